# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decision: which strategy the pieces of one section stand for, and how sure that is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.recognition.concentric import find_arcs
from vkworkbench.core.recognition.neighbours import find_neighbours
from vkworkbench.core.recognition.section import Section
from vkworkbench.core.recognition.thresholds import (
    ADAPTIVE,
    BITES,
    CONFIDENCE,
    ENOUGH,
    NEIGHBOURS,
    POCKET,
    RINGS,
    STROKES,
    TROCHOIDS,
    WATERLINES,
)
from vkworkbench.core.strategy import Strategy
from vkworkbench.language import Message

ENTERED = Message("winding-with-entry")


@dataclass(frozen=True)
class Verdict:
    """What one section is.

    Attributes
    ----------
    strategy : Strategy
    support : float
        Share of the cutting length that shows what the strategy asks for, 0..1.
    count : int
        How many rows, rings or strokes show it.
    seen : Message
        What shows it.
    parts : tuple of Verdict
        Where mixed: the verdicts on its rings and on its rows.
    rival : float
        Share of that length that speaks for another strategy as well, 0..1.
    step : float or None
        Distance between neighbouring passes that are neither rings nor straight rows, mm.
    """

    strategy: Strategy
    support: float
    count: int
    seen: Message
    parts: tuple[Verdict, ...] = ()
    rival: float = 0.0
    step: float | None = None

    @property
    def confidence(self) -> float:
        """How often such verdicts are right, 0..1.

        Never under 0.62, the share of right answers where hardly anything is seen, and never over 0.97:
        toolpaths nobody has seen yet hold surprises. Between them it grows with the share of the length that
        shows the pattern and with the number of times it comes again, and falls with the share that speaks
        for the next best strategy as well. The two limits are read off the reliability table of
        benchmarks/recognition.py.
        """
        margin = min(self.support, 1.0) * (1 - min(self.rival, 1.0))
        return float(CONFIDENCE.LEAST + CONFIDENCE.SPAN * margin * (1 - np.exp(-self.count / CONFIDENCE.TIMES)))


def judge(s: Section) -> Verdict:
    """Judge a section by its rings, its rows or its open strokes, whichever make up most of it."""
    rings = s.share(s.ring_pieces[s.rings.index])
    opened = 1 - rings
    rowlike = max(s.zigzag, sum(f.length for f in s.rows) / s.length)
    if rowlike > ENOUGH.SHARE * opened:
        rowlike = opened  # the rest are the links
    arcs = _judge_arcs(s) if rings < RINGS.OFFSETS and rowlike < ENOUGH.SHARE else None
    bites, against = s.part(s.strokes.bite), s.part(s.strokes.against)
    number = int(s.strokes.bite.sum())
    many = bites > BITES.SHARE and number >= BITES.COUNT
    # Circles that the boundary cuts open overlap, too. Those keep their radii, and bites do not.
    circles = arcs is not None and arcs.strategy is Strategy.CONTOUR_PARALLEL
    if many and not circles and against < BITES.AGAINST * bites and rowlike < ENOUGH.SHARE:
        support = CONFIDENCE.GIVEN + (1 - CONFIDENCE.GIVEN) * bites
        return Verdict(Strategy.ADAPTIVE, support, number, Message("bites-overlap", count=number))
    if arcs:
        return arcs
    # Whatever the rest is: a tool that corrects its direction all the time leaves remnants to rows and bites.
    hunting, nested = s.share(s.hunting), s.share(s.rings.nested)
    if min(hunting, nested) > ENOUGH.SHARE * rings:
        return Verdict(Strategy.ADAPTIVE, hunting / rings, len(s.rings), Message("endless-winding"))
    # Offsets are still offsets where the innermost are so narrow that they are passes and no loops.
    offsets = rings > RINGS.OFFSETS and nested > RINGS.OFFSETS * rings
    if offsets or (rings > RINGS.ALONE and (rowlike < RINGS.ROWS_BESIDE or not s.rows)):
        return _judge_rings(s, rings)
    of_rows = _judge_rows(s, rowlike)
    both = rings > RINGS.AMONG_ROWS and rowlike > RINGS.ROWS_BESIDE and of_rows.count >= ENOUGH.TIMES
    if rowlike < RINGS.ALONE and not both:
        return _judge_strokes(s, rings)
    if not both:
        return of_rows
    of_rings = _judge_rings(s, rings)
    seen = Message("rows-and-loops", rows=rowlike, loops=rings)
    support = min(1.0, CONFIDENCE.GIVEN + 2 * rings, CONFIDENCE.GIVEN + 2 * rowlike)
    return Verdict(Strategy.MIXED, support, of_rows.count, seen, (of_rings, of_rows))


