# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the tool's path under cutter compensation (G41, G42), for lines and arcs in the XY plane, as in LinuxCNC.

The first compensated move ends at a distance of the tool's radius from the programmed end point, perpendicular to the
programmed path. Then the tool follows offset curves, at a distance of the tool's radius from the programmed path. At an
outer corner, an arc joins two offset curves. At an inner corner, the tool leaves the first offset curve at the
intersection with the second offset curve. The end of a move is therefore known only when the next move is read. Then
the handler corrects the end point in the command that was already added for the first move.
"""

from __future__ import annotations

from cmath import phase
from math import pi
from typing import NamedTuple

import numpy as np

from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.interpreter.state.offset_path import Compensation, Curve
from vkworkbench.core.gcode.moves import arcs, codes
from vkworkbench.language import Message

_SAME = 1e-6  # mm; points at most this far apart are treated as equal
_LEFT = (410, 411)
# L words of G10 that set a tool's radius: in LinuxCNC's tool table, and as Fanuc's geometry and wear offset.
_TOOL_TABLE, _GEOMETRY, _WEAR = 1.0, 12.0, 13.0
_STRAIGHT_ON = 0.05  # rad; at a corner with a smaller turn, LinuxCNC adds no arc


class _Target(NamedTuple):
    """The end of a programmed move, mm, and the centre of an arc, mm; None for a line."""

    end: complex
    centre: complex | None


def _start(machine: Machine, line: Line) -> None:
    """Process G41, G42, G41.1 and G42.1. The tool's radius comes from the D word in the line, or from G10."""
    words, name = dict(line.words), codes.name_of(line.code)
    if line.code % 10:
        radius = machine.modes.unit * words["D"] / 2 if "D" in words else None
    else:
        radius = _radius(machine, words.get("D", -1.0))
    before, machine.compensation = machine.compensation, None
    place = machine.here()
    usable = machine.modes.plane == codes.XY_PLANE and not machine.is_mapped and {"X", "Y"} <= place.keys()
    if radius is None or not radius >= 0 or not usable or machine.modes.feed_mode == codes.INVERSE_TIME:
        machine.problem(Message("compensation-not-read", name=name))
    elif radius > 0:
        tool = complex(place["X"], place["Y"])
        programmed = tool if before is None else before.programmed
        machine.compensation = Compensation(name, 1 if line.code in _LEFT else -1, radius, programmed, tool)
        if line.code % 10 == 0 and (machine.is_fanuc() or (_GEOMETRY, words["D"]) in machine.radii):
            machine.problem(Message("compensation-of-linuxcnc", name=name))


def _radius(machine: Machine, number: float) -> float | None:
    """Return the radius of a tool offset with its wear, mm; None if the program does not contain the radius."""
    radius = machine.radii.get((_TOOL_TABLE, number), machine.radii.get((_GEOMETRY, number)))
    return None if radius is None else radius + machine.radii.get((_WEAR, number), 0.0)


def _end(machine: Machine, line: Line) -> None:
    """Process G40, after which the next move leads back to the programmed path."""
    if machine.compensation is not None:
        machine.compensation.ends = True
    machine.other(line)


def follow(machine: Machine, mode: int, move: dict[str, float]) -> None:
    """Add the commands of a straight move or an arc under compensation.

    Parameters
    ----------
    machine : Machine
        Machine whose `compensation` is not None.
    mode : int
        The G-code of the motion, as ten times its number (10 for G1).
    move : dict
        The words of the move in the coordinates of the toolpath, mm.
    """
    compensation = machine.compensation
    if compensation is None:
        return
    if mode not in codes.ARCS and {"X", "Y"}.isdisjoint(move) and not compensation.ends:
        machine.write(mode, move)
        return
    target = _target(machine, compensation, mode, move)
    begin, compensation.programmed = compensation.programmed, target.end
    if compensation.ends:
        machine.compensation = None
        _leave(machine, compensation, mode, move, begin)
        return
    if mode not in codes.ARCS and compensation.last is not None and abs(target.end - begin) <= _SAME:
        machine.write(mode, {letter: value for letter, value in move.items() if letter not in "XY"})
        return
    curve = _beside(compensation, mode, begin, target)
    joined = curve is not None and (compensation.last is None or _join(machine, compensation, mode, move, curve, begin))
    if curve is None or not joined:
        machine.problem(Message("compensation-not-read", name=compensation.name))
        machine.compensation = None
        _leave(machine, compensation, mode, move, begin)
        return
    compensation.last = curve
    compensation.command = len(machine.commands)
    _write(machine, compensation, mode, move, curve)


def stop(machine: Machine) -> None:
    """End the compensation before a move that cannot be compensated, for example a drilled hole."""
    compensation, machine.compensation = machine.compensation, None
    if compensation is not None and not compensation.ends:
        machine.problem(Message("compensation-not-read", name=compensation.name))
    if compensation is not None and abs(compensation.tool - compensation.programmed) > _SAME:
        _write(machine, compensation, codes.FEED, {}, Curve(compensation.tool, compensation.programmed))


