# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide each monotonous area into pieces: loops, single turns of spirals and helices, zigzags and open strokes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN, Areas, axis_of, closing_turns, is_closed, is_one_turn, winding_turns
from vkworkbench.core.recognition.thresholds import NEGLIGIBLE, PASSES, PIECES, ROUNDING, WINDINGS

LOOP, WINDING, ZIGZAG, STROKE = range(4)


@dataclass(frozen=True)
class Pieces:
    """Measures of the k pieces of the monotonous areas: loops, turns of windings, zigzags and strokes.

    Attributes
    ----------
    start, end : (k,) int
        The moves of piece i are the moves from start[i] to end[i] - 1.
    kind : (k,) int
        LOOP: closed, with a net turn of 2 pi. WINDING: one turn of a stretch of several full turns, such as a spiral.
        ZIGZAG: back and forth, with half-turns of alternating sign between its passes. STROKE: any other piece.
    area : (k,) int
        Monotonous area of each piece.
    length : (k,) float
        Length in the plane, mm.
    net : (k,) float
        Net turn from the first to the last move, rad. With its closing turn, a loop has a net turn of +-2 pi.
    back : (k,) float
        Turning to the left and to the right that cancels out, sum |turn| - |net|, rad; 0 for a convex curve.
    enclosed : (k,) float
        Signed area between the piece and its chord, mm2.
    box : (k, 4) float
        Bounding box: lowest x and y, highest x and y, mm.
    z, last_z, rise, drop : (k,) float
        Mean height, height at the end, range of heights, and height gained from start to end, mm.
    passes : (k,) int
        Number of passes along the axis of each piece, in either direction.
    wavy : (k,) bool
        Whether a loop or winding has alternating half-turns, like a concave contour or a zigzag whose end is at its
        start.
    """

    start: np.ndarray
    end: np.ndarray
    kind: np.ndarray
    area: np.ndarray
    length: np.ndarray
    net: np.ndarray
    back: np.ndarray
    enclosed: np.ndarray
    box: np.ndarray
    z: np.ndarray
    last_z: np.ndarray
    rise: np.ndarray
    drop: np.ndarray
    passes: np.ndarray
    wavy: np.ndarray

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.start)

    @cached_property
    def flat(self) -> np.ndarray:
        """Whether each piece stays at one height, (k,)."""
        return self.rise < ROUNDING.HEIGHT


def cut_pieces(moves: Areas) -> Pieces:
    """Divide the monotonous areas into pieces and measure the pieces.

    Parameters
    ----------
    moves : Areas
        At least one move.
    """
    first, end = moves.loops
    loop = np.zeros(len(moves) + 1, bool)
    loop[first] = True
    cut = loop.copy()
    cut[moves.start] = True
    cut[end] = True
    again = np.zeros(len(cut), bool)
    again[_comes_back(moves, cut)] = True
    cut |= again
    start = np.flatnonzero(cut[:-1])
    parts = _Stretches(moves, start)
    net, closed = parts.net()
    kind = np.where(loop[start] | (closed & is_one_turn(net)), LOOP, STROKE)
    # Only two kinds of stretches (consecutive moves) can be zigzags: open stretches of at least three moves, and loops
    # whose left and right turns cancel out by at least a full turn.
    able = np.where(kind == LOOP, parts.turned > np.abs(net) + TURN, parts.end - parts.start > 2)
    if parts.length[able].sum() < NEGLIGIBLE.LINKS * parts.length.sum():
        able[:] = (
            False  # open stretches and unwinding loops that are short in total are links between loops, not zigzags
        )
    alternating, constant, passes, parallel = half_turns(moves, parts, able)
    opened = kind != LOOP
    waves = (alternating > PASSES.ALTERNATING * parts.length) & (alternating > PASSES.MORE * constant)
    winding = opened & (np.abs(net) > WINDINGS.TURN * TURN)
    rows = (passes > PASSES.OF_A_LETTER) | (parallel > PASSES.SHARE)
    zigzag = opened & ~winding & waves & rows & ~again[start] & ~again[parts.end]
    kind[winding], kind[zigzag] = WINDING, ZIGZAG
    wavy = (winding & waves) | ((kind == LOOP) & (alternating > PASSES.ALTERNATING_LOOP * parts.length))
    if winding.any():
        further = winding_turns(moves, start[winding], parts.end[winding], np.sign(net[winding]))
        start = np.union1d(start, further)
        of = np.searchsorted(parts.start, start, side="right") - 1
        kind, passes, wavy = kind[of], passes[of], wavy[of]
        parts = _Stretches(moves, start)
        net, _ = parts.net()
    area = np.zeros(len(start), np.int64)
    if len(moves.start) > 1:
        area = np.searchsorted(moves.start, start, side="right") - 1
    return parts.measure(kind, area, net, passes, wavy)


