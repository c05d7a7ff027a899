# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer at any moment of the simulation.

The ray of each pixel has the dexels of the part and the elements of the traces, which are the pieces removed by trajectories.
Joining traces to dexels again restores any earlier moment.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.memory.memory import Peak
from vkworkbench.core.zbuffer.rays.records import Records, first_not_below
from vkworkbench.core.zbuffer.rays.surface import STOCK, Picture, Surface
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.given import whole


class Chips(NamedTuple):
    """Removed material in an image.

    Attributes
    ----------
    depth, far : (pixels,) float32
        Depths of its nearest and its farthest end, mm; NaN for a ray without removed material.
    owner : (pixels,) int32
        Trajectory that removes the nearest piece; `STOCK` for a ray without removed material.
    """

    depth: np.ndarray
    far: np.ndarray
    owner: np.ndarray


@dataclass(frozen=True, eq=False)
class ZBuffer:
    """An image of rays cut by toolpaths, at one moment of the simulation.

    Attributes
    ----------
    frame : Frame
        Axes, centre and pixel of the image.
    cuts : Cuts
        The toolpaths that cut the stock.
    step : int
        The moment, in simulated trajectories.
    records : Records
        The pieces of all rays.
    surface : Surface
        The visible surfaces at any moment.
    candidates : int
        Number of pairs of a tile or pixel and a trajectory that were tested. It depends slightly on the number of processes.
    peak : Peak
        Peak memory, including pictures.
    """

    frame: Frame
    cuts: Cuts
    step: int
    records: Records
    surface: Surface
    candidates: int
    peak: Peak

    @property
    def trajectories(self) -> int:
        """Number of all trajectories."""
        return len(self.cuts)

    @property
    def picture(self) -> Picture:
        """Depth and owner of the visible surface at this moment, for every pixel."""
        return self.surface.picture(self.step)

    @cached_property
    def dexel_records(self) -> np.ndarray:
        """(d,) ndarray of DEXEL : the dexels at this moment, including material that later trajectories remove."""
        return self.records.dexels(self.step)

    @cached_property
    def trace_records(self) -> np.ndarray:
        """(m,) ndarray of TRACE : the pieces that all trajectories remove, sorted by pixel and depth."""
        return self.records.traces()

    @cached_property
    def trace_index(self) -> np.ndarray:
        """(pixels + 1,) ndarray of INDEX : first element of each pixel in `trace_records`."""
        return self.records.trace_index()

    @property
    def dexels(self) -> int:
        """Number of dexels at this moment."""
        return len(self.dexel_records)

    @property
    def traces(self) -> int:
        """Number of trace elements at this moment."""
        return int(np.count_nonzero(self.records.cut & (self.records.owner < self.step)))

    @property
    def memory_bytes(self) -> int:
        """Memory of records and index, including traces of later moments, bytes."""
        return self.records.nbytes

    @property
    def part_volume(self) -> float:
        """Volume of the part at this moment, mm^3."""
        return _length(self.dexel_records) * self.frame.pixel**2

    @property
    def chip_volume(self) -> float:
        """Volume removed before this moment, mm^3."""
        return _length(self.trace_records[self.trace_records["trajectory"] < self.step]) * self.frame.pixel**2

    def chips(self, first: int, end: int) -> Chips:
        """Return the material that some trajectories remove, seen alone.

        Parameters
        ----------
        first, end : int
            The trajectories first .. end - 1.

        Raises
        ------
        ValueError, TypeError
            See :meth:`at`.
        """
        first, end = self._moment("first", first), self._moment("end", end)
        records, pixels = self.records, self.frame.width * self.frame.height
        pieces = np.flatnonzero((records.owner >= first) & (records.owner < end))
        pixel = np.searchsorted(records.index, pieces, side="right") - 1
        nearest = np.ones(len(pieces) + 1, bool)
        nearest[1:-1] = pixel[1:] != pixel[:-1]
        farthest = nearest[1:]
        depth, far = np.full((2, pixels), np.nan, np.float32)
        owner = np.full(pixels, STOCK, np.int32)
        far[pixel[farthest]] = records.far[pieces[farthest]]
        pieces, pixel = pieces[nearest[:-1]], pixel[nearest[:-1]]
        inner = pieces > records.index[pixel]
        depth[pixel] = np.where(inner, records.far[pieces - 1], records.entry[pixel])
        owner[pixel] = records.owner[pieces]
        return Chips(depth, far, owner)

    def removers(self, pixels: np.ndarray, depth: np.ndarray) -> np.ndarray:
        """Return the trajectory that removed the stock at a depth of each ray.

        Parameters
        ----------
        pixels : (k,) int64
        depth : (k,) float32
            mm along the view.

        Returns
        -------
        (k,) int32
            `STOCK` where no trajectory before this moment removed material.
        """
        records = self.records
        first, end = (records.index[pixels + at].astype(np.int64) for at in (0, 1))
        piece = first_not_below(records.far, first, end, depth)
        removed = np.flatnonzero((piece < end) & (depth > records.entry[pixels]))
        owner = records.owner[piece[removed]]
        found = np.full(len(pixels), STOCK, np.int32)
        found[removed] = np.where(owner < self.step, owner, STOCK)
        return found

    def at(self, step: int) -> ZBuffer:
        """Return the simulation at another moment.

        Parameters
        ----------
        step : int
            Number of trajectories simulated, from 0 (the stock) to `trajectories` (the part); ``cuts.first[i]`` is the
            moment before cut `i`.

        Raises
        ------
        ValueError
            If `step` is negative or larger than the number of trajectories.
        TypeError
            If `step` is not an integer.
        """
        return replace(self, step=self._moment("step", step))

    def _moment(self, name: str, given: object) -> int:
        most = self.trajectories
        return whole(name, given, f"a whole number, 0 to {most}", lambda step: 0 <= step <= most)


def _length(records: np.ndarray) -> float:
    return float((records["far"].astype(float) - records["near"]).sum())
