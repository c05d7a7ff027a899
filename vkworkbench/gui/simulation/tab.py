# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab of a simulation: reads what is to be simulated, and follows what happens to the document."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.document.simulated_job import JobCopy, ReadCut
from vkworkbench.gui.background import Background, Busy
from vkworkbench.gui.plain_text import tell
from vkworkbench.gui.qt import QMdiArea, QPushButton, Qt, QTimer, QVBoxLayout, QWidget, Signal
from vkworkbench.gui.sentences import said
from vkworkbench.gui.simulation.keys import KeyedWidget
from vkworkbench.gui.simulation.player import Player
from vkworkbench.gui.text import translate
from vkworkbench.language import Unusable
from vkworkbench.report import Cancelled


class SimulationTab(KeyedWidget):
    """Shows a job's simulation as soon as the job has been read, in a thread of its own.

    Parameters
    ----------
    copy : JobCopy
        What is to be read.

    Attributes
    ----------
    player : Player or None
        None while the job is being read.
    outdated : Signal
        The toolpaths have changed, and the user wants them simulated again.
    """

    outdated = Signal()

    def __init__(self, copy: JobCopy, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.copy = copy
        self.player: Player | None = None
        self._background = Background(self)
        self.busy = Busy(self._background)
        self._read: list[ReadCut] = []
        self._open = True
        self.again = QPushButton(translate("Vk_Simulate", "The toolpaths have changed. Simulate again"))
        self.again.clicked.connect(lambda *_: self.outdated.emit())
        self.again.hide()
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(4, 4, 4, 4)
        self._layout.addWidget(self.again)
        self._layout.addWidget(self.busy)
        self.keys = {int(Qt.Key_Escape): lambda: self.window_of().close()}
        FreeCAD.addDocumentObserver(self)
        self._background.start(self._reading(), self._work, self._take, self._ended)

    # Reading

    def _work(self, going_on: Callable[[], None]) -> Iterator[ReadCut]:
        return self.copy.read()

    def _reading(self) -> str:
        done, labels = len(self._read), self.copy.labels
        return translate("Vk_Simulate", "Reading {} ({} of {})…").format(labels[done], done + 1, len(labels))

    def _take(self, read: ReadCut) -> None:
        self._read.append(read)
        if len(self._read) < len(self.copy.labels):
            self.busy.label.setText(self._reading())

    def _ended(self, error: Exception | None) -> None:
        try:
            if error is not None:
                raise error
            job = self.copy.job(self._read)
        except Cancelled:
            self.window_of().close()
        except Unusable as unusable:
            self.window_of().close()
            tell(translate("Vk_Simulate", "Simulate toolpaths"), said(unusable.what), Gui.getMainWindow())
        else:
            self._show(Player(job))

    def _show(self, player: Player) -> None:
        self.player = player
        # FreeCAD 1.1 brings the 3D view to the front for a selection.
        player.asked.connect(lambda: QTimer.singleShot(0, self.come_to_front))
        self.keys.update({
            int(Qt.Key_Space): player.moment.play,
            int(Qt.Key_Comma): lambda: player.moment.step(-1),
            int(Qt.Key_Period): lambda: player.moment.step(1),
        })  # fmt: skip
        self._layout.addWidget(player, 1)

    # The tab

    def come_to_front(self) -> None:
        """Show the tab before the other ones of FreeCAD's window."""
        # Not by the sub-window's mdiArea(): PySide6 then deletes FreeCAD's area together with the sub-window.
        area = Gui.getMainWindow().findChild(QMdiArea)
        area.setActiveSubWindow(self.window_of())

    def window_of(self) -> QWidget:
        """Return the tab in FreeCAD's window."""
        return self.parentWidget() or self

    def closeEvent(self, event) -> None:
        self.end()
        super().closeEvent(event)

    def end(self) -> None:
        """Stop all work: the tab is closed."""
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)
        self._background.give_up()
        if self.player is not None:
            self.player.end()

    # What happens to the document

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.PATH.names and self._is_ours(obj):
            self.again.show()

    def slotDeletedObject(self, obj) -> None:
        if self._is_ours(obj):
            self.again.show()

    def slotDeletedDocument(self, document) -> None:
        if document.Name == self.copy.document:
            self.end()
            QTimer.singleShot(0, self.window_of().close)

    def _is_ours(self, obj) -> bool:
        return obj.Document.Name == self.copy.document and obj.Name in self.copy.names