def _judge_rings(s: Section, rings: float) -> Verdict:
    r = s.rings
    helix = s.share(r.stacked & r.sloped & r.round)
    # Where other contours are ramped in the same way, the round ones among them are profiles like those.
    if helix > ENOUGH.SHARE * rings and s.share(r.round) > RINGS.ALL_ROUND * rings:
        # A flat winding that goes on outward clears a pocket, however long the helix that leads into it.
        clears = r.nested & r.winding & ~r.sloped & ~r.stacked
        if (clears[1:] & clears[:-1]).sum() >= 2:
            return Verdict(Strategy.ADAPTIVE, (helix + s.share(clears)) / rings, len(r), ENTERED)
        return Verdict(Strategy.HELIX, helix / rings, len(r), Message("constant-radius"))
    opposite = s.share(r.opposite)
    if opposite > ENOUGH.SHARE * rings:
        return Verdict(Strategy.ZIGZAG, opposite / rings, len(r), Message("sense-alternates"))
    nested, deeper = s.share(r.nested), s.share(r.deeper)
    changing = r.depths >= WATERLINES.DEPTHS and r.depth_range > WATERLINES.RANGE * s.tool
    changing = changing and deeper > WATERLINES.DEEPER * rings
    if changing and deeper > nested:
        if r.evenness < WATERLINES.EVENER:
            seen = Message("even-in-plane")
            return Verdict(Strategy.CONTOUR_PARALLEL, deeper / rings, len(r), seen, rival=nested / rings)
        seen = Message("shape-changes")
        return Verdict(Strategy.WATERLINE, deeper / rings, r.depths, seen, rival=nested / rings)
    if nested > ENOUGH.SHARE * rings:
        winding = s.share(r.winding)
        linked = s.share(s.aside)
        if winding > ENOUGH.SHARE * rings and linked < ENOUGH.SHARE * winding:
            # A spiral leaves nothing to bites and strokes; one that the boundary cuts open is judged by its arcs.
            bitten = s.part(s.strokes.bite) > ADAPTIVE.BITES and s.strokes.bite.sum() >= ENOUGH.TIMES
            if bitten or helix > ADAPTIVE.ENTRY or s.strokes.length.sum() > ADAPTIVE.STROKES * s.length:
                return Verdict(Strategy.ADAPTIVE, winding / rings, len(r), ENTERED)
            if s.cornered() < ENOUGH.SHARE:
                return Verdict(Strategy.SPIRAL, winding / rings, len(r), Message("endless-winding"))
        rival = deeper / rings if changing else 0.0
        return Verdict(Strategy.CONTOUR_PARALLEL, nested / rings, len(r), Message("nested"), rival=rival)
    moved = s.share(r.moved)
    if moved > TROCHOIDS.SHARE * rings and len(r) >= ENOUGH.TIMES:
        return Verdict(Strategy.ADAPTIVE, moved / rings, len(r), Message("loops-move"))
    if s.share(r.alone) > ENOUGH.SHARE * rings and s.filled() > POCKET.FILLED:
        return Verdict(Strategy.MIXED, CONFIDENCE.POCKET, 2, Message("pass-inside"))
    if s.letters():
        return Verdict(Strategy.ENGRAVING, CONFIDENCE.STROKES, len(r), Message("many-shapes"))
    # A loop that comes again is a contour. So are loops that have nothing to do with one another, with less support.
    support = CONFIDENCE.GIVEN + (1 - CONFIDENCE.GIVEN) * s.share(r.repeated) / rings
    rival = max(nested, deeper if changing else 0.0, moved if len(r) >= ENOUGH.TIMES else 0.0) / rings
    return Verdict(Strategy.PROFILE, support, len(r) + 2, Message("not-nested"), rival=rival)


