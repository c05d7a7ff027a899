# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's entries in context menus, opened by real right clicks in the tree."""

import subprocess

import FreeCAD
import FreeCADGui as Gui
import Path
import pytest
from PySide import QtCore, QtGui

from vkworkbench import freecad
from vkworkbench.document.marks import marks

CAM = "PathWorkbench" if freecad.version() < (1, 0) else "CAMWorkbench"
OURS = {"Analyze Toolpaths", "Clear Analysis", "Toolpath Results", "Show Strategies", "Gauss Map"}


@pytest.fixture(scope="module", params=["VkWorkbench", CAM])
def shown_tree(request, example_path, kept_document, window):
    """The tree of the example with imported G-code, a toolpath without a Proxy that the last test marks."""
    kept_document.close()
    document = FreeCAD.openDocument(str(example_path))
    imported = document.addObject("Path::Feature", "Imported")
    imported.Path = Path.Path("G0 Z30\nG0 X5 Y5\nG1 Z15 F10\nG1 X50\nG1 Y10\nG1 X5\nG1 Y15\nG1 X50\nG0 Z30")
    window.activate(request.param)
    window.tree.expandAll()
    window.settle()
    yield Tree(window, document, pictured=request.param == CAM)
    FreeCAD.closeDocument(document.Name)
    window.settle()


@pytest.fixture
def tree(shown_tree):
    Gui.Selection.clearSelection()
    return shown_tree


class Tree:
    """The tree of FreeCAD's window, clicked with real mouse events of xdotool."""

    def __init__(self, window, document, pictured):
        self.window, self.document, self.pictured = window, document, pictured

    def row(self, label):
        """Return the index of the first row with this label."""
        model = self.window.tree.model()

        def visit(parent):
            for number in range(model.rowCount(parent)):
                index = model.index(number, 0, parent)
                if index.data() == label:
                    return index
                below = visit(index)
                if below is not None:
                    return below
            return None

        return visit(QtCore.QModelIndex())

    def click(self, label, button, *keys):
        view, index = self.window.tree, self.row(label)
        view.scrollTo(index)
        self.window.settle()
        at = view.visualRect(index)
        self._press(view.viewport().mapToGlobal(QtCore.QPoint(at.left() + 40, at.center().y())), button, *keys)

    def _press(self, where, button, *keys):
        command = ["xdotool", *(word for key in keys for word in ("keydown", key))]
        command += ["mousemove", str(where.x()), str(where.y()), "click", str(button)]
        command += [word for key in keys for word in ("keyup", key)]
        subprocess.run(command, check=True, timeout=120)

    def menu_of(self, label, choose=None):
        """Open the context menu of a row, choose an entry or press Esc, and return the texts of the menu."""
        texts = []

        def look():
            menu = QtGui.QApplication.activePopupWidget()
            if menu is None:
                QtCore.QTimer.singleShot(50, look)
                return
            actions = {action.text().replace("&", ""): action for action in menu.actions()}
            below = [
                action.menu() for action in menu.actions() if action.menu() and "Toolpath Analysis" in action.text()
            ]
            texts.extend(action.text().replace("&", "") for ours in below for action in ours.actions())
            texts.extend(actions)
            if choose is None:
                if self.pictured:  # take the picture in only one of the two workbenches
                    self.window.screenshot(f"context-menu-{label}")
                self.window.press(menu, QtCore.Qt.Key_Escape)
            else:
                where = menu.mapToGlobal(menu.actionGeometry(actions[choose]).center())
                self._press(where, 1)

        QtCore.QTimer.singleShot(50, look)
        self.click(label, 3)
        self.window.wait(lambda: texts and QtGui.QApplication.activePopupWidget() is None)
        return set(texts)


@pytest.mark.parametrize("label", ["Job", "Operations", "Face", "Cut out with tags", "Imported"])
def test_context_menu_of_operations_has_the_entries(tree, label):
    tree.click(label, 1)
    assert tree.menu_of(label) >= OURS


def test_context_menu_of_several_objects_has_the_entries(tree, window):
    tree.click("Face", 1)
    tree.click("Imported", 1, "ctrl")
    window.wait(lambda: len(Gui.Selection.getSelection()) == 2)
    assert tree.menu_of("Imported") >= OURS
    assert len(Gui.Selection.getSelection()) == 2


def test_context_menu_of_models_and_tools_has_no_entries(tree):
    for label in ("Model", "Tools"):
        tree.click(label, 1)
        assert not tree.menu_of(label) & OURS


def test_context_menu_entry_analyzes_the_selected_object(tree, window):
    tree.click("Imported", 1)
    tree.menu_of("Imported", choose="Analyze Toolpaths")
    document = tree.document
    window.wait(lambda: [obj.Label for obj in document.Objects if marks.is_marked(obj)] == ["Imported"])
