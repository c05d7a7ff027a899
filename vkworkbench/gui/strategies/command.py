# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that colours toolpaths in the 3D view by strategy."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

from vkworkbench.document.job.operations import find
from vkworkbench.gui.qt.document_command import DocumentCommand
from vkworkbench.gui.qt.plain_text import inform
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.strategies import view


class StrategiesCommand(DocumentCommand):
    """Switch the colours of the active document's toolpaths on or off."""

    name = "Vk_Strategies"
    menu = QT_TRANSLATE_NOOP("Vk_Strategies", "Show Strategies")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Strategies",
        "Colors the toolpaths in the 3D view by their machining strategy, and rapid "
        "moves gray. The document is not changed.",
    )
    keys = "V, C"

    def GetResources(self) -> dict:
        return {**super().GetResources(), "Checkable": False}  # a checkable button whose initial state is unchecked

    def Activated(self, checked: int) -> None:
        document = FreeCAD.ActiveDocument
        if document is None or bool(checked) == view.is_shown(document):
            return
        if not checked:
            view.hide(document)
            return
        if not find(document):
            follow_document(document)
            text = translate(
                "Vk_Strategies",
                "There is no toolpath to color in this document. Create a job with operations, or import G-code.",
            )
            inform(translate("Vk_Strategies", "Show Strategies"), text, Gui.getMainWindow())
            return
        view.show(document, lambda: follow_document(FreeCAD.ActiveDocument))


def follow_document(document) -> None:
    """Show on the command's button whether the toolpaths of a document are coloured."""
    for action in Gui.Command.get(StrategiesCommand.name).getAction():
        action.setChecked(view.is_shown(document))


class _ActiveDocument:
    """Shows on the command's button whether the toolpaths of the active document are coloured."""

    def slotActivateDocument(self, document) -> None:
        follow_document(document)

    def slotDeletedDocument(self, document) -> None:
        follow_document(FreeCAD.ActiveDocument)


StrategiesCommand.add()
FreeCAD.addDocumentObserver(_ActiveDocument())
