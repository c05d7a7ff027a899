# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the rapids and the fast plunges of a job, on rays whose distance is small compared with each tool's width."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.solids import SMALLEST
from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.findings.faults import (
    ROUNDED,
    ArcRises,
    Crash,
    Plunge,
    crashes_among,
    plunges_among,
    too_fast,
)
from vkworkbench.core.zbuffer.findings.fine_rays import RAYS_ACROSS, FineRays, half_widths, parts_of
from vkworkbench.core.zbuffer.findings.removed_segments import joined
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts, Source
from vkworkbench.core.zbuffer.sweeps.trajectories import passes_over

# Distance between rays for the second check, mm, which examines rapids that remove nothing on the rays of the first
# check. With a larger distance between rays, rapids that cut a thin layer off a wall are missed. With a smaller
# distance between rays, the check is slower.
_CLOSE = 2.0**-5
# Smallest distance between rays, mm. Only pointed tools whose tip is slightly below the stock's top need rays as close
# as this.
_CLOSEST = 2.0**-10


@dataclass(frozen=True)
class CrashCheck:
    """The crashes and fast plunges of a job, found on rays whose distance is small compared with each tool's width.

    Attributes
    ----------
    crashes : tuple of Crash
        Rapids that cut, in the order of the trajectories.
    fast_plunges : tuple of Plunge
        Plunges into full material above the tool's vertical feed, in the order of the trajectories.
    unchecked : tuple of Source
        Rapids and fast plunges that were not checked within the time limit, in the order of the trajectories.
    pixel : float
        Largest distance between neighbouring rays, mm; 0 if no move had to be checked.
    met : bool
        Whether at least one move can meet the stock, judged by bounding boxes.
    """

    crashes: tuple[Crash, ...] = ()
    fast_plunges: tuple[Plunge, ...] = ()
    unchecked: tuple[Source, ...] = ()
    pixel: float = 0.0
    met: bool = True


def check_crashes(
    cuts: Iterable[Cut], stock: Solid, *, seconds: float = np.inf, going_on: Callable[[], None] = lambda: None
) -> CrashCheck:
    """Find the rapids that cut and the plunges that are too fast, for tools and stocks of any size.

    A rapid is not checked if it certainly stays above the stock, or if it retracts along the tool's axis. All other
    rapids, and all plunges faster than the tool's vertical feed, are simulated on rays. Neighbouring rays are at most
    an eighth of the tool's width, measured at the height of the stock's top, from each other. Rapids that remove
    nothing on these rays are checked again on rays that are at most 0.03 mm apart, until the time limit is reached.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in machining order.
    seconds : float
        Time limit, s. Moves that are not checked within the time limit are returned as unchecked.
    going_on : callable, optional
        Called many times a second. An exception raised by `going_on` ends the check.
    """
    numbered = Cuts(cuts)
    return _Check(numbered, stock, time.monotonic() + seconds, going_on).run()


class _OutOfTime(Exception):
    pass


