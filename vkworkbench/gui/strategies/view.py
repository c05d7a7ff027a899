# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw toolpaths in the 3D view in the colours of their strategies, and rapids in grey. Documents are not changed.

The lines of an operation are child nodes of its view provider, so that they are placed, hidden and deleted with the
operation. A background thread computes the lines of a few operations at a time.
"""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable, Iterator
from typing import Tuple

import FreeCAD
import FreeCADGui as Gui
from pivy import coin

from vkworkbench import freecad
from vkworkbench.document.job.operations import find, is_operation, names_of
from vkworkbench.document.job.recognition import Source, source_of
from vkworkbench.gui.qt.background import Background, Busy
from vkworkbench.gui.qt.language_change import LanguageChange
from vkworkbench.gui.qt.names import single_shot
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.strategies.legend import Legend
from vkworkbench.gui.strategies.lines import Drawing, Lines, drawings
from vkworkbench.report import Cancelled

_SLICE = 0.03  # longest time for copying paths before Qt handles other events, s

Key = Tuple[str, str]  # names of the document and the object


def _groups(obj) -> list[coin.SoGroup]:
    """Return the current group nodes in which FreeCAD draws an object; empty if FreeCAD does not draw it.

    Other code can remove the nodes, and FreeCAD crashes if a removed node is used. Therefore call this function before
    each use of the nodes.
    """
    switch = obj.ViewObject.SwitchNode
    children = map(switch.getChild, range(switch.getNumChildren()))
    return [child for child in children if isinstance(child, coin.SoGroup)]


class _Shown:
    """The coloured lines of the operations of one document, by the names of the operations."""

    def __init__(self, document_name: str) -> None:
        self._document = document_name
        self.lines: dict[str, Lines] = {}
        self.legend = Legend(document_name)

    def put(self, obj, lines: Lines) -> None:
        self.take_away(obj.Name)
        for group in _groups(obj)[:1]:
            group.addChild(lines.root)
            self.lines[obj.Name] = lines
            self.name_colors()

    def take_away(self, name: str) -> None:
        if name in self.lines:
            self._take_away(name)
            self.name_colors()

    def _take_away(self, name: str) -> None:
        root = self.lines.pop(name).root
        for group in _groups(FreeCAD.getDocument(self._document).getObject(name)):
            if group.findChild(root) >= 0:
                group.removeChild(root)

    def forget(self, name: str) -> None:
        """Release the lines of a deleted operation."""
        if self.lines.pop(name, None) is not None:
            self.name_colors()

    def end(self) -> None:
        """Remove all lines and the legend."""
        for name in list(self.lines):
            self._take_away(name)
        self.legend.remove()

    def name_colors(self) -> None:
        """Show the strategies of the visible operations in the legend."""
        document = FreeCAD.getDocument(self._document)
        visible = [lines for name, lines in self.lines.items() if document.getObject(name).Visibility]
        self.legend.show(strategy for lines in visible for strategy in lines.strategies)


class _Drawer:
    """Draws the operations that wait to be drawn, a few at a time."""

    def __init__(self, cancelled: Callable) -> None:
        self._cancelled = cancelled
        self._background = Background()
        self.busy = Busy(self._background)
        self.busy.button.clicked.connect(self._give_up)
        Gui.getMainWindow().statusBar().addPermanentWidget(self.busy)
        self._language = LanguageChange(_name_colors, Gui.getMainWindow())
        self._pending: dict[Key, None] = {}
        self._at_work: list[Key] = []
        self._later = single_shot(self._read)

    @property
    def works(self) -> bool:
        return bool(self._pending) or self._background.works

    def draw(self, objects) -> None:
        self._pending.update(dict.fromkeys(map(names_of, objects)))
        if self._pending and not self._background.works:
            self._later.start()

    def forget(self, document_name: str) -> None:
        """Stop drawing a document."""
        self._background.give_up()
        keys = [key for key in (*self._at_work, *self._pending) if key[0] != document_name]
        self._pending, self._at_work = dict.fromkeys(keys), []
        self.draw(())

    def _give_up(self) -> None:
        """Stop drawing if the user pressed the button to cancel after one batch had ended and before the next began."""
        if self.works:
            self._ended(Cancelled("given up"))

    def _read(self) -> None:
        until = time.monotonic() + _SLICE
        batch: list[tuple[Key, Source]] = []
        while self._pending and (not batch or time.monotonic() < until):
            key = next(iter(self._pending))
            del self._pending[key]
            obj = _object(key)
            if obj is not None and _groups(obj):  # without a group, FreeCAD does not draw the object
                batch.append((key, source_of(obj)))
        self._at_work = [key for key, _ in batch]
        if batch:
            text = translate("Vk_Strategies", "Drawing strategies, operations left: {}")
            self._background.start(text.format(len(batch) + len(self._pending)), _work(batch), self._show, self._ended)

    def _show(self, result: tuple[Key, Drawing | None]) -> None:
        key, drawing = result
        obj = _object(key)
        if obj is None:
            return
        shown = _shown[key[0]]
        if drawing is None:
            shown.take_away(key[1])
            return
        lines = Lines(drawing)
        lines.emphasize(obj in Gui.Selection.getSelection("*"))
        shown.put(obj, lines)

    def _ended(self, error: Exception | None) -> None:
        self._at_work = []
        if error is None:
            self.draw(())
            return
        for name in list(_shown):
            hide(FreeCAD.getDocument(name))
        self._cancelled()


def _work(batch: list[tuple[Key, Source]]) -> Callable:
    def work(going_on: Callable) -> Iterator[tuple[Key, Drawing | None]]:
        for key, source in batch:
            found = False
            try:
                for drawing in drawings(source, going_on):
                    found = True
                    yield key, drawing
            except Cancelled:
                raise
            except Exception:  # draw the other operations; the analysis reports the error
                FreeCAD.Console.PrintLog(traceback.format_exc())
            if not found:
                yield key, None

    return work


def _object(key: Key):
    """Return an operation of a coloured document; None if the operation was deleted or the colours were removed."""
    document = FreeCAD.listDocuments().get(key[0])
    return document.getObject(key[1]) if document is not None and key[0] in _shown else None


_shown: dict[str, _Shown] = {}
_drawer: _Drawer | None = None


def show(document, cancelled: Callable) -> None:
    """Colour the toolpaths of a document, and keep the colours up to date.

    `cancelled` is called after the user cancelled the drawing, which removes all colours.
    """
    global _drawer
    if _drawer is None:
        _drawer = _Drawer(cancelled)
        watcher = _Watcher()
        FreeCAD.addDocumentObserver(watcher)
        Gui.Selection.addObserver(watcher)
    _shown[document.Name] = _Shown(document.Name)
    # A link in a job's group is not drawn here: FreeCAD draws it as a copy of the coloured operation.
    _drawer.draw(filter(is_operation, (operation.object for operation in find(document))))


def _name_colors() -> None:
    """Show the legends of all documents again, in FreeCAD's language."""
    for shown in _shown.values():
        shown.name_colors()


