# SPDX-License-Identifier: LGPL-2.1-or-later
"""All Qt names of the add-on, from FreeCAD's own wrapper.

FreeCAD 0.20's wrapper has no QtWidgets, but QtGui holds the widgets in every version.
"""

from PySide.QtCore import QEvent, QItemSelectionModel, QModelIndex, QObject, Qt, QTimer
from PySide.QtGui import QDockWidget, QHeaderView, QMessageBox, QProgressDialog, QTreeView

__all__ = [
    "QDockWidget", "QEvent", "QHeaderView", "QItemSelectionModel", "QMessageBox", "QModelIndex", "QObject",
    "QProgressDialog", "QTimer", "QTreeView", "Qt",
]  # fmt: skip
