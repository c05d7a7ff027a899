# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper, numpy only: from commands to trajectories, signature, strategy and cost."""

from vkworkbench.core.linearize import linearize
from vkworkbench.core.machining import Machining, machining
from vkworkbench.core.signature import Signature, signature
from vkworkbench.core.solids import Stock, Tool, View
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.toolpath import Problem, Toolpath

__all__ = [
    "Machining", "Problem", "Signature", "Stock", "Strategy", "Tool", "Toolpath", "View", "linearize", "machining",
    "signature",
]  # fmt: skip
