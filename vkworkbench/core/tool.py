# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the tool of a simulation as a convex solid of revolution."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, tan

import numpy as np

from vkworkbench.core.toolpath import COORDINATE_LIMIT
from vkworkbench.given import number, of_kind, positive
from vkworkbench.language import Message, Unusable

SHAPES = ("endmill", "ballend", "bullnose", "vbit", "drill")
_DEFAULT_TIP_ANGLE = {"vbit": pi / 3, "drill": 118 * pi / 180}
_SIZES = {
    "diameter": "a number of mm",
    "corner_radius": "a number of mm",
    "tip_angle": "a number of rad",
    "tip_diameter": "a number of mm",
}
_BODIES = ("cutting_edge_height", "length", "shank_diameter", "holder_diameter", "holder_length")


@dataclass(frozen=True)
class Tool:
    """A milling tool or drill: an upright, convex solid of revolution, whose tip is at the programmed point.

    The solid has no upper end, because in the simulation the shank cuts like the cutting edge below it.
    `core.zbuffer.collisions` finds collisions of the shank and the holder from the sizes of both.

    Parameters
    ----------
    shape : {"endmill", "ballend", "bullnose", "vbit", "drill"}
        Form of the tip.
    diameter : float
        Cutting diameter, mm.
    corner_radius : float
        Radius of a bull-nose mill's corner, mm; 0 makes a flat end, half the diameter makes a ball end.
    tip_angle : float, optional
        Included angle of a V-bit's or a drill's tip, rad; by default 60 and 118 degrees.
    tip_diameter : float
        Diameter of the flat end of a V-bit's cone, mm. Chamfer mills and engravers have a flat end.
    cutting_edge_height, length : float, optional
        Height above the tip at which the flutes end, and height at which the holder begins, mm.
    shank_diameter, holder_diameter, holder_length : float, optional
        Sizes of the shank and of the holder, mm.

    Raises
    ------
    Unusable
        If the diameter is not a positive number of at most a kilometre, the corner radius is above half the diameter,
        the tip angle is outside ]0, pi], or the tip is wider than the tool.
    ValueError
        If the shape is unknown, a size is a text that is not a number, or a size of shank, holder or flutes is not
        positive.
    TypeError
        If a size is not a number. (FreeCAD's quantities are accepted, in mm.)
    """

    shape: str
    diameter: float
    corner_radius: float = 0.0
    tip_angle: float | None = None
    tip_diameter: float = 0.0
    cutting_edge_height: float | None = None
    length: float | None = None
    shank_diameter: float | None = None
    holder_diameter: float | None = None
    holder_length: float | None = None

    def __post_init__(self) -> None:
        if self.shape not in SHAPES:
            raise ValueError(f"unknown tool shape {self.shape!r}; known are {', '.join(SHAPES)}")
        for name, takes in _SIZES.items():
            given = getattr(self, name)
            if given is not None or name != "tip_angle":
                # `number` converts FreeCAD's quantities to plain numbers. The checks below reject unusable numbers.
                object.__setattr__(self, name, number(name, given, takes))
        for name in _BODIES:
            given = getattr(self, name)
            if given is not None:
                object.__setattr__(self, name, number(name, given, "a positive number of mm", positive))
        if not (self.radius > 0 and self.diameter <= COORDINATE_LIMIT):
            raise Unusable(Message("tool-diameter", diameter=self.diameter))
        if self.shape == "bullnose" and not 0 <= self.corner_radius <= self.radius:
            raise Unusable(Message("corner-radius", radius=self.radius, corner=self.corner_radius))
        if self.tip_angle is not None and not 0 < self.tip_angle / 2 <= pi / 2:
            raise Unusable(Message("tip-angle", angle=self.tip_angle))
        if not 0 <= self.tip_diameter <= self.diameter:
            raise Unusable(Message("tip-diameter", diameter=self.diameter, tip=self.tip_diameter))

    @property
    def radius(self) -> float:
        """Cutting radius, mm."""
        return self.diameter / 2

    @property
    def rounding(self) -> float:
        """Radius of the rounded corner, mm: the tool's radius for a ball end, 0 for a tool without a rounded corner."""
        return {"ballend": self.radius, "bullnose": self.corner_radius}.get(self.shape, 0.0)

    @property
    def steepness(self) -> float:
        """Rise of the conical tip per mm of radius; 0 without a cone."""
        if self.shape not in _DEFAULT_TIP_ANGLE:
            return 0.0
        angle = self.tip_angle if self.tip_angle is not None else _DEFAULT_TIP_ANGLE[self.shape]
        # An angle of pi is a flat end; tan(pi / 2) is finite because of rounding.
        return 1 / tan(angle / 2) if angle < pi else 0.0

    @property
    def tip(self) -> float:
        """Radius within which a conical tip is flat, mm; 0 without a cone."""
        return self.tip_diameter / 2 if self.steepness else 0.0

    @property
    def body_sizes(self) -> dict[str, float]:
        """The known sizes of flutes, shank and holder, mm, by their names."""
        return {name: size for name in _BODIES if (size := getattr(self, name)) is not None}

    def scaled(self, factor: float) -> Tool:
        """Return the tool with all its lengths multiplied by a factor."""
        sizes = self.body_sizes
        sizes.update(diameter=self.diameter, corner_radius=self.corner_radius, tip_diameter=self.tip_diameter)
        return Tool(self.shape, tip_angle=self.tip_angle, **{name: factor * size for name, size in sizes.items()})

    @property
    def rim(self) -> float:
        """Height above the tip at which the tool reaches its full radius, mm."""
        return float(self.profile(np.array(self.radius)))

    def height(self, r: np.ndarray | float) -> np.ndarray:
        """Return the height of the tool's lower surface above its tip.

        Parameters
        ----------
        r : array_like
            Distance from the tool's axis, mm.

        Returns
        -------
        ndarray
            Heights, mm, an array with the shape of `r`; infinite outside the tool.
        """
        r = np.asarray(r, float)
        return np.where(r <= self.radius, self.profile(r), np.inf)

    def profile(self, r: np.ndarray) -> np.ndarray:
        """Return the height of the lower surface above the tip at distances `r` from the axis, mm.

        At distances beyond the tool's radius, for example by rounding, the height is the height at the full radius.
        """
        corner = self.rounding
        flat, width = (self.radius - corner, corner) if corner else (self.tip, self.radius - self.tip)
        beyond_flat = np.minimum(np.maximum(r - flat, 0.0), width)
        return corner - np.sqrt(corner**2 - beyond_flat**2) if corner else self.steepness * beyond_flat


def check_tool(given: object) -> None:
    """Raise a TypeError that explains how to make a tool, unless a Tool is given."""
    of_kind("a tool", given, Tool, "a Tool(shape, diameter, ...)")
