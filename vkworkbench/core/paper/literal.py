# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the strategy of a toolpath by the paper's own rule, for comparison with the recognised strategy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper.areas import Areas
from vkworkbench.core.paper.directions import TURN, farthest, top_level, turns
from vkworkbench.core.paper.signature import NO_LENGTH
from vkworkbench.core.paper.thresholds import TURNS
from vkworkbench.core.strategy import Strategy


@dataclass(frozen=True)
class PaperVerdict:
    """The result of the paper's rule for the longest monotonous area (sections 3.1 and 3.2).

    Attributes
    ----------
    strategy : Strategy
        CONTOUR_PARALLEL if abs(phi) exceeds 2 pi, ZIGZAG if abs(phi) never exceeds pi, otherwise UNKNOWN, because
        section 3.2 does not decide between pi and 2 pi. (By the level in section 3.1, areas below 2 pi are zigzags, and
        areas at 2 pi are contours.)
    area : int
        Index of the longest area, to which the rule is applied, in :class:`Areas`.
    level : int
        Level (number of whole turns in phi) farthest from zero.
    phi_range : tuple of float
        Lowest and highest phi, rad, counted from the first trajectory, without the closing turn (last move to first).
    v : tuple of float
        V_k (the sum of the first k trajectories) at the last trajectory, in the working plane, mm.
    theta_range : tuple of float
        Lowest and highest theta (the direction of V_k), rad, made continuous by removing jumps of 2 pi.
    sense : str or None
        "ccw" or "cw" if the image of V_k on the unit circle moves in one sense only; None if the image moves back and
        forth, as the paper expects for a zigzag. (For a contour, the paper expects that the image goes all around the
        circle, but the image does so only if the path starts inside the contour.)
    """

    strategy: Strategy
    area: int
    level: int
    phi_range: tuple[float, float]
    v: tuple[float, float]
    theta_range: tuple[float, float]
    sense: str | None

    @property
    def image(self) -> tuple[float, float]:
        """Gaussian image of V_k, a point of the unit circle; (0, 0) if V_k is 0."""
        length = float(np.hypot(*self.v))
        return (self.v[0] / length, self.v[1] / length) if length >= NO_LENGTH else (0.0, 0.0)


def paper_verdict(areas: Areas) -> PaperVerdict | None:
    """Return the strategy of the longest monotonous area by the paper's rule; None if no move has a direction."""
    if not len(areas):
        return None
    area = int(np.argmax(areas.area_length))
    found = areas.signature(area)
    low, high = areas.signed_extremes
    phi_range = float(low[area]), float(high[area])
    reached = abs(farthest(phi_range))
    strategy = Strategy.UNKNOWN
    if reached > TURN + TURNS.EXACT:
        strategy = Strategy.CONTOUR_PARALLEL
    elif reached <= np.pi + TURNS.EXACT:
        strategy = Strategy.ZIGZAG
    theta = found.theta
    turned = np.append(0.0, turns(theta))
    image = np.cumsum(turned)
    net, both_ways = float(image[-1]), float(np.abs(turned).sum())
    theta_range = float(image.min() + theta[0]), float(image.max() + theta[0])
    sense = None
    if both_ways > TURNS.EXACT and both_ways - abs(net) <= 2 * TURNS.BACK_AND_FORTH * both_ways:
        sense = "ccw" if net > 0 else "cw"
    return PaperVerdict(
        strategy,
        area,
        top_level(phi_range),
        phi_range,
        (float(found.x[-1] + found.dx[-1] - found.x[0]), float(found.y[-1] + found.dy[-1] - found.y[0])),
        theta_range,
        sense,
    )
