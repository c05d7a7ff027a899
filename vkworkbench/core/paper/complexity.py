# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the complexity of a polyline by its turns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper.directions import TURN
from vkworkbench.core.paper.signature import signature


@dataclass(frozen=True)
class Complexity:
    """The sums of the turns of a polyline.

    If a polyline is closed, the sums include the turn from its last trajectory into its first.

    Attributes
    ----------
    total_turning : float
        Sum of the absolute turns, rad (the total curvature of Milnor 1950). The sum is 2 pi for a convex contour, and
        every dent increases the sum. `Signature.total_turning`, by contrast, is the net turning.
    net_turning : float
        Sum of the turns with their signs, rad: the cumulative angular function phi at the end.
    windings : float
        Net turning as a number of full turns: 1 for a counter-clockwise closed contour that does not cross itself, -1
        for a clockwise contour that does not cross itself. The paper's level is the net turning in full turns,
        truncated toward zero.
    """

    total_turning: float
    net_turning: float
    windings: float


def complexity(points: np.ndarray) -> Complexity:
    """Measure the complexity of a polyline from its directions alone, in O(n).

    The paper proposes this measure: the method "could be applied in many other fields to evaluate the complexity of a
    curve by studying the features of its contour" (section 4).

    Parameters
    ----------
    points : (n+1, 2) or (n+1, 3) array_like of float
        Vertices of the polyline, as for :func:`signature`.

    Returns
    -------
    Complexity
        The values do not depend on the polyline's position, rotation and size, if its trajectories are longer than 1e-9
        mm. If the polyline is traversed in the other direction, the net turning and the windings change their signs,
        except for the contributions of half turns, which have no sign.

    Raises
    ------
    ValueError
        If :func:`signature` rejects the points.

    Examples
    --------
    >>> square = complexity([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    >>> round(square.total_turning / np.pi, 9), round(square.windings, 9)
    (2.0, 1.0)
    """
    found = signature(points)
    closing = found.total_turning - float(found.phi[-1]) if len(found) else 0.0
    total = float(np.abs(found.turning).sum()) + abs(closing)
    return Complexity(total, found.total_turning, found.total_turning / TURN)
