# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user selected that has toolpaths. Loads no numpy: the context menus ask it."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.document.operations import is_job_group, is_operation, kind


def selected_operations() -> list:
    """Return the selected jobs, groups of a job's operations, and operations."""
    return [obj for obj in Gui.Selection.getSelection() if _has_operations(obj)]


def _has_operations(obj) -> bool:
    return kind(obj) in ("job", "group") or is_operation(obj) or is_job_group(obj)
