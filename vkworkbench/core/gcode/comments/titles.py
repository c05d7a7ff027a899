# SPDX-License-Identifier: LGPL-2.1-or-later
"""Separate titles of operations from remarks in the comments of an NC program."""

from __future__ import annotations

import re
from functools import lru_cache

# Words that some post processors write before a title, and the title.
_TITLED = re.compile(
    r"(?:begin operation|operation start|start cutting path id|start generation of|path|toolpath(?: name)?|operation(?: name)?"
    r"|op(?:eration)? ?\d+(?: of \d+)?|block-name|name|type|no\.? ?\d+|nr\.? ?\d+)"
    r"\s*[:=]\s*(?:-\s+)?(?!g-code from|(?:block|header|footer|[GM]\d+)$)(\S.*)",
    re.IGNORECASE,
)
# A title and a tool in one comment, as written by Fusion's post processor for Marlin and by SheetCam.
_BEFORE_TOOL = re.compile(r"(\S.*?) - milling - tool: \d+ - |operation: (\S.*?), T\d+: ", re.IGNORECASE)
_STARTING = re.compile(r"starting (\S.*) op$")  # A title as Kiri:Moto writes it.
# Comments that are not titles: post processors write them to describe the post processor, the machine, its modes, or
# moves within an operation.
_REMARK = re.compile(
    r"""
    \W*$ | [-+.\d\s/:*x%]+$ | .{80} | .*(?:https?://|\.(?:cps|pp|ulp|h|stl|svg|brd|tpl|gmax|txt|nc|ngc|tap)\b)
    | [A-Z0-9]+_[A-Z0-9_]+$ | \*{2,} | -{2,} | ={2,} | .*\b\d{1,2}:\d{2}\b | [MGTNS]\d+\b | \[ | .*\|
    | .*=\s*[-+]?[\d.]+\s*\w*$ | (?:\w+\s+){0,3}\w+\.?(?:\(\S+\))?\s*:\s*[-+]?[\d.,]+(?:\s*(?:mm|in|%|rpm|seconds|s)?\b.*)?$ | [XYZ]\s?(?:min|max|:) | [XYZ](?:,Y)?\ (?:start|end):
    | .*\bdepth:\s*[-+]?[\d.]+$ | helix\ cut\ operation$ | (?:turn|wait)\b | (?:header|footer)\b | origin: | pycam[-_] | (?-i:[a-z_]\w*_\w+)(?:\(\S+\))?\s*[:=] | pen\ (?:up|down)$ | (?:(?:ensure|turns)\ )?laser\ o(?:n|ff)\b
    | (?:begin|start|stop|end)\ cut(?:ting)?$ | cutting\ (?:begins|starts|ends)$ | finished\b\W*$ | \$\w+\(
    | .*(?:主轴|冷却|切削液|程序|延时|暂停|补偿|坐标|回零|返回|原点|抬刀|换刀|退刀|快速|安全|进给|转速|取消|设置|设定|单位|公制|英制)
    | pcb2gcode\b | software-independent\ gerber\b | (?:drill\ )?bit\ sizes\s*: | high\s+up\s+down\b | (?:generator|shape)\s*= | generator: | [\w-]+\s*:\s*(?:true|false)$ | end\ cutting\ path\b | it\ is\b
    | [XYZ]{2}\ plane\b | exact\ path\b | default\ cutting$ | feed\ per\b | work\ coordinate\b | select\b.*\b(?:plane|coordinate\ system|work\ offset)\b
    | toolpath(?:\ wp\b|$) | strategy\ used\b | unconverted\ code\b | pass\ \#?\d+\ at\b | moving\ to\b | ending\ .*\ op\b
    | block-\w+\s*: | (?=.*\d)[0-9a-f]{6}$ | [\w\ ]*(?:height\ offset|comp|css|compressor)\ o(?:n|ff)$
    | (?:ranges|tools)\ table$ | .*\b(?:press|make\ sure)\b.*\b(?:cycle\ start|spindle|button|key|running)\b
    | \w$ | (?:linear|arc|circular|rapid)(?:\ (?:mill|moves?|motion|traverse|interpolation|start|end|c?cw))*$
    | (?:comp\ )?(?:left|right|off)$ | retraction\ move$ | move\ to\b | .*\bcutter\ comp\b | programmer\s*: | comment$
    | begin\ (?:drilling|tapping|thread\ milling|probing|custom)$ | end\ custom$ | operation\ (?:initialise|done|finalised): | inactive\ operation
    | beginning\ of\b | (?:begin|end\ of)\ step\b | (?-i:part\ \d+)$ | part\ \d+\.$ | break$ | layer\ (?:\d+\ begins|transition)$ | transition\ to\ base:
    | (?:start|end)\ hold$ | end\ index\ angle\b | cut\ area\ [-\d.]+$ | wire\ \d+\.$ | step\ over\ %: | probe(?:open|close)\b | starting$
    | (?:section|start|stop|job|operation|epilogue)\ (?:begin|end)$ | optional\ stop\b | axis,
    | (?:[A-Z][-+]?\d*\.\d*\s+)*[A-Z][-+]?\d*\.\d*$
    | (?:laser|plasma|waterjet|through|etch|vaporize)\ cutting\.?$ | run\ point-pierce\b
    | (?:msg|debug|print|id)\b\s*[,=]? | (?:material|werkstoff)\s*(?:[-:=]|size$) | post\s*=
    | .*\b(?:personal\ use|rapid|feed\s?rates?|unrestricted|subscription|machining\ time|copyright|licens\w*|gcode|g-code
        |generated|produced\ by|created|erstellt|exported|made\ using|post\ ?processor|posts?\ processor|preprocessor|preamble|postamble|output
        |vendor|model|description|hersteller|proveedor|machine|maschine|bearbeiten|spindle|coolant|retract\w*|plunge
        |units?|millimeters?|millimetres?|inch(?:es)?|metric|absolute|incremental|clearance|safe\w*|attention|compensat\w*
        |programa?|filename|file|settings|stock|home|dwell|laufzeit|werkzeuge|required|tools?|toolchange|mode|end\ of|return|postprocessor
        |direction|cut\ depth|pass\ depth|paths|lead|penetrate|cancel|set|use)\b
    | (?:finish|end|stop|start|begin|path|ramp|cut|cutting|lift|air|move\w*|link|layer|pass|depth|level|loop|z|step|line|segment|slice)
        \b\s*[#:=]?\s*(?:operation.*|section.*|block.*|path.*|of\b.*|[-+\d.,/\s]*(?:of\s*\d+)?(?:mm)?)$
    """,
    re.IGNORECASE | re.VERBOSE,
)  # fmt: skip


@lru_cache(maxsize=1000)
def title_of(comment: str) -> str:
    """Return the name of an operation in a comment; empty if the comment is a remark."""
    text = comment.strip(" *-=#;:\t")
    if re.fullmatch(r"\([^()]*\)", text):  # a comment such as ; (Pocket)
        text = text[1:-1].strip()
    if before := title_before_tool(text):
        return before
    if titled := _TITLED.match(text) or _STARTING.match(text):
        return titled[1].strip()
    return "" if not text or _REMARK.match(text) else text


def title_before_tool(comment: str) -> str:
    """Return the name of the operation in a comment with an operation and its tool; empty for other comments."""
    found = _BEFORE_TOOL.match(comment.strip(" *-=#;:\t"))
    return (found[1] or found[2]).strip() if found else ""
