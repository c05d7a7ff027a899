# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths in the 3D view in the colours of their strategies, rapids grey; no document is changed.

Each operation's lines hang below its own view provider, so they are placed, hidden and freed with it.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD
import FreeCADGui as Gui
import numpy as np
from pivy import coin

from vkworkbench import freecad, preferences
from vkworkbench.core import Strategy, Toolpath, linearize, recognize
from vkworkbench.document.operations import find, kind
from vkworkbench.document.setting import read_tool
from vkworkbench.gui import latest
from vkworkbench.gui.colors import RAPID
from vkworkbench.gui.qt import QColor

_NAME = "VkStrategies"
_WIDTH, _SELECTED_WIDTH, _RAPID_WIDTH = 3, 6, 1  # px
_DEPTH = 0.9995  # of the depth range: in front of FreeCAD's own lines, which lie in the same place


def colored_parts(toolpath: Toolpath, spans) -> list[tuple[str, np.ndarray]]:
    """Return which trajectories are to be drawn in which colour.

    Parameters
    ----------
    toolpath : Toolpath
    spans : sequence of Span
        Of its recognition; a cutting move outside all of them has the colour of an unknown strategy.

    Returns
    -------
    list of (str, (m,) int64 array)
        Colour and indices of trajectories, the rapids first.
    """
    color = np.full(len(toolpath), list(Strategy).index(Strategy.UNKNOWN))
    for span in spans:
        inside = (toolpath.command >= span.first_command) & (toolpath.command <= span.last_command)
        color[inside] = list(Strategy).index(span.strategy)
    color[toolpath.rapid] = -1
    parts = [(RAPID, np.flatnonzero(color == -1))]
    parts += [(strategy.color, np.flatnonzero(color == number)) for number, strategy in enumerate(Strategy)]
    return [(name, trajectories) for name, trajectories in parts if len(trajectories)]


@dataclass(frozen=True)
class Lines:
    """The coloured lines of one operation in the scene graph.

    Attributes
    ----------
    root : coin.SoSeparator
    cuts : coin.SoDrawStyle
        Of all lines but the rapids.
    """

    root: coin.SoSeparator
    cuts: coin.SoDrawStyle


def lines(toolpath: Toolpath, spans) -> Lines:
    """Return the scene graph of a toolpath in the colours of its strategies."""
    root = coin.SoSeparator()
    root.setName(_NAME)
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE  # the operation is picked by FreeCAD's own lines
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    depth = coin.SoDepthBuffer()
    depth.range = (0, _DEPTH)
    points = coin.SoCoordinate3()
    points.point.setValues(0, len(toolpath.points), toolpath.points.astype(np.float32).tolist())
    cuts, rapids = coin.SoDrawStyle(), coin.SoDrawStyle()
    cuts.lineWidth, rapids.lineWidth = _WIDTH, _RAPID_WIDTH
    for node in (pick, light, depth, points):
        root.addChild(node)
    for name, trajectories in colored_parts(toolpath, spans):
        color = coin.SoBaseColor()
        color.rgb = QColor(name).getRgbF()[:3]
        strips = coin.SoIndexedLineSet()
        indices = _strips(trajectories)
        strips.coordIndex.setValues(0, len(indices), indices)
        for node in (rapids if name == RAPID else cuts, color, strips):
            root.addChild(node)
    return Lines(root, cuts)


def _strips(trajectories: np.ndarray) -> list[int]:
    """Indices of points, runs of consecutive trajectories joined, -1 after each run."""
    ends = np.flatnonzero(np.diff(trajectories) > 1) + 1
    indices: list[int] = []
    for run in np.split(trajectories, ends):
        indices += [*run.tolist(), int(run[-1]) + 1, -1]
    return indices


def show(document) -> None:
    """Colour the toolpaths of a document; they keep their colours up to date by themselves."""
    global _watcher
    if _watcher is None:
        _watcher = _Watcher()
        FreeCAD.addDocumentObserver(_watcher)
        Gui.Selection.addObserver(_watcher)
    _drawn[document.Name] = {}
    for operation in find(document):
        _draw(operation.object)
    _emphasize()


def hide(document) -> None:
    """Take the colours away."""
    for parent, drawn in _drawn.pop(document.Name, {}).values():
        parent.removeChild(drawn.root)


def is_shown(document) -> bool:
    return document is not None and document.Name in _drawn


# Lines and the node they hang below, by the names of document and object.
_drawn: dict[str, dict[str, tuple[coin.SoGroup, Lines]]] = {}


def _draw(obj) -> None:
    here = _drawn[obj.Document.Name]
    if obj.Name in here:
        parent, drawn = here.pop(obj.Name)
        parent.removeChild(drawn.root)
    modes = obj.ViewObject.SwitchNode
    if not modes.getNumChildren():
        return  # FreeCAD does not draw it: a macro made it, without a view proxy
    toolpath = linearize(obj.Path.Commands, tolerance=preferences.read().tolerance)
    if len(toolpath):
        parent = modes.getChild(0)
        drawn = lines(toolpath, _spans(obj, toolpath))
        parent.addChild(drawn.root)
        here[obj.Name] = parent, drawn


def _emphasize() -> None:
    """Draw the selected operations wider: FreeCAD's own lines, which it highlights, are covered."""
    selected = {(obj.Document.Name, obj.Name) for obj in Gui.Selection.getSelection("*")}
    for document, here in _drawn.items():
        for name, (_, drawn) in here.items():
            drawn.cuts.lineWidth = _SELECTED_WIDTH if (document, name) in selected else _WIDTH


def _spans(obj, toolpath: Toolpath):
    """Return the spans that the last analysis found; if the toolpath has changed since, recognise it now."""
    known = latest.found_of(obj)
    if known is not None:
        return known.spans
    try:
        diameter = read_tool(obj).diameter
    except ValueError:
        diameter = None
    return recognize(toolpath, tool_diameter=diameter).spans


class _Watcher:
    """Draws toolpaths anew that changed, and forgets those that are gone."""

    def __init__(self) -> None:
        self._changed: set[tuple[str, str]] = set()

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.PATH.names and obj.Document.Name in _drawn and kind(obj) in ("operation", "dressup", "array"):
            self._changed.add((obj.Document.Name, obj.Name))

    def slotRecomputedDocument(self, document) -> None:
        self._draw_changed(document)

    def slotUndoDocument(self, document) -> None:
        self._draw_changed(document)

    def slotRedoDocument(self, document) -> None:
        self._draw_changed(document)

    def addSelection(self, *what) -> None:
        _emphasize()

    def setSelection(self, *what) -> None:
        _emphasize()

    def removeSelection(self, *what) -> None:
        _emphasize()

    def clearSelection(self, *what) -> None:
        _emphasize()

    def slotDeletedObject(self, obj) -> None:
        _drawn.get(obj.Document.Name, {}).pop(obj.Name, None)

    def slotDeletedDocument(self, document) -> None:
        _drawn.pop(document.Name, None)

    def _draw_changed(self, document) -> None:
        here = {key for key in self._changed if key[0] == document.Name}
        self._changed -= here
        for _, name in here:
            obj = document.getObject(name)
            if obj is not None and is_shown(document):
                _draw(obj)
        if here:
            _emphasize()


_watcher: _Watcher | None = None
