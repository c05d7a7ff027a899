# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle the G-codes that mirror, scale and rotate coordinates, and apply these maps (transformations) to moves."""

from __future__ import annotations

from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.interpreter.state.maps import mapped, rotation
from vkworkbench.core.gcode.moves import codes
from vkworkbench.language import Message

_LEAST_PERCENTAGE = 100.0  # a scale in a program is in thousandths if it is a whole number and not below this limit


def map_move(machine: Machine, mode: int, move: dict[str, float]) -> None:
    """Mirror, scale and rotate the words of a move by the maps in force.

    Parameters
    ----------
    machine : Machine
    mode : int
        The G-code of the motion, as ten times its number (10 for G1).
    move : dict
        The words of the move before the maps are applied, mm. The dictionary `move` is changed.
    """
    xy, relative = machine.map(), machine.modes.relative
    in_plane = xy.flips or xy.factor.imag or xy.factor.real != machine.maps.height[0]
    if in_plane and machine.modes.plane != codes.XY_PLANE and (mode in codes.ARCS or mode in codes.CYCLES):
        machine.problem(Message("coordinates-not-changed", name=_name(machine)))
        return
    if relative:
        mapped(move, "XY", xy.vector, 0.0)
    elif {"X", "Y"} & move.keys():
        _map_point(machine, move)
    factor, _ = machine.maps.height
    if factor != 1.0:
        for letter in {"Z", *("R" if mode in codes.CYCLES else "")} & move.keys():
            of = machine.origins.of("Z")
            move[letter] = factor * move[letter] if relative else machine.maps.height_of(move[letter], of)
        for letter in {*("Q" if mode in codes.CYCLES else ""), *("K" if mode in codes.ARCS else "")} & move.keys():
            move[letter] *= factor
    if mode in codes.ARCS:
        if machine.modes.absolute_centres:
            here = machine.here()
            mapped(move, "IJ", xy.point, complex(here.get("X", 0.0), here.get("Y", 0.0)))
        else:
            mapped(move, "IJ", xy.vector, 0.0)
        if "R" in move:
            move["R"] *= abs(xy.factor)


def turned(machine: Machine, mode: int) -> int:
    """Return the motion after the maps are applied: a mirror changes the direction of arcs."""
    if mode in codes.ARCS and machine.maps.mirrors and machine.map().flips:
        return codes.CLOCKWISE if mode == codes.COUNTER_CLOCKWISE else codes.COUNTER_CLOCKWISE
    return mode


def _map_point(machine: Machine, move: dict[str, float]) -> None:
    """Map the X and Y words of an absolute target. The tool's coordinate replaces an absent word."""
    xy, here = machine.map(), machine.here()
    if xy.factor.imag and not {"X", "Y"} <= {*move, *here}:
        machine.problem(Message("coordinates-not-changed", name=_name(machine)))
        return
    given = {"X", "Y"} & move.keys()
    mapped(move, "XY", xy.point, complex(here.get("X", 0.0), here.get("Y", 0.0)))
    if not xy.factor.imag:
        for letter in {"X", "Y"} - given:
            del move[letter]


def _name(machine: Machine) -> str:
    """Return the name of the G-code that rotates, scales or mirrors the coordinates now."""
    maps = machine.maps
    return "G68" if maps.turn else "G51" if maps.scale else "G51.1" if maps.mirrors else "G10"


def _centre(machine: Machine, line: Line) -> dict[str, float]:
    """Return the fixed point of a rotation or scaling, mm. An absent word of the line means the tool's coordinate."""
    unit = machine.modes.unit
    return {**{letter: unit * value for letter, value in machine.coordinates().items()}, **line.lengths(unit)}


def _rotate(machine: Machine, line: Line) -> None:
    """Process G68. A G68 without an angle, under G91, or with words for a rotation in space is not read."""
    line.apart = True
    words = dict(line.words)
    if "R" not in words or machine.modes.relative or not line.letters.isdisjoint("ZIJKAB"):
        machine.leave_out(line, Message("coordinates-not-changed", name="G68"))
        return
    centre = _centre(machine, line)
    machine.maps.turn = rotation(words["R"]), complex(centre.get("X", 0.0), centre.get("Y", 0.0))


def _end_rotation(machine: Machine, _line: Line) -> None:
    machine.maps.turn = None


def _scale(machine: Machine, line: Line) -> None:
    """Process G51 with the same scale for all axes, either a P word or equal I, J and K words."""
    line.apart = True
    words = dict(line.words)
    scales = {words[letter] for letter in "PIJK" if letter in words}
    scale = scales.pop() if len(scales) == 1 and ("P" in words or {"I", "J"} <= words.keys()) else 0.0
    if scale >= _LEAST_PERCENTAGE and scale % 1 == 0:
        scale /= 1000
    if scale <= 0 or machine.modes.relative:
        machine.leave_out(line, Message("coordinates-not-changed", name="G51"))
        return
    centre = _centre(machine, line)
    machine.maps.scale = complex(scale), complex(centre.get("X", 0.0), centre.get("Y", 0.0))
    deep = "P" in words or "K" in words
    machine.maps.height = (scale, centre.get("Z", 0.0)) if deep else (1.0, 0.0)


def _end_scale(machine: Machine, line: Line) -> None:
    """Process G50, the end of scaling. On a lathe, G50 limits the spindle speed."""
    machine.maps.scale, machine.maps.height = None, (1.0, 0.0)
    machine.other(line)


def _mirror(machine: Machine, line: Line) -> None:
    """Process G51.1, which mirrors along X, along Y, or along both axes."""
    line.apart = True
    if "Z" in line.letters or machine.modes.relative or line.letters.isdisjoint("XY"):
        machine.leave_out(line, Message("coordinates-not-changed", name="G51.1"))
        return
    machine.maps.mirrors.update(line.lengths(machine.modes.unit))


def _end_mirror(machine: Machine, line: Line) -> None:
    """Process G50.1, which ends the mirror along the axes in its line; in a line without axes, along X and Y."""
    line.apart = True
    for letter in set("XY") & line.letters or set("XY"):
        machine.maps.mirrors.pop(letter, None)


HANDLERS: dict[int, Handler] = {
    codes.ROTATE: _rotate,
    codes.END_ROTATION: _end_rotation,
    codes.SCALE: _scale,
    codes.END_SCALE: _end_scale,
    codes.MIRROR: _mirror,
    codes.END_MIRROR: _end_mirror,
}
