# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tools of an NC program, as its comments describe them.

Fusion and HSMWorks write ``T1 D=6.35 CR=0. - ZMIN=-3. - flat end mill``, CamBam ``T6 : 6.0`` and
``TOOL/MILL,6.0,0.0,20.0,0``, Vectric and Estlcam ``End Mill {1/4 inch}`` and ``End mill 3mm``, Mastercam and CAMWorks
``T4 | 3/8 FLAT ENDMILL`` and ``6MM CRB 2FL``, Fabex ``Tool: D = 3.0 mm type END``, FreeCAD ``TC: 5mm Endmill``, PyCAM
``tool_radius = 1.5``, pcb-gcode ``Tool Size`` with the number in the next comment, and ``T01  1.000mm 0.0394in``.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import lru_cache

from vkworkbench.core.gcode.moves.units import INCH
from vkworkbench.core.tool import Tool

_LARGEST, _LARGEST_BARE = 500.0, 150.0  # mm; 14 END MILL is no tool of 14 inches, 265bit none of 265 mm

_NUMBER = r"(?:\d+(?:\.\d*|,\d+)?|[.,]\d+)"
_FRACTION = r"(?:\d+[ -])?\d+/\d+"
_SIZE = rf"(?P<size>{_FRACTION}|{_NUMBER})"
_METRIC = ("mm", "мм", "m")  # M8: a metric thread
_MM = r"mm(?![a-z\d_])"  # 6mm立铣刀: no space before words in Chinese
_UNIT = rf"\s*(?P<unit>{_MM}|мм\b|inch(?:es)?\b|in\b\.?|\"|'')?"
_CHINESE = "[铣钻镗铰]刀|[球角头]刀|钻头|中心钻|丝锥"  # without a space before them
_MILLING_WORD = (
    r"end ?mills?(?![a-z])|mill\b|em\b|face ?mills?(?![a-z])|slot ?(?:cutter|drill)|(?<!laser )(?<!plasma )cutter\b|flycutter\b|ball ?(?:nose|end)|bull ?(?:nose|end)|v[- ]?bit|"
    r"engrav\w*\b(?!\s+(?:an?|the)\b)|chamfer\w*|router|bit\b|drills?\b|(?:spot|twist|start|step) ?drill|facing ?tool|reamer|tap\b|crb\b|carbide|"
    r"\w*fr(?:ä|ae|.)ser\b|bohrer|gravier\w*|freza|sverlo|fresa|broca|fraise|foret|frees|фреза|сверло|гравер|"
    + _CHINESE
)
# Of other languages' words for a tool only the first of a comment names one: "trajectoire d'outil 3" is a toolpath.
_NUMBERED = re.compile(
    r"(?:\b(?:T|tool(?:\s*(?:no\.?|nr\.?|number))?)"
    r"|^\W*(?:werkzeug|wkz\.?|wz\.?|outil|herramienta|ferramenta|utensile|narz[eę]dzie|n[aá]stroj|gereedschap|инструмент)"
    r"(?:[\s-]*(?:nr\.?|n[°º]|nummer))?)"
    r"\s*(?:[-#:=]\s*)?(?P<number>\d{1,8})\b(?![./]\d|\")(?!\s*(?:mm|мм)\b)",
    re.IGNORECASE,
)
_LETTER = re.compile(rf"(?<![A-Za-z])D\s*=\s*{_SIZE}{_UNIT}", re.IGNORECASE)
_WORD = re.compile(
    rf"(?:\bdia(?:meter|m)?\b\.?|\bdiametro\b|\bdiámetro\b|\bdiamètre\b|\bdurchmesser\b|[øØ⌀φΦ]|\bдиаметр|\btool size)\s*[:=.\-]*\s*{_SIZE}{_UNIT}(?![\d.,]*\s*(?:mcl|loc|oal)\b)",
    re.IGNORECASE,
)
# Not the end of a range: SPOT DRILL .06 TO .125 DIA. makes holes of that size.
_BEFORE = re.compile(rf"(?<![\d.,/])(?<!\bto)(?<!\bto ){_SIZE}{_UNIT}\s*\bdia(?:meter|m)?\b", re.IGNORECASE)
# .375_3/8 X 90 DEG. SPOT DRILL: what is said twice is the size.
_DECIMAL = re.compile(r"(?<![\w.,/#-])(?P<size>\d*[.,]\d+)(?P<across>)(?P<unit>)(?= \d+/\d)")
_RADIUS = re.compile(rf"\btool radius\s*[:=]\s*{_SIZE}{_UNIT}", re.IGNORECASE)
_CAMBAM = re.compile(rf"T\d+\s*:\s*(?P<size>{_NUMBER})", re.IGNORECASE)
_CUTVIEWER = re.compile(
    r"TOOL/(?P<kind>MILL|DRILL|CHAMFER)\s*,\s*(?P<size>[\d.]+)(?:\s*,\s*(?P<second>[\d.]+))?", re.IGNORECASE
)
# Diameter and length, 10 x 72: with as much room before the x as behind it, unlike 2x 6mm.
_ACROSS = rf"(?:(?:mm|in)?(?:\s+[x×]\s+|[x×])(?:{_FRACTION}|{_NUMBER}))*"
_WITH_UNIT = rf"(?<![\d.,/])(?<!\bthan ){_SIZE}{_ACROSS}\s*(?P<unit>{_MM}|мм\b|inch(?:es)?\b|in\b|\")"
_MEASURED = re.compile(rf"{_WITH_UNIT}(?!\s*(?:l|loc|oal)\b)", re.IGNORECASE)
# What is measured behind the tool word may be its length as well.
_NO_LENGTH = re.compile(
    rf"{_WITH_UNIT}(?!\s*(?:l\b|loc\b|lo?ng|length|lang|lg\b|oal\b|deep|depth|shank|stick|holder|corner|rad|cr?\b|pitch))",
    re.IGNORECASE,
)
_SHORT = re.compile(rf"(?<![\w|])D(?P<size>{_NUMBER})(?![\w|])")  # D10; between bars it is an offset
# FreeCAD converts the moves of a program to inches, and no comment.
_IN_MM = re.compile(r"\W*compensated tool path\. diameter", re.IGNORECASE)
# In what is said of compensation a D word names its register. And several sizes are those of several tools.
_COMPENSATION = re.compile(r"\bcomp(?:ensation)?\b|\bregister\b", re.IGNORECASE)
_SEVERAL = re.compile(r"\bsizes\b", re.IGNORECASE)
_LENGTH_OFFSET = re.compile(r"(?<!\w)H(\d{1,8})\b")
_TOGETHER = re.compile(r"(?<=\btool)(?=Dia|Radius)")  # toolDiam: 0.125
_IN_BOTH = re.compile(
    r"(?<![\d.])(?P<mm>\d+(?:\.\d+)?\s*mm)\s*/\s*(?P<inches>\d*\.\d+)(?!\d|\s*mm)", re.IGNORECASE
)  # 11mm / .433
_FLUTES = re.compile(r"\b\d+\s*-?\s*fl(?:utes?)?\b", re.IGNORECASE)
_LISTED = re.compile(r"\s*T\d+\s*(?:[|:=]|[\d.]+mm\s+[\d.]+in\b)", re.IGNORECASE)
_LONGEST, _LONGEST_NAME = 200, 60  # characters; longer comments are prose that mentions a size in passing
_KIND = r"(?:\s*(?:flat|square|long|stub|hss|key(?:way|seat)?|woodruff|t-slot|dovetail))*"  # 1.5 KEY CUTTER .0938
_BARE = re.compile(
    rf"(?<![\w.,/#]){_SIZE}(?P<across>)(?P<unit>)(?={_KIND}\s*(?:{_MILLING_WORD}))",
    re.IGNORECASE,
)
# Directly before what the tool is: in a sentence about other things as well, this is its size.
_ATTACHED = re.compile(
    rf"(?<![\w.,/#]){_SIZE}(?P<across>{_ACROSS}){_UNIT}(?:\s*(?:flat|square|stub|hss))*(?=\s*(?:{_MILLING_WORD}))",
    re.IGNORECASE,
)
# DRILL 8.5; a whole number there may be anything, and behind a pointed tool it is an angle.
_BEHIND = re.compile(
    rf"(?<![a-zà-ÿа-я])(?:{_MILLING_WORD})\s*(?P<size>{_FRACTION}|\d+[.,]\d*|[.,]\d+)(?P<unit>)$", re.IGNORECASE
)
# Behind a tool for threads it is their pitch; and the part has diameters, too.
_THREAD = re.compile(r"thread|gewinde|rosca|filet", re.IGNORECASE)
_OF_PART = re.compile(r"\b(?:bore|boss|circle|hole|pocket)s?\b|bohrung|tasche", re.IGNORECASE)
# A number in a table of drills, that of an operation, and of how many sizes there are.
_OTHER_NUMBER = re.compile(
    r"(?:#|\b(?:no|nr|op|job)\b\.?|\bnumber)\s*\d+(?![./\d])|(?<![\d./])\d+(?=(?:\s+\w+){0,2}\s+sizes\b)", re.IGNORECASE
)
# M8 X 1.25, 1/4-20: a thread's diameter, and its pitch or turns per inch. Of a pipe's thread the inches are no measure.
_TAP = re.compile(r"\btap\b(?!\s*drill)", re.IGNORECASE)
_METRIC_THREAD = re.compile(
    rf"(?<![A-Za-z\d])(?P<unit>M)(?P<size>{_NUMBER})(?=\s*[-x×]\s*[\d.,].*\btap\b|\s*tap\b)", re.IGNORECASE
)
_INCH_THREAD = re.compile(
    rf"(?<![\d.,/])(?P<size>{_FRACTION})(?=\s*-\s*\d+(?!.*(?:npt|bsp|pipe)).*\btap\b|\s*tap\b)", re.IGNORECASE
)
# The drill of the hole for it has another diameter.
_FOR_TAP = re.compile(r"(?<=drill)\b.*\bfor\b.*\btap\b.*", re.IGNORECASE)
# T9 3/16 HARVEY EM: behind a tool's number no other fraction stands than its diameter, and that of a thread (1/4-20).
_NEXT_TO_NUMBER = re.compile(rf"[\s:=-]*(?P<size>{_FRACTION})(?P<across>){_UNIT}(?!\s*-\s*\d)", re.IGNORECASE)
_IS_TOOL = re.compile(rf"(?<![a-zà-ÿа-я])(?:{_MILLING_WORD})|{_CHINESE}", re.IGNORECASE)
_CORNER = re.compile(rf"\b(?:CR|corner radius|torus_radius)\s*[=:]\s*(?P<size>{_NUMBER})", re.IGNORECASE)
_TAPER = re.compile(rf"\bTAPER\s*=\s*(?P<size>{_NUMBER})\s*deg", re.IGNORECASE)
_ANGLE = re.compile(rf"(?<![\d.,]){_SIZE}\s*(?:°|deg(?:ree)?s?\b)", re.IGNORECASE)
# Directly before a pointed tool such a whole number is its angle, no size of 90 mm.
_BARE_ANGLE = re.compile(
    r"(?<![\w.,/#-])(?P<size>60|82|90|100|118|120|1[34]\d)(?=\s+(?:spot|cent(?:er|re)[- ]?drill|chamfer|countersink|engrav|v[- ]?bit))",
    re.IGNORECASE,
)
_SHAPES = (
    ("ballend", r"ball|kugel|radiusfr|esf.rica|h.misph|сферич|球"),
    ("bullnose", r"bull|torus|corner"),
    (
        "vbit",
        r"v[- ]?bit|v-?carv|chamfer|engrav|conical|gravier|fase|cent(?:er|re)[- ]?drill|spot|countersink|гравер|senker|chafl|倒角|中心钻",
    ),
    ("drill", r"drill|bohrer|broca|foret|sverlo|сверло|钻"),
)


