# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the lengths, depth and machining time of one operation.

FreeCAD's ``Path.Length`` and ``CycleTime`` read the centre of an arc as an absolute position and are wrong for every
arc, so this module does not use them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.machine import Machine
from vkworkbench.core.toolpath import SLOWEST, Toolpath, check_toolpath, exact_lengths
from vkworkbench.given import not_negative, number, of_kind
from vkworkbench.language import Message, render


@dataclass(frozen=True)
class Machining:
    """Lengths, depth and time of machining one operation.

    Attributes
    ----------
    cutting_length, rapid_length : float
        Exact lengths of the tool tip's path at feed and in rapids, mm.
    lowest : float or None
        Lowest height of the tool tip at feed, mm; None if nothing cuts.
    depth : float or None
        Distance of `lowest` below the top of the stock, mm, at least 0; None if one of the two heights is unknown.
    cutting_seconds, rapid_seconds : float or None
        Time of the moves whose speed is known, s; None if no speed is known. Without a machine, the tool is assumed to
        move at constant speed.
    left_out : tuple of Message
        Reasons why the times are incomplete; empty if they are complete.
    shortest, median : float or None
        Shortest and median path length of one command at feed, mm; None if nothing cuts. Tiny lengths show that an NC
        program is divided into too many lines.
    dwell_seconds : float
        Time of the dwells, s.
    """

    cutting_length: float
    rapid_length: float
    lowest: float | None
    depth: float | None
    cutting_seconds: float | None
    rapid_seconds: float | None
    left_out: tuple[Message, ...]
    shortest: float | None = None
    median: float | None = None
    dwell_seconds: float = 0.0

    @property
    def complete(self) -> bool:
        """Whether `seconds` includes all moves; otherwise, `seconds` is a lower bound."""
        return not self.left_out

    @property
    def notes(self) -> tuple[str, ...]:
        """Reasons in English why the times are incomplete; each is a sentence without a full stop."""
        return tuple(map(render, self.left_out))

    @property
    def seconds(self) -> float | None:
        """Time of cuts, rapids and dwells, s, without tool changes; None if the cutting time is unknown."""
        if self.cutting_seconds is None:
            return None
        return self.cutting_seconds + (self.rapid_seconds or 0.0) + self.dwell_seconds


def trajectory_seconds(
    toolpath: Toolpath, *, horizontal_rapid: float = 0.0, vertical_rapid: float = 0.0, machine: Machine | None = None
) -> np.ndarray:
    """Return the time of every trajectory, (n,) float64 s; NaN if its speed is unknown.

    Parameters
    ----------
    horizontal_rapid, vertical_rapid : float
        As for :func:`machining`.
    machine : Machine, optional
        As for :func:`machining`.

    Raises
    ------
    ValueError, TypeError
        As for :func:`machining`.
    """
    check_toolpath(toolpath)
    of_kind("machine", machine, (Machine, type(None)), "a Machine or None")
    takes = "a rapid speed in mm/s, a number of at least 0"
    horizontal_rapid = number("horizontal_rapid", horizontal_rapid, takes, not_negative)
    vertical_rapid = number("vertical_rapid", vertical_rapid, takes, not_negative)
    if machine is not None:
        return machine.seconds(toolpath)
    rapid = np.where(_upright(toolpath), vertical_rapid, horizontal_rapid)
    speed = np.where(toolpath.rapid, rapid, toolpath.feed)
    return exact_lengths(toolpath) / np.where(speed >= SLOWEST, speed, np.nan)


def seconds_of_dwells(toolpath: Toolpath, *, machine: Machine | None = None) -> np.ndarray:
    """Return the time of the dwells before each trajectory, (n,) float64 s.

    A dwell in a drilling cycle follows the hole. A dwell at the end of the toolpath is added to the dwells of the last
    trajectory.

    Raises
    ------
    TypeError
        As for :func:`machining`.
    """
    check_toolpath(toolpath)
    of_kind("machine", machine, (Machine, type(None)), "a Machine or None")
    if not len(toolpath):
        return np.zeros(0)
    dwelling, seconds = toolpath.dwells.T
    behind = np.searchsorted(toolpath.command, dwelling, "right")
    in_cycle = toolpath.command[np.maximum(behind, 1) - 1] == dwelling
    at = np.clip(behind - in_cycle, 0, len(toolpath) - 1)
    result: np.ndarray = np.bincount(at, weights=seconds, minlength=len(toolpath))
    return result * (machine.factor if machine else 1.0)


