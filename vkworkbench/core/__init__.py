# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper, numpy only: from commands to trajectories, signature, strategy and cost."""

from vkworkbench.core.linearize import linearize
from vkworkbench.core.machining import Machining, machining
from vkworkbench.core.recognition import Recognition, Span, recognize
from vkworkbench.core.resolution import Accuracy, Resolution, best_accuracy, best_resolution
from vkworkbench.core.resources import Estimate, Speed, estimate
from vkworkbench.core.signature import Signature, signature
from vkworkbench.core.solids import ConvexStock, Stock, Tool, View
from vkworkbench.core.speed import measure_speed
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.toolpath import Problem, Toolpath
from vkworkbench.core.zbuffer import ZBuffer, simulate

__all__ = [
    "Accuracy", "ConvexStock", "Estimate", "Machining", "Problem", "Recognition", "Resolution", "Signature",
    "Span", "Speed", "Stock", "Strategy", "Tool", "Toolpath", "View", "ZBuffer", "best_accuracy",
    "best_resolution", "estimate", "linearize", "machining", "measure_speed", "recognize", "signature",
    "simulate",
]  # fmt: skip
