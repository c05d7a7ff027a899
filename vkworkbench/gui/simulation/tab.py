# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab of a simulation: it reads the job, then shows the player, and reacts to changes of the document."""

from __future__ import annotations

from collections.abc import Iterator

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.document.computer import garbage, idle
from vkworkbench.document.simulation.copy import JobCopy
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.language_change import LanguageChange
from vkworkbench.gui.qt.names import QPainter, QPushButton, Qt, QTimer, QVBoxLayout, QWidget, Signal, single_shot
from vkworkbench.gui.qt.plain_text import inform
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.player import Player
from vkworkbench.gui.simulation.reading import Reading
from vkworkbench.gui.simulation.widgets import KeyedWidget, error_text
from vkworkbench.report import Cancelled

_ON_OPERATION = freecad.names_in_fingerprint("path")
_ON_SETTING = freecad.names_in_fingerprint("setting")
_SELECTED = 1000  # ms after a selection within which FreeCAD can bring its 3D view to the front
_ENDED = 1000  # ms after which the threads of a closed tab have usually ended


class SimulationTab(KeyedWidget):
    """Reads a job, and then shows its simulation."""

    outdated = Signal()  # the document has changed, and the user asked for a new simulation

    def __init__(self, copy: JobCopy, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.copy = copy
        self.player: Player | None = None  # None while the job is being read
        self._open = True
        self.again = QPushButton(translate("Vk_Simulate", "The simulated job has changed. Simulate it again."))
        self.again.clicked.connect(lambda *_: self.outdated.emit())
        self.again.hide()
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(4, 4, 4, 4)
        self._layout.addWidget(self.again)
        self._changed: set[str] = set()  # operations whose path has possibly changed since the job was copied
        self._soon = single_shot(lambda: idle.work(self._comparing()), self)
        self._asked = QTimer(self)
        self._asked.setSingleShot(True)
        self._asked.setInterval(_SELECTED)
        self.keys = {int(Qt.Key_Escape): self._leave}
        self._language = LanguageChange(self.outdated.emit, self)
        FreeCAD.addDocumentObserver(self)
        self.reading = Reading(copy)
        self.reading.read.connect(self._simulate)
        self.reading.failed.connect(self._not_read)
        self._layout.addWidget(self.reading, 1)

    # Reading

    def _simulate(self, job: SimulatedJob) -> None:
        self.reading.hide()
        self._show(Player(job, self.reading.seen))
        self._soon.start()

    def _not_read(self, error: Exception) -> None:
        if isinstance(error, ReferenceError):
            self.again.show()
            return
        self.window_of().close()
        if not isinstance(error, Cancelled):
            inform(translate("Vk_Simulate", "Simulate Toolpaths"), error_text(error), Gui.getMainWindow())

    def _show(self, player: Player) -> None:
        self.player = player
        player.asked.connect(lambda *_: self._asked.start())
        widgets.area_of_views().subWindowActivated.connect(self._stay_in_front)
        self.keys.update(player.time_line.keys)
        self.keys.update({
            int(Qt.Key_Space): player.moment.play,
            int(Qt.Key_Comma): lambda: player.moment.step(-1),
            int(Qt.Key_Period): lambda: player.moment.step(1),
        })  # fmt: skip
        self._layout.addWidget(player, 1)
        self.setFocusProxy(player.time_line)

    # The tab

    def _leave(self) -> None:
        """End measuring; close the tab if the user is not measuring."""
        if self.player is None or not self.player.end_measuring():
            self.window_of().close()

    def come_to_front(self) -> None:
        """Show the tab in front of FreeCAD's other tabs."""
        # Do not use the sub-window's mdiArea(): PySide6 would delete FreeCAD's area together with the sub-window.
        widgets.area_of_views().setActiveSubWindow(self.window_of())

    def _stay_in_front(self) -> None:
        """Bring this tab to the front if FreeCAD 1.1 has shown the 3D view because of a selection made in this tab."""
        if self._asked.isActive():
            QTimer.singleShot(0, self.come_to_front)

    def window_of(self) -> QWidget:
        """Return the sub-window that contains this tab in FreeCAD's main window."""
        return self.parentWidget() or self

    def showEvent(self, event) -> None:
        super().showEvent(event)
        QTimer.singleShot(0, self._take_focus)

    def _take_focus(self) -> None:
        """Move the keyboard focus from the first button, where Qt has put it, to the time line."""
        focused = self.focusWidget()
        if focused is not None and focused.hasFocus():
            self.setFocus()

    def paintEvent(self, event) -> None:
        """Paint the background, because other tabs are visible through this tab with FreeCAD 0.20's style sheets."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), Gui.getMainWindow().palette().window())
        painter.end()

    def closeEvent(self, event) -> None:
        self.end()
        super().closeEvent(event)

    def end(self) -> None:
        """Stop all work when the tab is closed."""
        if self._open:
            self._open = False
            self._soon.stop()
            self._asked.stop()
            FreeCAD.removeDocumentObserver(self)
            QTimer.singleShot(_ENDED, garbage.give_back)
        self.reading.end()
        if self.player is not None:
            self.player.end()

    # The following methods respond to changes of the document.

    def slotChangedObject(self, obj, name: str) -> None:
        if name in _ON_OPERATION | _ON_SETTING and obj.Document.Name == self.copy.document:
            if name in _ON_OPERATION:
                self._changed.add(obj.Name)
            self._compare()

    def slotDeletedObject(self, obj) -> None:
        if obj.Document.Name == self.copy.document:
            self._compare()

    def slotDeletedDocument(self, document) -> None:
        if document.Name == self.copy.document:
            self.end()
            QTimer.singleShot(0, self.window_of().close)

    def _compare(self) -> None:
        """Compare the document with the simulated job soon; until then, hide the faults in tree and results panel."""
        if self.player is not None:  # a job that is still being read is compared as soon as it has been read
            self.player.known.follow(False)
            self._soon.start()

    def _comparing(self) -> Iterator[None]:
        if not self._open:
            return
        holds = yield from self.copy.comparing(self._changed)
        if self._open and not self._soon.isActive():  # the document did not change during the comparison
            self.again.setVisible(not holds)
            self.player.known.follow(holds)
