# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that shows the results panel."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.document_command import DocumentCommand
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP

_HEIGHT = 300  # height of the panel, px


class ResultsCommand(DocumentCommand):
    """Show the results panel and give it the keyboard focus; hide the panel if it has the focus already."""

    name = "Vk_Results"
    menu = QT_TRANSLATE_NOOP("Vk_Results", "Toolpath Results")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Results",
        "Shows the analyzed operations with their strategies, machining times, simulation times and warnings.",
    )
    keys = "V, R"

    def Activated(self) -> None:
        dock = docks.find(docks.RESULTS)
        if docks.has_focus(dock):
            dock.hide()
        else:
            show()
            docks.find(docks.RESULTS).setFocus()


def refresh() -> None:
    """Refresh the results panel, if it exists, after Qt's pending events."""
    dock = docks.find(docks.RESULTS)
    if dock is not None:
        dock.refresh_soon()


def show() -> None:
    """Show the results panel without moving the keyboard focus, and refresh the panel after Qt's pending events."""
    from vkworkbench.gui.results.panel import ResultsDock

    dock = docks.find(docks.RESULTS)
    if dock is None:
        dock = ResultsDock(Gui.getMainWindow())
        docks.add(dock, _HEIGHT)
    else:
        docks.show(dock, _HEIGHT)
    dock.refresh_soon()


ResultsCommand.add()
