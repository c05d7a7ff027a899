# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide an NC program into parts, and decide whether the parts are different operations."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from vkworkbench.core.gcode import title_of
from vkworkbench.core.paper import Areas, monotonous_areas
from vkworkbench.core.recognition.patterns.footprints import count_depths
from vkworkbench.core.recognition.thresholds import MAJORITY, PARTS, ROWS, VISITS
from vkworkbench.core.recognition.verdict.operation import cutting_length, recognize_one, spans_of
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message


class CutSection(NamedTuple):
    """A section of a program between two borders (possible starts of operations).

    The fields are the section's first trajectory, the trajectory after the section, and the section's strategy.
    """

    begin: int
    end: int
    found: Recognition


def find_borders(toolpath: Toolpath, moves: Areas) -> dict[int, bool]:
    """Return the borders (trajectories before which another operation can begin), and whether each border is certain.

    Tool changes, and both ends of a run of drilled holes, are certain borders. A comment that is a title is an
    uncertain border. Comments that are not titles are ignored.
    """
    comments = {int(at) for at, text in toolpath.comments if title_of(text)}
    borders = dict.fromkeys(comments, False) if len(comments) <= PARTS.BORDERS else {}
    borders.update((int(at), True) for at in toolpath.tool_changes)
    holes = moves.holes
    if len(holes) < PARTS.DRILLED * len(moves.start) or _sculptured(moves):
        holes = holes[toolpath.cycle[holes]]  # a canned cycle always drills
    if len(moves) and len(holes):
        # Holes form one run if there is no milling between them.
        place = np.searchsorted(moves.index, holes)
        begin = np.flatnonzero(np.append(True, place[1:] != place[:-1]))
        # The next operation begins at a rapid and not at a lift, because a steep lift after milling or tapping is part
        # of the operation before.
        milled = moves.index[place[begin[place[begin] > 0]] - 1]
        rapids = np.append(np.flatnonzero(toolpath.rapid), len(toolpath))
        parted = rapids[np.searchsorted(rapids, np.concatenate([milled, holes[begin[1:] - 1], holes[-1:]]))]
        borders.update(dict.fromkeys(parted.tolist(), True))
    return {at: certain for at, certain in borders.items() if 0 < at < len(toolpath)}


def is_titled(toolpath: Toolpath, first: int) -> bool:
    """Return whether one title and all tool changes come before the first cut, so that the program is one operation."""
    titles = [at for at, text in toolpath.comments if title_of(text)]
    return len(titles) == 1 and titles[0] <= first and bool((toolpath.tool_changes <= first).all())


def without_lone_plunge(toolpath: Toolpath, moves: Areas) -> Areas:
    """Return the areas in which few plunges beside milling are not holes, as they park the tool or touch the stock."""
    if not len(moves) or len(moves.holes) >= PARTS.HOLES:
        return moves
    return replace(moves, holes=moves.holes[toolpath.cycle[moves.holes]])


