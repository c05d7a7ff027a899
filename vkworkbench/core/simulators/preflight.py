# SPDX-License-Identifier: LGPL-2.1-or-later
"""What to know before a simulation is started, found in O(n)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.gcode import Words
from vkworkbench.core.simulators.constants import Simulator, available_simulators
from vkworkbench.core.simulators.legacy import LegacyCost
from vkworkbench.core.simulators.motions import motions
from vkworkbench.core.simulators.opengl import OpenGLCost
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer import Estimate
from vkworkbench.language import Message, render

LONGEST_PLAY = 600.0  # s
SLOWEST_FRAME = 0.1  # s, ten pictures per second
MOST_SHORT_MOVES = 2000
RAMP_ERROR = 0.1  # mm

_CLOCKWISE, _COUNTERCLOCKWISE = 20, 30


@dataclass(frozen=True)
class Caution:
    """Something to know before a simulation is started.

    Attributes
    ----------
    code : str
        What it is, for programs: ``"legacy-hangs"``, ``"legacy-ramp"``, ``"long-play"``, ``"memory"``,
        ``"arcs"`` or ``"short-moves"``.
    what : Message
        What happens and what to do.
    command : int or None
        Index of the first command concerned; None where it is the operation as a whole.
    """

    code: str
    what: Message
    command: int | None = None

    @property
    def message(self) -> str:
        """What happens and what to do in English, one or two sentences with full stops."""
        return render(self.what)

    def __str__(self) -> str:
        return self.message


def preflight(
    commands: Iterable,
    toolpath: Toolpath,
    *,
    version: tuple[int, ...],
    diameter: float | None = None,
    zbuffer: Estimate | None = None,
    legacy: LegacyCost | None = None,
    opengl: OpenGLCost | None = None,
    memory_budget: float = 1e9,
    time_budget: float = LONGEST_PLAY,
) -> tuple[Caution, ...]:
    """Find what goes wrong or takes too much in the simulators.

    Parameters
    ----------
    commands : iterable
        ``(name, parameters)`` pairs or objects with ``.Name`` and ``.Parameters``.
    toolpath : Toolpath
        Those commands, linearised.
    version : tuple of int
        Of FreeCAD, at least major and minor.
    diameter : float, optional
        Of the tool, mm; without it ramps are not checked.
    zbuffer, legacy, opengl : Estimate, LegacyCost, OpenGLCost, optional
        Estimates for this operation; without them time and memory are not checked.
    memory_budget : float
        Bytes one operation may take.
    time_budget : float
        s playing it may take.

    Returns
    -------
    tuple of Caution
        The worst first; empty when there is nothing to say.
    """
    cautions = _hangs(Words(commands), toolpath, version)
    if diameter is not None:
        cautions += _ramps(toolpath, diameter)
    if legacy is not None:
        cautions += _long_legacy(legacy, time_budget) + _short_moves(toolpath, legacy.resolution)
    if opengl is not None and Simulator.OPENGL in available_simulators(version):
        cautions += _long_opengl(opengl, time_budget)
    cautions += _memory(zbuffer, legacy, opengl, memory_budget)
    return tuple(cautions)


def _hangs(words: Words, toolpath: Toolpath, version: tuple[int, ...]) -> list[Caution]:
    """Arcs on which ``PerformCutVoxel`` raises an error, after which the legacy simulator never goes on.

    It computes with the words X, Y and, before FreeCAD 1.1, Z of an arc even where they are absent, and
    divides by a number of chords that is 0 where radius or sweep is 0: of full circles, and where start and end lie
    in one direction from the centre, as in FreeCAD's Deburr. Arcs with a K word take another way.
    """
    arcs = np.flatnonzero((words.codes == _CLOCKWISE) | (words.codes == _COUNTERCLOCKWISE))
    if not len(arcs):
        return []
    values = {letter: words.column(letter, arcs)[0] for letter in "XYZIJK"}
    i, j = (np.nan_to_num(values[letter]) for letter in "IJ")
    x, y = (_last_word(words, letter, arcs) for letter in "XY")
    swept = np.arctan2(values["Y"] - y - j, values["X"] - x - i) - np.arctan2(-j, -i)
    still = np.abs(np.remainder(swept + np.pi, 2 * np.pi) - np.pi) < 1e-9
    plain = ~(np.abs(values["K"]) > 0)
    absent = {letter: np.isnan(values[letter]) for letter in "XYZ"}
    made = motions(toolpath)
    circle = np.isin(arcs, made.command[np.abs(made.sweep) > 2 * np.pi - 1e-6])
    reasons = [
        (absent["X"] | absent["Y"], Message("arc-without-xy")),
        (absent["Z"] & (tuple(version[:2]) < (1, 1)), Message("arc-without-z")),
        ((i == 0) & (j == 0), Message("arc-without-centre")),
        (circle & ~absent["X"] & ~absent["Y"], Message("arc-full-circle")),
        (still & ~circle & ((i != 0) | (j != 0)), Message("arc-without-sweep")),
    ]
    has_opengl = Simulator.OPENGL in available_simulators(version)
    instead = Message("use-opengl") if has_opengl else Message("leave-out")
    found = []
    for bad, reason in reasons:
        concerned = arcs[bad & plain]
        if not len(concerned):
            continue
        first, others = int(concerned[0]), len(concerned) - 1
        what = Message(
            "legacy-hangs", reason=reason, command=first, instead=instead,
            others=Message("and-more", count=others) if others else None,
        )  # fmt: skip
        found.append(Caution("legacy-hangs", what, first))
    return found


def _last_word(words: Words, letter: str, rows: np.ndarray) -> np.ndarray:
    """The last value of a parameter before each of the commands `rows`; NaN before the first."""
    values = words.column(letter)[0]
    last = np.maximum.accumulate(np.where(np.isnan(values), -1, np.arange(len(values))))
    last = np.where(rows > 0, last[rows - 1], -1)
    return np.where(last < 0, np.nan, values[last])


def _ramps(toolpath: Toolpath, diameter: float) -> list[Caution]:
    """Sloping lines longer than the tool is wide.

    ``ApplyLinearTool`` divides the rise by the steps across the tool and adds it at every step along the
    move, so the far end is cut at ``length / diameter`` times the rise.
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
        "legacy-ramp", count=len(wrong), error=error[worst], command=toolpath.command[worst],
        way=Message("too-deep") if moves[worst, 2] < 0 else Message("too-high"),
    )  # fmt: skip
    return [Caution("legacy-ramp", what, int(toolpath.command[wrong[0]]))]


