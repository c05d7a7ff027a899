# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that shows or hides the Gauss map panel."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.document_command import DocumentCommand
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP

_HEIGHT = 420  # height of the panel, px


class GaussMapCommand(DocumentCommand):
    """Show the Gauss map panel and give it the keyboard focus; hide the panel if it has the focus already."""

    name = "Vk_GaussMap"
    menu = QT_TRANSLATE_NOOP("Vk_GaussMap", "Gauss Map")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_GaussMap",
        "Shows why the selected operation has its strategy. Shows the toolpath, the "
        "Gauss map of its directions and of the vector V_k, and the cumulative angular "
        "function.",
    )
    keys = "V, G"

    def Activated(self) -> None:
        dock = docks.find(docks.GAUSS_MAP)
        if docks.has_focus(dock):
            dock.hide()
        else:
            show()
            docks.find(docks.GAUSS_MAP).setFocus()


def show() -> None:
    """Show the Gauss map panel."""
    dock = docks.find(docks.GAUSS_MAP)
    if dock is None:
        from vkworkbench.gui.gauss.dock import GaussMapDock

        docks.add(GaussMapDock(Gui.getMainWindow()), _HEIGHT)
    else:
        docks.show(dock, _HEIGHT)


GaussMapCommand.add()
