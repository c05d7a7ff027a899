# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons of the OpenGL simulator's window, which Qt does not know; for the benchmark and the tests."""

from PySide import QtCore, QtGui

from vkworkbench import freecad

# Where they are, from the window's lower left corner.
PLAY, FASTER = ((52, -34), (136, -34)) if freecad.version() < (1, 1, 0) else ((42, -36), (172, -36))


def click(window, x, y):
    """Click with the left button, y from below."""
    where = QtCore.QPointF(x, window.height() + y)
    none, left = QtCore.Qt.NoButton, QtCore.Qt.LeftButton
    for kind, button, buttons in (
        (QtCore.QEvent.MouseMove, none, none),
        (QtCore.QEvent.MouseButtonPress, left, left),
        (QtCore.QEvent.MouseButtonRelease, left, none),
    ):
        event = QtGui.QMouseEvent(kind, where, where, button, buttons, QtCore.Qt.NoModifier)
        QtCore.QCoreApplication.sendEvent(window, event)
