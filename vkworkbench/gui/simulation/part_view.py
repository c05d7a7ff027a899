# SPDX-License-Identifier: LGPL-2.1-or-later
"""The image of the simulated part. The user turns, pans and zooms the part with the mouse, and clicks on surfaces."""

from __future__ import annotations

from dataclasses import replace
from math import floor, log10
from typing import NamedTuple

import FreeCAD
import numpy as np

from vkworkbench.core import Frame, Stock, View
from vkworkbench.core.rendering import Scene, project, turned
from vkworkbench.gui.qt.colors import paper
from vkworkbench.gui.qt.names import (
    QApplication,
    QColor,
    QEvent,
    QImage,
    QPainter,
    QPalette,
    QPen,
    QPointF,
    QPolygonF,
    QRectF,
    QSize,
    QSizePolicy,
    Qt,
    QWidget,
    Signal,
)  # fmt: skip
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import translate

TURN, PAN = "turn", "pan"
_LEFT, _MIDDLE, _RIGHT = Qt.LeftButton, Qt.MiddleButton, Qt.RightButton
_NONE, _SHIFT, _CTRL, _ALT = Qt.NoModifier, Qt.ShiftModifier, Qt.ControlModifier, Qt.AltModifier
# Mouse buttons and modifier keys in FreeCAD's navigation styles (preferences, Display > Navigation). In each style, the
# left button alone turns the part, too.
_STYLES = {
    "CAD": ((_MIDDLE, _NONE, PAN), (_MIDDLE | _LEFT, _NONE, TURN), (_MIDDLE | _RIGHT, _NONE, TURN)),
    "Gesture": ((_RIGHT, _NONE, PAN), (_MIDDLE, _NONE, TURN)),
    "MayaGesture": ((_LEFT, _ALT, TURN), (_MIDDLE, _ALT, PAN)),
    "Blender": ((_MIDDLE, _NONE, TURN), (_MIDDLE, _SHIFT, PAN)),
    "SolidWorks": ((_MIDDLE, _NONE, TURN), (_MIDDLE, _CTRL, PAN)),
    "SiemensNX": ((_MIDDLE, _NONE, TURN), (_MIDDLE | _RIGHT, _NONE, PAN), (_MIDDLE, _SHIFT, PAN)),
    "Revit": ((_MIDDLE, _NONE, PAN), (_MIDDLE, _SHIFT, TURN)),
    "Inventor": ((_MIDDLE, _NONE, PAN),),
    "OpenCascade": ((_MIDDLE, _CTRL, PAN), (_RIGHT, _CTRL, TURN)),
    "OpenSCAD": ((_RIGHT, _NONE, PAN),),
    "TinkerCAD": ((_MIDDLE, _NONE, PAN), (_RIGHT, _NONE, TURN)),
    "Touchpad": ((_LEFT, _SHIFT, PAN), (_LEFT, _ALT, TURN)),
}


def action(buttons, modifiers) -> str | None:
    """Return the action of dragging with these buttons and keys in the user's navigation style: `TURN`, `PAN`, or None."""
    if buttons == _LEFT and modifiers == _NONE:
        return TURN
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    name = group.GetString("NavigationStyle", "Gui::CADNavigationStyle")
    style = _STYLES.get(name.replace("Gui::", "").replace("NavigationStyle", ""), _STYLES["CAD"])
    return next((what for b, m, what in style if buttons == b and modifiers == m), None)


_TURN_SPEED = 0.008  # angle by which the view turns for each pixel of mouse motion, rad
_ZOOM = 1.2  # zoom factor for each notch of the mouse wheel
_RING = 14  # radius of the ring around a shown place, px
_MARGIN = 1.06  # size of the image, as a multiple of the size of the stock
_SCALE, _SCALE_GAP = 120, 8  # maximum length of the scale bar, and its distance from the corner, px
_TRIAD, _LETTER = 26, 12  # length of the drawn axes, and the distance of their letters, px
_AXIS_COLORS = ("#d64545", "#3f9b46", "#4477cc")


def round_length(most: float) -> float:
    """Return the largest length that is at most `most` and is 1, 2 or 5 times a power of ten."""
    power = 10.0 ** floor(log10(most))
    return next(digit * power for digit in (5, 2, 1) if digit * power <= most * (1 + 1e-9))


class Surface(NamedTuple):
    """A point on the surface of the part."""

    owner: int  # trajectory that made the surface; -1 for the raw stock, `CUT_OPEN` for the face of a section
    place: np.ndarray  # (3,): position of the point, mm


