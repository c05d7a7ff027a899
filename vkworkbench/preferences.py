# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences with their meanings and defaults.

Commands and macros use the same preferences. FreeCAD stores the preferences in its parameters, in ``Mod/VkWorkbench``,
with names such as ``ImageWidth``. A page in FreeCAD's preferences dialog shows the preferences. This module does not
import numpy, because FreeCAD's start loads this module to register the page.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path

OWN = "own"  # in `mark_simulator`: the simulator that FreeCAD's button starts; in `machine`: the user's own machine
GROUP = "User parameter:BaseApp/Preferences/Mod/VkWorkbench"
_LONGEST_SETTINGS = 100_000  # characters in a file with a machine's settings; grbl prints fewer than 2000

# View directions by the names of FreeCAD's standard views.
DIRECTIONS = {
    "Top": (0, 0, -1), "Front": (0, 1, 0), "Right": (-1, 0, 0), "Rear": (0, -1, 0), "Left": (1, 0, 0),
    "Bottom": (0, 0, 1), "Isometric": (-1, 1, -1),
}  # fmt: skip


def _number(default: float, least: float, most: float):
    return field(default=default, metadata={"least": least, "most": most})


def _choice(default: str, choices: Callable[[], tuple[str, ...]]):
    return field(default=default, metadata={"choices": choices})


def _simulators() -> tuple[str, ...]:
    """Return the names of the simulators that this FreeCAD has, after "own"."""
    from vkworkbench.core.simulators import available
    from vkworkbench.freecad import version

    return OWN, *(simulator.name for simulator in available(version()))


def _machines() -> tuple[str, ...]:
    """Return the names of the typical machines."""
    from vkworkbench.core import MACHINES

    return tuple(MACHINES)


