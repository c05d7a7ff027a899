# SPDX-License-Identifier: LGPL-2.1-or-later
"""A class that uses FreeCAD's window as a user does (wait, click, type, look), and fixtures for several test files."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from xml.etree import ElementTree

import dead_widgets
import events
import FreeCAD
import FreeCADGui as Gui
import kept_example
import pytest
from cases import first_everywhere
from coarse import coarse_check
from PySide import QtCore, QtGui
from simulation_window import SMALL, Desk

try:  # PySide2 first, because FreeCAD crashes if PySide6 is imported while FreeCAD uses PySide2
    from PySide2.QtTest import QTest
except ImportError:
    from PySide6.QtTest import QTest

from vkworkbench import freecad, preferences
from vkworkbench.core.zbuffer import Speed
from vkworkbench.document.computer import calibration, idle
from vkworkbench.document.job.results import RESULTS
from vkworkbench.gui.qt import docks, widgets
from vkworkbench.gui.qt.renderer import note_renderer
from vkworkbench.gui.results import command as results
from vkworkbench.gui.tree import column as tree

CAM_WORKBENCH = "PathWorkbench" if freecad.version() < (1, 0) else "CAMWorkbench"


def use_default_speeds(patch):
    patch.setattr(calibration, "measure_speed", lambda going_on: Speed())


@pytest.fixture
def default_preferences():
    """Reset the preferences to their defaults before and after the test."""
    group = FreeCAD.ParamGet(preferences.GROUP)
    group.Clear()
    yield
    group.Clear()


@pytest.fixture
def default_speeds(monkeypatch):
    """Let calibrations of a test find the default speeds without measuring."""
    use_default_speeds(monkeypatch)


@pytest.fixture(scope="session", autouse=True)
def usual_computer():
    """Calibrate FreeCAD with the default speeds, so that no predicted time depends on this computer."""
    with pytest.MonkeyPatch.context() as patch:
        use_default_speeds(patch)
        note_renderer()
        calibration.calibrate()


@pytest.fixture(scope="session", autouse=True)
def checked_coarsely():
    """Check simulated jobs coarsely; the tests of the core and of the documents check which faults are found."""
    with coarse_check():
        yield


@pytest.fixture(scope="session", autouse=True)
def coarse_legacy_simulator():
    """Start FreeCAD's legacy simulator with its coarsest mesh; its finest mesh has a million triangles."""
    # Imported here and not at the top of the file, because stranger.py imports this file and does not find examples/.
    from make_example import cam

    module = cam("Main.Gui.Simulator")
    make_panel = module.CAMSimTaskUi.__init__

    def make_coarse_panel(panel, simulation):
        make_panel(panel, simulation)
        panel.form.sliderAccuracy.setValue(panel.form.sliderAccuracy.minimum())

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module.CAMSimTaskUi, "__init__", make_coarse_panel)
        yield


@pytest.fixture
def restored_calibration():
    """Return the path of the calibration file, and restore the file's content after the test."""
    path = calibration._path()
    before = path.read_bytes()
    yield path
    path.write_bytes(before)


@pytest.fixture(autouse=True)
def nothing_known(request):
    """Forget the results of earlier analyses, unless the test uses the marks in the example that stays open."""
    if not ("marked" in request.fixturenames and request.getfixturevalue("kept_document").is_marked):
        RESULTS.clear()


@pytest.fixture(autouse=True)
def no_dead_widgets():
    """After a test that opened a FreeCAD simulator, invalidate PySide's wrappers of the deleted widgets."""
    yield
    if Window.opened_simulator:
        Window.opened_simulator = False
        dead_widgets.forget()


@pytest.fixture(autouse=True)
def mouse_below_the_window():
    """Move the pointer away, because FreeCAD 1.1 selects at the pointer's position instead of the event's position."""
    QtGui.QCursor.setPos(QtGui.QApplication.primaryScreen().geometry().bottomRight())


