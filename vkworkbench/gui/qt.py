# SPDX-License-Identifier: LGPL-2.1-or-later
"""All Qt names of the add-on, from FreeCAD's own wrapper.

FreeCAD 0.20's wrapper has no QtWidgets, but QtGui holds the widgets in every version.
"""

from PySide.QtCore import (
    QAbstractTableModel,
    QDate,
    QEvent,
    QEventLoop,
    QItemSelectionModel,
    QLocale,
    QModelIndex,
    QObject,
    QPoint,
    QPointF,
    QRectF,
    QSortFilterProxyModel,
    Qt,
    QTimer,
)  # fmt: skip
from PySide.QtGui import (
    QAbstractItemView,
    QApplication,
    QColor,
    QComboBox,
    QDockWidget,
    QFileDialog,
    QFont,
    QFontMetrics,
    QHBoxLayout,
    QHeaderView,
    QImage,
    QLabel,
    QListWidget,
    QMessageBox,
    QOffscreenSurface,
    QOpenGLContext,
    QPainter,
    QPalette,
    QPen,
    QProgressBar,
    QProgressDialog,
    QPushButton,
    QSlider,
    QSpinBox,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QToolButton,
    QToolTip,
    QTreeView,
    QVBoxLayout,
    QWidget,
)  # fmt: skip

__all__ = [
    "QAbstractItemView", "QAbstractTableModel", "QApplication", "QColor", "QComboBox", "QDate", "QDockWidget",
    "QEvent", "QEventLoop", "QFileDialog", "QFont", "QFontMetrics", "QHBoxLayout", "QHeaderView", "QImage",
    "QItemSelectionModel", "QLabel", "QListWidget", "QLocale", "QMessageBox", "QModelIndex", "QObject",
    "QOffscreenSurface", "QOpenGLContext", "QPainter", "QPalette", "QPen", "QPoint", "QPointF", "QProgressBar",
    "QProgressDialog", "QPushButton", "QRectF", "QSlider", "QSortFilterProxyModel", "QSpinBox", "QStyle",
    "QStyleOptionViewItem", "QStyledItemDelegate", "QTableView", "QTimer", "QToolButton", "QToolTip", "QTreeView",
    "QVBoxLayout", "QWidget", "Qt",
]  # fmt: skip
