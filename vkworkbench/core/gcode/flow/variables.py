# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the values of an NC program's variables: #1, #500, #<depth>, #<_depth>."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Union

from vkworkbench.core.gcode.flow.ended import Ended, Unknown
from vkworkbench.language import Message

# The value of a variable is a number, or None for an empty variable of a Fanuc control. If the value is unknown, a
# Message with the reason is stored instead.
Value = Union[float, None, Message]

ALARM = 3000  # On Fanuc controls, an assignment to #3000 raises an alarm.
_LARGEST_NUMBER = 99_999  # Variables with larger numbers do not exist, which limits the memory for variables.
_WHOLE = 1e-4  # LinuxCNC: largest difference between a variable's number and a whole number.
_RESULTS = frozenset(["_VALUE", "_VALUE_RETURNED"])  # LinuxCNC: the result of a subprogram.
# LinuxCNC's variables for the state of the machine.
_OF_MACHINE = frozenset([
    "_VMAJOR", "_VMINOR", "_LINE", "_MOTION_MODE", "_PLANE", "_CCOMP", "_METRIC", "_IMPERIAL", "_ABSOLUTE",
    "_INCREMENTAL", "_INVERSE_TIME", "_UNITS_PER_MINUTE", "_UNITS_PER_REV", "_COORD_SYSTEM", "_TOOL_OFFSET",
    "_RETRACT_R_PLANE", "_RETRACT_OLD_Z", "_SPINDLE_RPM_MODE", "_SPINDLE_CSS_MODE", "_IJK_ABSOLUTE_MODE",
    "_LATHE_DIAMETER_MODE", "_LATHE_RADIUS_MODE", "_SPINDLE_ON", "_SPINDLE_CW", "_MIST", "_FLOOD",
    "_SPEED_OVERRIDE", "_FEED_OVERRIDE", "_ADAPTIVE_FEED", "_FEED_HOLD", "_FEED", "_RPM", "_X", "_Y", "_Z",
    "_A", "_B", "_C", "_U", "_V", "_W", "_ABS_X", "_ABS_Y", "_ABS_Z", "_ABS_A", "_ABS_B", "_ABS_C", "_ABS_U",
    "_ABS_V", "_ABS_W", "_CURRENT_TOOL", "_CURRENT_POCKET", "_SELECTED_TOOL", "_SELECTED_POCKET", "_TASK",
    "_CALL_LEVEL", "_REMAP_LEVEL",
])  # fmt: skip
# The axes of variables that contain the tool's coordinates. The value of a variable is known if the program determines
# the coordinate.
_PLACE = {5420: "X", 5421: "Y", 5422: "Z"}
_PLACE_OF_FANUC = {5001: "X", 5002: "Y", 5003: "Z", 5041: "X", 5042: "Y", 5043: "Z"}
_FIRST_OF_MACHINE, _LAST_OF_MACHINE = 5000, 5999  # LinuxCNC: positions, offsets, the tool table, results of probing.
_FIRST_OF_FANUC = 1000  # Fanuc: signals, tool offsets, alarms, clocks, modal states, positions.
_KEPT_FROM, _KEPT_TO = 500, 999  # Fanuc: variables that keep their values when the power is off.


@dataclass
class Frame:
    """The local variables in one run of an NC program or subprogram.

    Attributes
    ----------
    numbers : dict
        The values of variables such as #1, by their numbers.
    names : dict
        The values of #<name> by their names.
    left : dict of int to int
        Remaining number of runs of each REPEAT loop that is not finished, by the index of the loop's first line.
    """

    numbers: dict[int, Value] = field(default_factory=dict)
    names: dict[str, Value] = field(default_factory=dict)
    left: dict[int, int] = field(default_factory=dict)