def _long_legacy(cost: LegacyCost, budget: float) -> list[Caution]:
    if cost.play_seconds <= budget:
        return []
    what = Message("legacy-long-play", longer=cost.play_seconds, time=cost.fast_forward_seconds)
    return [Caution("long-play", what)]


def _short_moves(toolpath: Toolpath, resolution: float) -> list[Caution]:
    moves = np.diff(toolpath.points, axis=0)
    short = np.flatnonzero((toolpath.sweep == 0) & ~toolpath.rapid & ((moves**2).sum(axis=1) < resolution**2))
    if len(short) <= MOST_SHORT_MOVES:
        return []
    what = Message("legacy-short-moves", count=len(short), cell=resolution)
    return [Caution("short-moves", what, int(toolpath.command[short[0]]))]


def _long_opengl(cost: OpenGLCost, budget: float) -> list[Caution]:
    found = []
    if cost.fastest_seconds > budget:
        found.append(Caution("long-play", Message("opengl-long-play", time=cost.fastest_seconds)))
    if cost.frame_seconds > SLOWEST_FRAME and 2 * cost.arc_draws > cost.draws:
        percent = round(100 * cost.arc_draws / cost.draws)
        found.append(Caution("arcs", Message("opengl-arcs", time=cost.frame_seconds, percent=percent)))
    return found


def _memory(
    zbuffer: Estimate | None, legacy: LegacyCost | None, opengl: OpenGLCost | None, budget: float
) -> list[Caution]:
    found = []
    for name, cost, instead in (
        ("z-buffer", zbuffer, Message("smaller-image")),
        ("legacy", legacy, Message("coarser-accuracy")),
        ("OpenGL", opengl, Message("fewer-operations")),
    ):
        if cost is not None and cost.memory_bytes > budget:
            what = Message("memory", simulator=name, memory=cost.memory_bytes, allowed=budget, instead=instead)
            found.append(Caution("memory", what))
    return found
