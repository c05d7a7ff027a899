# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gauss map view: the picture of the method for the selected operation, in a dock."""

from __future__ import annotations

import math
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad, preferences
from vkworkbench.core import linearize
from vkworkbench.core.paper import Areas, Signature, monotonous_areas
from vkworkbench.document.operations import kind
from vkworkbench.document.setting import placed
from vkworkbench.gui import docks
from vkworkbench.gui.gauss_figure import CLOCKWISE, COUNTER_CLOCKWISE, TRAIL, GaussCanvas
from vkworkbench.gui.plain_text import as_plain, warn
from vkworkbench.gui.qt import (
    QApplication,
    QComboBox,
    QDockWidget,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QPalette,
    QPushButton,
    QSlider,
    QSpinBox,
    Qt,
    QTimer,
    QVBoxLayout,
    QWidget,
)  # fmt: skip
from vkworkbench.gui.sentences import said, user
from vkworkbench.gui.text import translate
from vkworkbench.language import Message, Unusable

_LISTED = 50  # areas in the chooser, the longest ones
_NOT_IN_NAMES = '\\/:*?"<>|'


class GaussMapDock(QDockWidget):
    """Follows the selection while it is visible; shows the longest monotonous area of the operation first."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(translate("Vk_GaussMap", "Gauss map"), parent)
        self.setObjectName(docks.GAUSS_MAP)
        self._shown: tuple[str, str] | None = None  # document and operation
        self._areas: Areas | None = None
        self._canvas: GaussCanvas | None = None
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.refresh)

        self.title, self.values, self.legend = QLabel(), QLabel(), QLabel(_legend())
        as_plain(self.title)
        for label in (self.title, self.values, self.legend):
            label.setWordWrap(True)  # a dock may be narrow
            label.setTextInteractionFlags(Qt.TextSelectableByMouse)
        self.legend.setAlignment(Qt.AlignRight)
        self.chooser = QComboBox()
        self.chooser.setSizeAdjustPolicy(QComboBox.AdjustToContents)
        self.chooser.setToolTip(translate(
            "Vk_GaussMap", "The areas that the tool cuts without a rapid move or a plunge, the longest first."
        ))  # fmt: skip
        self.chooser.currentIndexChanged.connect(self._show_area)
        self.saver = QPushButton(translate("Vk_GaussMap", "Save picture…"))
        self.saver.setToolTip(translate("Vk_GaussMap", "Saves the three plots as they stand, as PNG or SVG."))
        self.saver.clicked.connect(self._save)
        self.slider = QSlider(Qt.Horizontal)
        self.slider.setToolTip(translate("Vk_GaussMap", "Steps through the trajectories k of the area."))
        self.number = QSpinBox()
        self.number.setToolTip(self.slider.toolTip())
        self.slider.valueChanged.connect(self.number.setValue)
        self.number.valueChanged.connect(self.slider.setValue)
        self.slider.valueChanged.connect(self._step)

        self._body = QWidget()
        self._column = QVBoxLayout(self._body)
        self._column.addLayout(_row(self.title))
        self._column.addLayout(_row(self.chooser, self.slider, self.number, self.saver))
        self._column.addLayout(_row(self.values, self.legend))
        self.setWidget(self._body)

        Gui.Selection.addObserver(self)
        FreeCAD.addDocumentObserver(self)
        self.visibilityChanged.connect(lambda visible: self._later.start(0))

    # FreeCAD calls these when the selection changes.

    def addSelection(self, *what) -> None:
        self._later.start(0)

    def setSelection(self, *what) -> None:
        self._later.start(0)

    # FreeCAD calls these when a document changes.

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.names_in_fingerprint("path") and self._shown == (obj.Document.Name, obj.Name):
            self._shown = None
            self._later.start(0)

    def slotDeletedObject(self, obj) -> None:
        if self._shown == (obj.Document.Name, obj.Name):
            self._say_nothing()

    def slotDeletedDocument(self, document) -> None:
        if self._shown is not None and self._shown[0] == document.Name:
            self._say_nothing()

    def refresh(self) -> None:
        """Show the selected operation; where none is selected, what is shown stays."""
        if not self.isVisible():
            return
        chosen = [obj for obj in Gui.Selection.getSelection() if kind(obj) in ("operation", "dressup", "array")]
        if not chosen:
            if self._shown is None:
                self._say_nothing()
            return
        obj = chosen[0]
        if self._shown == (obj.Document.Name, obj.Name):
            return
        self._shown = (obj.Document.Name, obj.Name)
        QApplication.setOverrideCursor(Qt.WaitCursor)
        try:
            self._read(obj)
        finally:
            QApplication.restoreOverrideCursor()

    def _read(self, obj) -> None:
        try:
            path = placed(linearize(obj.Path.Commands, tolerance=preferences.read().tolerance), obj.Placement)
        except Unusable as error:
            self._say(said(Message("of", label=obj.Label, sentence=error.what)))
            return
        areas = monotonous_areas(path)
        if not len(areas):
            self._say(translate("Vk_GaussMap", "{}: no cutting move has a direction in the plane").format(obj.Label))
            return
        self._areas = areas
        self._label = obj.Label
        self.chooser.blockSignals(True)
        self.chooser.clear()
        for area in areas.by_length[:_LISTED]:
            count = int(areas.end[area] - areas.start[area])
            text = translate("Vk_GaussMap", "Area {}: {} trajectories, {}")
            self.chooser.addItem(text.format(area + 1, user().count(count), user().length(areas.area_length[area])), int(area))
        self.chooser.blockSignals(False)
        self._show_area(0)

    def _show_area(self, row: int) -> None:
        canvas = self._ready_canvas()
        canvas.show_area(self._areas, self.chooser.itemData(row))
        signature = canvas.signature
        self.title.setText("\n".join([
            f"{self._label}: {_reached(self._areas)}",
            translate("Vk_GaussMap", "This area: {}").format(_reached(signature)),
        ]))  # fmt: skip
        notes = []
        if canvas.drawn < canvas.points:
            text = translate("Vk_GaussMap", "Toolpath drawn with {} of {} points: the others fall on the same pixels.")
            notes.append(text.format(*map(user().count, (canvas.drawn, canvas.points))))
        if len(signature) > TRAIL:
            notes.append(translate("Vk_GaussMap", "Gauss map of the last {} trajectories up to k.").format(user().count(TRAIL)))
        self.legend.setText(_legend() + "".join(f"<br>{note}" for note in notes))
        count = len(signature)
        for widget in (self.slider, self.number):
            widget.blockSignals(True)
            widget.setRange(1, count)
            widget.setValue(count)
            widget.blockSignals(False)
        self.slider.setPageStep(max(1, count // 20))
        self._enable(True)
        self._step(count)

    def _step(self, k: int) -> None:
        signature = self._canvas.signature
        self._canvas.step(k - 1)
        self.values.setText(
            f"k = {user().count(k)} / {user().count(len(signature))}   α = {_in_degrees(signature.alpha[k - 1])}   "
            f"φ = {_in_pi(signature.phi[k - 1])}   θ = {_in_degrees(signature.theta[k - 1])}   "
            f"|V| = {user().length(signature.length[k - 1])}   n = {signature.level[k - 1]}"
        )

    def _ready_canvas(self) -> GaussCanvas:
        """Return the canvas, in the colours that the window has now."""
        palette = self._body.palette()
        colors = tuple(palette.color(role).name() for role in (QPalette.WindowText, QPalette.Window))
        if self._canvas is None:
            self._canvas = GaussCanvas()
            self._canvas.setMinimumSize(300, 160)
            self._canvas.setToolTip(translate(
                "Vk_GaussMap",
                "<p>Left the toolpath with the vector V<sub>k</sub> from the area's first point. On the unit circle "
                "the images of the trajectory v<sub>k</sub> and of V<sub>k</sub>; the arcs show how they moved. A "
                "zigzag goes to and fro on a part of the circle, a contour goes all around. Right the cumulative "
                "angular function φ and the angle θ on level n: a contour-parallel path leaves the dashed lines "
                "±2π, a zigzag stays within.</p>",
            ))  # fmt: skip
            self._column.insertWidget(1, self._canvas, 1)
        self._canvas.set_colors(*colors)
        return self._canvas

    def _say_nothing(self) -> None:
        self._shown = None
        self._say(translate("Vk_GaussMap", "Select an operation in the tree."))

    def _say(self, text: str) -> None:
        """Show a sentence instead of a picture."""
        self.title.setText(text)
        self._enable(False)
        self.values.clear()

    def _enable(self, there_is_a_picture: bool) -> None:
        for widget in (self.chooser, self.saver, self.slider, self.number, self.legend, self._canvas):
            if widget is not None:
                widget.setVisible(there_is_a_picture)

    def _save(self) -> None:
        document = FreeCAD.listDocuments()[self._shown[0]]
        folder = Path(document.FileName).parent if document.FileName else Path.home()
        name = "".join("_" if c in _NOT_IN_NAMES else c for c in self._label)
        path, chosen = QFileDialog.getSaveFileName(
            self, translate("Vk_GaussMap", "Save picture"), str(folder / f"{name}.png"), "PNG (*.png);;SVG (*.svg)"
        )
        if not path:
            return
        if Path(path).suffix.lower() not in (".png", ".svg"):
            path += ".svg" if "svg" in chosen else ".png"
        try:
            self._canvas.save(path)
        except OSError as error:
            warn(translate("Vk_GaussMap", "Save picture"), str(error), self)


def _row(*widgets: QWidget) -> QHBoxLayout:
    """Lay widgets side by side; labels and sliders take the space there is."""
    row = QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget, int(isinstance(widget, (QLabel, QSlider))))
    return row


def _reached(of: Areas | Signature) -> str:
    """Return the range of phi and the level in words: of all areas, as in the mark and the table, or of one area."""
    text = translate("Vk_GaussMap", "φ between {} and {} turns, level n = {}, exact reversals: {}")
    return text.format(*map(user().turns, of.phi_range), of.top_level, user().count(len(of.reversals)))


def _legend() -> str:
    senses = (
        (COUNTER_CLOCKWISE, "↺ " + translate("Vk_GaussMap", "counter-clockwise")),
        (CLOCKWISE, "↻ " + translate("Vk_GaussMap", "clockwise")),
    )
    text = " &nbsp; ".join(f'<span style="color:{color}">{name}</span>' for color, name in senses)
    return text + " &nbsp; × " + translate("Vk_GaussMap", "exact reversal")


def _in_pi(angle: float) -> str:
    return f"{user().decimals(angle / math.pi, 2)}π".replace("-", "−")


def _in_degrees(angle: float) -> str:
    return f"{user().decimals(math.degrees(angle), 1)}°"
