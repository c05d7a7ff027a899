# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert commands into trajectories: apply modal codes, and divide arcs and canned cycles into straight moves.

NumPy operations process all commands at once. Python loops only read the commands, and compute the heights of canned
cycles.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from vkworkbench.core.gcode.moves import arcs, cycles
from vkworkbench.core.gcode.moves.arc_centres import resolve_arcs
from vkworkbench.core.gcode.moves.codes import ARCS, COMMENT, RAPID, REAMING, TOOL_CHANGE
from vkworkbench.core.gcode.moves.modal import ModalState
from vkworkbench.core.gcode.moves.words import Words
from vkworkbench.core.toolpath import PLANE_AXES, Toolpath
from vkworkbench.given import number, positive
from vkworkbench.language import Message, Unusable

MOST_TRAJECTORIES = 5_000_000  # largest number of trajectories; this many need 2 GB of memory

_ZERO_LENGTH = 1e-9  # mm; a trajectory is left out if its length along each axis is at most this length


def linearize(commands: Iterable[Any] | Words, *, tolerance: float = 0.01, infer_centres: bool = False) -> Toolpath:
    """Convert the commands of one operation into straight trajectories.

    The trajectories have the form that the paper assumes: "all the trajectories are linearized and defined by the
    Cartesian co-ordinates of their starting point and of their point of destination" (section 2.1).

    Parameters
    ----------
    commands : iterable or Words
        ``(name, parameters)`` pairs, or objects with ``.Name`` and ``.Parameters``, in FreeCAD's units (mm, mm/s).
        Names may be ``G1``, ``G01``, ``(comment)``, or empty for a modal line. In a tap (G84, G74) with an S word
        (turns/min), an F word of at most 10 is the pitch, mm.
    tolerance : float
        Largest distance between an arc and its chords, mm.
    infer_centres : bool
        Whether the centre words of arcs may be read as coordinates if the commands contain neither G90.1 nor G91.1.
        Some controls read centre words as coordinates by default. The two readings, offsets and coordinates, are
        compared on all arcs for which they give different arcs; full circles and arcs with an R word are not compared.
        Coordinates are chosen if more than half of the compared arcs miss their end points when read with offsets, and
        less than half as many arcs miss their end points when read with coordinates.

    Returns
    -------
    Toolpath
        The trajectories. `problems` lists the parts of the commands that could not be used. The tool starts at the
        first word of each axis, so the path does not begin with a move from the origin. In a move to a machine position
        (G28, G30, G53), the tool does not move in X and Y, and moves in Z to the greatest height in the commands.

    Raises
    ------
    ValueError
        If `tolerance` is not a positive number.
    TypeError
        If `commands` has another type, for example a FreeCAD Path or the text of a program.
    Unusable
        If the commands need more than 5 million moves.
    """
    tolerance = number("tolerance", tolerance, "a positive number of mm", positive)
    words = commands if isinstance(commands, Words) else Words(commands)
    program = ModalState(words, infer_centres)
    points, rapid, command, sweep, is_cycle = _moves(program, tolerance)

    moved = _moved(points)
    while not moved.all():  # removing a short move changes the start of the next move, which can then be short, too
        points = points[np.concatenate([[True], moved])]
        rapid, command, sweep, is_cycle = rapid[moved], command[moved], sweep[moved], is_cycle[moved]
        moved = _moved(points)
    points += 0.0  # replaces -0.0 by 0.0
    feed = np.where(rapid, 0.0, program.feed[command])
    comments = np.flatnonzero(words.codes == COMMENT)
    before = np.searchsorted(command, comments).tolist()
    return Toolpath(
        points, rapid, command, feed, sweep, program.plane[command].astype(np.uint8), is_cycle,
        commands=len(words),
        tool_changes=np.searchsorted(command, np.flatnonzero(words.codes == TOOL_CHANGE)),
        comments=tuple((at, words.names[i].strip(" ()")) for at, i in zip(before, comments.tolist())),
        problems=tuple(program.problems),
        dwells=program.dwells,
    )  # fmt: skip


