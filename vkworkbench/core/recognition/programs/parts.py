# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a program: where it is divided, and when its parts are different operations."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from vkworkbench.core.gcode import title_of
from vkworkbench.core.paper import Areas, monotonous_areas
from vkworkbench.core.recognition.patterns.footprints import count_depths, number_depths
from vkworkbench.core.recognition.programs.finishing import Cut, within_operations
from vkworkbench.core.recognition.thresholds import ENOUGH, PARTS, ROWS, SAME, VISITS
from vkworkbench.core.recognition.verdict.operation import cutting_length, recognize_one, spans_of
from vkworkbench.core.recognition.verdict.recognition import Recognition
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message


def find_borders(toolpath: Toolpath, moves: Areas) -> dict[int, bool]:
    """Return the trajectories before which another operation may begin, and whether it certainly does.

    Tool changes and runs of drilled holes are certain; a comment that is a title is a hint, a remark none.
    """
    comments = {int(at) for at, text in toolpath.comments if title_of(text)}
    borders = dict.fromkeys(comments, False) if len(comments) <= PARTS.BORDERS else {}
    borders.update((int(at), True) for at in toolpath.tool_changes)
    holes = moves.holes
    if len(holes) < PARTS.DRILLED * len(moves.start) or _sculptured(moves) or _in_layers(toolpath, moves):
        holes = holes[toolpath.cycle[holes]]  # a canned cycle drills, whatever there is beside it
    if len(moves) and len(holes):
        # Holes with no milling between them are one run.
        place = np.searchsorted(moves.index, holes)
        begin = np.flatnonzero(np.append(True, place[1:] != place[:-1]))
        # They part at a rapid: a steep lift behind what is milled, or out of a tapped hole, goes on with it.
        milled = moves.index[place[begin[place[begin] > 0]] - 1]
        rapids = np.append(np.flatnonzero(toolpath.rapid), len(toolpath))
        parted = rapids[np.searchsorted(rapids, np.concatenate([milled, holes[begin[1:] - 1], holes[-1:]]))]
        borders.update(dict.fromkeys(parted.tolist(), True))
    return {at: certain for at, certain in borders.items() if 0 < at < len(toolpath)}


