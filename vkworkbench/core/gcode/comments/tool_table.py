# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the tools of an NC program from its comments.

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

# Largest diameters of a tool, mm: if the comment contains a unit, and if it contains no unit. If the limit without a
# unit is higher, 14 END MILL is read as a tool of 14 inches (356 mm), and 265bit as a tool of 265 mm.
_LARGEST, _LARGEST_BARE = 500.0, 150.0

_NUMBER = r"(?:\d+(?:\.\d*|,\d+)?|[.,]\d+)"
_FRACTION = r"(?:\d+[ -])?\d+/\d+"
_SIZE = rf"(?P<size>{_FRACTION}|{_NUMBER})"
_METRIC = ("mm", "мм", "m")  # M as in M8, a metric thread.
_MM = r"mm(?![a-z\d_])"  # Chinese words can follow without a space, as in 6mm立铣刀.
_UNIT = rf"\s*(?P<unit>{_MM}|мм\b|inch(?:es)?\b|in\b\.?|\"|'')?"
# Words for tools in Chinese, Korean and Japanese, which need no space before the word.
_UNSPACED = "[铣钻镗铰]刀|[球角头平底]刀|钻头|中心钻|丝锥|엔드밀|볼밀|드릴|커터|리머|탭|챔퍼|페이스밀|공구|エンドミル|ドリル|タップ|リーマ|カッター|フライス|工具"
_MILLING_WORD = (
    r"end ?mills?(?![a-z])|mill\b|em\b|face ?mills?(?![a-z])|slot ?(?:cutter|drill)|(?<!laser )(?<!plasma )cutter\b|flycutter\b|ball ?(?:nose|end)|bull ?(?:nose|end)|v[- ]?bit|"
    r"engrav\w*\b(?!\s+(?:an?|the)\b)|chamfer\w*|router|bit\b|drills?\b|(?:spot|twist|start|step) ?drill|facing ?tool|reamer|tap\b|crb\b|carbide|"
    r"\w*fr(?:ä|ae|.)ser\b|bohrer|gravier\w*|freza|sverlo|fresa|broca|fraise|foret|frees|фреза|сверло|гравер|"
    + _UNSPACED
)
# A tool's number after the word "tool". In other languages, the word must be at the beginning of the comment,
# because "trajectoire d'outil 3" is a toolpath.
_NUMBERED = re.compile(
    r"(?:\b(?:T|tool(?:\s*(?:no\.?|nr\.?|number))?)"
    r"|^\W*(?:werkzeug|wkz\.?|wz\.?|outil|herramienta|ferramenta|utensile|공구|工具|narz[eę]dzie|n[aá]stroj|gereedschap|инструмент)"
    r"(?:[\s-]*(?:nr\.?|n[°º]|nummer))?)"
    r"\s*(?:[-#:=]\s*)?(?P<number>\d{1,8})\b(?![./]\d|\")(?!\s*(?:mm|мм)\b)",
    re.IGNORECASE,
)
_LETTER = re.compile(rf"(?<![A-Za-z])D\s*=\s*{_SIZE}{_UNIT}", re.IGNORECASE)
_WORD = re.compile(
    rf"(?:\bdia(?:meter|m)?\b\.?|\bdiametro\b|\bdiámetro\b|\bdiamètre\b|\bdurchmesser\b|[øØ⌀φΦ]|지름|직경|直径|(?<![а-я])ф(?=\s*\d)|\bдиаметр|\btool size)\s*[:=.\-]*\s*{_SIZE}{_UNIT}(?![\d.,]*\s*(?:mcl|loc|oal)\b)",
    re.IGNORECASE,
)
# A number before "diameter". A number after TO is not the tool's diameter, because a SPOT DRILL .06 TO .125 DIA makes
# holes of .06 to .125 inches.
_BEFORE = re.compile(rf"(?<![\d.,/])(?<!\bto)(?<!\bto ){_SIZE}{_UNIT}\s*\bdia(?:meter|m)?\b", re.IGNORECASE)
# A length that a comment contains as a decimal and as a fraction, as in .375_3/8 SPOT DRILL, is the diameter.
_DECIMAL = re.compile(r"(?<![\w.,/#-])(?P<size>\d*[.,]\d+)(?P<across>)(?P<unit>)(?= \d+/\d)")
_RADIUS = re.compile(rf"\btool radius\s*[:=]\s*{_SIZE}{_UNIT}", re.IGNORECASE)
_CAMBAM = re.compile(rf"T\d+\s*:\s*(?P<size>{_NUMBER})", re.IGNORECASE)
_CUTVIEWER = re.compile(
    r"TOOL/(?P<kind>MILL|DRILL|CHAMFER)\s*,\s*(?P<size>[\d.]+)(?:\s*,\s*(?P<second>[\d.]+))?", re.IGNORECASE
)
# Diameter and length of a tool, as in 10 x 72 or 10x72. With a space on one side only, 2x 6mm means two tools of 6 mm.
_ACROSS = rf"(?:(?:mm|in)?(?:\s+[x×]\s+|[x×])(?:{_FRACTION}|{_NUMBER}))*"
_WITH_UNIT = rf"(?<![\d.,/])(?<!\bthan ){_SIZE}{_ACROSS}\s*(?P<unit>{_MM}|мм\b|inch(?:es)?\b|in\b|\")"
_MEASURED = re.compile(rf"{_WITH_UNIT}(?!\s*(?:l|loc|oal)\b)", re.IGNORECASE)
# A number with a unit after the tool word. If a word such as LENGTH or SHANK follows, the number is not the diameter.
_NO_LENGTH = re.compile(
    rf"{_WITH_UNIT}(?!\s*(?:l\b|loc\b|lo?ng|length|lang|lg\b|oal\b|deep|depth|shank|stick|holder|corner|rad|cr?\b|pitch))",
    re.IGNORECASE,
)
# A diameter such as D10; between vertical bars, D10 is the number of an offset.
_SHORT = re.compile(rf"(?<![\w|])D(?P<size>{_NUMBER})(?![\w|])")
# This comment from FreeCAD is always in mm, because FreeCAD converts the moves of a program to inches, but not its
# comments.
_IN_MM = re.compile(r"\W*compensated tool path\. diameter", re.IGNORECASE)
# In a comment on cutter compensation, a D word is the number of an offset register.
_COMPENSATION = re.compile(r"\bcomp(?:ensation)?\b|\bregister\b", re.IGNORECASE)
_SEVERAL = re.compile(r"\bsizes\b", re.IGNORECASE)  # a comment with the word "sizes" describes several tools
_LENGTH_OFFSET = re.compile(r"(?<!\w)H(\d{1,8})\b")
_TOGETHER = re.compile(r"(?<=\btool)(?=Dia|Radius)")  # in toolDiam: 0.125, a space is inserted before "Diam"
# A size in mm and in inches, as in 11mm / .433.
_IN_BOTH = re.compile(r"(?<![\d.])(?P<mm>\d+(?:\.\d+)?\s*mm)\s*/\s*(?P<inches>\d*\.\d+)(?!\d|\s*mm)", re.IGNORECASE)
_FLUTES = re.compile(r"\b\d+\s*-?\s*fl(?:utes?)?\b", re.IGNORECASE)
_LISTED = re.compile(r"\s*T\d+\s*(?:[|:=]|[\d.]+mm\s+[\d.]+in\b)", re.IGNORECASE)
_LONGEST, _LONGEST_NAME = 200, 60  # characters; longer comments are prose in which a size does not describe a tool.
# Words between a diameter and the word for the tool, as in 1.5 KEY CUTTER.
_KIND = r"(?:\s*(?:flat|square|long|stub|hss|key(?:way|seat)?|woodruff|t-slot|dovetail))*"
_BARE = re.compile(
    rf"(?<![\w.,/#]){_SIZE}(?P<across>)(?P<unit>)(?={_KIND}\s*(?:{_MILLING_WORD}))",
    re.IGNORECASE,
)
# A number directly before the tool word is the tool's diameter, even if the comment contains other numbers.
_ATTACHED = re.compile(
    rf"(?<![\w.,/#]){_SIZE}(?P<across>{_ACROSS}){_UNIT}(?:\s*(?:flat|square|stub|hss))*(?=\s*(?:{_MILLING_WORD}))",
    re.IGNORECASE,
)
# A decimal number or fraction after the tool word, as in DRILL 8.5. A whole number after the tool word can
# be another property; after the word for a pointed tool, it is an angle.
_BEHIND = re.compile(
    rf"(?<![a-zà-ÿа-я])(?:{_MILLING_WORD})\s*(?P<size>{_FRACTION}|\d+[.,]\d*|[.,]\d+)(?P<unit>)$", re.IGNORECASE
)
# A number after a threading tool is the pitch of the thread.
_THREAD = re.compile(r"thread|gewinde|rosca|filet", re.IGNORECASE)
# In a comment with one of these words, a diameter belongs to the part, not to the tool.
_OF_PART = re.compile(r"\b(?:bore|boss|circle|hole|pocket)s?\b|bohrung|tasche", re.IGNORECASE)
# Numbers that are not a diameter: a drill's gauge number (#7), an operation's number (OP 2), and a number of sizes (3
# SIZES).
_OTHER_NUMBER = re.compile(
    r"(?:#|\b(?:no|nr|op|job)\b\.?|\bnumber)\s*\d+(?![./\d])|(?<![\d./])\d+(?=(?:\s+\w+){0,2}\s+sizes\b)", re.IGNORECASE
)
# Taps: M8 X 1.25 is the diameter of a thread and its pitch; 1/4-20 is the diameter and the turns per inch. The nominal
# size of a pipe thread is not the diameter of the thread.
_TAP = re.compile(r"\btap\b(?!\s*drill)", re.IGNORECASE)
_METRIC_THREAD = re.compile(
    rf"(?<![A-Za-z\d])(?P<unit>M)(?P<size>{_NUMBER})(?=\s*[-x×]\s*[\d.,].*\btap\b|\s*tap\b)", re.IGNORECASE
)
_INCH_THREAD = re.compile(
    rf"(?<![\d.,/])(?P<size>{_FRACTION})(?=\s*-\s*\d+(?!.*(?:npt|bsp|pipe)).*\btap\b|\s*tap\b)", re.IGNORECASE
)
# The comment on a tap drill contains the size of the tap, which is not the drill's diameter.
_FOR_TAP = re.compile(r"(?<=drill)\b.*\bfor\b.*\btap\b.*", re.IGNORECASE)
# A fraction after a tool's number is the tool's diameter, as in T9 3/16 HARVEY EM, except for the size of a thread
# (1/4-20).
_NEXT_TO_NUMBER = re.compile(rf"[\s:=-]*(?P<size>{_FRACTION})(?P<across>){_UNIT}(?!\s*-\s*\d)", re.IGNORECASE)
_IS_TOOL = re.compile(rf"(?<![a-zà-ÿа-я])(?:{_MILLING_WORD})|{_UNSPACED}", re.IGNORECASE)
_CORNER = re.compile(rf"\b(?:CR|corner radius|torus_radius)\s*[=:]\s*(?P<size>{_NUMBER})", re.IGNORECASE)
# Sizes of the parts of a tool: flute length 8, LOC=8, stick-out 20 mm, OAL: 20, shank dia 6. Without "=" or ":", the number
# after LOC or OAL is possibly another length, as in 1.25 LOC 3 OAL.
_PARTS = {
    part: re.compile(rf"(?<![a-z])(?:{words})\s*{_SIZE}{_UNIT}", re.IGNORECASE)
    for part, words in (
        ("cutting_edge_height", r"(?:flute length|length of cut|cutting edge height)\s*[:=]?|loc\s*[:=]"),
        ("length", r"stick-?out\s*[:=]?|(?:oal|overall length)\s*[:=]"),
        ("shank_diameter", r"shank(?: dia(?:meter|m)?\b\.?)?\s*[:=]?"),
    )
}
_TAPER = re.compile(rf"\bTAPER\s*=\s*(?P<size>{_NUMBER})\s*deg", re.IGNORECASE)
_ANGLE = re.compile(rf"(?<![\d.,]){_SIZE}\s*(?:°|deg(?:ree)?s?\b)", re.IGNORECASE)
# A common tip angle directly before the word for a pointed tool is not a diameter, so 90 V-BIT is not 90 mm wide.
_BARE_ANGLE = re.compile(
    r"(?<![\w.,/#-])(?P<size>60|82|90|100|118|120|1[34]\d)(?=\s+(?:spot|cent(?:er|re)[- ]?drill|chamfer|countersink|engrav|v[- ]?bit))",
    re.IGNORECASE,
)
_SHAPES = (
    ("ballend", r"ball|kugel|radiusfr|esf.rica|h.misph|сферич|球|볼|ボール"),
    ("bullnose", r"bull|torus|corner"),
    (
        "vbit",
        r"v[- ]?bit|v-?carv|chamfer|engrav|conical|gravier|fase|cent(?:er|re)[- ]?drill|spot|countersink|гравер|senker|chafl|倒角|中心钻|챔퍼",
    ),
    ("drill", r"drill|bohrer|broca|foret|sverlo|сверло|钻|드릴|ドリル"),
)


