# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute machining times with acceleration: the tool's speed along a toolpath, as a machine's controller plans it.

A controller moves the tool as fast as the feed rate, the axes and the corners allow, and brakes before each corner. Two
cumulative minima give the squared speed at all corners at once: the minimum from the last corner backwards limits
braking, and the minimum from the first corner forwards limits acceleration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType

import numpy as np

from vkworkbench.core.toolpath import PLANE_AXES, SLOWEST, Toolpath, check_toolpath, exact_lengths
from vkworkbench.given import number, numbers, of_kind, whole

# Limit for the sine of half the angle at the corner between two moves, which is 1 if both moves have the same
# direction. Above this limit of the sine, the directions differ only by rounding, and the corner does not limit the
# speed.
_STRAIGHT = 1 - 1e-12


# Smallest and largest speed, acceleration and factor of a machine, and largest other value. With values beyond these
# limits, times could be infinite.
_LEAST, _MOST, _MOST_OTHER = SLOWEST, 1e9, 1e6


def _is_speed(value: float | np.ndarray) -> bool:
    return bool(np.all((value >= _LEAST) & (value <= _MOST)))


def _are_three_speeds(values: np.ndarray) -> bool:
    return values.shape == (3,) and _is_speed(values)


@dataclass(frozen=True)
class Machine:
    """Speeds and accelerations of a machine.

    Parameters
    ----------
    rates : (3,) tuple of float
        Largest speeds of the X, Y and Z axes, mm/s. Rapids move at the axes' largest speeds.
    accelerations : (3,) tuple of float
        Accelerations of the axes, mm/s^2.
    deviation : float
        Largest distance between a programmed corner and the rounded path of the tool, mm. In grbl, this is the junction
        deviation; in LinuxCNC, the path tolerance (G64 P). If the value is 0, the tool stops at each corner.
    lookahead : int
        Number of moves that the controller plans ahead. The tool must be able to stop within the planned moves, so a
        controller that plans few moves ahead is slow in NC programs with tiny moves.
    factor : float
        Measured time of a job divided by its planned time. All computed times are multiplied by `factor`.
    tool_change : float
        Time to change the tool between two operations, s, without `spindle_start`.
    spindle_start : float
        Time that the spindle needs to reach its speed, s.

    Raises
    ------
    ValueError
        If a speed, an acceleration or the factor is not between 1e-6 and 1e9, `deviation`, `tool_change` or
        `spindle_start` is not between 0 and 1e6, or `lookahead` is less than 1.
    TypeError
        If a value is not a number, or `lookahead` is not an integer.
    """

    rates: tuple[float, float, float]
    accelerations: tuple[float, float, float]
    deviation: float
    lookahead: int = 1000
    factor: float = 1.0
    tool_change: float = 0.0
    spindle_start: float = 0.0

    def __post_init__(self) -> None:
        for name in ("rates", "accelerations"):
            takes = f"three numbers from {_LEAST:g} to {_MOST:g}, for X, Y and Z"
            given = numbers(name, getattr(self, name), takes, _are_three_speeds)
            object.__setattr__(self, name, tuple(given.tolist()))
        takes = f"a number from {_LEAST:g} to {_MOST:g}"
        object.__setattr__(self, "factor", number("factor", self.factor, takes, _is_speed))
        takes = f"a number from 0 to {_MOST_OTHER:g}"
        for name in ("deviation", "tool_change", "spindle_start"):
            value = number(name, getattr(self, name), takes, lambda value: 0 <= value <= _MOST_OTHER)
            object.__setattr__(self, name, value)
        takes = f"a whole number of moves, from 1 to {_MOST:g}"
        moves = whole("lookahead", self.lookahead, takes, lambda moves: 1 <= moves <= _MOST)
        object.__setattr__(self, "lookahead", moves)

    def seconds(self, toolpath: Toolpath) -> np.ndarray:
        """Return the time of every trajectory, from standstill to standstill.

        Parameters
        ----------
        toolpath : Toolpath
            n trajectories, feeds in mm/s.

        Returns
        -------
        (n,) float64
            s; NaN for cutting moves without a feed.

        Raises
        ------
        TypeError
            If `toolpath` is not a Toolpath.
        """
        check_toolpath(toolpath)
        if not len(toolpath):
            return np.zeros(0)
        lengths, (begin, end) = exact_lengths(toolpath), _tangents(toolpath)
        along = np.abs(np.diff(toolpath.points, axis=0)) / toolpath.lengths[:, None]
        speed = self._speeds(toolpath, along, lengths)
        gain = 2 * _least_over(self.accelerations, along) * lengths  # change of speed^2 at full acceleration
        reached = np.concatenate(([0.0], np.cumsum(gain)))
        planned = reached[np.minimum(np.arange(len(reached)) + self.lookahead, len(gain))]
        squared = np.minimum(self._corners(begin, end, speed), planned - reached)
        squared = np.minimum.accumulate((squared + reached)[::-1])[::-1] - reached
        squared = np.minimum.accumulate(squared - reached) + reached
        return _trapezoids(np.maximum(squared, 0.0), speed, gain, lengths) * self.factor

    def _speeds(self, toolpath: Toolpath, along: np.ndarray, lengths: np.ndarray) -> np.ndarray:
        """Return the largest speed in each move, (n,) mm/s; NaN for a cutting move without a feed."""
        limit = _least_over(self.rates, along)
        feed = np.where(toolpath.feed > 0, toolpath.feed, np.nan)
        speed = np.where(toolpath.rapid, limit, np.minimum(feed, limit))
        arc = np.flatnonzero(toolpath.sweep)
        acceleration = np.array([min(self.accelerations[axis] for axis in PLANE_AXES[plane][:2])
                                 for plane in (17, 18, 19)])[toolpath.plane[arc] - 17]  # fmt: skip
        # The centripetal acceleration limits the speed, because the tool's direction turns by the sweep.
        centripetal = np.sqrt(acceleration * lengths[arc] / np.abs(toolpath.sweep[arc]))
        speed[arc] = np.minimum(speed[arc], centripetal)
        return speed

    def _corners(self, begin: np.ndarray, end: np.ndarray, speed: np.ndarray) -> np.ndarray:
        """Return the largest squared speed at each of n + 1 points; 0 at both ends and at moves with unknown speed."""
        turn = begin[1:] - end[:-1]
        sine = np.sqrt(np.clip((1 + (begin[1:] * end[:-1]).sum(axis=1)) / 2, 0, 1))
        change = np.sqrt((turn**2).sum(axis=1))
        with np.errstate(divide="ignore", invalid="ignore"):
            acceleration = _least_over(self.accelerations, np.abs(turn) / change[:, None])
            # The largest circle that rounds a corner within the deviation has the radius deviation * sine / (1 - sine).
            squared = np.where(sine < _STRAIGHT, acceleration * self.deviation * sine / (1 - sine), np.inf)
        squared = np.minimum(squared, np.minimum(speed[1:], speed[:-1]) ** 2)
        return np.concatenate(([0.0], np.nan_to_num(squared), [0.0]))


