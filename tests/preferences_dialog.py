# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's preferences dialog, opened for a function that works in the dialog."""

import dead_widgets
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from vkworkbench.gui.qt import widgets


def in_preferences(window, work):
    """Open the preferences, and call `work` with the dialog and the add-on's form. `work` closes the dialog."""
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
    """Show the page of the form, like a click on its group does."""
    for stack in widgets.find(QtGui.QStackedWidget):
        if stack.isAncestorOf(form):
            (index,) = (index for index in range(stack.count()) if stack.widget(index).isAncestorOf(form))
            stack.setCurrentIndex(index)