@dataclass(frozen=True)
class ToldTool:
    """A tool that a comment describes.

    Attributes
    ----------
    number : int or None
        The tool's number in T words; None if the comment contains no tool number.
    tool : Tool
    from_here : bool
        Whether all moves after the comment use this tool, as after comments for CutViewer. If False, the comment
        possibly lists a tool that the program needs later.
    """

    number: int | None
    tool: Tool
    from_here: bool = False


@lru_cache(maxsize=1000)
def tool_told(comment: str, *, inches: bool, of: int | None = None) -> ToldTool | None:
    """Return the tool that a comment describes; None if the comment contains no diameter.

    Parameters
    ----------
    comment : str
        Text of the comment, without its parentheses.
    inches : bool
        Whether decimal lengths without a unit are in inches (G20). Fractions without a unit (1/4) are always in inches.
    of : int, optional
        Number of the new tool if the comment is in the line of a tool change. A diameter in the line of a tool change
        belongs to the new tool even if the comment contains no word for a tool.
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
    """Return the tool number in a comment, also without a diameter; None if the comment contains no tool number."""
    number = _NUMBERED.search(comment)
    return int(number["number"]) if number else None


def _spaced(comment: str) -> str:
    """Return a comment with spaces between words and numbers, and without the number of flutes.

    If a size is given in mm and in inches, only the mm are kept.
    """
    return _IN_BOTH.sub(_in_mm, _FLUTES.sub("", _TOGETHER.sub(" ", comment.replace("_", " "))))


def _in_mm(both: re.Match[str]) -> str:
    """Return the part in mm of a size given in mm and in inches; the whole text if these two sizes differ."""
    mm, from_inches = float(both["mm"][:-2]), float(both["inches"]) * INCH
    return both["mm"] if abs(from_inches - mm) < 0.02 * mm else both[0]


def _size(comment: str, number: re.Match[str] | None) -> re.Match[str] | None:
    """Return the match of a tool's diameter in a comment; None if the comment contains no diameter."""
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
    if number is not None:  # "tool 1 1/4" is tool 1 with 1/4 inch, not 1 1/4 inches
        comment = f"{comment[: number.start()]}  {comment[number.end() :]}"
    comment = _without_offsets(_OTHER_NUMBER.sub("#", _BARE_ANGLE.sub("", comment)), number)
    if _TAP.search(comment):
        return _METRIC_THREAD.search(comment) or _INCH_THREAD.search(comment) or _NO_LENGTH.search(comment)
    found = [match for match in (_MEASURED.search(comment), _BARE.search(comment)) if match]
    size = _ATTACHED.search(comment) or min(found, key=re.Match.start, default=None)
    # A whole number without a unit is possibly the tool's number.
    if size is None or (number is None and _is_bare(size)):
        return _NO_LENGTH.search(comment) or _SHORT.search(comment) or size
    return size


