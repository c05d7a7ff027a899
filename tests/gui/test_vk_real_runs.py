# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulations that the user runs teach the calibration how long they take."""

import time

import FreeCADGui as Gui
import numpy as np
import pytest
from opengl_window import FASTER, PLAY, click
from PySide import QtCore, QtGui

from vkworkbench import freecad, preferences
from vkworkbench.core.simulators import DEFAULTS, opengl_speeds
from vkworkbench.document.computer import calibration
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.simulators import panels as simulator_panels
from vkworkbench.gui.simulators import real_runs
from vkworkbench.gui.simulators.real_runs import OpenGLRun, _played

OLD = freecad.version() < (1, 0, 0)


@pytest.fixture
def calibrated(marked, window):
    """The example job after a first analysis, in FreeCAD's own workbench."""
    window.activate("PathWorkbench" if OLD else "CAMWorkbench")
    yield marked
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()


@pytest.fixture
def undisturbed(monkeypatch):
    """The processor always works for FreeCAD: other programs must not decide what these runs teach."""
    monkeypatch.setattr(real_runs, "_now", lambda: np.full(2, time.perf_counter()))


_ACCURACY = 6  # of the 10 positions of the slider; at 10, the default, meshes have three times as many triangles


def runs():
    return calibration.load(preferences.read().renderer).runs


def simulator(window, name, label):
    """Open a simulator's panel with one operation ticked, coarsely; return a function that finds its buttons by name."""
    window.start_simulator(name)
    window.wait(simulator_panels.panels)
    window.settle()  # the add-on notices it
    (panel,) = simulator_panels.panels()
    listed = panel.findChild(QtGui.QListWidget, "listOperations")
    for row in range(listed.count()):
        ticked = QtCore.Qt.Checked if listed.item(row).text() == label else QtCore.Qt.Unchecked
        listed.item(row).setCheckState(ticked)
    if name == "legacy":
        panel.findChild(QtGui.QSlider, "sliderAccuracy").setValue(_ACCURACY)
    return lambda name: panel.findChild(QtGui.QToolButton, name)


def test_the_first_analysis_calibrates(calibrated):
    known = calibration.load(preferences.read().renderer)
    assert preferences.read().renderer and known.constants.cell != DEFAULTS.cell


def test_runs_of_the_legacy_simulator_teach(calibrated, undisturbed, window):
    before = {name: len(values) for name, values in runs().items()}
    button = simulator(window, "legacy", "Bore")
    for name, taught in (("toolButtonFF", "fast-forward"), ("toolButtonPlay", "play")):
        window.click_on(button(name))
        assert not button(name).isEnabled()
        window.wait(lambda: button(name).isEnabled())
        window.wait(lambda: len(runs().get(taught, ())) == before.get(taught, 0) + 1)
    assert len(runs()["fast-forward"][-1]) == 3
    shown, drawn, display_seconds, seconds = runs()["play"][-1]
    assert 80 < shown < 100 and drawn > 1e5 and display_seconds < seconds
    assert 0 < calibration.constants(preferences.read().renderer).redraw < 1


def test_a_run_that_was_disturbed_teaches_nothing(calibrated, window, monkeypatch):
    monkeypatch.setattr(real_runs, "_now", lambda: np.array([1e3 * time.perf_counter(), 0.0]))
    before = runs()
    button = simulator(window, "legacy", "Bore")
    window.click_on(button("toolButtonFF"))
    window.wait(lambda: button("toolButtonFF").isEnabled())
    window.idle()
    assert runs() == before


def test_a_run_that_was_paused_teaches_nothing(calibrated, window):
    before = runs()
    button = simulator(window, "legacy", "Bore")
    (bar,) = (panel.findChild(QtGui.QProgressBar, "progressBar") for panel in simulator_panels.panels())
    window.click_on(button("toolButtonPlay"))
    window.wait(lambda: bar.value() > 0)
    window.click_on(button("toolButtonPause"))
    window.settle()
    window.click_on(button("toolButtonFF"))
    window.wait(lambda: button("toolButtonFF").isEnabled())
    window.idle()
    assert runs() == before


@pytest.mark.skipif(OLD, reason="FreeCAD 0.20 has no OpenGL simulator")
def test_a_run_of_the_opengl_simulator_teaches(calibrated, undisturbed, window):
    before = len(runs().get("draw", ()))
    button = simulator(window, "OpenGL", "Pocket zigzag")
    window.click_on(button("toolButtonPlay"))

    def shown():
        return [w for w in QtGui.QGuiApplication.allWindows() if "CAMSim" in w.metaObject().className()]

    window.wait(shown)
    (simulation,) = shown()
    simulation.requestActivate()
    window.idle(2)
    faster = len(opengl_speeds(freecad.version())) - 1
    for where in [FASTER] * faster + [PLAY]:
        click(simulation, *where)
        window.idle(0.3)
    watch = simulation.findChild(OpenGLRun)
    window.wait(lambda: len(watch._times) > 150)  # twice as many frames as it has to play
    simulation.close()
    window.wait(lambda: len(runs().get("draw", ())) == before + 1)
    known = calibration.load(preferences.read().renderer).constants
    assert 0 < known.draw < 1e-3 and known.opengl_factor >= 2  # one run tells no error
    of_frames, of_play = runs()["draw"][-1]
    assert of_frames > 0 and of_play > 0


def test_the_end_of_a_play_is_found_while_other_programs_run():
    growing, finished = 0.03 + 0.0015 * np.arange(70), np.full(80, 0.021)
    frames = np.concatenate((growing, finished))
    for begin, end in ((5, 12), (35, 42), (60, 64), (70, 90)):
        frames[begin:end] *= 2.5
    assert _played(frames) == 70
    assert _played(growing) == _played(finished) == _played(frames[:0]) == 0


def test_simulators_are_called_as_in_freecads_menu(opened, window):
    window.activate("PathWorkbench" if OLD else "CAMWorkbench")
    names = ["legacy"] if OLD else ["legacy", "OpenGL"]
    for name in names:
        (action, *_) = Gui.Command.get(freecad.simulator_command(name)).getAction()
        assert action.text().replace("&", "") == freecad.simulator_title(name) == user().simulator(name)
    assert freecad.own_simulator() == names[-1]
    assert freecad.simulator_title("z-buffer") is freecad.simulator_command("z-buffer") is None
    assert user().simulator("z-buffer") == "extended z-buffer"
