# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle the G-codes of work offsets, shifts of the coordinates and machine positions."""

from __future__ import annotations

from math import nan

from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.interpreter.state.origins import NUMBERED
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

# L words of G10 that set a tool's radius: in LinuxCNC's tool table (L1), and in Fanuc's geometry and wear offsets (L12,
# L13), to which a G10 under G91 adds its R word.
_RADII, _RADII_OF_FANUC = (1.0, 12.0, 13.0), (12.0, 13.0)
# Work offsets with a P word, and the codes of the offsets that they select: Fanuc's G54 P1 is G54.1 P1; Mach3 has G59 P7.
_WITH_P = {540: codes.MORE_OFFSETS, 590: 590}
# Codes whose line can contain the P word of a work offset. If a line has a code that is not in this set, the P word can
# belong to that code.
_WITHOUT_P = frozenset([
    *(("G", float(code)) for code in (0, 1, 17, 18, 19, 20, 21, 40, 43, 49, 54, 59, 80, 90, 91, 94, 98, 99)),
    *(("M", float(code)) for code in (3, 4, 5, 8, 9)),
])  # fmt: skip


def select(machine: Machine, offset: tuple[int, float]) -> None:
    """Select a work offset; report the work offset if the program does not contain the offset's origin."""
    if offset == machine.modes.offset:
        return
    machine.modes.offset = offset
    if not machine.moved:
        machine.origins.system = offset
    elif not machine.origins.select(offset):
        machine.problem(Message("coordinates-not-changed", name=codes.name_of(offset[0])))


def _offset(machine: Machine, line: Line) -> tuple[int, float] | None:
    """Return the work offset that a G-code selects, or None: ten times the G-code, and the number of the work offset.

    The number is the P word of G54.1, G154 and Fanuc's G54, the H word of Okuma's G15, and 0 for other G-codes.
    """
    code, words = line.code, dict(line.words)
    if machine.okuma:
        return (code, words.get("H", 0.0)) if code == codes.OKUMA_OFFSET else None
    if code not in codes.OFFSETS:
        return None
    if code in _WITH_P and "P" in words and machine.motion not in codes.CYCLES:
        numbered = _WITHOUT_P.issuperset(word for word in line.words if word[0] in "GM")
        return (_WITH_P[code] if numbered else code), words["P"] if numbered else 0.0
    return code, words.get("P", 0.0) if code in codes.NUMBERED_OFFSETS else 0.0


def _work_offset(machine: Machine, line: Line) -> None:
    # In a line with G43, the H word is the number of a tool length offset, not of a work offset.
    if line.code == codes.OKUMA_OFFSET and "H" in line.letters and ("G", 43.0) not in line.words:
        machine.okuma = True
    if line.code == codes.OKUMA_OFFSET:
        machine.polar = False
    offset = _offset(machine, line)
    if offset is not None:
        select(machine, offset)


def _shift(machine: Machine, line: Line) -> None:
    """Process G52, G92, G92.1, G92.2 and G92.3."""
    values = line.lengths(machine.modes.unit)
    line.apart |= line.code in (codes.LOCAL, codes.POSITION)
    if machine.maps.fixes_origin or (values and not line.apart and machine.is_fanuc()):
        _coordinates(machine, line)  # on Fanuc controls, G92.1 resets only the axes in its line
    elif line.code == codes.LOCAL:
        machine.origins.shift_by(values)
        if not values:
            _coordinates(machine, line)
    elif line.code == codes.POSITION:
        _name_place(machine, values)
    elif line.code in (codes.END_SHIFT, codes.SUSPEND_SHIFT):
        machine.origins.end_shift(keep=line.code == codes.SUSPEND_SHIFT)
    elif line.code == codes.RESUME_SHIFT:
        machine.origins.resume_shift()


def _name_place(machine: Machine, values: dict[str, float]) -> None:
    """Shift the coordinates so that the tool's position has the coordinates `values` (G92).

    The coordinates along an axis are shifted only if the tool's position along the axis is known. The position is
    unknown before the first move along the axis, and after a move to a position that is not in the program.
    """
    place = machine.here()
    if not machine.place.lost.isdisjoint(values):
        machine.problem(Message("coordinates-not-changed", name="G92"))
    for letter in values.keys() & place.keys():
        machine.origins.shift_here(letter, place[letter], values[letter])


