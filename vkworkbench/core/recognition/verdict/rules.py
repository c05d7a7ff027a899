# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propose the strategy of an operation by rules about its loops, rows and strokes."""

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
    """The strategy of one section and its reason.

    Attributes
    ----------
    strategy : Strategy
    count : int
        Number of rows, rings or strokes that show the strategy.
    seen : Message
        Reason for the strategy.
    parts : tuple of Verdict
        For a mixed section: the verdicts on its rings and on its rows.
    step : float or None
        Distance between neighbouring passes that are neither rings nor straight rows, mm.
    finished : bool
        Whether contours around the rows finish the walls.
    """

    strategy: Strategy
    count: int
    seen: Message
    parts: tuple[Verdict, ...] = ()
    step: float | None = None
    finished: bool = False


def judge_section(section: Section) -> Verdict:
    """Return the strategy of a section's rings, rows or open strokes, whichever have most of the cutting length."""
    rings = section.share(section.ring_pieces[section.rings.index])
    rows = _share_of_rows(section, 1 - rings)
    arcs = _judge_arcs(section) if rings < RINGS.OFFSETS and rows < MAJORITY.SHARE else None
    verdict = _judge_bites(section, rows, arcs) or arcs or _judge_hunting(section, rings)
    if verdict:
        return verdict
    if _rings_prevail(section, rings, rows):
        return _judge_rings(section, rings)
    of_rows = _judge_rows(section, rows)
    both = rings > RINGS.AMONG_ROWS and rows > RINGS.ROWS_BESIDE and of_rows.count >= MAJORITY.REPETITIONS
    if both:
        return _judge_rows_and_rings(section, of_rows, rings, rows)
    return _judge_strokes(section) if rows < RINGS.ALONE else of_rows


def _share_of_rows(section: Section, open_share: float) -> float:
    """Return the share of the section's length in rows.

    If rows are most of the length outside rings, everything outside rings counts as rows, because the rest is links
    between the rows.
    """
    rows = max(section.zigzag, sum(family.length for family in section.rows) / section.length)
    return open_share if rows > MAJORITY.SHARE * open_share else rows


def _judge_bites(section: Section, rows: float, arcs: Verdict | None) -> Verdict | None:
    """Return adaptive clearing if enough strokes overlap, as the bites of a cutter with limited engagement do.

    Circles interrupted at the boundary overlap like bites, but have a common centre. Concentric arcs therefore are not
    adaptive clearing.
    """
    strokes = section.strokes
    bites, against = section.part(strokes.bite), section.part(strokes.against)
    count = int(strokes.bite.sum())
    circles = arcs is not None and arcs.strategy is Strategy.CONTOUR_PARALLEL
    enough = bites > BITES.SHARE and count >= BITES.COUNT
    if enough and not circles and against < BITES.AGAINST * bites and rows < MAJORITY.SHARE:
        return Verdict(Strategy.ADAPTIVE, count, Message("bites-overlap", count=count))
    return None


def _judge_hunting(section: Section, rings: float) -> Verdict | None:
    """Return adaptive clearing if most rings are nested and most rings constantly correct their direction."""
    hunting, nested = section.share(section.hunting), section.share(section.rings.nested)
    if min(hunting, nested) > MAJORITY.SHARE * rings:
        return Verdict(Strategy.ADAPTIVE, len(section.rings), Message("endless-winding"))
    return None


def _rings_prevail(section: Section, rings: float, rows: float) -> bool:
    """Return whether the rings decide the strategy: nearly all of them are offsets, or there are hardly any rows."""
    offsets = rings > RINGS.OFFSETS and section.share(section.rings.nested) > RINGS.OFFSETS * rings
    return offsets or (rings > RINGS.ALONE and (rows < RINGS.ROWS_BESIDE or not section.rows))


def _judge_rows_and_rings(section: Section, of_rows: Verdict, rings: float, rows: float) -> Verdict:
    """Return rows with a finishing pass if the rings are contours of the rows, otherwise a mixed section."""
    if max(section.bordered()) > MAJORITY.SHARE:
        return replace(of_rows, finished=True)
    seen = Message("rows-and-loops", rows=rows, loops=rings)
    return Verdict(Strategy.MIXED, of_rows.count, seen, (_judge_rings(section, rings), of_rows))


