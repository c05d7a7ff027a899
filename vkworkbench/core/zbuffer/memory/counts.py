# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of dexels and trace elements of a simulation, estimated from a few hundred rays that are simulated exactly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.culling.tiles import TILE
from vkworkbench.core.zbuffer.memory.sampling import sample
from vkworkbench.core.zbuffer.memory.silhouette import seen_areas
from vkworkbench.core.zbuffer.rays.dexels import UNCUT, Pieces
from vkworkbench.core.zbuffer.rays.records import GAP
from vkworkbench.core.zbuffer.rays.removal import Removal

# Fixed seed, so that the window and a macro give the same numbers.
_SEED = 2002


@dataclass(frozen=True)
class Counts:
    """Estimated numbers of records.

    Attributes
    ----------
    stock, gaps : float
        Dexels of the uncut stock, and pieces of rays in its gaps. Gaps are kept as records.
    dexels : float
        Dexels at the end.
    traces, traces_error : float
        Elements of the traces, and the standard error of their number.
    touched : float
        Pixels that are cut.
    passes : float
        Pairs of a pixel and a trajectory that passes it, including pairs that remove nothing.
    unconnected : float
        Share of `passes` on rays whose intervals are not connected. The intervals of these rays are sorted, see `chains.py`.
    band : float
        Records of the band of `TILE` rows with the most records.
    pixels : int
        Pixels of the image.
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
        """Number of dexels, elements of traces and gaps at the end."""
        return self.dexels + self.traces + self.gaps


def count(removal: Removal) -> Counts:
    """Estimate the records of a simulation.

    The order of the trajectories determines how often a pixel is cut (paper, section 2.1). The sampled rays are cut in this order.

    Parameters
    ----------
    removal : Removal

    Returns
    -------
    Counts
        Equal for equal arguments.
    """
    frame = removal.frame
    rng = np.random.default_rng(_SEED)
    rays = sample(removal, rng)
    pieces, passes = removal.cut(rays.x, rays.y)
    # An uncut ray has one dexel, and one more behind every gap of the stock.
    held = np.bincount(pieces.ray, minlength=len(rays.x))
    empty = np.bincount(pieces.ray[pieces.owner == GAP], minlength=len(rays.x))
    parts = np.bincount(pieces.ray[pieces.owner == UNCUT], minlength=len(rays.x))
    cuts = held - empty - parts
    first = empty + (held > 0)
    per_area = 1 / frame.pixel**2

    covered, gaps = seen_areas(removal.stock, frame, rng)
    # Rays may end with fewer dexels (cut through) or with more (cut in the middle).
    more, _ = rays.total(parts - first)
    more = max(more, -covered)  # if everything is cut away, rounding can make the sum negative
    traces, error = rays.total(cuts)
    passed, _ = rays.total(passes)
    unconnected, _ = rays.total(passes * _unconnected(pieces, len(rays.x)))
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


def _unconnected(pieces: Pieces, rays: int) -> np.ndarray:
    """Return the rays (rays,) bool whose intervals are not connected: the owner has a maximum inside the ray (`UNCUT` is largest)."""
    owner, ray = pieces.owner, pieces.ray
    peak = np.flatnonzero((owner[1:-1] > owner[:-2]) & (owner[1:-1] > owner[2:]) & (ray[2:] == ray[:-2]))
    found: np.ndarray = np.bincount(ray[peak], minlength=rays) > 0
    return found
