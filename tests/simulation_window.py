# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helpers for tests of the tab of *Simulate Toolpaths*: open the tab, share it, wait for its pictures, drag in it."""

from __future__ import annotations

import os
import sys
import threading
import traceback
from contextlib import contextmanager

import events
import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from vkworkbench import preferences
from vkworkbench.gui.qt import docks
from vkworkbench.gui.simulation.tab import SimulationTab

COMMAND = "Simulate Toolpaths"
# Without a graphics card, each change in FreeCAD's window takes time in proportion to all pixels of the window.
SMALL = 860, 560  # px, size of the window
# px, size of the window for the whole job. Only the pictures of the documents need a larger window.
WHOLE = (1024, 700) if os.environ.get("VKWORKBENCH_SCREENSHOTS") else SMALL
PLAYER = 360, 320  # px, size of the player for smaller jobs, whose finest simulation takes a third of a second


def tabs(window):
    return [tab for tab in window.find(SimulationTab) if tab.isVisible()]


def shown(tab, window):
    """Wait for the finest picture of the job, and return the player."""
    window.wait(lambda: tab.player is not None and tab.player.simulation is not None, 120)
    finest(tab.player, window)
    return tab.player


def finest(player, window):
    """Wait for the finest picture of the current moment and view."""

    def rests():
        return player.simulation is not None and not player.is_busy and player.pictures.is_current

    while True:
        for _ in range(4):  # a picture can change the legend, which changes the layout and the view
            events.happen()
        if rests():
            return
        window.wait(rests, 300)


def make_small(tab, window):
    """Make the player of the simulation small as soon as it exists.

    If the job has nothing to simulate, FreeCAD shows a message box; wait for this box.
    """
    window.wait(lambda: tab.player is not None or window.boxes())
    if tab.player is not None:
        tab.player.setFixedSize(*PLAYER)


def close(window):
    """Close all simulation tabs with Esc."""
    for tab in tabs(window):
        window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