@dataclass(frozen=True)
class ToldTool:
    """What a comment says of a tool.

    Attributes
    ----------
    number : int or None
        Its number in the program, where the comment names it.
    tool : Tool
    from_here : bool
        Whether it is the tool of all that follows, as CutViewer's comments say; others may list what the program needs.
    """

    number: int | None
    tool: Tool
    from_here: bool = False


@lru_cache(maxsize=1000)
def tool_told(comment: str, *, inches: bool, of: int | None = None) -> ToldTool | None:
    """Return the tool that a comment describes, None where it names no diameter.

    Parameters
    ----------
    comment : str
        Without its parentheses.
    inches : bool
        Whether lengths without a unit are inches, as G20 says. A fraction (1/4) is always one of an inch.
    of : int, optional
        The tool to which the comment's line changes: there a diameter is the tool's without a word that says so.
    """
    if len(comment) > _LONGEST:
        return None
    comment = _spaced(comment)
    inches = inches and not _IN_MM.match(comment)
    number = _NUMBERED.search(comment)
    size = _size(comment, number) or (None if of is None else _size_alone(comment, of))
    if size is None:
        return None
    diameter = _millimetres(size, inches or _also_a_fraction(comment, size))
    if size.re is _RADIUS:
        diameter *= 2
    bare = size.re in (_BARE, _ATTACHED) and not size["unit"]
    if not 0 < diameter <= (_LARGEST_BARE if bare else _LARGEST):
        return None
    return ToldTool(number_named(comment), _tool(comment, size, diameter, inches), size.re is _CUTVIEWER)


