# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the Gauss map shows of one operation, worked out in any thread."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from vkworkbench.core import Family, Recognition, linearize
from vkworkbench.core.gcode import used_up
from vkworkbench.core.paper import Areas, distinct, links, monotonous_areas, outline, overlapping, proof
from vkworkbench.document.job.recognition import Source, recognize_operation
from vkworkbench.document.job.setting import placed

_CELLS = 1000  # of a toolpath's plot
_MOST = 8_000  # segments of it that are drawn
_CLOSE = 0.25  # of the whole; in a smaller window more than these may be told apart


class Polyline:
    """A polyline of which as much is drawn as can be told apart.

    Attributes
    ----------
    points : (n+1, 2) float64
        mm, NaN where it is broken.
    """

    def __init__(self, points: np.ndarray) -> None:
        self.points = points
        everywhere = np.full(2, np.inf)
        self._sketch = distinct(points, overlapping(points, -everywhere, everywhere), cells=_CELLS, most=_MOST)

    def seen(self, lower: np.ndarray, upper: np.ndarray, share: float) -> np.ndarray:
        """Return the segments to draw in a window, (m,) int64, which is that share of the whole."""
        if share > _CLOSE or len(self._sketch) < _MOST // 4:
            return self._sketch
        return distinct(self.points, overlapping(self.points, lower, upper), cells=_CELLS, most=_MOST)


@dataclass(frozen=True)
class Reading:
    """An operation as the Gauss map shows it.

    Attributes
    ----------
    recognition : Recognition
        The same that an analysis finds: mark, table and CSV have its numbers.
    areas : Areas
        All monotonous areas of the toolpath.
    outline, links : Polyline
        The areas, and how the tool gets from one to the next.
    proof : int
        Index of the area that shows best why.
    """

    recognition: Recognition
    areas: Areas
    outline: Polyline
    links: Polyline
    proof: int


def read(source: Source, going_on: Callable) -> Iterator[Reading | None]:
    """Yield what is shown; None where no cutting move has a direction.

    Raises
    ------
    Unusable
        Where the commands are too many trajectories.
    Cancelled
        By `going_on`, which is called between two steps.
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
    _ = signature.theta_level, signature.length  # not in the window's thread
    drawn = [Polyline(points(areas)) for points in (outline, links)]
    going_on()
    yield Reading(recognition, areas, *drawn, index)
