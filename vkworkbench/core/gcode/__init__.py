# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands become a toolpath.

In: commands, as ``(name, parameters)`` pairs or FreeCAD's objects, in mm and mm/s.
Out: `Toolpath`, straight trajectories with their source commands, and the problems met on the way.
`Words` is the same commands as columns, for who needs a word that no trajectory tells.
"""

from vkworkbench.core.gcode.linearize import MOST_TRAJECTORIES, linearize
from vkworkbench.core.gcode.words import Words

__all__ = ["MOST_TRAJECTORIES", "Words", "linearize"]
