# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the modal state of an NC program, which M70 saves and M72 restores."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.units import INCH

# The fields of `Modes` that store modal G-codes for `linearize`, by the code.
GROUPS = {
    **dict.fromkeys(codes.PLANES, "plane"),
    codes.ABSOLUTE: "distance",
    codes.RELATIVE: "distance",
    codes.ABSOLUTE_CENTRES: "centres",
    codes.RELATIVE_CENTRES: "centres",
    codes.TO_START: "retract",
    codes.TO_RETRACT_PLANE: "retract",
}


@dataclass
class Modes:
    """The modal state, without the motion.

    Attributes
    ----------
    unit, feed_unit : float
        The unit of lengths and the unit of feed rates, mm: 25.4 for inches, 1 for mm. The two units differ only under
        Siemens' G70.
    plane, distance, centres, retract : int
        G-codes in force, as ten times their numbers (170 for G17): G17 to G19, G90 or G91, G90.1 or G91.1, G98 or G99.
    feed_mode : int
        930, 940 or 950 for G93, G94 or G95.
    per_turn : float or None
        The last F word under G95; None in other feed modes.
    feed : float or None
        The feed rate in force, mm/s; None before the first F word.
    offset : (int, float)
        G-code of the work offset in force, as ten times its number (540 for G54), and its P or H word.
    """

    unit: float = 1.0
    feed_unit: float = 1.0
    plane: int = codes.XY_PLANE
    distance: int = codes.ABSOLUTE
    centres: int = codes.RELATIVE_CENTRES
    retract: int = codes.TO_START
    feed_mode: int = codes.PER_MINUTE
    per_turn: float | None = None
    feed: float | None = None
    offset: tuple[int, float] = (540, 0.0)

    @property
    def relative(self) -> bool:
        """bool : Whether coordinates are relative to the tool (G91)."""
        return self.distance == codes.RELATIVE

    @property
    def absolute_centres(self) -> bool:
        """bool : Whether the centre words of arcs are coordinates (G90.1)."""
        return self.centres == codes.ABSOLUTE_CENTRES

    def measure_in(self, code: int, of_lengths: frozenset[int]) -> None:
        """Set the unit of lengths and feed rates.

        Parameters
        ----------
        code : int
            G-code of the unit, as ten times its number (200 for G20).
        of_lengths : frozenset of int
            G-codes that set the unit of lengths only.
        """
        self.unit = INCH if code in codes.INCHES else 1.0
        if code not in of_lengths:
            self.feed_unit = self.unit
