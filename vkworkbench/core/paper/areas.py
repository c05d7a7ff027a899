# SPDX-License-Identifier: LGPL-2.1-or-later
"""Split a toolpath into monotonous areas, and compute measures and the signature of each area.

Every measure is computed once and cached.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from vkworkbench.core.paper.directions import extremes, signs_of_reversals, top_level, total_turns
from vkworkbench.core.paper.loops import closed_loops, closing_turns, is_closed, may_be_closed
from vkworkbench.core.paper.moves import Moves, cutting_moves
from vkworkbench.core.paper.signature import Signature
from vkworkbench.core.paper.thresholds import LOOPS, TURNS
from vkworkbench.core.toolpath import Toolpath


def monotonous_areas(toolpath: Toolpath, first: int = 0, last: int | None = None) -> Areas:
    """Split the cutting moves into monotonous areas, the stretches between two rapids, plunges or lifts (section 2.1).

    Parameters
    ----------
    first, last : int
        First and last trajectory to split into areas; by default all trajectories are split.

    Returns
    -------
    Areas
        The areas contain no moves (m = 0) if no trajectory cuts along the working plane.
    """
    return Areas(**vars(cutting_moves(toolpath, first, len(toolpath) if last is None else last + 1)))


class Areas(Moves):
    """The `m` moves in `a` monotonous areas, and measures of whole areas."""

    @cached_property
    def end(self) -> np.ndarray:
        """Index after the last move of each area, (a,) int: area i consists of the moves start[i] to end[i] - 1."""
        return np.append(self.start[1:], len(self)) if len(self) else self.start

    @cached_property
    def climbs(self) -> bool:
        """Whether any move changes the height of the tool."""
        return bool(self.dz.any())

    @cached_property
    def area_length(self) -> np.ndarray:
        """Length of each area in the plane, (a,) mm."""
        return np.add.reduceat(self.length, self.start) if len(self) else np.empty(0)

    @property
    def by_length(self) -> np.ndarray:
        """Indices of the areas, the longest first, (a,)."""
        return np.argsort(-self.area_length, kind="stable")

    @cached_property
    def loops(self) -> tuple[np.ndarray, np.ndarray]:
        """First move of each closed loop, and index after its last move, both (k,) int; see :func:`closed_loops`."""
        return closed_loops(self)

    @cached_property
    def _signs(self) -> tuple[np.ndarray, np.ndarray]:
        """Signs of the half turns, and the last alternating sign in each area; see :func:`signs_of_reversals`."""
        return signs_of_reversals(self.turning, self.unsigned, self.start, TURNS.UNSIGNED)

    @cached_property
    def signed(self) -> tuple[np.ndarray, np.ndarray]:
        """Turning and phi, both (m,) rad, with the signs of half turns that :func:`signs_of_reversals` chooses."""
        if not len(self.unsigned):
            return self.turning, self.phi
        signs = self._signs[0]
        turning = self.turning.copy()
        turning[self.unsigned] += np.pi * signs
        half_turns = np.zeros(len(self), np.int64)
        half_turns[self.unsigned] = signs
        np.cumsum(half_turns, out=half_turns)
        half_turns -= np.repeat(half_turns[self.start], self.end - self.start)
        return turning, self.phi + np.pi * half_turns

    @cached_property
    def twice_swept(self) -> np.ndarray:
        """Twice the signed area of the triangle between each move and the origin, (m,) mm2."""
        swept: np.ndarray = self.x * self.dy
        swept -= self.y * self.dx
        return swept

    @cached_property
    def closed(self) -> np.ndarray:
        """Whether each area ends at its start, up to a small gap, (a,) bool; see :func:`is_closed`."""
        first, last = self.start, self.end - 1
        end_x, end_y = self.x[last] + self.dx[last], self.y[last] + self.dy[last]
        gap = np.hypot(end_x - self.x[first], end_y - self.y[first])
        found = may_be_closed(gap, self.area_length)
        chosen = np.flatnonzero(found)
        if len(chosen):
            size = (self.end - self.start)[chosen]
            of = slice(None) if found.all() else np.flatnonzero(np.repeat(found, self.end - self.start))
            twice_area = np.add.reduceat(self.twice_swept[of], np.cumsum(size) - size)
            chord = (end_x * self.y[first] - end_y * self.x[first])[chosen]
            found[chosen] = is_closed(gap[chosen], (twice_area + chord) / 2, size)
        return found

    @cached_property
    def total_turning(self) -> np.ndarray:
        """Phi at the end of each area, (a,) rad, including the closing turn of areas that end at their start.

        The closing turn is the turn from the last move of an area into its first move. In an area of offset loops that
        are linked without a lift, the result includes the closing turn of the last loop. The result does not include
        the closing turns of small loops along the boundary of a zigzag.
        """
        begin, end = self.start.copy(), self.end.copy()
        closes = self.closed.copy()
        first, loop_end = self.loops
        if len(first):
            area = np.searchsorted(self.start, first, side="right") - 1
            way = np.zeros(len(self) + 1)
            np.cumsum(self.length, out=way[1:])
            looped = np.bincount(area, way[loop_end] - way[first], len(begin)) > LOOPS.LOOPED * self.area_length
            final = np.append(area[1:] > area[:-1], True) & looped[area] & ~self.closed[area]
            begin[area[final]], end[area[final]] = first[final], loop_end[final]
            closes[area[final]] = True
        phi, closing = self.signed[1][end - 1], closing_turns(self.alpha, begin, end)
        total = np.where(self.closed, total_turns(phi, closing, self._signs[1], TURNS.UNSIGNED), phi + closing)
        return np.where(closes, total, phi)

    @cached_property
    def signed_extremes(self) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest phi of each area, with the chosen signs of half turns, (a,) rad each.

        The turn from the last move of a closed area into its first move is not included.
        """
        return extremes(self.signed[1], self.start) if len(self.unsigned) else self.phi_extremes

    @cached_property
    def phi_ranges(self) -> np.ndarray:
        """Lowest and highest phi in each area, with the turn from a loop's last move into its first, (a, 2) rad."""
        if not len(self):
            return np.empty((0, 2))
        (low, high), total = self.signed_extremes, self.total_turning
        return np.array([np.minimum(low, total), np.maximum(high, total)]).T

    @cached_property
    def phi_range(self) -> tuple[float, float]:
        """Lowest and highest phi in all areas, with the turn from a loop's last move into its first, rad."""
        if not len(self):
            return 0.0, 0.0
        return float(self.phi_ranges[:, 0].min()), float(self.phi_ranges[:, 1].max())

    @property
    def top_level(self) -> int:
        """Level (number of whole turns in phi) farthest from zero in all areas.

        Phi includes the turn from a loop's last move into its first.
        """
        return top_level(self.phi_range)

    def signature(self, area: int) -> Signature:
        """Return the signature of one area; its arrays share memory with the areas where possible."""
        of = slice(self.start[area], self.end[area])
        turning, phi = self.signed
        unsigned, exact = (
            found[slice(*np.searchsorted(found, (of.start, of.stop)))] for found in (self.unsigned, self.reversals)
        )
        return Signature(
            self.x[of],
            self.y[of],
            self.dx[of],
            self.dy[of],
            self.alpha[of],
            turning[of][1:],
            phi[of],
            unsigned=unsigned - of.start - 1,
            reversals=exact - of.start - 1,
            closed=bool(self.closed[area]),
            total_turning=float(self.total_turning[area]),
        )