class _Check:
    def __init__(self, cuts: Cuts, stock: Solid, end: float, going_on: Callable[[], None]) -> None:
        self.cuts, self.stock, self._end, self._going_on = cuts, stock, end, going_on
        self.fast, self._rises = too_fast(cuts), ArcRises(cuts)
        self.crashes: dict[int, Crash] = {}
        self.plunges: list[Plunge] = []

    def run(self) -> CrashCheck:
        moves, half_width = self._doubtful()
        pixel = 2.0 ** np.floor(np.log2(np.maximum(2 * half_width / RAYS_ACROSS, _CLOSEST)))
        unchecked, largest = [], 0.0
        for size in np.unique(pixel)[::-1].tolist():
            own = np.flatnonzero(pixel == size)
            left = self._check(moves[own], half_width[own], size, self._find)
            unchecked += left
            if len(left) < len(own):
                largest = max(largest, size)
        if not unchecked:
            self._look_closer(moves, half_width, pixel)
        return CrashCheck(
            tuple(self.crashes[trajectory] for trajectory in sorted(self.crashes)),
            tuple(sorted(self.plunges, key=lambda plunge: plunge.trajectory)),
            tuple(self.cuts.source(trajectory) for trajectory in sorted(unchecked) if trajectory not in self.crashes),
            largest,
            bool(self._met.any()),
        )

    def _doubtful(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the moves to check (k,), and half the width of each tool at the height of the stock's top, mm."""
        cuts, stock = self.cuts, self.stock
        start, end = cuts.ends
        met = passes_over(start, end, np.array([cut.tool.radius for cut in cuts.cuts])[cuts.cut], stock)
        depth = stock.upper[2] - np.minimum(start[:, 2], end[:, 2])
        # A rapid straight up from the end of the previous move stays in the hole that this move cut, so it needs no
        # check.
        up = (np.hypot(*(end - start)[:, :2].T) < SMALLEST) & (end[:, 2] >= start[:, 2])
        up[cuts.first[:-1][np.diff(cuts.first) > 0]] = False
        rapid = cuts.rapid & ~up & (depth > ROUNDED)
        self._met = met & (depth > 0)
        moves = np.flatnonzero(met & (rapid | self.fast & (depth > 0)))
        of_cut = cuts.cut[moves]
        half_width = np.empty(len(moves))
        for number in np.unique(of_cut):
            own = of_cut == number
            half_width[own] = half_widths(cuts.cuts[number].tool, depth[moves[own]])
        return moves, half_width

    def _look_closer(self, moves: np.ndarray, half_width: np.ndarray, pixel: np.ndarray) -> None:
        """Check the rapids that removed nothing on the rays of the first check again, on closer rays."""
        fine = ~self.fast[moves] & (pixel > _CLOSE) & ~np.isin(moves, list(self.crashes))
        self._check(moves[fine], half_width[fine], _CLOSE, self._find_touch)

    def _check(
        self,
        moves: np.ndarray,
        half_width: np.ndarray,
        pixel: float,
        find: Callable[[FineRays, np.ndarray, np.ndarray], None],
    ) -> list[int]:
        """Call `find` for batches of the moves `moves` (k,); return the moves not checked within the time limit."""
        if len(moves) == 0:
            return []
        rays = FineRays(self.cuts, self.stock, pixel)
        for part in parts_of(self.cuts.lengths[moves] / half_width):
            try:
                self._continue()
                find(rays, moves[part], half_width[part])
            except _OutOfTime:
                return moves[part.start :].tolist()
        return []

    def _continue(self) -> None:
        self._going_on()
        if time.monotonic() > self._end:
            raise _OutOfTime

    def _find(self, rays: FineRays, moves: np.ndarray, half_width: np.ndarray) -> None:
        """Find the crashes and fast plunges among the moves `moves` (k,), with their volumes."""
        parts = list(rays.removed_by(moves, half_width, self._continue))
        if not parts:
            return
        segments, cuts = joined(parts), self.cuts
        fast = self.fast[segments.owner]
        rapid = segments.selected(~fast)
        for crash in crashes_among(cuts, rapid, rapid.volumes(len(cuts)), self._rises):
            self.crashes[crash.trajectory] = crash
        plunges = moves[self.fast[moves]]
        if len(plunges):
            self.plunges += plunges_among(cuts, plunges, segments.selected(fast))

    def _find_touch(self, rays: FineRays, moves: np.ndarray, half_width: np.ndarray) -> None:
        """Find the crashes among the moves `moves` (k,).

        When a move has crashed once, it is not examined any further.
        """
        removed = np.zeros(len(self.cuts))
        for segments in rays.removed_by(moves, half_width, self._continue):
            removed += segments.volumes(len(self.cuts))
            found = crashes_among(self.cuts, segments, removed, self._rises)
            for crash in found:
                self.crashes.setdefault(crash.trajectory, crash)
            rays.forget(np.array([crash.trajectory for crash in found], np.int64))
