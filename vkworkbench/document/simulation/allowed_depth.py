# SPDX-License-Identifier: LGPL-2.1-or-later
"""The depth to which an operation is meant to cut into the model, as engraving, V-carving and deburring do."""

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
# An imported engraving has no property with its depth. Its depth is the depth that this share of its cutting length
# does not exceed. With a smaller share, the deepest strokes are gouges. With a larger share, one stroke that is too
# deep is not a gouge.
_NOT_DEEPER = 0.9


def allowed_depth(obj, tool: Tool | None, simplified: Message | None) -> float:
    """Return the intended depth of an operation's cut into the model, mm; infinite if an end mill replaces its tool.

    Parameters
    ----------
    obj : DocumentObject
    simplified : Message or None
        The remark that the tool is simulated by a simpler shape.
    """
    if tool is None:
        return 0.0
    # An end mill replaces an undercutting tool and is larger, so it also cuts where the real tool does not.
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
    """Return a cut; for an imported engraving, with the depth of its strokes below `top`, mm."""
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
