# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules: which strategy the pieces of one section stand for."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.recognition.patterns.concentric import find_arcs
from vkworkbench.core.recognition.patterns.entries import share_rising
from vkworkbench.core.recognition.patterns.neighbours import find_neighbours
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import (
    ADAPTIVE,
    BITES,
    MAJORITY,
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
    count : int
        How many rows, rings or strokes show it.
    seen : Message
        What shows it.
    parts : tuple of Verdict
        Where mixed: the verdicts on its rings and on its rows.
    step : float or None
        Distance between neighbouring passes that are neither rings nor straight rows, mm.
    finished : bool
        Whether contours around the rows finish their walls.
    """

    strategy: Strategy
    count: int
    seen: Message
    parts: tuple[Verdict, ...] = ()
    step: float | None = None
    finished: bool = False


def judge(s: Section) -> Verdict:
    """Judge a section by its rings, its rows or its open strokes, whichever make up most of it."""
    rings = s.share(s.ring_pieces[s.rings.index])
    opened = 1 - rings
    rowlike = max(s.zigzag, sum(f.length for f in s.rows) / s.length)
    if rowlike > MAJORITY.SHARE * opened:
        rowlike = opened  # the rest are the links
    arcs = _judge_arcs(s) if rings < RINGS.OFFSETS and rowlike < MAJORITY.SHARE else None
    bites, against = s.part(s.strokes.bite), s.part(s.strokes.against)
    number = int(s.strokes.bite.sum())
    many = bites > BITES.SHARE and number >= BITES.COUNT
    # Circles that the boundary cuts open overlap, too. Those keep their radii, and bites do not.
    circles = arcs is not None and arcs.strategy is Strategy.CONTOUR_PARALLEL
    if many and not circles and against < BITES.AGAINST * bites and rowlike < MAJORITY.SHARE:
        return Verdict(Strategy.ADAPTIVE, number, Message("bites-overlap", count=number))
    if arcs:
        return arcs
    # Whatever the rest is: a tool that corrects its direction all the time leaves remnants to rows and bites.
    hunting, nested = s.share(s.hunting), s.share(s.rings.nested)
    if min(hunting, nested) > MAJORITY.SHARE * rings:
        return Verdict(Strategy.ADAPTIVE, len(s.rings), Message("endless-winding"))
    # Offsets are still offsets where the innermost are so narrow that they are passes and no loops.
    offsets = rings > RINGS.OFFSETS and nested > RINGS.OFFSETS * rings
    if offsets or (rings > RINGS.ALONE and (rowlike < RINGS.ROWS_BESIDE or not s.rows)):
        return _judge_rings(s, rings)
    of_rows = _judge_rows(s, rowlike)
    both = rings > RINGS.AMONG_ROWS and rowlike > RINGS.ROWS_BESIDE and of_rows.count >= MAJORITY.REPETITIONS
    if rowlike < RINGS.ALONE and not both:
        return _judge_strokes(s)
    if not both:
        return of_rows
    if max(s.bordered()) > MAJORITY.SHARE:
        return replace(of_rows, finished=True)
    of_rings = _judge_rings(s, rings)
    seen = Message("rows-and-loops", rows=rowlike, loops=rings)
    return Verdict(Strategy.MIXED, of_rows.count, seen, (of_rings, of_rows))


def _judge_rings(s: Section, rings: float) -> Verdict:
    r = s.rings
    helix = s.share(r.stacked & r.sloped & r.round)
    # Where other contours are ramped in the same way, the round ones among them are profiles like those.
    if helix > MAJORITY.SHARE * rings and s.share(r.round) > RINGS.ALL_ROUND * rings:
        # A flat winding that goes on outward clears a pocket, however long the helix that leads into it.
        clears = r.nested & r.winding & ~r.sloped & ~r.stacked
        if (clears[1:] & clears[:-1]).sum() >= 2:
            if _is_even_spiral(s, rings):
                return Verdict(Strategy.SPIRAL, len(r), Message("endless-winding"))
            return Verdict(Strategy.ADAPTIVE, len(r), ENTERED)
        return Verdict(Strategy.HELIX, len(r), Message("constant-radius"))
    if s.share(r.opposite) > MAJORITY.SHARE * rings:
        return Verdict(Strategy.ZIGZAG, len(r), Message("sense-alternates"))
    nested, deeper = s.share(r.nested), s.share(r.deeper)
    changing = r.depths >= WATERLINES.DEPTHS and r.depth_range > WATERLINES.RANGE * s.tool
    changing = changing and deeper > WATERLINES.DEEPER * rings
    if changing and deeper > nested:
        if r.evenness < WATERLINES.EVENER:
            return Verdict(Strategy.CONTOUR_PARALLEL, len(r), Message("even-in-plane"))
        return Verdict(Strategy.WATERLINE, r.depths, Message("shape-changes"))
    if nested > MAJORITY.SHARE * rings:
        winding = s.share(r.winding)
        linked = s.share(s.aside)
        if winding > MAJORITY.SHARE * rings and linked < MAJORITY.SHARE * winding:
            # A spiral leaves nothing to bites and strokes; one that the boundary cuts open is judged by its arcs.
            bitten = s.part(s.strokes.bite) > ADAPTIVE.BITES and s.strokes.bite.sum() >= MAJORITY.REPETITIONS
            entered = helix + s.wound > ADAPTIVE.ENTRY and not _is_even_spiral(s, rings)
            if bitten or entered or s.strokes.length.sum() > ADAPTIVE.STROKES * s.length:
                return Verdict(Strategy.ADAPTIVE, len(r), ENTERED)
            if s.cornered() < MAJORITY.SHARE:
                return Verdict(Strategy.SPIRAL, len(r), Message("endless-winding"))
        return Verdict(Strategy.CONTOUR_PARALLEL, len(r), Message("nested"))
    if s.share(r.moved) > TROCHOIDS.SHARE * rings and len(r) >= MAJORITY.REPETITIONS:
        return Verdict(Strategy.ADAPTIVE, len(r), Message("loops-move"))
    if s.share(r.alone) > MAJORITY.SHARE * rings and s.filled() > POCKET.FILLED:
        return Verdict(Strategy.MIXED, 2, Message("pass-inside"))
    if s.letters():
        return Verdict(Strategy.ENGRAVING, len(r), Message("many-shapes"))
    # A loop that comes again is a contour. So are loops that have nothing to do with one another.
    seen = Message("in-strokes") if s.in_strokes > MAJORITY.SHARE else Message("not-nested")
    return Verdict(Strategy.PROFILE, len(r), seen)


def _is_even_spiral(s: Section, rings: float) -> bool:
    """Tell whether all rings are round and their turns at one distance: to keep its engagement, a tool steps unevenly."""
    return s.rings.equidistant and s.share(s.rings.round) > RINGS.ALL_ROUND * rings


def _judge_rows(s: Section, rowlike: float) -> Verdict:
    opposite, same = sum(f.opposite for f in s.rows), sum(f.same for f in s.rows)
    count = sum(f.count for f in s.rows)
    if opposite >= same or s.zigzag > MAJORITY.SHARE * rowlike:
        return Verdict(Strategy.ZIGZAG, count, Message("half-turns-alternate"))
    return Verdict(Strategy.ONE_WAY, count, Message("same-way"))


def _judge_arcs(s: Section) -> Verdict | None:
    """Judge circles that the boundary cuts open: rows around a centre."""
    arcs = find_arcs(s.moves, s.pieces, np.union1d(s.strokes.index, s.rings.index))
    if (
        arcs is None
        or arcs.count < MAJORITY.REPETITIONS
        or arcs.even < MAJORITY.SHARE
        or arcs.length < MAJORITY.SHARE * s.length
    ):
        return None
    strategy, seen = Strategy.CONTOUR_PARALLEL, Message("nested")
    if arcs.opposite > arcs.same:
        strategy, seen = Strategy.ZIGZAG, Message("half-turns-alternate")
    elif arcs.spiral > MAJORITY.SHARE * arcs.length:
        strategy, seen = Strategy.SPIRAL, Message("endless-winding")
    return Verdict(strategy, arcs.count, seen, step=arcs.step)


def _judge_strokes(s: Section) -> Verdict:
    k = s.strokes
    sloped = s.part(k.sloped)
    number = len(k)
    beside = find_neighbours(s.moves, s.pieces, k.index, s.tool)
    if beside and beside.count >= MAJORITY.REPETITIONS and beside.share > NEIGHBOURS.SHARE:
        if beside.even > MAJORITY.SHARE:
            strategy = Strategy.CONTOUR_PARALLEL if beside.onward > MAJORITY.SHARE else Strategy.ZIGZAG
            return Verdict(strategy, beside.count, Message("open-offsets"), step=beside.step)
        if beside.onward > NEIGHBOURS.ONWARD:
            return Verdict(Strategy.ADAPTIVE, beside.count, Message("open-passes"), step=beside.step)
    if k.depths >= WATERLINES.OPEN_DEPTHS and sloped < WATERLINES.SLOPED and k.distinct > MAJORITY.SHARE * number:
        return Verdict(Strategy.WATERLINE, k.depths, Message("open-contours-change"))
    extent = s.pieces.box[:, 2:].max(axis=0) - s.pieces.box[:, :2].min(axis=0)
    long = k.typical > STROKES.LONG * extent.sum()
    # Letters may be carved at several depths as contours are, but there are more of them, and they are short.
    contours = k.distinct < STROKES.DISTINCT * number and (long or k.distinct <= MAJORITY.REPETITIONS)
    # What comes again deeper rises to its ends where it is left, not in the corners of letters.
    if not contours and max(sloped, s.retraced) < MAJORITY.SHARE and share_rising(s.areas) > STROKES.RISING:
        return Verdict(Strategy.ENGRAVING, number, Message("rising-strokes"))
    if k.distinct <= 1 or contours or s.retraced > MAJORITY.SHARE:
        seen = Message("one-open-contour") if number == 1 else Message("open-contour-again")
        return Verdict(Strategy.PROFILE, number, seen)
    if long and sloped < MAJORITY.SHARE and k.distinct <= MAJORITY.REPETITIONS:
        return Verdict(Strategy.PROFILE, number, Message("long-strokes"))
    return Verdict(Strategy.ENGRAVING, number, Message("short-strokes"))
