# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the offset curves of cutter compensation (straight lines and arcs), and compute their intersections.

A point in the plane is a complex number, mm.
"""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import pi, sqrt
from typing import NamedTuple

_SAME = 1e-6  # mm; points at most this far apart are treated as equal


@dataclass
class Curve:
    """An offset curve: a straight line or an arc.

    Attributes
    ----------
    start, end : complex
        The end points.
    centre : complex or None
        The centre of an arc; None for a line.
    turn : int
        1 for a counter-clockwise arc, -1 for a clockwise arc, 0 for a line.
    """

    start: complex
    end: complex
    centre: complex | None = None
    turn: int = 0

    def way(self, point: complex) -> complex:
        """Return the direction of the curve at a point on the curve, as a vector of length 1."""
        way = self.end - self.start if self.centre is None else self.turn * 1j * (point - self.centre)
        return way / abs(way)

    def contains(self, point: complex) -> bool:
        """Return whether a point on the extended curve (whole line or circle) is between the end points."""
        if min(abs(point - self.start), abs(point - self.end)) <= _SAME:
            return True
        if self.centre is None:
            along = (self.way(point).conjugate() * (point - self.start)).real
            return 0 < along < abs(self.end - self.start)
        whole, part = (
            (self.turn * phase((one - self.centre) / (self.start - self.centre))) % (2 * pi)
            for one in (self.end, point)
        )
        return part < whole or abs(self.end - self.start) <= _SAME

    def meets(self, other: Curve) -> list[complex]:
        """Return the intersection points of two curves, which are extended to whole lines or circles."""
        if self.centre is not None and other.centre is not None:
            return _of_circles(self.centre, abs(self.end - self.centre), other.centre, abs(other.start - other.centre))
        if self.centre is None and other.centre is None:
            way, across = self.way(0), other.way(0)
            sine = (way.conjugate() * across).imag
            if abs(sine) < 1e-12:
                return []
            return [self.start + way * ((other.start - self.start).conjugate() * across).imag / sine]
        line, arc = (self, other) if self.centre is None else (other, self)
        centre = arc.centre or 0.0
        way, foot = line.way(0), centre - line.start
        along, off = (way.conjugate() * foot).real, (way.conjugate() * foot).imag
        half = abs((self.end if arc is self else other.start) - centre) ** 2 - off**2
        if half < 0:
            return []
        return [line.start + way * (along + sign * sqrt(half)) for sign in (-1, 1)]


def _of_circles(centre: complex, radius: float, other: complex, other_radius: float) -> list[complex]:
    way = other - centre
    if abs(way) <= _SAME:
        return []
    along = (abs(way) ** 2 + radius**2 - other_radius**2) / (2 * abs(way))
    half = radius**2 - along**2
    if half < 0:
        return []
    return [centre + way / abs(way) * complex(along, sign * sqrt(half)) for sign in (-1, 1)]


@dataclass
class Compensation:
    """The cutter compensation in force.

    Attributes
    ----------
    name : str
        Name of the compensation's G-code.
    side : int
        1 if the tool is to the left of the path, -1 if the tool is to the right.
    radius : float
        Distance of the tool's centre from the path, mm.
    programmed, tool : complex
        The last end point of the programmed path, and the position of the tool's centre, mm.
    last : Curve or None
        The last offset curve; None before the first compensated move.
    command : int
        Index of the command from which `last` was computed.
    relative : bool
        Whether the words of the command for `last` are relative (G91).
    ends : bool
        Whether the next move leads back to the programmed path, because of G40.
    """

    name: str
    side: int
    radius: float
    programmed: complex
    tool: complex
    last: Curve | None = None
    command: int = -1
    relative: bool = False
    ends: bool = False


class Corner(NamedTuple):
    """A corner after the last move, to be rounded (``,R``) or chamfered (``,C``) when the next move is read.

    Attributes
    ----------
    letter : str
        The letter of the corner word, with its comma.
    size : float
        Radius of the arc, or distance from the corner to both ends of the chamfer, mm.
    command, line : int
        Index of the command whose move ends at the corner, and line of the program.
    start, end : complex
        The end points of the move before the corner; `end` is the corner.
    """

    letter: str
    size: float
    command: int
    line: int
    start: complex
    end: complex
