# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper, numpy only: from commands to trajectories, signature, strategy and cost."""

from vkworkbench.core.linearize import linearize
from vkworkbench.core.machining import Machining, machining
from vkworkbench.core.recognition import Recognition, Span, recognize
from vkworkbench.core.resources import Estimate, estimate
from vkworkbench.core.signature import Signature, signature
from vkworkbench.core.solids import Stock, Tool, View
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.toolpath import Problem, Toolpath
from vkworkbench.core.zbuffer import ZBuffer, simulate

__all__ = [
    "Estimate", "Machining", "Problem", "Recognition", "Signature", "Span", "Stock", "Strategy", "Tool", "Toolpath",
    "View", "ZBuffer", "estimate", "linearize", "machining", "recognize", "signature", "simulate",
]  # fmt: skip
