# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle the G-codes of dwells, of calls, and of moves whose G-code is in force for one line only.

The moves whose G-code is in force for one line only are probes, threads and splines. Calls are reported as not read.
"""

from __future__ import annotations

from typing import Callable, Dict

from vkworkbench.core.gcode.interpreter import splines
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.unread import dwell_of
from vkworkbench.language import Message

# A function that adds the commands of a move with the given words, mm.
Shape = Callable[[Machine, Line, Dict[str, float]], None]


def _dwell(machine: Machine, line: Line) -> None:
    line.feeds = not line.letters.isdisjoint("PXU")  # On Siemens controls, F in G4 F2 is the time.
    line.apart |= "P" not in line.letters  # If a dwell's line has a P word, its axis words are a move's target.
    seconds = dwell_of(dict(line.words))
    if seconds is None:
        machine.problem(Message("dwell-untimed"))
    else:
        machine.dwells.append((machine.number, seconds))


def _macro_call(machine: Machine, line: Line) -> None:
    line.feeds = False
    machine.leave_out(line, Message("subprogram-not-read"))


def _pocket(machine: Machine, line: Line) -> None:
    """Process G12, G13 and G150, the codes of Haas controls for milling circles and pockets."""
    if line.letters.isdisjoint("IQ"):
        machine.other(line)
    else:
        line.feeds = False
        machine.leave_out(line, Message("pocket-not-read", name=codes.name_of(line.code)))


def _probe(machine: Machine, line: Line) -> None:
    if line.letters.isdisjoint("XYZ"):
        line.apart = True
    else:
        machine.problem(Message("probing-as-rapid"))
        line.once = line.code


def _thread(machine: Machine, line: Line) -> None:
    """Process G33 and G33.1 with a K word. Without a K word, G33 is a lathe's thread with the pitch in F."""
    if "K" not in line.letters or line.letters.isdisjoint("XYZ"):
        machine.other(line)
        return
    machine.problem(Message("thread-at-pitch", name=codes.name_of(line.code)))
    line.once = line.code


def _spline(machine: Machine, line: Line) -> None:
    """Process G5 and G5.1. A spline is read as a line if a word of its control points is missing."""
    if line.letters.isdisjoint("XYZ"):
        line.apart = True
        return
    if (
        not machine.is_mapped
        and splines.is_complete(line.code, dict(line.words))
        and {"X", "Y"} <= machine.place.now().keys()
    ):
        machine.problem(Message("spline-as-chords", name=codes.name_of(line.code)))
        line.once = line.code
    else:
        machine.problem(Message("spline-as-line", name=codes.name_of(line.code)))
    line.motion = codes.FEED


def _probe_along(machine: Machine, line: Line, move: dict[str, float]) -> None:
    """Add a probing move as a rapid.

    After a probing move, the tool's position is unknown, because the move stops at the part.
    """
    machine.write(codes.RAPID, move)
    machine.place.lose(set("XYZ") & line.letters)


def _thread_along(machine: Machine, line: Line, move: dict[str, float]) -> None:
    """Add a move at a feed rate of pitch times spindle speed; after a tap (G33.1), also add the move back."""
    pitch = machine.modes.unit * dict(line.words)["K"]
    place, relative = dict(machine.place.now()), machine.modes.relative
    there = {letter: move[letter] for letter in "XYZ" if letter in move}
    back = {letter: -move[letter] if relative else place[letter] for letter in there if relative or letter in place}
    machine.stand(stands=not machine.spindle)
    machine.write(codes.FEED, {**there, "F": pitch * machine.spindle / 60})
    if line.once == codes.RIGID_TAP:
        machine.write(codes.FEED, back)
    if machine.modes.feed is not None:
        machine.add("G94", {"F": machine.modes.feed})


def _spline_along(machine: Machine, line: Line, move: dict[str, float]) -> None:
    """Add the chords of a spline."""
    place, relative = machine.place.now(), machine.modes.relative
    axes = [letter for letter in "XYZ" if letter in place]
    start = [place[letter] for letter in axes]
    at_rest = dict.fromkeys(axes, 0.0) if relative else place
    offset = start if relative else [0.0] * len(axes)
    end = [move.get(letter, at_rest[letter]) + offset[i] for i, letter in enumerate(axes)]
    words = {letter: machine.modes.unit * value for letter, value in line.words}
    points = splines.chords(line.once or 0, words, start, end)
    if relative:
        points[1:] -= points[:-1].copy()
        points[0] -= start
    feed = {"F": move["F"]} if "F" in move else {}
    for point in points.tolist():
        machine.write(codes.FEED, {**dict(zip(axes, point)), **feed})


HANDLERS: dict[int, Handler] = {
    **dict.fromkeys(codes.PROBES_OF_PROGRAMS, _probe),
    **dict.fromkeys([codes.THREAD, codes.RIGID_TAP], _thread),
    **dict.fromkeys(codes.SPLINES, _spline),
    **dict.fromkeys(codes.MACRO_CALLS, _macro_call),
    **dict.fromkeys(codes.POCKETS, _pocket),
    codes.DWELL: _dwell,
}
SHAPES: dict[int, Shape] = {
    **dict.fromkeys(codes.PROBES_OF_PROGRAMS, _probe_along),
    **dict.fromkeys([codes.THREAD, codes.RIGID_TAP], _thread_along),
    **dict.fromkeys(codes.SPLINES, _spline_along),
}
