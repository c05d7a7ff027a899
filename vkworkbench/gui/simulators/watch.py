# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notice that the user starts one of FreeCAD's simulators. Only the start of a simulator makes this module load numpy.

Menus, drop-down buttons and macros can start a simulator, and some of these starts trigger no action of a command. A
task panel always opens, so this module watches FreeCAD's task view for a new child widget, which each task adds.
"""

from __future__ import annotations

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QEvent, QObject, QWidget, single_shot
from vkworkbench.gui.simulators.panels import panels, simulator_of


class TaskWatch(QObject):
    """Look for a simulator's panel whenever a task view shows another task."""

    def __init__(self, view: QWidget) -> None:
        super().__init__(view)
        self._changed = single_shot(self._look, self)  # delayed until FreeCAD has completed the panel
        view.installEventFilter(self)

    def eventFilter(self, view, event) -> bool:
        if event.type() == QEvent.ChildAdded:
            self._changed.start()
        return False

    def _look(self) -> None:
        for panel in panels():
            if not panel.property("VkSeen"):
                panel.setProperty("VkSeen", True)
                _opened(panel)


_watched: dict[QWidget, TaskWatch] = {}  # references without which Python would delete the event filters


def watch() -> None:
    """Watch all existing task views of FreeCAD. A task view that is watched already is skipped."""
    for view in widgets.find(QWidget):
        if view.metaObject().className() == "Gui::TaskView::TaskView" and view not in _watched:
            _watched[view] = TaskWatch(view)


def _opened(panel: QWidget) -> None:
    """Show the warning for a simulator's panel, if warnings are on and the document has marks in the tree."""
    if preferences.read().warn_of_simulators and any(map(may_have_mark, FreeCAD.ActiveDocument.Objects)):
        from vkworkbench.gui.simulators import warning as simulator_warning

        simulator_warning.watch(panel, simulator_of(panel))
