# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controls of a simulation: rows above the part control the view, rows below the part control the shown moment."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from vkworkbench.core.zbuffer import TOLERANCE
from vkworkbench.gui.qt.names import (
    MenuButton,
    QAction,
    QComboBox,
    QDoubleSpinBox,
    QHBoxLayout,
    QMenu,
    QSlider,
    QStyle,
    QStyleOptionComboBox,
    QStylePainter,
    Qt,
    QToolButton,
    QVBoxLayout,
    QWidget,
    Signal,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import OneLine, as_html
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, explain, translate
from vkworkbench.gui.simulation import exports
from vkworkbench.gui.simulation.coloring import COLORINGS, by_difference
from vkworkbench.gui.simulation.faults import Fault
from vkworkbench.gui.simulation.widgets import PAUSE, PLAY, Legend, SymbolButton

# Playback speeds, as multiples of the machine's speed. The speed None plays the whole job in _WHOLE seconds.
_SPEEDS = (1, 10, 100, 1000, None)
_WHOLE = 30.0
_VIEWS = (
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Isometric"), "Isometric"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Top"), "Top"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Front"), "Front"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Right"), "Right"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Rear"), "Rear"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Left"), "Left"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Bottom"), "Bottom"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "As in the 3D View"), None),
)
_AXES = "XYZ"
PART, CHIPS, BOTH = range(3)
GAP = 4  # px between rows, and between the widgets of a row
_MIN_LETTERS = 4  # minimum width of a combo box, in letters
_BORDERS = 60  # px that a menu needs beside the text of an entry


