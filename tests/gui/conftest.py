# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window as a person uses it: wait, click, look."""

from __future__ import annotations

import os
import subprocess
import time
from pathlib import Path
from xml.etree import ElementTree

import dead_widgets
import events
import FreeCAD
import FreeCADGui as Gui
import kept_example
import pytest
from PySide import QtCore, QtGui

try:  # in this order: where FreeCAD runs on PySide2, loading PySide6 beside it crashes
    from PySide2.QtTest import QTest
except ImportError:
    from PySide6.QtTest import QTest

from vkworkbench import freecad
from vkworkbench.document.computer import idle
from vkworkbench.document.job.results import RESULTS
from vkworkbench.gui.qt import docks, widgets
from vkworkbench.gui.tree import column as tree


@pytest.fixture(autouse=True)
def nothing_known(request):
    """No test finds what another one's analysis found, but in `marked` what the analysis of its document found."""
    if not ("marked" in request.fixturenames and request.getfixturevalue("kept_document").is_marked):
        RESULTS.clear()


@pytest.fixture(autouse=True)
def no_dead_widgets():
    """No test meets what FreeCAD left of another one."""
    yield
    dead_widgets.forget()


@pytest.fixture(autouse=True)
def mouse_below_the_window():
    """FreeCAD 1.1 asks the mouse, not the event, what a press hits: where it was left there may be an empty task panel."""
    QtGui.QCursor.setPos(QtGui.QApplication.primaryScreen().geometry().bottomRight())


DARK = """
QWidget { background-color: #26282c; color: #e6e6e6; }
QTreeView, QTableView { background-color: #1e1f22; alternate-background-color: #26282c; color: #e6e6e6; }
QTreeView::item:selected, QTableView::item:selected { background-color: #3d5a80; color: #ffffff; }
QHeaderView::section { background-color: #33363b; color: #e6e6e6; }
"""


