# SPDX-License-Identifier: LGPL-2.1-or-later
"""A warning line over the 3D view, shown if a simulator of FreeCAD that the user opens would hang or take too long.

The line does not block the window, and offers this add-on's simulation, which is faster. The warning uses only marks in the tree that are
not outdated.
"""

from __future__ import annotations

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.slow_simulation import warning_at_start
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import (
    QComboBox,
    QEvent,
    QFrame,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QMdiArea,
    QObject,
    QPushButton,
    QTimer,
    QToolButton,
    QWidget,
    single_shot,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import as_plain, unbroken
from vkworkbench.gui.qt.sentences import sentence
from vkworkbench.gui.qt.text import explain, translate
from vkworkbench.gui.simulators import panels as simulator_panels
from vkworkbench.language import Message

NAME = "VkSimulatorWarning"
_MARGIN = 8  # px between the warning line and the edges of the 3D view
_LOOK = 200  # ms between two checks whether the simulator's panel is still open
# Style of the warning line, the same in every theme.
_STYLE = """
QFrame#VkSimulatorWarning { background-color: #fff4ce; border: 1px solid #c77700; border-radius: 4px; }
QLabel { background-color: transparent; color: #1a1a1a; border: none; }
QPushButton { background-color: #9c5d00; color: #ffffff; border: none; border-radius: 3px; padding: 4px 10px; }
QPushButton:hover, QPushButton:focus { background-color: #7a4900; }
QToolButton { background-color: transparent; color: #1a1a1a; border: none; padding: 2px 6px; }
QToolButton:hover, QToolButton:focus { background-color: #f0dca0; }
"""


class Line(QFrame):
    """The warning line: a text, a button for the simulation tab, and a button that closes the line."""

    def __init__(self, area: QMdiArea) -> None:
        super().__init__(area)
        self.setObjectName(NAME)
        self.setStyleSheet(_STYLE)
        self.text = as_plain(QLabel())
        self.text.setWordWrap(True)
        self.way = QPushButton(translate("Vk_Simulate", "Simulate Toolpaths"))
        self.close_button = QToolButton()
        self.close_button.setText("\u2715")
        explain(self.close_button, translate("Vk_Warning", "Close"))
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 4, 4, 4)
        row.addWidget(self.text, 1)
        row.addWidget(self.way)
        row.addWidget(self.close_button)
        area.installEventFilter(self)

    def eventFilter(self, area, event) -> bool:
        if event.type() == QEvent.Resize and self.isVisible():
            self.place()
        return False

    def place(self) -> None:
        """Place the line across the top of FreeCAD's views. The height of the line depends on its text."""
        area = self.parentWidget()
        width = area.width() - 2 * _MARGIN
        self.setGeometry(_MARGIN, area.viewport().y() + _MARGIN, width, self.heightForWidth(width))
        self.raise_()

    def end(self) -> None:
        self.hide()
        self.deleteLater()


class OpenPanel(QObject):
    """Shows the warning while a simulator's panel is open, and updates it when the user ticks other operations.

    The warning line is the Qt parent of this object. The object keeps no reference to the panel, see `widgets`.
    """

    def __init__(self, panel: QWidget, simulator: str) -> None:
        line = Line(widgets.area_of_views())
        super().__init__(line)
        self._line, self._simulator = line, simulator
        self._document = FreeCAD.ActiveDocument.Name
        self._line.hide()
        self._line.way.clicked.connect(self._take)
        self._line.close_button.clicked.connect(self._end)
        self._changed = single_shot(self._say, self)  # updates once if the user ticks all operations with one click
        # A timer, because PySide would keep the closed panel's widget if a signal of the panel were connected.
        self._open = QTimer(self)
        self._open.timeout.connect(self._look)
        self._open.start(_LOOK)
        panel.findChild(QListWidget, "listOperations").itemChanged.connect(lambda item: self._changed.start())
        panel.findChild(QComboBox, "comboJobs").currentIndexChanged.connect(lambda index: self._changed.start())
        self._say()

    def _look(self) -> None:
        if not simulator_panels.panels():
            self._line.end()

    def _say(self) -> None:
        panels = simulator_panels.panels()
        if not panels or FreeCAD.ActiveDocument is None or FreeCAD.ActiveDocument.Name != self._document:
            return
        _, operations = simulator_panels.chosen_in(panels[0])
        wrong = warning_at_start(self._simulator, list(map(marks.read, operations)), preferences.read())
        if wrong is None:
            self._line.hide()
            return
        self._line.text.setText(unbroken(f"{sentence(wrong)} {sentence(Message('ours-instead'))}"))
        self._line.show()
        self._line.place()

    def _end(self) -> None:
        self._changed.blockSignals(True)
        self._line.hide()

    def _take(self) -> None:
        """Simulate the operations in this add-on's tab instead."""
        panel = next(iter(simulator_panels.panels()), None)
        self._end()
        if panel is None:  # the panel was closed after the last check
            return
        _, operations = simulator_panels.chosen_in(panel)
        simulator_panels.close()
        # Open the tab after FreeCAD has removed the panel.
        QTimer.singleShot(0, lambda: _simulate(operations))


def watch(panel: QWidget, simulator: str) -> None:
    """Show the warning for the operations ticked in a simulator's panel, as long as the panel is open."""
    for line in widgets.find(Line):
        line.end()
    OpenPanel(panel, simulator)


def _simulate(operations: list) -> None:
    from vkworkbench.gui.simulation.command import open_tab  # loads numpy

    open_tab(operations)