class Variables:
    """The variables of an NC program, with their values before the current line.

    Parameters
    ----------
    fanuc : bool
        Whether the program is for a Fanuc control, on which a variable without a value is empty. In LinuxCNC, a
        variable without a value is 0.
    report : callable
        Reports a message on the current line.
    place : callable
        Returns the known coordinates of the tool, by axis, in the program's unit.

    Attributes
    ----------
    frames : list of Frame
        The local variables of the main program and of the called subprograms, innermost call last.
    changes : int
        Counter that grows with each change of a variable or of a REPEAT loop's remaining runs, and with each run of a
        subprogram.
    """

    def __init__(
        self, *, fanuc: bool, report: Callable[[Message], None], place: Callable[[], dict[str, float]]
    ) -> None:
        self._fanuc = fanuc
        self._report, self._place = report, place
        self._locals = 33 if fanuc else 30  # largest number of a local variable
        self._numbers: dict[int, Value] = {}
        self._names: dict[str, Value] = {}
        self.frames = [Frame()]
        self.changes = 0

    def numbered(self, number: float | None) -> float | None:
        """Return the value of a variable with a number; None for an empty variable."""
        index = self._index(number)
        if index == 0:
            return None
        if self._from_machine(index):
            return self._coordinate((_PLACE_OF_FANUC if self._fanuc else _PLACE).get(index, ""), f"#{index}")
        values = self._values(index)
        if index in values:
            return _known(values[index])
        if self._fanuc and (index >= _FIRST_OF_FANUC or _KEPT_FROM <= index <= _KEPT_TO):
            raise Unknown(Message("value-of-machine", name=f"#{index}"))
        # No report for an unset local variable of a subprogram: it is an argument that the call leaves out.
        if values is not self.frames[-1].numbers or len(self.frames) == 1:
            self._report(Message("variable-unset"))
        return None if self._fanuc else 0.0

    def named(self, name: str) -> float | None:
        """Return the value of a variable with a name."""
        values = self._values_by_name(name)
        if name in values:
            return _known(values[name])
        if name in _RESULTS:
            return 0.0
        if _is_of_machine(name):
            return self._coordinate(name[1:], f"#<{name.lower()}>")
        raise Ended(Message("name-unset", name=f"#<{name.lower()}>"))

    def _coordinate(self, letter: str, name: str) -> float:
        """Return the tool's coordinate along an axis; raise Unknown if the program does not determine it."""
        place = self._place()
        if letter not in place:
            raise Unknown(Message("value-of-machine", name=name))
        self.changes += 1  # the position can differ in each run of a loop, so the loop is not endless
        return place[letter]

    def exists(self, name: str) -> bool:
        """Return whether a variable with a name has a value."""
        return name in self._values_by_name(name) or name in _RESULTS or _is_of_machine(name)

    def set_number(self, number: float | None, value: Value) -> None:
        """Assign a value to a variable with a number."""
        index = self._index(number)
        if self._fanuc and index == ALARM:
            raise Ended(Message("alarm"))
        if self._moves_origin(index):
            self._report(Message("coordinates-not-changed", name=f"#{index}"))
        if not self._from_machine(index):
            self._set(self._values(index), index, value)

    def set_name(self, name: str, value: Value) -> None:
        """Assign a value to a variable with a name."""
        self._set(self._values_by_name(name), name, value)

    def _set(self, values: dict[Any, Value], key: int | str, value: Value) -> None:
        self.changes += values.get(key) != value or key not in values
        values[key] = value

    def _index(self, number: float | None) -> int:
        """Return the number of a variable as a whole number. Fanuc controls also have #0, which is always empty."""
        number = number or 0.0
        index = round(number)
        if not (0 if self._fanuc else 1) <= index <= _LARGEST_NUMBER or abs(number - index) > _WHOLE:
            raise Ended(Message("no-variable", name=f"#{number:g}"))
        return index

    def _values(self, index: int) -> dict[int, Value]:
        return self.frames[-1].numbers if index <= self._locals else self._numbers

    def _values_by_name(self, name: str) -> dict[str, Value]:
        return self._names if name[0] == "_" else self.frames[-1].names

    def _from_machine(self, index: int) -> bool:
        """Return whether a variable's value comes from the machine, even after the program assigns a value."""
        first = _FIRST_OF_FANUC if self._fanuc else _FIRST_OF_MACHINE
        return first <= index <= _LAST_OF_MACHINE

    def _moves_origin(self, index: int) -> bool:
        """Return whether an assignment changes a work offset or a tool offset."""
        return 5201 <= index <= 5400 or (self._fanuc and (2000 <= index < 3000 or 7000 <= index < 8000))


def _known(value: Value) -> float | None:
    if isinstance(value, Message):
        raise Unknown(value)
    return value


def _is_of_machine(name: str) -> bool:
    return name in _OF_MACHINE or name.startswith(("_HAL[", "_INI["))
