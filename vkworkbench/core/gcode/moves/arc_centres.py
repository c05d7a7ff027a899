# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the centre words (I, J, K) and the number of turns (P) of an NC program's arcs."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.gcode.moves import arcs
from vkworkbench.core.gcode.moves.codes import CLOCKWISE
from vkworkbench.core.gcode.moves.modal import ModalState
from vkworkbench.language import Message

_MOST_TURNS = 10_000  # Largest number of turns of an arc (P word).
_OFF_CIRCLE = 0.05  # mm; if an arc ends farther than this from its circle, its centre words were probably misread.


def resolve_arcs(
    program: ModalState, rows: np.ndarray, axes: np.ndarray, start: np.ndarray, end: np.ndarray
) -> arcs.Arcs:
    """Return the geometry of all arcs, and report each arc that is not read exactly as the program defines it.

    Parameters
    ----------
    program : ModalState
        The commands.
    rows : (m,) int
        Indices of the commands that are arcs.
    axes : (m, 3) int
        The two axes of each arc's plane, and the axis of the plane's normal.
    start, end : (m, 3) float64
        The start point and the end point of each arc along the axes in `axes`, mm.
    """
    words, problems = program.words, program.problems
    columns, unusable = zip(*(words.column(letter, rows) for letter in "IJK"))
    problems.add(rows[np.any(unusable, axis=0)], Message("unusable-centre"))
    offset = np.take_along_axis(np.column_stack(columns), axes[:, :2], 1)
    radius, unusable = words.column("R", rows)
    problems.add(rows[unusable], Message("unusable-word", letter="R"))
    clockwise = program.motion[rows] == CLOCKWISE
    ends = start[:, :2], end[:, :2], clockwise, offset, radius
    resolved = arcs.resolve(*ends, program.absolute_centre[rows])
    if program.infer_centres:
        absolute = arcs.resolve(*ends, np.ones(len(rows), bool))
        differ = np.abs(resolved.centre - absolute.centre).max(axis=1) > _OFF_CIRCLE
        circles = differ & ~np.isnan(offset).any(axis=1) & (np.abs(resolved.sweep) > 2 * np.pi - 1e-9)
        fits, fits_absolute = resolved.gap <= _OFF_CIRCLE, absolute.gap <= _OFF_CIRCLE
        tells = differ & ~circles & (fits | fits_absolute)
        off, off_absolute = (np.count_nonzero(tells & ~fit) for fit in (fits, fits_absolute))
        if 2 * off > np.count_nonzero(tells) and 2 * off_absolute < off:
            resolved = absolute
            problems.add(rows[:1], Message("absolute-centres"))
        elif not tells.any() and not _repeats(offset[circles]):
            problems.add(rows[circles], Message("circles-alone"))

    known = np.take_along_axis(program.known[np.maximum(rows - 1, 0)] & (rows > 0)[:, None], axes[:, :2], 1)
    unknown_start = ~known.all(axis=1)
    problems.add(rows[unknown_start], Message("arc-before-start"))
    bad = resolved.degenerate & ~unknown_start
    problems.add(rows[bad], Message("arc-as-line"))
    uneven = (resolved.gap > np.maximum(0.1, 0.01 * resolved.radius[:, 0])) & ~resolved.degenerate & ~unknown_start
    problems.add(rows[uneven], Message("arc-of-changing-radius"))
    turns = np.nan_to_num(words.column("P", rows)[0], nan=1.0)
    usable = (turns <= _MOST_TURNS) & (turns % 1 == 0)
    problems.add(rows[~usable & (turns > 1)], Message("turns-not-read"))
    resolved.sweep[:] += np.sign(resolved.sweep) * np.where(usable & (turns > 1), turns - 1, 0) * 2 * np.pi
    # If the start point is unknown, the arc's sweep is 0, and the arc has zero length.
    resolved.sweep[unknown_start] = 0.0
    return resolved


def _repeats(offset: np.ndarray) -> bool:
    """Return whether two successive circles have equal centre words, as the circles of a helix do.

    `offset` contains the centre words of the circles, (m, 2) mm.

    Equal centre words are probably offsets, because coordinates would mean two circles around one centre, which is
    rare.
    """
    return bool((np.diff(offset, axis=0) == 0).all(axis=1).any())
