# SPDX-License-Identifier: LGPL-2.1-or-later
"""All Qt names that the add-on uses, from FreeCAD's own package PySide, and small helpers for Qt.

In FreeCAD 0.20 the package PySide has no module QtWidgets, but in every version its module QtGui contains the widgets.
"""

from __future__ import annotations

from collections.abc import Callable

from PySide.QtCore import (
    QAbstractItemModel,
    QDate,
    QEvent,
    QEventLoop,
    QItemSelectionModel,
    QLineF,
    QLocale,
    QModelIndex,
    QObject,
    QPoint,
    QPointF,
    QRectF,
    QSize,
    QSortFilterProxyModel,
    Qt,
    QTimer,
    Signal,
)  # fmt: skip
from PySide.QtGui import (
    QAbstractItemView,
    QAction,
    QApplication,
    QCheckBox,
    QColor,
    QComboBox,
    QCursor,
    QDialogButtonBox,
    QDockWidget,
    QDoubleSpinBox,
    QFileDialog,
    QFont,
    QFontMetrics,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QIcon,
    QImage,
    QInputDialog,
    QKeySequence,
    QLabel,
    QLineEdit,
    QListWidget,
    QMdiArea,
    QMenu,
    QMessageBox,
    QOffscreenSurface,
    QOpenGLContext,
    QPainter,
    QPalette,
    QPen,
    QPixmap,
    QPolygonF,
    QProgressBar,
    QProgressDialog,
    QPushButton,
    QRegion,
    QScrollArea,
    QSizePolicy,
    QSlider,
    QSpinBox,
    QSplitter,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionComboBox,
    QStyleOptionViewItem,
    QStylePainter,
    QTabWidget,
    QTextBrowser,
    QToolButton,
    QToolTip,
    QTreeView,
    QVBoxLayout,
    QWidget,
)  # fmt: skip


def single_shot(work: Callable[[], object] | Signal, parent: QObject | None = None, ms: int = 0) -> QTimer:
    """Return a timer that calls `work`, or emits the signal, once after `ms`.

    If the timer is started again before `ms` are over, the call is delayed again.
    """
    timer = QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(ms)
    timer.timeout.connect(work)
    return timer


def svg_generator(path: str, width: int, height: int, title: str):
    """Return a paint device that writes an SVG file."""
    from PySide.QtCore import QRect, QSize
    from PySide.QtSvg import QSvgGenerator

    generator = QSvgGenerator()
    generator.setFileName(path)
    generator.setSize(QSize(width, height))
    generator.setViewBox(QRect(0, 0, width, height))
    generator.setTitle(title)
    return generator


class MenuButton(QToolButton):
    """A button that opens a menu, wide enough for the arrow that FreeCAD 1.1's theme would draw over the text."""

    def __init__(self, text: str, menu: QMenu | None = None) -> None:
        super().__init__()
        self.setText(text)
        self.setPopupMode(QToolButton.InstantPopup)
        self.setMenu(menu or QMenu(self))

    def sizeHint(self) -> QSize:
        # No widget argument, because with a widget FreeCAD 1.1's theme would return 0.
        arrow = self.style().pixelMetric(QStyle.PM_MenuButtonIndicator)
        return super().sizeHint() + QSize(arrow, 0)
