# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons of the OpenGL simulator's window, which are not Qt widgets, for the benchmark and the tests."""

from PySide import QtCore, QtGui

from vkworkbench import freecad

# Positions of two buttons, and of the slider's thumb at the start, px from the window's lower left corner.
PLAY, FASTER, THUMB = (
    ((52, -34), (136, -34), (240, -34)) if freecad.version() < (1, 1, 0) else ((42, -36), (172, -36), (30, -78))
)


_NONE, _LEFT = QtCore.Qt.NoButton, QtCore.Qt.LeftButton
MOVE, PRESS = (QtCore.QEvent.MouseMove, _NONE, _NONE), (QtCore.QEvent.MouseButtonPress, _LEFT, _LEFT)
DRAG, RELEASE = (QtCore.QEvent.MouseMove, _NONE, _LEFT), (QtCore.QEvent.MouseButtonRelease, _LEFT, _NONE)


def send(window, x, y, kind):
    """Send a mouse event to a position `x` px from the left edge of the window and `-y` px above its lower edge."""
    where, (event, button, buttons) = QtCore.QPointF(x, window.height() + y), kind
    QtCore.QCoreApplication.sendEvent(
        window, QtGui.QMouseEvent(event, where, where, button, buttons, QtCore.Qt.NoModifier)
    )


def click(window, x, y):
    """Click with the left button, `x` px from the left edge of the window and `-y` px above its lower edge."""
    for kind in (MOVE, PRESS, RELEASE):
        send(window, x, y, kind)
