# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mirror, scale and rotate coordinates (G51.1, G51, G68), and rotate work offsets (G10 L2 R).

A point in the XY plane is a complex number. Controls apply the mirror first, then the scale, then the rotation.
"""

from __future__ import annotations

from cmath import rect
from math import radians
from typing import Callable, NamedTuple

from vkworkbench.core.gcode.interpreter.state.origins import System


class Map(NamedTuple):
    """A similarity of the XY plane, which maps a point p to ``factor * p + offset``.

    If `flips` is true, the point p is first replaced by its complex conjugate.

    Attributes
    ----------
    factor, offset : complex
        Factor for scale and rotation, and translation in mm.
    flips : bool
        Whether the map changes the direction of arcs.
    """

    factor: complex = 1.0
    offset: complex = 0.0
    flips: bool = False

    def vector(self, way: complex) -> complex:
        """Return the vector that the map makes of a vector (a difference between two points)."""
        return self.factor * (way.conjugate() if self.flips else way)

    def point(self, point: complex) -> complex:
        """Return the image of a point."""
        return self.vector(point) + self.offset

    def back(self, point: complex) -> complex:
        """Return the point whose image is the given point."""
        before = (point - self.offset) / self.factor
        return before.conjugate() if self.flips else before

    def then(self, other: Map) -> Map:
        """Return the map that applies this map first, and then another map."""
        factor = self.factor.conjugate() if other.flips else self.factor
        return Map(other.factor * factor, other.point(self.offset), self.flips != other.flips)


def _around(factor: complex, centre: complex) -> Map:
    """Return the map that rotates and scales around a point."""
    return Map(factor, centre - factor * centre)


class Maps:
    """The mirrors, scales and rotations in force.

    Attributes
    ----------
    mirrors : dict of str to float
        For each mirrored axis (X or Y), the coordinate that the mirror does not change, mm.
    scale, turn : (complex, complex) or None
        The factor and the fixed point (mm) of G51, and of G68; None if the code is not in force.
    height : (float, float)
        The factor of the scale along Z, and the height that this scale does not change, mm.
    angles : dict
        The angle of each rotated work offset, degrees.
    """

    def __init__(self) -> None:
        self.mirrors: dict[str, float] = {}
        self.scale: tuple[complex, complex] | None = None
        self.turn: tuple[complex, complex] | None = None
        self.height = (1.0, 0.0)
        self.angles: dict[System, float] = {}

    def rotate_system(self, system: System, degrees: float) -> None:
        """Rotate a work offset around its origin."""
        self.angles.pop(system, None)
        if degrees:
            self.angles[system] = degrees

    @property
    def fixes_origin(self) -> bool:
        """bool : Whether a map is in force under which controls do not allow another origin (G52, G92)."""
        return bool(self.mirrors or self.scale or self.turn)

    def xy(self, system: System, of_system: complex, origin: complex) -> Map:
        """Return the map from the programmed points to the points of the toolpath.

        Parameters
        ----------
        system : (int, float)
            The work offset in force.
        of_system, origin : complex
            The origin of the work offset, and the origin of the program's coordinates, mm.
        """
        result = Map()
        if "X" in self.mirrors:
            result = result.then(Map(-1.0, 2 * (self.mirrors["X"] + origin.real), flips=True))
        if "Y" in self.mirrors:
            result = result.then(Map(1.0, 2j * (self.mirrors["Y"] + origin.imag), flips=True))
        for one in (self.scale, self.turn):
            if one is not None:
                result = result.then(_around(one[0], one[1] + origin))
        angle = self.angles.get(system, 0.0)
        return result.then(_around(rotation(angle), of_system)) if angle else result

    def height_of(self, z: float, origin: float) -> float:
        """Return the height after scaling, mm; `origin` is the origin of the program's heights."""
        factor, fixed = self.height
        return fixed + origin + factor * (z - fixed - origin)

    def height_before(self, z: float, origin: float) -> float:
        """Return the height before scaling, mm, from a height after scaling; `origin` is as in `height_of`."""
        factor, fixed = self.height
        return fixed + origin + (z - fixed - origin) / factor


def rotation(degrees: float) -> complex:
    """Return the complex factor of a rotation; the factors of right angles are exact."""
    quarters, rest = divmod(degrees, 90.0)
    return 1j ** (int(quarters) % 4) * (rect(1.0, radians(rest)) if rest else 1.0)


def mapped(move: dict[str, float], letters: str, function: Callable[[complex], complex], rest: complex) -> None:
    """Map the X and Y words of a move, if one of the two is present.

    Parameters
    ----------
    move : dict
        The words of a move, mm, which are changed.
    letters : str
        The letters of the words along X and Y.
    function : callable
        Maps the point or the vector of the two words.
    rest : complex
        The values (real part along X, imaginary part along Y) that are used for absent words.
    """
    along_x, along_y = letters[0], letters[1]
    if along_x in move or along_y in move:
        value = function(complex(move.get(along_x, rest.real), move.get(along_y, rest.imag)))
        move[along_x], move[along_y] = value.real, value.imag
