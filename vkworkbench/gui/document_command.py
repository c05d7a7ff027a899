# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD asks of a command that does something with the active document."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui


class DocumentCommand:
    """A command in menus and toolbars, with an icon of its name; offered while a document is open.

    Attributes
    ----------
    name : str
    menu, tooltip : str
        What FreeCAD translates, in the context of the name.
    keys : str
        Its shortcut, empty without one.
    """

    name: str
    menu: str
    tooltip: str
    keys = ""

    def GetResources(self) -> dict:
        texts = {"MenuText": self.menu, "ToolTip": self.tooltip, "WhatsThis": self.tooltip}
        return {**texts, "Pixmap": self.name, **({"Accel": self.keys} if self.keys else {})}

    def IsActive(self) -> bool:
        return FreeCAD.ActiveDocument is not None

    @classmethod
    def add(cls) -> None:
        """Add it to FreeCAD's commands."""
        Gui.addCommand(cls.name, cls())