class Window:
    """FreeCAD's main window."""

    def __init__(self):
        self.main = Gui.getMainWindow()
        self.main.setGeometry(0, 0, 1280, 1000)

    def wait(self, until, seconds=120.0):
        """Let FreeCAD work until a condition holds: the windows of three FreeCADs may share two processors."""
        end = time.monotonic() + seconds
        while not until():
            assert time.monotonic() < end, f"waited {seconds} s in vain"
            events.happen()

    def idle(self, seconds=0.2):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            events.happen()

    def settle(self):
        """Handle all pending events, and wait for the timers of the trees and for the deferred work of the add-on."""
        for _ in range(2):
            QtGui.QGuiApplication.sync()
            events.happen()
        self.wait(lambda: not (idle._works or idle._calls or any(timer.isActive() for timer in self._tree_timers())))

    def _tree_timers(self):
        """The timers after which FreeCAD's trees show a selection or a change."""
        return [timer for view in tree.trees() for timer in view.findChildren(QtCore.QTimer)]

    def activate(self, workbench):
        Gui.activateWorkbench(workbench)
        self.settle()
        # FreeCAD began in no workbench, which hides the tree's dock.
        shown = {"Combo View": True, "Model": True, "Report view": False, "Python console": False}
        for dock in self.find(QtGui.QDockWidget):
            if dock.objectName() in shown:
                dock.setVisible(shown[dock.objectName()])
                dock.raise_()  # in 1.x the task panel may cover the tree
        for bar in self.find(QtGui.QToolBar):
            if bar.objectName() == "Toolpath Analysis":  # a row of its own, where it has room for all its buttons
                self.main.insertToolBarBreak(bar)
        self.settle()

    def find(self, kind, name=None):
        """The widgets of a kind that there are; kept until the next are looked for, and with them what they are asked for."""
        self.found = widgets.find(kind, name)
        return self.found

    def first(self, kind, name=None):
        return next(iter(self.find(kind, name)), None)

    def button(self, text):
        """The visible tool button of a command, by its menu text."""
        found = [
            b
            for b in self.find(QtGui.QToolButton)
            if b.isVisible() and b.defaultAction() and b.defaultAction().text().replace("&", "") == text
        ]
        assert found, f"no button {text!r}"
        return found[0]

    def click(self, text):
        self.wait(lambda: self.button(text).isEnabled())
        QTest.mouseClick(self.button(text), QtCore.Qt.LeftButton)

    def analyze(self, document):
        """Click *Analyze Toolpaths* on the example job, and wait for its marks."""
        self.click("Analyze Toolpaths")
        self.wait(lambda: document.getObject("Job").Label2)
        self.settle()

    def start_simulator(self, name):
        """Start a simulator of FreeCAD as its command does; the panels of before do not get in its way."""
        dead_widgets.forget()
        Gui.runCommand(freecad.simulator_command(name))

    def click_on(self, widget):
        QTest.mouseClick(widget, QtCore.Qt.LeftButton)

    def click_at(self, widget, where):
        QTest.mouseClick(widget, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, where)

    def mouse_press(self, widget, where, button):
        QTest.mousePress(widget, button, QtCore.Qt.NoModifier, where)

    def mouse_move(self, widget, where, button):
        """Move the mouse with a button held: QTest's own moves forget the button."""
        event = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, QtCore.QPointF(where), QtCore.QPointF(widget.mapToGlobal(where)),
                                  QtCore.Qt.NoButton, button, QtCore.Qt.NoModifier)  # fmt: skip
        QtGui.QApplication.sendEvent(widget, event)
        QtGui.QApplication.processEvents()

    def mouse_release(self, widget, where, button):
        QTest.mouseRelease(widget, button, QtCore.Qt.NoModifier, where)

    def press(self, widget, key):
        QTest.keyClick(widget, key)

    def type(self, widget, text):
        QTest.keyClicks(widget, text)

    def boxes(self):
        """The message boxes that are open."""
        return [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QMessageBox) and w.isVisible()]

    def dismiss(self):
        """Close all message boxes by their button, and return their texts."""
        texts = []
        for box in self.boxes():
            texts.append(box.text())
            QTest.mouseClick(box.buttons()[0], QtCore.Qt.LeftButton)
        self.settle()
        return texts

    @property
    def tree(self):
        return next(view for view in tree.trees() if view.isVisible())

    def descriptions(self):
        """The tree's second column by its first."""
        model, found = self.tree.model(), {}

        def visit(parent):
            for row in range(model.rowCount(parent)):
                index = model.index(row, 0, parent)
                found[index.data()] = model.index(row, 1, parent).data()
                visit(index)

        visit(QtCore.QModelIndex())
        return found

    def see_all(self):
        """Turn the 3D view so that all of the job is seen from the front, right and above."""
        Gui.activeView().viewIsometric()
        Gui.SendMsgToActiveView("ViewFit")

    def screenshot(self, name):
        folder = Path(os.environ.get("VKWORKBENCH_SCREENSHOTS", "build/screenshots"))
        folder.mkdir(parents=True, exist_ok=True)
        self.idle(0.5)
        path = folder / f"{name}-{'.'.join(FreeCAD.Version()[:2])}.png"
        subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
        return path


@pytest.fixture(scope="session")
def window():
    return Window()


@pytest.fixture
def small(window):
    """A window in which the finest picture does not take long."""
    before = window.main.geometry()
    window.main.setGeometry(0, 0, 1024, 700)
    yield
    window.main.setGeometry(before)


@pytest.fixture(scope="session")
def kept_document(example_path):
    """The example's document, which stays open until a test changes it."""
    return kept_example.KeptExample(example_path)


def hide_results(window):
    """Hide the panel of results, which takes room from the 3D view."""
    for dock in window.find(QtGui.QDockWidget, docks.RESULTS):
        dock.hide()


