# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a toolpath to the machining strategy it uses, with the evidence in the paper's terms."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.paper import Areas, PaperVerdict, monotonous_areas, paper_verdict
from vkworkbench.core.recognition.decide import decide
from vkworkbench.core.recognition.entries import find_entry
from vkworkbench.core.recognition.evidence import gather, sentence
from vkworkbench.core.recognition.footprints import count_depths
from vkworkbench.core.recognition.section import Section
from vkworkbench.core.recognition.thresholds import ENOUGH, PARTS, ROWS, VISITS, VOTES
from vkworkbench.core.recognition.verdict import Verdict, judge
from vkworkbench.core.recognition.visits import begun
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message, render


@dataclass(frozen=True)
class Span:
    """A stretch of an operation that follows one strategy.

    Attributes
    ----------
    first, last : int
        First and last trajectory, inclusive.
    first_command, last_command : int
        Their source commands.
    strategy : Strategy
    share : float
        Share of the operation's cutting length, 0..1.
    """

    first: int
    last: int
    first_command: int
    last_command: int
    strategy: Strategy
    share: float


@dataclass(frozen=True)
class Recognition:
    """What an operation does, told from its toolpath alone.

    Attributes
    ----------
    strategy : Strategy
    confidence : float
        How often verdicts with the same support are right, 0..1.
    why : Message
        In the paper's terms with the numbers.
    spans : tuple of Span
        In the order of cutting; more than one only where the strategy is mixed.
    level : int
        The level n of the paper reached, signed: whole turns of phi in one area, truncated toward zero.
    phi_range : tuple of float
        Lowest and highest phi reached in any area, rad, counted from the area's first trajectory, closing turns of loops
        included.
    reversals : int
        Exact reversals: turns of +-pi, which have no sign.
    sense : str or None
        Sense of rotation of the loops, "ccw" or "cw"; None where there is none or both.
    stepover : float or None
        Distance between neighbouring passes, mm.
    passes : int or None
        Number of rows or loops, all depths together.
    depths : int
        Number of depths at which whole moves are cut; 0 on sculptured surfaces, which have none.
    direction : float or None
        Direction of the rows, rad in [0, pi).
    closed_loops : int
        Number of loops that return to their first point.
    milling : str or None
        "climb" or "conventional" for nested loops cut by a spindle that turns clockwise (M3).
    entry : str or None
        How most of the depth is entered before the pattern: "plunge", "ramp", "zigzag ramp" or "helix"; None where the
        descent is the operation, and of mixed ones.
    paper : PaperVerdict or None
        What the paper's rule says to the letter, with V_k and its Gauss image; None where no move has a direction.
    """

    strategy: Strategy
    confidence: float
    why: Message
    spans: tuple[Span, ...] = ()
    level: int = 0
    phi_range: tuple[float, float] = (0.0, 0.0)
    reversals: int = 0
    sense: str | None = None
    stepover: float | None = None
    passes: int | None = None
    depths: int = 0
    direction: float | None = None
    closed_loops: int = 0
    milling: str | None = None
    entry: str | None = None
    paper: PaperVerdict | None = None

    @property
    def reason(self) -> str:
        """Why in English, one sentence without a full stop."""
        return render(self.why)


def recognize(toolpath: Toolpath, *, tool_diameter: float | None = None, program: bool = False) -> Recognition:
    """Recognise the machining strategy of an operation (paper, section 3; docs/recognition.md).

    Parameters
    ----------
    toolpath : Toolpath
        The linearised trajectories.
    tool_diameter : float, optional
        mm. Where it is unknown (None, 0, nan) the usual step between passes takes its place.
    program : bool
        Whether it may hold several operations that nothing parts but a retract, as an imported program does. One
        operation must not be divided so: it retracts, too.

    Returns
    -------
    Recognition
        With Strategy.EMPTY where nothing cuts. No toolpath raises.
    """
    rapid = toolpath.rapid
    if rapid.all():
        return Recognition(Strategy.EMPTY, 1.0, Message("only-rapids") if len(toolpath) else Message("no-moves"))
    tool = float(tool_diameter) if tool_diameter and np.isfinite(tool_diameter) and tool_diameter > 0 else 0.0
    moves = monotonous_areas(toolpath)
    first, last = int(np.argmin(rapid)), len(rapid) - 1 - int(np.argmin(rapid[::-1]))
    whole = _judge_one(toolpath, moves, first, last, tool)
    borders = _borders(toolpath, moves)
    if program:
        borders.update(dict.fromkeys(_told_apart(toolpath, borders, begun(toolpath, moves), tool), True))
    if not 0 < len(borders) <= PARTS.BORDERS:
        return whole
    return _judge_sections(toolpath, borders, whole, tool, program)


