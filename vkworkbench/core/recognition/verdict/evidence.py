# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers behind a verdict, and the sentence that tells them in the paper's terms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import farthest
from vkworkbench.core.recognition.patterns.footprints import count_depths
from vkworkbench.core.recognition.patterns.pieces import LOOP
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import ENOUGH, ENTRY, LITTLE, RINGS, SAME
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.language import ENGLISH, Message


@dataclass(frozen=True)
class Evidence:
    """Numbers of a section; the fields are those of Recognition."""

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


def gather(s: Section, verdict: Verdict) -> Evidence:
    """Collect the numbers behind a verdict."""
    around = verdict.strategy.family is Family.AROUND or not s.rows
    rings, rows = s.rings, s.rows
    main = max(rows, key=lambda f: f.length) if rows else None
    sense = milling = stepover = passes = None
    if len(rings) and around:
        turned = float((np.sign(s.pieces.net[rings.index]) * rings.length).sum() / rings.length.sum())
        sense = "ccw" if turned > ENOUGH.SHARE else "cw" if turned < -ENOUGH.SHARE else None
        passes = len(rings)
        if np.isfinite(rings.step) and verdict.strategy is not Strategy.PROFILE:
            stepover = rings.step
            if sense and max(rings.growing, 1 - rings.growing) > RINGS.ONE_WAY:
                # What is left to cut lies on the right of a climbing tool: outward of a growing ccw loop.
                milling = "climb" if (rings.growing > 0.5) == (sense == "ccw") else "conventional"
    elif main:
        # Grids are not cut row by row, also where only one family of their rows looks as if it were.
        passes, stepover = sum(f.count for f in rows), main.step
        longest = max(s.families, key=lambda f: f.length)
        if len(rows) > 1 or sum(f.length for f in s.families) > (1 + ENOUGH.SHARE) * longest.length:
            stepover = longest.period
    if verdict.step and not stepover:
        passes, stepover = verdict.count, verdict.step
    return Evidence(
        level=s.areas.top_level,
        phi_range=s.areas.phi_range,
        reversals=len(s.areas.reversals),
        sense=sense,
        stepover=stepover,
        passes=passes,
        depths=count_depths(_heights(s)),
        direction=main.axis if main and not around else None,
        closed_loops=int((s.pieces.kind == LOOP).sum()),
        milling=milling,
    )


def _heights(s: Section) -> np.ndarray:
    """Return the heights at which pieces lie, (k,) mm: where nearly all of one is level, however it is entered.

    A zigzag that is ramped into without a lift at several depths is one piece.
    """
    p, m = s.pieces, s.moves
    counts = p.length > LITTLE.PIECE * p.length.max()
    flat: np.ndarray = p.z[counts & p.flat]
    if p.flat.all():
        return flat
    # Of pieces that are ramped into, or lifted over tags, the level moves tell.
    level = np.flatnonzero(np.repeat(counts & ~p.flat, p.end - p.start) & (np.abs(m.dz) < SAME.HEIGHT))
    of = np.searchsorted(p.start, level, side="right") - 1
    nearly = np.bincount(of, m.length[level], len(p)) > ENTRY.LEVEL * p.length
    level = level[nearly[of]]
    of, height = of[nearly[of]], np.rint(m.z[level] / SAME.HEIGHT)
    order = np.lexsort((height, of))
    level, of, height = level[order], of[order], height[order]
    begin = np.flatnonzero(np.append(True, (of[1:] != of[:-1]) | (height[1:] != height[:-1]))[: len(of)])
    if not len(begin):
        return flat
    share = np.add.reduceat(m.length[level], begin) / p.length[of[begin]]
    share[share < ENTRY.ONE_OF_SEVERAL] = 0.0  # plateaus
    lies = (share > 0) & (np.bincount(of[begin], share, len(p))[of[begin]] > ENTRY.LEVEL)
    return np.concatenate([flat, m.z[level[begin[lies]]]])


def sentence(s: Section, verdict: Verdict, e: Evidence) -> Message:
    """Tell the verdict with its numbers."""
    low, high = e.phi_range
    strategy, seen, spread = verdict.strategy, verdict.seen, _spread(e)
    at_0 = ENGLISH.turns(low) == ENGLISH.turns(high) == "0"
    if strategy.family is Family.ROWS and s.rows:
        if at_0:
            return Message("rows-at-0", count=e.passes, spread=spread, seen=seen, strategy=strategy)
        return Message("rows", low=low, high=high, count=e.passes, spread=spread, seen=seen, strategy=strategy)
    if len(s.rings) and (strategy.family is Family.AROUND or strategy is Strategy.ZIGZAG):
        turning = {"ccw": Message("counter-clockwise"), "cw": Message("clockwise")}.get(e.sense or "")
        return Message(
            "loops", reached=farthest(e.phi_range), count=len(s.rings), spread=spread, seen=seen, strategy=strategy,
            turning=turning,
        )  # fmt: skip
    if strategy is Strategy.MIXED or not len(s.strokes):
        return Message("between", low=low, high=high, seen=seen, strategy=strategy)
    count = len(s.strokes)
    if at_0:
        return Message("strokes-at-0", count=count, spread=spread, seen=seen, strategy=strategy)
    return Message("strokes", low=low, high=high, count=count, spread=spread, seen=seen, strategy=strategy)


def _spread(e: Evidence) -> Message | None:
    """How far apart the passes lie, and at how many depths; None where there is nothing to tell."""
    if e.stepover and e.depths > 1:
        return Message("apart-at-depths", step=e.stepover, depths=e.depths)
    if e.stepover:
        return Message("apart", step=e.stepover)
    return Message("at-depths", depths=e.depths) if e.depths > 1 else None
