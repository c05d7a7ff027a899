# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle the G-codes for units, planes, feed modes and tool length offsets."""

from __future__ import annotations

from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import NO_LENGTH, Handler, Machine
from vkworkbench.core.gcode.interpreter.state.modes import GROUPS
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_LATHE_CYCLE = frozenset("PQUWR")  # with a P, Q, U, W or R word, G70 to G72 are turning cycles, not units
_OF_RS274 = (200, 210)
_HOLE_PATTERN = frozenset("IJKL")  # with an I, J, K or L word, G70 to G72 are patterns of holes (Haas, Yasnac)


def _state(machine: Machine, line: Line) -> None:
    """Process a modal G-code that `linearize` needs, for example G17 or G91, and add it to the commands."""
    code = line.code
    if code in GROUPS:
        setattr(machine.modes, GROUPS[code], code)
    if code == codes.CANCEL:
        machine.motion = machine.written = code
    elif code == 180:
        machine.clues.g_code(18, set(), machine.number)
    machine.add(codes.name_of(code), {})


def _unit(machine: Machine, line: Line) -> None:
    before = machine.modes.feed_unit
    machine.measure_in(line.code)
    changes = machine.moved and machine.modes.feed_unit != before and "F" in line.letters
    if changes and line.code in _OF_RS274 and not machine.is_fanuc():
        line.feed_factor = before / machine.modes.feed_unit
        machine.problem(Message("feed-in-old-unit", name=codes.name_of(line.code)))


def _pattern(machine: Machine, line: Line) -> None:
    """Process G70 to G72: turning cycles, patterns of holes, or units."""
    name = codes.name_of(line.code)
    if line.letters.isdisjoint(_LATHE_CYCLE) and not line.letters.isdisjoint(_HOLE_PATTERN):
        line.feeds = False
        machine.leave_out(line, Message("hole-pattern-not-read", name=name))
    # On Okuma controls, G71 with a Z word sets the return level of canned cycles.
    elif line.code == 710 and sorted(letter for letter, _ in line.words if letter != "N") == ["G", "Z"]:
        machine.leave_out(line, Message("unknown-code", name=repr(name)))
    elif line.code in codes.UNITS and line.letters.isdisjoint(_LATHE_CYCLE):
        machine.measure_in(line.code)
    else:
        machine.other(line)


def _feed_mode(machine: Machine, line: Line) -> None:
    machine.modes.feed_mode, machine.modes.per_turn = line.code, None


def _tool_length(machine: Machine, line: Line) -> None:
    words = dict(line.words)
    number = words.get("Z" if line.code == 431 else "H", machine.spindle_tool)
    length = NO_LENGTH if line.code == 490 or number == 0 else (line.code, number)
    if length != machine.tool_length:
        machine.tool_length, machine.length_changed = length, machine.moved
    if line.code == 431 and "H" not in line.letters and codes.MOTION_WORDS.isdisjoint(line.words):
        line.apart = True  # the Z word is the tool's length, not the target of a move
    machine.other(line)


HANDLERS: dict[int, Handler] = {
    **dict.fromkeys(codes.KEPT, _state),
    **dict.fromkeys(codes.UNITS, _unit),
    **dict.fromkeys(codes.PATTERNS, _pattern),
    **dict.fromkeys(codes.FEED_MODES, _feed_mode),
    **dict.fromkeys(codes.TOOL_LENGTH, _tool_length),
}