def _judge_one(toolpath: Toolpath, moves: Areas, first: int, last: int, tool: float) -> Recognition:
    """Recognise the trajectories first .. last as one operation."""
    if not len(moves):
        holes = len(moves.holes)
        strategy = Strategy.DRILLING
        why = (
            Message("vertical", count=holes, strategy=strategy)
            if holes
            else Message("vertical-somewhere", strategy=strategy)
        )
        spans = _spans(toolpath, [(first, last, strategy)])
        return Recognition(strategy, VOTES.SUREST, why, spans, passes=holes or None)
    section = Section(moves, tool)
    verdict, confidence = decide(section, judge(section))
    evidence = gather(section, verdict)
    why = sentence(section, verdict, evidence)
    runs = _runs(section, verdict) if verdict.parts else [(first, last, verdict.strategy)]
    spans = _spans(toolpath, runs)
    strategy = verdict.strategy
    entered = strategy.is_answer and strategy not in (Strategy.MIXED, Strategy.HELIX)
    entry = find_entry(moves) if entered else None
    evidence = {**vars(evidence), "reversals": len(moves.reversals), "entry": entry}
    return Recognition(strategy, confidence, why, spans, **evidence, paper=paper_verdict(moves))


def _runs(section: Section, verdict: Verdict) -> list[tuple[int, int, Strategy]]:
    """Return the stretches of loops and of rows in a mixed operation; a link belongs to what it follows."""
    of_rings, of_rows = verdict.parts
    is_ring = section.ring_pieces.copy()
    known = is_ring | section.row_pieces
    held = np.maximum.accumulate(np.where(known, np.arange(len(known)), 0))
    is_ring = is_ring[held]
    begin = np.flatnonzero(np.concatenate([[True], is_ring[1:] != is_ring[:-1]]))
    index, pieces = section.moves.index, section.pieces
    first = index[pieces.start[begin]]
    last = index[np.append(pieces.start[begin[1:]], len(index)) - 1]
    return [
        (int(a), int(b), of_rings.strategy if ring else of_rows.strategy)
        for a, b, ring in zip(first, last, is_ring[begin])
    ]


def _borders(toolpath: Toolpath, moves: Areas) -> dict[int, bool]:
    """Return the trajectories before which another operation may begin, and whether it certainly does.

    Tool changes and runs of drilled holes are certain; a comment is a hint.
    """
    comments = {int(at) for at, _ in toolpath.comments}
    borders = dict.fromkeys(comments, False) if len(comments) <= PARTS.BORDERS else {}
    borders.update((int(at), True) for at in toolpath.tool_changes)
    holes = moves.holes
    if len(moves) and len(holes) and len(holes) >= PARTS.DRILLED * len(moves.start) and not _sculptured(moves):
        # Holes with no milling between them are one run.
        place = np.searchsorted(moves.index, holes)
        begin = np.flatnonzero(np.append(True, place[1:] != place[:-1]))
        before = np.append(-1, moves.index)[place[begin]] + 1
        after = np.append(holes[begin[1:] - 1], holes[-1]) + 1
        borders.update(dict.fromkeys(np.concatenate([before, after]).tolist(), True))
    return {at: certain for at, certain in borders.items() if 0 < at < len(toolpath)}


def _told_apart(toolpath: Toolpath, borders: dict[int, bool], begun: dict[int, float], tool: float) -> list[int]:
    """Return the retracts that part operations: those that likely do, and those with clearly different verdicts beside.

    Parameters
    ----------
    borders : dict
        Other borders.
    begun : dict
        Where another operation may begin, and how likely it is.
    """
    doubtful = [at for at, share in begun.items() if share <= VISITS.BORDER]
    if not doubtful:
        return list(begun)
    beside = {}
    cutting = np.flatnonzero(~toolpath.rapid)
    at = sorted({*borders, *begun, 0, len(toolpath)})
    for a, b in zip(at, at[1:]):
        inside = cutting[np.searchsorted(cutting, a) : np.searchsorted(cutting, b)]
        if len(inside):
            first, last = int(inside[0]), int(inside[-1])
            one = _judge_one(toolpath, monotonous_areas(toolpath, first, last), first, last, tool)
            beside.setdefault(a, [None, None])[1] = beside.setdefault(b, [None, None])[0] = one
    return [at for at in begun if begun[at] > VISITS.BORDER or _clearly_differ(*beside.get(at, (None, None)))]


def _clearly_differ(one: Recognition | None, other: Recognition | None) -> bool:
    if one is None or other is None or not (one.strategy.is_answer and other.strategy.is_answer):
        return False
    return one.strategy is not other.strategy and one.confidence * other.confidence > VISITS.DIFFER