@pytest.fixture
def nothing_swallowed(monkeypatch):
    """Fail if Qt calls a function that raises: FreeCAD would swallow the exception."""
    errors = []
    monkeypatch.setattr(sys, "excepthook", lambda *error: errors.append(error))
    monkeypatch.setattr(threading, "excepthook", errors.append)
    yield
    assert errors == []


DARK = """
QWidget { background-color: #26282c; color: #e6e6e6; }
QTreeView, QTableView { background-color: #1e1f22; alternate-background-color: #26282c; color: #e6e6e6; }
QTreeView::item:selected, QTableView::item:selected { background-color: #3d5a80; color: #ffffff; }
QHeaderView::section { background-color: #33363b; color: #e6e6e6; }
"""


class Window:
    """FreeCAD's main window."""

    opened_simulator = False  # whether the test has opened a simulator of FreeCAD

    def __init__(self):
        self.main = Gui.getMainWindow()
        if not os.environ.get("VKWORKBENCH_SCREENSHOTS"):
            # Without a graphics card, the navigation cube and the axes take a third of the drawing time of a small
            # view.
            view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
            for drawn in ("ShowNaviCube", "CornerCoordSystem", "UseNavigationAnimations"):
                view.SetBool(drawn, False)
        self.main.setGeometry(0, 0, 1280, 1000)

    def wait(self, until, seconds=120.0):
        """Handle events until a condition holds; the limit is long, because three FreeCADs may share two processors."""
        end = time.monotonic() + seconds
        while not until():
            assert time.monotonic() < end, f"waited {seconds} s in vain"
            events.happen()

    def idle(self, seconds=0.2):
        """Handle events for a fixed time; only for a test that nothing happens."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            events.happen()

    def settle(self):
        """Handle all pending events, the timers of the trees, and the add-on's deferred work."""
        for _ in range(2):
            QtGui.QGuiApplication.sync()
            events.happen()
        # FreeCAD's trees show a selection or a change after a timer. The timers are searched for only once, because a
        # search creates a Python object for each widget of FreeCAD.
        timers = [timer for view in tree.trees() for timer in view.findChildren(QtCore.QTimer)]
        self.wait(lambda: not (idle._works or idle._calls or any(timer.isActive() for timer in timers)))

    def activate(self, workbench):
        if Gui.activeWorkbench().name() != workbench:
            Gui.activateWorkbench(workbench)
            self.settle()
        # Show the tree's dock, which FreeCAD hides because it starts without a workbench.
        shown = {"Combo View": True, "Model": True, "Report view": False, "Python console": False}
        for widget in self.find((QtGui.QDockWidget, QtGui.QTabWidget, QtGui.QToolBar)):
            name = widget.objectName()
            if name in shown and isinstance(widget, QtGui.QDockWidget):
                widget.setVisible(shown[name])
                widget.raise_()  # in FreeCAD 1.x the task panel can cover the tree
            # In FreeCAD 0.20, choose the tab with the tree, because some workbenches choose the tab with the tasks.
            elif name == "combiTab":
                widget.setCurrentIndex(0)
            # Move the toolbar to a separate row, in which it has room for all its buttons.
            elif name == "Toolpath Analysis" and not self.main.toolBarBreak(widget):
                self.main.insertToolBarBreak(widget)
        self.settle()

    def find(self, kind, name=None):
        """Return all widgets of a class or of several, kept until the next call so that PySide does not delete them."""
        self.found = widgets.find(kind, name)
        return self.found

    def first(self, kind, name=None):
        return next(iter(self.find(kind, name)), None)

    def button(self, text):
        """Return the visible tool button of the command with this menu text."""
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

    def show_results(self):
        """Show the results panel and return it."""
        results.show()
        self.settle()
        return self.first(QtGui.QDockWidget, docks.RESULTS)

    def start_simulator(self, name):
        """Start a simulator of FreeCAD as its command does, after removing the remains of earlier panels."""
        dead_widgets.forget()
        Window.opened_simulator = True
        Gui.runCommand(freecad.simulator_command(name))

    def click_on(self, widget):
        QTest.mouseClick(widget, QtCore.Qt.LeftButton)

    def click_at(self, widget, where):
        QTest.mouseClick(widget, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, where)

    def mouse_press(self, widget, where, button):
        QTest.mousePress(widget, button, QtCore.Qt.NoModifier, where)

    def mouse_move(self, widget, where, button):
        """Move the mouse while a button is held, which QTest cannot do."""
        event = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, QtCore.QPointF(where), QtCore.QPointF(widget.mapToGlobal(where)),
                                  QtCore.Qt.NoButton, button, QtCore.Qt.NoModifier)  # fmt: skip
        QtGui.QApplication.sendEvent(widget, event)
        QtGui.QApplication.processEvents()

    def mouse_release(self, widget, where, button):
        QTest.mouseRelease(widget, button, QtCore.Qt.NoModifier, where)

    def wheel(self, widget, where, notches=1):
        """Turn the mouse wheel; a positive number of notches turns the wheel away from the user."""
        place = QtCore.QPointF(where)
        event = QtGui.QWheelEvent(place, QtCore.QPointF(widget.mapToGlobal(where)), QtCore.QPoint(),
                                  QtCore.QPoint(0, 120 * notches), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
                                  QtCore.Qt.NoScrollPhase, False)  # fmt: skip
        QtGui.QApplication.sendEvent(widget, event)

    def ask_for_tooltip(self, widget, where):
        """Let the pointer rest at a place of a widget."""
        event = QtGui.QHelpEvent(QtCore.QEvent.ToolTip, where, widget.mapToGlobal(where))
        QtGui.QApplication.sendEvent(widget, event)

    def tooltip(self, label):
        """Return the tooltip of an object's description in the tree."""
        QtGui.QToolTip.hideText()
        self.ask_for_tooltip(self.tree.viewport(), self.tree.visualRect(self.cell(label)).center())
        self.wait(QtGui.QToolTip.isVisible)
        return QtGui.QToolTip.text()

    def press(self, widget, key):
        QTest.keyClick(widget, key)

    def type(self, widget, text):
        QTest.keyClicks(widget, text)

    def top_level(self, kind):
        """Return the visible top-level widgets of a class."""
        return [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, kind) and w.isVisible()]

    def boxes(self):
        """Return the open message boxes."""
        return self.top_level(QtGui.QMessageBox)

    def progress_dialog(self):
        """Return the visible progress dialog, or None."""
        return next(iter(self.top_level(QtGui.QProgressDialog)), None)

    def answer_file_dialog(self, path, begin):
        """Call `begin`, which opens a file dialog, type a path in it, and return the dialog's title."""
        titles = []

        def answer():
            dialogs = self.top_level(QtGui.QFileDialog)
            if not dialogs:
                QtCore.QTimer.singleShot(50, answer)
                return
            titles.append(dialogs[0].windowTitle())
            name = dialogs[0].findChild(QtGui.QLineEdit)
            name.setText(str(path))
            self.press(name, QtCore.Qt.Key_Return)

        QtCore.QTimer.singleShot(50, answer)
        begin()
        self.settle()
        (title,) = titles
        return title

    def dismiss(self):
        """Close all message boxes with their first button, and return their texts."""
        texts = []
        for box in self.boxes():
            texts.append(box.text())
            QTest.mouseClick(box.buttons()[0], QtCore.Qt.LeftButton)
        self.settle()
        return texts

    @property
    def tree(self):
        return next(view for view in tree.trees() if view.isVisible())

    def cell(self, label, column=1):
        """Return the index of a cell of the tree; the label is the text in the first column of its row."""
        model = self.tree.model()
        (found,) = model.match(model.index(0, 0), QtCore.Qt.DisplayRole, label, 1,
                               QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive | QtCore.Qt.MatchWrap)  # fmt: skip
        return found.sibling(found.row(), column)

    def descriptions(self):
        """Return {label: description} of all rows of the tree."""
        model, found = self.tree.model(), {}

        def visit(parent):
            for row in range(model.rowCount(parent)):
                index = model.index(row, 0, parent)
                found[index.data()] = model.index(row, 1, parent).data()
                visit(index)

        visit(QtCore.QModelIndex())
        return found

    def see_all(self):
        """Show the whole job in the 3D view, seen from the front, right and above."""
        Gui.activeView().viewIsometric()
        Gui.SendMsgToActiveView("ViewFit")

    def screenshot(self, name):
        """Save a picture of the screen for docs/take_pictures.py, if tests/run.sh was asked for pictures."""
        folder = os.environ.get("VKWORKBENCH_SCREENSHOTS")
        if not folder:
            self.settle()
            return
        Path(folder).mkdir(parents=True, exist_ok=True)
        self.idle(0.5)
        path = Path(folder) / f"{name}-{'.'.join(FreeCAD.Version()[:2])}.png"
        subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)


