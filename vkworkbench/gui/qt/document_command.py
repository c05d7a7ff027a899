# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base class of commands on the active document, and the selected operations. This module does not import numpy."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

from vkworkbench.document.job.operations import is_job_group, is_operation, kind


class DocumentCommand:
    """A command in menus and toolbars, which is enabled while a document is open."""

    name: str  # name of the command, of its icon, and of the context of its translations
    menu: str  # English text, which FreeCAD translates
    tooltip: str  # English text, which FreeCAD translates
    keys = ""  # keyboard shortcut; empty if there is no shortcut

    def GetResources(self) -> dict:
        texts = {"MenuText": self.menu, "ToolTip": self.tooltip, "WhatsThis": self.tooltip}
        return {**texts, "Pixmap": self.name, **({"Accel": self.keys} if self.keys else {})}

    def IsActive(self) -> bool:
        document = FreeCAD.ActiveDocument
        return document is not None and not document.Restoring

    @classmethod
    def add(cls) -> None:
        """Register the command in FreeCAD."""
        Gui.addCommand(cls.name, cls())


def selected_operations() -> list:
    """Return the selected jobs, groups of a job's operations, and operations."""
    return [obj for obj in Gui.Selection.getSelection() if _has_operations(obj)]


def _has_operations(obj) -> bool:
    return kind(obj) in ("job", "group") or is_operation(obj) or is_job_group(obj)