def _data(machine: Machine, line: Line) -> None:
    """Process G10: L2 sets a work offset, L20 sets a work offset from the tool's position."""
    line.apart = True
    words = dict(line.words)
    kind, values = words.get("L"), line.lengths(machine.modes.unit)
    if kind in _RADII and {"P", "R"} <= words.keys():
        adds = machine.modes.relative and kind in _RADII_OF_FANUC
        machine.radii[kind, words["P"]] = nan if adds else machine.modes.unit * words["R"]
    if kind not in (2.0, 20.0):
        return
    system, place = _numbered(machine, words.get("P", -1.0), kind), machine.here()
    if system is not None and kind == 2.0:
        if "R" in words:
            machine.maps.rotate_system(system, words["R"])
        if not machine.origins.set_machine(system, values, moved=machine.moved):
            machine.problem(Message("origin-assumed", name=codes.name_of(line.code)))
    elif machine.moved:
        if (
            system is not None
            and values.keys() <= place.keys()
            and not (machine.is_mapped or system in machine.maps.angles)
        ):
            machine.origins.set_here(system, place, values)
        else:
            machine.problem(Message("coordinates-not-changed", name=codes.name_of(line.code)))


def _numbered(machine: Machine, number: float, kind: float) -> tuple[int, float] | None:
    """Return the work offset that G10 changes, from its P and L words; None if only the control can determine it.

    On Fanuc controls, P0 is an additional offset, L20 sets the work offsets of G54.1, and under G91 values are added.
    """
    if machine.is_fanuc():
        return NUMBERED.get(number) if kind == 2.0 and not machine.modes.relative else None
    return machine.origins.system if number == 0 else NUMBERED.get(number)


def _machine_position(machine: Machine, line: Line) -> None:
    """Process a move to a machine position (G28, G30, G53). The program does not contain machine positions.

    Only a move in Z is stored as a command. The tool's unknown position is reported only if another move follows in the
    program. The unknown height is not reported if a program stop or tool change precedes the next move.
    """
    axes = line.letters & set("XYZ") or (set() if line.code == codes.MACHINE_COORDINATES else set("XYZ"))
    leave_program(machine, line, axes, line.code, codes.name_of(line.code))


def leave_program(machine: Machine, line: Line, axes: set[str], code: int, name: str) -> None:
    """Add a move along some axes to an unknown machine position.

    Parameters
    ----------
    machine : Machine
    line : Line
        The line of the move.
    axes : set of str
        The axes that move.
    code : int
        The G-code of the command for the move in Z, as ten times its number (530 for G53).
    name : str
        Name of the program's code, for messages.
    """
    line.apart = True
    if not machine.moved:
        return
    if "Z" in axes:
        machine.add(codes.name_of(code), {"Z": 0.0})
    machine.place.lose(axes)
    if not axes.isdisjoint("XY"):
        machine.away.append((machine.number, Message("machine-position", name=name)))
    elif axes:
        machine.away.append((machine.number, Message("machine-height", name=name)))


def _polar(machine: Machine, line: Line) -> None:
    """Process G16. The centre of Fanuc's polar coordinates is the origin; Mach3's centre is the tool's position."""
    here = machine.coordinates()
    if machine.is_fanuc() or (here.get("X"), here.get("Y")) == (0.0, 0.0):
        machine.polar = True
    else:
        _coordinates(machine, line)


def _coordinates(machine: Machine, line: Line) -> None:
    machine.leave_out(line, Message("coordinates-not-changed", name=codes.name_of(line.code)))


HANDLERS: dict[int, Handler] = {
    **dict.fromkeys([*codes.OFFSETS, codes.OKUMA_OFFSET], _work_offset),
    **dict.fromkeys(codes.CHANGES_COORDINATES, _coordinates),
    **dict.fromkeys([codes.LOCAL, codes.POSITION, codes.END_SHIFT, codes.SUSPEND_SHIFT, codes.RESUME_SHIFT], _shift),
    **dict.fromkeys(codes.MACHINE, _machine_position),
    codes.DATA: _data,
    codes.POLAR: _polar,
}
