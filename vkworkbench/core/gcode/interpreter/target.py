# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of a move into lengths, mm, in the coordinates of the toolpath."""

from __future__ import annotations

import math

from vkworkbench.core.gcode.interpreter.mapping import map_move
from vkworkbench.core.gcode.interpreter.state.machine import Machine
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.unread import ROTARY
from vkworkbench.language import Message

_COORDINATES = {"X": "X", "Y": "Y", "Z": "Z"}  # Letters of absolute coordinates, and their axes.
_OF_ARCS = {**_COORDINATES, "I": "X", "J": "Y", "K": "Z"}  # Absolute coordinates of arcs under G90.1.
_POLAR = "@^"  # LinuxCNC's polar coordinates: @ is the distance from the origin, ^ is the angle in degrees.
_POLAR_LETTERS = dict(zip("XY", _POLAR))
_LENGTHS = frozenset("XYZIJKRQ")
_KNOWN = _LENGTHS | {"F", "S", "P", "L", "H", "D", *_POLAR}


def target(machine: Machine, mode: int, parameters: dict[str, float]) -> dict[str, float]:
    """Return the lengths of a move in the coordinates of the toolpath, mm; report words that are not read."""
    if machine.polar:
        parameters = _with_polar_letters(machine, parameters)
    if is_polar(parameters):
        parameters = _cartesian(machine, parameters)
    unit = machine.modes.unit
    move = {letter: unit * value for letter, value in parameters.items() if letter in _LENGTHS}
    if machine.origins.used:
        move = _shifted(machine, mode, move)
    if machine.is_mapped:
        map_move(machine, mode, move)
    if machine.dialect.has_pole:
        move = _centred(machine, mode, move)
    if not _KNOWN.issuperset(parameters):
        machine.clues.axes(parameters, mode > 0, machine.number)
        for letter in sorted(set(parameters) - _KNOWN):
            _unread(machine, letter, parameters[letter])
    return move


def _with_polar_letters(machine: Machine, parameters: dict[str, float]) -> dict[str, float]:
    """Return the words of a line after G16, with the letters @ and ^ of LinuxCNC's polar coordinates.

    X words are the distance from the origin, and Y words are the angle. Lines under G91 or in another plane than XY are
    reported and read as if G16 were not there.
    """
    given = {"X", "Y"} & parameters.keys()
    modes = machine.modes
    known = len(given) == 2 or {"X", "Y"} <= machine.here().keys()
    if given and (modes.relative or modes.plane != codes.XY_PLANE or not known):
        machine.problem(Message("coordinates-not-changed", name="G16"))
        return parameters
    return {_POLAR_LETTERS.get(letter, letter): value for letter, value in parameters.items()}


def is_polar(parameters: dict[str, float]) -> bool:
    """Return whether a line contains polar coordinates."""
    return not parameters.keys().isdisjoint(_POLAR)


def polar_step(machine: Machine, parameters: dict[str, float]) -> dict[str, float]:
    """Return the X and Y words, mm, of the next repeat of a relative move in polar coordinates."""
    unit, words = machine.modes.unit, _cartesian(machine, parameters)
    return {letter: unit * words[letter] for letter in "XY" if letter in words}


def _cartesian(machine: Machine, parameters: dict[str, float]) -> dict[str, float]:
    """Return the words of a line, with X and Y words instead of LinuxCNC's polar coordinates @ and ^."""
    place, unit = machine.here(), machine.modes.unit
    if not {"X", "Y"} <= place.keys() and (machine.modes.relative or not {*_POLAR} <= parameters.keys()):
        for letter in sorted({*_POLAR} & parameters.keys()):
            machine.problem(Message("word-not-read", letter=letter))
        return parameters
    origin_x, origin_y = machine.origins.of("X"), machine.origins.of("Y")
    x, y = place.get("X", origin_x) - origin_x, place.get("Y", origin_y) - origin_y
    distance, angle = math.hypot(x, y), math.degrees(math.atan2(y, x))
    if machine.modes.relative:
        distance += unit * parameters.get("@", 0.0)
        angle += parameters.get("^", 0.0)
    else:
        distance = unit * parameters["@"] if "@" in parameters else distance
        angle = parameters.get("^", angle)
    end_x, end_y = distance * math.cos(math.radians(angle)), distance * math.sin(math.radians(angle))
    if machine.modes.relative:
        end_x, end_y = end_x - x, end_y - y
    rest = {letter: value for letter, value in parameters.items() if letter not in _POLAR}
    return {**rest, "X": end_x / unit, "Y": end_y / unit}


def _shifted(machine: Machine, mode: int, move: dict[str, float]) -> dict[str, float]:
    """Return the words of a move, with the origin in force added to the coordinates."""
    centres = machine.dialect.has_pole or (machine.modes.absolute_centres and mode in codes.ARCS)
    if machine.modes.relative:
        along = {"I": "X", "J": "Y", "K": "Z"} if centres else {}
    else:
        along = _OF_ARCS if centres else _COORDINATES
        if mode in codes.CYCLES:
            along = {**along, "R": codes.DRILLED[machine.modes.plane]}
    return {
        letter: value + machine.origins.of(along[letter]) if letter in along else value
        for letter, value in move.items()
    }


def _centred(machine: Machine, mode: int, move: dict[str, float]) -> dict[str, float]:
    """Return the words of a move; for an arc, with the centre from the same line or from an earlier line."""
    centre = {letter: move.pop(letter) for letter in "IJK" if letter in move}
    if centre and machine.modes.relative:  # relative centres are not read, because the tool's position is unknown here
        machine.pole = {}
        for letter in centre:
            machine.problem(Message("word-not-read", letter=letter))
    else:
        machine.pole.update(centre)
    is_arc = mode in codes.ARCS and "R" not in move and not {"X", "Y", "Z"}.isdisjoint(move)
    return {**move, **machine.pole} if is_arc else move


def _unread(machine: Machine, letter: str, value: float) -> None:
    """Report a word that is not read. The word of a rotary axis is reported only if its value changes.

    A rotary axis is at 0 until the axis's first word.
    """
    if letter not in ROTARY:
        machine.problem(Message("word-not-read", letter=letter))
    elif value != machine.angles.get(letter, 0.0):
        machine.problem(Message("rotary-not-read", letter=letter))
        machine.angles[letter] = value