def _sculptured(moves: Areas) -> bool:
    """Whether there are too many heights for depths: then plunges are passes of a raster, clipped to a point."""
    return count_depths(moves.z[:: len(moves) // ROWS.SAMPLE + 1]) > PARTS.DEPTHS


def _judge_sections(toolpath, borders, whole: Recognition, tool: float, program: bool) -> Recognition:
    """Recognise the sections between the borders; mixed where they differ as much as their borders ask."""
    found, certainly = [], []
    cutting = np.flatnonzero(~toolpath.rapid)
    at = sorted(borders)
    parts = 0  # what certain borders part, so far
    for a, b in zip([0, *at], [*at, len(toolpath)]):
        parts += borders.get(a, False)
        inside = cutting[np.searchsorted(cutting, a) : np.searchsorted(cutting, b)]
        if len(inside):
            first, last = int(inside[0]), int(inside[-1])
            found.append(_judge_one(toolpath, monotonous_areas(toolpath, first, last), first, last, tool))
            certainly.append(parts)
    length = np.array([sum(_lengths(toolpath, s.first, s.last) for s in r.spans) for r in found])
    share = length / length.sum()
    main = int(np.argmax(share))
    # A border between a section and the longest one counts the same whichever of the two comes first.
    certain = np.array(certainly) != certainly[main]
    differs = np.array([_differs(r, found[main], sure) for r, sure in zip(found, certain)])
    drilled = np.array([r.strategy is Strategy.DRILLING for r in found])  # holes have next to no length
    enough = drilled | (share > PARTS.CERTAIN) if program else drilled
    if share[differs].sum() < PARTS.ASIDE and not (differs & certain & enough).any():
        return _agree(toolpath, whole, found, share)
    runs = _joined([_one_span(r) for r in found] if program else found)
    names = list(dict.fromkeys(strategy for _, _, strategy in runs))
    why = Message("sections", count=len(runs), strategies=names, strategy=Strategy.MIXED)
    confidence = float((share * [r.confidence for r in found]).sum())
    return replace(
        whole, strategy=Strategy.MIXED, confidence=confidence, why=why, entry=None, spans=_spans(toolpath, runs)
    )


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


def _joined(found: list[Recognition]) -> list[tuple[int, int, Strategy]]:
    """Return the spans of consecutive sections as (first, last, strategy), equal neighbours as one."""
    runs: list[tuple[int, int, Strategy]] = []
    for r in found:
        for s in r.spans:
            if runs and runs[-1][2] is s.strategy:
                runs[-1] = (runs[-1][0], s.last, s.strategy)
            else:
                runs.append((s.first, s.last, s.strategy))
    return runs


def _agree(toolpath, whole: Recognition, found: list[Recognition], share: np.ndarray) -> Recognition:
    """Return the verdict on the whole; the longest section's where every section says another than the whole.

    A section too short to show a strategy of its own does not count: the loops of a waterline and the rows of a
    zigzag may each have a title.
    """
    told = [k for k, r in enumerate(found) if r.strategy is not Strategy.UNKNOWN and not _short(r)]
    if not told or whole.strategy in {found[k].strategy for k in told}:
        return whole
    longest = found[max(told, key=lambda k: share[k])]
    runs = [(found[0].spans[0].first, found[-1].spans[-1].last, longest.strategy)]
    if longest.strategy is Strategy.MIXED:
        runs = _joined(found)
    return replace(longest, spans=_spans(toolpath, runs))


def _short(one: Recognition) -> bool:
    """Whether a section is too little to show a strategy."""
    return one.closed_loops < 2 and (one.passes or 0) < 3


def _differs(one: Recognition, main: Recognition, certain: bool) -> bool:
    """Whether a section is another operation than the main one.

    Where a tool change parts them, another strategy is another operation. A comment alone divides only strategies of
    different families: FreeCAD titles the passes of one operation, and the roughing and the finishing pass of one
    pocket are a contour-parallel and a profile.
    """
    if Strategy.UNKNOWN in (one.strategy, main.strategy):
        return False
    if not one.closed_loops and (one.passes or 0) < 3:
        return False  # too little to show a strategy
    if certain:
        return one.strategy is not main.strategy
    families = {one.strategy.family, main.strategy.family}
    return len(families) > 1 and Family.STROKES not in families


def _lengths(toolpath: Toolpath, first: int, last: int) -> float:
    """Cutting length of the trajectories first .. last, mm."""
    steps = np.diff(toolpath.points[first : last + 2], axis=0)[~toolpath.rapid[first : last + 1]]
    return float(np.sqrt((steps * steps).sum(axis=1)).sum())


def _spans(toolpath: Toolpath, runs: list[tuple[int, int, Strategy]]) -> tuple[Span, ...]:
    length = [_lengths(toolpath, first, last) for first, last, _ in runs] if len(runs) > 1 else [1.0]
    total = sum(length) or 1.0
    command = toolpath.command
    return tuple(
        Span(first, last, int(command[first]), int(command[last]), strategy, part / total)
        for (first, last, strategy), part in zip(runs, length)
    )