def _comes_back(moves: Areas, cut: np.ndarray) -> np.ndarray:
    """Return the moves at which the tool reverses and follows a bent pass backwards, as on a ramp along a contour.

    Only passes without a plunge between them are compared, because a plunge ends the area. A straight pass and its
    reversal stay one piece, because they can be an entry or a row of a zigzag.

    Parameters
    ----------
    moves : Areas
    cut : (m + 1,) bool
        Whether a loop or an area begins or ends before the move, so that a new piece begins.
    """
    if not len(moves.reversals):
        return moves.reversals
    begins = cut.copy()
    begins[moves.reversals] = begins[-1] = True
    back: np.ndarray = moves.reversals[~cut[moves.reversals]]
    back = back[~begins[back + 1]]  # a pass of one move is always straight, and is not a bent pass
    if not len(back):
        return back
    start = np.flatnonzero(begins[:-1])
    parts, k = _Stretches(moves, start), np.searchsorted(start, back)
    ground = np.column_stack([parts.boxes(), parts.length / 4])
    same = np.abs(ground[k] - ground[k - 1]).max(axis=1) < ROUNDING.GROUND
    back, k = back[same], k[same]
    return back[off_line(moves, parts.start[k], parts.end[k]) > ROUNDING.GROUND]


def off_line(moves: Areas, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the largest distance of the moves from start[i] to end[i] - 1 from a line, (k,) mm.

    The line runs through the first point in the direction of the longest move.
    """
    if not len(start):
        return np.empty(0)
    size = end - start
    first = np.cumsum(size) - size
    at = np.arange(int(size.sum())) + np.repeat(start - first, size)
    length = moves.length[at]
    is_longest = np.flatnonzero(length == np.repeat(np.maximum.reduceat(length, first), size))
    longest = at[is_longest[np.searchsorted(is_longest, first)]]
    dx, dy, x, y = (
        np.repeat(of, size) for of in (moves.dx[longest], moves.dy[longest], moves.x[start], moves.y[start])
    )
    across = (moves.y[at] + moves.dy[at] - y) * dx - (moves.x[at] + moves.dx[at] - x) * dy
    return np.maximum.reduceat(np.abs(across), first) / moves.length[longest]


class _Stretches:
    """All moves, divided into k stretches of consecutive moves, with the measures of every stretch."""

    def __init__(self, moves: Areas, start: np.ndarray) -> None:
        self.moves = moves
        self.start = start
        self.end = np.append(start[1:], len(moves))
        self.length = np.add.reduceat(moves.length, start)
        last = self.end - 1
        self.x, self.y = moves.x[start], moves.y[start]
        self.end_x, self.end_y = moves.x[last] + moves.dx[last], moves.y[last] + moves.dy[last]
        gap_x, gap_y = self.end_x - self.x, self.end_y - self.y
        self.gap = np.sqrt(gap_x * gap_x + gap_y * gap_y)  # the square root is many times faster than np.hypot
        twice_area = np.add.reduceat(moves.twice_swept, start)
        self.enclosed = (twice_area + self.end_x * self.y - self.end_y * self.x) / 2

    @cached_property
    def turned(self) -> np.ndarray:
        """Sum of the absolute turns, (k,) rad."""
        return np.add.reduceat(np.abs(self.moves.turning), self.start)

    def net(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the net turn of each stretch (with the closing turn of closed stretches), and whether it is closed."""
        moves = self.moves
        net = moves.phi[self.end - 1] - moves.phi[self.start]
        closed = is_closed(self.gap, self.enclosed, self.end - self.start)
        at = np.flatnonzero(closed)
        net[at] += closing_turns(moves.alpha, self.start[at], self.end[at])
        return net, closed

    def boxes(self) -> np.ndarray:
        """Return the bounding box of each stretch, lowest x and y, highest x and y, (k, 4) mm."""
        begin, end = (self.x, self.y), (self.end_x, self.end_y)
        box = np.array([*map(np.minimum, begin, end), *map(np.maximum, begin, end)])
        last, most = self.end - 1, int((self.end - self.start).max())
        if most > PIECES.FEW:
            for along, low, high in zip((self.moves.x, self.moves.y), box[:2], box[2:]):
                np.minimum(low, np.minimum.reduceat(along, self.start), out=low)
                np.maximum(high, np.maximum.reduceat(along, self.start), out=high)
            return box.T
        for k in range(1, most):
            at = np.minimum(self.start + k, last)
            for along, low, high in zip((self.moves.x, self.moves.y), box[:2], box[2:]):
                place = along.take(at)
                np.minimum(low, place, out=low)
                np.maximum(high, place, out=high)
        return box.T

    def measure(
        self, kind: np.ndarray, area: np.ndarray, net: np.ndarray, passes: np.ndarray, wavy: np.ndarray
    ) -> Pieces:
        """Return the `Pieces` with the measures of all stretches."""
        moves, start = self.moves, self.start
        low, high = np.minimum, np.maximum
        z = last_z = moves.z[self.end - 1]
        first_z = moves.z[start] - moves.dz[start]
        rise = np.zeros(len(start))
        if moves.climbs:
            middle = moves.z - moves.dz / 2
            middle *= moves.length
            z = np.add.reduceat(middle, start) / self.length
            rise = high(high.reduceat(moves.z, start), first_z) - low(low.reduceat(moves.z, start), first_z)
        return Pieces(
            start=start,
            end=self.end,
            kind=kind,
            area=area,
            length=self.length,
            net=net,
            back=np.maximum(self.turned - np.abs(net), 0.0),
            enclosed=self.enclosed,
            box=self.boxes(),
            z=z,
            last_z=last_z,
            rise=rise,
            drop=last_z - first_z,
            passes=passes,
            wavy=wavy,
        )


class HalfTurns(NamedTuple):
    """The half-turns (reversals of direction) between the passes of k stretches; see `half_turns`.

    Attributes
    ----------
    alternating, constant : (k,) float
        Length of the passes between two half-turns of opposite sign, and between two half-turns of equal sign, mm.
    passes : (k,) int
        Number of passes; 1 for a stretch that was not measured.
    parallel : (k,) float
        Share of the passes' length that is parallel to the axis. The value is measured only for stretches of few
        passes, and is 0 for other stretches.
    """

    alternating: np.ndarray
    constant: np.ndarray
    passes: np.ndarray
    parallel: np.ndarray


def half_turns(moves: Areas, parts: _Stretches, able: np.ndarray) -> HalfTurns:
    """Measure the half-turns between passes, whose signs distinguish back-and-forth patterns from contours.

    A pass is a run of moves in one direction along the axis of its stretch. Between two opposite passes, the sum of the
    turns (phi) changes by pi or -pi. The signs of these half-turns alternate in a zigzag and stay the same around a
    contour (paper, section 3.2). The signs of the half-turns do not depend on the first trajectory, unlike the paper's
    condition -pi <= phi <= pi, and are also valid with islands and concave boundaries. An exact reversal, after which
    the tool returns on the same line, has no sign and counts as alternating.

    Parameters
    ----------
    moves : Areas
    parts : _Stretches
    able : (k,) bool
        Stretches to measure.
    """
    k = len(parts.start)
    stretch = np.flatnonzero(able)
    if not len(stretch):
        return HalfTurns(np.zeros(k), np.zeros(k), np.ones(k, np.int64), np.zeros(k))
    size = (parts.end - parts.start)[stretch]
    of, dx, dy, length = np.repeat(stretch, size), moves.dx, moves.dy, moves.length
    chosen = None  # None selects all moves of all stretches
    if len(stretch) < k:
        chosen = np.flatnonzero(np.repeat(able, parts.end - parts.start))
        dx, dy, length = dx[chosen], dy[chosen], length[chosen]
    begin = np.cumsum(size) - size
    cos = dx / length
    axis = axis_of(np.add.reduceat(cos * dx, begin), np.add.reduceat(cos * dy, begin), parts.length[stretch])
    u, v = np.cos(axis), np.sin(axis)
    if len(stretch) > 1:
        u, v = np.repeat(u, size), np.repeat(v, size)
    along = np.multiply(dx, u, out=cos)
    along += dy * v
    on = np.flatnonzero(np.abs(along) > PASSES.ALONG * length)
    if not len(on):
        return HalfTurns(np.zeros(k), np.zeros(k), np.ones(k, np.int64), np.zeros(k))
    forward = (along > 0).take(on)
    new = forward[1:] != forward[:-1]
    if len(stretch) > 1:
        new |= np.diff(of.take(on)) > 0
    begin = np.flatnonzero(np.concatenate([[True], new]))
    first, passed = on.take(begin), np.add.reduceat(length.take(on), begin)
    of = of.take(first)
    passes = np.maximum(np.bincount(of, minlength=k), 1)
    few = passes <= PASSES.OF_A_LETTER
    parallel = np.zeros(k)
    if few[stretch].any():
        exactly = np.abs(along) > PASSES.PARALLEL * length
        exact = np.add.reduceat((length * exactly).take(on), begin)
        parallel = np.bincount(of, exact, k) / np.maximum(np.bincount(of, passed, k), 1e-9)
        parallel[~few] = 0.0
    phi = moves.phi.take(first if chosen is None else chosen.take(first))
    half_turn = np.rint((phi[1:] - phi[:-1]) * (1 / np.pi))
    same = of[1:] == of[:-1]
    between = same[1:] & same[:-1]  # whether the pass is neither the first nor the last pass of its stretch
    alternates = half_turn[1:] * half_turn[:-1] <= 0
    of, passed = of[1:-1], passed[1:-1]
    return HalfTurns(
        alternating=np.bincount(of, np.where(between & alternates, passed, 0.0), k),
        constant=np.bincount(of, np.where(between & ~alternates, passed, 0.0), k),
        passes=passes,
        parallel=parallel,
    )
