# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the removed volume, removal rate, depth of cut and width of cut of each trajectory from its trace."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer.findings.volumes import Volumes
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

# Depth and width of cut are computed only in views in which the cosine of the angle to the vertical is at least this
# value; in other views, which are from the side, they are 0.
_FROM_THE_SIDE = 0.3


def removed_volumes(zbuffer: ZBuffer) -> np.ndarray:
    """Return the volume that each trajectory removes.

    Parameters
    ----------
    zbuffer : ZBuffer
        The finished simulation, or any moment of it. The volumes are always the volumes of the whole simulation.

    Returns
    -------
    (n,) float64
        Removed volumes, mm^3.
    """
    return zbuffer.records.lengths * zbuffer.frame.pixel**2


def removal_rates(zbuffer: ZBuffer, measured: Volumes | None = None) -> np.ndarray:
    """Return the material removal rate of each trajectory.

    Parameters
    ----------
    measured : Volumes, optional
        Measured volumes. Without measured volumes, the volumes are computed from the image.

    Returns
    -------
    (n,) float64
        Removal rates, mm^3/min; NaN for trajectories without a feed rate.
    """
    seconds = zbuffer.cuts.seconds
    volumes = removed_volumes(zbuffer) if measured is None else measured.each
    return 60 * volumes / np.where(seconds > 0, seconds, np.nan)


def cuts_air(zbuffer: ZBuffer, measured: Volumes | None = None) -> np.ndarray:
    """Return whether each trajectory is a feed move that removes nothing.

    A move shorter than two pixels can remove material that no ray meets. Therefore consecutive moves are joined into
    stretches with a length of two pixels, and all moves in a stretch get the same result. The image cannot distinguish
    passes that are closer to each other than a pixel; for such passes, use smaller pixels or measured volumes.

    Parameters
    ----------
    measured : Volumes, optional
        Measured volumes. A move with a measured volume above 0 counts as cutting, even if no ray of the image meets the
        removed material.

    Returns
    -------
    (n,) bool
    """
    cuts = zbuffer.cuts
    volumes = removed_volumes(zbuffer)
    if measured is not None:
        volumes = np.maximum(volumes, measured.each)
    length, volumes = np.where(cuts.rapid, 0.0, (cuts.lengths, volumes))
    stretch = np.floor((np.cumsum(length) - length / 2) / (2 * zbuffer.frame.pixel)).astype(np.int64)
    # A rapid begins a new stretch of joined moves, and so does the first trajectory of an operation.
    begins = cuts.rapid.copy()
    begins[1:] |= (np.diff(cuts.cut) != 0) | (np.diff(stretch) != 0)
    group = np.cumsum(begins)
    return ~cuts.rapid & (np.bincount(group, volumes)[group] == 0)


def engagement(zbuffer: ZBuffer, measured: Volumes | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Return the depth and width of cut of each trajectory.

    The depth is the height of the tallest segment that the trajectory removes from a ray. The width is the removed
    volume divided by the depth and by the move's horizontal length, but at most the tool's diameter. The width of a
    plunge is 0.

    Parameters
    ----------
    measured : Volumes, optional
        Measured volumes and depths. Without `measured`, volumes and depths are computed from the image.

    Returns
    -------
    depth, width : (n,) float64
        Depth and width, mm; 0 for trajectories that remove nothing. Without measured volumes, depth and width are 0 in
        a view from the side.
    """
    cuts = zbuffer.cuts
    if measured is None:
        depth, volumes = _depths_in(zbuffer), removed_volumes(zbuffer)
    else:
        depth, volumes = measured.depths, measured.each
    width = np.zeros(len(cuts))
    start, end = cuts.ends
    run = np.hypot(*(end - start)[:, :2].T)
    cut = np.flatnonzero((depth > 0) & (run > 0))
    diameter = np.array([own.tool.diameter for own in cuts.cuts])[cuts.cut[cut]]
    width[cut] = np.minimum(volumes[cut] / (depth[cut] * run[cut]), diameter)
    return depth, width


def _depths_in(zbuffer: ZBuffer) -> np.ndarray:
    """Return the height of the tallest segment that each trajectory removes from a ray, (n,) mm.

    The heights are 0 in a view from the side.
    """
    depth = np.zeros(zbuffer.trajectories)
    steep = abs(float(zbuffer.frame.direction[2]))
    if steep < _FROM_THE_SIDE:
        return depth
    for _, _, block in zbuffer.records.blocks():
        segments = np.flatnonzero(block.cut)
        np.maximum.at(
            depth, block.owner[segments], (block.far[segments].astype(float) - block.near()[segments]) * steep
        )
    return depth


def trajectory_table(zbuffer: ZBuffer, measured: Volumes | None = None) -> dict[str, np.ndarray]:
    """Return quantities of each trajectory, such as length and removed volume, as columns (n,) of a table.

    Parameters
    ----------
    measured : Volumes, optional
        Measured volumes and depths. Without `measured`, volumes and depths are computed from the image.

    Returns
    -------
    dict of ndarray
        ``cut`` and ``command``: numbers of the operation and of the command to which each trajectory belongs;
        ``rapid``: True for a rapid; ``length``, mm; ``seconds``, s, 0 if the feed is unknown; ``removed_volume``, mm^3;
        ``rate``: removal rate, mm^3/min, NaN if the feed is unknown; ``air``: True for a feed move that removes
        nothing; ``depth`` and ``width`` of cut, mm; ``tool_diameter``, mm.
    """
    cuts = zbuffer.cuts
    depth, width = engagement(zbuffer, measured)
    diameters = np.array([cut.tool.diameter for cut in cuts.cuts])
    return {
        "cut": cuts.cut,
        "command": cuts.command,
        "rapid": cuts.rapid,
        "length": cuts.lengths,
        "seconds": cuts.seconds,
        "removed_volume": removed_volumes(zbuffer) if measured is None else measured.each,
        "rate": removal_rates(zbuffer, measured),
        "air": cuts_air(zbuffer, measured),
        "depth": depth,
        "width": width,
        "tool_diameter": diameters[cuts.cut],
    }
