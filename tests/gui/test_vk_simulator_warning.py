# SPDX-License-Identifier: LGPL-2.1-or-later
"""The warning line above the view, when one of FreeCAD's simulators is started: when it is shown, and its button."""

import gc
import re

import dead_widgets
import FreeCADGui as Gui
import Path
import pytest
from cases import first_everywhere
from PySide import QtCore, QtGui

from vkworkbench import freecad, preferences
from vkworkbench.document.marks import marks, watcher
from vkworkbench.gui.simulators import panels as simulator_panels
from vkworkbench.gui.simulators.warning import OpenPanel

OLD = freecad.version() < (1, 0, 0)


@pytest.fixture(autouse=True)
def forgotten(monkeypatch):
    """Tell PySide which panels were deleted: otherwise FreeCAD sometimes cannot open the next panel."""
    close = simulator_panels.close

    def close_and_forget():
        close()
        dead_widgets.forget()

    monkeypatch.setattr(simulator_panels, "close", close_and_forget)


@pytest.fixture
def marked(marked, window):
    """The example job after an analysis, in FreeCAD's own workbench."""
    window.activate("PathWorkbench" if OLD else "CAMWorkbench")
    before = preferences.read().time_budget
    yield marked
    preferences.write(time_budget=before, warn_of_simulators=True)
    if Gui.Control.activeDialog():
        _close(window)
    for tab in window.find(QtGui.QMdiSubWindow):
        if tab.widget() is not None and tab.widget().metaObject().className() == "SimulationTab":
            tab.close()
    window.wait(lambda: not lines(window))


def _close(window):
    simulator_panels.close()
    window.wait(lambda: not Gui.Control.activeDialog() and simulator_panel(window) is None)


def lines(window):
    return [w for w in window.find(QtGui.QFrame, "VkSimulatorWarning") if w.isVisible()]


def simulator_panel(window):
    return next(iter(simulator_panels.panels()), None)


def start(window, name):
    """Start a simulator, and return the visible warning lines."""
    window.start_simulator(name)
    window.wait(lambda: simulator_panel(window) is not None)
    window.settle()
    return lines(window)


def warned(window, name):
    """Start a simulator, wait for its warning line, and return the line."""
    start(window, name)
    window.wait(lambda: lines(window))
    (line,) = lines(window)
    return line


def let_hang(document, label):
    """Give an operation an arc of angle 0, at which the legacy simulator hangs; analyse the operation."""
    (obj,) = document.getObjectsByLabel(label)
    obj.Path = Path.Path([*obj.Path.Commands, Path.Command("G2", {"X": 1.0, "Y": 1.0, "Z": -1.0, "I": 5.0, "J": 0.0}),
                          Path.Command("G2", {"X": 1.0, "Y": 1.0, "Z": -1.0, "I": 5.0, "J": 0.0})])  # fmt: skip
    obj.purgeTouched()  # the simulator recomputes touched operations, which would restore the path
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    Gui.runCommand("Vk_Analyze")
    Gui.Selection.clearSelection()
    return obj, obj.Path.Size - 1


@pytest.mark.long
def test_warning_is_not_shown_within_the_budget(marked, window):
    preferences.write(time_budget=1e5)
    for name in freecad.own_simulators():
        assert start(window, name) == []
        _close(window)


@pytest.mark.parametrize("simulator", first_everywhere(freecad.own_simulators()))
def test_warning_of_a_long_play_opens_the_simulation_tab(marked, window, simulator):
    preferences.write(time_budget=0.1)
    line = warned(window, simulator)
    Gui.activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    window.screenshot("warning-play")
    text = line.text.text().replace("\u00a0", " ")
    assert text.startswith("Playing this simulation takes about ") and text.endswith("at once, coarse at first.")
    assert freecad.simulator_title(simulator) in text
    # A non-breaking space keeps number and unit in one line.
    assert not re.search(r"\d (?:ms|s|min|h)\b", line.text.text())
    assert not line.isModal() and not window.boxes()
    assert line.text.height() >= line.text.heightForWidth(line.text.width())
    window.click_on(line.way)
    window.wait(lambda: any(t.windowTitle().startswith("Simulation") for t in window.find(QtGui.QMdiSubWindow)))
    assert lines(window) == [] and not Gui.Control.activeDialog()
    # After closing the panel, the document has no objects that the legacy simulator made.
    assert not [o for o in marked.Objects if o.Name.startswith("Cut")]


