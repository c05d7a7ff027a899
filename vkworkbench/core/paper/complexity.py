# SPDX-License-Identifier: LGPL-2.1-or-later
"""How complex the contour of a polyline is, told by its turns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper.directions import TURN
from vkworkbench.core.paper.signature import signature


@dataclass(frozen=True)
class Complexity:
    """The turns of a polyline; those of a closed one include the turn from its last trajectory into its first.

    Attributes
    ----------
    total_turning : float
        Sum of the turns, each without its sign, rad: 2 pi for a convex contour, more for every dent. It is the total
        curvature of the polyline (Milnor 1950), and not `Signature.total_turning`, which is the net turning.
    net_turning : float
        Sum of the turns with their signs, rad: the cumulative angular function phi at the end.
    windings : float
        Net turns in full turns: the paper's level before it is cut to an integer; 1 for a closed contour that does not
        cross itself, counter-clockwise, -1 clockwise.
    """

    total_turning: float
    net_turning: float
    windings: float


def complexity(points: np.ndarray) -> Complexity:
    """Measure the complexity of a polyline by its directions alone, in O(n).

    The paper proposes it: the method "could be applied in many other fields to evaluate the complexity of a curve by
    studying the features of its contour" (section 4).

    Parameters
    ----------
    points : (n+1, 2) or (n+1, 3) array_like of float
        As for :func:`signature`.

    Returns
    -------
    Complexity
        It does not depend on the polyline's place, rotation, and size, as long as its trajectories are longer than a
        millionth of a micrometre; traversed the other way round, the net turning and the windings change their signs,
        but for half turns, which have none.

    Raises
    ------
    ValueError
        As :func:`signature`.

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
