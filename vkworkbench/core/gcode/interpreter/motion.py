# SPDX-License-Identifier: LGPL-2.1-or-later
"""Add the commands of moves, with their feed rates."""

from __future__ import annotations

from vkworkbench.core.gcode.interpreter import compensation, corners
from vkworkbench.core.gcode.interpreter.cycles import leave_holes, repeats_of
from vkworkbench.core.gcode.interpreter.mapping import turned
from vkworkbench.core.gcode.interpreter.single_moves import SHAPES
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Machine
from vkworkbench.core.gcode.interpreter.target import is_polar, polar_step, target
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.unread import dwell_of
from vkworkbench.language import Message

AXES = frozenset("XYZIJKR")


def move_of(machine: Machine, line: Line) -> None:
    """Add the command for a program line: a move, or a motion or feed rate that only later lines use."""
    motion, apart, parameters = line.motion, line.apart, line.parameters
    if motion is None and machine.motion == codes.CANCEL:  # axis words without a motion code after G80 are a rapid
        motion = _after_cancel(machine) if not AXES.isdisjoint(parameters) and not apart and line.once is None else None
    if motion is not None:
        if motion in codes.CYCLES and machine.motion in (codes.RAPID, codes.FEED, *codes.ARCS):
            machine.before_cycles = machine.motion
        machine.motion, machine.later, machine.written = motion, None, -1
        machine.pause = 0.0
    mode = machine.motion
    feed = _feed(machine, line)
    move = {} if apart else target(machine, mode, parameters)
    if feed is not None:
        move["F"] = feed
    if apart or AXES.isdisjoint(move):
        # The command for a feed rate is named G94, because a command without a name would repeat the canned cycle in
        # force.
        if motion is not None or feed is not None:
            machine.add("G94" if motion is None else codes.name_of(motion), {} if feed is None else {"F": feed})
            machine.written = machine.written if motion is None else motion
        return
    if machine.away or machine.ended or not machine.moved:
        _begin_move(machine)
    machine.unnamed = None
    if machine.compensation is not None and (line.once is not None or machine.motion in codes.CYCLES):
        compensation.stop(machine)
    if line.once is None:
        _move_along(machine, parameters, move)
    else:
        SHAPES[line.once](machine, line, move)


def _after_cancel(machine: Machine) -> int:
    """Return the motion of a move after G80; report the move if controls differ in its motion."""
    if machine.before_cycles > codes.RAPID:
        machine.problem(Message("rapid-after-cancel"))
    return codes.RAPID


def _move_along(machine: Machine, parameters: dict[str, float], move: dict[str, float]) -> None:
    """Add the commands of a line with axis words for the motion in force."""
    mode = machine.motion
    _note(machine, mode, parameters, move)
    repeats = 1
    if mode in codes.CYCLES:
        leave_holes(machine, mode)
        repeats = repeats_of(machine, mode, parameters, move)
        if repeats <= 0:
            machine.later = move
            return
        if machine.pause:
            machine.dwells += [(machine.number, machine.pause)] * repeats
        if machine.later is not None:
            move, machine.later = {**machine.later, **move}, None
            machine.written = -1
    elif mode in codes.ARCS and parameters.get("P", 1.0) != 1:
        move["P"] = parameters["P"]
    if machine.stands or machine.modes.per_turn is not None:
        machine.stand(stands=machine.modes.per_turn is not None and not machine.spindle and mode > 0)
    if machine.seconds and mode > 0 and mode not in codes.CYCLES:
        machine.inverse_time[len(machine.commands)] = 1 / machine.seconds
    if machine.compensation is not None and mode not in codes.CYCLES:
        compensation.follow(machine, mode, move)
        return
    motion = turned(machine, mode) if machine.maps.mirrors else mode
    for _ in range(repeats):
        corners.write(machine, motion, parameters, move)
        if repeats > 1 and machine.modes.relative and is_polar(parameters):
            # If a relative move by a polar angle is repeated, each repeat has another direction.
            move.update(polar_step(machine, parameters))


def _note(machine: Machine, mode: int, parameters: dict[str, float], move: dict[str, float]) -> None:
    """Note words of a move that indicate a lathe or another machine than a mill.

    Report a move without a Z word after a change of the tool length offset.
    """
    if "Y" in move:
        _note_y(machine, move["Y"])
    if mode in codes.ARCS:
        machine.clues.arc(set(parameters), machine.number)
    if "Z" in move and not machine.modes.relative:
        machine.length_changed = machine.stopped = False
    elif machine.length_changed and (mode > 0 or not machine.stopped):
        machine.problem(Message("length-before-height"))
        machine.length_changed = False
    if "L" in parameters and mode not in codes.CYCLES and machine.call is None:
        machine.problem(Message("word-not-read", letter="L"))
    if mode in codes.CYCLES and "P" in parameters:
        seconds = dwell_of(parameters)
        machine.pause = seconds or 0.0
        if seconds is None:
            machine.problem(Message("dwell-untimed"))


def _note_y(machine: Machine, y: float) -> None:
    if machine.modes.relative:
        machine.clues.y(y != 0)
    else:
        machine.clues.y(machine.last_y not in (None, y))
        machine.last_y = y


def _begin_move(machine: Machine) -> None:
    if not machine.moved:
        machine.origins.begin()
    machine.moved = True
    for line, what in machine.away:
        machine.problem(what, line)
    machine.away.clear()
    if machine.ended:
        machine.problem(Message("goes-on"))


def _feed(machine: Machine, line: Line) -> float | None:
    """Return the feed rate in a line's F word, mm/s; None without an F word, and None under G93.

    Under G93, an F word sets `machine.seconds`, the duration of the line's move.
    """
    modes, per_turn = machine.modes, machine.modes.feed_mode == codes.PER_TURN
    value = line.parameters.get("F") if line.feeds else None
    machine.seconds = 60 / value if modes.feed_mode == codes.INVERSE_TIME and value and value > 0 else 0.0
    if value is None or modes.feed_mode == codes.INVERSE_TIME:
        return None
    value *= line.feed_factor
    modes.per_turn = value if per_turn else None
    modes.feed = value * modes.feed_unit * (machine.spindle if per_turn else 1.0) / machine.dialect.feed_time
    return modes.feed