def _moved(points: np.ndarray) -> np.ndarray:
    """Return whether each trajectory is longer than `_ZERO_LENGTH` along an axis, (n - 1,) bool."""
    moved = np.zeros(max(len(points) - 1, 0), bool)
    for axis in range(3):  # a loop over the axes needs less memory than one array of all differences
        moved |= np.abs(np.diff(points[:, axis])) > _ZERO_LENGTH
    return moved


def _moves(program: ModalState, tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return points, rapid, command, sweep and cycle of all moves, including moves with zero length."""
    motion, position = program.motion, program.position
    is_arc = np.isin(motion, ARCS)
    counts = (motion >= 0).astype(np.int64)

    arc_rows = np.flatnonzero(is_arc)
    if len(arc_rows):
        axes = np.array([PLANE_AXES[p] for p in program.plane[arc_rows].tolist()])
        start, end = program.before(arc_rows), position[arc_rows]
        flat_start = np.take_along_axis(start, axes, 1)
        flat_end = np.take_along_axis(end, axes, 1)
        resolved = resolve_arcs(program, arc_rows, axes, flat_start, flat_end)
        counts[arc_rows] = arcs.chord_counts(resolved, tolerance)
    cycle_rows = np.flatnonzero(program.is_cycle)
    if len(cycle_rows):
        code = program.motion[cycle_rows]
        counts[cycle_rows] = cycles.move_counts(code, program.cycle_heights, program.cycle_peck)

    total = int(counts.sum())
    if total > MOST_TRAJECTORIES:
        raise Unusable(Message("too-many-moves", moves=total, tolerance=tolerance))
    command = np.repeat(np.arange(len(motion)), counts)
    # The start point of the first move, and the end points of all moves.
    all_points = np.empty((total + 1 if total else 0, 3))
    all_points[:1], points = position[:1], all_points[1:]
    np.take(position, command, axis=0, out=points, mode="clip")
    rapid = (motion == RAPID)[command]
    is_cycle = program.is_cycle[command]
    sweep = np.zeros(total)
    if len(arc_rows):
        chord_of = np.repeat(np.arange(len(arc_rows)), counts[arc_rows])
        flat = arcs.chords(resolved, counts[arc_rows], flat_start[:, :2], flat_end[:, :2],
                           flat_start[:, 2], flat_end[:, 2])  # fmt: skip
        on_arc = is_arc[command]
        in_space = np.empty_like(flat)
        np.put_along_axis(in_space, axes[chord_of], flat, 1)
        points[on_arc] = in_space
        sweep[on_arc] = (resolved.sweep / counts[arc_rows])[chord_of]
    if len(cycle_rows):
        points[is_cycle], rapid[is_cycle] = _expand_cycles(program, cycle_rows)
    return all_points, rapid, command, sweep, is_cycle


def _expand_cycles(program: ModalState, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the end points of all moves of canned cycles, (k, 3) mm, and whether each move is a rapid, (k,) bool."""
    start = program.before(rows).copy()
    start[rows == 0] = program.position[0]
    axes = np.array([PLANE_AXES[p] for p in program.plane[rows].tolist()])
    start = np.take_along_axis(start, axes, 1)
    start[:, 2] = program.cycle_heights[:, 0]
    hole = np.take_along_axis(program.position[rows], axes[:, :2], 1)
    code, heights, peck = program.motion[rows], program.cycle_heights, program.cycle_peck
    only_to_r = program.rapid_to_start[rows] | (code == REAMING)
    leaves = np.where(only_to_r, heights[:, 1], heights[:, 3])
    flat, rapid = cycles.moves(code, start, hole, heights, peck, program.cycle_rises, leaves)
    points = np.empty_like(flat)
    np.put_along_axis(points, np.repeat(axes, cycles.move_counts(code, heights, peck), axis=0), flat, 1)
    return points, rapid
