# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers behind a verdict, and the sentence that tells them in the paper's terms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench import friendly
from vkworkbench.core.paper import farthest
from vkworkbench.core.recognition.footprints import count_depths
from vkworkbench.core.recognition.pieces import LOOP
from vkworkbench.core.recognition.section import Section
from vkworkbench.core.recognition.thresholds import ENOUGH, LITTLE, RINGS
from vkworkbench.core.recognition.verdict import Verdict
from vkworkbench.core.strategy import Family, Strategy


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
        if np.isfinite(rings.step):
            stepover = rings.step
            if sense and max(rings.growing, 1 - rings.growing) > RINGS.ONE_WAY:
                # What is left to cut lies on the right of a climbing tool: outward of a growing ccw loop.
                milling = "climb" if (rings.growing > 0.5) == (sense == "ccw") else "conventional"
    elif main:
        # Grids are not cut row by row.
        passes, stepover = sum(f.count for f in rows), main.period if len(rows) > 1 else main.step
    if verdict.step and not stepover:
        passes, stepover = verdict.count, verdict.step
    flat = s.pieces.flat & (s.pieces.length > LITTLE.PIECE * s.pieces.length.max())
    return Evidence(
        level=s.moves.top_level,
        phi_range=s.moves.phi_range,
        reversals=len(s.moves.reversals),
        sense=sense,
        stepover=stepover,
        passes=passes,
        depths=count_depths(s.pieces.z[flat]),
        direction=main.axis if main and not around else None,
        closed_loops=int((s.pieces.kind == LOOP).sum()),
        milling=milling,
    )


def sentence(s: Section, verdict: Verdict, e: Evidence) -> str:
    """Tell the verdict in one sentence with its numbers."""
    low, high = e.phi_range
    strategy = verdict.strategy
    apart = f", {e.stepover:.3g} mm apart" if e.stepover else ""
    depths = f" at {e.depths} depths" if e.depths > 1 else ""
    turning = {"ccw": ", counter-clockwise", "cw": ", clockwise"}.get(e.sense or "", "")
    between = f"between {friendly.turns(low)} and {friendly.turns(high)} turns"
    stays = "stays at 0" if friendly.turns(low) == friendly.turns(high) == "0" else f"stays {between}"
    if strategy.family is Family.ROWS and s.rows:
        return f"phi {stays} over {e.passes} rows{apart}{depths}, {verdict.seen}: {strategy}"
    if len(s.rings) and (strategy.family is Family.AROUND or strategy is Strategy.ZIGZAG):
        return (
            f"phi reaches {friendly.turns(farthest(e.phi_range))} turns over {_count(len(s.rings), 'loop')}{apart}"
            f"{depths}, {verdict.seen}: {strategy}{turning}"
        )
    if strategy is Strategy.MIXED or not len(s.strokes):
        return f"phi lies {between}, {verdict.seen}: {strategy}"
    strokes = _count(len(s.strokes), "open stroke")
    return f"phi {stays} over {strokes}{apart}{depths}, {verdict.seen}: {strategy}"


def _count(number: int, thing: str) -> str:
    """Return how many there are of a thing."""
    return f"one {thing}" if number == 1 else f"{number} {thing}s"