def number_named(comment: str) -> int | None:
    """Return the number of the tool that a comment names, with or without its measures."""
    number = _NUMBERED.search(comment)
    return int(number["number"]) if number else None


def _spaced(comment: str) -> str:
    """Return a comment with its words apart, without the numbers of flutes, and a size once."""
    return _IN_BOTH.sub(_in_mm, _FLUTES.sub("", _TOGETHER.sub(" ", comment.replace("_", " "))))


def _in_mm(both: re.Match[str]) -> str:
    """Return a size that stands in mm and in inches in mm alone, two other numbers as they are."""
    mm, from_inches = float(both["mm"][:-2]), float(both["inches"]) * INCH
    return both["mm"] if abs(from_inches - mm) < 0.02 * mm else both[0]


def _size(comment: str, number: re.Match[str] | None) -> re.Match[str] | None:
    """Return where a comment names a tool's diameter."""
    written = _CAMBAM.fullmatch(comment.strip()) or _CUTVIEWER.match(comment.strip())
    if written:
        return written
    is_tool = _IS_TOOL.search(comment) is not None
    if _SEVERAL.search(comment) or (
        number is None and not is_tool and not re.search(r"\btool", comment, re.IGNORECASE)
    ):
        return None
    explicit = _LETTER.search(comment) or _WORD.search(comment) or _BEFORE.search(comment) or _RADIUS.search(comment)
    if explicit or not (is_tool or _LISTED.match(comment)) or len(comment) > _LONGEST_NAME:
        return explicit
    for twice in _DECIMAL.finditer(comment):
        if _also_a_fraction(comment, twice):
            return twice
    comment = _FOR_TAP.sub("", comment)
    beside = _NEXT_TO_NUMBER.match(comment, number.end()) if number is not None and is_tool else None
    if beside and not _TAP.search(comment):
        return beside
    if number is not None:  # "tool 1 1/4" is no tool of 1 1/4
        comment = f"{comment[: number.start()]}  {comment[number.end() :]}"
    comment = _without_offsets(_OTHER_NUMBER.sub("#", _BARE_ANGLE.sub("", comment)), number)
    if _TAP.search(comment):
        return _METRIC_THREAD.search(comment) or _INCH_THREAD.search(comment) or _NO_LENGTH.search(comment)
    found = [match for match in (_MEASURED.search(comment), _BARE.search(comment)) if match]
    size = _ATTACHED.search(comment) or min(found, key=re.Match.start, default=None)
    if size is None or (number is None and _is_bare(size)):  # the tool's number may stand before the tool word, too
        return _NO_LENGTH.search(comment) or _SHORT.search(comment) or size
    return size


