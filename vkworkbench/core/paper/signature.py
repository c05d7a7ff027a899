# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the paper's signature of a polyline: V_k, the cumulative angular function, levels and the Gauss map."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.paper.directions import (
    TURN,
    directions,
    level_of,
    signs_of_reversals,
    top_level,
    total_turns,
    turns,
    wrap,
)
from vkworkbench.core.paper.plane import plane_of_points
from vkworkbench.core.paper.thresholds import TURNS
from vkworkbench.given import numbers

NO_LENGTH = 1e-9  # mm; a shorter trajectory has no direction


def signature(points: np.ndarray) -> Signature:
    """Compute the signature of a polyline (paper, sections 3.1 and 3.2; Otterloo 1991).

    Parameters
    ----------
    points : (n+1, 2) or (n+1, 3) array_like of float
        Vertices. A polyline in space is projected to the coordinate plane of its motion. The plane is XY, unless Z
        changes and only one of X and Y changes; the plane is then YZ or ZX.

    Raises
    ------
    ValueError
        If `points` has another shape or contains a value that is not a finite number.

    Examples
    --------
    >>> square = signature([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0), (1, 0)])
    >>> float(square.phi[-1] / np.pi), int(square.level[-1])
    (2.0, 1)
    """
    points = numbers("points", points, "an array of (n+1, 2) or (n+1, 3) numbers")
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points must have the shape (n+1, 2) or (n+1, 3), not {points.shape}")
    if not np.isfinite(points).all():
        raise ValueError("points must be finite numbers")
    x, y = (points[:, axis] for axis in plane_of_points(points)[:2])
    dx, dy = x[1:] - x[:-1], y[1:] - y[:-1]
    squares = dx * dx + dy * dy
    alpha = directions(dx, dy)
    if squares.min(initial=np.inf) < NO_LENGTH**2:
        _carry_directions(alpha, np.flatnonzero(squares < NO_LENGTH**2))
    turning = turns(alpha)
    reversals, last = np.flatnonzero(np.abs(turning) > np.pi - TURNS.EXACT), np.zeros(1, np.int64)
    if len(reversals):
        turning[reversals] = 0.0
        before = np.append(0.0, turning)
        signs, last = signs_of_reversals(before, reversals + 1, np.zeros(1, np.int64), TURNS.EXACT)
        turning[reversals] = np.pi * signs
    phi = np.zeros(len(alpha))
    np.cumsum(turning, out=phi[1:])
    gap = np.hypot(x[-1] - x[0], y[-1] - y[0]) if len(alpha) else np.inf
    closed = bool(gap <= TURNS.EXACT * max(np.ptp(x), np.ptp(y))) if len(alpha) else False
    total = float(phi[-1]) if len(alpha) else 0.0
    if closed:
        total = float(total_turns(phi[-1:], wrap(alpha[:1] - alpha[-1:]), last, TURNS.EXACT)[0])
    return Signature(x[:-1], y[:-1], dx, dy, alpha, turning, phi, reversals, reversals, closed, total)


