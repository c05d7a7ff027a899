# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the segments of rays that given trajectories remove, and compute their points, heights and volumes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer


@dataclass(frozen=True, eq=False)
class RemovedSegments:
    """Segments of rays in one image, each removed by a trajectory.

    Attributes
    ----------
    frame : Frame
        The image whose rays were cut.
    owner : (k,) ndarray of int
        Trajectory that removes each segment.
    x, y : (k,) ndarray
        Image coordinates of each segment's ray, mm.
    near, far : (k,) ndarray
        Depths at which each segment begins and ends, mm.
    """

    frame: Frame
    owner: np.ndarray
    x: np.ndarray
    y: np.ndarray
    near: np.ndarray
    far: np.ndarray

    def points(self, segment: np.ndarray, depth: np.ndarray) -> np.ndarray:
        """Return the points (q, 3) at the depths `depth` (q,) on the rays of the segments `segment` (q,), mm."""
        result: np.ndarray = self.frame.origins(self.x[segment], self.y[segment])
        result += np.multiply.outer(depth, self.frame.direction)
        return result

    def selected(self, chosen: np.ndarray) -> RemovedSegments:
        """Return the segments that the argument selects: a mask (k,) bool, or numbers of segments, ascending."""
        columns = (self.owner, self.x, self.y, self.near, self.far)
        return RemovedSegments(self.frame, *(column[chosen] for column in columns))

    @property
    def upper(self) -> np.ndarray:
        """Depth of the higher end of each segment, (k,) mm."""
        return self.near if self.frame.direction[2] < 0 else self.far

    def volumes(self, trajectories: int) -> np.ndarray:
        """Return the volume that each trajectory removes, (trajectories,) mm^3."""
        return np.bincount(self.owner, self.far - self.near, trajectories) * self.frame.pixel**2

    def tops(self, trajectories: int) -> np.ndarray:
        """Return the height of the highest point that each trajectory removes, (trajectories,) mm.

        The height is -inf if the trajectory removes nothing.
        """
        heights = self.points(np.arange(len(self.owner)), self.upper)[:, 2]
        tops = np.full(trajectories, -np.inf)
        np.maximum.at(tops, self.owner, heights)
        return tops


def joined(parts: Sequence[RemovedSegments]) -> RemovedSegments:
    """Join several sets of removed segments of rays of one image."""
    columns = zip(*((part.owner, part.x, part.y, part.near, part.far) for part in parts))
    return RemovedSegments(parts[0].frame, *map(np.concatenate, columns))


def segments_of(zbuffer: ZBuffer, owners: np.ndarray) -> RemovedSegments:
    """Return the segments that the selected trajectories remove in an image.

    `owners` (n,) bool selects the trajectories.
    """
    records, frame = zbuffer.records, zbuffer.frame
    segments, pixel, near = records.segments_of(owners)
    row, column = np.divmod(pixel, frame.width)
    x, y = frame.pixel_centres(column, row)
    far = records.far[segments].astype(float)
    return RemovedSegments(frame, records.owner[segments], x, y, near.astype(float), far)