# Typical machines: a hobby router with belts or screws and grbl, a small milling machine, and a machining centre.
MACHINES: Mapping[str, Machine] = MappingProxyType({
    "hobby-router": Machine((50.0, 50.0, 10.0), (250.0, 250.0, 100.0), 0.01, 15, tool_change=120.0, spindle_start=3.0),
    "small-mill": Machine((50.0, 50.0, 40.0), (500.0, 500.0, 400.0), 0.02, tool_change=60.0, spindle_start=3.0),
    "machining-centre": Machine((500.0, 500.0, 400.0), (4000.0, 4000.0, 4000.0), 0.02, tool_change=6.0, spindle_start=3.0),
})  # fmt: skip

# Numbers of grbl's settings, by the fields of `Machine` that they set. Rates are in mm/min in grbl.
_GRBL = {"rates": (110, 111, 112), "accelerations": (120, 121, 122)}
_GRBL_DEVIATION = 11


def machine_of_grbl(settings: str, otherwise: Machine) -> Machine:
    """Return the machine that is described by grbl's settings, as grbl's command ``$$`` prints them.

    Parameters
    ----------
    settings : str
        Lines such as ``$110=3000.000``. Lines in another form are skipped.
    otherwise : Machine
        Machine whose values are used for settings that are not in `settings`.

    Raises
    ------
    ValueError
        If no line is a known setting, or if a setting has an impossible value.
    TypeError
        If `settings` is not a text, or `otherwise` is not a Machine.
    """
    of_kind("settings", settings, str, "the text that grbl prints")
    of_kind("otherwise", otherwise, Machine, "a Machine")
    found = {}
    for line in settings.splitlines():
        name, _, value = line.strip().partition("=")
        if name[:1] == "$" and name[1:].isdigit() and value:
            found[int(name[1:])] = number(name, value.split()[0].split("(")[0], "a number")
    if not {_GRBL_DEVIATION, *_GRBL["rates"], *_GRBL["accelerations"]} & found.keys():
        raise ValueError("there is no line such as $110=3000: paste what grbl answers to $$")
    given = {field.name: getattr(otherwise, field.name) for field in fields(Machine)}
    for name, scale in (("rates", 60.0), ("accelerations", 1.0)):
        given[name] = tuple(found.get(key, scale * kept) / scale for key, kept in zip(_GRBL[name], given[name]))
    given["deviation"] = found.get(_GRBL_DEVIATION, otherwise.deviation)
    return Machine(**given)


