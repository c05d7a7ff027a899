# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert commands and NC programs into toolpaths.

`linearize` converts a list of commands into a `Toolpath`, which contains straight trajectories, the command of each
trajectory, and the problems found. The commands are ``(name, parameters)`` pairs or FreeCAD's objects, in mm and mm/s.
`Words` converts a list of commands into arrays, with a column for each letter, for code that needs words which a
`Toolpath` does not contain.

`read_program` converts the text of an NC program into commands. `split_sections` finds the operations and the tools of
a program, and `title_of` separates titles of operations from other comments. `looks_like_inches` returns whether inches
were probably read as millimetres. `looks_like_increments` returns whether thousandths of a millimetre were probably
read as millimetres. `in_seconds` corrects feed rates in mm/min that were read as mm/s.
"""

from vkworkbench.core.gcode.blocks import split_comments, split_words
from vkworkbench.core.gcode.comments.sections import Section, split_sections
from vkworkbench.core.gcode.comments.titles import title_of
from vkworkbench.core.gcode.comments.tool_table import tells_inches
from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.moves.codes import ARCS, OFFSETS
from vkworkbench.core.gcode.moves.linearize import linearize
from vkworkbench.core.gcode.moves.program import Program
from vkworkbench.core.gcode.moves.units import DOUBTFUL, INCH, in_seconds, looks_like_inches, looks_like_increments
from vkworkbench.core.gcode.moves.words import Words, used_up
from vkworkbench.core.gcode.reader import read_program

__all__ = [
    "ARCS", "DOUBTFUL", "INCH", "OFFSETS", "Program", "Section", "Words", "at_line", "in_seconds", "linearize",
    "looks_like_inches", "looks_like_increments", "read_program", "split_comments", "split_sections", "split_words", "tells_inches", "title_of", "used_up",
]  # fmt: skip
