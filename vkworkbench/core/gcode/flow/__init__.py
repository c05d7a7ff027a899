# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calculate expressions, and follow the loops, conditions and calls of an NC program.

The input is the lines of a program's text. `Flow.step` performs the macro statement of a program line. `Flow.step`
returns the line with numbers in place of variables and expressions, and the index of the next line. `Subprograms` finds
programs and blocks by their numbers. `arguments` returns the variables that a macro call sets. The exception `Ended`
contains the reason why the rest of a program cannot be followed.
"""

from vkworkbench.core.gcode.flow.ended import Ended
from vkworkbench.core.gcode.flow.fanuc import arguments
from vkworkbench.core.gcode.flow.flow import Flow
from vkworkbench.core.gcode.flow.step import Call, Step
from vkworkbench.core.gcode.flow.subprograms import PROGRAM_NUMBER, Subprograms, calls_block

__all__ = ["PROGRAM_NUMBER", "Call", "Ended", "Flow", "Step", "Subprograms", "arguments", "calls_block"]
