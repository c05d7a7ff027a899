# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finishing passes: contours that go around what was cleared, and belong to the operation that cleared it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

import numpy as np

from vkworkbench.core.recognition.thresholds import PARTS, SAME
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath


class Cut(NamedTuple):
    """What is cut between two borders: the trajectories with which it and the next begin, and what it is."""

    begin: int
    end: int
    found: Recognition


class _Run(NamedTuple):
    """Consecutive sections that all clear, or all go around, to one depth; boxes: what each of them cuts, (2, 3) mm."""

    sections: list[Cut]
    clears: bool
    boxes: list[np.ndarray]


def within_operations(toolpath: Toolpath, cut: Sequence[Cut], doubtful: Collection[int]) -> set[int]:
    """Return the borders in doubt between what clears an area and the contours that finish its walls, and among both.

    The contours go around all that was cleared, as deep as it was. They may be several: one around each island.

    Parameters
    ----------
    toolpath : Toolpath
    cut : sequence of Cut
        The sections of the program.
    doubtful : collection of int
        The borders at which an operation may go on.
    """
    found: set[int] = set()
    runs = _runs(toolpath, cut, doubtful)
    for one, two in zip(runs, runs[1:]):
        if one.clears is two.clears or not _meet(one.sections[-1], two.sections[0], doubtful):
            continue
        area, walls = (one, two) if one.clears else (two, one)
        low, high = np.min(area.boxes, axis=(0, 1)), np.max(area.boxes, axis=(0, 1))
        # The contours next to what was cleared, as many as go around it: others may be another operation.
        outward = np.array(walls.boxes if area is one else walls.boxes[::-1])
        if abs(low[2] - outward[0, 0, 2]) > SAME.HEIGHT:
            continue
        least = np.minimum.accumulate(outward[:, 0, :2])
        most = np.maximum.accumulate(outward[:, 1, :2])
        apart = np.maximum(np.abs(least - low[:2]), np.abs(most - high[:2])).max(axis=1)
        stepover = max(section.found.stepover or 0.0 for section in area.sections)
        around = np.flatnonzero(apart < max(PARTS.AROUND * np.hypot(*(high - low)[:2]), stepover))
        if len(around):
            count = int(around[-1]) + 1
            members = [*one.sections, *two.sections[:count]] if area is one else [*one.sections[-count:], *two.sections]
            found.update(section.begin for section in members[1:])
    return found


def _runs(toolpath: Toolpath, cut: Sequence[Cut], doubtful: Collection[int]) -> list[_Run]:
    """Return the sections that clear and those that go around, as many at once as follow one another."""
    runs: list[_Run] = []
    for section in cut:
        strategy = section.found.strategy
        clears = strategy.family is Family.ROWS or strategy is Strategy.ADAPTIVE
        # Two walls may lie in one another as two offsets do.
        offsets = strategy is Strategy.CONTOUR_PARALLEL and (section.found.passes or 0) <= PARTS.WALLS
        if not (clears or offsets or strategy is Strategy.PROFILE):
            continue
        box, last = _ground(toolpath, section.found), runs[-1] if runs else None
        follows = last and last.clears is clears and _meet(last.sections[-1], section, doubtful)
        if last and follows and abs(last.boxes[-1][0, 2] - box[0, 2]) < SAME.HEIGHT:
            last.sections.append(section)
            last.boxes.append(box)
        else:
            runs.append(_Run([section], clears, [box]))
    return runs


def _meet(one: Cut, two: Cut, doubtful: Collection[int]) -> bool:
    """Whether the second section may go on with the operation of the first."""
    return one.end == two.begin and two.begin in doubtful


def _ground(toolpath: Toolpath, one: Recognition) -> np.ndarray:
    """Return the box of what a section cuts, (2, 3): its lowest and its highest corner, mm."""
    first, last = one.spans[0].first, one.spans[-1].last
    cut = np.flatnonzero(~toolpath.rapid[first : last + 1]) + first
    points = toolpath.points[np.union1d(cut, cut + 1)]
    return np.array([points.min(axis=0), points.max(axis=0)])
