# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's dialog of preferences, opened in front of a function that works in it."""

import dead_widgets
import FreeCADGui as Gui
from PySide import QtCore, QtGui


def in_preferences(window, work):
    """Open the preferences, call `work` with the dialog and this workbench's form, shown; `work` closes the dialog."""
    failure = []

    def answer():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            QtCore.QTimer.singleShot(50, answer)
            return
        try:
            form = dialog.findChild(QtGui.QWidget, "VkPreferences")
            show_page(dialog, form)
            window.idle(0.2)
            work(dialog, form)
        except BaseException as error:
            failure.append(error)
            dialog.reject()

    QtCore.QTimer.singleShot(50, answer)
    Gui.runCommand("Std_DlgPreferences")
    dead_widgets.forget()
    if failure:
        raise failure[0]


def show_page(dialog, form):
    """Turn to the page, as clicks on its group would."""
    parent = form
    while parent is not dialog:
        stack, parent = parent, parent.parentWidget()
        if isinstance(parent, QtGui.QStackedWidget):
            parent.setCurrentWidget(stack)