def _sculptured(moves: Areas) -> bool:
    """Return whether a surface is cut at many heights.

    Plunges on a surface are not holes, but passes of a raster that the boundary shortens to a point.
    """
    return count_depths(moves.z[:: len(moves) // ROWS.SAMPLE + 1]) > PARTS.DEPTHS


class Sections:
    """The parts of a toolpath between borders (possible starts of operations).

    Each section is recognised once and cached.

    Parameters
    ----------
    toolpath : Toolpath
    tool : float
        Tool diameter, mm; 0 if unknown.
    """

    def __init__(self, toolpath: Toolpath, tool: float) -> None:
        self.toolpath = toolpath
        self._tool = tool
        self._cutting = np.flatnonzero(~toolpath.rapid)
        self._known: dict[tuple[int, int], Recognition] = {}

    def between(self, borders: Iterable[int]) -> Iterator[CutSection]:
        """Yield the sections between the given borders and between the ends of the toolpath.

        Sections in which nothing is cut are left out.
        """
        at = sorted({0, *borders, len(self.toolpath)})
        ends = zip(at, at[1:], np.searchsorted(self._cutting, at), np.searchsorted(self._cutting, at[1:]))
        for a, b, begin, end in ends:
            if begin < end:
                yield CutSection(a, b, self._recognized(int(self._cutting[begin]), int(self._cutting[end - 1])))

    def _recognized(self, first: int, last: int) -> Recognition:
        if (first, last) not in self._known:
            moves = monotonous_areas(self.toolpath, first, last)
            self._known[first, last] = recognize_one(self.toolpath, moves, first, last, self._tool)
        return self._known[first, last]


def dividing_retracts(sections: Sections, borders: Collection[int], retracts: dict[int, float]) -> list[int]:
    """Return the retracts that separate two operations.

    A retract separates operations if the probability that another operation begins after the retract is high. A retract
    with a lower probability separates operations if clearly different strategies are recognised before and after the
    retract.

    Parameters
    ----------
    sections : Sections
        Sections of the program.
    borders : collection of int
        Borders (possible starts of other operations) that are not retracts.
    retracts : dict
        Trajectories of retracts after which another operation can begin, with probabilities.
    """
    if not retracts:
        return []
    cuts = list(sections.between((*borders, *retracts)))
    neighbours = [(one, two) for one, two in zip(cuts, cuts[1:]) if one.end == two.begin and two.begin in retracts]
    pairs = {two.begin: (one.found, two.found) for one, two in neighbours}
    names = {
        at: frozenset(one.strategy for one in pair)
        for at, pair in pairs.items()
        if retracts[at] <= VISITS.BORDER and _odds(retracts[at]) * _odds_of_difference(*pair) > VISITS.DIFFER
    }
    times = Counter(names.values())
    # If a program alternates between two strategies, at each depth or at each place, both strategies are one operation.
    dividing = {at for at, pair in names.items() if times[pair] < PARTS.TURNS}
    dividing |= {at for at, probability in retracts.items() if probability > VISITS.BORDER}
    return [at for at in retracts if at in dividing]


def _odds_of_difference(one: Recognition, other: Recognition) -> float:
    """Return the odds that two sections of a program are different operations.

    If both strategies can occur in one operation, the odds are 0.
    """
    if not (one.strategy.is_answer and other.strategy.is_answer):
        return 0.0
    # The two strategies can be one operation, because adaptive clearing of a round pocket winds like a spiral.
    if one.strategy is other.strategy or {one.strategy, other.strategy} == {Strategy.ADAPTIVE, Strategy.SPIRAL}:
        return 0.0
    return _odds(one.confidence * other.confidence)


def _odds(share: float) -> float:
    return share / (1 - share)


def recognize_parts(sections: Sections, borders: Mapping[int, bool], whole: Recognition, program: bool) -> Recognition:
    """Recognise the sections between the given borders (possible starts of operations).

    The result is the strategy MIXED if sections are long enough and clearly differ.
    """
    toolpath, cuts = sections.toolpath, list(sections.between(borders))
    found = [cut.found for cut in cuts]
    stretch = _stretches(borders, cuts)
    share = _shares(toolpath, found)
    main = int(np.argmax(share))
    differs = np.array([
        _differs(one, found[main], apart, program) for one, apart in zip(found, stretch != stretch[main])
    ])  # fmt: skip
    # In an NC program, each stretch between two certain borders, such as tool changes, is an operation. In a single
    # FreeCAD operation, titles do not begin another operation.
    operation = stretch if program else np.zeros_like(stretch)
    little = bool(share[differs].sum() < PARTS.ASIDE)
    if little and not (differs & (stretch != stretch[main]) & _is_enough(found, share, program)).any():
        return _agree(toolpath, whole, found, share, operation)
    runs = _joined(found, operation)
    spans = spans_of(toolpath, runs)
    names = list(dict.fromkeys(strategy for _, _, strategy in runs))
    tool_changes = np.searchsorted(np.sort(toolpath.tool_changes), [cut.begin for cut in cuts], side="right")
    if little and (tool_changes[differs] == tool_changes[main]).all():
        # A few other cuts with the same tool do not change the strategy of the program.
        pattern = whole if whole.strategy is found[main].strategy else found[main]
        others = [name for name in names if name is not pattern.strategy]
        # Short sections can have the strategy of the program, so that there is no other strategy to report.
        why = Message("with-others", told=pattern.why, strategies=others) if others else pattern.why
        return replace(pattern, why=why, spans=spans)
    why = Message("sections", count=len(runs), strategies=names, strategy=Strategy.MIXED)
    confidence = float((share * [one.confidence for one in found]).sum())
    return replace(whole, strategy=Strategy.MIXED, confidence=confidence, why=why, entry=None, spans=spans)


def _stretches(borders: Mapping[int, bool], cuts: list[CutSection]) -> np.ndarray:
    """Return for each section the number of certain borders (starts of operations) before it, (k,) int."""
    certain = np.append(0, np.cumsum([is_certain for _, is_certain in sorted(borders.items())]))
    return certain[np.searchsorted(sorted(borders), [cut.begin for cut in cuts], side="right")]


def _shares(toolpath: Toolpath, found: list[Recognition]) -> np.ndarray:
    """Return each section's share of the program's cutting length, (k,)."""
    length = np.array([sum(cutting_length(toolpath, s.first, s.last) for s in one.spans) for one in found])
    return length / length.sum()


def _is_enough(found: list[Recognition], share: np.ndarray, program: bool) -> np.ndarray:
    """Return whether each section of a program is long enough for an operation, (k,) bool.

    Sections of drilled holes are always long enough.
    """
    drilled = np.array([one.strategy is Strategy.DRILLING for one in found])
    return drilled | (share > PARTS.CERTAIN) if program else drilled


def _joined(found: list[Recognition], operation: np.ndarray) -> list[tuple[int, int, Strategy]]:
    """Return the stretches with one strategy as (first, last, strategy), equal neighbours in one operation joined.

    Parameters
    ----------
    found : list of Recognition
    operation : (k,) int
        Number of each section's operation, ascending.
    """
    runs: list[tuple[int, int, Strategy]] = []
    for one, begins in zip(found, np.diff(operation, prepend=operation[0]) > 0):
        for k, span in enumerate(one.spans):
            if runs and runs[-1][2] is span.strategy and not (begins and k == 0):
                runs[-1] = (runs[-1][0], span.last, span.strategy)
            else:
                runs.append((span.first, span.last, span.strategy))
    return runs


def _agree(
    toolpath: Toolpath, whole: Recognition, found: list[Recognition], share: np.ndarray, operation: np.ndarray
) -> Recognition:
    """Return the strategy of the whole program, or of its longest section if all sections have other strategies.

    Sections that are too short to show a strategy are ignored, because some programs give a title to each loop of a
    waterline or to each row of a zigzag. Sections can only contradict the strategy of the whole program if together
    they have at least half of the program's length.
    """
    clear = [k for k, r in enumerate(found) if r.strategy is not Strategy.UNKNOWN and not _short(r, 2)]
    if share[clear].sum() < MAJORITY.SHARE or whole.strategy in {found[k].strategy for k in clear}:
        return whole
    longest = found[max(clear, key=lambda k: share[k])]
    runs = [(found[0].spans[0].first, found[-1].spans[-1].last, longest.strategy)]
    if longest.strategy is Strategy.MIXED:
        runs = _joined(found, operation)
    return replace(longest, spans=spans_of(toolpath, runs))


def _short(one: Recognition, loops: int) -> bool:
    """Return whether a section of a program has fewer than `loops` loops and too few passes to show a strategy.

    One loop is enough to show that a section beside rows is another operation. Two loops are needed to contradict the
    strategy recognised for the whole program.
    """
    return one.closed_loops < loops and (one.passes or 0) < PARTS.PASSES


def _differs(one: Recognition, main: Recognition, apart: bool, program: bool) -> bool:
    """Return whether a section of a program is another operation than the longest section.

    After a certain border, such as a tool change, a section with another strategy is another operation. A comment alone
    divides only strategies of different families, because FreeCAD gives titles to the passes of one operation. For
    example, the roughing of a pocket is contour-parallel, and its finishing pass is a profile.
    """
    if Strategy.UNKNOWN in (one.strategy, main.strategy):
        return False
    if apart and program:
        return one.strategy is not main.strategy
    if _short(one, 1):
        return False
    if apart:
        return one.strategy is not main.strategy
    families = {one.strategy.family, main.strategy.family}
    return len(families) > 1 and Family.STROKES not in families
