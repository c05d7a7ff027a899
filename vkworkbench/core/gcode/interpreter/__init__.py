# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of an NC program into commands, in mm and mm/s.

`Interpreter` reads the words of each program line, and stores commands and problems with the number of their line. Each
module contains the handlers for the G-codes of one subject, for example units.
"""

from vkworkbench.core.gcode.interpreter.interpreter import Interpreter

__all__ = ["Interpreter"]