class SceneBar(QWidget):
    """Controls for the direction of the view, the colours and the chips, a list of warnings, and a menu for saving."""

    looked = Signal(object)  # the user chose a standard direction by its name, or the direction of the 3D view (None)
    recolored = Signal()  # the user changed the colouring or the tolerance
    chosen = Signal()  # the user chose to show the part, the chips or both, or the path of the tool
    hinted, pointed = Signal(object), Signal(object)  # the mouse pointer is on a fault (`Fault`); the user chose it
    saved = Signal(object)  # the user asked to save; the argument is the function of `exports` that saves

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.views = _menu(
            translate("Vk_Simulate", "View"),
            translate("Vk_Simulate", "Direction of the view, path of the tool, section, and measuring."),
        )
        for text, name in _VIEWS:
            action = self.views.menu().addAction(user().translate("Vk_Simulate", text))
            action.triggered.connect(lambda *_, n=name: self.looked.emit(n))
        self.section = SectionBar()
        self._add_aids(self.views.menu())
        self.colorings = _combo(translate("Vk_Simulate", "Property that colors the surfaces."))
        for text, _ in COLORINGS:
            self.colorings.addItem(user().translate("Vk_Simulate", text))
        self.chips = _combo(
            translate("Vk_Simulate", "Shows the part, the material that the current operation removes, or both.")
        )
        self.chips.addItem(translate("Vk_Simulate", "Part"))
        self.chips.addItem(translate("Vk_Simulate", "Chips"))
        self.chips.addItem(translate("Vk_Simulate", "Part and Chips"))
        self.colorings.currentIndexChanged.connect(lambda *_: self.recolored.emit())
        self.chips.currentIndexChanged.connect(lambda *_: self.chosen.emit())
        self.legend = Legend()
        factor, unit = user().length_unit(TOLERANCE)
        self.tolerance = QDoubleSpinBox()
        explain(self.tolerance, translate("Vk_Simulate", "Differences from the model below this value are ignored."))
        self.tolerance.setDecimals(3)
        self.tolerance.setPrefix("± ")
        self.tolerance.setSuffix(f" {unit}")
        self.tolerance.setRange(0.001, 100 / factor)
        self.tolerance.setSingleStep(0.5 * TOLERANCE / factor)
        self.tolerance.setValue(TOLERANCE / factor)
        self.tolerance.valueChanged.connect(lambda *_: self.recolored.emit())
        self._unit = factor
        self.worst = _menu(
            translate("Vk_Simulate", "Worst Places"),
            translate("Vk_Simulate", "Places where the part differs most from the model. Choose a place to see it."),
        )
        self.warnings = _menu(
            translate("Vk_Simulate", "⚠ Warnings: {}").format(0),
            translate("Vk_Simulate", "Collisions, gouges and fast plunges in the simulation. Choose one to see it."),
        )
        bold = self.warnings.font()
        bold.setBold(True)
        self.warnings.setFont(bold)
        self.warnings.hide()
        save = _menu(
            translate("Vk_Simulate", "Save"),
            translate("Vk_Simulate", "Saves pictures, the shown part as a solid, or removal rates."),
        )
        _, _, *self.results = (self._saving(save.menu(), text, work) for text, work in (
            (translate("Vk_Simulate", "Picture…"), exports.save_picture),
            (translate("Vk_Simulate", "Pictures of the Whole Job…"), exports.save_frames),
            (translate("Vk_Simulate", "Shown Part as STL…"), exports.save_part),
            (translate("Vk_Simulate", "Shown Part as Mesh in the Document"), exports.add_part),
            (translate("Vk_Simulate", "Removal Rates…"), exports.save_rates),
        ))  # fmt: skip
        for action in self.results:
            action.setEnabled(False)
            action.setToolTip(translate("Vk_Simulate", "This is available when the finest picture is ready."))
        self.controls, self.differences = QWidget(), QWidget()
        _fill(self.controls, self.views, self.colorings, None, self.warnings, self.chips, save)
        _fill(self.differences, self.tolerance, self.worst, None)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GAP)
        for widget in (self.controls, self.differences, self.section, self.legend):
            layout.addWidget(widget)

    @property
    def compares(self) -> bool:
        """Whether surfaces are coloured by their difference from the model."""
        return COLORINGS[self.colorings.currentIndex()][1] is by_difference

    @property
    def tolerance_mm(self) -> float:
        return self.tolerance.value() * self._unit

    def list_warnings(self, found: Sequence[Fault], text: Callable[[Fault], str]) -> None:
        """List faults in the menu of warnings, each with the text that `text` returns."""
        self._list(self.warnings, found, text)
        count = user().count(len(found))
        self.warnings.setText(translate("Vk_Simulate", "⚠ Warnings: {}").format(count))
        self.warnings.setVisible(bool(found))

    def list_worst(self, found: Sequence[Fault], text: Callable[[Fault], str]) -> None:
        """List the largest differences from the model in the menu of worst places."""
        self._list(self.worst, found, text)
        self.worst.setEnabled(bool(found))

    def _add_aids(self, menu: QMenu) -> None:
        """Add the path of the tool, sections and measuring to the menu of views."""
        menu.addSeparator()
        self.path = menu.addAction(translate("Vk_Simulate", "Path of the Tool"))
        self.path.setToolTip(translate("Vk_Simulate", "Shows the path of the operation: blue is done, pink to come."))
        self.measure = menu.addAction(translate("Vk_Simulate", "Measure"))
        self.measure.setToolTip(translate("Vk_Simulate", "Two clicks on the part show their distance. Esc ends it."))
        for action in (self.path, self.measure):
            action.setCheckable(True)
        self.path.toggled.connect(lambda *_: self.chosen.emit())
        menu.addSeparator()
        for axis, name in enumerate(_AXES):
            action = menu.addAction(translate("Vk_Simulate", "Section in {}").format(name))
            action.triggered.connect(lambda *_, axis=axis: self.section.begin(axis))
        none = menu.addAction(translate("Vk_Simulate", "No Section"))
        none.triggered.connect(lambda *_: self.section.begin(None))

    def _saving(self, menu: QMenu, text: str, work: Callable) -> QAction:
        action = menu.addAction(text)
        action.triggered.connect(lambda *_: self.saved.emit(work))
        return action

    def _list(self, button: QToolButton, found: Sequence[Fault], text: Callable[[Fault], str]) -> None:
        button.menu().clear()
        for fault in found:
            words = text(fault)
            short = self.fontMetrics().elidedText(words, Qt.ElideRight, self.window().width() - _BORDERS)
            action = button.menu().addAction(short.replace("&", "&&"))
            action.setToolTip(as_html(words))
            action.hovered.connect(lambda *_, fault=fault: self.hinted.emit(fault))
            action.triggered.connect(lambda *_, fault=fault: self.pointed.emit(fault))


