# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper, numpy only: from commands to trajectories, signature, strategy and cost."""

from vkworkbench.core.linearize import linearize
from vkworkbench.core.signature import Signature, signature
from vkworkbench.core.toolpath import Problem, Toolpath

__all__ = ["Problem", "Signature", "Toolpath", "linearize", "signature"]
