# SPDX-License-Identifier: LGPL-2.1-or-later
"""Invalidate PySide's wrappers of widgets that FreeCAD has deleted.

Since version 1.0, FreeCAD leaves wrappers of deleted widgets when its preferences or a simulator's panel are closed.
PySide mistakes a later widget at the same address for the deleted widget, and FreeCAD crashes.
"""

import gc
import sys

from PySide import QtCore, QtGui

shiboken = sys.modules.get("shiboken6") or sys.modules["shiboken2"]


def forget():
    """Invalidate the wrappers of deleted widgets, and assert that the add-on owns no deleted widget."""
    alive = {shiboken.getCppPointer(widget)[0] for widget in QtGui.QApplication.allWidgets()}
    kinds = set(_with_subclasses(QtGui.QWidget))  # looking up an object's type in a set is faster than isinstance()
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
    """Return whether parts of a form were deleted, which means that another widget is now at its address."""
    return any(isinstance(part, QtCore.QObject) and not shiboken.isValid(part) for part in vars(widget).values())
