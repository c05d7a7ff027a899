# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of the colours, in a corner of the 3D view and of its screenshots."""

from __future__ import annotations

from collections.abc import Iterable

import FreeCADGui as Gui
from pivy import coin

from vkworkbench.core import Strategy
from vkworkbench.gui.qt.colors import RAPID
from vkworkbench.gui.qt.names import QApplication, QColor, QFontMetrics, QImage, QPainter, QPen, QPointF, QRectF, Qt
from vkworkbench.gui.qt.sentences import strategy_name
from vkworkbench.gui.qt.text import translate

_PAPER, _INK = "#f7f7f7", "#1b1b1b"  # colours of the legend's background and text
_SAMPLE = 26  # length of the line that shows a strategy's colour, px
_GAP, _MARGIN = 8, 12  # distances within the legend, px
_WIDTH = 3  # width of the line that shows a strategy's colour, px


class Legend:
    """The legend of one document, in all its 3D views."""

    def __init__(self, document_name: str) -> None:
        self._document = document_name
        self._entries: list[tuple[str, str]] = []
        self._root, self._image = _overlay()
        self._keeper = coin.SoGroup()  # keeps the legend's node, which would be deleted with the last 3D view
        self._keeper.addChild(self._root)

    def show(self, strategies: Iterable[Strategy]) -> None:
        """Show the colours and names of strategies and of rapid moves."""
        seen = set(strategies)
        entries = [(s.color, strategy_name(s)) for s in Strategy if s in seen]
        entries.append((RAPID, translate("Vk_Strategies", "Rapid Moves")))
        if entries != self._entries:
            self._entries = entries
            _fill(self._image, _painted(entries))
        for scene in self._scenes():
            if scene.findChild(self._root) < 0:
                scene.addChild(self._root)

    def remove(self) -> None:
        """Remove the legend from the views."""
        for scene in self._scenes():
            if scene.findChild(self._root) >= 0:
                scene.removeChild(self._root)

    def _scenes(self) -> list[coin.SoGroup]:
        views = Gui.getDocument(self._document).mdiViewsOfType("Gui::View3DInventor")
        return [view.getSceneGraph() for view in views]


def _overlay() -> tuple[coin.SoGroup, coin.SoImage]:
    """Return nodes that show an image in the lower left corner of a 3D view, in front of all objects.

    FreeCAD's command "Fit all" ignores the nodes.
    """
    # The Python package coin has no constructor for SoSkipBoundingGroup, because FreeCAD defines this class.
    node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    node.getField("mode").set("EXCLUDE_BBOX")
    root = coin.cast(node, "SoGroup")
    root.setName("VkLegend")
    apart = coin.SoSeparator()
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.height = 2
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    depth = coin.SoDepthBuffer()
    depth.test = False
    corner = coin.SoTranslation()
    corner.translation = (-0.99, -0.98, 0)
    image = coin.SoImage()
    image.horAlignment, image.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    front = coin.SoAnnotation()
    for child in (camera, pick, depth, corner, image):
        front.addChild(child)
    apart.addChild(front)
    root.addChild(apart)
    return root, image


def _painted(entries: list[tuple[str, str]]) -> QImage:
    ratio = Gui.getMainWindow().devicePixelRatioF()
    font = QApplication.font()
    text = QFontMetrics(font)
    line = text.height() + 2
    width = max(text.boundingRect(name).width() for _, name in entries) + _SAMPLE + 2 * _MARGIN + _GAP
    height = line * len(entries) + 2 * _GAP
    image = QImage(round(width * ratio), round(height * ratio), QImage.Format_RGBA8888)
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.transparent)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.Antialiasing)
    painter.setFont(font)
    painter.setPen(Qt.NoPen)
    painter.setBrush(QColor(_PAPER))
    painter.drawRoundedRect(QRectF(0, 0, width, height), 4, 4)
    for row, (color, name) in enumerate(entries):
        middle = _GAP + line * (row + 0.5)
        painter.setPen(QPen(QColor(color), _WIDTH))
        painter.drawLine(QPointF(_MARGIN, middle), QPointF(_MARGIN + _SAMPLE, middle))
        painter.setPen(QColor(_INK))
        left = _MARGIN + _SAMPLE + _GAP
        painter.drawText(QRectF(left, middle - line / 2, width - left, line), int(Qt.AlignVCenter), name)
    painter.end()
    return image


def _fill(node: coin.SoImage, image: QImage) -> None:
    upside_down = image.mirrored(False, True)
    size = coin.SbVec2s(image.width(), image.height())
    node.image.setValue(size, 4, bytes(upside_down.constBits()))
