# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the data of the Gauss map for one operation, in any thread."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from vkworkbench.core import Family, Recognition, linearize
from vkworkbench.core.gcode import used_up
from vkworkbench.core.paper import Areas, distinct, links, monotonous_areas, outline, overlapping, proof
from vkworkbench.document.job.recognition import Source, recognize_operation
from vkworkbench.document.job.setting import placed

_CELLS = 1000  # number of cells along a side of the toolpath's plot
_MAX_SEGMENTS = 8_000  # maximum number of drawn segments
_CLOSE = 0.25  # if a smaller share of the data is visible, the segments to draw are selected for the visible range


class Polyline:
    """A polyline (n+1, 2), mm, of which only segments that look different on the screen are drawn.

    A point with NaN interrupts the polyline.
    """

    def __init__(self, points: np.ndarray) -> None:
        self.points = points
        everywhere = np.full(2, np.inf)
        self._sketch = distinct(points, overlapping(points, -everywhere, everywhere), cells=_CELLS, most=_MAX_SEGMENTS)

    def seen(self, lower: np.ndarray, upper: np.ndarray, share: float) -> np.ndarray:
        """Return the indices of the segments to draw in the visible range from `lower` to `upper`, (m,) int64.

        `share` is the visible share of the data.
        """
        if share > _CLOSE or len(self._sketch) < _MAX_SEGMENTS // 4:
            return self._sketch
        return distinct(self.points, overlapping(self.points, lower, upper), cells=_CELLS, most=_MAX_SEGMENTS)


@dataclass(frozen=True)
class Reading:
    """The data of the Gauss map for one operation."""

    # The recognition is the same as in an analysis, so that the plots show the numbers of the mark in the tree, the
    # table and the CSV file.
    recognition: Recognition
    areas: Areas  # all monotonous areas of the toolpath
    # outline, links: the moves of all areas, and the moves between the areas.
    outline: Polyline
    links: Polyline
    proof: int  # index of the area that explains the strategy best


def read(source: Source, going_on: Callable) -> Iterator[Reading | None]:
    """Yield the data of an operation's Gauss map; None if no cutting move has a direction.

    `Unusable` is raised if the operation has too many trajectories. `going_on` is called between two steps of the
    computation, and raises `Cancelled` to end it.
    """
    commands = source.path.Commands
    going_on()
    toolpath = placed(linearize(used_up(commands), tolerance=source.tolerance), source.placement)
    going_on()
    areas = monotonous_areas(toolpath)
    if not len(areas):
        yield None
        return
    going_on()
    recognition, _ = recognize_operation(toolpath, source.tool_diameter, source.imported)
    going_on()
    main = max(recognition.spans, key=lambda span: span.share)
    index = proof(areas, main.first, main.last, around=main.strategy.family is Family.AROUND)
    going_on()
    signature = areas.signature(index)
    # Computes these cached properties here in a thread, because they would block Qt's main thread for long.
    _ = (
        signature.theta_level,
        signature.length,
    )
    drawn = [Polyline(points(areas)) for points in (outline, links)]
    going_on()
    yield Reading(recognition, areas, *drawn, index)