class Desk:
    """FreeCAD's window with an open document and its simulation tab, shared by the tests of a file.

    Parameters
    ----------
    window : Window
    example : Path
        File of the example job.
    folder : Path
        Folder for the files of smaller jobs, which the test files share.

    Attributes
    ----------
    document : Document or None
        The document that was opened last. A test may have closed the document.
    """

    def __init__(self, window, example, folder):
        self.window, self.example, self._folder = window, example, folder
        self.document = None
        self._path, self._tab, self._tolerance = None, None, 0.0
        self._before = window.main.geometry()
        self._is_active = False

    @property
    def small(self):
        """Path: file of the example job with four operations, the fastest to simulate."""
        return self._reduced("small", ("Face", "Pocket zigzag", "Pocket around island", "Drill holes"))

    @property
    def bare(self):
        """Path: file of the example job without operations."""
        return self._reduced("bare", ())

    def open(self, path):
        """Return the document of a file, opened again, with the analysis workbench active."""
        self.close()
        self.window.main.setGeometry(0, 0, *(WHOLE if path == self.example else SMALL))
        self._path, self.document = path, FreeCAD.openDocument(str(path))
        if not self._is_active:
            self.window.activate("VkWorkbench")
            self._is_active = True
        self.window.idle(0.02)  # waits until FreeCAD's tree shows the objects of the document
        self.window.tree.expandAll()
        Gui.Selection.clearSelection()
        return self.document

    def kept(self, path):
        """Return the document of a file without a tab. Open the file only if it is not open yet."""
        if self._is_open(path):
            close(self.window)
            return self.document
        return self.open(path)

    @contextmanager
    def changed(self, path):
        """Yield the document of a file for changes, and undo the changes afterwards."""
        document = self.kept(path)
        document.UndoMode = 1
        document.openTransaction("test")
        yield document
        close(self.window)
        document.commitTransaction()
        document.undo()
        document.clearUndos()
        document.UndoMode = 0

    def simulate(self):
        """Click on the command and return the tab, with a small player unless the whole example is simulated."""
        Gui.Selection.clearSelection()
        self.window.click(COMMAND)
        self.window.wait(lambda: tabs(self.window))
        (self._tab,) = tabs(self.window)
        if self._path != self.example:
            make_small(self._tab, self.window)
        return self._tab

    def shared(self, path, direction="Isometric", *, at_its_finest=True):
        """Return the tab in its initial state. The tab is reset, because other tests may have used it."""
        if not (self._is_open(path) and tabs(self.window) == [self._tab] and not self._tab.again.isVisible()):
            self.kept(path)
            tab = self.simulate()
            self.window.wait(lambda: tab.player is not None and tab.player.simulation is not None)
            self._tolerance = tab.player.scene_bar.tolerance.value()
        self._reset(direction)
        if at_its_finest:
            finest(self._tab.player, self.window)
        return self._tab

    def _is_open(self, path):
        return path == self._path and str(path) in (document.FileName for document in FreeCAD.listDocuments().values())

    def _reset(self, direction):
        """Reset all choices in the tab, and view the part from a standard direction."""
        player = self._tab.player
        bar, view = player.scene_bar, player.view
        Gui.Selection.clearSelection()
        bar.colorings.setCurrentIndex(0)
        bar.chips.setCurrentIndex(0)
        bar.tolerance.setValue(self._tolerance)
        bar.path.setChecked(False)
        bar.measure.setChecked(False)
        bar.section.begin(None)
        player.play_bar.speeds.setCurrentIndex(player.play_bar.speeds.count() - 1)
        if self._path != self.example:
            player.setFixedSize(*PLAYER)
        if (view._direction, view._offset, view._zoom) != (preferences.DIRECTIONS[direction], (0.0, 0.0), 1.0):
            player.look(direction)
        player.moment.go_to(player.clock.total)
        player.time_line._see(0.0, player.clock.total)
        self._tab.come_to_front()
        player.time_line.setFocus()

    def close(self):
        """Close the tab and the document."""
        close(self.window)
        if self.window.boxes():
            self.window.dismiss()
        for dock in self.window.find(QtGui.QDockWidget, docks.RESULTS):
            dock.hide()  # a visible panel would make the tab smaller
        if self.document is not None and self._is_open(self._path):
            FreeCAD.closeDocument(self.document.Name)
        self.document = self._path = self._tab = None
        self.window.idle(0.02)

    def leave(self):
        """Close the tab and the document, and restore the size of FreeCAD's window."""
        self.close()
        self.window.main.setGeometry(self._before)

    def _reduced(self, name, labels):
        """Return the file of the example job with only these operations. The first call saves the file."""
        path = self._folder / f"{name}.FCStd"
        if not path.exists():
            self.close()
            document = FreeCAD.openDocument(str(self.example))
            for op in [op for op in document.Job.Operations.Group if op.Label not in labels]:
                base = getattr(op, "Base", None)
                document.removeObject(op.Name)
                if hasattr(base, "TypeId"):  # FreeCAD has removed this base of a dress-up together with the dress-up
                    document.removeObject(base.Name)
            document.saveAs(str(path))
            FreeCAD.closeDocument(document.Name)
        return path


def drag(window, widget, start, end, button=QtCore.Qt.LeftButton, steps=6):
    """Drag the mouse with real mouse events."""
    window.mouse_press(widget, start, button)
    for number in range(1, steps + 1):
        part = QtCore.QPoint(start.x() + (end.x() - start.x()) * number // steps,
                             start.y() + (end.y() - start.y()) * number // steps)  # fmt: skip
        window.mouse_move(widget, part, button)
    window.mouse_release(widget, end, button)


def working():
    """Return the names of the functions on the stacks of all other threads."""
    frames = sys._current_frames()
    own = threading.get_ident()
    return [entry.name for thread, frame in frames.items() if thread != own for entry in traceback.extract_stack(frame)]
