# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gauss map panel: three plots that explain the strategy of the selected operation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.document.job.operations import is_active, is_operation, names_of
from vkworkbench.document.job.recognition import Source, source_of
from vkworkbench.gui.gauss.canvas import GaussCanvas
from vkworkbench.gui.gauss.figure import TRAIL, GaussFigure
from vkworkbench.gui.gauss.reading import Reading, read
from vkworkbench.gui.gauss.theme import Theme
from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.background import Background, Busy
from vkworkbench.gui.qt.language_change import LanguageChange
from vkworkbench.gui.qt.names import (
    QColor,
    QComboBox,
    QDockWidget,
    QEvent,
    QFileDialog,
    QFrame,
    QHBoxLayout,
    QImage,
    QLabel,
    QPalette,
    QPoint,
    QPushButton,
    QRegion,
    QScrollArea,
    QSlider,
    QSpinBox,
    Qt,
    QVBoxLayout,
    QWidget,
    single_shot,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import WholeText, as_plain, shortened, warn
from vkworkbench.gui.qt.saving import folder_of
from vkworkbench.gui.qt.sentences import sentence, strategy_name, user
from vkworkbench.gui.qt.text import explain, translate
from vkworkbench.language import Message, Unusable
from vkworkbench.report import Cancelled

_LISTED = 50  # maximum number of areas in the combo box, which lists the toolpath's longest areas
_QUICK = 20_000  # an area with fewer trajectories is drawn without a background thread
_NOT_IN_NAMES = '\\/:*?"<>|'


class GaussMapDock(QDockWidget):
    """Shows the plots of the selected operation, at first for the area that explains its strategy best."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(docks.GAUSS_MAP)
        self._shown: tuple[str, str] | None = None  # names of the shown document and operation
        self._reading: Reading | None = None
        self._background = Background(self)
        self._recolor, self._later = single_shot(self._take_colors, self), single_shot(self.refresh, self)
        self._build()
        self._language = LanguageChange(self._translate, self)

        Gui.Selection.addObserver(self)
        FreeCAD.addDocumentObserver(self)
        self.visibilityChanged.connect(lambda visible: self._later.start())

    def _build(self) -> None:
        """Make the contents of the dock, in FreeCAD's language."""
        self.setWindowTitle(translate("Vk_GaussMap", "Gauss Map"))
        self.busy = Busy(self._background)
        self.title, self.values, self.legend = QLabel(), QLabel(), QLabel()
        as_plain(self.title)
        for label in (self.title, self.values, self.legend):
            label.setWordWrap(True)  # a label in one line would not fit in a narrow dock
            label.setTextInteractionFlags(Qt.TextSelectableByMouse)
        self._whole = [WholeText(label) for label in (self.title, self.values, self.legend)]
        self.legend.setAlignment(Qt.AlignRight)
        self.chooser = QComboBox()
        self.chooser.setSizeAdjustPolicy(QComboBox.AdjustToContents)
        explain(self.chooser, translate(
            "Vk_GaussMap", "Areas that the tool cuts without a rapid move or a plunge. The area that shows "
            "the strategy best comes first, then the longest areas."
        ))  # fmt: skip
        self.chooser.currentIndexChanged.connect(self._choose_area)
        self.saver = QPushButton(translate("Vk_GaussMap", "Save Picture…"))
        self.saver.setToolTip(translate("Vk_GaussMap", "Saves the three plots as PNG or SVG."))
        self.saver.clicked.connect(self._save)
        self.slider = QSlider(Qt.Horizontal)
        explain(self.slider, translate("Vk_GaussMap", "Steps through the trajectories k of the area."))
        self.number = QSpinBox()
        explain(self.number, self.slider.toolTip())
        self.slider.valueChanged.connect(self.number.setValue)
        self.number.valueChanged.connect(self.slider.setValue)
        self.slider.valueChanged.connect(self._step)

        self.canvas = GaussCanvas()
        self.canvas.setMinimumSize(300, GaussFigure.min_height(self.canvas.fontMetrics()))
        self.canvas.setToolTip(translate(
            "Vk_GaussMap",
            "<p>The left plot shows the toolpath with the vector V<sub>k</sub> from the "
            "first point of the area. The unit circle shows the directions of the trajectory "
            "v<sub>k</sub> and of V<sub>k</sub>. Its arcs show how these directions have "
            "moved. In a zigzag, the direction of v<sub>k</sub> moves back and forth on a "
            "part of the circle. In a contour, it moves all around the circle. The direction "
            "of V<sub>k</sub> moves all around only if the path begins inside the contour. "
            "The right plot shows the cumulative angular function φ and the angle θ on level "
            "n, in turns. A contour-parallel path reaches the dashed lines, one turn from its "
            "start. A zigzag stays between the dashed lines, one turn from its middle.</p>",
        ) + translate("Vk_GaussMap", "<p>Use the wheel to zoom, drag to move, and double-click to show everything "
                                     "again.</p>"))  # fmt: skip
        self.setWidget(self._laid_out())
        self._enable(False)

    def _translate(self) -> None:
        """Make the contents of the dock again, in FreeCAD's new language, and show the selected operation."""
        before = self.widget()
        self._say_nothing()
        self._build()
        before.deleteLater()
        self._later.start()

    def _laid_out(self) -> QWidget:
        """Return the dock's widgets in a scroll area, because a small screen is too low for all widgets."""
        self._body = QWidget()
        column = QVBoxLayout(self._body)
        column.setContentsMargins(4, 2, 4, 2)
        column.setSpacing(2)
        column.addLayout(_row(self.title))
        column.addWidget(self.busy)
        column.addWidget(self.canvas, 1)
        column.addLayout(_row(self.chooser, self.slider, self.number, self.saver))
        below = _row(self.values, self.legend)
        below.setStretch(0, 2)
        column.addLayout(below)
        area = QScrollArea()
        area.setFrameShape(QFrame.NoFrame)
        area.setWidgetResizable(True)
        area.setWidget(self._body)
        self.setFocusProxy(area)
        return area

    # FreeCAD calls the following methods when its selection changes.

    def addSelection(self, *what) -> None:
        self._later.start()

    setSelection = addSelection

    # FreeCAD calls the following methods when a document changes.

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.names_in_fingerprint("path") and self._shown == names_of(obj):
            self._shown = None
            self._later.start()

    def slotActivateDocument(self, document) -> None:
        self._later.start()

    def slotDeletedObject(self, obj) -> None:
        if self._shown == names_of(obj):
            self._say_nothing()

    def slotDeletedDocument(self, document) -> None:
        if self._shown is not None and self._shown[0] == document.Name:
            self._say_nothing()

    def refresh(self) -> None:
        """Show the plots of the selected operation. If no operation is selected, keep the operation that is shown."""
        if not self.isVisible():
            return
        chosen = list(filter(is_operation, Gui.Selection.getSelection()))
        if not chosen:
            document = FreeCAD.ActiveDocument
            if self._shown is None or document is None or self._shown[0] != document.Name:
                self._say_nothing()
            return
        obj = chosen[0]
        if self._shown == names_of(obj):
            return
        self._shown = names_of(obj)
        self._label, self._active = obj.Label, is_active(obj)
        self.chooser.setEnabled(False)  # the chooser still lists the areas of the previous operation
        self.saver.setEnabled(False)
        source = source_of(obj)
        text = translate("Vk_GaussMap", "Reading {}…").format(obj.Label)
        self._background.start(text, lambda going_on: _drawn(source, going_on), self._show, self._ended)

    def _ended(self, error: Exception | None) -> None:
        if isinstance(error, Unusable):
            self._say(sentence(Message("of", label=self._label, sentence=error.what)))
        elif isinstance(error, Cancelled):
            self._say_nothing()
        elif error is not None:
            self._say_nothing()
            raise error

    def _show(self, drawn: tuple[Reading, GaussFigure] | None) -> None:
        if drawn is None and not self._active:
            self._say(sentence(Message("of", label=self._label, sentence=Message("inactive"))))
            return
        if drawn is None:
            text = translate("Vk_GaussMap", "{}: No move cuts sideways, so there is no direction to show.")
            self._say(text.format(self._label))
            return
        self._reading, figure = drawn
        areas, proof = self._reading.areas, self._reading.proof
        listed = [proof, *(area for area in areas.by_length[:_LISTED].tolist() if area != proof)]
        self.chooser.blockSignals(True)
        self.chooser.clear()
        for area in listed:
            count = int(areas.end[area] - areas.start[area])
            text = translate("Vk_GaussMap", "Area {}: {} trajectories, {}")
            self.chooser.addItem(
                text.format(area + 1, user().count(count), user().length(areas.area_length[area])), area
            )
        self.chooser.blockSignals(False)
        self._show_figure(figure)

    def _choose_area(self, row: int) -> None:
        self._background.give_up()  # stop drawing the area that was chosen before
        reading, area = self._reading, self.chooser.itemData(row)
        if reading.areas.end[area] - reading.areas.start[area] < _QUICK:
            self._show_figure(GaussFigure(reading, area))
            return
        self.saver.setEnabled(False)  # the plots still show the previous area until the new area is drawn
        text = translate("Vk_GaussMap", "Reading {}…").format(self._label)
        self._background.start(text, lambda going_on: [GaussFigure(reading, area)], self._show_figure, self._chosen)

    def _chosen(self, error: Exception | None) -> None:
        if not isinstance(error, Cancelled):
            self._ended(error)
            return
        self.chooser.blockSignals(True)
        # The user cancelled the drawing of the new area: choose the area that the plots still show.
        self.chooser.setCurrentIndex(self.chooser.findData(self.canvas.figure.area))
        self.chooser.blockSignals(False)
        self.saver.setEnabled(True)

    def _show_figure(self, figure: GaussFigure) -> None:
        found = self._reading.recognition
        signature = figure.signature
        self.canvas.set_background(self._behind())
        self.canvas.show_figure(figure)
        reached = _reached(found.phi_range, found.level, found.reversals)
        here = _reached(signature.phi_range, signature.top_level, len(signature.reversals))
        texts = [f"{shortened(self._label)}: {self._verdict()}. {sentence(found.why)}", reached]
        if here != reached:
            texts.append(translate("Vk_GaussMap", "This area: {}").format(here))
        self.title.setText("\n".join(texts))
        self._show_notes()
        count = len(signature)
        for widget in (self.slider, self.number):
            widget.blockSignals(True)
            widget.setRange(1, count)
            widget.setValue(count)
            widget.blockSignals(False)
        self.slider.setPageStep(max(1, count // 20))
        self._enable(True)
        self._step(count)

    def _show_notes(self) -> None:
        text = _legend(self.canvas.theme)
        if len(self.canvas.figure.signature) > TRAIL:
            note = translate("Vk_GaussMap", "Gauss map of the last {} trajectories up to k.")
            text += "<br>" + note.format(user().count(TRAIL))
        self.legend.setText(text)

    def _verdict(self) -> str:
        """Return the strategy and the confidence as text, as in the mark in the tree."""
        found = self._reading.recognition
        name = strategy_name(found.strategy)
        return f"{name} {user().share(found.confidence)}" if found.strategy.is_answer else name

    def _step(self, k: int) -> None:
        figure = self.canvas.figure
        signature = figure.signature
        self.canvas.step(k - 1)
        text = (
            f"k = {user().count(k)} / {user().count(len(signature))}   α = {_in_degrees(signature.alpha[k - 1])}   "
            f"{_in_turns(signature.phi[k - 1])}   θ = {_in_degrees(signature.theta[k - 1])}   "
            f"|V| = {user().length(signature.length[k - 1])}   n = {signature.level[k - 1]}"
        )
        if k == len(signature) < len(figure.phi):
            text += "   " + translate("Vk_GaussMap", "with the closing turn {}, n = {}").format(
                _in_turns(figure.phi[-1]), figure.level[-1]
            )
        self.values.setText(text)
        self._fit_texts()

    def _fit_texts(self) -> None:
        for text in self._whole:
            text.fit()

    def _behind(self) -> QColor:
        """Return the colour of the background behind the plots, which a palette or a style sheet determines."""
        image = QImage(1, 1, QImage.Format_RGB32)
        image.fill(self._body.palette().color(QPalette.Window))
        corner = self._body.mapTo(self, QPoint(2, 2))  # no widget covers the background at this point in the margin
        self.render(image, QPoint(0, 0), QRegion(corner.x(), corner.y(), 1, 1))
        return image.pixelColor(0, 0)

    def changeEvent(self, event) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.StyleChange, QEvent.PaletteChange):
            self._recolor.start()

    def _take_colors(self) -> None:
        self.canvas.set_background(self._behind())
        if self.canvas.figure is not None:
            self._show_notes()

    def _say_nothing(self) -> None:
        self._shown = None
        self._background.give_up()
        self._say(translate("Vk_GaussMap", "Select an operation in the tree."))

    def _say(self, text: str) -> None:
        """Show a sentence instead of the plots."""
        self.title.setText(text)
        self._enable(False)
        self.values.clear()
        self._fit_texts()

    def _enable(self, has_plots: bool) -> None:
        for widget in (self.chooser, self.saver, self.slider, self.number, self.legend, self.canvas):
            widget.setVisible(has_plots)
        self.chooser.setEnabled(True)
        self.saver.setEnabled(True)

    def _save(self) -> None:
        document = FreeCAD.listDocuments()[self._shown[0]]
        name = "".join("_" if c in _NOT_IN_NAMES else c for c in self._label)
        title, forms = translate("Vk_GaussMap", "Save Picture"), "PNG (*.png);;SVG (*.svg)"
        path, chosen = QFileDialog.getSaveFileName(self, title, str(folder_of(document) / f"{name}.png"), forms)
        if not path:
            return
        if Path(path).suffix.lower() not in (".png", ".svg"):
            path += ".svg" if "svg" in chosen else ".png"
        try:
            self.canvas.save(path, f"{self._label}: {self._verdict()}")
        except OSError as error:
            warn(title, str(error), self)


def _drawn(source: Source, going_on: Callable) -> Iterator[tuple[Reading, GaussFigure] | None]:
    """Read an operation, and draw the area that explains its strategy best. Any thread may call this function."""
    for reading in read(source, going_on):
        yield reading and (reading, GaussFigure(reading, reading.proof))


def _row(*widgets: QWidget) -> QHBoxLayout:
    """Return a row of widgets in which labels and sliders take the free space."""
    row = QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget, int(isinstance(widget, (QLabel, QSlider))))
    return row


def _reached(phi_range: tuple[float, float], level: int, reversals: int) -> str:
    """Return an area's range of phi, its level n (number of whole turns) and its number of exact reversals as text."""
    text = translate("Vk_GaussMap", "φ between {} and {} turns, level n = {}, exact reversals: {}")
    return text.format(*map(user().turns, phi_range), level, user().count(reversals))


def _legend(theme: Theme) -> str:
    senses = (
        (theme.counter_clockwise, "↺ " + translate("Vk_GaussMap", "counter-clockwise")),
        (theme.clockwise, "↻ " + translate("Vk_GaussMap", "clockwise")),
    )
    text = " &nbsp; ".join(f'<span style="color:{color}">{name}</span>' for color, name in senses)
    return text + " &nbsp; × " + translate("Vk_GaussMap", "exact reversal")


def _in_turns(phi: float) -> str:
    return translate("Vk_GaussMap", "φ = {} turns").format(user().turns(phi))


def _in_degrees(angle: float) -> str:
    return f"{user().decimals(math.degrees(angle), 1)}°"
