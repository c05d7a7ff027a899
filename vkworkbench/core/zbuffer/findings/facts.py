# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facts on each trajectory from its trace: volume, removal rate, depth and width of cut."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

# Smallest cosine of the view's tilt from the vertical. In flatter views the depth and width of cut are unknown.
_FROM_THE_SIDE = 0.3


def removed_volumes(zbuffer: ZBuffer) -> np.ndarray:
    """Return the volume that each trajectory removes.

    Parameters
    ----------
    zbuffer : ZBuffer
        The volumes cover the whole simulation, whatever the moment.

    Returns
    -------
    (n,) float64
        mm^3.
    """
    return zbuffer.records.lengths * zbuffer.frame.pixel**2


def removal_rates(zbuffer: ZBuffer) -> np.ndarray:
    """Return the material removal rate of each trajectory.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    (n,) float64
        mm^3/min; NaN for trajectories without a feed rate.
    """
    seconds = zbuffer.cuts.seconds
    return 60 * removed_volumes(zbuffer) / np.where(seconds > 0, seconds, np.nan)


def cuts_air(zbuffer: ZBuffer) -> np.ndarray:
    """Return which feed moves remove nothing.

    A move shorter than two pixels may pass between the rays. Therefore consecutive moves are joined into stretches of two
    pixels, and all moves of a stretch get the same answer. Passes closer than a pixel cannot be distinguished; they need
    a finer image.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    (n,) bool
    """
    cuts = zbuffer.cuts
    length, volumes = np.where(cuts.rapid, 0.0, (cuts.lengths, removed_volumes(zbuffer)))
    stretch = np.floor((np.cumsum(length) - length / 2) / (2 * zbuffer.frame.pixel)).astype(np.int64)
    # A rapid or the next cut begins a new stretch.
    begins = cuts.rapid.copy()
    begins[1:] |= (np.diff(cuts.cut) != 0) | (np.diff(stretch) != 0)
    group = np.cumsum(begins)
    result: np.ndarray = ~cuts.rapid & (np.bincount(group, volumes)[group] == 0)
    return result


def engagement(zbuffer: ZBuffer) -> tuple[np.ndarray, np.ndarray]:
    """Return the depth and width of cut of each trajectory.

    The depth is the height of the highest piece that the trajectory removes. The width is the removed volume divided by depth and
    length, at most the tool's diameter; a plunge has the width 0.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    depth, width : (n,) float64
        mm; 0 for trajectories that remove nothing, and for all trajectories in a view from the side.
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
    """Return the facts on each trajectory as columns (n,) of a table.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    dict of ndarray
        ``cut`` and ``command``: the origin; ``rapid``; ``length`` mm; ``seconds``, 0 if the feed is unknown;
        ``removed_volume`` mm^3; ``rate`` mm^3/min, NaN without a feed; ``air``: True for a feed move that removes
        nothing; ``depth`` and ``width`` of cut, mm; ``tool_diameter`` mm.
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