def _size_alone(comment: str, tool: int) -> re.Match[str] | None:
    """Return the diameter in a comment that need not say that it is about a tool; D with that tool's number is an offset."""
    comment = comment.strip()
    short = _SHORT.fullmatch(comment)
    if short:
        return None if short["size"].isdigit() and int(short["size"]) == tool else short
    size = _MEASURED.fullmatch(comment) or (None if _OF_PART.search(comment) else _WORD.search(comment))
    if size is None and not (_TAP.search(comment) or _THREAD.search(comment)) and _shape(comment) != "vbit":
        size = _BEHIND.search(comment)
    return size


def _without_offsets(comment: str, number: re.Match[str] | None) -> str:
    """Return a comment without offsets: D words with the number of the tool, or of an H word, and of compensation."""
    if _COMPENSATION.search(comment):
        return _SHORT.sub("", comment)
    own = {int(offset) for offset in _LENGTH_OFFSET.findall(comment)} | ({int(number["number"])} if number else set())
    return _SHORT.sub(lambda word: "" if word["size"].isdigit() and int(word["size"]) in own else word[0], comment)


def _is_bare(size: re.Match[str]) -> bool:
    """Whether a size is a whole number alone."""
    return size["size"].isdigit() and not size["unit"] and not size["across"]


def tells_inches(comment: str) -> bool:
    """Whether a comment names a tool's diameter as a plain number and as the same fraction of an inch: DIA 0.5, 1/2 ENDMILL."""
    if "/" not in comment or len(comment) > _LONGEST:
        return False
    comment = _spaced(comment)
    size = _size(comment, _NUMBERED.search(comment))
    return size is not None and not size.groupdict().get("unit") and _also_a_fraction(comment, size)


