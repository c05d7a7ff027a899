# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench, its commands in FreeCAD's CAM workbench, and the observers that start when FreeCAD starts.

This module does not import numpy, because FreeCAD loads it at each start.
"""

from __future__ import annotations

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad, preferences
from vkworkbench.document.computer import idle
from vkworkbench.document.job.operations import kind
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.gui import machine_page, preferences_page
from vkworkbench.gui.qt.document_command import selected_operations
from vkworkbench.gui.qt.names import QTimer
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.simulators import watch as simulator_watch

ROOT = Path(__file__).resolve().parents[2]
ICONS = ROOT / "resources" / "icons"
TRANSLATIONS = ROOT / "resources" / "translations"
COMMANDS = ["Vk_Analyze", "Vk_Clear", "Vk_Results", "Vk_Strategies", "Vk_GaussMap", "Vk_Simulate", "Vk_Clamps"]
JOB_COMMANDS = ["Vk_PreviousJob", "Vk_AddMesh", "Vk_SaveStl"]  # commands in the menu, and in the context menu of a job
TITLE = QT_TRANSLATE_NOOP("Workbench", "Toolpath Analysis")  # title of toolbar and menu


class VkWorkbench(Gui.Workbench):
    """The workbench of this add-on. FreeCAD's CAM workbench has the same commands."""

    Icon = str(ICONS / "VkWorkbench.svg")

    def __init__(self) -> None:
        VkWorkbench.MenuText = translate("Workbench", "Toolpath Analysis")
        VkWorkbench.ToolTip = translate(
            "Workbench", "Recognizes machining strategies of toolpaths and estimates the cost of their simulation."
        )

    def Initialize(self) -> None:
        _load_commands()
        self.appendToolbar(TITLE, COMMANDS)
        self.appendMenu(TITLE, [*COMMANDS, *JOB_COMMANDS])

    def ContextMenu(self, recipient: str) -> None:
        _append_to_context_menu(self)

    def GetClassName(self) -> str:
        return "Gui::PythonWorkbench"


def install() -> None:
    """Register the add-on. InitGui.py calls it once when FreeCAD starts."""
    Gui.addLanguagePath(str(TRANSLATIONS))
    Gui.updateLocale()
    Gui.addIconPath(str(ICONS))
    for page in (preferences_page.PreferencesPage, machine_page.MachinePage):
        Gui.addPreferencePage(page, preferences_page.TITLE)
    Gui.addWorkbench(VkWorkbench())
    for name, menu in freecad.WORKBENCHES.items():
        workbench = Gui.listWorkbenches().get(name)
        if workbench is not None:
            _extend(workbench, menu)
    idle.use(lambda call: QTimer.singleShot(1, call))  # wait 1 ms, so that Qt handles other events first
    FreeCAD.addDocumentObserver(_OpenedDocuments())
    FreeCAD.addDocumentObserver(_Recomputes())
    # The task view to watch exists at the latest when a workbench is activated.
    Gui.getMainWindow().workbenchActivated.connect(lambda name: simulator_watch.watch())


def _extend(workbench, menu: str) -> None:
    """Add the commands to a workbench that FreeCAD has not initialised yet.

    This function wraps two methods of the workbench. FreeCAD's workbench manipulators are not used, because FreeCAD
    0.20 does not have them, and because they cannot create toolbars.
    """
    initialize, context_menu = workbench.Initialize, workbench.ContextMenu

    def Initialize() -> None:
        initialize()
        _load_commands()
        workbench.appendToolbar(TITLE, COMMANDS)
        workbench.appendMenu([menu], ["Separator", *COMMANDS, *JOB_COMMANDS])

    def ContextMenu(recipient: str) -> None:
        try:
            # FreeCAD's function fails for objects without a Proxy, such as groups and imported G-code.
            context_menu(recipient)
        finally:
            _append_to_context_menu(workbench)

    workbench.Initialize, workbench.ContextMenu = Initialize, ContextMenu


class _OpenedDocuments:
    """Compares the marks in the tree of a document with its operations after the document was opened.

    Afterwards the watcher keeps the marks up to date. A document is only compared again after new objects were added,
    because new objects can be copies with marks.
    """

    def __init__(self) -> None:
        self._opened: set[str] = set()  # opened documents that were not compared yet
        self._compared: set[str] = set()

    def slotCreatedObject(self, obj) -> None:
        self._compared.discard(obj.Document.Name)
        if obj.Document.Importing:
            self._later(obj.Document.Name)

    def slotDeletedDocument(self, document) -> None:
        self._opened.discard(document.Name)
        self._compared.discard(document.Name)

    def slotCreatedDocument(self, document) -> None:
        self._opened.add(document.Name)
        self._later(document.Name)

    def slotActivateDocument(self, document) -> None:
        self._later(document.Name)

    def slotCommitTransaction(self, document) -> None:
        # If this module was never imported, no marks in the tree were written.
        if "vkworkbench.document.marks.marking" in sys.modules:
            from vkworkbench.gui.tree import pills

            pills.show()

    def _later(self, name: str) -> None:
        QTimer.singleShot(0, lambda: self._look(name))

    def _look(self, name: str) -> None:
        document = FreeCAD.listDocuments().get(name)
        if document is None or name in self._compared:
            return
        # Wait until the document is loaded, because timers also run while FreeCAD shows the progress bar of loading.
        if document.Restoring:
            self._later(name)
            return
        opened = name in self._opened
        self._opened.discard(name)
        if any(map(may_have_mark, document.Objects)):
            # The following imports load numpy, so they are executed only for a document with marks in the tree.
            from vkworkbench.document import upkeep
            from vkworkbench.document.marks import watcher
            from vkworkbench.gui.tree import pills

            pills.show()
            upkeep.watch()
            idle.work(watcher.comparing(document, opened=opened))
            self._compared.add(name)


class _Recomputes:
    """Analyses outdated operations again after a recompute, if this is switched on in the preferences.

    The analysis starts when FreeCAD is idle, and shows a progress dialog.
    """

    def slotRecomputedDocument(self, document) -> None:
        if "vkworkbench.document.marks.marking" in sys.modules and preferences.read().analyze_after_recompute:
            name = document.Name
            idle.later(f"analysis of {name}", lambda: self._analyze(name))

    def _analyze(self, name: str) -> None:
        from vkworkbench.document import upkeep
        from vkworkbench.gui.qt import progress

        # Analyse only after the marks in the tree have been compared with the operations.
        if name in FreeCAD.listDocuments():
            idle.work(upkeep.analyzing_again(FreeCAD.getDocument(name), progress.analyze))


def _load_commands() -> None:
    import vkworkbench.gui.commands
    import vkworkbench.gui.gauss.command
    import vkworkbench.gui.job_commands
    import vkworkbench.gui.results.command
    import vkworkbench.gui.simulation.command
    import vkworkbench.gui.strategies.command  # noqa: F401


def _append_to_context_menu(workbench) -> None:
    selected = selected_operations()
    if selected:
        of_job = JOB_COMMANDS if any(kind(obj) == "job" for obj in selected) else []
        analyze, *others = COMMANDS
        workbench.appendContextMenu("", [analyze])
        workbench.appendContextMenu(TITLE, [*others, *of_job])
        workbench.appendContextMenu("", ["Separator"])
