# SPDX-License-Identifier: LGPL-2.1-or-later
"""The speed of a computer, and of this one: the simulator timed on small made-up toolpaths."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from vkworkbench.core.solids import Stock
from vkworkbench.core.steady import processor_clock, steady_seconds
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer.cost.effort import Work, work_of
from vkworkbench.core.zbuffer.memory.counts import count
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.sharing import shared_seconds
from vkworkbench.core.zbuffer.simulator.simulate import simulate
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts

_STOCK = Stock((0, 0, 0), (60, 60, 20))
_FLAT, _BALL = Tool("endmill", 8), Tool("ballend", 8)
_TOP, _TILTED = (0, 0, -1), (0, 1, -2)
# How often each run is timed at most.
_RUNS = 8
# The true time of nine in ten is within this factor of that of a measured speed, as benchmarks/resources.py time prints, and
# on toolpaths of more kinds benchmarks/learn_effort.py.
_FACTOR = 2.0
# Weight of the usual proportions against one measured time.
_RIDGE = 0.5
# No constant is less than this share of the usual: noisy times would make some nothing.
_LEAST = 0.1


@dataclass(frozen=True)
class Speed:
    """What one unit of the simulator's work costs on one computer, s.

    The defaults are those of a Xeon core; :func:`measure_speed` measures this computer's.

    Attributes
    ----------
    trajectory : float
        One trajectory, whether it meets the stock or not.
    pixel : float
        One pixel of the image.
    meeting : float
        One trajectory looked at for one of the largest tiles.
    block : float
        One block of pairs of one kind that are worked on at once.
    test : float
        One pair of a tile and a trajectory tested.
    cell : float
        One pair of a pixel and a trajectory by which its ray is cut.
    record : float
        One dexel or element of a trace.
    factor : float
        The true time is between the estimated one divided and multiplied by this.
    processes : int
        How many cut at once: all else is what one of them takes.
    """

    trajectory: float = 3.91e-07
    pixel: float = 6.89e-08
    meeting: float = 5.52e-09
    block: float = 0.000414
    test: float = 5.76e-07
    cell: float = 1.49e-06
    record: float = 3.7e-08
    factor: float = 3.0
    processes: int = 1

    @property
    def constants(self) -> np.ndarray:
        """(7,) float64 ndarray : what the units of `Work.amounts` cost, in its order."""
        return np.array([self.trajectory, self.pixel, self.meeting, self.block, self.test, self.cell, self.record])

    def seconds(self, work: Work, growth: float = 1.0) -> float:
        """Return how long work takes, s, in an image of `growth` times as many pixels."""
        alone = float((work.amounts(growth) * self.constants).sum())
        return shared_seconds(alone, max(1, min(self.processes, int(work.bands))))


USUAL = Speed()


def measure_speed(clock: Callable[[], float] = processor_clock, going_on: Callable[[], object] = lambda: None) -> Speed:
    """Time the simulator on lines, arcs and a surface, in about two seconds, until it is steady.

    The images are nearly as large as real ones: in a small one most of the time is what every array operation takes
    to begin.

    Parameters
    ----------
    clock : callable
        Tells the time, s: that of this processor, so that other programs do not make it slower.
    going_on : callable
        Called before each simulation, of less than a tenth of a second; it may raise to end the measurement.

    Returns
    -------
    Speed
        The constants that explain the times best, by least squares of the relative differences.
    """
    runs = (
        (_rows(6), _FLAT, _square(640)),
        (_rows(44), _FLAT, _square(512)),
        (_rows(12), _FLAT, _square(256, _TILTED)),
        (_loops(3), _FLAT, _square(512)),
        (_surface(8), _BALL, _square(384)),
        (_surface(4), _BALL, _square(256, _TILTED)),
    )
    amounts = np.array([_work(*run) for run in runs])
    pieces = [
        partial(simulate, toolpath, tool=tool, stock=_STOCK, view=view, processes=1) for toolpath, tool, view in runs
    ]
    return fit_speed(amounts, steady_seconds(pieces, most=_RUNS, clock=clock, going_on=going_on))


def fit_speed(amounts: np.ndarray, seconds: np.ndarray) -> Speed:
    """Find the constants that explain measured times, as near to the usual proportions as these allow.

    Least squares of the relative differences, with a ridge towards the default constants times one factor
    (Hoerl and Kennard 1970): few noisy times do not tell all constants apart.

    Parameters
    ----------
    amounts : (k, 7) ndarray
        The work of each simulation, see `Work.amounts`.
    seconds : (k,) ndarray
        What they took.
    """
    default = USUAL.constants
    factor = float(np.median(seconds / (amounts @ default)))
    usual = factor * default
    rows = np.vstack((amounts * usual / seconds[:, None], _RIDGE * np.eye(len(usual))))
    right = np.concatenate((np.ones(len(seconds)), np.full(len(usual), _RIDGE)))
    shares = np.linalg.lstsq(rows, right, rcond=None)[0]
    trajectory, pixel, meeting, block, test, cell, record = (usual * np.maximum(shares, _LEAST)).tolist()
    return Speed(trajectory, pixel, meeting, block, test, cell, record, factor=_FACTOR)


def _work(toolpath: Toolpath, tool: Tool, view: View) -> np.ndarray:
    """The work of one simulation; see `Work.amounts`."""
    removal = Removal(Cuts([Cut(toolpath, tool)]), _STOCK, view.frame(_STOCK))
    return work_of(removal, len(toolpath), count(removal)).amounts()


def _square(side: int, direction: tuple[float, float, float] = _TOP) -> View:
    return View(direction, side, side)


def _rows(count: int) -> Toolpath:
    """Straight rows to and fro at one height, an even number of them."""
    x, y = np.tile([8.0, 52.0, 52.0, 8.0], count // 2), np.repeat(np.linspace(8, 52, count), 2)
    return Toolpath.through(np.column_stack((x, y, np.full(len(x), 15.0))))


def _loops(count: int) -> Toolpath:
    """Circles from the outside inwards, of chords of 5 degrees."""
    angles = np.linspace(0, 2 * np.pi, 73)
    radius, angle = np.repeat(np.linspace(22, 6, count), len(angles)), np.tile(angles, count)
    return Toolpath.through(
        np.column_stack((30 + radius * np.cos(angle), 30 + radius * np.sin(angle), np.full(len(angle), 12.0)))
    )


def _surface(count: int) -> Toolpath:
    """Rows to and fro over waves, an even number of them."""
    row = np.linspace(0, 60, 31)
    x, y = np.tile(np.concatenate((row, row[::-1])), count // 2), np.repeat(np.linspace(0, 60, count), len(row))
    return Toolpath.through(np.column_stack((x, y, 13 + 3 * np.sin(x / 9) * np.cos(y / 11))))