def hide(document) -> None:
    """Remove the colours of a document."""
    if is_shown(document):
        _shown.pop(document.Name).end()
        _drawer.forget(document.Name)


def is_shown(document) -> bool:
    return document is not None and document.Name in _shown


def is_drawing() -> bool:
    """Return whether operations are still to be drawn."""
    return _drawer is not None and _drawer.works


class _Watcher:
    """Redraws changed toolpaths, and drops deleted toolpaths."""

    def __init__(self) -> None:
        self._changed: set[Key] = set()

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.PATH.names and obj.Document.Name in _shown and is_operation(obj):
            self._changed.add(names_of(obj))
        elif name == "Visibility" and obj.Document.Name in _shown and obj.Name in _shown[obj.Document.Name].lines:
            _shown[obj.Document.Name].name_colors()

    def slotRecomputedDocument(self, document) -> None:
        here = {key for key in self._changed if key[0] == document.Name}
        self._changed -= here
        _drawer.draw(filter(None, map(_object, here)))

    slotUndoDocument = slotRedoDocument = slotRecomputedDocument

    def addSelection(self, *what) -> None:
        selected = set(map(names_of, Gui.Selection.getSelection("*")))
        for document, shown in _shown.items():
            for name, lines in shown.lines.items():
                lines.emphasize((document, name) in selected)

    setSelection = removeSelection = clearSelection = addSelection

    def slotDeletedObject(self, obj) -> None:
        if obj.Document.Name in _shown:
            _shown[obj.Document.Name].forget(obj.Name)

    def slotDeletedDocument(self, document) -> None:
        if _shown.pop(document.Name, None) is not None:
            _drawer.forget(document.Name)