def _judge_rings(section: Section, rings: float) -> Verdict:
    """Return the strategy of the rings, which make up the share `rings` of the length."""
    count = len(section.rings)
    helix = _judge_helix(section, rings)
    if helix:
        return helix
    if section.share(section.rings.opposite) > MAJORITY.SHARE * rings:
        return Verdict(Strategy.ZIGZAG, count, Message("sense-alternates"))
    waterline = _judge_changing_rings(section, rings)
    if waterline:
        return waterline
    if section.share(section.rings.nested) > MAJORITY.SHARE * rings:
        return _judge_nested_rings(section, rings)
    if section.share(section.rings.moved) > TROCHOIDS.SHARE * rings and count >= MAJORITY.REPETITIONS:
        return Verdict(Strategy.ADAPTIVE, count, Message("loops-move"))
    if section.share(section.rings.alone) > MAJORITY.SHARE * rings and section.filled() > POCKET.FILLED:
        return Verdict(Strategy.MIXED, 2, Message("pass-inside"))
    if section.letters():
        return Verdict(Strategy.ENGRAVING, count, Message("many-shapes"))
    # Loops that are repeated at other depths are contours of a profile. Loops that are neither nested nor repeated are
    # also contours of a profile.
    return Verdict(Strategy.PROFILE, count, _seen_of_contours(section, rings))


def _seen_of_contours(section: Section, rings: float) -> Message:
    """Return the reason for a profile: strokes between tags, few nested loops, or no nested loops."""
    if section.in_strokes > MAJORITY.SHARE:
        return Message("in-strokes")
    nested = section.share(section.rings.nested) / rings
    return Message("partly-nested", share=nested) if nested else Message("not-nested")


def _share_of_helix(section: Section) -> float:
    """Return the share of the length in sloped circles that are repeated at other depths, as in a helix."""
    rings = section.rings
    return section.share(rings.stacked & rings.sloped & rings.round)


def _judge_helix(section: Section, rings: float) -> Verdict | None:
    """Return a helix, or the strategy of the clearing after a helical entry; None if the rings are not a helix."""
    found, count = section.rings, len(section.rings)
    all_round = section.share(found.round) > RINGS.ALL_ROUND * rings
    if _share_of_helix(section) <= MAJORITY.SHARE * rings or not all_round:
        return None
    # Nested horizontal turns clear a pocket, even if the helix that enters the pocket is longer.
    clears = found.nested & found.winding & ~found.sloped & ~found.stacked
    if (clears[1:] & clears[:-1]).sum() < 2:
        climbs = section.pieces.drop[found.index].sum() > 0
        return Verdict(Strategy.HELIX, count, Message("constant-radius-up") if climbs else Message("constant-radius"))
    if _is_even_spiral(section, rings):
        return Verdict(Strategy.SPIRAL, count, Message("endless-winding"))
    return Verdict(Strategy.ADAPTIVE, count, ENTERED)


def _judge_changing_rings(section: Section, rings: float) -> Verdict | None:
    """Return the strategy of contours whose shape changes with the depth; None if the shape does not change."""
    found = section.rings
    deeper = section.share(found.deeper)
    deep = found.depths >= WATERLINES.DEPTHS and found.depth_range > WATERLINES.RANGE * section.tool
    if not deep or deeper <= WATERLINES.DEEPER * rings or deeper <= section.share(found.nested):
        return None
    if found.evenness < WATERLINES.EVENER:
        return Verdict(Strategy.CONTOUR_PARALLEL, len(found), Message("even-in-plane"))
    return Verdict(Strategy.WATERLINE, found.depths, Message("shape-changes"))


def _judge_nested_rings(section: Section, rings: float) -> Verdict:
    """Return the strategy of nested rings: offsets, or, for one continuous winding, a spiral or adaptive clearing."""
    count, strokes = len(section.rings), section.strokes
    offsets = Verdict(Strategy.CONTOUR_PARALLEL, count, Message("nested"))
    winding = section.share(section.rings.winding)
    if winding <= MAJORITY.SHARE * rings or section.share(section.aside) >= MAJORITY.SHARE * winding:
        return offsets
    # A spiral contains neither bites (overlapping bent strokes) nor open strokes. `_judge_arcs` judges a spiral that is
    # interrupted at the boundary.
    bitten = section.part(strokes.bite) > ADAPTIVE.BITES and strokes.bite.sum() >= MAJORITY.REPETITIONS
    entered = _share_of_helix(section) + section.wound > ADAPTIVE.ENTRY and not _is_even_spiral(section, rings)
    if bitten or entered or strokes.length.sum() > ADAPTIVE.STROKES * section.length:
        return Verdict(Strategy.ADAPTIVE, count, ENTERED)
    if section.cornered() < MAJORITY.SHARE:
        return Verdict(Strategy.SPIRAL, count, Message("endless-winding"))
    return offsets


