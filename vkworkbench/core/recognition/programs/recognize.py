# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise the machining strategy of a toolpath, with the evidence in the paper's terms."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.turned import is_turned
from vkworkbench.core.recognition.programs.parts import (
    Sections,
    dividing_retracts,
    find_borders,
    is_titled,
    recognize_parts,
    without_lone_plunge,
)
from vkworkbench.core.recognition.programs.visits import find_retracts
from vkworkbench.core.recognition.thresholds import PARTS
from vkworkbench.core.recognition.verdict.operation import recognize_one, unknown
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.toolpath import Toolpath, check_toolpath
from vkworkbench.given import number
from vkworkbench.language import Message


def recognize(toolpath: Toolpath, *, tool_diameter: float | None = None, program: bool = False) -> Recognition:
    """Recognise the machining strategy of an operation (paper, section 3; docs/recognition.md).

    Parameters
    ----------
    toolpath : Toolpath
        The linearised trajectories.
    tool_diameter : float, optional
        Tool diameter, mm. If unknown (None, 0, NaN), the usual step between passes is used instead.
    program : bool
        Whether the toolpath can contain several operations that only retracts separate, like an imported NC program.
        Pass False for a single operation, which also contains retracts.

    Returns
    -------
    Recognition
        Strategy.EMPTY if nothing cuts, Strategy.UNKNOWN if a problem of the toolpath hides cuts. An argument that is
        not a Toolpath raises an exception.

    Raises
    ------
    TypeError
        If `toolpath` is not a Toolpath (for example, a list of commands), or if the diameter has no numeric type.
    ValueError
        If the diameter is a text that is not a number.
    """
    check_toolpath(toolpath)
    rapid = toolpath.rapid
    if rapid.all():
        return Recognition(Strategy.EMPTY, 1.0, Message("only-rapids") if len(toolpath) else Message("no-moves"))
    if toolpath.hidden_cuts:
        return unknown(toolpath, toolpath.hidden_cuts.remark)
    if is_turned(toolpath):
        return unknown(toolpath, Message("like-a-lathe", strategy=Strategy.UNKNOWN))
    tool = number("tool_diameter", tool_diameter or 0.0, "a number of mm, or None")
    tool = tool if 0 < tool < np.inf else 0.0
    moves = without_lone_plunge(toolpath, monotonous_areas(toolpath))
    first, last = int(np.argmin(rapid)), len(rapid) - 1 - int(np.argmin(rapid[::-1]))
    whole = recognize_one(toolpath, moves, first, last, tool)
    borders, sections = find_borders(toolpath, moves), Sections(toolpath, tool)
    if program and len(borders) <= PARTS.BORDERS and not is_titled(toolpath, first):
        retracts = dividing_retracts(sections, borders, find_retracts(toolpath, moves))
        borders.update(dict.fromkeys(retracts, True))
    if not 0 < len(borders) <= PARTS.BORDERS:
        return whole
    return recognize_parts(sections, borders, whole, program)
