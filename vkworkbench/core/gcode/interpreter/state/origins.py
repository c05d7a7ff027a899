# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the origins of NC program coordinates: shifts (G52, G92) and work offsets (G54 to G59.3, set by G10).

All origins are stored in the coordinates of the toolpath. The origin of the toolpath is the work offset in force at the
first move.
"""

from __future__ import annotations

from typing import Dict, Tuple

System = Tuple[int, float]  # Ten times the G-code of a work offset (540 for G54), and its P or H word.
Values = Dict[str, float]  # Lengths in mm, by axis.
FIRST: System = (540, 0.0)
# Work offsets, by the P word of G10 that selects them. P0 is not in this table, because it means the work offset in
# force.
NUMBERED: dict[float, System] = dict(
    zip(map(float, range(1, 10)), [(code, 0.0) for code in (540, 550, 560, 570, 580, 590, 591, 592, 593)])
)


class Origins:
    """The work offsets and the shift (G52, G92) that a program sets.

    Attributes
    ----------
    shift : dict
        The shift of G52 and G92 along each axis, mm. LinuxCNC has one shift for both codes.
    system : (int, float)
        The work offset in force.
    used : bool
        Whether an origin can differ from the toolpath's origin; False in most programs.
    """

    def __init__(self) -> None:
        self.used = False
        self.shift: Values = {}
        self.system = FIRST
        self._suspended: Values = {}
        self._origins: dict[System, Values] = {}
        self._machine: dict[System, Values] = {}  # Origins in machine coordinates, from G10 L2.
        self._assumed: set[System] = set()  # Work offsets whose origins are not in the program.
        self._zero: Values = {}  # Origin of the toolpath in machine coordinates.

    def of(self, letter: str) -> float:
        """Return the origin in force along an axis, mm."""
        return self._origins.get(self.system, {}).get(letter, 0.0) + self.shift.get(letter, 0.0)

    def begin(self) -> None:
        """Set the origin of the toolpath to the work offset in force. Call `begin` at the first move of the program."""
        self._origins[self.system] = dict.fromkeys("XYZ", 0.0)
        self._zero = dict(self._machine.get(self.system, {}))

    def select(self, system: System) -> bool:
        """Select a work offset after the first move; return whether the program contains its origin.

        Along axes whose origin is not in the program, the origin of the previous work offset is kept.
        """
        self.used = True
        before, self.system = self.system, system
        origin = self._origins.setdefault(system, {})
        machine = self._machine.get(system, {})
        for letter in "XYZ":
            if letter in origin:
                continue
            if letter in machine and letter in self._zero:
                origin[letter] = machine[letter] - self._zero[letter]
                continue
            self._assumed.add(system)
            origin[letter] = self._origins[before].get(letter, 0.0)
            if letter in machine:
                self._zero[letter] = machine[letter] - origin[letter]
        return system not in self._assumed

    def set_machine(self, system: System, values: Values, *, moved: bool) -> bool:
        """Set the origin of a work offset in machine coordinates (G10 L2).

        Parameters
        ----------
        system : (int, float)
            The work offset.
        values : dict
            The origin along each axis, mm.
        moved : bool
            Whether the program has already moved the tool.

        Returns
        -------
        bool
            Whether the program determines the coordinates of the moves that follow. If False, the toolpath's origin is
            assumed to be at the machine's zero point, as in LinuxCNC without a table of work offsets.
        """
        machine = self._machine.setdefault(system, {})
        machine.update(values)
        if not moved:
            return True
        self.used = True
        origin, known = self._origins.setdefault(system, {}), True
        for letter, value in values.items():
            if letter in self._zero:
                origin[letter] = value - self._zero[letter]
            elif system == self.system:
                known = False
                self._zero[letter], origin[letter] = 0.0, value
            else:
                origin.pop(letter, None)
        return known

    def set_here(self, system: System, place: Values, values: Values) -> None:
        """Set the origin of a work offset so that the tool's position has the coordinates `values` (G10 L20).

        Parameters
        ----------
        system : (int, float)
            The work offset.
        place, values : dict
            The tool's position, and its new coordinates, mm, by axis.
        """
        self.used = True
        origin = self._origins.setdefault(system, {})
        for letter, value in values.items():
            origin[letter] = place[letter] - value - self.shift.get(letter, 0.0)

    def shift_by(self, values: Values) -> None:
        """Set the shift along some axes (G52), mm."""
        self.used = True
        self.shift.update(values)

    def shift_here(self, letter: str, place: float, value: float) -> None:
        """Set the shift so that the tool's position has the coordinate `value` along an axis (G92), mm."""
        self.used = True
        self.shift[letter] = place - value - (self.of(letter) - self.shift.get(letter, 0.0))
        self._suspended = {}

    def end_shift(self, *, keep: bool) -> None:
        """End the shift of G52 and G92.

        If `keep` is True (G92.2), store the shift for `resume_shift`; if False (G92.1), delete the shift.
        """
        self._suspended = self.shift if keep else {}
        self.shift = {}

    def resume_shift(self) -> None:
        """Restore the shift that G92.2 suspended (G92.3)."""
        self.shift = dict(self._suspended or self.shift)
