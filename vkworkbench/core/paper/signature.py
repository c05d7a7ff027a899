# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's signature of a polyline: V_k, the cumulative angular function, levels and the Gauss map."""

from __future__ import annotations

from functools import cached_property

import numpy as np

TURN = 2 * np.pi
EXACT = 1e-6  # rad; a turn this close to half a turn is an exact reversal, and a level this close is reached
NO_LENGTH = 1e-9  # mm; a shorter trajectory has no direction


def signature(points: np.ndarray) -> Signature:
    """Compute the signature of a polyline (paper, sections 3.1 and 3.2; Otterloo 1991).

    Parameters
    ----------
    points : (n+1, 2) or (n+1, 3) array_like of float
        Vertices. A polyline in space is seen in the coordinate plane its motion lies in: XY, unless X or Y
        never changes while Z does (then ZX or YZ).

    Returns
    -------
    Signature

    Raises
    ------
    ValueError
        If `points` has another shape or holds a value that is no finite number.

    Examples
    --------
    >>> square = signature([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0), (1, 0)])
    >>> float(square.phi[-1] / np.pi), int(square.level[-1])
    (2.0, 1)
    """
    return Signature(points)


class Signature:
    """Directions, turns and levels of a polyline of n trajectories.

    Attributes
    ----------
    alpha : (n,) float64
        Direction of trajectory v_i, rad in [-pi, pi]; one without length keeps the direction before it.
    turning : (n-1,) float64
        Angle delta phi between successive trajectories, wrapped to [-pi, pi] (section 3.2). An exact reversal
        has no sign of its own: the signs alternate, so that going back and forth never adds up.
    phi : (n,) float64
        Cumulative angular function, rad; phi[0] = 0.
    level : (n,) int64
        n, the integer part of phi / 2 pi, truncated toward zero.
    reversals : (m,) int64
        Indices into `turning` of the exact reversals.
    length : (n,) float64
        Length of V_k, the sum of the first k trajectories.
    theta : (n,) float64
        Direction of V_k, rad in [-pi, pi].
    theta_level : (n,) float64
        theta + n 2 pi (section 3.1).
    """

    def __init__(self, points: np.ndarray) -> None:
        points = np.asarray(points, np.float64)
        if points.ndim != 2 or points.shape[1] not in (2, 3):
            raise ValueError(f"points must have the shape (n+1, 2) or (n+1, 3), not {points.shape}")
        x, y = _plane(points)
        dx, dy = x[1:] - x[:-1], y[1:] - y[:-1]
        self._x, self._y = x, y
        # The work is done in few arrays: for a long path it is their memory that takes the time.
        squares = dx * dx
        squares += dy * dy
        if not np.isfinite(squares.max(initial=0.0)) and not np.isfinite(points).all():
            raise ValueError("points must be finite numbers")
        self.alpha = np.arctan2(dy, dx)
        if squares.min(initial=np.inf) < NO_LENGTH**2:
            _carry_directions(self.alpha, squares < NO_LENGTH**2)
        self.turning = turning = self.alpha[1:] - self.alpha[:-1]
        scratch = squares[1:]
        np.multiply(turning, 1 / TURN, out=scratch)
        np.rint(scratch, out=scratch)
        scratch *= TURN
        turning -= scratch
        np.abs(turning, out=scratch)
        self.reversals = np.empty(0, np.int64)
        if scratch.max(initial=0.0) > np.pi - EXACT:
            self.reversals = np.flatnonzero(scratch > np.pi - EXACT)
            _alternate(turning, self.reversals)
        self.phi = np.zeros(len(self.alpha))
        np.cumsum(turning, out=self.phi[1:])

    def __len__(self) -> int:
        """Return the number of trajectories."""
        return len(self.alpha)

    @cached_property
    def level(self) -> np.ndarray:
        turns = self.phi * (1 / TURN)
        # Rounding must not keep a full turn from being one.
        turns += np.copysign(EXACT / TURN, turns)
        return turns.astype(np.int64)  # truncates

    @cached_property
    def _v(self) -> tuple[np.ndarray, np.ndarray]:
        return self._x[1:] - self._x[:1], self._y[1:] - self._y[:1]

    @cached_property
    def length(self) -> np.ndarray:
        return np.hypot(*self._v)

    @cached_property
    def theta(self) -> np.ndarray:
        x, y = self._v
        return np.arctan2(y, x)

    @cached_property
    def theta_level(self) -> np.ndarray:
        return self.theta + TURN * self.level

    @cached_property
    def closed(self) -> bool:
        """Whether the polyline ends where it began, to a millionth of its size."""
        if not len(self):
            return False
        size = max(np.ptp(self._x), np.ptp(self._y))
        return bool(self.length[-1] <= EXACT * size)

    @cached_property
    def total_turning(self) -> float:
        """Phi after the whole traversal, rad: a closed polyline's last exterior angle included.

        +2 pi for a simple closed counter-clockwise polygon, -2 pi for a clockwise one (section 3.2).
        """
        if not len(self):
            return 0.0
        total = float(self.phi[-1])
        if self.closed:
            last = float(self.alpha[0] - self.alpha[-1])
            total += last - TURN * round(last / TURN)
        return total

    @cached_property
    def phi_interval(self) -> tuple[np.ndarray, np.ndarray]:
        """Phi with every exact reversal counted as -pi, and as +pi: both (n,). What holds at both ends holds."""
        signed = self.turning.copy()
        signed[self.reversals] = 0.0
        doubt = np.zeros(len(self))
        doubt[self.reversals + 1] = np.pi
        steady = np.concatenate([np.zeros(min(len(self), 1)), np.cumsum(signed)])
        return steady - np.cumsum(doubt), steady + np.cumsum(doubt)

    def gauss_map(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the Gaussian images on the unit circle of the trajectories and of V_k, both (n, 2).

        The tips of the unit tangents are taken (section 2.2); for plane curves they are as good as normals.
        """
        images = (self.alpha, self.theta)
        return tuple(np.column_stack([np.cos(angle), np.sin(angle)]) for angle in images)


def _plane(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the two coordinates of the plane the motion lies in."""
    x, y = points[:, 0], points[:, 1]
    if points.shape[1] == 3 and len(points) and (x.min() == x.max() or y.min() == y.max()):
        z = points[:, 2]
        if z.min() != z.max():
            if y.min() == y.max() and x.min() != x.max():
                return z, x  # G18: seen along Y, Z is the first axis
            if x.min() == x.max() and y.min() != y.max():
                return y, z
    return x, y


def _carry_directions(alpha: np.ndarray, still: np.ndarray) -> None:
    """Give trajectories without length the direction before them, at the beginning the one after them."""
    if still.all():
        alpha[:] = 0.0
        return
    last = np.maximum.accumulate(np.where(still, -1, np.arange(len(alpha))))
    alpha[:] = alpha[np.where(last >= 0, last, np.argmin(still))]


def _alternate(turning: np.ndarray, reversals: np.ndarray) -> None:
    """Sign the exact reversals in turn, the first one so that it brings phi back toward zero."""
    before = turning[: reversals[0]].sum()
    first = -np.pi if before > EXACT else np.pi
    turning[reversals] = first * (-1.0) ** np.arange(len(reversals))
