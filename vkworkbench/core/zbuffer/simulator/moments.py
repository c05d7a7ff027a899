# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide the extended z-buffer after any number of simulated trajectories.

The ray of each pixel consists of dexels, which are segments inside the part, and of trace elements, which are segments
that trajectories removed. An earlier state of the part is restored by adding the trace elements that later trajectories
remove to the dexels. A moment of the simulation is given as the number of trajectories simulated before it.
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
    """The material that given trajectories remove (chips), as seen in an image without the rest of the part.

    Attributes
    ----------
    depth, far : (pixels,) float32
        Depths at which the removed material begins and ends on each ray, mm; NaN for a ray without removed material.
    owner : (pixels,) int32
        Trajectory that removes the segment nearest to the eye on each ray; `STOCK` for a ray without removed material.
    """

    depth: np.ndarray
    far: np.ndarray
    owner: np.ndarray


@dataclass(frozen=True, eq=False)
class ZBuffer:
    """An image of rays cut by toolpaths, after a given number of simulated trajectories.

    Attributes
    ----------
    frame : Frame
        Axes, centre and pixel of the image.
    cuts : Cuts
        The toolpaths that cut the stock.
    step : int
        The moment of the simulation, as the number of simulated trajectories.
    records : Records
        The segments of all rays, for all moments of the simulation.
    surface : Surface
        The visible surfaces at any moment of the simulation.
    candidates : int
        How many times a trajectory was tested against a tile or a pixel. The number of tests depends slightly on the
        number of processes.
    peak : Peak
        The quantities that determined the peak memory of the simulation, including its pictures.
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
        """Number of all trajectories, including trajectories that are not yet simulated at this moment."""
        return len(self.cuts)

    @property
    def picture(self) -> Picture:
        """Depth of the visible surface at this moment of the simulation, and trajectory that cut it, by pixel."""
        return self.surface.picture(self.step)

    @cached_property
    def dexel_records(self) -> np.ndarray:
        """(d,) ndarray of DEXEL : the dexels at this moment, including material that later trajectories remove."""
        return self.records.dexels(self.step)

    @cached_property
    def trace_records(self) -> np.ndarray:
        """(m,) ndarray of TRACE : the segments that all trajectories remove, sorted by pixel and depth."""
        return self.records.traces()

    @cached_property
    def trace_index(self) -> np.ndarray:
        """(pixels + 1,) ndarray of INDEX : first element of each pixel in `trace_records`."""
        return self.records.trace_index()

    @property
    def dexels(self) -> int:
        """Number of dexels at this moment of the simulation."""
        return len(self.dexel_records)

    @property
    def traces(self) -> int:
        """Number of trace elements that trajectories before this moment of the simulation removed."""
        return int(np.count_nonzero(self.records.cut & (self.records.owner < self.step)))

    @property
    def memory_bytes(self) -> int:
        """Memory for all dexels, trace elements and gaps, including trace elements removed after this moment, bytes."""
        return self.records.nbytes

    @property
    def part_volume(self) -> float:
        """Volume of the part at this moment of the simulation, mm^3."""
        return _length(self.dexel_records) * self.frame.pixel**2

    @property
    def chip_volume(self) -> float:
        """Volume removed before this moment of the simulation, mm^3."""
        return _length(self.trace_records[self.trace_records["trajectory"] < self.step]) * self.frame.pixel**2

    def chips(self, first: int, end: int) -> Chips:
        """Return the material that the given trajectories remove, as seen without the rest of the part.

        Parameters
        ----------
        first, end : int
            Number of the first trajectory, and number of the last trajectory plus 1.

        Raises
        ------
        ValueError, TypeError
            See :meth:`at`.
        """
        first, end = self._moment("first", first), self._moment("end", end)
        records, pixels = self.records, self.frame.width * self.frame.height
        segments = np.flatnonzero((records.owner >= first) & (records.owner < end))
        pixel = np.searchsorted(records.index, segments, side="right") - 1
        nearest = np.ones(len(segments) + 1, bool)
        nearest[1:-1] = pixel[1:] != pixel[:-1]
        farthest = nearest[1:]
        depth, far = np.full((2, pixels), np.nan, np.float32)
        owner = np.full(pixels, STOCK, np.int32)
        far[pixel[farthest]] = records.far[segments[farthest]]
        segments, pixel = segments[nearest[:-1]], pixel[nearest[:-1]]
        inner = segments > records.index[pixel]
        depth[pixel] = np.where(inner, records.far[segments - 1], records.entry[pixel])
        owner[pixel] = records.owner[segments]
        return Chips(depth, far, owner)

    def removers(self, pixels: np.ndarray, depth: np.ndarray) -> np.ndarray:
        """Return, for each given ray, the trajectory that removed the stock at the ray's given depth.

        Parameters
        ----------
        pixels : (k,) int64
            Pixel of each ray, as the index row * width + column.
        depth : (k,) float32
            Given depth on each ray, measured along the view, mm.

        Returns
        -------
        (k,) int32
            The trajectories; `STOCK` where no trajectory removed material before this moment.
        """
        records = self.records
        first, end = (records.index[pixels + at].astype(np.int64) for at in (0, 1))
        segment = first_not_below(records.far, first, end, depth)
        removed = np.flatnonzero((segment < end) & (depth > records.entry[pixels]))
        owner = records.owner[segment[removed]]
        found = np.full(len(pixels), STOCK, np.int32)
        found[removed] = np.where(owner < self.step, owner, STOCK)
        return found

    def at(self, step: int) -> ZBuffer:
        """Return the z-buffer at another moment of the simulation.

        Parameters
        ----------
        step : int
            Number of simulated trajectories, from 0 (the uncut stock) to `trajectories` (the finished part). For the
            moment before the operation `i`, `step` is ``cuts.first[i]``.

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
