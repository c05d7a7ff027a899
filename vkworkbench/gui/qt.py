# SPDX-License-Identifier: LGPL-2.1-or-later
"""All Qt names of the add-on, from FreeCAD's own wrapper.

FreeCAD 0.20's wrapper has no QtWidgets, but QtGui holds the widgets in every version.
"""

from PySide.QtCore import QEvent, QItemSelectionModel, QModelIndex, QObject, QRectF, QTimer, Qt
from PySide.QtGui import (
    QApplication, QColor, QComboBox, QDockWidget, QFileDialog, QHBoxLayout, QHeaderView, QLabel,
    QMessageBox, QPainter, QPalette, QPen, QProgressDialog, QPushButton, QSlider, QSpinBox, QStyle,
    QStyleOptionViewItem, QStyledItemDelegate, QToolTip, QTreeView, QVBoxLayout, QWidget,
)  # fmt: skip

__all__ = [
    "QApplication", "QColor", "QComboBox", "QDockWidget", "QEvent", "QFileDialog", "QHBoxLayout",
    "QHeaderView", "QItemSelectionModel", "QLabel", "QMessageBox", "QModelIndex", "QObject", "QPainter",
    "QPalette", "QPen", "QProgressDialog", "QPushButton", "QRectF", "QSlider", "QSpinBox", "QStyle",
    "QStyleOptionViewItem", "QStyledItemDelegate", "QTimer", "QToolTip", "QTreeView", "QVBoxLayout",
    "QWidget", "Qt",
]  # fmt: skip
