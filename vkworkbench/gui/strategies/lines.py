# SPDX-License-Identifier: LGPL-2.1-or-later
"""One toolpath as coloured lines: computed in any thread, and shown as nodes of the 3D view."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from pivy import coin

from vkworkbench.core import Strategy, Toolpath, linearize
from vkworkbench.core.paper import distinct
from vkworkbench.document.job.recognition import Source, recognize_operation
from vkworkbench.document.job.setting import placed
from vkworkbench.gui.qt.colors import RAPID
from vkworkbench.gui.qt.names import QColor

_NAME = "VkStrategies"
_WIDTH, _SELECTED_WIDTH, _RAPID_WIDTH = 3, 6, 1  # widths of lines, px
_DEPTH = 0.9995  # end of OpenGL's depth range; a value below 1 draws the coloured lines in front of FreeCAD's lines
_SKETCHED = 20_000  # a toolpath with more trajectories is first drawn as a sketch with this number of trajectories
_CELLS = 200  # number of cells of the sketch along its longest side
_BATCH = 20_000  # number of points that are converted to Python numbers in one step
_ORIGIN = ("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0})  # FreeCAD draws every toolpath from the origin
_STRATEGIES = tuple(Strategy)


@dataclass(frozen=True)
class Drawing:
    """The coloured lines of a toolpath."""

    points: list
    # Colours, each with the indices of the points of its lines. Each line ends with the index -1.
    parts: list[tuple[str, list[int]]]
    strategies: frozenset[Strategy]  # the strategies in the drawing; empty for a sketch


def drawings(source: Source, going_on: Callable) -> Iterator[Drawing]:
    """Yield the drawing of an operation; for a long toolpath a sketch first.

    `Unusable` is raised if the operation has too many trajectories. `going_on` is called between two steps of the
    computation, and raises `Cancelled` to end it.
    """
    commands = source.path.Commands
    going_on()
    toolpath = linearize(commands, tolerance=source.tolerance)
    going_on()
    if not len(toolpath):
        return
    approach = _approach(commands, toolpath, source.tolerance)
    del commands
    if len(toolpath) > _SKETCHED:
        shown = distinct(toolpath.points, np.arange(len(toolpath)), cells=_CELLS, most=_SKETCHED)
        yield replace(_drawing(toolpath, approach, (), shown, going_on), strategies=frozenset())
        going_on()
    found, _ = recognize_operation(placed(toolpath, source.placement), source.tool_diameter, source.imported)
    going_on()
    yield _drawing(toolpath, approach, found.spans, np.arange(len(toolpath)), going_on)


def _approach(commands: list, toolpath: Toolpath, tolerance: float) -> np.ndarray:
    """Return the path from the origin to the first position that the program determines, (m, 3) mm.

    FreeCAD draws this path, and uses 0 for the coordinates that the program has not yet determined.
    """
    before = [(command.Name, command.Parameters) for command in commands[: toolpath.command[0]]]
    points = linearize([_ORIGIN, *before], tolerance=tolerance).points
    return points if len(points) else np.zeros((1, 3))


def colored(toolpath: Toolpath, spans) -> np.ndarray:
    """Return the colour of each trajectory: the index of its strategy, -1 for a rapid, (n,) int64.

    A cutting move outside all `spans` (parts of the toolpath with one strategy) has the colour of an unknown strategy.
    """
    color = np.full(len(toolpath), _STRATEGIES.index(Strategy.UNKNOWN))
    for span in spans:
        inside = (toolpath.command >= span.first_command) & (toolpath.command <= span.last_command)
        color[inside] = _STRATEGIES.index(span.strategy)
    color[toolpath.rapid] = -1
    return color


def _drawing(toolpath: Toolpath, approach: np.ndarray, spans, shown: np.ndarray, going_on: Callable) -> Drawing:
    points = np.concatenate([approach, toolpath.points]).astype(np.float32)
    color = colored(toolpath, spans)[shown]
    segments = shown + len(approach)
    parts = []
    for number in (-1, *range(len(_STRATEGIES))):
        chosen = segments[color == number]
        if number == -1:
            chosen = np.concatenate([np.arange(len(approach)), chosen])
        if len(chosen):
            parts.append((RAPID if number == -1 else _STRATEGIES[number].color, _listed(_strips(chosen), going_on)))
    strategies = frozenset(_STRATEGIES[number] for number in np.unique(color).tolist() if number >= 0)
    return Drawing(_listed(points, going_on), parts, strategies)


def _strips(segments: np.ndarray) -> np.ndarray:
    """Return the indices of the points of lines. Consecutive segments form one line, and each line ends with -1."""
    ends = np.append(np.flatnonzero(np.diff(segments) > 1), len(segments) - 1)
    strips = np.insert(segments, ends + 1, segments[ends] + 1)
    return np.insert(strips, ends + np.arange(1, len(ends) + 1) + 1, -1)


def _listed(array: np.ndarray, going_on: Callable) -> list:
    """Return an array as a list, converted in small steps, because each step holds the GIL and blocks the window."""
    found: list = []
    for first in range(0, len(array), _BATCH):
        going_on()
        found += array[first : first + _BATCH].tolist()
    return found


class Lines:
    """The nodes of one operation's coloured lines."""

    def __init__(self, drawing: Drawing) -> None:
        self.strategies = drawing.strategies
        self.root = root = coin.SoSeparator()
        root.setName(_NAME)
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE  # a click selects the operation by FreeCAD's own lines
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        depth = coin.SoDepthBuffer()
        depth.range = (0, _DEPTH)
        points = coin.SoCoordinate3()
        points.point.setValues(0, len(drawing.points), drawing.points)
        self._cuts, rapids = coin.SoDrawStyle(), coin.SoDrawStyle()
        self._cuts.lineWidth, rapids.lineWidth = _WIDTH, _RAPID_WIDTH
        for node in (pick, light, depth, points):
            root.addChild(node)
        for name, indices in drawing.parts:
            color = coin.SoBaseColor()
            color.rgb = QColor(name).getRgbF()[:3]
            strips = coin.SoIndexedLineSet()
            strips.coordIndex.setValues(0, len(indices), indices)
            for node in (rapids if name == RAPID else self._cuts, color, strips):
                root.addChild(node)

    def emphasize(self, selected: bool) -> None:
        """Draw a selected operation wider, because these lines cover FreeCAD's highlighted lines."""
        self._cuts.lineWidth = _SELECTED_WIDTH if selected else _WIDTH
