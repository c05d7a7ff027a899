# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict on moves that are not the tool's way through the part."""

from __future__ import annotations

from vkworkbench.core.recognition.verdict.operation import spans_of
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message


def unknown(toolpath: Toolpath, why: Message) -> Recognition:
    """Return that a toolpath's strategy is unknown, with the reason; it has at least one trajectory."""
    spans = spans_of(toolpath, [(0, len(toolpath) - 1, Strategy.UNKNOWN)])
    return Recognition(Strategy.UNKNOWN, 0.0, why, spans)
