# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the numbers of dexels and trace elements of a simulation from a few hundred rays.

A dexel is a segment of a ray inside the part. A trace element is a segment of a ray that a trajectory removes. The
sampled rays are simulated exactly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.culling.tiles import TILE
from vkworkbench.core.zbuffer.memory.sampling import sample
from vkworkbench.core.zbuffer.memory.silhouette import seen_areas
from vkworkbench.core.zbuffer.rays.dexels import UNCUT, Segments
from vkworkbench.core.zbuffer.rays.records import GAP
from vkworkbench.core.zbuffer.rays.removal import Removal

# Seed of the random sample. With a fixed seed, the add-on's window and a user's macro get equal estimates.
_SEED = 2002


@dataclass(frozen=True)
class Counts:
    """Estimated numbers of records, which are dexels, trace elements and gaps in the stock.

    Attributes
    ----------
    stock, gaps : float
        Number of dexels of the uncut stock, and number of segments of rays in gaps in the stock. Each segment of a ray
        in a gap is stored as a record.
    dexels : float
        Number of dexels at the end of the simulation.
    traces, traces_error : float
        Number of trace elements, and its standard error.
    touched : float
        Number of pixels whose ray at least one trajectory cuts.
    passes : float
        Number of pairs of a pixel and a trajectory whose swept volume the pixel's ray meets, including trajectories
        that remove nothing from the ray.
    unconnected : float
        Share of `passes` on rays whose removed intervals are not connected. The simulator sorts the removed intervals
        only on these rays; see `chains.py`.
    band : float
        Number of dexels, trace elements and gaps in the fullest band of `TILE` pixel rows.
    pixels : int
        Number of pixels in the image.
    """

    stock: float
    gaps: float
    dexels: float
    traces: float
    traces_error: float
    touched: float
    passes: float
    unconnected: float
    band: float
    pixels: int

    @property
    def records(self) -> float:
        """Number of dexels, trace elements and gaps at the end of the simulation."""
        return self.dexels + self.traces + self.gaps


def count(removal: Removal) -> Counts:
    """Estimate the numbers of records (dexels, trace elements and gaps) of a simulation.

    The order of the trajectories determines how often a pixel is cut (paper, section 2.1). Therefore the sampled rays
    are cut in the order of the NC program.

    Returns
    -------
    Counts
        Equal arguments give equal counts.
    """
    frame = removal.frame
    rng = np.random.default_rng(_SEED)
    rays = sample(removal, rng)
    segments, passes = removal.cut(rays.x, rays.y)
    # In the uncut stock, a ray has one dexel, and one additional dexel for every gap in the stock.
    held = np.bincount(segments.ray, minlength=len(rays.x))
    empty = np.bincount(segments.ray[segments.owner == GAP], minlength=len(rays.x))
    parts = np.bincount(segments.ray[segments.owner == UNCUT], minlength=len(rays.x))
    cuts = held - empty - parts
    first = empty + (held > 0)
    per_area = 1 / frame.pixel**2

    covered, gaps = seen_areas(removal.stock, frame, rng)
    # A ray that is cut to its end has fewer dexels than in the uncut stock. A ray that is cut in the middle of a dexel
    # has more dexels than in the uncut stock.
    more, _ = rays.total(parts - first)
    more = max(more, -covered)  # rounding errors must not make the number of dexels negative
    traces, error = rays.total(cuts)
    passed, _ = rays.total(passes)
    unconnected, _ = rays.total(passes * _unconnected(segments, len(rays.x)))
    band = np.floor((rays.y / frame.pixel + frame.height / 2) / TILE).astype(np.int64)
    bands = np.bincount(np.maximum(band, 0), held * rays.area, minlength=1)
    return Counts(
        covered * per_area,
        gaps * per_area,
        (covered + more) * per_area,
        traces * per_area,
        error * per_area,
        rays.total(cuts > 0)[0] * per_area,
        passed * per_area,
        unconnected / passed if passed else 0.0,
        float(bands.max()) * per_area,
        frame.width * frame.height,
    )


def _unconnected(segments: Segments, rays: int) -> np.ndarray:
    """Return whether the removed intervals of each ray are not connected, (rays,) bool.

    The removed intervals of a ray are not connected if a segment between two other segments was removed later than
    both, so that its owner (the removing trajectory) is greater than both neighbours' owners. A segment that no
    trajectory removes has the greatest owner, `UNCUT`.
    """
    owner, ray = segments.owner, segments.ray
    peak = np.flatnonzero((owner[1:-1] > owner[:-2]) & (owner[1:-1] > owner[2:]) & (ray[2:] == ray[:-2]))
    return np.bincount(ray[peak], minlength=rays) > 0
