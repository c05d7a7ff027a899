# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each control has a text or an accessible name for screen readers."""

import pytest
from PySide import QtGui

from vkworkbench.gui.qt.widgets import area_of_views
from vkworkbench.gui.simulators.warning import Line

CONTROLS = QtGui.QAbstractButton, QtGui.QComboBox, QtGui.QAbstractSpinBox, QtGui.QAbstractSlider, QtGui.QLineEdit


def nameless(widget):
    """Return class and tooltip of all controls without a name, except controls that Qt makes as parts of others."""
    controls = [part for part in widget.findChildren(QtGui.QWidget) if isinstance(part, CONTROLS)]
    assert controls
    return [
        (part.metaObject().className(), part.toolTip())
        for part in controls
        if not part.objectName().startswith("qt_")
        and not isinstance(part, QtGui.QScrollBar)
        and not isinstance(part.parent(), CONTROLS)
        and not part.accessibleName()
        and not (isinstance(part, QtGui.QAbstractButton) and any(map(str.isalnum, part.text())))
    ]


@pytest.mark.parametrize(("command", "dock"), [("Toolpath Results", "VkResults"), ("Gauss Map", "VkGaussMap")])
def test_controls_of_docks_have_accessible_names(opened, window, command, dock):
    window.click(command)
    window.wait(lambda: window.first(QtGui.QDockWidget, dock))
    assert nameless(window.first(QtGui.QDockWidget, dock).widget()) == []
    window.click(command)


def test_controls_of_the_simulation_have_accessible_names(desk):
    tab = desk.shared(desk.small)
    assert nameless(tab) == []
    assert tab.player.play_bar.play_button.accessibleName() == "Plays or pauses the simulation (Space)."


def test_button_that_closes_the_warning_has_an_accessible_name(window):
    line = Line(area_of_views())
    line.way.setText("Simulate Toolpaths")
    assert nameless(line) == []
    line.end()
