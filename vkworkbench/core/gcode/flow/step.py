# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the effects of a macro statement: the words that are left in its line, and the program line that follows."""

from __future__ import annotations

from typing import NamedTuple

from vkworkbench.core.gcode.flow.variables import Frame


class Call(NamedTuple):
    """A call of a subprogram in the same text.

    Attributes
    ----------
    first, end : int
        Indices of the subprogram's first line, and of the line after the subprogram's last line.
    times : int
        Number of times that the subprogram runs.
    frame : Frame or None
        Local variables of the subprogram; None if the subprogram uses the variables of its caller.
    """

    first: int
    end: int
    times: int = 1
    frame: Frame | None = None


class Step(NamedTuple):
    """The effects of a macro statement in a program line.

    Attributes
    ----------
    code : str
        The program line with numbers in place of variables and expressions; empty if no words are left.
    to : int or None
        Index of the line at which the program continues; None for the next line.
    call : Call or None
        The subprogram that the line calls.
    returns : bool
        Whether the line ends the current subprogram.
    """

    code: str = ""
    to: int | None = None
    call: Call | None = None
    returns: bool = False