def test_warning_is_hidden_without_a_panel_or_ticked_operations(marked, window):
    preferences.write(time_budget=0.1)
    line = warned(window, "legacy")
    _close(window)
    window.wait(lambda: lines(window) == [])
    line = warned(window, "legacy")
    listed = simulator_panel(window).findChild(QtGui.QListWidget, "listOperations")
    for row in range(listed.count()):
        listed.item(row).setCheckState(QtCore.Qt.Unchecked)
    window.wait(lambda: not line.isVisible())
    listed.item(0).setCheckState(QtCore.Qt.Checked)
    window.wait(line.isVisible)
    window.click_on(line.close_button)
    assert lines(window) == []
    listed.item(1).setCheckState(QtCore.Qt.Checked)
    window.settle()
    assert lines(window) == []  # a warning that the user has closed does not appear again


@pytest.mark.long
def test_click_after_closing_the_panel_does_nothing(marked, window):
    preferences.write(time_budget=0.1)
    (line,) = start(window, "legacy")
    (panel,) = (child for child in line.children() if isinstance(child, OpenPanel))
    simulator_panels.close()
    # The timer that looks for closed panels has not run yet, so the line is still visible.
    assert simulator_panel(window) is None and line.isVisible()
    panel._take()  # a direct call, because an exception in a function that Qt calls would not fail the test
    assert lines(window) == []
    window.idle()
    assert not Gui.Control.activeDialog() and simulator_panel(window) is None


@pytest.mark.skipif(not OLD, reason="FreeCAD itself keeps a panel since 1.0")
def test_closed_simulator_panels_are_deleted(marked, window):
    # If Python kept the old panel, PySide would mistake a new widget at the same address for the old panel, and the
    # next panel could not open.
    def kept():
        return sum(type(thing) is QtGui.QDialog for thing in gc.get_objects())

    preferences.write(time_budget=0.1)
    gc.collect()
    before = kept()
    for _ in range(2):
        warned(window, "legacy")
        _close(window)
        gc.collect()
        assert kept() == before


@pytest.mark.long
def test_warning_names_an_operation_that_hangs_the_simulator(marked, window):
    preferences.write(time_budget=1e5)
    _, command = let_hang(marked, "Bore")
    line = warned(window, "legacy")
    window.screenshot("warning-hangs")
    assert f"command {command + 1} of Bore" in line.text.text().replace("\u00a0", " ")


@pytest.mark.long
def test_outdated_marks_cause_no_warning(marked, window):
    preferences.write(time_budget=1e5)
    obj, _ = let_hang(marked, "Bore")
    obj.Path = Path.Path(obj.Path.Commands[:-2])
    watcher.check(marked)
    assert marks.is_outdated(obj)
    assert start(window, "legacy") == []


@pytest.mark.long
def test_no_warning_without_marks_or_when_switched_off(marked, window):
    preferences.write(time_budget=0.1, warn_of_simulators=False)
    assert start(window, "legacy") == []
    _close(window)
    preferences.write(warn_of_simulators=True)
    Gui.runCommand("Vk_Clear")
    assert start(window, "legacy") == []


def test_every_way_to_start_a_simulator_shows_the_warning(marked, window):
    """Tool buttons with a menu, and runCommand, do not trigger the action of the command."""
    preferences.write(time_budget=0.1)
    command = freecad.simulator_command(freecad.own_simulator())
    action = Gui.Command.get(command).getAction()[0]
    for begin in (lambda: Gui.runCommand(command), action.trigger):
        window.wait(action.isEnabled)
        begin()
        window.wait(lambda: lines(window))
        _close(window)
        window.wait(lambda: not lines(window))