def _sculptured(moves: Areas) -> bool:
    """Whether there are too many heights for depths: then plunges are passes of a raster, clipped to a point."""
    return count_depths(moves.z[:: len(moves) // ROWS.SAMPLE + 1]) > PARTS.DEPTHS


def _in_layers(toolpath: Toolpath, moves: Areas) -> bool:
    """Whether most plunge elsewhere, to several depths of the milling: contours of a surface, clipped to a point."""
    bottom = toolpath.points[moves.holes + 1]
    depth = number_depths(np.concatenate([bottom[:, 2], moves.z[moves.start]]))
    drilled, milled = set(depth[: len(bottom)].tolist()), set(depth[len(bottom) :].tolist())
    if len(drilled) < PARTS.LAYERS or not drilled <= milled:
        return False
    places = np.unique(np.rint(bottom[:, :2] / SAME.PLACE), axis=0)
    return len(places) > ENOUGH.SHARE * len(bottom)


class Sections:
    """What a toolpath cuts between borders; each stretch is recognised once, however often it is asked for.

    Parameters
    ----------
    toolpath : Toolpath
    tool : float
        Tool diameter, mm; 0 where unknown.
    """

    def __init__(self, toolpath: Toolpath, tool: float) -> None:
        self.toolpath = toolpath
        self._tool = tool
        self._cutting = np.flatnonzero(~toolpath.rapid)
        self._known: dict[tuple[int, int], Recognition] = {}

    def between(self, borders: Iterable[int]) -> Iterator[Cut]:
        """Yield the sections between some borders; none where nothing is cut."""
        at = sorted({0, *borders, len(self.toolpath)})
        ends = zip(at, at[1:], np.searchsorted(self._cutting, at), np.searchsorted(self._cutting, at[1:]))
        for a, b, begin, end in ends:
            if begin < end:
                yield Cut(a, b, self._recognized(int(self._cutting[begin]), int(self._cutting[end - 1])))

    def _recognized(self, first: int, last: int) -> Recognition:
        if (first, last) not in self._known:
            moves = monotonous_areas(self.toolpath, first, last)
            self._known[first, last] = recognize_one(self.toolpath, moves, first, last, self._tool)
        return self._known[first, last]


def told_apart(sections: Sections, borders: Collection[int], begun: dict[int, float]) -> list[int]:
    """Return the retracts that part operations: those that likely do, and those with clearly different verdicts beside.

    Parameters
    ----------
    sections : Sections
        Of the program.
    borders : collection of int
        Other borders.
    begun : dict
        Where another operation may begin, and how likely it is.
    """
    if not begun:
        return []
    cut = list(sections.between((*borders, *begun)))
    beside = [(one, two) for one, two in zip(cut, cut[1:]) if one.end == two.begin and two.begin in begun]
    pairs = {two.begin: (one.found, two.found) for one, two in beside}
    names = {
        at: frozenset(one.strategy for one in pair)
        for at, pair in pairs.items()
        if begun[at] <= VISITS.BORDER and _odds(begun[at]) * _differing(*pair) > VISITS.DIFFER
    }
    times = Counter(names.values())
    # Two patterns that take turns are one operation, depth after depth or place after place.
    told = {at for at, pair in names.items() if times[pair] < PARTS.TURNS}
    told |= {at for at, share in begun.items() if share > VISITS.BORDER}
    # So are a pattern and the contours that finish its walls.
    told -= within_operations(sections.toolpath, cut, {at for at in begun if begun[at] < VISITS.SURE})
    return [at for at in begun if at in told]


def _differing(one: Recognition, other: Recognition) -> float:
    """Return the odds that two sections are different operations, told by their verdicts; 0 where those may be one."""
    if not (one.strategy.is_answer and other.strategy.is_answer):
        return 0.0
    # Adaptive clearing winds where its place is round.
    if one.strategy is other.strategy or {one.strategy, other.strategy} == {Strategy.ADAPTIVE, Strategy.SPIRAL}:
        return 0.0
    return _odds(one.confidence * other.confidence)


def _odds(share: float) -> float:
    return share / (1 - share)


def recognize_parts(sections: Sections, borders: Mapping[int, bool], whole: Recognition, program: bool) -> Recognition:
    """Recognise the sections between the borders; mixed where they differ as much as their borders ask."""
    toolpath, cut = sections.toolpath, list(sections.between(borders))
    found = [one for *_, one in cut]
    parts = np.cumsum([certain for _, certain in sorted(borders.items())])  # what certain borders part, so far
    certainly = np.append(0, parts)[np.searchsorted(sorted(borders), [a for a, *_ in cut], side="right")]
    length = np.array([sum(cutting_length(toolpath, s.first, s.last) for s in r.spans) for r in found])
    share = length / length.sum()
    main = int(np.argmax(share))
    # A border between a section and the longest one counts the same whichever of the two comes first.
    certain = certainly != certainly[main]
    # Two pockets that a program cuts one after the other are two operations; what FreeCAD titles within one is not.
    operation = certainly if program else np.zeros_like(certainly)
    differs = np.array([_differs(r, found[main], sure, program) for r, sure in zip(found, certain)])
    drilled = np.array([r.strategy is Strategy.DRILLING for r in found])  # holes have next to no length
    enough = drilled | (share > PARTS.CERTAIN) if program else drilled
    little = bool(share[differs].sum() < PARTS.ASIDE)
    if little and not (differs & certain & enough).any():
        return _agree(toolpath, whole, found, share, operation)
    runs = _joined([_one_span(r) for r in found] if program else found, operation)
    spans = spans_of(toolpath, runs)
    names = list(dict.fromkeys(strategy for _, _, strategy in runs))
    change = np.searchsorted(np.sort(toolpath.tool_changes), [a for a, *_ in cut], side="right")
    if little and (change[differs] == change[main]).all():
        # What one tool cuts beside the pattern, however surely, does not take its name away.
        pattern = whole if whole.strategy is found[main].strategy else found[main]
        others = [name for name in names if name is not pattern.strategy]
        # None where rows with a contour around them are the rows that the pattern is.
        why = Message("with-others", told=pattern.why, strategies=others) if others else pattern.why
        return replace(pattern, why=why, spans=spans)
    why = Message("sections", count=len(runs), strategies=names, strategy=Strategy.MIXED)
    confidence = float((share * [r.confidence for r in found]).sum())
    return replace(whole, strategy=Strategy.MIXED, confidence=confidence, why=why, entry=None, spans=spans)


def _one_span(one: Recognition) -> Recognition:
    """Return an operation of a program as one span; rows with a contour around them are rows with a finishing pass."""
    if len(one.spans) < 2:
        return one
    share = sum(s.share for s in one.spans if s.strategy.family is Family.ROWS)
    rows = max((s for s in one.spans), key=lambda s: s.share if s.strategy.family is Family.ROWS else -1.0).strategy
    strategy = rows if share > ENOUGH.SHARE else one.strategy
    first, last = one.spans[0], one.spans[-1]
    span = replace(first, last=last.last, last_command=last.last_command, strategy=strategy, share=1.0)
    return replace(one, spans=(span,))


def _joined(found: list[Recognition], operation: np.ndarray) -> list[tuple[int, int, Strategy]]:
    """Return the spans of consecutive sections as (first, last, strategy), equal neighbours of one operation as one.

    Parameters
    ----------
    found : list of Recognition
    operation : (k,) int
        Number of the operation that each section belongs to, ascending.
    """
    runs: list[tuple[int, int, Strategy]] = []
    for r, begins in zip(found, np.diff(operation, prepend=operation[0]) > 0):
        for k, s in enumerate(r.spans):
            if runs and runs[-1][2] is s.strategy and not (begins and k == 0):
                runs[-1] = (runs[-1][0], s.last, s.strategy)
            else:
                runs.append((s.first, s.last, s.strategy))
    return runs


def _agree(
    toolpath: Toolpath, whole: Recognition, found: list[Recognition], share: np.ndarray, operation: np.ndarray
) -> Recognition:
    """Return the verdict on the whole; the longest section's where every section says another than the whole.

    A section too short to show a strategy of its own does not count: the loops of a waterline and the rows of a
    zigzag may each have a title. Nor do a few holes, or what little is known, speak for all the rest.
    """
    told = [k for k, r in enumerate(found) if r.strategy is not Strategy.UNKNOWN and not _short(r, 2)]
    if share[told].sum() < ENOUGH.SHARE or whole.strategy in {found[k].strategy for k in told}:
        return whole
    longest = found[max(told, key=lambda k: share[k])]
    runs = [(found[0].spans[0].first, found[-1].spans[-1].last, longest.strategy)]
    if longest.strategy is Strategy.MIXED:
        runs = _joined(found, operation)
    return replace(longest, spans=spans_of(toolpath, runs))


def _short(one: Recognition, loops: int) -> bool:
    """Whether a section with fewer loops than that is too little to show a strategy.

    One loop is enough to be another operation than rows; to gainsay the verdict on the whole it takes two.
    """
    return one.closed_loops < loops and (one.passes or 0) < PARTS.PASSES


def _differs(one: Recognition, main: Recognition, certain: bool, program: bool) -> bool:
    """Whether a section is another operation than the main one.

    Where a tool change parts them, another strategy is another operation. A comment alone divides only strategies of
    different families: FreeCAD titles the passes of one operation, and the roughing and the finishing pass of one
    pocket are a contour-parallel and a profile.
    """
    if Strategy.UNKNOWN in (one.strategy, main.strategy):
        return False
    if certain and program:
        return one.strategy is not main.strategy
    if _short(one, 1):
        return False
    if certain:
        return one.strategy is not main.strategy
    families = {one.strategy.family, main.strategy.family}
    return len(families) > 1 and Family.STROKES not in families