class PartView(QWidget):
    """A widget that shows images of a simulation."""

    changed = Signal()  # the view was turned, panned or zoomed, or the widget's size has changed
    resized = Signal()
    asked = Signal(object)  # the user clicked on a surface, the argument (`Surface`)
    restyled = Signal()  # the theme has changed, and with it the background

    def __init__(self, stock: Stock, direction: tuple[float, float, float], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stock = stock
        self._direction, self._offset = direction, (0.0, 0.0)
        self._zoom = 1.0
        self._scene: Scene | None = None
        self._image = QImage()
        self._frame: Frame | None = None
        self._place_shown: tuple[float, float, float] | None = None
        self._measured: tuple[np.ndarray, ...] = ()
        self._pressed = self._last = None
        self.setMinimumSize(160, 50)
        self.setSizePolicy(QSizePolicy.Expanding, QSizePolicy.Expanding)
        self.setFocusPolicy(Qt.StrongFocus)
        self.setBackgroundRole(QPalette.Base)  # a theme's style sheet sets the background only of this role
        self.setAccessibleName(translate("Vk_Simulate", "Simulated Part"))

    @property
    def background(self) -> tuple[int, int, int]:
        return paper(self.palette()).getRgb()[:3]

    @property
    def view(self) -> View:
        """The view to show, with one pixel for each pixel of the screen."""
        ratio = self.devicePixelRatioF()
        size = {"width": max(1, round(self.width() * ratio)), "height": max(1, round(self.height() * ratio))}
        whole = View(self._direction, **size).frame(self.stock)
        return View(self._direction, **size, pixel=whole.pixel * _MARGIN / self._zoom, offset=self._offset)

    @property
    def frame(self) -> Frame:
        """The frame (placement and pixels) of the view to show."""
        return self.view.frame(self.stock)

    def look(self, direction: tuple[float, float, float]) -> None:
        """Show the whole stock from a direction."""
        self._direction, self._offset, self._zoom = direction, (0.0, 0.0), 1.0
        self.changed.emit()

    def sizeHint(self) -> QSize:
        return QSize(400, 80)

    def show_scene(self, scene: Scene, frame: Frame) -> None:
        """Show a scene that was drawn with this frame."""
        self._scene, self._frame = scene, frame
        height, width = scene.pixels.shape
        # Copy the image, because it must live longer than the array of bytes.
        self._image = QImage(scene.pixels.tobytes(), width, height, 4 * width, QImage.Format_RGB32).copy()
        self.update()

    def show_place(self, place: tuple[float, float, float] | None) -> None:
        """Draw a ring around a point of the part, mm; remove the ring if `place` is None."""
        self._place_shown = place
        self.update()

    def show_measured(self, points: tuple[np.ndarray, ...]) -> None:
        """Draw the measured points, mm, and the line between two points; draw nothing if there are no points."""
        self._measured = points
        self.update()

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        try:
            self._paint(painter)
        finally:
            painter.end()  # end painting also after an error, because the traceback would keep the painter active

    def _paint(self, painter: QPainter) -> None:
        painter.fillRect(self.rect(), QColor(*self.background))
        if self._scene is None:
            return
        ratio = self.devicePixelRatioF()
        painter.save()
        painter.scale(1 / ratio, 1 / ratio)
        # After a change of the view, show the previous image at its place in the new view until a new image is drawn.
        wanted = self.frame
        painter.drawImage(self._place(wanted), self._image)
        if self._place_shown is not None:
            column, row, _ = project(np.array([self._place_shown]), wanted)[0]
            painter.setRenderHint(QPainter.Antialiasing)
            painter.setBrush(Qt.NoBrush)
            for color, width in (("#ffffff", 5), ("#d32f2f", 2.5)):  # red on white is visible on surfaces of any colour
                painter.setPen(QPen(QColor(color), width * ratio))
                painter.drawEllipse(QPointF(column, row), _RING * ratio, _RING * ratio)
        if self._measured:
            points = [QPointF(x, y) for x, y, _ in project(np.array(self._measured), wanted).tolist()]
            painter.setRenderHint(QPainter.Antialiasing)
            for color, width in (("#ffffff", 4), ("#1a5fb4", 2)):
                painter.setPen(QPen(QColor(color), width * ratio))
                painter.setBrush(QColor(color))
                painter.drawPolyline(QPolygonF(points))
                for point in points:
                    painter.drawEllipse(point, width * ratio, width * ratio)
        painter.restore()
        self._paint_scale(painter, wanted.pixel * ratio)
        self._paint_axes(painter, wanted)

    def _paint_scale(self, painter: QPainter, pixel: float) -> None:
        """Paint a scale bar of a round length; `pixel` is the size of one pixel of the widget on the part, mm."""
        factor, _ = user().length_unit(_SCALE * pixel)
        length = factor * round_length(_SCALE * pixel / factor)
        left, bottom = _SCALE_GAP, self.height() - _SCALE_GAP
        right = left + length / pixel
        painter.setPen(QPen(self.palette().text().color(), 1))
        painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in (
            (left, bottom - _SCALE_GAP / 2), (left, bottom), (right, bottom), (right, bottom - _SCALE_GAP / 2)
        )]))  # fmt: skip
        painter.drawText(QPointF(left + _SCALE_GAP / 2, bottom - _SCALE_GAP / 2), user().measure(length, 1))

    def _paint_axes(self, painter: QPainter, frame: Frame) -> None:
        """Paint the directions of X, Y and Z. The axis that points most towards the viewer is painted last."""
        painter.setRenderHint(QPainter.Antialiasing)
        centre = QPointF(self.width() - _TRIAD - _LETTER, self.height() - _TRIAD - _LETTER)
        axes = zip(frame.direction, frame.right, frame.up, "XYZ", _AXIS_COLORS)
        for _, right, up, name, color in sorted(axes, key=lambda axis: -axis[0]):
            end = QPointF(centre.x() + _TRIAD * right, centre.y() - _TRIAD * up)
            painter.setPen(QPen(QColor(color), 2))
            painter.drawLine(centre, end)
            away = 1 + _LETTER / (2 * _TRIAD)
            letter = QPointF(centre.x() + _TRIAD * right * away, centre.y() - _TRIAD * up * away)
            place = QRectF(letter.x() - _LETTER, letter.y() - _LETTER, 2 * _LETTER, 2 * _LETTER)
            painter.drawText(place, int(Qt.AlignCenter), name)

    def _place(self, wanted: Frame) -> QRectF:
        """Return the rectangle of the last drawn image in the view to show."""
        frame = self._frame
        scale = frame.pixel / wanted.pixel
        column, row, _ = project(frame.centre[None], wanted)[0]
        width, height = frame.width * scale, frame.height * scale
        return QRectF(column - width / 2, row - height / 2, width, height)

    def changeEvent(self, event) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.StyleChange, QEvent.PaletteChange):
            self.restyled.emit()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.resized.emit()
        self.changed.emit()

    def mousePressEvent(self, event) -> None:
        self._pressed = self._last = event.pos()
        self.setFocus()

    def mouseMoveEvent(self, event) -> None:
        if self._last is None:
            return
        moved = event.pos() - self._pressed
        if self._last == self._pressed and moved.manhattanLength() < QApplication.startDragDistance():
            return
        by, self._last = event.pos() - self._last, event.pos()
        doing = action(event.buttons(), event.modifiers())
        if doing == TURN:
            self._direction = turned(self._direction, by.x() * _TURN_SPEED, -by.y() * _TURN_SPEED)
            self.changed.emit()
        elif doing == PAN:
            self._shift(-by.x(), by.y())

    def mouseReleaseEvent(self, event) -> None:
        clicked = self._pressed is not None and self._last == self._pressed and event.button() == Qt.LeftButton
        self._pressed = self._last = None
        if clicked:
            surface = self.surface_at(event.pos())
            if surface is not None:
                self.asked.emit(surface)

    def surface_at(self, where) -> Surface | None:
        """Return the surface at a position of the mouse; None on the background, and before the first image."""
        if self._scene is None:
            return None
        ratio = self.devicePixelRatioF()
        place = self._place(self.frame)
        height, width = self._scene.depth.shape
        column = int((where.x() * ratio - place.left()) / place.width() * width)
        row = height - 1 - int((where.y() * ratio - place.top()) / place.height() * height)
        if not (0 <= column < width and 0 <= row < height) or np.isnan(self._scene.depth[row, column]):
            return None
        # The depths of an averaged picture are finer than its pixels.
        frame = replace(self._frame, pixel=self._frame.pixel * self._frame.width / width, width=width, height=height)
        (point,) = frame.points([column], [row], self._scene.depth[row, column : column + 1])
        return Surface(int(self._scene.owner[row, column]), point)

    def wheelEvent(self, event) -> None:
        factor = _ZOOM ** (event.angleDelta().y() / 120)
        at = event.position()
        # Zoom around the point of the part under the mouse pointer.
        x, y = at.x() - self.width() / 2, self.height() / 2 - at.y()
        self._shift(x, y)
        self._zoom = min(max(self._zoom * factor, 0.2), 200.0)
        self._shift(-x, -y)

    def _shift(self, right: float, up: float) -> None:
        """Move the eye to the right and up by a number of pixels of the widget."""
        pixel = self.view.pixel * self.devicePixelRatioF()
        self._offset = self._offset[0] + right * pixel, self._offset[1] + up * pixel
        self.changed.emit()
