# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices that the user starts one of FreeCAD's simulators. Loads no numpy before that.

Their commands can be called from menus, drop-down buttons and macros, and only some of these trigger the command's
action; but always a task panel opens. So the task view is watched for a new child, of which it gets one with each task.
"""

from __future__ import annotations

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QEvent, QObject, QWidget, single_shot
from vkworkbench.gui.simulators.panels import panels, simulator_of


class TaskWatch(QObject):
    """Looks for a simulator's panel whenever a task view shows another task."""

    def __init__(self, view: QWidget) -> None:
        super().__init__(view)
        self._changed = single_shot(self._look, self)  # the panel is complete once FreeCAD is done with it
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


_watched: dict[QWidget, TaskWatch] = {}  # kept: what belongs to a widget goes when Python lets go of the widget


def watch() -> None:
    """Watch the task views that there are now, each once."""
    for view in widgets.find(QWidget):
        if view.metaObject().className() == "Gui::TaskView::TaskView" and view not in _watched:
            _watched[view] = TaskWatch(view)


def _opened(panel: QWidget) -> None:
    """Warn of what the marks know about the simulation that a panel will start."""
    if preferences.read().warn_of_simulators and any(map(may_have_mark, FreeCAD.ActiveDocument.Objects)):
        from vkworkbench.gui.simulators import warning as simulator_warning

        simulator_warning.watch(panel, simulator_of(panel))