def _is_even_spiral(section: Section, rings: float) -> bool:
    """Return whether nearly all rings are circles at equal distances, as in a spiral.

    The turns of adaptive clearing have unequal distances.
    """
    return section.rings.equidistant and section.share(section.rings.round) > RINGS.ALL_ROUND * rings


def _judge_rows(section: Section, rows: float) -> Verdict:
    """Return zigzag if the rows alternate, otherwise one-way. The rows have the share `rows` of the length."""
    opposite, same = (sum(getattr(family, name) for family in section.rows) for name in ("opposite", "same"))
    count = sum(family.count for family in section.rows)
    if opposite >= same or section.zigzag > MAJORITY.SHARE * rows:
        return Verdict(Strategy.ZIGZAG, count, Message("half-turns-alternate"))
    return Verdict(Strategy.ONE_WAY, count, Message("same-way"))


def _judge_arcs(section: Section) -> Verdict | None:
    """Return the strategy of circles interrupted at the boundary; None if too few strokes are concentric arcs."""
    arcs = find_arcs(section.moves, section.pieces, np.union1d(section.strokes.index, section.rings.index))
    if arcs is None or arcs.count < MAJORITY.REPETITIONS:
        return None
    if arcs.even < MAJORITY.SHARE or arcs.length < MAJORITY.SHARE * section.length:
        return None
    strategy, seen = Strategy.CONTOUR_PARALLEL, Message("nested")
    if arcs.opposite > arcs.same:
        strategy, seen = Strategy.ZIGZAG, Message("half-turns-alternate")
    elif arcs.spiral > MAJORITY.SHARE * arcs.length:
        strategy, seen = Strategy.SPIRAL, Message("endless-winding")
    return Verdict(strategy, arcs.count, seen, step=arcs.step)


def _judge_strokes(section: Section) -> Verdict:
    """Return the strategy of open strokes: offsets of an open wall, waterlines, an open contour, or an engraving."""
    strokes = section.strokes
    sloped = section.part(strokes.sloped)
    beside = _judge_neighbours(section)
    if beside:
        return beside
    changing = strokes.depths >= WATERLINES.OPEN_DEPTHS and sloped < WATERLINES.SLOPED
    if changing and strokes.distinct > MAJORITY.SHARE * len(strokes):
        return Verdict(Strategy.WATERLINE, strokes.depths, Message("open-contours-change"))
    return _judge_contours_or_letters(section, sloped)


def _judge_neighbours(section: Section) -> Verdict | None:
    """Return offsets, rows or adaptive clearing for open strokes side by side; None if there are too few."""
    beside = find_neighbours(section.moves, section.pieces, section.strokes.index, section.tool)
    if not beside or beside.count < MAJORITY.REPETITIONS or beside.share <= NEIGHBOURS.SHARE:
        return None
    if beside.even > MAJORITY.SHARE:
        strategy = Strategy.CONTOUR_PARALLEL if beside.onward > MAJORITY.SHARE else Strategy.ZIGZAG
        return Verdict(strategy, beside.count, Message("open-offsets"), step=beside.step)
    if beside.onward > NEIGHBOURS.ONWARD:
        return Verdict(Strategy.ADAPTIVE, beside.count, Message("open-passes"), step=beside.step)
    return None


def _judge_contours_or_letters(section: Section, sloped: float) -> Verdict:
    """Return a profile for an open contour at one or several depths, and an engraving for many short strokes."""
    strokes, box = section.strokes, section.pieces.box
    count = len(strokes)
    extent = box[:, 2:].max(axis=0) - box[:, :2].min(axis=0)
    long = strokes.typical > STROKES.LONG * extent.sum()
    few = strokes.distinct <= MAJORITY.REPETITIONS
    # Letters can also be repeated at several depths, but there are more letters than contours, and letters are short.
    contours = strokes.distinct < STROKES.DISTINCT * count and (long or few)
    # A contour repeated at greater depths rises only at its ends. Carved letters rise in their corners.
    level = max(sloped, section.retraced) < MAJORITY.SHARE
    if not contours and level and share_rising(section.areas) > STROKES.RISING:
        return Verdict(Strategy.ENGRAVING, count, Message("rising-strokes"))
    if strokes.distinct <= 1 or contours or section.retraced > MAJORITY.SHARE:
        seen = Message("one-open-contour") if count == 1 else Message("open-contour-again")
        return Verdict(Strategy.PROFILE, count, seen)
    if long and sloped < MAJORITY.SHARE and few:
        return Verdict(Strategy.PROFILE, count, Message("long-strokes"))
    return Verdict(Strategy.ENGRAVING, count, Message("short-strokes"))
