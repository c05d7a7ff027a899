# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the speed of a computer by timing the simulator on small synthetic toolpaths."""

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
# Largest number of times that each synthetic simulation is timed.
_RUNS = 8
# Uncertainty of a time that is estimated with a measured speed: 90 % of the actual times are between the estimate
# divided by this factor and the estimate times this factor. benchmarks/resources.py prints the share of the actual
# times between these limits; benchmarks/learn_effort.py prints the share for more kinds of toolpaths.
_FACTOR = 2.0
# Weight of the ridge term of the fit, which keeps the default proportions between the constants of `Speed`; a measured
# time has the weight 1.
_RIDGE = 0.5
# Lower bound of each fitted constant of `Speed`, as a share of the default constant that is scaled to this computer.
# Without the bound, noisy times could give constants that are zero or negative.
_LEAST = 0.1


@dataclass(frozen=True)
class Speed:
    """Time that one computer needs for each step of the simulator, s.

    The default values were measured on one core of a Xeon processor. :func:`measure_speed` measures the values for the
    computer on which it runs.

    Attributes
    ----------
    trajectory : float
        Time for one trajectory, whether or not the trajectory meets the stock.
    pixel : float
        Time for one pixel of the image.
    meeting : float
        Time to compare one trajectory with one tile of the largest size.
    block : float
        Time for one batch of pairs (of a tile or pixel and a trajectory) of one kind, in addition to the time for the
        pairs in the batch.
    test : float
        Time to test one pair of a tile and a trajectory.
    cell : float
        Time to cut the ray of one pixel by one trajectory.
    record : float
        Time for one dexel, trace element or gap in a vertical view.
    factor : float
        Uncertainty of an estimated time; the actual time is probably between the estimate divided by `factor` and the
        estimate times `factor`.
    processes : int
        Number of processes that cut at the same time. All times in `Speed` are for one process.
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
        """Time for one unit of each element of `Work.amounts`, in the same order, (7,) float64, s."""
        return np.array([self.trajectory, self.pixel, self.meeting, self.block, self.test, self.cell, self.record])

    def seconds(self, work: Work, growth: float = 1.0) -> float:
        """Return the time of a simulation whose image has `growth` times as many pixels as the image of `work`, s."""
        alone = float((work.amounts(growth) * self.constants).sum())
        return shared_seconds(alone, max(1, min(self.processes, int(work.bands))))


USUAL = Speed()


def measure_speed(clock: Callable[[], float] = processor_clock, going_on: Callable[[], object] = lambda: None) -> Speed:
    """Time the simulator on straight passes, circles and a wavy surface until repeated times agree.

    The measurement takes about two seconds. The images are nearly as large as real images, because in small images the
    overhead of numpy's calls takes most of the time.

    Parameters
    ----------
    clock : callable
        Returns a time, s. The default is the processor time, because other processes on the computer do not influence
        the processor time.
    going_on : callable
        Called before each simulation, several times a second. An exception raised by `going_on` stops the measurement.

    Returns
    -------
    Speed
        The constants that `fit_speed` fits to the measured times.
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
    """Fit the constants of `Speed` to measured times.

    The fit is a ridge regression (Hoerl and Kennard 1970) on the relative differences between estimated and measured
    times. The ridge term keeps the proportions between the constants close to the default proportions, because a few
    noisy times do not determine all constants.

    Parameters
    ----------
    amounts : (k, 7) ndarray
        The amounts of work in each simulation; see `Work.amounts`.
    seconds : (k,) ndarray
        Measured time of each simulation, s.
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
    """Return the amounts of work in one simulation, (7,); see `Work.amounts`."""
    removal = Removal(Cuts([Cut(toolpath, tool)]), _STOCK, view.frame(_STOCK))
    return work_of(removal, len(toolpath), count(removal)).amounts()


def _square(side: int, direction: tuple[float, float, float] = _TOP) -> View:
    return View(direction, side, side)


def _rows(count: int) -> Toolpath:
    """Return an even number of straight parallel passes at one height, cut back and forth."""
    x, y = np.tile([8.0, 52.0, 52.0, 8.0], count // 2), np.repeat(np.linspace(8, 52, count), 2)
    return Toolpath.through(np.column_stack((x, y, np.full(len(x), 15.0))))


def _loops(count: int) -> Toolpath:
    """Return concentric circles, the largest first, with chords of 5 degrees."""
    angles = np.linspace(0, 2 * np.pi, 73)
    radius, angle = np.repeat(np.linspace(22, 6, count), len(angles)), np.tile(angles, count)
    return Toolpath.through(
        np.column_stack((30 + radius * np.cos(angle), 30 + radius * np.sin(angle), np.full(len(angle), 12.0)))
    )


def _surface(count: int) -> Toolpath:
    """Return an even number of parallel passes over a wavy surface, cut back and forth."""
    row = np.linspace(0, 60, 31)
    x, y = np.tile(np.concatenate((row, row[::-1])), count // 2), np.repeat(np.linspace(0, 60, count), len(row))
    return Toolpath.through(np.column_stack((x, y, 13 + 3 * np.sin(x / 9) * np.cos(y / 11))))
