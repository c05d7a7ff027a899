# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own simulators: their names, and the measurements of the first analysis."""

import FreeCADGui as Gui

from vkworkbench import freecad, preferences
from vkworkbench.core.simulators import DEFAULTS
from vkworkbench.document.computer import calibration
from vkworkbench.gui.qt.sentences import user

OLD = freecad.version() < (1, 0, 0)


def test_first_analysis_stores_the_opengl_renderer(marked):
    known = calibration.constants(calibration.known_speed(), preferences.read().renderer)
    assert preferences.read().renderer and known.cell != DEFAULTS.cell


def test_simulators_are_called_as_in_freecads_menu(opened, window):
    window.activate("PathWorkbench" if OLD else "CAMWorkbench")
    names = ["legacy"] if OLD else ["legacy", "OpenGL"]
    for name in names:
        (action, *_) = Gui.Command.get(freecad.simulator_command(name)).getAction()
        assert action.text().replace("&", "") == freecad.simulator_title(name) == user().simulator(name)
    assert freecad.own_simulator() == names[-1]
    assert freecad.simulator_title("z-buffer") is freecad.simulator_command("z-buffer") is None
    assert user().simulator("z-buffer") == "Simulate Toolpaths simulator"