def _size_alone(comment: str, tool: int) -> re.Match[str] | None:
    """Return the match of a diameter in a tool change's comment, which need not contain a word for a tool.

    A D word with the number of the tool is an offset, not a diameter.
    """
    comment = comment.strip()
    short = _SHORT.fullmatch(comment)
    if short:
        return None if short["size"].isdigit() and int(short["size"]) == tool else short
    size = _MEASURED.fullmatch(comment) or (None if _OF_PART.search(comment) else _WORD.search(comment))
    if size is None and not (_TAP.search(comment) or _THREAD.search(comment)) and _shape(comment) != "vbit":
        size = _BEHIND.search(comment)
    return size


def _without_offsets(comment: str, number: re.Match[str] | None) -> str:
    """Return a comment without the D words that are offsets.

    A D word is an offset if its number is the number of the tool or of an H word, or if the comment is on compensation.
    """
    if _COMPENSATION.search(comment):
        return _SHORT.sub("", comment)
    own = {int(offset) for offset in _LENGTH_OFFSET.findall(comment)} | ({int(number["number"])} if number else set())
    return _SHORT.sub(lambda word: "" if word["size"].isdigit() and int(word["size"]) in own else word[0], comment)


def _is_bare(size: re.Match[str]) -> bool:
    """Return whether a size is a whole number without a unit and without a tool length (10 x 72)."""
    return size["size"].isdigit() and not size["unit"] and not size["across"]