def _also_a_fraction(comment: str, size: re.Match[str]) -> bool:
    """Whether a comment names the same size as a fraction of an inch, too."""
    if "/" in size["size"]:
        return False
    value = float(size["size"].replace(",", "."))
    return any(
        int(below) and abs(int(above) / int(below) - value) < 1e-3
        for above, below in re.findall(r"(\d{1,3})/(\d{1,3})", comment)
    )


def _millimetres(size: re.Match[str], inches: bool) -> float:
    text = size["size"].replace(",", ".")
    unit = (size.groupdict().get("unit") or "").lower()
    if "/" in text:
        *whole, fraction = re.split(r"[ -]", text)
        above, below = (float(part) for part in fraction.split("/"))
        value = sum(map(float, whole)) + (above / below if below else 0.0)
        return value * (1.0 if unit in _METRIC else INCH)
    return float(text) * (1.0 if unit in _METRIC else INCH if unit or inches else 1.0)


def _tool(comment: str, size: re.Match[str], diameter: float, inches: bool) -> Tool:
    """Return the tool; impossible measures are not used."""
    unit = INCH if inches else 1.0
    kind = size.groupdict().get("kind")
    shape = _shape(comment)
    corner = _CORNER.search(comment)
    rounding = float(corner["size"].replace(",", ".")) * unit if corner else 0.0
    if kind and size["second"] and kind.upper() == "MILL":
        rounding = float(size["second"]) * unit
    elif kind:
        shape = {"DRILL": "drill", "CHAMFER": "vbit"}.get(kind.upper(), shape)
    if shape in ("endmill", "bullnose") and 0 < rounding <= diameter / 2:
        ball = rounding > 0.499 * diameter
        return Tool("ballend", diameter) if ball else Tool("bullnose", diameter, corner_radius=rounding)
    if shape in ("vbit", "drill"):
        return Tool(shape, diameter, tip_angle=_tip_angle(comment))
    return Tool("endmill" if shape == "bullnose" else shape, diameter)


def _shape(comment: str) -> str:
    return next((shape for shape, words in _SHAPES if re.search(words, comment, re.IGNORECASE)), "endmill")


def _tip_angle(comment: str) -> float | None:
    """Return the included angle of a tip, rad; Fusion's TAPER is the half of it where a side cuts."""
    taper = _TAPER.search(comment)
    if taper:
        half = re.search(r"chamfer|fase|engrav|gravier|v-?bit", comment, re.IGNORECASE)
        degrees = (2 if half else 1) * float(taper["size"].replace(",", "."))
    else:
        angle = _ANGLE.search(comment) or _BARE_ANGLE.search(comment)
        degrees = float(angle["size"].replace(",", ".")) if angle and "/" not in angle["size"] else 0.0
    return math.radians(degrees) if 0 < degrees <= 180 else None
