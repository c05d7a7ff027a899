# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that simulates toolpaths, in a tab of FreeCAD's window."""

from __future__ import annotations

from collections.abc import Iterator

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.core import Strategy
from vkworkbench.document.recognized import recognized
from vkworkbench.document.simulation import SimulatedJob, read_job
from vkworkbench.gui.plain_text import tell
from vkworkbench.gui.qt import QMdiArea
from vkworkbench.gui.selection import selected_operations
from vkworkbench.gui.sentences import said
from vkworkbench.gui.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.language import Unusable

NAME = "Vk_Simulate"


class SimulateCommand:
    """Simulate the selected job or operations, or the job of the active document."""

    def GetResources(self) -> dict[str, str]:
        text = QT_TRANSLATE_NOOP(
            "Vk_Simulate",
            "Simulates the selected job or operations, or the job of the active document, and shows the part at any "
            "moment, what made each of its surfaces, and rapid moves that cut.",
        )
        return {
            "MenuText": QT_TRANSLATE_NOOP("Vk_Simulate", "Simulate toolpaths"),
            "ToolTip": text,
            "WhatsThis": text,
            "Pixmap": NAME,
            "Accel": "V, S",
        }

    def IsActive(self) -> bool:
        return FreeCAD.ActiveDocument is not None

    def Activated(self) -> None:
        if FreeCAD.ActiveDocument is not None:
            open_tab(selected_operations() or FreeCAD.ActiveDocument)


def open_tab(what):
    """Open a tab that simulates operations; return it, or None where there is nothing to simulate, which is told."""
    from vkworkbench.gui.simulation.tab import SimulationTab

    window = Gui.getMainWindow()
    try:
        job = read_job(what)
    except Unusable as error:
        tell(translate("Vk_Simulate", "Simulate toolpaths"), said(error.what), window)
        return None
    tab = SimulationTab(job, tuple(_strategies(job)))
    tab.setWindowTitle(translate("Vk_Simulate", "Simulation: {}").format(_title(job)))
    tab.setWindowIcon(Gui.getIcon(NAME))
    tab.outdated.connect(lambda: _again(tab))
    window.findChild(QMdiArea).addSubWindow(tab)
    tab.showMaximized()
    tab.setFocus()
    return tab


def _again(tab) -> None:
    """Simulate the operations of a tab as they are now, in a new tab in its place."""
    document = FreeCAD.getDocument(tab.job.operations[0].document)
    objects = [document.getObject(operation.name) for operation in tab.job.operations]
    tab.window_of().close()
    open_tab([obj for obj in objects if obj is not None] or document)


def _title(job: SimulatedJob) -> str:
    """The document's label, or that of the only operation."""
    if len(job.operations) == 1:
        return job.operations[0].label
    return FreeCAD.getDocument(job.operations[0].document).Label


def _strategies(job: SimulatedJob) -> Iterator[Strategy]:
    """The strategies of a job's operations, as they are marked."""
    for operation, cut in zip(job.operations, job.cuts):
        imported = freecad.is_imported(FreeCAD.getDocument(operation.document).getObject(operation.name))
        found, _ = recognized(cut.toolpath, cut.tool.diameter, imported)
        yield found.strategy


Gui.addCommand(NAME, SimulateCommand())
