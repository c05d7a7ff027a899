# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of an NC program into commands, in mm and mm/s.

Input: the words of a line. Output: commands, and problems with their lines. `Interpreter` reads the lines; the
modules hold the handlers of G-codes by subject.
"""

from vkworkbench.core.gcode.interpreter.interpreter import Interpreter

__all__ = ["Interpreter"]
