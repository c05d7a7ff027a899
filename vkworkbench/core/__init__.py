# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's method with numpy only: commands, trajectories, signature, strategy and cost. These names are stable.

Other packages import each folder's public names from its ``__init__``, never from the files inside.
"""

from vkworkbench.core.gcode import linearize
from vkworkbench.core.machine import MACHINES, Machine, machine_of_grbl
from vkworkbench.core.machining import Machining, machining, trajectory_seconds
from vkworkbench.core.paper import Complexity, Signature, complexity, signature
from vkworkbench.core.recognition import Recognition, Span, recognize
from vkworkbench.core.solids import Stock, stock_around
from vkworkbench.core.steady import processor_clock, steady_seconds
from vkworkbench.core.stocks import Cylinder, Mesh, Solid
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import COORDINATE_LIMIT, Problem, Toolpath, exact_lengths
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer import (
    Cut,
    Estimate,
    Resolution,
    Speed,
    ZBuffer,
    best_resolution,
    cauchy_crofton,
    estimate,
    measure_speed,
    simulate,
    simulate_job,
)

__all__ = [
    "COORDINATE_LIMIT", "MACHINES", "Complexity", "Cut", "Cylinder", "Estimate", "Family", "Frame", "Machine", "Machining", "Mesh", "Problem",
    "Recognition", "Resolution", "Signature", "Solid", "Span", "Speed", "Stock", "Strategy", "Tool", "Toolpath",
    "View", "ZBuffer", "best_resolution", "cauchy_crofton", "complexity", "estimate", "exact_lengths", "linearize", "machine_of_grbl", "machining",
    "measure_speed", "processor_clock", "recognize", "signature", "simulate", "simulate_job", "steady_seconds",
    "stock_around", "trajectory_seconds",
]  # fmt: skip
