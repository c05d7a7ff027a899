# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse does in FreeCAD's navigation style that the user has chosen. The left button alone always turns."""

from __future__ import annotations

import FreeCAD

from vkworkbench.gui.qt.names import Qt

TURN, PAN = "turn", "pan"
_LEFT, _MIDDLE, _RIGHT = Qt.LeftButton, Qt.MiddleButton, Qt.RightButton
_NONE, _SHIFT, _CTRL, _ALT = Qt.NoModifier, Qt.ShiftModifier, Qt.ControlModifier, Qt.AltModifier
# Buttons and key of each style; see FreeCAD's preferences, Display > Navigation.
_STYLES = {
    "CAD": ((_MIDDLE, _NONE, PAN), (_MIDDLE | _LEFT, _NONE, TURN), (_MIDDLE | _RIGHT, _NONE, TURN)),
    "Gesture": ((_RIGHT, _NONE, PAN), (_MIDDLE, _NONE, TURN)),
    "MayaGesture": ((_LEFT, _ALT, TURN), (_MIDDLE, _ALT, PAN)),
    "Blender": ((_MIDDLE, _NONE, TURN), (_MIDDLE, _SHIFT, PAN)),
    "SolidWorks": ((_MIDDLE, _NONE, TURN), (_MIDDLE, _CTRL, PAN)),
    "SiemensNX": ((_MIDDLE, _NONE, TURN), (_MIDDLE | _RIGHT, _NONE, PAN), (_MIDDLE, _SHIFT, PAN)),
    "Revit": ((_MIDDLE, _NONE, PAN), (_MIDDLE, _SHIFT, TURN)),
    "Inventor": ((_MIDDLE, _NONE, PAN),),
    "OpenCascade": ((_MIDDLE, _CTRL, PAN), (_RIGHT, _CTRL, TURN)),
    "OpenSCAD": ((_RIGHT, _NONE, PAN),),
    "TinkerCAD": ((_MIDDLE, _NONE, PAN), (_RIGHT, _NONE, TURN)),
    "Touchpad": ((_LEFT, _SHIFT, PAN), (_LEFT, _ALT, TURN)),
}


def action(buttons, modifiers) -> str | None:
    """Return what dragging with these buttons and keys does: `TURN`, `PAN`, or None."""
    if buttons == _LEFT and modifiers == _NONE:
        return TURN
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    name = group.GetString("NavigationStyle", "Gui::CADNavigationStyle")
    style = _STYLES.get(name.replace("Gui::", "").replace("NavigationStyle", ""), _STYLES["CAD"])
    return next((what for b, m, what in style if buttons == b and modifiers == m), None)