def _least_over(limits: tuple[float, float, float], along: np.ndarray) -> np.ndarray:
    """Return the length of the longest vector in each direction `along` (n, 3) with components within the limits."""
    with np.errstate(divide="ignore"):
        result: np.ndarray = (np.array(limits) / along).min(axis=1)
    return result


def _tangents(toolpath: Toolpath) -> tuple[np.ndarray, np.ndarray]:
    """Return the directions of motion at the start and at the end of each trajectory, (n, 3) unit vectors.

    In the plane of an arc, a chord differs from the tangents at its ends by half of the sweep.
    """
    moves = np.diff(toolpath.points, axis=0)
    begin, end = moves.copy(), moves.copy()
    for plane, (first, second, _) in PLANE_AXES.items():
        arc = np.flatnonzero((toolpath.sweep != 0) & (toolpath.plane == plane))
        half = toolpath.sweep[arc] / 2
        across, up = moves[arc, first], moves[arc, second]
        # A helix rises along the arc, so the arc's length replaces the chord's length in the plane.
        stretch = half / np.sin(half)
        for tangents, angle in ((begin, -half), (end, half)):
            tangents[arc, first] = stretch * (np.cos(angle) * across - np.sin(angle) * up)
            tangents[arc, second] = stretch * (np.sin(angle) * across + np.cos(angle) * up)
    for tangents in (begin, end):
        tangents /= np.sqrt((tangents**2).sum(axis=1))[:, None]
    return begin, end


def _trapezoids(squared: np.ndarray, speed: np.ndarray, gain: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    """Return the time of each move, (n,) s. In each move, the tool accelerates, keeps its speed, and brakes.

    `squared` (n + 1,) are the squared speeds at the ends of the moves, mm^2/s^2. `speed`, `gain` and `lengths` (n,) are
    the largest speed, the change of the squared speed at full acceleration, and the length of each move.
    """
    enter, leave = squared[:-1], squared[1:]
    top = np.minimum(speed**2, (enter + leave + gain) / 2)
    peak, acceleration = np.sqrt(top), gain / (2 * lengths)
    changing = (2 * peak - np.sqrt(enter) - np.sqrt(leave)) / acceleration
    steady = np.maximum(lengths - (2 * top - enter - leave) / (2 * acceleration), 0.0)
    return changing + steady / peak
