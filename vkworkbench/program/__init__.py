# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs from files, without FreeCAD: standard library and numpy only.

In: files and folders, as a macro or the command line names them.
Out: `Report`, one row for each operation of each program; `main`, the command ``python3 -m vkworkbench``.
"""

from vkworkbench.program.analysis import analyze, is_path
from vkworkbench.program.command_line import main

__all__ = ["analyze", "is_path", "main"]
