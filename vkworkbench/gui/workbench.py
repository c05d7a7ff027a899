# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench, its commands in FreeCAD's own CAM workbench, and what starts with FreeCAD. Loads no numpy."""

from __future__ import annotations

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad, preferences
from vkworkbench.document.computer import idle
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.gui import preferences_page
from vkworkbench.gui.qt.document_command import selected_operations
from vkworkbench.gui.qt.names import QApplication, QTimer
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.simulators import watch as simulator_watch

ROOT = Path(__file__).resolve().parents[2]
ICONS = ROOT / "resources" / "icons"
TRANSLATIONS = ROOT / "resources" / "translations"
COMMANDS = ["Vk_Analyze", "Vk_Clear", "Vk_Results", "Vk_Strategies", "Vk_GaussMap", "Vk_Simulate"]
TITLE = QT_TRANSLATE_NOOP("Workbench", "Toolpath analysis")  # of toolbar and menu


class VkWorkbench(Gui.Workbench):
    """Toolpath analysis on its own; the same commands are in the CAM workbench."""

    Icon = str(ICONS / "VkWorkbench.svg")

    def __init__(self) -> None:
        VkWorkbench.MenuText = translate("Workbench", "Toolpath Analysis")
        VkWorkbench.ToolTip = translate(
            "Workbench", "Recognizes machining strategies of toolpaths and estimates what simulating them costs."
        )

    def Initialize(self) -> None:
        _load_commands()
        self.appendToolbar(TITLE, COMMANDS)
        self.appendMenu(TITLE, COMMANDS)

    def ContextMenu(self, recipient: str) -> None:
        _append_to_context_menu(self)

    def GetClassName(self) -> str:
        return "Gui::PythonWorkbench"


def install() -> None:
    """Register everything: called once by InitGui.py when FreeCAD starts."""
    Gui.addLanguagePath(str(TRANSLATIONS))
    Gui.updateLocale()
    Gui.addIconPath(str(ICONS))
    Gui.addPreferencePage(preferences_page.PreferencesPage, preferences_page.TITLE)
    Gui.addWorkbench(VkWorkbench())
    for name, menu in freecad.WORKBENCHES.items():
        workbench = Gui.listWorkbenches().get(name)
        if workbench is not None:
            _extend(workbench, menu)
    idle.use(lambda call: QTimer.singleShot(1, call))  # ms: other events come before
    FreeCAD.addDocumentObserver(_OpenedDocuments())
    FreeCAD.addDocumentObserver(_Recomputes())
    Gui.getMainWindow().workbenchActivated.connect(lambda name: simulator_watch.watch())  # then the task view is there
    QApplication.instance().focusWindowChanged.connect(_focus_changed)


def _extend(workbench, menu: str) -> None:
    """Add the commands to a workbench that is not yet initialised.

    The instance's methods are wrapped: FreeCAD's own way, workbench manipulators, is missing in 0.20 and cannot make
    a toolbar.
    """
    initialize, context_menu = workbench.Initialize, workbench.ContextMenu

    def Initialize() -> None:
        initialize()
        _load_commands()
        workbench.appendToolbar(TITLE, COMMANDS)
        workbench.appendMenu([menu], ["Separator", *COMMANDS])

    def ContextMenu(recipient: str) -> None:
        try:
            context_menu(recipient)  # FreeCAD's own fails on what has no Proxy: a group, imported G-code
        finally:
            _append_to_context_menu(workbench)

    workbench.Initialize, workbench.ContextMenu = Initialize, ContextMenu


class _OpenedDocuments:
    """Compares the marks of a document with its paths once it has been opened: they may be of other paths.

    From then on the watcher keeps them true; only what is new in a document may be a copy of something marked.
    """

    def __init__(self) -> None:
        self._opened: set[str] = set()  # and not looked at since
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
        if "vkworkbench.document.marks.marking" in sys.modules:  # then there may be marks, also by a macro
            from vkworkbench.gui.tree import pills

            pills.show()

    def _later(self, name: str) -> None:
        QTimer.singleShot(0, lambda: self._look(name))

    def _look(self, name: str) -> None:
        document = FreeCAD.listDocuments().get(name)
        if document is None or name in self._compared:
            return
        if document.Restoring:  # still loading: FreeCAD's progress bar lets timers run meanwhile
            self._later(name)
            return
        opened = name in self._opened
        self._opened.discard(name)
        if any(map(may_have_mark, document.Objects)):
            # These load numpy: only for a document with marks.
            from vkworkbench.document import upkeep
            from vkworkbench.document.marks import watcher
            from vkworkbench.gui.tree import pills

            pills.show()
            upkeep.watch()
            idle.work(watcher.comparing(document, opened=opened))
            self._compared.add(name)


class _Recomputes:
    """Analyses again after a recompute, if the user wishes: when FreeCAD is idle, with progress, and Esc cancels."""

    def slotRecomputedDocument(self, document) -> None:
        if "vkworkbench.document.marks.marking" in sys.modules and preferences.read().analyze_after_recompute:
            name = document.Name
            idle.later(f"analysis of {name}", lambda: self._analyze(name))

    def _analyze(self, name: str) -> None:
        from vkworkbench.document import upkeep
        from vkworkbench.gui.qt import progress

        if name in FreeCAD.listDocuments():  # behind the work that compares its marks
            idle.work(upkeep.analyzing_again(FreeCAD.getDocument(name), progress.analyze))


def _focus_changed(window) -> None:
    """Notice that the user opens the OpenGL simulator, which has a window of its own."""
    if window is not None and "CAMSim" in window.metaObject().className():
        from vkworkbench.gui.simulators import real_runs

        real_runs.watch_opengl(window)


def _load_commands() -> None:
    import vkworkbench.gui.commands
    import vkworkbench.gui.gauss.command
    import vkworkbench.gui.results.command
    import vkworkbench.gui.simulation.command
    import vkworkbench.gui.strategies.command  # noqa: F401


def _append_to_context_menu(workbench) -> None:
    if selected_operations():
        workbench.appendContextMenu("", [*COMMANDS, "Separator"])
