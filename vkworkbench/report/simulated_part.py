# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures and the solid of a simulated part, for jobs and for NC programs."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

import numpy as np

from vkworkbench.core import ZBuffer
from vkworkbench.core.rendering import CUT, colors_of, palette, png, shade
from vkworkbench.core.zbuffer import part_triangles, write_stl
from vkworkbench.given import check_file_name

_Part = TypeVar("_Part", bound="SimulatedPart")


class SimulatedPart:
    """A part at one moment of a simulation, after `step` trajectories: the base class for jobs and for NC programs.

    Attributes
    ----------
    zbuffer : ZBuffer
        Depth of every pixel and the trajectory that cut it, dexels and traces.
    """

    zbuffer: ZBuffer

    @property
    def step(self) -> int:
        """Number of trajectories that the tool has made on this part."""
        return self.zbuffer.step

    @property
    def trajectories(self) -> int:
        """Number of all trajectories of the simulation."""
        return self.zbuffer.trajectories

    def at(self: _Part, step: int) -> _Part:  # noqa: PYI019 - older Pythons have no Self
        """Return the simulation at the moment after `step` trajectories.

        Raises
        ------
        ValueError
            If `step` is negative or larger than the number of trajectories.
        TypeError
            If `step` is not an integer.
        """
        return replace(self, zbuffer=self.zbuffer.at(step))  # type: ignore[type-var]

    def image(self) -> np.ndarray:
        """Return the shaded image of the part, (height, width, 3) uint8, row 0 at the top."""
        frame, picture = self.zbuffer.frame, self.zbuffer.picture
        size = frame.height, frame.width
        return shade(picture.depth.reshape(size), frame.pixel, colors_of(picture.owner.reshape(size), palette(CUT)))

    def save_png(self, path: str | os.PathLike[str]) -> None:
        """Write the picture to a PNG file.

        Raises
        ------
        ValueError
            If the file's name does not end with ``.png``.
        TypeError
            If `path` is not a file name.
        OSError
            If the file cannot be written.
        """
        _check_suffix(path, ".png", "picture is a PNG")
        Path(path).write_bytes(png(self.image()))

    def triangles(self) -> np.ndarray:
        """Return the triangles of the part's closed surface at this moment, (t, 3, 3) float64 mm.

        All walls are vertical and follow the edges of the pixels; see `core.zbuffer.part_triangles`.
        """
        return part_triangles(self._of_solid())

    def save_stl(self, path: str | os.PathLike[str]) -> None:
        """Write the part at this moment to a binary STL file, in mm, as a closed surface; see `triangles`.

        Raises
        ------
        ValueError
            If the file's name does not end with ``.stl``.
        TypeError
            If `path` is not a file name.
        OSError
            If the file cannot be written.
        """
        _check_suffix(path, ".stl", "solid is an STL")
        write_stl(path, self.triangles())

    def _of_solid(self) -> ZBuffer:
        """Return the z-buffer from which the part's surface is computed."""
        return self.zbuffer


def _check_suffix(path: str | os.PathLike[str], suffix: str, kind: str) -> None:
    check_file_name(path)
    if Path(path).suffix.lower() != suffix:
        raise ValueError(f"the {kind} file, so its name must end with {suffix}, unlike {str(path)!r}")