@pytest.fixture(scope="session")
def window():
    return Window()


@pytest.fixture
def small(window):
    """Make the window small, so that the finest picture of a simulation is computed quickly."""
    before = window.main.geometry()
    window.main.setGeometry(0, 0, *SMALL)
    yield
    window.main.setGeometry(before)


@pytest.fixture(scope="session")
def kept_document(example_path):
    """The document of the example, which stays open until a test changes it."""
    return kept_example.KeptExample(example_path)


@pytest.fixture(scope="module")
def desk(window, example_path, tmp_path_factory):
    """FreeCAD's window with the document and the simulation tab that the tests of a file share."""
    desk = Desk(window, example_path, tmp_path_factory.getbasetemp())
    yield desk
    desk.leave()


@pytest.fixture
def document(desk):
    """A freshly opened job of four operations, which the test may change."""
    return desk.open(desk.small)


def hide_results(window):
    """Hide the results panel, so that the 3D view is larger."""
    for dock in widgets.docks():
        if dock.objectName() == docks.RESULTS:
            dock.hide()


@pytest.fixture(autouse=True)
def no_kept_document(request):
    """Close the example, which stays open between tests, before a test that uses the window without the example."""
    names = set(request.fixturenames)
    if not {"opened", "marked"} & names and {"window", "example_path"} & names:
        hide_results(request.getfixturevalue("window"))
        request.getfixturevalue("kept_document").close()


