# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise one operation: entry, pattern, finishing pass, and the numbers that support the strategy."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import Areas, paper_verdict
from vkworkbench.core.recognition.patterns.entries import find_entry
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict.decide import decide
from vkworkbench.core.recognition.verdict.evidence import gather_evidence, reason_of
from vkworkbench.core.recognition.verdict.recognition import Recognition, Span
from vkworkbench.core.recognition.verdict.rules import Verdict, judge_section
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message

ENTERED = {
    "ramp": Message("entered-by-ramp"),
    "zigzag ramp": Message("entered-by-zigzag-ramp"),
    "helix": Message("entered-by-helix"),
}
FINISHED = {Family.ROWS: Message("finished-by-contour"), Family.AROUND: Message("finished-by-loop")}


def recognize_one(toolpath: Toolpath, moves: Areas, first: int, last: int, tool: float) -> Recognition:
    """Recognise the trajectories `first` to `last` as one operation. `tool` is the diameter, mm; 0 if unknown."""
    if not len(moves):
        holes = len(moves.holes)
        strategy = Strategy.DRILLING
        why = (
            Message("vertical", count=holes, strategy=strategy)
            if holes
            else Message("vertical-somewhere", strategy=strategy)
        )
        spans = spans_of(toolpath, [(first, last, strategy)])
        return Recognition(strategy, VOTES.SUREST, why, spans, passes=holes or None)
    section = Section(moves, tool)
    paper = paper_verdict(moves)
    verdict, confidence = decide(section, judge_section(section), paper)
    evidence = gather_evidence(section, verdict)
    why = reason_of(section, verdict, evidence)
    runs = _runs(section, verdict, first, last) if verdict.parts else [(first, last, verdict.strategy)]
    spans = spans_of(toolpath, runs)
    strategy = verdict.strategy
    entered = strategy.is_answer and strategy not in (Strategy.MIXED, Strategy.HELIX)
    z = toolpath.points[: last + 2, 2]
    entry = find_entry(moves) if entered and (z[1:] < z[:-1]).any() else None
    finishing = verdict.finished and strategy.family is Family.ROWS
    finishing |= strategy is Strategy.ADAPTIVE and section.ends_with_contour()
    numbers = {**vars(evidence), "entry": entry, "finishing": finishing}
    why = _with_layers(why, entry, FINISHED[strategy.family] if finishing else None)
    return Recognition(strategy, confidence, why, spans, **numbers, paper=paper)


def _with_layers(why: Message, entry: str | None, finishing: Message | None) -> Message:
    """Return the reason for the strategy, with the kind of entry (except plunges) and the finishing pass added."""
    way = ENTERED.get(entry or "")
    return Message("with-layers", told=why, entry=way, finishing=finishing) if way or finishing else why


def _runs(section: Section, verdict: Verdict, first: int, last: int) -> list[tuple[int, int, Strategy]]:
    """Divide the trajectories `first` to `last` of a mixed operation into stretches of loops and stretches of rows.

    A link between loops or rows belongs to the stretch before the link. A lead-in belongs to the stretch after the
    lead-in.
    """
    of_rings, of_rows = verdict.parts
    is_ring = section.ring_pieces.copy()
    known = is_ring | section.row_pieces
    held = np.maximum.accumulate(np.where(known, np.arange(len(known)), np.argmax(known)))
    is_ring = is_ring[held]
    begin = np.flatnonzero(np.concatenate([[True], is_ring[1:] != is_ring[:-1]]))
    index, pieces = section.moves.index, section.pieces
    firsts = [first, *index[pieces.start[begin[1:]]].tolist()]
    lasts = [*index[pieces.start[begin[1:]] - 1].tolist(), last]
    return [
        (a, b, of_rings.strategy if ring else of_rows.strategy) for a, b, ring in zip(firsts, lasts, is_ring[begin])
    ]


def cutting_length(toolpath: Toolpath, first: int, last: int) -> float:
    """Return the cutting length of the trajectories `first` to `last`, mm."""
    steps = np.diff(toolpath.points[first : last + 2], axis=0)[~toolpath.rapid[first : last + 1]]
    return float(np.sqrt((steps * steps).sum(axis=1)).sum())


def spans_of(toolpath: Toolpath, runs: list[tuple[int, int, Strategy]]) -> tuple[Span, ...]:
    """Return stretches (first, last, strategy) as spans with their shares of the cutting length."""
    length = [cutting_length(toolpath, first, last) for first, last, _ in runs] if len(runs) > 1 else [1.0]
    total = sum(length) or 1.0
    command = toolpath.command
    return tuple(
        Span(first, last, int(command[first]), int(command[last]), strategy, part / total)
        for (first, last, strategy), part in zip(runs, length)
    )


def unknown(toolpath: Toolpath, why: Message) -> Recognition:
    """Return an unknown strategy with its reason, for a toolpath with at least one trajectory."""
    spans = spans_of(toolpath, [(0, len(toolpath) - 1, Strategy.UNKNOWN)])
    return Recognition(Strategy.UNKNOWN, 0.0, why, spans)