@dataclass(frozen=True)
class Preferences:
    """The user's preferences.

    Attributes
    ----------
    mark_simulator : {"own", "z-buffer", "legacy", "OpenGL"}
        Simulator whose time the marks in the tree show: the simulator that FreeCAD's button starts, the paper's
        extended z-buffer, FreeCAD's legacy simulator in fast-forward, or FreeCAD's OpenGL simulator at the highest
        speed. FreeCAD 0.20 has no OpenGL simulator.
    legacy_accuracy : float
        Edge length of the legacy simulator's cells, in percent of the stock's longer side. 0.1 is the finest position
        of the simulator's slider, and 1 is the coarsest.
    opengl_quality : int
        Position of the OpenGL simulator's quality slider. 10 is the best quality.
    time_budget : float
        Time limit of a simulation, s. Longer simulations get a warning, and recommended settings stay within the limit.
    memory_budget : float
        Memory limit of a simulation, MB. Simulations that need more memory get a warning, and recommended settings stay
        within the limit.
    image_width, image_height : int
        Size of the extended z-buffer's image, pixels. The default is the size in the paper (section 1).
    view_direction : str
        View direction of the z-buffer: one of FreeCAD's standard views.
    tolerance : float
        Largest distance between an arc and the chords that replace it, mm.
    analyze_after_recompute : bool
        Whether marked operations are analysed again after each recompute that changed them.
    show_pills : bool
        Whether the tree shows marks as coloured pills instead of plain text.
    warn_of_simulators : bool
        Whether a bar above the 3D view warns of simulations in FreeCAD's simulators that would hang or exceed the time
        limit.
    holder_diameter, holder_length : float
        Diameter and length of the holder, mm, for tools without a holder of their own; 0 if unknown.
    travel_x, travel_y, travel_z : float
        Travel of the machine along its axes, mm; 0 if unknown.
    machine : {"", "hobby-router", "small-mill", "machining-centre", "own"}
        The machine for which machining times are planned. "" means that times are computed with constant feeds. "own"
        means a machine with the user's own values, which are the preferences from `rate_x` to `spindle_start`.
    rate_x, rate_y, rate_z : float
        Largest speeds of the axes, mm/min.
    acceleration_x, acceleration_y, acceleration_z : float
        Accelerations of the axes, mm/s^2.
    corner_deviation : float
        Corner deviation of the machine, mm; see `core.Machine.deviation`.
    lookahead : int
        Number of moves that the controller plans ahead.
    time_factor : float
        Measured time of a job divided by its planned time.
    tool_change, spindle_start : float
        Times of a tool change and of a start of the spindle, s; see `core.Machine`.
    renderer : str
        Name of the renderer that OpenGL reported at the last calibration. The page in the preferences dialog does not
        show this preference.
    result_columns : str
        Columns of the results whose visibility differs from the default, separated by commas. The page in the
        preferences dialog does not show this preference.
    """

    mark_simulator: str = _choice(OWN, _simulators)
    legacy_accuracy: float = _number(0.1, 0.1, 1.0)
    opengl_quality: int = _number(10, 1, 10)
    time_budget: float = _number(600.0, 0.1, 1e6)
    memory_budget: float = _number(1000.0, 1.0, 1e6)
    image_width: int = _number(800, 1, 10_000)
    image_height: int = _number(600, 1, 10_000)
    view_direction: str = _choice("Top", lambda: tuple(DIRECTIONS))
    tolerance: float = _number(0.01, 1e-4, 1.0)
    analyze_after_recompute: bool = False
    show_pills: bool = True
    warn_of_simulators: bool = True
    holder_diameter: float = _number(0.0, 0.0, 1e4)
    holder_length: float = _number(0.0, 0.0, 1e4)
    travel_x: float = _number(0.0, 0.0, 1e6)
    travel_y: float = _number(0.0, 0.0, 1e6)
    travel_z: float = _number(0.0, 0.0, 1e6)
    machine: str = _choice("", lambda: ("", *_machines(), OWN))
    rate_x: float = _number(3000.0, 1.0, 1e6)
    rate_y: float = _number(3000.0, 1.0, 1e6)
    rate_z: float = _number(600.0, 1.0, 1e6)
    acceleration_x: float = _number(250.0, 0.1, 1e6)
    acceleration_y: float = _number(250.0, 0.1, 1e6)
    acceleration_z: float = _number(100.0, 0.1, 1e6)
    corner_deviation: float = _number(0.01, 0.0, 10.0)
    lookahead: int = _number(15, 1, 100_000)
    time_factor: float = _number(1.0, 0.01, 100.0)
    tool_change: float = _number(120.0, 0.0, 3600.0)
    spindle_start: float = _number(3.0, 0.0, 600.0)
    renderer: str = ""
    result_columns: str = ""

    @cached_property
    def simulator(self) -> str:
        """Name of the simulator whose time the marks in the tree show.

        The sentence contains the simulator's name in place of "own".
        """
        if self.mark_simulator != OWN:
            return self.mark_simulator
        from vkworkbench.freecad import own_simulator

        return own_simulator()

    @cached_property
    def simulators(self) -> tuple[str, ...]:
        """Names of the simulators whose costs are shown, in marks in the tree and in columns of the results."""
        columns = [key.split(" ")[0] for key in self.result_columns.split(",")]
        return self.simulator, *(name for name in _simulators() if name in columns and name != self.simulator)

    @property
    def memory_budget_bytes(self) -> float:
        return self.memory_budget * 1e6

    @property
    def budget(self) -> dict[str, float]:
        """Limits of memory, bytes, and time, s, as arguments of ``best_resolution``."""
        return {"memory_bytes": self.memory_budget_bytes, "seconds": self.time_budget}

    @property
    def holder(self) -> dict[str, float]:
        """Known sizes of the tool holder, mm, by the names of the attributes of `Tool`."""
        sizes = {"holder_diameter": self.holder_diameter, "holder_length": self.holder_length}
        return {name: size for name, size in sizes.items() if size} if self.holder_diameter else {}

    @property
    def travel(self) -> tuple[float, float, float]:
        """Travel of the machine along X, Y and Z, mm; 0 if unknown."""
        return self.travel_x, self.travel_y, self.travel_z

    @property
    def planned_machine(self):
        """The `Machine` for which machining times are planned; None for constant feeds."""
        from vkworkbench.core import MACHINES, Machine

        if self.machine == "":
            return None
        if self.machine != OWN:
            return replace(MACHINES[self.machine], factor=self.time_factor)
        rates = self.rate_x / 60, self.rate_y / 60, self.rate_z / 60
        accelerations = self.acceleration_x, self.acceleration_y, self.acceleration_z
        return Machine(rates, accelerations, self.corner_deviation, self.lookahead, self.time_factor,
                       self.tool_change, self.spindle_start)  # fmt: skip

    def with_machine(self, name: str, machine) -> Preferences:
        """Return the preferences with the speeds, accelerations and other values of a machine.

        The time factor of the preferences is kept.
        """
        rates, accelerations = machine.rates, machine.accelerations
        return replace(
            self, machine=name, rate_x=60 * rates[0], rate_y=60 * rates[1], rate_z=60 * rates[2],
            acceleration_x=accelerations[0], acceleration_y=accelerations[1], acceleration_z=accelerations[2],
            corner_deviation=machine.deviation, lookahead=machine.lookahead, tool_change=machine.tool_change,
            spindle_start=machine.spindle_start,
        )  # fmt: skip

    def for_machine(self, given) -> Preferences:
        """Return the preferences with another machine.

        The machine is a `Machine`, the name of a typical machine, or a file with the settings that grbl prints
        (``$$``). Values that are not in the file are the values of the hobby router. None keeps the machine in the
        preferences. A ValueError is raised if a name is neither a typical machine nor a readable file of settings.
        """
        from vkworkbench.core import MACHINES, Machine, machine_of_grbl
        from vkworkbench.given import of_kind

        of_kind("machine", given, (Machine, str, os.PathLike, type(None)), "a Machine, a name or a file of settings")
        if given is None:
            return self
        if isinstance(given, Machine):
            return replace(self.with_machine(OWN, given), time_factor=given.factor)
        if given in MACHINES:
            return replace(self, machine=given)
        try:
            settings = _read_settings(Path(given))
        except (OSError, ValueError):
            names = ", ".join(MACHINES)
            raise ValueError(f"no machine {str(given)!r}: name {names}, or a file with grbl's settings") from None
        return self.with_machine(OWN, machine_of_grbl(settings, MACHINES["hobby-router"]))

    @property
    def view(self):
        """The `View` of the z-buffer."""
        from vkworkbench.core import View

        return View(DIRECTIONS[self.view_direction], self.image_width, self.image_height)


