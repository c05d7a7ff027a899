# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the directions of moves, the turns between moves, and levels, numbers of whole turns (paper, section 3.2)."""

from __future__ import annotations

from typing import overload

import numpy as np

from vkworkbench.core.paper.thresholds import TURNS

TURN = 2 * np.pi


def directions(dx: np.ndarray, dy: np.ndarray) -> np.ndarray:
    """Return alpha, the directions of moves (n,), rad in [-pi, pi]."""
    return np.arctan2(dy, dx)


@overload
def wrap(angle: float) -> float: ...
@overload
def wrap(angle: np.ndarray) -> np.ndarray: ...
def wrap(angle: float | np.ndarray) -> float | np.ndarray:
    """Return one angle or angles (n,), wrapped to [-pi, pi], rad."""
    return angle - TURN * np.rint(angle * (1 / TURN))


def turns(alpha: np.ndarray) -> np.ndarray:
    """Return delta phi, the turns between successive directions (n,), (n-1,) rad in [-pi, pi] (section 3.2)."""
    return wrap(alpha[1:] - alpha[:-1])


def signs_of_reversals(
    turning: np.ndarray, at: np.ndarray, start: np.ndarray, half: float
) -> tuple[np.ndarray, np.ndarray]:
    """Choose signs for the half turns, so that moves back and forth do not add up in phi, the sum of the turns.

    A half turn to the left and a half turn to the right lead into the same direction, so a half turn has no sign of its
    own. If the tool leaves its path and returns on the same line, for example to relieve a corner, the half turn at the
    tip gets the sign with which the turns before, at and after the tip add up to the turn of the path without this
    excursion. All other half turns get alternating signs.

    Parameters
    ----------
    turning : (m,) float
        Turn at the start of each move, rad, where half a turn is already subtracted from each half turn; 0 at the start
        of an area.
    at : (r,) int
        Indices of the moves that begin with a half turn, ascending.
    start : (a,) int
        First move of each area.
    half : float
        A turn has no sign if it differs from half a turn by less than this angle, rad.

    Returns
    -------
    signs : (r,) int64
        +1 or -1.
    last : (a,) int64
        Sign of the last half turn with alternating signs in each area; 0 if the area has no such half turn. The first
        of these half turns gets the sign that brings phi (the sum of the turns) toward zero.
    """
    last = np.zeros(len(start), np.int64)
    if not len(at):
        return at, last
    area = np.searchsorted(start, at, side="right") - 1
    beside = turning[at - 1] + np.append(turning, 0.0)[at + 1]
    apart = np.diff(at) > 1
    alone = np.append(True, apart) & np.append(apart, True)
    signs = np.where(alone & (np.abs(beside) > half), -np.sign(beside), 0.0).astype(np.int64)
    others = np.flatnonzero(signs == 0)
    if len(others):
        turned = turning.copy()
        turned[at] += np.pi * signs
        phi = np.cumsum(turned)
        area, phi = area[others], phi[at[others]] - phi[start[area[others]]]
        first = np.flatnonzero(np.append(True, area[1:] != area[:-1]))
        size = np.diff(np.append(first, len(area)))
        rank = np.arange(len(area)) - np.repeat(first, size)
        begin = np.repeat(np.where(phi[first] > TURNS.EXACT, -1, 1), size)
        signs[others] = begin * (1 - 2 * (rank & 1))
        last[area] = signs[others]  # for an area with several half turns, numpy keeps the sign of the last half turn
    return signs, last


def total_turns(phi: np.ndarray, closing: np.ndarray, last: np.ndarray, half: float) -> np.ndarray:
    """Return the total turning of closed paths: phi of the last move plus the closing turn, (k,) rad.

    The closing turn is the turn from the last move into the first. If the closing turn is half a turn, its sign is
    unknown. If the path has half turns with alternating signs, the closing turn gets the sign that continues the
    alternation. If the path has no such half turns, for example at the tip of a lead-in along which the tool also
    leaves the contour, the closing turn gets the sign that brings phi closest to one full turn.

    Parameters
    ----------
    phi, closing : (k,) float
        Phi of the last move, and the turn from the last move into the first, rad.
    last : (k,) int
        Last alternating sign of a half turn in each path, from :func:`signs_of_reversals`; 0 if the path has none.
    half : float
        A closing turn has no sign if it differs from half a turn by less than this angle, rad.
    """
    sign = np.where(last, -last, np.where(np.abs(phi) > TURN, -1.0, 1.0) * np.copysign(1.0, phi))
    turned = np.where(np.abs(closing) > np.pi - half, closing + np.pi * (sign - np.copysign(1.0, closing)), closing)
    return phi + turned


def extremes(values: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the lowest and highest of `values` (m,) in each area, (a,) each; areas begin at the moves `start` (a,)."""
    if len(start) == 1:  # for a single area, min and max are many times faster than reduceat
        return values.min(keepdims=True), values.max(keepdims=True)
    return np.minimum.reduceat(values, start), np.maximum.reduceat(values, start)


@overload
def level_of(phi: float) -> int: ...
@overload
def level_of(phi: np.ndarray) -> np.ndarray: ...
def level_of(phi: float | np.ndarray) -> int | np.ndarray:
    """Return the level n, the number of whole turns in phi, truncated toward zero.

    If phi is below a whole turn only because of rounding, the whole turn counts as completed.

    Parameters
    ----------
    phi : float or (n,) float64
        rad.
    """
    turned = phi * (1 / TURN)
    turned += np.copysign(TURNS.EXACT / TURN, turned)
    return turned.astype(np.int64) if isinstance(turned, np.ndarray) else int(turned)


def farthest(phi_range: tuple[float, float]) -> float:
    """Return the bound of a range of phi that is farther from zero, rad; the upper bound if both are equally far."""
    low, high = phi_range
    return high if high >= -low - TURNS.EXACT else low


def top_level(phi_range: tuple[float, float]) -> int:
    """Return the level (number of whole turns) of that bound of a range of phi which is farther from zero."""
    return level_of(farthest(phi_range))


@overload
def axis_of(along_x: float, along_y: float, length: float) -> float: ...
@overload
def axis_of(along_x: np.ndarray, along_y: np.ndarray, length: np.ndarray) -> np.ndarray: ...
def axis_of(along_x: float | np.ndarray, along_y: float | np.ndarray, length: float | np.ndarray) -> float | np.ndarray:
    """Return the main axis of moves, rad in [-pi/2, pi/2].

    The angles of the moves are doubled, so that opposite directions are equal. The main axis is half the direction of
    the sum of the vectors with doubled angles.

    Parameters
    ----------
    along_x, along_y : (k,) float or float
        Sums of cos(alpha)^2 and of cos(alpha) sin(alpha) over the moves, weighted by the moves' lengths, mm.
    length : (k,) float or float
        Sum of the lengths, mm.
    """
    return 0.5 * np.arctan2(2 * along_y, 2 * along_x - length)
