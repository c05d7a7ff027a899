# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer at any moment of the simulation.

Every pixel's ray holds the dexels of the part and the elements of the traces, the pieces the trajectories removed.
Traces glue the chips back on the part, so every moment of the simulation can be had again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.memory.memory import Peak
from vkworkbench.core.zbuffer.rays.records import Records
from vkworkbench.core.zbuffer.rays.surface import STOCK, Picture, Surface
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.given import whole


@dataclass(frozen=True, eq=False)
class ZBuffer:
    """An image of rays cut by toolpaths, at one moment of the simulation.

    Attributes
    ----------
    frame : Frame
        Axes, centre and pixel of the image.
    cuts : Cuts
        What it is cut by; tells where a trajectory comes from.
    step : int
        The moment: that many trajectories have been simulated.
    records : Records
        The pieces of all rays.
    surface : Surface
        The pieces of rays that are seen at some moment.
    candidates : int
        Pairs of a tile or pixel of the image and a trajectory that the simulation tested; a few more or less where
        several processes shared it.
    peak : Peak
        What decided the memory that it took, with pictures of it.
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
        """How many trajectories there are."""
        return len(self.cuts)

    @property
    def picture(self) -> Picture:
        """What is seen at this moment: depth and owner of the surface at every pixel."""
        return self.surface.picture(self.step)

    @cached_property
    def dexel_records(self) -> np.ndarray:
        """The dexels at this moment, the chips that have not been cut yet included: (d,) ndarray of DEXEL."""
        return self.records.dexels(self.step)

    @cached_property
    def trace_records(self) -> np.ndarray:
        """(m,) ndarray of TRACE : what all trajectories remove, sorted by pixel and depth."""
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
        """Bytes of the records and of the index, the traces of later moments included."""
        return self.records.nbytes

    @property
    def part_volume(self) -> float:
        """Volume of what is left at this moment, mm^3."""
        return _length(self.dexel_records) * self.frame.pixel**2

    @property
    def chip_volume(self) -> float:
        """Volume removed until this moment, mm^3."""
        return _length(self.trace_records[self.trace_records["trajectory"] < self.step]) * self.frame.pixel**2

    def chips(self, first: int, end: int) -> Picture:
        """Return what some trajectories remove, as it is seen alone: the first of their pieces on each ray.

        Parameters
        ----------
        first, end : int
            The trajectories first .. end - 1.

        Raises
        ------
        ValueError, TypeError
            As :meth:`at`.
        """
        first, end = self._moment("first", first), self._moment("end", end)
        records, pixels = self.records, self.frame.width * self.frame.height
        pieces = np.flatnonzero((records.owner >= first) & (records.owner < end))
        pixel = np.searchsorted(records.index, pieces, side="right") - 1
        nearest = np.ones(len(pieces), bool)
        nearest[1:] = pixel[1:] != pixel[:-1]
        pieces, pixel = pieces[nearest], pixel[nearest]
        depth, owner = np.full(pixels, np.nan, np.float32), np.full(pixels, STOCK, np.int32)
        inner = pieces > records.index[pixel]
        depth[pixel] = np.where(inner, records.far[pieces - 1], records.entry[pixel])
        owner[pixel] = records.owner[pieces]
        return Picture(self.step, depth, owner)

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
            Where there is no such moment.
        TypeError
            Where it is no whole number.
        """
        return replace(self, step=self._moment("step", step))

    def _moment(self, name: str, given: object) -> int:
        most = self.trajectories
        return whole(name, given, f"a whole number, 0 to {most}", lambda step: 0 <= step <= most)


def _length(records: np.ndarray) -> float:
    return float((records["far"].astype(float) - records["near"]).sum())
