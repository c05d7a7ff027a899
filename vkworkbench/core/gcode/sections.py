# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations of an NC program, divided at its titles and tool changes."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

from vkworkbench.core.gcode.codes import MOTION_NAMES
from vkworkbench.core.gcode.program import Program
from vkworkbench.core.gcode.tool_table import number_named, tool_told
from vkworkbench.core.tool import Tool

MANY_TITLES = 50  # titles of one form; a program with more numbers its passes, not its operations

_AXES = frozenset("XYZ")
# What pcb-gcode writes in a comment of its own before the one with the number; and descriptions that name no tool.
_TOOL_SIZE = re.compile(r"\s*tool size\s*", re.IGNORECASE)
# As NX writes them: a tool's name, and its diameter in a comment of its own in the next line.
_TOOL_NAME = re.compile(r"\W*(?:tool(?:\s*(?:name|no\.?|number|type|desc\w*))?\s*[:=#]|T\d+\b)", re.IGNORECASE)
_ITS_DIAMETER = re.compile(r"\W*(?:D|(?:tool\s*)?dia(?:meter)?)\.?\s*[:=]\s*[\d.,]+", re.IGNORECASE)
_NO_NAME = re.compile(r"\s*(?:TOOL/|tool_radius\b|tool size\b)", re.IGNORECASE)

