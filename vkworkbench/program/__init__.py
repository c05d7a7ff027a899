# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis and simulation of NC programs in files, with numpy and the standard library, but without FreeCAD.

Input: paths of files and folders, from a macro or the command line. Output: `Report`, with one row for each operation
of each program; `ProgramSimulation`, the result of `simulate`; `main`, the command ``python3 -m vkworkbench``.
"""

from vkworkbench.program.analysis import analyze, is_path
from vkworkbench.program.command_line import main
from vkworkbench.program.simulation import ProgramSimulation, simulate

__all__ = ["ProgramSimulation", "analyze", "is_path", "main", "simulate"]
