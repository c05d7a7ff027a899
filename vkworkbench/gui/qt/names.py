# SPDX-License-Identifier: LGPL-2.1-or-later
"""All Qt names of the add-on, from FreeCAD's own wrapper, and what takes several of Qt's calls.

FreeCAD 0.20's wrapper has no QtWidgets, but QtGui holds the widgets in every version.
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
    QDialogButtonBox,
    QDockWidget,
    QDoubleSpinBox,
    QFileDialog,
    QFont,
    QFontMetrics,
    QFrame,
    QHBoxLayout,
    QHeaderView,
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

__all__ = [
    "QAbstractItemModel", "QAbstractItemView", "QAction", "QApplication", "QCheckBox", "QColor", "QComboBox",
    "QDate", "QDialogButtonBox", "QDockWidget", "QDoubleSpinBox", "QEvent", "QEventLoop", "QFileDialog",
    "QFont", "QFontMetrics", "QFrame", "QHBoxLayout",
    "QHeaderView", "QImage", "QInputDialog", "QItemSelectionModel", "QKeySequence", "QLabel", "QLineEdit", "QLineF", "QListWidget",
    "QLocale", "QMdiArea", "QMenu", "QMessageBox", "QModelIndex", "QObject", "QOffscreenSurface", "QOpenGLContext",
    "QPainter", "QPalette", "QPen", "QPixmap", "QPoint", "QPointF", "QPolygonF", "QProgressBar", "QProgressDialog",
    "QPushButton", "QRectF", "QRegion", "QScrollArea", "QSize", "QSizePolicy", "QSlider", "QSortFilterProxyModel", "QSpinBox",
    "QSplitter", "QStyle", "QStyleOptionComboBox", "QStyleOptionViewItem", "QStylePainter", "QStyledItemDelegate",
    "QTabWidget", "QTextBrowser", "QTimer", "QToolButton", "QToolTip", "QTreeView", "QVBoxLayout", "QWidget", "Qt", "Signal",
    "single_shot", "svg_generator",
]  # fmt: skip


def single_shot(work: Callable[[], object] | Signal, parent: QObject | None = None, ms: int = 0) -> QTimer:
    """Return a timer that does the work, or emits the signal, once for many starts: as soon as other events are done."""
    timer = QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(ms)
    timer.timeout.connect(work)
    return timer


def svg_generator(path: str, width: int, height: int, title: str):
    """Return what a painter writes into an SVG file."""
    from PySide.QtCore import QRect, QSize
    from PySide.QtSvg import QSvgGenerator

    generator = QSvgGenerator()
    generator.setFileName(path)
    generator.setSize(QSize(width, height))
    generator.setViewBox(QRect(0, 0, width, height))
    generator.setTitle(title)
    return generator
