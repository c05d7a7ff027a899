# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise a toolpath in inches that was read as millimetres, at its true size, because thresholds are in mm."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from vkworkbench.core.gcode import INCH
from vkworkbench.core.recognition.programs.recognize import recognize
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message


def recognize_inches(toolpath: Toolpath, *, tool_diameter: float | None = None, program: bool = False) -> Recognition:
    """Recognise a toolpath of inches that were read as millimetres.

    Parameters
    ----------
    toolpath : Toolpath
        The toolpath as it was read.
    tool_diameter : float, optional
        True diameter of the tool, mm.
    program : bool
        See `recognize`.

    Returns
    -------
    Recognition
        The result for the toolpath at 25.4 times its size. All lengths in the result are in the unit of the toolpath as
        it was read.
    """
    found = recognize(replace(toolpath, points=INCH * toolpath.points), tool_diameter=tool_diameter, program=program)
    paper = found.paper and replace(found.paper, v=(found.paper.v[0] / INCH, found.paper.v[1] / INCH))
    stepover = found.stepover and found.stepover / INCH
    return replace(found, why=_as_read(found.why), stepover=stepover, paper=paper)


def _as_read(value: Any) -> Any:
    """Return a message in which the stepover is converted to the unit of the toolpath as it was read."""
    if isinstance(value, tuple):
        return tuple(map(_as_read, value))
    if not isinstance(value, Message):
        return value
    given: dict[str, Any] = value.arguments
    arguments = {
        name: one / INCH if name == "step" and one is not None else _as_read(one) for name, one in given.items()
    }
    return type(value)(value.code, **arguments)