@dataclass(frozen=True, eq=False)
class Signature:
    """Directions, turns and levels of a polyline of n trajectories.

    Attributes
    ----------
    x, y : (n,) float64
        Start of each trajectory in the working plane, mm.
    dx, dy : (n,) float64
        The trajectories v_i in the plane, mm.
    alpha : (n,) float64
        Direction of trajectory v_i, rad in [-pi, pi]; a trajectory without length has the previous trajectory's
        direction.
    turning : (n-1,) float64
        Angle delta phi between successive trajectories, wrapped to [-pi, pi] (section 3.2). An exact reversal has no
        sign of its own: :func:`signs_of_reversals` chooses signs with which moves back and forth do not add up in phi.
    phi : (n,) float64
        Cumulative angular function: the sum of the turns before each trajectory, rad; phi[0] = 0.
    unsigned, reversals : (u,) and (r,) int64
        Indices into `turning` of half turns, which have no sign: of turns that are half turns up to rounding, and of
        exact half turns. For a polyline that is given by its points, both arrays contain only the exact half turns.
    closed : bool
        Whether the polyline ends at its start. For a polyline that is given by its points, the tolerance is a millionth
        of its size.
    total_turning : float
        Phi after the whole traversal, rad, including the last exterior angle of a closed polyline: +2 pi for a simple
        closed counter-clockwise polygon, -2 pi for a clockwise polygon (section 3.2). For linked offset loops, the
        value is phi at the end of the last loop, including the turn from the loop's last trajectory into its first.
    level : (n,) int64
        Level n: the number of whole turns in phi, which is phi / 2 pi truncated toward zero.
    length : (n,) float64
        Length of V_k, the sum of the first k trajectories.
    theta : (n,) float64
        Direction of V_k, rad in [-pi, pi]; if V_k is 0, the direction of the previous V_k.
    theta_level : (n,) float64
        Sum of theta and n times 2 pi, where n is the level (section 3.1).
    """

    x: np.ndarray
    y: np.ndarray
    dx: np.ndarray
    dy: np.ndarray
    alpha: np.ndarray
    turning: np.ndarray
    phi: np.ndarray
    unsigned: np.ndarray
    reversals: np.ndarray
    closed: bool
    total_turning: float

    def __len__(self) -> int:
        """Return the number of trajectories."""
        return len(self.alpha)

    @cached_property
    def vertices(self) -> np.ndarray:
        """Vertices of the polyline in its plane, (n+1, 2) mm."""
        points = np.empty((len(self) + min(len(self), 1), 2))
        for column, start, step in zip(points.T, (self.x, self.y), (self.dx, self.dy)):
            column[: len(self)] = start
            column[len(self) :] = start[-1:] + step[-1:]
        return points

    @cached_property
    def level(self) -> np.ndarray:
        """Level n of each trajectory, (n,): the integer part of phi / 2 pi (section 3.1)."""
        return level_of(self.phi)

    @cached_property
    def _v(self) -> tuple[np.ndarray, np.ndarray]:
        x, y = self.x + self.dx, self.y + self.dy
        x -= self.x[:1]
        y -= self.y[:1]
        return x, y

    @cached_property
    def length(self) -> np.ndarray:
        """Lengths L_k of V_k, (n,) mm (section 3.1)."""
        return np.hypot(*self._v)

    @cached_property
    def theta(self) -> np.ndarray:
        """Theta, angles of V_k to the X axis, (n,) rad in [-pi, pi] (section 3.1); if V_k is 0, the previous angle."""
        x, y = self._v
        theta = directions(x, y)
        near = np.flatnonzero((x < NO_LENGTH) & (x > -NO_LENGTH))
        _carry_directions(theta, near[x[near] ** 2 + y[near] ** 2 < NO_LENGTH**2])
        return theta

    @cached_property
    def theta_level(self) -> np.ndarray:
        """Sum of theta and 2 pi times the level, (n,) rad (section 3.1)."""
        return self.theta + TURN * self.level

    @cached_property
    def phi_range(self) -> tuple[float, float]:
        """Lowest and highest phi, rad, with the turn from the last into the first trajectory of a closed polyline."""
        total = self.total_turning
        return float(min(self.phi.min(initial=0.0), total)), float(max(self.phi.max(initial=0.0), total))

    @property
    def top_level(self) -> int:
        """Level (number of whole turns in phi) farthest from zero.

        Phi includes the turn from the last into the first trajectory of a closed polyline.
        """
        return top_level(self.phi_range)

    def gauss_map(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the Gaussian images of the trajectories and of V_k, points of the unit circle, both (n, 2).

        Each image is the unit vector in the direction of a trajectory or of V_k (section 2.2).
        """
        return _on_circle(self.alpha), _on_circle(self.theta)


def _on_circle(angle: np.ndarray) -> np.ndarray:
    return np.column_stack([np.cos(angle), np.sin(angle)])


def _carry_directions(alpha: np.ndarray, still: np.ndarray) -> None:
    """Give each trajectory without length (indices `still`, (s,) int) the direction of the previous trajectory.

    Trajectories without length at the beginning of the polyline get the direction of the first trajectory with a
    length.
    """
    if len(still) == len(alpha):
        alpha[:] = 0.0
    elif len(still):
        begin = np.append(True, still[1:] > still[:-1] + 1)
        run = np.cumsum(begin) - 1
        source = still[begin] - 1
        if source[0] < 0:
            source[0] = np.count_nonzero(run == 0)
        alpha[still] = alpha[source[run]]
