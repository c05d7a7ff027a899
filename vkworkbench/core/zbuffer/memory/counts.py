# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many dexels and trace elements a simulation ends with, from some hundred rays simulated exactly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.culling.tiles import TILE
from vkworkbench.core.zbuffer.memory.sampling import sample
from vkworkbench.core.zbuffer.memory.silhouette import seen_areas
from vkworkbench.core.zbuffer.rays.dexels import UNCUT, Pieces
from vkworkbench.core.zbuffer.rays.records import GAP
from vkworkbench.core.zbuffer.rays.removal import Removal

# The same rays every time: a click and a macro give the same numbers.
_SEED = 2002


@dataclass(frozen=True)
class Counts:
    """Numbers of records, estimated.

    Attributes
    ----------
    stock, gaps : float
        Dexels of the uncut stock, and pieces of rays in its gaps, which stay.
    dexels : float
        Dexels at the end.
    traces, traces_error : float
        Elements of the traces, and one standard error of their number.
    touched : float
        Pixels that something cuts.
    passes : float
        Pairs of a pixel and a trajectory that passes it, whether or not anything is left to cut.
    unconnected : float
        Share of `passes` that are of rays whose removals do not connect: these are sorted (`chains.py`).
    band : float
        Records of the fullest band of `TILE` rows.
    pixels : int
        Of the image.
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
        """Dexels, elements of traces and gaps that the z-buffer holds at the end."""
        return self.dexels + self.traces + self.gaps


def count(removal: Removal) -> Counts:
    """Estimate the records of a simulation.

    The sequence of the trajectories decides how often a pixel is cut (paper, section 2.1); the rays see that sequence.

    Parameters
    ----------
    removal : Removal

    Returns
    -------
    Counts
        The same for the same arguments.
    """
    frame = removal.frame
    rng = np.random.default_rng(_SEED)
    rays = sample(removal, rng)
    pieces, passes = removal.cut(rays.x, rays.y)
    # A ray begins with a dexel, and one more behind every gap of the stock.
    held = np.bincount(pieces.ray, minlength=len(rays.x))
    empty = np.bincount(pieces.ray[pieces.owner == GAP], minlength=len(rays.x))
    parts = np.bincount(pieces.ray[pieces.owner == UNCUT], minlength=len(rays.x))
    cuts = held - empty - parts
    first = empty + (held > 0)
    per_area = 1 / frame.pixel**2

    covered, gaps = seen_areas(removal.stock, frame, rng)
    # Where a ray was cut through or through a wall: fewer or more dexels than it began with.
    more, _ = rays.total(parts - first)
    more = max(more, -covered)  # where everything is cut away, rounding leaves less than nothing
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
    """(rays,) bool: whose gap did not only grow. Owners then rise and fall again along the ray, or what is left parts them."""
    owner, ray = pieces.owner, pieces.ray
    peak = np.flatnonzero((owner[1:-1] > owner[:-2]) & (owner[1:-1] > owner[2:]) & (ray[2:] == ray[:-2]))  # behind each
    found: np.ndarray = np.bincount(ray[peak], minlength=rays) > 0
    return found
