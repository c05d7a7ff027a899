# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that simulates toolpaths, in a tab of FreeCAD's window."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

from vkworkbench.document.job.operations import find, jobs_of, posted
from vkworkbench.document.simulation.copy import JobCopy, copy_job
from vkworkbench.gui.qt import docks, widgets
from vkworkbench.gui.qt.document_command import DocumentCommand, selected_operations
from vkworkbench.gui.qt.plain_text import choose, inform
from vkworkbench.gui.qt.sentences import sentence
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.language import Unusable

_LOW = 400  # minimum height for which the tab makes room, px; a lower tab hides some rows of controls


class SimulateCommand(DocumentCommand):
    """Simulate the selected job or operations, or the job of the active document.

    If the document has several jobs, the command asks for one of them.
    """

    name = "Vk_Simulate"
    menu = QT_TRANSLATE_NOOP("Vk_Simulate", "Simulate Toolpaths")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Simulate",
        "Simulates the selected job or operations, or the job of the active document. "
        "Shows the part at any moment, the operation that made each surface, and rapid "
        "moves that cut.",
    )
    keys = "V, M"

    def Activated(self) -> None:
        document, selected = FreeCAD.ActiveDocument, selected_operations()
        if document is None:
            return
        jobs = [] if selected else list(jobs_of(posted(find(document))).values())
        if len(jobs) > 1:
            # The numbers distinguish jobs with the same label.
            labels = [f"{number}. {job.Label}" for number, job in enumerate(jobs, 1)]
            title = translate("Vk_Simulate", "Simulate Toolpaths")
            text = translate("Vk_Simulate", "Choose the job to simulate:")
            choose(title, text, labels, lambda number: open_tab(jobs[number]), Gui.getMainWindow())
        else:
            open_tab(selected or document)


def open_tab(what):
    """Open a tab that simulates operations, and return it; if nothing can be simulated, say why and return None."""
    from vkworkbench.gui.simulation.tab import SimulationTab

    window = Gui.getMainWindow()
    try:
        copy = copy_job(what)
    except Unusable as error:
        inform(translate("Vk_Simulate", "Simulate Toolpaths"), sentence(error.what), window)
        return None
    tab = SimulationTab(copy)
    tab.setWindowTitle(translate("Vk_Simulate", "Simulation: {}").format(_title(copy)))
    tab.setWindowIcon(Gui.getIcon(SimulateCommand.name))
    tab.outdated.connect(lambda: _again(tab))
    widgets.area_of_views().addSubWindow(tab)
    tab.showMaximized()
    docks.make_room(_LOW)
    tab.setFocus()
    return tab


def _again(tab) -> None:
    """Close a tab, and open a new tab with a new simulation of the same objects, if their document is still open."""
    if tab.copy.document not in FreeCAD.listDocuments():
        return
    asked = tab.copy.asked()
    tab.window_of().close()
    open_tab(asked)


def _title(copy: JobCopy) -> str:
    """Return the title of the tab: the label of the document, or the label of the only operation."""
    return copy.labels[0] if len(copy.labels) == 1 else FreeCAD.getDocument(copy.document).Label


SimulateCommand.add()