# What py2gcode writes before an operation and behind it; the comments between tell its parameters and passes.
_FROM, _TO = re.compile(r"Begin (\w+)"), re.compile(r"End (\w+)")
# A title after the words that some post processors write before it.
_TITLED = re.compile(
    r"(?:begin operation|start cutting path id|start generation of|path|toolpath(?: name)?|operation(?: name)?"
    r"|op(?:eration)? ?\d+(?: of \d+)?|block-name|name|type|no\.? ?\d+|nr\.? ?\d+)"
    r"\s*[:=]\s*(?!g-code from|(?:block|header|footer|[GM]\d+)$)(\S.*)",
    re.IGNORECASE,
)
_BEFORE_TOOL = re.compile(r"(\S.*?) - milling - tool: \d+ - ", re.IGNORECASE)  # Fusion for Marlin
# Comments that are no titles: what post processors say of themselves, the machine, modes, and moves in an operation.
_REMARK = re.compile(
    r"""
    \W*$ | [-+.\d\s/:*x%]+$ | .{80} | .*(?:https?://|\.(?:cps|pp|ulp|h|stl|svg|brd|tpl|gmax|txt|nc|ngc|tap)\b)
    | [A-Z0-9]+_[A-Z0-9_]+$ | \*{2,} | -{2,} | ={2,} | .*\b\d{1,2}:\d{2}\b | [MGTNS]\d+\b | \[ | .*\|
    | .*=\s*[-+]?[\d.]+\s*\w*$ | (?:\w+\s+){0,3}\w+\.?(?:\(\S+\))?\s*:\s*[-+]?[\d.,]+(?:\s*(?:mm|in|%|rpm|seconds|s)?\b.*)?$ | [XYZ]\s?(?:min|max|:) | [XYZ](?:,Y)?\ (?:start|end):
    | .*\bdepth:\s*[-+]?[\d.]+$ | helix\ cut\ operation$ | (?:turn|wait)\b | (?:header|footer)\b | origin: | pycam[-_] | (?-i:[a-z_]\w*_\w+)(?:\(\S+\))?\s*[:=] | pen\ (?:up|down)$ | (?:ensure\ )?laser\ o(?:n|ff)\b
    | (?:begin|start|stop|end)\ cut(?:ting)?$
    | pcb2gcode\b | high\s+up\s+down\b | (?:generator|shape)\s*= | end\ cutting\ path\b | it\ is\b
    | [XYZ]{2}\ plane\b | exact\ path\b | default\ cutting$ | feed\ per\b | work\ coordinate\b | select\b.*\b(?:plane|coordinate\ system|work\ offset)\b
    | block-\w+\s*: | (?=.*\d)[0-9a-f]{6}$ | [\w\ ]*(?:height\ offset|comp|css|compressor)\ o(?:n|ff)$
    | (?:ranges|tools)\ table$ | .*\b(?:press|make\ sure)\b.*\b(?:cycle\ start|spindle|button|key|running)\b
    | begin\ drilling$ | (?:section|start|stop|job|operation|epilogue)\ (?:begin|end)$ | optional\ stop\b | axis,
    | (?:[A-Z][-+]?\d*\.\d*\s+)+[A-Z][-+]?\d*\.\d*$
    | (?:laser|plasma|waterjet|through|etch|vaporize)\ cutting\.?$ | run\ point-pierce\b
    | (?:msg|debug|print|id)\b\s*[,=]? | (?:material|werkstoff)\s*[-:=]
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


@dataclass(frozen=True)
class Section:
    """One operation of a program, in the order of cutting.

    Attributes
    ----------
    title : str
        What the program calls it, else its tool; empty where it says neither.
    number : int or None
        Number of its tool.
    tool : Tool or None
        What the program's comments say of that tool.
    first, last : int
        First and last line.
    """

    title: str
    number: int | None
    tool: Tool | None
    first: int
    last: int


@dataclass
class _Group:
    """The comments and the tool change between two cuts.

    Attributes
    ----------
    line : int
        Line of the first of them.
    title : str
        Title in the last comment that is no remark, outside of subprograms.
    called : str
        The first such title within a subprogram.
    headings
        All comments that are no remarks, with the numbers that post processors write before the titles.
    change, number
        Line of the last tool change, None where there is none, and the number of its tool.
    tool, tool_name, told
        The tool that is described without a number, or with the number that is changed to, that comment, and its line.
    known : dict
        The tools described so far, by their numbers.
    """

    line: int
    title: str = ""
    called: str = ""
    headings: tuple[str, ...] = ()
    change: int | None = None
    number: int | None = None
    tool: Tool | None = None
    tool_name: str = ""
    told: int | None = None
    known: dict[int, Tool] = field(default_factory=dict)


def split_sections(program: Program) -> tuple[Section, ...]:
    """Divide a program into its operations, at tool changes and at titles that follow a cut.

    Returns
    -------
    tuple of Section
        At least one; every line with a command is in one of them.
    """
    groups = _groups(program)
    forms = Counter(_form(group.title) for group in groups if group.title and group.change is None)
    passes = {form for form, times in forms.items() if times > MANY_TITLES}
    sections: list[Section] = []
    number = tool = headings = None
    everything = groups[-1].known
    for group in groups:
        title = "" if _form(group.title) in passes else group.title
        if group.change is not None:
            number, tool = group.number, None
        elif sections and (not title or group.headings == headings):
            continue
        headings = group.headings
        tool = group.tool or tool
        known = None if number is None else group.known.get(number) or everything.get(number)
        if number is None and len(everything) == 1:
            (known,) = everything.values()
        if sections:
            sections[-1] = replace(sections[-1], last=group.line - 1)
        sections.append(
            Section(title or group.called or group.tool_name, number, known or tool, group.line, int(program.lines[-1]))
        )
    return tuple(sections)


def _groups(program: Program) -> list[_Group]:
    """Return the comments and tool changes between the cuts, one group for the program's beginning at least."""
    marks: list[tuple[int, int, str | float | None, bool]] = [
        (*comment, number in program.in_calls) for number, comment in enumerate(_with_sizes(program.comments))
    ]
    named: dict[int, int] = {}  # tools by the lines of their T words
    for at, (name, words) in enumerate(program.commands):
        if name == "M6":
            marks.append((at, int(program.lines[at]), words.get("T"), False))
        elif name[:1] == "T":
            named[int(program.lines[at])] = int(name[1:])
    cuts = _cuts(program)
    marks.sort(key=lambda mark: mark[:2])
    changes = {line: None if what is None else int(what) for _, line, what, _ in marks if not isinstance(what, str)}
    listed = _listed(marks, cuts)
    groups = [_Group(min([int(program.lines[0]), *(line for _, line, *_ in marks[:1])]))]
    place, known, begun = 0, groups[0].known, ""
    ended = {found[1] for _, _, text in program.comments if (found := _TO.fullmatch(text))}
    for at, line, what, called in marks:
        if bisect_left(cuts, at) != place:
            place = bisect_left(cuts, at)
            groups.append(_Group(line, known=known))
        group = groups[-1]
        if not isinstance(what, str):
            group.change, group.number = line, None if what is None else int(what)
            continue
        told = tool_told(what, inches=program.inches, of=changes.get(line))
        if told is not None and told.number is None and line not in changes and (place, what) in listed:
            continue
        change = line if line in changes else group.change
        if told is None:
            if group.number is None:
                number = number_named(what)
                group.tool = (None if number is None else known.get(number)) or group.tool
            begins = _FROM.fullmatch(what)
            if begins and begins[1] in ended:
                title = begun = begins[1]
            else:
                title = "" if begun else title_of(what)
                begun = "" if what == f"End {begun}" else begun
            if title and called:
                group.called = group.called or title
            elif title and not _beside_a_move(program, at, line):
                group.title, group.headings = title, (*group.headings, what)
            continue
        name = "" if _NO_NAME.match(what) else what
        number = told.number
        if number is None and change is not None and line not in changes:
            number = named.get(line)  # behind a change it is got ready
        if number is not None:
            group.known = known = {**known, number: told.tool}
            group.tool_name = name if number == group.number else group.tool_name
        elif told.from_here or group.tool is None or change not in (None, group.told):
            # What the line of a change tells stays, unless another tool is told to be the one from here on.
            group.tool, group.tool_name, group.told = told.tool, name, line
    return groups


def _beside_a_move(program: Program, at: int, line: int) -> bool:
    """Return whether a comment stands in the line of the command before which it is, a move: it says what that is for."""
    return at < len(program.commands) and program.lines[at] == line and not _AXES.isdisjoint(program.commands[at][1])


def _listed(marks: list[tuple[int, int, str | float | None, bool]], cuts: list[int]) -> set[tuple[int, str]]:
    """Return the comments between two cuts, with how many cuts are before, that list tools which are changed to later.

    They are said again where they are, of two other tools at least: what one says is often true of several.
    """
    places = [bisect_left(cuts, at) for at, *_ in marks]
    tools = {place: what for place, (_, _, what, _) in zip(places, marks) if isinstance(what, (int, float))}
    said = [(place, what) for place, (_, _, what, _) in zip(places, marks) if isinstance(what, str) and place in tools]
    last = {what: tools[place] for place, what in said}
    others: dict[int, set[float]] = {}
    for place, what in said:
        others.setdefault(place, set()).update({last[what]} - {tools[place]})
    return {(place, what) for place, what in said if last[what] != tools[place] and len(others[place]) > 1}


def _with_sizes(comments: Iterable[tuple[int, int, str]]) -> Iterator[tuple[int, int, str]]:
    """Give comments, a tool's size together with the comment before it, which says what it is, or its name."""
    before, size, next_line = "", False, 0
    for at, line, text in comments:
        joined = before and (size or (line == next_line and _ITS_DIAMETER.match(text)))
        yield at, line, f"{before}: {text}" if joined else text
        size, next_line = _TOOL_SIZE.fullmatch(text) is not None, line + 1
        before = text if size or _TOOL_NAME.match(text) else ""


def _cuts(program: Program) -> list[int]:
    """Return the commands that cut; of a plunge and what is cut from where it leads along the plane, not the plunge."""
    cuts: list[int] = []
    plunge: int | None = None  # where the tool began to go down to where it has not cut yet
    motion, depth = "", 0.0
    for at, (name, words) in enumerate(program.commands):
        motion = name if name in MOTION_NAMES else motion
        if name not in ("", motion) or not motion or _AXES.isdisjoint(words):
            continue
        vertical = _AXES.isdisjoint(words.keys() - {"Z"})
        if plunge is not None:
            if motion == "G1" and vertical and words["Z"] < depth:
                depth = words["Z"]
                continue
            if motion == "G0" or vertical:
                cuts.append(plunge)  # a hole
            plunge = None
        if motion == "G1" and vertical:
            plunge, depth = at, words["Z"]
        elif motion != "G0":
            cuts.append(at)
    return cuts if plunge is None else [*cuts, plunge]


@lru_cache(maxsize=1000)
def title_of(comment: str) -> str:
    """Return the name of an operation in a comment, empty where it is a remark."""
    text = comment.strip(" *-=#;:\t")
    if re.fullmatch(r"\([^()]*\)", text):  # behind a semicolon
        text = text[1:-1].strip()
    titled = _TITLED.match(text) or _BEFORE_TOOL.match(text)
    if titled:
        return titled[1].strip()
    return "" if not text or _REMARK.match(text) else text


def _form(title: str) -> str:
    return re.sub(r"[\d.,]+", "#", title)
