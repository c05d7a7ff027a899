# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the traces tell of each trajectory: what it removes, how fast, how deep and how wide."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

# Views less steep than this cosine do not see how high a piece is.
_FROM_THE_SIDE = 0.3


def removed_volumes(zbuffer: ZBuffer) -> np.ndarray:
    """Volume that each trajectory removes, (n,) float64 mm^3.

    Parameters
    ----------
    zbuffer : ZBuffer
        Of any moment.
    """
    return zbuffer.records.lengths * zbuffer.frame.pixel**2


def removal_rates(zbuffer: ZBuffer) -> np.ndarray:
    """Volume that each trajectory removes in a minute, (n,) float64 mm^3/min; not a number for those without a feed.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    seconds = zbuffer.cuts.seconds
    return 60 * removed_volumes(zbuffer) / np.where(seconds > 0, seconds, np.nan)


def cuts_air(zbuffer: ZBuffer) -> np.ndarray:
    """Which feed moves remove nothing, (n,) bool.

    What is shorter than two pixels may pass between the rays: such moves are told together with their neighbours on so
    long a stretch. Passes closer than a pixel are not told apart at all: choose a finer image for them.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    cuts = zbuffer.cuts
    length, volumes = np.where(cuts.rapid, 0.0, (cuts.lengths, removed_volumes(zbuffer)))
    stretch = np.floor((np.cumsum(length) - length / 2) / (2 * zbuffer.frame.pixel)).astype(np.int64)
    # A rapid, and another cut, begin a new stretch.
    begins = cuts.rapid.copy()
    begins[1:] |= (np.diff(cuts.cut) != 0) | (np.diff(stretch) != 0)
    together = np.cumsum(begins)
    result: np.ndarray = ~cuts.rapid & (np.bincount(together, volumes)[together] == 0)
    return result


def engagement(zbuffer: ZBuffer) -> tuple[np.ndarray, np.ndarray]:
    """Depth and width of cut of each trajectory, two arrays (n,) float64 mm, 0 where it removes nothing.

    The depth is the height of the highest piece that it removes, the width what is missing to its volume; a plunge has
    no width. Neither is known where one looks from the side.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    n, cuts = zbuffer.trajectories, zbuffer.cuts
    depth, width = np.zeros((2, n))
    steep = abs(float(zbuffer.frame.direction[2]))
    if steep < _FROM_THE_SIDE:
        return depth, width
    for _, _, block in zbuffer.records.blocks():
        pieces = np.flatnonzero(block.cut)
        np.maximum.at(depth, block.owner[pieces], (block.far[pieces].astype(float) - block.near()[pieces]) * steep)
    start, end = cuts.ends
    run = np.hypot(*(end - start)[:, :2].T)
    cut = np.flatnonzero((depth > 0) & (run > 0))
    diameter = np.array([own.tool.diameter for own in cuts.cuts])[cuts.cut[cut]]
    width[cut] = np.minimum(removed_volumes(zbuffer)[cut] / (depth[cut] * run[cut]), diameter)
    return depth, width


def trajectory_table(zbuffer: ZBuffer) -> dict[str, np.ndarray]:
    """Tell what each trajectory does: columns (n,) of a table.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    dict of ndarray
        ``cut`` and ``command``: where it comes from; ``rapid``; ``length`` mm; ``seconds``, 0 where its speed is not
        known; ``removed_volume`` mm^3; ``rate`` mm^3/min, not a number without a feed; ``air``: whether it is a feed move
        that removes nothing; ``depth`` and ``width`` of cut, mm; ``tool_diameter`` mm.
    """
    cuts = zbuffer.cuts
    depth, width = engagement(zbuffer)
    diameters = np.array([cut.tool.diameter for cut in cuts.cuts])
    return {
        "cut": cuts.cut,
        "command": cuts.command,
        "rapid": cuts.rapid,
        "length": cuts.lengths,
        "seconds": cuts.seconds,
        "removed_volume": removed_volumes(zbuffer),
        "rate": removal_rates(zbuffer),
        "air": cuts_air(zbuffer),
        "depth": depth,
        "width": width,
        "tool_diameter": diameters[cuts.cut],
    }
