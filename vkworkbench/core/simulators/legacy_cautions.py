# SPDX-License-Identifier: LGPL-2.1-or-later
"""Warn of errors and long times in FreeCAD's legacy simulator. The checks take a time of O(n) for n trajectories."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.gcode import ARCS, Words
from vkworkbench.core.simulators import opengl
from vkworkbench.core.simulators.legacy import NAME, LegacyCost
from vkworkbench.core.simulators.simulator import Caution, Conditions, Task
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message

# MOST_SHORT_MOVES: number of moves shorter than a cell of the simulator above which a warning appears. RAMP_ERROR:
# error of a ramp's depth, mm, above which a warning appears. With lower limits for moves and ramps, harmless toolpaths
# get warnings. With higher limits for moves and ramps, visible errors of the simulator get no warning.
MOST_SHORT_MOVES = 2000
RAMP_ERROR = 0.1


def cautions(task: Task, cost: LegacyCost | None, conditions: Conditions) -> list[Caution]:
    """Return warnings.

    Arcs are checked only if `task.words` (the words of the G-code commands) is not None, ramps only if `task.tool` is
    not None, and times and short moves only if `cost` is not None.
    """
    found = _hangs(task, conditions.version)
    if task.tool is not None:
        found += _ramps(task.toolpath, task.tool.diameter)
    if cost is not None:
        found += _long(cost, conditions.time_budget) + _short_moves(task.toolpath, cost.resolution)
    return found


def _hangs(task: Task, version: tuple[int, ...]) -> list[Caution]:
    """Find arcs on which FreeCAD's ``PerformCutVoxel`` raises an error, so that the legacy simulator never ends.

    ``PerformCutVoxel`` uses the words X and Y of an arc, and before FreeCAD 1.1 also Z, even if these words are absent.
    ``PerformCutVoxel`` also divides by the number of chords of the arc, which is 0 if the computed radius or sweep is
    0. The sweep is 0 for full circles, and for arcs whose start and end lie in the same direction from the centre, as
    in FreeCAD's Deburr operation. Arcs with a K word are cut by other code, which does not have these errors.
    """
    words = task.words
    if words is None:
        return []
    arcs = np.flatnonzero(np.isin(words.codes, ARCS))
    if not len(arcs):
        return []
    values = {letter: words.column(letter, arcs)[0] for letter in "XYZIJK"}
    i, j = (np.nan_to_num(values[letter]) for letter in "IJ")
    x, y = (_last_word(words, letter, arcs) for letter in "XY")
    swept = np.arctan2(values["Y"] - y - j, values["X"] - x - i) - np.arctan2(-j, -i)
    still = np.isclose(np.sin(swept / 2), 0)
    plain = ~(np.abs(values["K"]) > 0)
    absent = {letter: np.isnan(values[letter]) for letter in "XYZ"}
    made = task.motions
    circle = np.isin(arcs, made.command[np.abs(made.sweep) > 2 * np.pi - 1e-6])
    reasons = [
        (absent["X"] | absent["Y"], Message("arc-without-xy")),
        (absent["Z"] & (tuple(version[:2]) < (1, 1)), Message("arc-without-z")),
        ((i == 0) & (j == 0), Message("arc-without-centre")),
        (circle & ~absent["X"] & ~absent["Y"], Message("arc-full-circle")),
        (still & ~circle & ((i != 0) | (j != 0)), Message("arc-without-sweep")),
    ]
    instead = Message("use-opengl", simulator=opengl.NAME) if version >= opengl.SINCE else Message("leave-out")
    found = []
    for bad, reason in reasons:
        concerned = arcs[bad & plain]
        if not len(concerned):
            continue
        first, others = int(concerned[0]), len(concerned) - 1
        what = Message(
            "legacy-hangs", simulator=NAME, reason=reason, command=first + 1, instead=instead,
            others=Message("and-more", count=others) if others else None,
        )  # fmt: skip
        found.append(Caution("legacy-hangs", what, first))
    return found


def _last_word(words: Words, letter: str, rows: np.ndarray) -> np.ndarray:
    """Return the last value of the word `letter` before each of the commands `rows`; NaN if there is none."""
    values = words.column(letter)[0]
    known = np.flatnonzero(~np.isnan(values))
    return np.append(np.nan, values[known])[np.searchsorted(known, rows)]


def _ramps(toolpath: Toolpath, diameter: float) -> list[Caution]:
    """Find sloping straight moves longer than the tool's diameter, which the legacy simulator cuts at a wrong depth.

    ``ApplyLinearTool`` divides the height difference of the move by the number of steps across the tool, but adds the
    quotient at every step along the move. So the height difference at the end of the move is too large by the factor
    ``length / diameter``.
    """
    moves = np.diff(toolpath.points, axis=0)
    level = np.hypot(moves[:, 0], moves[:, 1])
    lines = (toolpath.sweep == 0) & ~(toolpath.rapid & (moves[:, 2] > 0))
    error = np.where(lines, np.abs(moves[:, 2]) * (level / diameter - 1), 0.0)
    wrong = np.flatnonzero(error > RAMP_ERROR)
    if not len(wrong):
        return []
    worst = wrong[np.argmax(error[wrong])]
    what = Message(
        "legacy-ramp", simulator=NAME, count=len(wrong), error=error[worst], command=toolpath.command[worst] + 1,
        way=Message("too-deep") if moves[worst, 2] < 0 else Message("too-high"),
    )  # fmt: skip
    return [Caution("legacy-ramp", what, int(toolpath.command[wrong[0]]))]


def _long(cost: LegacyCost, budget: float) -> list[Caution]:
    if cost.play_seconds <= budget:
        return []
    what = Message("legacy-long-play", simulator=NAME, longer=cost.play_seconds, time=cost.fast_forward_seconds)
    return [Caution("long-play", what)]


def _short_moves(toolpath: Toolpath, resolution: float) -> list[Caution]:
    moves = np.diff(toolpath.points, axis=0)
    short = np.flatnonzero((toolpath.sweep == 0) & ~toolpath.rapid & ((moves**2).sum(axis=1) < resolution**2))
    if len(short) <= MOST_SHORT_MOVES:
        return []
    what = Message("legacy-short-moves", simulator=NAME, count=len(short), cell=resolution)
    return [Caution("short-moves", what, int(toolpath.command[short[0]]))]
