# SPDX-License-Identifier: LGPL-2.1-or-later
"""Process M-codes: stops, calls, returns, and codes that save and restore the modal state."""

from __future__ import annotations

from dataclasses import replace

from vkworkbench.core.gcode.flow import calls_block
from vkworkbench.core.gcode.interpreter.offsets import select
from vkworkbench.core.gcode.interpreter.state.machine import Machine
from vkworkbench.core.gcode.interpreter.state.modes import Modes
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_OUTPUTS = frozenset([67, 68])  # LinuxCNC's M-codes for analog outputs, for example to a laser, with E and Q words.
_SETTINGS = frozenset([92, 201, 203, 204, 205, 206])  # Marlin's M-codes for steps/mm, speeds and accelerations.
_OTHERS_M_CODE = 1000  # Smallest number of M-codes that vendors define, for example Snapmaker's M2000.
_ORIENT = 19  # M19 turns the spindle to the angle in its R word.
_SPINDLE = frozenset([3, 4, 5])
_RETURN_OF_SIEMENS = 17  # In a main program, M17 ends the program like M30.
# M-codes at which the operator or the tool changer can move the tool.
_STOPS = frozenset([0, 1, 6, 60, 600])
# LinuxCNC's M-codes that save, discard and restore the modal state.
_SAVE, _FORGET, _RESTORE, _SAVE_FOR_CALL = 70, 71, 72, 73


def process(machine: Machine, value: float, letters: set[str]) -> bool:
    """Process an M-code; return whether it ends the program or subprogram at once (M99)."""
    machine.clues.m_code(value, letters, machine.number)
    if value in _STOPS and machine.moved:
        machine.stop()
        machine.place.lose("XYZ")
    elif value in (_SAVE, _FORGET, _SAVE_FOR_CALL):
        machine.saved[-1] = None if value == _FORGET else replace(machine.modes), value == _SAVE_FOR_CALL
    elif (
        value == _RETURN_OF_SIEMENS and machine.moved and len(machine.saved) == 1
    ):  # before the first move: Marlin's M17
        machine.ended = True
    elif value == _RESTORE:
        restore(machine, machine.saved[-1][0])
    if not machine.dialect.calls:
        return False
    if value == 98 or (value in (97, 198) and "P" in letters):
        machine.call = value
        machine.calls_blocks |= calls_block(value, letters)
    if value == 99 and (machine.deleted or "P" in letters):
        machine.problem(Message("jumps-not-followed"))
        return False
    return value == 99


def restore(machine: Machine, saved: Modes | None) -> None:
    """Restore a saved modal state: add commands for the codes and the feed rate that differ from the current state."""
    if saved is None:
        return
    for group in ("plane", "distance", "centres", "retract"):
        code = getattr(saved, group)
        if code != getattr(machine.modes, group):
            machine.add(codes.name_of(code), {})
    if saved.feed not in (None, machine.modes.feed):
        machine.add("G94", {"F": saved.feed})
    offset = machine.modes.offset
    machine.modes = replace(saved)
    machine.modes.offset = offset
    select(machine, saved.offset)


def words_of(m_code: float, letters: set[str], *, first: bool) -> frozenset[str]:
    """Return the letters of the words that are parameters of an M-code, not of a move or a feed rate.

    An M-code for a setting of Marlin, or an M-code of a vendor, has parameters only if no G-code and no parameter
    precedes the M-code in the line (`first`). For example, in G1 X5 M203, X5 is the target of the move.
    """
    if m_code in _OUTPUTS:
        return frozenset("EQ")
    if m_code == _ORIENT or (m_code in _SPINDLE and letters.isdisjoint("XYZ")):
        return frozenset("PQR")  # R is the angle of the spindle here, not the R plane of a canned cycle
    if first and (m_code in _SETTINGS or m_code >= _OTHERS_M_CODE):
        return frozenset("ABCEFIJKPQRTUVWXYZ")
    return frozenset()
