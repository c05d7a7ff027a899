# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calculate expressions, and follow the loops, conditions and calls of an NC program.

Input: the lines of a program. Output: a line with numbers in place of its variables and expressions, and the line that
follows it. `Flow` performs the macro statements of a line; `Subprograms` finds programs and blocks by their numbers.
`arguments` are the variables that a macro call sets. `Ended` says why the rest of a program cannot be followed.
"""

from vkworkbench.core.gcode.flow.ended import Ended
from vkworkbench.core.gcode.flow.fanuc import arguments
from vkworkbench.core.gcode.flow.flow import Flow
from vkworkbench.core.gcode.flow.step import Call, Step
from vkworkbench.core.gcode.flow.subprograms import PROGRAM_NUMBER, Subprograms, calls_block

__all__ = ["PROGRAM_NUMBER", "Call", "Ended", "Flow", "Step", "Subprograms", "arguments", "calls_block"]
