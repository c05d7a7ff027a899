# SPDX-License-Identifier: LGPL-2.1-or-later
"""The depth to which an operation may cut into the model, as engraving, V-carving and deburring do on purpose."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import numpy as np

from vkworkbench import freecad
from vkworkbench.core import Cut, Strategy, Tool
from vkworkbench.document.job.operations import all_bases
from vkworkbench.document.job.recognition import recognize_operation
from vkworkbench.document.simulation.job import SimulatedOperation
from vkworkbench.language import Message

_ENGRAVING, _DEBURRING = ("Engrave", "Vcarve"), "Deburr"
# An imported engraving has no property with its depth. Therefore the allowed depth is computed from the cuts: this
# share of the cutting length is not deeper. With a lower share, the deepest intended strokes are reported as gouges.
# With a higher share, a single stroke that is too deep is not reported.
_NOT_DEEPER = 0.9


def allowed_depth(obj, tool: Tool | None, simplified: Message | None) -> float:
    """Return how deep an operation may cut into the model, mm; infinite if an end mill is simulated for its tool.

    `simplified` is the remark that a simpler shape is simulated instead of the tool, if any.
    """
    if tool is None:
        return 0.0
    # The end mill that is simulated instead of an undercutting tool is larger, and also cuts where the tool does not.
    if simplified is not None and "as-end-mill" in simplified.codes:
        return inf
    for one in (obj, *all_bases(obj)):
        name = freecad.operation_name(one)
        if name in _ENGRAVING:
            start, final = freecad.START_DEPTH.number(one), freecad.FINAL_DEPTH.number(one)
            return max(0.0, start - final) if start is not None and final is not None else 0.0
        if name == _DEBURRING:
            width, extra = freecad.DEBURRED_WIDTH.number(one) or 0.0, freecad.EXTRA_DEPTH.number(one) or 0.0
            return max(0.0, width * tool.steepness + extra)
    return 0.0


def with_stroke_depth(operation: SimulatedOperation, cut: Cut, top: float) -> Cut:
    """Return the cut (toolpath and tool) of an operation, with an allowed depth if it is an imported engraving.

    An imported engraving may cut to the depth of its strokes below `top`, the height of the engraved surface, mm.
    """
    if not operation.imported or cut.allowed_depth:
        return cut
    found, _ = recognize_operation(cut.toolpath, cut.tool.diameter, True)
    if found.strategy is not Strategy.ENGRAVING:
        return cut
    points, feeds = cut.toolpath.points, ~cut.toolpath.rapid
    length = np.hypot(*np.diff(points[:, :2], axis=0).T)[feeds]
    height = ((points[1:, 2] + points[:-1, 2]) / 2)[feeds]
    order = np.argsort(-height, kind="stable")
    deepest = np.searchsorted(np.cumsum(length[order]), _NOT_DEEPER * length.sum())
    return replace(cut, allowed_depth=max(0.0, float(top - height[order[min(deepest, len(order) - 1)]])))
