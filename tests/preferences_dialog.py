# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's dialog of preferences, opened in front of a function that works in it."""

import dead_widgets
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from vkworkbench.gui.qt import widgets


def in_preferences(window, work):
    """Open the preferences, call `work` with the dialog and this workbench's form, shown; `work` closes the dialog."""
    failure = []

    def answer():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            QtCore.QTimer.singleShot(50, answer)
            return
        try:
            (form,) = (form for form in widgets.find(QtGui.QWidget, "VkPreferences") if dialog.isAncestorOf(form))
            show_page(form)
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


def show_page(form):
    """Turn to the page, as clicks on its group would."""
    for stack in widgets.find(QtGui.QStackedWidget):
        if stack.isAncestorOf(form):
            (index,) = (index for index in range(stack.count()) if stack.widget(index).isAncestorOf(form))
            stack.setCurrentIndex(index)
