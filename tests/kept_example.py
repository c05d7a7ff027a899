# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example's document, which stays open between tests in FreeCAD's window if no test changes it."""

from __future__ import annotations

import io
import zipfile

import FreeCAD
import FreeCADGui as Gui

import vkworkbench
from vkworkbench.document.simulation import faults as simulated_faults
from vkworkbench.gui.strategies import view as strategy_view


class KeptExample:
    """The example, which is opened again only if a test changed it, or if it has marks and must have none.

    FreeCAD calls the methods whose names begin with "slot" when a document changes.

    Parameters
    ----------
    path : Path
        The example's file.

    Attributes
    ----------
    document : Document or None
        The open document.
    is_marked : bool
        Whether the document has the marks of one analysis.
    """

    def __init__(self, path) -> None:
        self._path = path
        self.document, self.is_marked = None, False
        self._name = None
        self._is_changed = False  # whether FreeCAD has reported a change, even if the test has undone the change
        FreeCAD.addDocumentObserver(self)

    def open(self, *, may_be_marked: bool):
        """Return the document as opened by FreeCAD, or with the marks of an earlier test if `may_be_marked`."""
        if self.is_marked and not may_be_marked and not self._clear_marks():
            self.close()
        if self.document is None:
            self.document, self.is_marked = FreeCAD.openDocument(str(self._path)), False
            self._name = self.document.Name
            self._camera = Gui.activeView().getCamera()
            self._remember()
            self._as_opened = self._state, self._before
        else:
            FreeCAD.setActiveDocument(self._name)
            Gui.activeView().setCamera(self._camera)
        return self.document

    def has_marks(self) -> None:
        """Treat the document with its new marks as unchanged."""
        self.is_marked = True
        self._remember()

    def undo_changes(self) -> None:
        """Undo the steps since the document was opened or marked."""
        for _ in range(self.document.UndoCount - self._state["steps"] if self.document is not None else 0):
            self.document.undo()

    def close_if_changed(self) -> None:
        """Close the document if a test changed more than its marks since it was opened or marked."""
        if self.document is not None and not self._is_as_remembered() and not self._clear_marks():
            self.close()

    def close(self) -> None:
        """Close the document if it is open."""
        if self._name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(self._name)
        self.document, self.is_marked, self._name = None, False, None

    def _is_as_remembered(self) -> bool:
        """Return whether the document is in the remembered state, after removing the flags of undone changes."""
        if self._is_changed and self._content() == self._before:
            self._purge_touched(obj for obj in self.document.Objects if "Touched" in obj.State)
            self._is_changed = False
        return not self._is_changed and self._look() == self._state

    def _clear_marks(self) -> bool:
        """Clear the marks, and return whether the document is now as FreeCAD opened it."""
        vkworkbench.clear(self.document)
        self.document.clearUndos()
        self.is_marked, self._is_changed = False, True
        self._state, self._before = self._as_opened
        # FreeCAD 1.1 saves the flag "touched" of Label2 too.
        self._purge_touched(obj for obj in self.document.Objects if obj.isDerivedFrom("Path::Feature"))
        return self._is_as_remembered()

    def _purge_touched(self, objects) -> None:
        """Remove the flag "touched" of objects that a test changed and changed back."""
        for obj in objects:
            if obj.Name not in self._state["touched"]:
                obj.purgeTouched()

    def _remember(self) -> None:
        self._state, self._before = self._look(), self._content()
        self._is_changed = False

    def _look(self):
        """Return the part of the document's state that `_content` does not contain, such as undo steps and 3D views."""
        gui_document = Gui.getDocument(self._name)
        return {
            "touched": [obj.Name for obj in self.document.Objects if "Touched" in obj.State],
            "steps": self.document.UndoCount,
            "undo mode": self.document.UndoMode,
            "views": len(gui_document.mdiViewsOfType("Gui::View3DInventor")),
            "view providers": [_check_sums(obj.ViewObject) for obj in self.document.Objects],
            "is edited": gui_document.getInEdit() is not None,
            "faults": dict(simulated_faults._found.get(self._name, ())),
            "has colored toolpaths": strategy_view.is_shown(self.document),
        }

    def _content(self):
        """Return the names of the objects in order, and the check sums of the saved data of each object."""
        objects = [(obj.Name, _check_sums(obj)) for obj in self.document.Objects]
        return self.document.Label, self.document.FileName, objects

    def _note(self, document) -> None:
        if document.Name == self._name:
            self._is_changed = True

    def slotCreatedObject(self, obj) -> None:
        self._note(obj.Document)

    def slotDeletedObject(self, obj) -> None:
        self._note(obj.Document)

    def slotChangedObject(self, obj, name: str) -> None:
        self._note(obj.Document)

    def slotAppendDynamicProperty(self, obj, name: str) -> None:
        self._note(obj.Document)

    def slotRemoveDynamicProperty(self, obj, name: str) -> None:
        self._note(obj.Document)

    def slotChangedDocument(self, document, name: str) -> None:
        self._note(document)

    def slotDeletedDocument(self, document) -> None:
        if document.Name == self._name:
            self.document, self.is_marked, self._name = None, False, None


def _check_sums(thing):
    """Return the check sums of the files in which FreeCAD saves an object or a view provider."""
    with zipfile.ZipFile(io.BytesIO(bytes(thing.dumpContent(Compression=0)))) as content:
        return [(file.filename, file.CRC) for file in content.infolist()]
