# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's own simulators will cost, and what goes wrong in them.

In: `Toolpath`, tool, stock, and `Constants`, what a unit of their work takes on one computer.
Out: `LegacyCost` and `OpenGLCost` of one operation or of several together; `Accuracy`, the finest that a budget
allows; `Caution`, what to know before they are started; what real runs teach about the constants.
"""

from vkworkbench.core.simulators.accuracy import Accuracy, best_accuracy
from vkworkbench.core.simulators.constants import DEFAULTS, Constants, Simulator, available_simulators, opengl_speeds
from vkworkbench.core.simulators.legacy import SLIDER, LegacyCost, legacy_costs, legacy_together, legacy_work
from vkworkbench.core.simulators.legacy_panel import fit_fast_forward, fit_play
from vkworkbench.core.simulators.motions import motions
from vkworkbench.core.simulators.opengl import OpenGLCost, opengl_cost, opengl_together
from vkworkbench.core.simulators.preflight import Caution, preflight

__all__ = [
    "DEFAULTS", "SLIDER", "Accuracy", "Caution", "Constants", "LegacyCost", "OpenGLCost", "Simulator",
    "available_simulators", "best_accuracy", "fit_fast_forward", "fit_play", "legacy_costs", "legacy_together",
    "legacy_work", "motions", "opengl_cost", "opengl_speeds", "opengl_together", "preflight",
]  # fmt: skip
