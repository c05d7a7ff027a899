# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choose the view from above in which a job is checked, with the smallest useful pixel that the budgets allow."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import ceil

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer.cost.estimate import estimate_job
from vkworkbench.core.zbuffer.cost.resolution import best_resolution
from vkworkbench.core.zbuffer.cost.speed import USUAL, Speed
from vkworkbench.core.zbuffer.sweeps.cuts import Cut

# _FINE_ENOUGH: largest pixel, mm, with which crashes and deviations from the model are searched for. This largest pixel
# is half the default tolerance of the comparison with the model, so that a wall whose error exceeds the tolerance is
# displaced by more than a pixel.
# _OF_TOOL: upper limit for the side of a pixel, as a share of the thinnest tool's diameter.
_FINE_ENOUGH, _OF_TOOL = 0.05, 1 / 16
# Number of pixels along the longer side of the image for which the cost is estimated. The cost for images with smaller
# pixels is extrapolated.
_FIRST = 800
# Peak memory of the comparison with the model, as a multiple of the peak memory of the simulation.
_COMPARING = 1.6


def axis_view(cuts: Iterable[Cut], stock: Solid, *, memory_bytes: float, seconds: float, speed: Speed = USUAL) -> View:
    """Return the view from above with the smallest useful pixel for which the simulation stays within the budgets.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in machining order.
    memory_bytes, seconds : float
        Memory budget, bytes, and time budget of the simulation, s.
    speed : Speed
        Speed of this computer.

    Returns
    -------
    View
        The view has a single pixel if the budgets do not allow any image.
    """
    cuts = list(cuts)
    useful = min([_FINE_ENOUGH, *(_OF_TOOL * cut.tool.diameter for cut in cuts)])
    extent = (stock.upper - stock.lower)[:2]
    first = _image(extent, max(extent.max() / _FIRST, useful))
    estimate = estimate_job(cuts, stock=stock, view=first, speed=speed)
    best = best_resolution([estimate], memory_bytes=max(memory_bytes / _COMPARING, 1.0), seconds=seconds).view
    if best is None:
        return replace(first, width=1, height=1, pixel=None)
    return _image(extent, max(best.frame(stock).pixel, useful))


def _image(extent: np.ndarray, pixel: float) -> View:
    width, height = (max(1, ceil(side / pixel - 1e-9)) for side in extent.tolist())
    return View((0.0, 0.0, -1.0), width, height, pixel)
