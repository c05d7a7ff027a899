# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of canned cycles from the form of each dialect to the form that `linearize` reads."""

from __future__ import annotations

from vkworkbench.core.gcode.blocks import whole
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_MOST_REPEATS = 10_000
_FINE_BORING = 760
_SHIFT = frozenset("IJQ")  # G76's shift of the tool at the bottom, whose direction can be a setting of the control


def _fine_boring(machine: Machine, line: Line) -> None:
    """Process G76: fine boring, which is read as G86 without the shift at the bottom. A G76 with the words of a lathe's threading cycle is not read."""
    if "R" in line.letters and ("Y" in line.letters or "P" not in line.letters):
        line.motion = codes.BORING
        for letter in sorted(line.letters & _SHIFT):
            machine.problem(Message("word-not-read", letter=letter))
    else:
        machine.other(line)


def leave_holes(machine: Machine, mode: int) -> None:
    """Select Fanuc's return from a cycle that retracts at feed: at feed to the R plane, then at rapid to the start."""
    if mode in codes.FEED_OUT and machine.modes.retract == codes.TO_START and machine.is_fanuc():
        machine.modes.retract = codes.RAPID_TO_START
        machine.add(codes.name_of(codes.RAPID_TO_START), {})


def repeats_of(machine: Machine, mode: int, parameters: dict[str, float], move: dict[str, float]) -> int:
    """Return the number of repeats of a canned cycle, and change `move` to the words that `linearize` reads."""
    move.pop("K", None)
    if "Q" in move:
        move["Q"] = abs(move["Q"])  # Fanuc controls ignore the sign of Q
        if mode in codes.TAPPING:
            machine.problem(Message("word-not-read", letter="Q"))
    pecks = [letter for letter in "IJK" if letter in parameters]
    repeats = parameters.get("L", parameters.get("K", 1.0))
    drills_once = mode not in (*codes.PECKING, codes.BORING)
    if drills_once and {"Z", "I"} <= move.keys() and "R" not in move:
        # On Fagor controls, Z is the level of the reference plane (R in other dialects), I is the depth, and K is a
        # dwell.
        move["R"], move["Z"] = move["Z"], move.pop("I")
        if "K" in parameters:
            machine.problem(Message("dwell-untimed"))
        repeats = parameters.get("L", 1.0)
    elif mode in codes.PECKING and ("I" in pecks or "J" in pecks or parameters.get("K", 1.0) % 1):
        # On Haas and Yasnac controls, I is the first peck, J reduces each further peck, and K is the smallest peck.
        if "I" in pecks and "Q" not in move:
            move["Q"] = move["I"]
            pecks.remove("I")
        for one in pecks:
            machine.problem(Message("word-not-read", letter=one))
        repeats = parameters.get("L", 1.0)
    elif mode in codes.PECKING and "L" not in parameters and repeats > 1 and not machine.modes.relative:
        # On Haas controls, K is a depth. On Fanuc controls, K is the number of repeats, here in the same hole.
        machine.problem(Message("word-not-read", letter="K"))
        repeats = 1.0
    elif drills_once:
        for one in sorted({"I", "J"} & parameters.keys()):
            machine.problem(Message("word-not-read", letter=one))
    return _limited(machine, repeats)


def _limited(machine: Machine, repeats: float) -> int:
    """Return the number of repeats of a canned cycle, limited to `_MOST_REPEATS`."""
    if repeats > _MOST_REPEATS:
        machine.problem(Message("repeats-limited", most=_MOST_REPEATS))
    return whole(repeats, _MOST_REPEATS)


HANDLERS: dict[int, Handler] = {_FINE_BORING: _fine_boring}