def _timed(moves: np.ndarray, lengths: np.ndarray, seconds: np.ndarray) -> tuple[float, float | None, float, int]:
    """Measure the moves selected by `moves`, (n,) bool. Unknown times in `seconds` are NaN.

    The result consists of the length of the selected moves, mm; the time of the moves whose speed is known, s, None if
    all speeds are unknown; and the length, mm, and the number of the moves whose speed is unknown.
    """
    timed = moves & ~np.isnan(seconds)
    length, missing = float(lengths[moves].sum()), int((moves & ~timed).sum())
    known = None if missing and not timed.any() else float(seconds[timed].sum())
    return length, known, length - float(lengths[timed].sum()), missing


def _rapids_untimed(length: float, names: list[str], controller: bool) -> Message:
    """Return the message that says why rapids have no time; `names` are the rapid speeds that are not set."""
    if not controller:
        return Message("rapids-without-controller", length=length)
    if len(names) == 1:
        return Message("rapids-untimed", length=length, name=names[0])
    return Message("all-rapids-untimed", length=length, name=names[0], other=names[1])


def _upright(toolpath: Toolpath) -> np.ndarray:
    """Return whether each trajectory is vertical, (n,) bool."""
    points = toolpath.points
    return (np.abs(points[1:, 0] - points[:-1, 0]) < 1e-6) & (np.abs(points[1:, 1] - points[:-1, 1]) < 1e-6)


def machining(
    toolpath: Toolpath,
    *,
    horizontal_rapid: float = 0.0,
    vertical_rapid: float = 0.0,
    controller: bool = True,
    top: float | None = None,
    machine: Machine | None = None,
) -> Machining:
    """Return lengths, depth and time of one operation.

    Parameters
    ----------
    toolpath : Toolpath
        The trajectories, feeds in mm/s.
    horizontal_rapid, vertical_rapid : float
        The tool controller's HorizRapid and VertRapid, mm/s; 0 (FreeCAD's default) if unknown. Speeds below `SLOWEST`
        are unknown, too. The vertical speed applies to vertical rapids, the horizontal speed to all other rapids.
    controller : bool
        Whether the operation has a tool controller, where the user can set the speeds.
    top : float, optional
        Height of the stock's top, mm.
    machine : Machine, optional
        Machine whose accelerations and speeds are used for the times, instead of the rapid speeds above. If None, the
        tool moves at constant feed and rapid speeds.

    Raises
    ------
    ValueError
        For a negative or non-finite rapid speed.
    TypeError
        If `toolpath` is not a Toolpath, `machine` is not a Machine, or a speed or `top` is not a number.
    """
    seconds = trajectory_seconds(
        toolpath, horizontal_rapid=horizontal_rapid, vertical_rapid=vertical_rapid, machine=machine
    )
    top = None if top is None else number("top", top, "a number of mm")
    lengths = exact_lengths(toolpath)
    rapid = toolpath.rapid
    left_out = []
    cutting_length, cutting_seconds, untimed, missing = _timed(~rapid, lengths, seconds)
    if missing:
        left_out.append(Message("cutting-untimed", length=untimed, count=missing))
    rapid_length, rapid_seconds, untimed, missing = _timed(rapid, lengths, seconds)
    if missing:
        upright = _upright(toolpath)
        speeds = ("HorizRapid", horizontal_rapid, ~upright), ("VertRapid", vertical_rapid, upright)
        names = [name for name, given, kind in speeds if given < SLOWEST and (rapid & kind).any()]
        left_out.append(_rapids_untimed(untimed, names, controller))
    left_out += [problem.remark for problem in toolpath.problems if problem.takes_time]
    lowest = depth = shortest = median = None
    if (~rapid).any():
        begin = np.flatnonzero(np.diff(toolpath.command[~rapid], prepend=-1))
        ways = np.add.reduceat(lengths[~rapid], begin)
        shortest, median = float(ways.min()), float(np.median(ways))
        heights = toolpath.points[:, 2]
        lowest = float(np.minimum(heights[:-1], heights[1:])[~rapid].min())
        if top is not None:
            depth = max(0.0, top - lowest)
    dwell_seconds = float(toolpath.dwells[:, 1].sum()) * (machine.factor if machine else 1.0)
    return Machining(cutting_length, rapid_length, lowest, depth, cutting_seconds, rapid_seconds, tuple(left_out),
                     shortest, median, dwell_seconds)  # fmt: skip