def _target(machine: Machine, compensation: Compensation, mode: int, move: dict[str, float]) -> _Target:
    """Return the end and the centre of a programmed move."""
    begin, modes = compensation.programmed, machine.modes
    if modes.relative:
        end = begin + complex(move.get("X", 0.0), move.get("Y", 0.0))
    else:
        end = complex(move.get("X", begin.real), move.get("Y", begin.imag))
    if mode not in codes.ARCS:
        return _Target(end, None)
    word = np.array([[move.get("I", np.nan), move.get("J", np.nan)]])
    resolved = arcs.resolve(
        np.array([[begin.real, begin.imag]]),
        np.array([[end.real, end.imag]]),
        np.array([mode == codes.CLOCKWISE]),
        word,
        np.array([move.get("R", np.nan)]),
        np.array([modes.absolute_centres]),
    )
    return _Target(end, complex(*resolved.centre[0]) if not resolved.degenerate[0] else None)


def _beside(compensation: Compensation, mode: int, begin: complex, target: _Target) -> Curve | None:
    """Return the offset curve beside a programmed move; None if no such curve exists."""
    side, radius, end = compensation.side, compensation.radius, target.end
    if mode not in codes.ARCS:
        way = end - begin
        if abs(way) <= (radius if compensation.last is None else _SAME):
            return None
        normal = side * 1j * way / abs(way) * radius
        return Curve(begin + normal, end + normal)
    centre, turn = target.centre, -1 if mode == codes.CLOCKWISE else 1
    if centre is None or compensation.last is None:
        return None
    beside = abs(begin - centre) - side * turn * radius
    if beside <= _SAME:
        return None
    scale = beside / abs(begin - centre)
    return Curve(centre + scale * (begin - centre), centre + scale * (end - centre), centre, turn)


def _join(
    machine: Machine, compensation: Compensation, mode: int, move: dict[str, float], curve: Curve, corner: complex
) -> bool:
    """Join an offset curve to the previous offset curve at a programmed corner; return whether this is possible."""
    last, side = compensation.last, compensation.side
    if last is None:
        return True
    feed = {"F": move["F"]} if "F" in move else {}
    turn = side * phase(curve.way(curve.start) / last.way(last.end))
    if abs(turn) <= _STRAIGHT_ON:
        curve.start = last.end
        return True
    if abs(turn) > pi - _STRAIGHT_ON and not (last.centre is None and curve.centre is None):
        return False  # at a reversal into or out of an arc, LinuxCNC's path is not determined
    if turn < 0 or turn > pi - _STRAIGHT_ON:
        around = codes.CLOCKWISE if side > 0 else codes.COUNTER_CLOCKWISE
        if mode == codes.RAPID:
            _write(machine, compensation, mode, feed, Curve(last.end, curve.start))
        else:
            _write(machine, compensation, around, feed, Curve(last.end, curve.start, corner, -side))
        return True
    meeting = [point for point in last.meets(curve) if last.contains(point) and curve.contains(point)]
    if not meeting:
        return False
    point = min(meeting, key=lambda one: abs(one - corner))
    _move_end(machine, compensation, point)
    curve.start = point
    return True


def _move_end(machine: Machine, compensation: Compensation, point: complex) -> None:
    """Change the end point in the command for the last offset curve."""
    machine.move_end(compensation.command, point, point - compensation.tool, relative=compensation.relative)
    compensation.tool = point


def _write(machine: Machine, compensation: Compensation, mode: int, move: dict[str, float], curve: Curve) -> None:
    """Add the command of an offset curve that begins at the tool's position.

    `move` contains further words of the command.
    """
    start, end = compensation.tool, curve.end
    compensation.relative = machine.modes.relative
    target = end - start if compensation.relative else end
    words = {letter: value for letter, value in move.items() if letter not in "IJR"}
    words["X"], words["Y"] = target.real, target.imag
    if curve.centre is not None:
        centre = curve.centre if machine.modes.absolute_centres else curve.centre - start
        words["I"], words["J"] = centre.real, centre.imag
    machine.write(mode, words)
    compensation.tool = end


def _leave(machine: Machine, compensation: Compensation, mode: int, move: dict[str, float], begin: complex) -> None:
    """Add the first move after the compensation.

    If this move is an arc, add a line to the programmed path before the arc.
    """
    if mode in codes.ARCS:
        _write(machine, compensation, codes.FEED, {}, Curve(compensation.tool, begin))
        machine.write(mode, move)
    else:
        _write(machine, compensation, mode, move, Curve(compensation.tool, compensation.programmed))


HANDLERS: dict[int, Handler] = {**dict.fromkeys(codes.COMPENSATION, _start), codes.END_COMPENSATION: _end}