def _read_settings(path: Path) -> str:
    """Return the text of a file with a machine's settings. Pipes, devices and large files raise ValueError."""
    if not path.is_file():
        raise ValueError
    with path.open(encoding="utf-8", errors="replace") as file:
        settings = file.read(_LONGEST_SETTINGS + 1)
    if len(settings) > _LONGEST_SETTINGS:
        raise ValueError
    return settings


def read() -> Preferences:
    """Return the stored preferences. Defaults replace invalid values. Outside FreeCAD, all values are defaults."""
    if "FreeCAD" not in sys.modules:
        return Preferences()
    import FreeCAD

    group = FreeCAD.ParamGet(GROUP)
    getters = {bool: group.GetBool, int: group.GetInt, float: group.GetFloat, str: group.GetString}
    values = {}
    for preference in fields(Preferences):
        value = getters[type(preference.default)](entry(preference.name), preference.default)
        if _possible(value, preference.metadata):
            values[preference.name] = value
    return Preferences(**values)


def write(**values) -> None:
    """Store some preferences, given as arguments with the preferences' names."""
    import FreeCAD

    group = FreeCAD.ParamGet(GROUP)
    setters = {bool: group.SetBool, int: group.SetInt, float: group.SetFloat, str: group.SetString}
    types = {preference.name: type(preference.default) for preference in fields(Preferences)}
    for name, value in values.items():
        setters[types[name]](entry(name), types[name](value))


def observe(changed: Callable[[str], None]) -> None:
    """Register a function that is called with the name of a preference whenever the stored preference changes."""
    import FreeCAD

    names = {entry(preference.name): preference.name for preference in fields(Preferences)}

    class Observer:
        def onChange(self, group, parameter: str | None) -> None:
            for name in [names[parameter]] if parameter in names else [] if parameter else names.values():
                changed(name)

    group, observer = FreeCAD.ParamGet(GROUP), Observer()
    group.Attach(observer)
    _observers.append((group, observer))  # the list keeps the group and the observer alive, because FreeCAD does not


_observers: list = []


def entry(name: str) -> str:
    """Return the name of the parameter that stores a preference."""
    return "".join(word.capitalize() for word in name.split("_"))


def choices(name: str) -> tuple[str, ...]:
    """Return the possible values of a preference, in the order in which the page shows them."""
    return next(preference.metadata["choices"]() for preference in fields(Preferences) if preference.name == name)


def is_possible(name: str, value) -> bool:
    """Return whether a value is valid for a preference."""
    return _possible(value, next(preference.metadata for preference in fields(Preferences) if preference.name == name))


def _possible(value, limits) -> bool:
    if "choices" in limits:
        # The stored name of a simulator that this FreeCAD version lacks is not valid.
        return value in limits["choices"]()
    return not limits or limits["least"] <= value <= limits["most"]
