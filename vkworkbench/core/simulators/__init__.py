# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predict the cost of a simulation in the paper's extended z-buffer and in FreeCAD's own simulators.

A `Task` is the toolpath of one operation with its tool and stock. `Conditions` are the version of FreeCAD, the speed of
the computer and the settings. From a `Task` and its `Conditions`, the entries of the table `SIMULATORS` compute the
`Cost` of one operation or of several operations in sequence, and the finest setting within a budget. A `Caution` is a
warning before a simulation is started.
"""

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.costs import Costs
from vkworkbench.core.simulators.kept import as_data as cost_as_data
from vkworkbench.core.simulators.kept import from_data as cost_from_data
from vkworkbench.core.simulators.legacy import LegacyCost, legacy_cost, legacy_together
from vkworkbench.core.simulators.opengl import OpenGLCost, opengl_cost, opengl_speeds, opengl_together, slow_frames
from vkworkbench.core.simulators.preflight import preflight
from vkworkbench.core.simulators.simulator import Caution, Conditions, Cost, Simulator, Task
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER, available, predict, together

__all__ = [
    "DEFAULTS", "LEGACY", "OPENGL", "SIMULATORS", "ZBUFFER",
    "Caution", "Conditions", "Constants", "Cost", "Costs", "LegacyCost", "OpenGLCost", "Simulator", "Task",
    "available", "cost_as_data", "cost_from_data", "legacy_cost", "legacy_together", "opengl_cost",
    "opengl_speeds", "opengl_together", "predict", "preflight", "slow_frames", "together",
]  # fmt: skip