@pytest.fixture
def opened(kept_document, window, request):
    """The example job, expanded in the tree of the analysis workbench; only the fixture `marked` adds marks."""
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
    if kept_document.document is None:
        window.settle()


@pytest.fixture
def marked(opened, kept_document, window):
    """The example job after a click on *Analyze toolpaths*."""
    if not kept_document.is_marked:
        window.analyze(opened)
        window.dismiss()
        window.tree.expandAll()
        kept_document.has_marks()
    elif not any(map(tree.is_seen, window.find(QtGui.QDockWidget, docks.RESULTS))):
        window.click("Toolpath Results")
    window.settle()
    return opened


@pytest.fixture(scope="module", params=first_everywhere(["dark", "light"]))
def theme(request, window):
    application = QtGui.QApplication.instance()
    before = application.styleSheet()
    if request.param == "dark":
        application.setStyleSheet(DARK)
    yield request.param
    application.setStyleSheet(before)
    window.idle()


def choose(pack):
    """Set the parameters of a preference pack as FreeCAD does; return the former values."""
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
    """Set a parameter, or remove it if the value is None; return the former value."""
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
    """FreeCAD in each theme that it ships: two preference packs since 1.0, style sheets in 0.20."""
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
    window.idle(1.0)  # FreeCAD applies a theme later. Waiting for a change would fail for the theme already in use.
    yield request.param
    for parameter in parameters:
        set_parameter(*parameter)
    window.idle(0.3)
    application.setStyle(style)
    application.setStyleSheet(before)
    window.idle(0.3)
