# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks, the warning line and the simulation are readable in the themes that FreeCAD ships."""

import FreeCADGui as Gui
import numpy as np
import simulation_window
from pictures import contrast, counted, pixels, shows
from PySide import QtCore, QtGui

from vkworkbench import freecad, preferences
from vkworkbench.core import Stock
from vkworkbench.document.marks import marks
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.time_line import TimeLine
from vkworkbench.gui.simulators import panels as simulator_panels


def contrast_of_text(image):
    """Return the contrast between the background (the commonest colour) and the colour that differs most from it."""
    shades = counted(image)
    ((back, _),) = shades.most_common(1)
    return max(contrast(back, shade) for shade in shades)


def test_mark_is_readable_in_freecads_themes(shipped, marked, window):
    view = window.tree
    model = view.model()
    (found,) = model.match(model.index(0, 0), QtCore.Qt.DisplayRole, "Face", 1,
                           QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive | QtCore.Qt.MatchWrap)  # fmt: skip
    view.scrollTo(found)
    window.settle()
    window.screenshot(f"marks-{shipped.replace(' ', '-')}")
    area = view.visualRect(found.sibling(found.row(), 1)) & view.viewport().rect()
    # Take the picture from the main window, because some themes make the tree's own background transparent.
    place = QtCore.QRect(view.viewport().mapTo(window.main, area.topLeft()), area.size())
    image = window.main.grab(place).toImage()
    color = marks.read(marked.getObjectsByLabel("Face")[0]).strategy.color
    end = int(np.flatnonzero(shows(image, color).any(axis=0))[-1])  # last column of the pill
    assert contrast_of_text(image.copy(0, 0, end, image.height())) >= 4.5
    assert contrast_of_text(image.copy(end + 4, 0, 60, image.height())) >= 4.5


def test_warning_line_is_readable_in_freecads_themes(shipped, marked, window):
    window.activate("PathWorkbench" if freecad.version() < (1, 0) else "CAMWorkbench")
    preferences.write(time_budget=0.1)
    try:
        window.start_simulator(freecad.own_simulator())
        window.wait(lambda: window.first(QtGui.QFrame, "VkSimulatorWarning") is not None)
        window.settle()
        (line,) = [w for w in window.find(QtGui.QFrame, "VkSimulatorWarning") if w.isVisible()]
        window.screenshot(f"warning-{shipped.replace(' ', '-')}")
        for part in (line.text, line.way):
            assert contrast_of_text(line.grab(part.geometry()).toImage()) >= 4.5
    finally:
        preferences.write(time_budget=600.0)
        simulator_panels.close()
        window.settle()


def test_simulation_tab_is_opaque_in_freecads_themes(shipped, small, marked, window):
    window.see_all()  # show a colourful 3D view behind the tab, which would be visible through a transparent tab
    Gui.Selection.clearSelection()
    window.click(simulation_window.COMMAND)
    window.wait(lambda: simulation_window.tabs(window))
    (tab,) = simulation_window.tabs(window)
    try:
        window.wait(lambda: tab.player is not None, 120)
        window.settle()
        window.screenshot(f"simulation-{shipped.replace(' ', '-')}")
        # In a small window the results leave the tab no room, and in FreeCAD 1.1 the Tasks may cover the tab.
        for dock in window.find(QtGui.QDockWidget):
            if dock.objectName() in ("Tasks", "VkResults"):
                dock.hide()
        window.settle()
        bar = tab.player.play_bar.controls
        row = window.main.grab(QtCore.QRect(bar.mapTo(window.main, QtCore.QPoint(0, 0)), bar.size())).toImage()
        # The background is read between the buttons, because a narrow window has no space after the last button.
        shown = [widget.geometry() for widget in bar.findChildren(QtGui.QWidget) if widget.parent() is bar]
        free = [x for x in range(bar.width()) if all(x < one.left() or x > one.right() for one in shown)]
        assert len(free) > 10
        assert len(np.unique(pixels(row)[:, free].reshape(-1, 4), axis=0)) == 1
    finally:
        tab.window_of().close()
        window.settle()


def test_moment_is_visible_on_the_time_line(shipped, window):
    line, part = TimeLine(window.main), PartView(Stock((0, 0, 0), (1, 1, 1)), (0, 0, -1), window.main)
    try:
        line.setGeometry(0, 0, 300, 80)
        line.show_job((), 10.0)
        line.show_moment(5.0)
        line.show()
        window.settle()
        image = line.grab().toImage()
        assert contrast_of_text(image) >= 4.5
        assert image.pixelColor(20, 20).getRgb()[:3] == part.background  # time line and view have the same background
    finally:
        for widget in (line, part):
            widget.hide()
            widget.setParent(None)
            widget.deleteLater()
