# SPDX-License-Identifier: LGPL-2.1-or-later
"""Replace the words of Siemens controls by the common words with the same meaning."""

from __future__ import annotations

import re
from functools import partial
from typing import NamedTuple

_NUMBER = r"([-+]?(?:\d+\.?\d*|\.\d+))"
# A coordinate or a centre in a distance mode of its own: X=AC(10) is absolute, X=IC(5) is incremental.
_PLACE = re.compile(rf"(?<![A-Z])([XYZIJK])\s*=\s*([AI])C\s*\(\s*{_NUMBER}\s*\)")
_AXES = {"I": "X", "J": "Y", "K": "Z"}  # the axes of centre words
# The corner after a move (RND, CHR), and the number of full turns of an arc in addition to the arc itself (TURN).
_WORD = re.compile(rf"(?<![A-Z])(RND|CHR|TURN)\s*=\s*{_NUMBER}")
_LETTERS = {"RND": ",R", "CHR": ",C", "TURN": "P"}
_TOOL_NAME = re.compile(r"(?<![A-Z])T\s*=\s*\"[^\"]*\"")
_MACHINE_POSITION = re.compile(r"\bSUPA\b")  # G53 of other controls
_SHIFT = re.compile(r"((?:N\s*\d+\s*)?)(A?)TRANS\b(?!\s*=)")
_COORDINATE = re.compile(rf"([XYZ])\s*=?\s*{_NUMBER}")
# Lines without effect on the tool's path: the tolerance of the control, and the stock.
_WITHOUT_EFFECT = re.compile(r"(?:N\s*\d+\s*)?(?:CYCLE832\s*\(.*\)|WORKPIECE\s*\(.*\)|STOPRE)")
_SWIVEL = re.compile(r"(?:N\s*\d+\s*)?CYCLE800\s*\((.*)\)")
_OF_PLANE = slice(4, 13)  # the arguments of CYCLE800 that shift and turn the working plane
_ZERO = re.compile(r"\s*[-+]?0*\.?0*\s*")

# A drilling cycle, after MCALL for the end of each later move in X and Y; MCALL alone ends these cycles.
_CYCLE = re.compile(r"(?:N\s*\d+\s*)?(?:(MCALL)|(?=CYCLE))\s*(?:(CYCLE8[123])\s*\(([^()]*)\))?")


class Drilling(NamedTuple):
    """A drilling cycle of a Siemens control.

    Attributes
    ----------
    modal : bool
        Whether a hole is drilled after each later move in X and Y (MCALL), not only at the tool's position.
    name : str
        Name of the cycle; empty for an MCALL that ends a modal cycle.
    heights : tuple of float
        The height to which the tool descends at rapid, the bottom, and the height after the cycle, in the program's
        unit.
    """

    modal: bool
    name: str
    heights: tuple[float, float, float]


def drilling(line: str) -> Drilling | None:
    """Return the drilling cycle in a line; None if the line contains no cycle that can be read."""
    found = _CYCLE.fullmatch(line)
    if found is None:
        return None
    if not found[2]:
        return Drilling(True, "", (0.0, 0.0, 0.0))
    # The height after the cycle, the reference plane, the clearance above this plane, and the depth, absolute or
    # below the reference plane.
    texts = [*found[3].replace(" ", "").split(","), "", "", "", "", ""][:5]
    if not all(re.fullmatch(_NUMBER, text) for text in texts if text) or not texts[0] or not (texts[3] or texts[4]):
        return None
    after, plane, clearance, bottom, depth = (float(text or 0) for text in texts)
    bottom = bottom if texts[3] else plane - abs(depth)
    return Drilling(found[1] is not None, found[2], (plane + clearance, bottom, after))


def spelled(line: str, place: dict[str, float], shift: dict[str, float], *, relative: bool) -> str | None:
    """Return a line with common words in place of Siemens' words; None if the line contains none of these words.

    Parameters
    ----------
    line : str
        The line in capitals, without the comment after a semicolon and without block delete.
    place, shift : dict
        The known coordinates of the tool, and the shift of the coordinates (TRANS), by axis, in the program's unit.
    relative : bool
        Whether G91 is in force in the line.
    """
    swivel = _SWIVEL.fullmatch(line)
    if _WITHOUT_EFFECT.fullmatch(line) or (swivel and all(map(_ZERO.fullmatch, swivel[1].split(",")[_OF_PLANE]))):
        return ""
    begin = _SHIFT.match(line)
    if begin:
        before = shift if begin[2] else {}
        values = {axis: float(value) for axis, value in _COORDINATE.findall(line[begin.end() :])}
        words = (f"{axis}{values.get(axis, 0.0) + before.get(axis, 0.0):.9f}" for axis in "XYZ")
        return f"{begin[1]}G52 {' '.join(words)}"
    result = _PLACE.sub(partial(_coordinate, place, relative), _TOOL_NAME.sub("", line))
    result = _MACHINE_POSITION.sub("G53", _WORD.sub(_common, result))
    return None if result == line else result


def _common(word: re.Match[str]) -> str:
    value = float(word[2]) + (word[1] == "TURN")
    return f"{_LETTERS[word[1]]}{value:.9f} "


def _coordinate(place: dict[str, float], relative: bool, word: re.Match[str]) -> str:
    """Return a coordinate in the distance mode of its line; the word itself if the tool's position is unknown."""
    letter, value, is_centre = word[1], float(word[3]), word[1] in _AXES
    axis, is_absolute = _AXES.get(letter, letter), word[2] == "A"
    if is_absolute != (not relative and not is_centre):
        if axis not in place:
            return word[0]
        value += -place[axis] if is_absolute else place[axis]
    return f"{letter}{value:.9f} "
