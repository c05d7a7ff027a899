# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise which strategy a toolpath follows.

The input is a `Toolpath` and, if known, the tool's diameter. The output is a `Recognition`: the strategy with its
confidence, its reason, the numbers that support the strategy, and, if the toolpath contains several strategies, its
parts with one strategy each.
"""

from vkworkbench.core.recognition.patterns.turned import is_turned
from vkworkbench.core.recognition.programs.inches import recognize_inches
from vkworkbench.core.recognition.programs.recognize import recognize
from vkworkbench.core.recognition.verdict.operation import unknown
from vkworkbench.core.recognition.verdict.recognition import Recognition, Span

__all__ = ["Recognition", "Span", "is_turned", "recognize", "recognize_inches", "unknown"]