def _judge_rows(s: Section, rowlike: float) -> Verdict:
    opposite, same = sum(f.opposite for f in s.rows), sum(f.same for f in s.rows)
    count = sum(f.count for f in s.rows)
    if opposite >= same or s.zigzag > ENOUGH.SHARE * rowlike:
        agree = opposite / (opposite + same) if opposite + same else 1.0
        support = rowlike * max(agree, s.zigzag)
        return Verdict(Strategy.ZIGZAG, support, max(count, 3), Message("half-turns-alternate"))
    return Verdict(Strategy.ONE_WAY, rowlike * same / (opposite + same), count, Message("same-way"))


def _judge_arcs(s: Section) -> Verdict | None:
    """Judge circles that the boundary cuts open: rows around a centre."""
    arcs = find_arcs(s.moves, s.pieces, np.union1d(s.strokes.index, s.rings.index))
    if arcs is None or arcs.count < ENOUGH.TIMES or arcs.even < ENOUGH.SHARE or arcs.length < ENOUGH.SHARE * s.length:
        return None
    strategy, seen = Strategy.CONTOUR_PARALLEL, Message("nested")
    if arcs.opposite > arcs.same:
        strategy, seen = Strategy.ZIGZAG, Message("half-turns-alternate")
    elif arcs.spiral > ENOUGH.SHARE * arcs.length:
        strategy, seen = Strategy.SPIRAL, Message("endless-winding")
    return Verdict(strategy, arcs.length / s.length, arcs.count, seen, step=arcs.step)


def _judge_strokes(s: Section, rings: float) -> Verdict:
    k = s.strokes
    sloped = s.part(k.sloped)
    number = len(k)
    if k.depths >= WATERLINES.OPEN_DEPTHS and sloped < WATERLINES.SLOPED and k.distinct > ENOUGH.SHARE * number:
        return Verdict(Strategy.WATERLINE, CONFIDENCE.GIVEN, k.depths, Message("open-contours-change"))
    beside = find_neighbours(s.moves, s.pieces, k.index, s.tool)
    if beside and beside.count >= ENOUGH.TIMES and beside.share > NEIGHBOURS.SHARE:
        support = beside.share * (1 - rings)
        if beside.even > ENOUGH.SHARE:
            strategy = Strategy.CONTOUR_PARALLEL if beside.onward > ENOUGH.SHARE else Strategy.ZIGZAG
            return Verdict(strategy, support, beside.count, Message("open-offsets"), step=beside.step)
        if beside.onward > NEIGHBOURS.ONWARD:
            return Verdict(Strategy.ADAPTIVE, support, beside.count, Message("open-passes"), step=beside.step)
    extent = s.pieces.box[:, 2:].max(axis=0) - s.pieces.box[:, :2].min(axis=0)
    long = k.typical > STROKES.LONG * extent.sum()
    # Letters may be carved at several depths as contours are, but there are more of them, and they are short.
    contours = k.distinct < STROKES.DISTINCT * number and (long or k.distinct <= ENOUGH.TIMES)
    if k.distinct <= 1 or contours or s.retraced > ENOUGH.SHARE:
        seen = Message("one-open-contour") if number == 1 else Message("open-contour-again")
        return Verdict(Strategy.PROFILE, CONFIDENCE.STROKES, number + 1, seen)
    if long and sloped < ENOUGH.SHARE and k.distinct <= ENOUGH.TIMES:
        return Verdict(Strategy.PROFILE, CONFIDENCE.LONG_STROKES, number, Message("long-strokes"))
    return Verdict(Strategy.ENGRAVING, CONFIDENCE.STROKES, number, Message("short-strokes"))
