# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets that FreeCAD leaves behind and that PySide takes for alive.

Since 1.0 FreeCAD leaves forms of pages each time its preferences are closed, and one each time the panel of its simulator is
closed. What Qt later makes at the same address is taken for that widget, and FreeCAD ends: after the twenty dialogs
of these tests that is likely.
"""

import gc
import sys

from PySide import QtCore, QtGui

shiboken = sys.modules.get("shiboken6") or sys.modules["shiboken2"]


def forget():
    """Tell PySide which widgets are gone; the add-on leaves none."""
    alive = {shiboken.getCppPointer(widget)[0] for widget in QtGui.QApplication.allWidgets()}
    kinds = set(_with_subclasses(QtGui.QWidget))  # a look into a set is faster than isinstance
    for thing in gc.get_objects():
        if (
            type(thing) in kinds
            and shiboken.isValid(thing)
            and (shiboken.getCppPointer(thing)[0] not in alive or _is_left_form(thing))
        ):
            shiboken.invalidate(thing)
            assert not type(thing).__module__.startswith("vkworkbench"), (
                f"{type(thing)} is dead, and PySide does not know"
            )


def _with_subclasses(kind):
    yield kind
    for below in type.__subclasses__(kind):
        yield from _with_subclasses(below)


def _is_left_form(widget):
    """Return whether parts of a form are gone that it has as attributes: at its address is now another widget."""
    return any(isinstance(part, QtCore.QObject) and not shiboken.isValid(part) for part in vars(widget).values())
