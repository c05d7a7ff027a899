# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find finishing passes: contours around a cleared area, which belong to the operation that cleared it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

import numpy as np

from vkworkbench.core.recognition.thresholds import PARTS, ROUNDING
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath


class CutSection(NamedTuple):
    """A section of a program between two borders (possible starts of operations).

    The fields are the section's first trajectory, the trajectory after the section, and the section's strategy.
    """

    begin: int
    end: int
    found: Recognition


class _Run(NamedTuple):
    """Consecutive sections at one depth that all clear areas, or are all contours, with their boxes, (2, 3) mm."""

    sections: list[CutSection]
    clears: bool
    boxes: list[np.ndarray]


def within_operations(toolpath: Toolpath, cut: Sequence[CutSection], doubtful: Collection[int]) -> set[int]:
    """Return the uncertain starts of operations between the clearing of an area and the contours finishing its walls.

    The finishing contours go around the whole cleared area, at the same depth as the clearing. Several contours finish
    the walls if there are islands, for example.

    Parameters
    ----------
    toolpath : Toolpath
    cut : sequence of CutSection
        The sections of the program.
    doubtful : collection of int
        Trajectories before which another operation possibly, but not certainly, begins.
    """
    found: set[int] = set()
    runs = _runs(toolpath, cut, doubtful)
    for one, two in zip(runs, runs[1:]):
        if one.clears is two.clears or not _meet(one.sections[-1], two.sections[0], doubtful):
            continue
        area, walls = (one, two) if one.clears else (two, one)
        low, high = np.min(area.boxes, axis=(0, 1)), np.max(area.boxes, axis=(0, 1))
        # Accept only contours around the cleared area that are cut directly before or after its clearing; other
        # contours can be another operation.
        outward = np.array(walls.boxes if area is one else walls.boxes[::-1])
        if abs(low[2] - outward[0, 0, 2]) > ROUNDING.HEIGHT:
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


def _runs(toolpath: Toolpath, cut: Sequence[CutSection], doubtful: Collection[int]) -> list[_Run]:
    """Group consecutive sections that clear an area, and consecutive sections that are contours."""
    runs: list[_Run] = []
    for section in cut:
        strategy = section.found.strategy
        clears = strategy.family is Family.ROWS or strategy is Strategy.ADAPTIVE
        # The finishing passes of two nested walls look like two offsets.
        offsets = strategy is Strategy.CONTOUR_PARALLEL and (section.found.passes or 0) <= PARTS.WALLS
        if not (clears or offsets or strategy is Strategy.PROFILE):
            continue
        box, last = _box(toolpath, section.found), runs[-1] if runs else None
        follows = last and last.clears is clears and _meet(last.sections[-1], section, doubtful)
        if last and follows and abs(last.boxes[-1][0, 2] - box[0, 2]) < ROUNDING.HEIGHT:
            last.sections.append(section)
            last.boxes.append(box)
        else:
            runs.append(_Run([section], clears, [box]))
    return runs


def _meet(one: CutSection, two: CutSection, doubtful: Collection[int]) -> bool:
    """Return whether the second section directly follows the first section, after an uncertain border."""
    return one.end == two.begin and two.begin in doubtful


def _box(toolpath: Toolpath, one: Recognition) -> np.ndarray:
    """Return the bounding box of a section's cutting moves, (2, 3): lower and upper corner, mm."""
    first, last = one.spans[0].first, one.spans[-1].last
    cut = np.flatnonzero(~toolpath.rapid[first : last + 1]) + first
    points = toolpath.points[np.union1d(cut, cut + 1)]
    return np.array([points.min(axis=0), points.max(axis=0)])
