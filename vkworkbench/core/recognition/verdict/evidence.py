# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collect the numbers that support a recognised strategy, and give the reason for it in the paper's terms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import farthest
from vkworkbench.core.recognition.patterns.footprints import count_depths
from vkworkbench.core.recognition.patterns.pieces import LOOP
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import ENTRY, MAJORITY, NEGLIGIBLE, RINGS, ROUNDING
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.language import ENGLISH, Message


@dataclass(frozen=True)
class Evidence:
    """The numbers that support the strategy of a section.

    `Recognition` documents the attributes, which have the same names there.
    """

    level: int
    phi_range: tuple[float, float]
    reversals: int
    sense: str | None
    stepover: float | None
    passes: int | None
    depths: int
    direction: float | None
    closed_loops: int
    milling: str | None


def gather_evidence(section: Section, verdict: Verdict) -> Evidence:
    """Return the numbers that support the strategy of a section."""
    around = verdict.strategy.family is Family.AROUND or not section.rows
    rings, rows = section.rings, section.rows
    main = max(rows, key=lambda f: f.length) if rows else None
    sense = milling = stepover = passes = None
    if len(rings) and around:
        turned = float((np.sign(section.pieces.net[rings.index]) * rings.length).sum() / rings.length.sum())
        sense = "ccw" if turned > MAJORITY.SHARE else "cw" if turned < -MAJORITY.SHARE else None
        passes = len(rings)
        if np.isfinite(rings.step) and verdict.strategy is not Strategy.PROFILE:
            stepover = rings.step
            if sense and max(rings.growing, 1 - rings.growing) > RINGS.ONE_WAY:
                # In climb milling, uncut material is to the right of the tool. If counter-clockwise loops grow
                # outwards, the uncut material outside the loops is to the right.
                milling = "climb" if (rings.growing > 0.5) == (sense == "ccw") else "conventional"
    elif main:
        # In a grid, rows cut one after the other need not be neighbours, so that the stepover is the distance at which
        # the rows repeat.
        passes, stepover = sum(f.count for f in rows), main.step
        longest = max(section.families, key=lambda f: f.length)
        if len(rows) > 1 or sum(f.length for f in section.families) > (1 + MAJORITY.SHARE) * longest.length:
            stepover = longest.period
    if verdict.step and not stepover:
        passes, stepover = verdict.count, verdict.step
    return Evidence(
        level=section.areas.top_level,
        phi_range=section.areas.phi_range,
        reversals=len(section.areas.reversals),
        sense=sense,
        stepover=stepover,
        passes=passes,
        depths=count_depths(_heights(section, verdict.strategy)),
        direction=main.axis if main and not around else None,
        closed_loops=int((section.pieces.kind == LOOP).sum()),
        milling=milling,
    )


def _heights(section: Section, strategy: Strategy) -> np.ndarray:
    """Return the heights of nearly horizontal loops, zigzags and strokes, without ramps and helical leads, (k,) mm.

    A zigzag that ramps to several depths without a lift is one piece and has several heights.
    """
    pieces, moves = section.pieces, section.moves
    counts = pieces.length > NEGLIGIBLE.PIECE * pieces.length.max()
    if strategy is Strategy.HELIX:
        counts &= section.ring_pieces
    flat: np.ndarray = pieces.z[counts & pieces.flat]
    if pieces.flat.all():
        return flat
    # If a piece has ramps or is lifted over tags, use the heights of its horizontal moves.
    level = np.flatnonzero(
        np.repeat(counts & ~pieces.flat, pieces.end - pieces.start) & (np.abs(moves.dz) < ROUNDING.HEIGHT)
    )
    of = np.searchsorted(pieces.start, level, side="right") - 1
    nearly = np.bincount(of, moves.length[level], len(pieces)) > ENTRY.LEVEL * pieces.length
    level = level[nearly[of]]
    of, height = of[nearly[of]], np.rint(moves.z[level] / ROUNDING.HEIGHT)
    order = np.lexsort((height, of))
    level, of, height = level[order], of[order], height[order]
    begin = np.flatnonzero(np.append(True, (of[1:] != of[:-1]) | (height[1:] != height[:-1]))[: len(of)])
    if not len(begin):
        return flat
    share = np.add.reduceat(moves.length[level], begin) / pieces.length[of[begin]]
    share[share < ENTRY.ONE_OF_SEVERAL] = 0.0  # ignore heights at which little of the piece is cut
    lies = (share > 0) & (np.bincount(of[begin], share, len(pieces))[of[begin]] > ENTRY.LEVEL)
    return np.concatenate([flat, moves.z[level[begin[lies]]]])


def reason_of(section: Section, verdict: Verdict, evidence: Evidence) -> Message:
    """Return the reason for the strategy of a section, with numbers."""
    low, high = evidence.phi_range
    strategy, seen, spread = verdict.strategy, verdict.seen, _spread(evidence)
    at_0 = ENGLISH.turns(low) == ENGLISH.turns(high) == "0"
    if strategy.family is Family.ROWS and section.rows:
        if at_0:
            return Message("rows-at-0", count=evidence.passes, spread=spread, seen=seen, strategy=strategy)
        return Message("rows", low=low, high=high, count=evidence.passes, spread=spread, seen=seen, strategy=strategy)
    if len(section.rings) and (strategy.family is Family.AROUND or strategy is Strategy.ZIGZAG):
        turning = {"ccw": Message("counter-clockwise"), "cw": Message("clockwise")}.get(evidence.sense or "")
        return Message(
            "loops", reached=farthest(evidence.phi_range), count=len(section.rings), spread=spread, seen=seen, strategy=strategy,
            turning=turning,
        )  # fmt: skip
    if strategy is Strategy.MIXED or not len(section.strokes):
        return Message("between", low=low, high=high, seen=seen, strategy=strategy)
    count = len(section.strokes)
    if at_0:
        return Message("strokes-at-0", count=count, spread=spread, seen=seen, strategy=strategy)
    return Message("strokes", low=low, high=high, count=count, spread=spread, seen=seen, strategy=strategy)


def _spread(evidence: Evidence) -> Message | None:
    """Return the stepover and the number of depths as a message; None without a stepover and at a single depth."""
    if evidence.stepover and evidence.depths > 1:
        return Message("apart-at-depths", step=evidence.stepover, depths=evidence.depths)
    if evidence.stepover:
        return Message("apart", step=evidence.stepover)
    return Message("at-depths", depths=evidence.depths) if evidence.depths > 1 else None