@pytest.fixture(autouse=True)
def no_kept_document(request):
    """Close the kept document before a test that uses the window without it."""
    names = set(request.fixturenames)
    if not {"opened", "marked"} & names and {"window", "example_path"} & names:
        hide_results(request.getfixturevalue("window"))
        request.getfixturevalue("kept_document").close()


@pytest.fixture
def opened(kept_document, window, request):
    """The example job, opened and expanded in the tree, in the analysis workbench; without marks but in `marked`."""
    may_be_marked = "marked" in request.fixturenames
    if not may_be_marked:
        hide_results(window)
    document = kept_document.open(may_be_marked=may_be_marked)
    window.activate("VkWorkbench")
    window.tree.expandAll()
    Gui.Selection.clearSelection()
    yield document
    Gui.Selection.clearSelection()
    kept_document.undo_changes()
    window.dismiss()
    kept_document.close_if_changed()
    window.settle()


@pytest.fixture
def marked(opened, kept_document, window):
    """The example job after an analysis by a click, which shows the panel of results."""
    if not kept_document.is_marked:
        window.analyze(opened)
        window.dismiss()
        window.tree.expandAll()
        kept_document.has_marks()
    elif not any(map(docks.is_seen, window.find(QtGui.QDockWidget, docks.RESULTS))):
        window.click("Toolpath Results")
    window.settle()
    return opened


@pytest.fixture(scope="module", params=["light", "dark"])
def theme(request, window):
    application = QtGui.QApplication.instance()
    before = application.styleSheet()
    if request.param == "dark":
        application.setStyleSheet(DARK)
    yield request.param
    application.setStyleSheet(before)
    window.idle()


def choose(pack):
    """Set the parameters of a preference pack, as FreeCAD does with one that is chosen; return those of before."""
    kinds = {"FCText": ("String", str), "FCUInt": ("Unsigned", int), "FCInt": ("Int", int), "FCFloat": ("Float", float),
             "FCBool": ("Bool", lambda text: text == "1")}  # fmt: skip
    before = []

    def visit(node, path):
        for one in node:
            if one.tag == "FCParamGroup":
                visit(one, [*path, one.get("Name")])
            else:
                kind, read = kinds[one.tag]
                before.append(("/".join(path), kind, one.get("Name")))
                before[-1] += (set_parameter(*before[-1], read(one.get("Value") or one.text or "")),)

    (root,) = ElementTree.parse(pack).getroot()
    visit(root, [])
    return before


def set_parameter(path, kind, name, value):
    """Set one, or remove it where the value is None; return its value of before."""
    group = FreeCAD.ParamGet(f"User parameter:{path}")
    known = {entry[1] for entry in group.GetContents() or ()}
    before = getattr(group, f"Get{kind}")(name) if name in known else None
    if value is None:
        getattr(group, f"Rem{kind}")(name)
    else:
        getattr(group, f"Set{kind}")(name, value)
    return before


@pytest.fixture(scope="session", params=["FreeCAD Dark", "FreeCAD Light", "Dark-blue", "Light-blue"])
def shipped(request, window):
    """FreeCAD in a look that comes with it: two preference packs since 1.0, and the style sheets of 0.20."""
    resources = Path(FreeCAD.getResourceDir()) / "Gui"
    pack = resources / "PreferencePacks" / request.param / f"{request.param}.cfg"
    sheet = resources / "Stylesheets" / f"{request.param}.qss"
    if not (pack.exists() or (sheet.exists() and FreeCAD.Version()[0] == "0")):
        pytest.skip(f"this FreeCAD has no {request.param}")
    application = QtGui.QApplication.instance()
    style, before = application.style().objectName(), application.styleSheet()
    parameters = choose(pack) if pack.exists() else []
    if not pack.exists():
        application.setStyleSheet(sheet.read_text())
    window.idle(1.0)  # the light one may be what FreeCAD has at first
    yield request.param
    for parameter in parameters:
        set_parameter(*parameter)
    window.idle(0.3)
    application.setStyle(style)
    application.setStyleSheet(before)
    window.idle(0.3)