def tells_inches(comment: str) -> bool:
    """Return whether a comment gives a diameter as a plain number and as a fraction of an inch: DIA 0.5, 1/2 ENDMILL.

    If a comment contains a size in both forms, the plain number is in inches, and so is the program.
    """
    if "/" not in comment or len(comment) > _LONGEST:
        return False
    comment = _spaced(comment)
    size = _size(comment, _NUMBERED.search(comment))
    return size is not None and not size.groupdict().get("unit") and _also_a_fraction(comment, size)


def _also_a_fraction(comment: str, size: re.Match[str]) -> bool:
    """Return whether a comment also contains the size as a fraction of an inch."""
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
    """Return the tool that a comment describes, without a corner radius or a tip angle that is impossible."""
    unit = INCH if inches else 1.0
    kind = size.groupdict().get("kind")
    shape, sizes = _shape(comment), _part_sizes(comment, inches)
    corner = _CORNER.search(comment)
    rounding = float(corner["size"].replace(",", ".")) * unit if corner else 0.0
    if kind and size["second"] and kind.upper() == "MILL":
        rounding = float(size["second"]) * unit
    elif kind:
        shape = {"DRILL": "drill", "CHAMFER": "vbit"}.get(kind.upper(), shape)
    if shape in ("endmill", "bullnose") and 0 < rounding <= diameter / 2:
        ball = rounding > 0.499 * diameter
        return Tool("ballend", diameter, **sizes) if ball else Tool("bullnose", diameter, rounding, **sizes)
    if shape in ("vbit", "drill"):
        return Tool(shape, diameter, tip_angle=_tip_angle(comment), **sizes)
    return Tool("endmill" if shape == "bullnose" else shape, diameter, **sizes)


def _part_sizes(comment: str, inches: bool) -> dict[str, float]:
    """Return the sizes of flutes, shank and stick-out in a comment, mm, by their names."""
    found = {name: pattern.search(comment) for name, pattern in _PARTS.items()}
    sizes = {name: _millimetres(size, inches) for name, size in found.items() if size}
    return {name: size for name, size in sizes.items() if 0 < size <= _LARGEST}


def _shape(comment: str) -> str:
    return next((shape for shape, words in _SHAPES if re.search(words, comment, re.IGNORECASE)), "endmill")


def _tip_angle(comment: str) -> float | None:
    """Return the included angle of a tip, rad. Fusion's TAPER is half the angle of chamfer and engraving tools."""
    taper = _TAPER.search(comment)
    if taper:
        half = re.search(r"chamfer|fase|engrav|gravier|v-?bit", comment, re.IGNORECASE)
        degrees = (2 if half else 1) * float(taper["size"].replace(",", "."))
    else:
        angle = _ANGLE.search(comment) or _BARE_ANGLE.search(comment)
        degrees = float(angle["size"].replace(",", ".")) if angle and "/" not in angle["size"] else 0.0
    return math.radians(degrees) if 0 < degrees <= 180 else None
