# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulating costs, simulator by simulator: the paper's extended z-buffer and FreeCAD's own, one entry each.

In: `Task`, one operation's toolpath with tool and stock; `Conditions`, the FreeCAD, the computer and the settings.
Out: the table `SIMULATORS`, each with its Cost of one operation or of several together, its advice for a budget and
what real runs teach it about the `Constants`; `Caution`, what to know before a simulation is started.
"""

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.costs import Costs
from vkworkbench.core.simulators.kept import as_data as cost_as_data
from vkworkbench.core.simulators.kept import from_data as cost_from_data
from vkworkbench.core.simulators.legacy import LegacyCost, legacy_cost, legacy_together
from vkworkbench.core.simulators.opengl import OpenGLCost, opengl_cost, opengl_speeds, opengl_together
from vkworkbench.core.simulators.preflight import preflight
from vkworkbench.core.simulators.simulator import Advice, Caution, Conditions, Cost, Simulator, Task
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER, available, predict, together

__all__ = [
    "DEFAULTS", "LEGACY", "OPENGL", "SIMULATORS", "ZBUFFER", "Advice",
    "Caution", "Conditions", "Constants", "Cost", "Costs", "LegacyCost", "OpenGLCost", "Simulator", "Task",
    "available", "cost_as_data", "cost_from_data", "legacy_cost", "legacy_together", "opengl_cost",
    "opengl_speeds", "opengl_together", "predict", "preflight", "together",
]  # fmt: skip
