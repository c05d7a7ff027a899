# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read what only Heidenhain's DIN/ISO has: polar coordinates around a pole, and datum shifts."""

from __future__ import annotations

from cmath import phase, rect
from math import ceil, degrees, radians

from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_ABSOLUTE, _RELATIVE = codes.ABSOLUTE / 10, codes.RELATIVE / 10
_ALONG = {"I": "X", "J": "Y"}  # the axes of the pole's coordinates
# For each G-code of a move in polar coordinates, the G-code of the same move in Cartesian coordinates.
_POLAR = {10.0: 0.0, 11.0: 1.0, 12.0: 2.0, 13.0: 3.0}
_WHOLE = 1e-9  # turns; a smaller rest is a rounding error


def cartesian(machine: Machine, words: list[tuple[str, float]]) -> list[tuple[str, float]]:
    """Return the words of a line, with X and Y words instead of a polar radius (R) and a polar angle (H).

    An incremental angle of more than one turn gives the number of turns of an arc (P).
    """
    code = next((value for letter, value in words if letter == "G" and value in _POLAR), None)
    if code is None:
        return words
    unit, origins, pole = machine.modes.unit, machine.origins, machine.pole
    relative = machine.modes.relative
    rest: list[tuple[str, float]] = []
    polar: list[tuple[str, float, bool]] = []  # letter, value, and whether the value is incremental
    for letter, value in words:
        if letter == "G" and value in (_ABSOLUTE, _RELATIVE):
            relative = value == _RELATIVE
        if letter in _ALONG and not relative:
            pole[letter] = unit * value + origins.of(_ALONG[letter])
        elif letter in "RH":
            polar.append((letter, value, relative))
        else:
            rest.append((letter, _POLAR.get(value, value) if letter == "G" else value))
    here = machine.here()
    if not {"I", "J"} <= pole.keys() or not {"X", "Y"} <= here.keys():
        machine.problem(Message("unknown-code", name=repr(f"G{code:.0f}")))
        return [(letter, value) for letter, value in rest if letter != "G" or value in (_ABSOLUTE, _RELATIVE)]
    centre = complex(pole["I"], pole["J"])
    arm = complex(here["X"], here["Y"]) - centre
    radius, angle, turns = abs(arm), degrees(phase(arm)), 1
    for letter, value, adds in polar:
        if letter == "R":
            radius = unit * value + (radius if adds else 0.0)
        else:
            turns = ceil(abs(value) / 360 - _WHOLE) if adds else 1
            angle = value + (angle if adds else 0.0)
    end = centre + rect(radius, radians(angle))
    start = complex(here["X"], here["Y"]) if relative else complex(origins.of("X"), origins.of("Y"))
    end = (end - start) / unit
    return [*rest, ("X", end.real), ("Y", end.imag), *([("P", float(turns))] if turns > 1 else [])]


def _shift(machine: Machine, line: Line) -> None:
    """Process G54 with axis words, which shifts the datum; under G91, the words are added to the shift."""
    line.apart = True
    values = line.lengths(machine.modes.unit)
    if not values:
        machine.unknown(line.code, line)
    # A G90 or G91 can follow G54 in the line.
    if ("G", _RELATIVE) in line.words or (machine.modes.relative and ("G", _ABSOLUTE) not in line.words):
        values = {axis: value + machine.origins.shift.get(axis, 0.0) for axis, value in values.items()}
    machine.origins.shift_by(values)


HANDLERS: dict[int, Handler] = {540: _shift}