class SectionBar(QWidget):
    """A slider that moves the section."""

    changed = Signal()  # the section has been moved, shown or removed
    _STEPS = 1000

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.axis: int | None = None  # axis perpendicular to the section; None without a section
        self.place = OneLine()
        self.slider = QSlider(Qt.Horizontal)
        self.slider.setRange(0, self._STEPS)
        self.slider.setValue(self._STEPS // 2)
        explain(self.slider, translate("Vk_Simulate", "Moves the section through the stock."))
        self.slider.valueChanged.connect(lambda *_: self.changed.emit())
        row = _fill(self, self.slider, self.place)
        row.setStretch(0, 3)
        row.setStretch(1, 1)

    @property
    def share(self) -> float:
        """Position of the section in the stock, from 0 (lower end) to 1 (upper end)."""
        return self.slider.value() / self._STEPS

    def begin(self, axis: int | None) -> None:
        """Show a section perpendicular to an axis; None removes the section."""
        self.axis = axis
        self.changed.emit()

    def show_place(self, millimetres: float) -> None:
        """Show the coordinate of the section as text."""
        self.place.show_text(f"{_AXES[self.axis or 0]} {user().measure(millimetres, 4)}")


class PlayBar(QWidget):
    """Buttons for stepping and playing, and a text about the shown moment."""

    # The user asked for a step by a trajectory (1), a command (2) or an operation (3); backwards if negative.
    stepped = Signal(int)
    play_clicked = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.play_button = SymbolButton(PLAY)
        explain(self.play_button, translate("Vk_Simulate", "Plays or pauses the simulation (Space)."))
        self.play_button.clicked.connect(lambda *_: self.play_clicked.emit())
        self.speeds = _combo(translate("Vk_Simulate", "Speed of the playback, compared with the machine."))
        for speed in _SPEEDS:
            text = translate("Vk_Simulate", "Job in {}").format(user().time(_WHOLE)) if speed is None else f"×{speed}"
            self.speeds.addItem(text if speed != 1 else translate("Vk_Simulate", "Real Time"))
        self.speeds.setCurrentIndex(len(_SPEEDS) - 1)
        self.steps = {by: self._step(by, tooltip) for by, tooltip in (
            (-3, translate("Vk_Simulate", "Go to the beginning of the operation.")),
            (-2, translate("Vk_Simulate", "Go back by one command of the program.")),
            (-1, translate("Vk_Simulate", "Go back by one trajectory.")),
            (1, translate("Vk_Simulate", "Go forward by one trajectory.")),
            (2, translate("Vk_Simulate", "Go forward by one command of the program.")),
            (3, translate("Vk_Simulate", "Go to the end of the operation.")),
        )}  # fmt: skip
        self.text = OneLine()
        self.text.setTextInteractionFlags(Qt.TextSelectableByMouse)
        self.controls = QWidget()
        back, on = ([button for by, button in self.steps.items() if by * sign > 0] for sign in (-1, 1))
        _fill(self.controls, *back, self.play_button, *on, self.speeds, None)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GAP)
        for widget in (self.controls, self.text):
            layout.addWidget(widget)

    def speed(self, total: float) -> float:
        """Return the chosen playback speed for a job of `total` s, as a multiple of the machine's speed."""
        return _SPEEDS[self.speeds.currentIndex()] or total / _WHOLE

    def show_playing(self, plays: bool) -> None:
        self.play_button.show_symbol(PAUSE if plays else PLAY)

    def _step(self, by: int, tooltip: str) -> QToolButton:
        button = SymbolButton(by)
        explain(button, tooltip)
        button.setAutoRepeat(abs(by) < 3)
        button.clicked.connect(lambda *_: self.stepped.emit(by))
        return button


class _Combo(QComboBox):
    """A combo box that shortens its text with "…". Qt's combo box would cut the text off."""

    def paintEvent(self, event) -> None:
        painter, option = QStylePainter(self), QStyleOptionComboBox()
        self.initStyleOption(option)
        field = self.style().subControlRect(QStyle.CC_ComboBox, option, QStyle.SC_ComboBoxEditField, self)
        option.currentText = option.fontMetrics.elidedText(option.currentText, Qt.ElideRight, field.width())
        painter.drawComplexControl(QStyle.CC_ComboBox, option)
        painter.drawControl(QStyle.CE_ComboBoxLabel, option)


def _menu(text: str, tooltip: str) -> MenuButton:
    button = MenuButton(text)
    button.setToolTip(tooltip)
    button.menu().setToolTipsVisible(True)
    return button


def _combo(tooltip: str) -> QComboBox:
    box = _Combo()
    explain(box, tooltip)
    box.setFocusPolicy(Qt.StrongFocus)
    box.setMinimumContentsLength(_MIN_LETTERS)
    return box


def _fill(bar: QWidget, *widgets: QWidget | None) -> QHBoxLayout:
    row = QHBoxLayout(bar)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(GAP)
    for widget in widgets:
        if widget is None:
            row.addStretch(1)
        else:
            row.addWidget(widget)
    return row
