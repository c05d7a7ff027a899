# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round or chamfer the corner between two straight moves in the XY plane (Fanuc's words ``,R`` and ``,C``).

The corner word is in the line of the first move. The second move is in a later line. When the second move is read, the
command of the first move is shortened. A corner word is reported as not read, unless its corner is cut.
"""

from __future__ import annotations

from cmath import phase
from math import pi, tan

from vkworkbench.core.gcode.interpreter.state.machine import Machine
from vkworkbench.core.gcode.interpreter.state.offset_path import Corner
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_SAME = 1e-6  # mm and rad; points or directions that differ by less are equal


def write(machine: Machine, mode: int, words: dict[str, float], move: dict[str, float]) -> None:
    """Cut the corner before a move, add the command of the move, and store the corner after the move.

    Parameters
    ----------
    machine : Machine
    mode : int
        The G-code of the move's motion, as ten times its number (10 for G1).
    words, move : dict
        The parameters of the move's line, and the words of the move in the coordinates of the toolpath, mm.
    """
    corner, machine.corner = machine.corner, None
    can_cut = mode == codes.FEED and machine.modes.plane == codes.XY_PLANE and machine.maps.scale is None
    can_cut &= not machine.seconds
    if corner is not None and corner.command == len(machine.commands) - 1 and can_cut:
        _cut(machine, corner, move)
    letters = [letter for letter in (",R", ",C") if letter in words]
    start = dict(machine.place.now()) if letters else {}
    machine.write(mode, move)
    if can_cut and len(letters) == 1 and words[letters[0]] >= 0 and {"X", "Y"} <= start.keys():
        end, size = machine.place.now(), machine.modes.unit * words[letters[0]]
        if start.get("Z") == end.get("Z"):
            ends = complex(start["X"], start["Y"]), complex(end["X"], end["Y"])
            machine.corner = Corner(letters[0], size, len(machine.commands) - 1, machine.number, *ends)


def _cut(machine: Machine, corner: Corner, move: dict[str, float]) -> None:
    """Cut a corner before a move. Relative words are changed, because the move begins where the arc or chamfer ends."""
    relative, here = machine.modes.relative, machine.place.now()
    rest = dict.fromkeys("XYZ", 0.0) if relative else here
    if not {"X", "Y"} <= here.keys() or move.get("Z") not in (None, rest.get("Z")):
        return
    first, second = corner.end - corner.start, complex(move.get("X", rest["X"]), move.get("Y", rest["Y"]))
    second -= 0.0 if relative else corner.end
    if min(abs(first), abs(second)) <= _SAME:
        return
    turn = phase(second / first)
    size = corner.size * (tan(abs(turn) / 2) if corner.letter == ",R" else 1.0)
    if abs(turn) > pi - _SAME or size > min(abs(first), abs(second)) + _SAME:
        return
    machine.problems[Message("word-not-read", letter=corner.letter)].remove(corner.line)
    if size <= _SAME:
        return
    before, after = -size * first / abs(first), size * second / abs(second)
    machine.move_end(corner.command, corner.end + before, before, relative=relative)
    end = after - before if relative else corner.end + after
    words, mode = {"X": end.real, "Y": end.imag}, codes.FEED
    if corner.letter == ",R" and abs(turn) > _SAME:
        words["R"], mode = corner.size, codes.COUNTER_CLOCKWISE if turn > 0 else codes.CLOCKWISE
    machine.write(mode, words)
    if relative:
        move["X"], move["Y"] = (second - after).real, (second - after).imag
