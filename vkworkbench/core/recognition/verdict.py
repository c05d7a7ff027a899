# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decision: which strategy the pieces of one section stand for, and how sure that is."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.pieces import CURVE, LINE, LOOP, WINDING, ZIGZAG, Pieces, cut_pieces
from vkworkbench.core.recognition.rings import Rings, relate_rings
from vkworkbench.core.recognition.rows import Rows, find_rows
from vkworkbench.core.recognition.strokes import Strokes, find_arcs, relate_strokes
from vkworkbench.core.strategy import Strategy

ENTERED = "a winding with a helical entry or bites out of the corners"
ASIDE = 0.15 * TURN  # a winding that turns more than this to and fro steps aside to the next loop
ROUGH = 0.05  # rad mm; what bends less over its length may be rounding to 0.01 mm
SMALL = 0.02  # of the longest ring or stroke; shorter ones are links and leads


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
    seen : str
        What shows it, without the numbers.
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
    seen: str
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
        return float(0.62 + 0.35 * margin * (1 - np.exp(-self.count / 1.5)))


@dataclass
class Section:
    """A stretch of moves judged as one, with everything that was measured on the way."""

    moves: Areas
    tool: float
    pieces: Pieces = field(init=False)
    rings: Rings = field(init=False)
    aside: np.ndarray = field(init=False)
    hunting: np.ndarray = field(init=False)
    strokes: Strokes = field(init=False)
    rows: list[Rows] = field(init=False)

    def __post_init__(self) -> None:
        self.pieces = cut_pieces(self.moves)
        p = self.pieces
        self.length = float(p.length.sum())
        kind = _absorb(p)
        self.rings = relate_rings(p, _large(p, (kind == LOOP) | (kind == WINDING)), self.tool)
        opened = (kind == LINE) | (kind == CURVE)
        if p.length[opened].sum() < 0.02 * self.length:
            opened[:] = False  # the links between loops
        self.strokes = relate_strokes(p, _large(p, opened))
        # Lattices of bouncing passes, and wavy loops that are no offsets of one another, may be rows.
        r = self.rings
        wavy = p.wavy[r.index]
        if wavy.any() and r.nested[wavy].mean() > 0.5:
            wavy[:] = False
        against, places = _against(self.moves, p, r)
        self.aside = against > ASIDE / 2  # what turns aside turns as much back again
        # Adaptive clearing from outside the stock corrects its direction all the time to keep one engagement.
        # Concave corners and links to the next loop turn more at once, at few places.
        self.hunting = p.flat[r.index] & (places >= 8) & (against < np.radians(10) * places)
        bouncing = r.winding & ~self.hunting & (r.back > 0.75 * TURN)
        self.lattice = ~r.nested & (r.crossing | bouncing | wavy)
        rowlike = (kind == ZIGZAG) | (kind == LINE) | (kind == CURVE)
        rowlike[r.index[self.lattice]] = True
        self.zigzag = float(p.length[kind == ZIGZAG].sum()) / self.length
        length = float(p.length[rowlike].sum())
        self.rows: list[Rows] = []
        if length > 0.1 * self.length:  # less are the links between loops
            chosen = np.arange(len(self.moves))
            if not rowlike.all():
                chosen = np.flatnonzero(np.repeat(rowlike, p.end - p.start))
            closed = p.length[rowlike & (kind == LOOP)].sum() > 0.9 * length
            self.rows = self._fill(find_rows(self.moves, chosen), length, closed)
        self.ring_pieces = np.zeros(len(p), bool)
        self.ring_pieces[r.index] = True
        if self.rows:
            self.ring_pieces[r.index[self.lattice]] = False
        self.row_pieces = rowlike & ~self.ring_pieces

    def _fill(self, families: list[Rows], length: float, closed: bool) -> list[Rows]:
        """Keep the families of rows that fill an area."""
        good = [f for f in families if _fills(f, self.tool) and not (closed and _walls(f, self.tool))]
        if good or len(families) < 2:
            return good
        # The passes of a grid come in the order of a billiard, not side by side; two families of many long
        # rows that are everything there is fill the area all the same.
        everything = sum(f.length for f in families) > 0.85 * length
        if everything and all(f.count >= 8 and f.typical > 2.5 * f.pitch for f in families):
            return families
        return []

    def share(self, rings: np.ndarray) -> float:
        """Share of the cutting length in these rings."""
        return float(self.rings.length[rings].sum()) / self.length

    def part(self, strokes: np.ndarray) -> float:
        """Share of the cutting length in these strokes."""
        return float(self.strokes.length[strokes].sum()) / self.length


def _fills(f: Rows, tool: float) -> bool:
    """Whether passes lie side by side as rows do: long moves, short steps between them (paper, section
    2.1)."""
    # In teeth as narrow as two steps the rows are short, but many and even.
    long = 1.5 if f.lines >= 10 and f.even > 0.8 else 2.5
    if f.opposite + f.same <= 0.25 * f.length or f.typical <= long * f.step:
        return False
    if f.step < 0.03 * tool:
        return False  # the same pass retraced
    regular = f.count >= 3 and f.even > 0.5
    # Many even steps say that the tool is wrong, but not where other rows lie between: those are two walls.
    if tool and f.step > 1.2 * tool and not (f.count >= 6 and f.even > 0.8 and f.pitch > 0.6 * f.step):
        return False
    return regular or (f.count == 2 and f.typical > 10 * f.step and 0.1 * tool < f.step <= tool)


def _walls(f: Rows, tool: float) -> bool:
    """Whether passes of a closed contour are the walls of its teeth: gaps and teeth take turns, or are too wide to be
    cut from row to row. A zigzag seldom comes back to its start, a contour always.
    """
    return f.period > 1.05 * f.pitch or bool(tool) and f.step > 1.2 * tool


def _absorb(p: Pieces) -> np.ndarray:
    """Return the kinds with those loops made part of a zigzag that do not go around it.

    A zigzag that runs along the boundary between its rows closes small loops; only one that encloses the
    rows is a contour of its own.
    """
    kind = p.kind.copy()
    zigzag = np.flatnonzero(kind == ZIGZAG)
    if not len(zigzag) or not (kind == LOOP).any():
        return kind
    around = np.full((int(p.area[-1]) + 1, 4), np.nan)
    around[p.area[zigzag]] = p.box[zigzag]
    box = around[p.area]
    slack = 0.15 * (box[:, 2:] - box[:, :2])
    encloses = (p.box[:, :2] <= box[:, :2] + slack).all(axis=1) & (p.box[:, 2:] >= box[:, 2:] - slack).all(
        axis=1
    )
    kind[(kind == LOOP) & ~np.isnan(box[:, 0]) & ~encloses & ~p.wavy] = ZIGZAG
    return kind


def _large(p: Pieces, which: np.ndarray) -> np.ndarray:
    """Return the indices of these pieces without the links and leads."""
    index = np.flatnonzero(which)
    if not len(index):
        return index
    length = p.length[index]
    return index[length > SMALL * length.max()]


def _against(moves: Areas, p: Pieces, r: Rings) -> tuple[np.ndarray, np.ndarray]:
    """Return how much each winding turns against its sense, rad, and at how many places.

    What rounding could bend does not count: finely sampled spirals are full of it.
    """
    angle, places = np.zeros(len(r)), np.zeros(len(r), np.int64)
    some = np.flatnonzero(r.winding & (r.back > 0.1))  # less is nothing
    if len(some):
        ring = np.full(len(p), -1)
        ring[r.index[some]] = some
        of = np.repeat(ring, p.end - p.start)
        inside = np.flatnonzero(of >= 0)
        of = of[inside]
        turning = -moves.turning[inside] * np.sign(p.net[r.index])[of]
        run = np.flatnonzero(np.append(True, ((turning[1:] > 0) != (turning[:-1] > 0)) | (of[1:] != of[:-1])))
        bent, of = np.add.reduceat(turning, run), of[run]
        true = bent * np.add.reduceat(moves.length[inside], run) > ROUGH
        angle = np.bincount(of[true], weights=bent[true], minlength=len(r))
        places = np.bincount(of[true], minlength=len(r))
    return angle, places


def judge(s: Section) -> Verdict:
    """Judge a section by its rings, its rows or its open strokes, whichever it is made of."""
    rings = s.share(s.ring_pieces[s.rings.index])
    opened = 1 - rings
    rowlike = max(s.zigzag, sum(f.length for f in s.rows) / s.length)
    if rowlike > 0.5 * opened:
        rowlike = opened  # the rest are the links
    arcs = _judge_arcs(s) if rings < 0.7 and rowlike < 0.5 else None
    bites, against = s.part(s.strokes.bite), s.part(s.strokes.against)
    number = int(s.strokes.bite.sum())
    many = (bites > 0.25 and number >= 4) or (bites > 0.1 and number >= 10)
    circles = arcs is not None and arcs.strategy is Strategy.CONTOUR_PARALLEL  # bites change their radius
    if many and not circles and against < 0.3 * bites and rowlike < 0.5:
        return Verdict(Strategy.ADAPTIVE, 0.6 + 0.4 * bites, number, f"{number} bites of one sense overlap")
    if arcs:
        return arcs
    # What a hunting tool leaves between its windings it cuts in rows and bites.
    hunting, nested = s.share(s.hunting), s.share(s.rings.nested)
    if rings > 0.3 and min(hunting, nested) > 0.5 * rings:
        return Verdict(Strategy.ADAPTIVE, hunting / rings, len(s.rings), "one winding that never closes")
    # Offsets whose innermost loops degenerate to passes are still offsets.
    offsets = rings > 0.7 and nested > 0.7 * rings
    if rings > 0.88 or offsets or (rings > 0.35 and (rowlike < 0.15 or not s.rows)):
        return _judge_rings(s, rings)
    of_rows = _judge_rows(s, rowlike)
    both = rings > 0.1 and rowlike > 0.15 and of_rows.count >= 5
    if rowlike < 0.35 and not both:
        return _judge_strokes(s)
    if not both:
        return of_rows
    of_rings = _judge_rings(s, rings)
    seen = f"rows ({rowlike:.0%} of the length) and loops ({rings:.0%}) share the area"
    return Verdict(
        Strategy.MIXED, min(1.0, 0.6 + 2 * rings, 0.6 + 2 * rowlike), of_rows.count, seen, (of_rings, of_rows)
    )


def _judge_rings(s: Section, rings: float) -> Verdict:
    r = s.rings
    helix = s.share(r.stacked & r.sloped & r.round)
    # Circles among other contours ramped in the same way are profiles, too.
    if helix > 0.5 * rings and s.share(r.round) > 0.85 * rings:
        # A level winding that goes on outward clears a pocket, however long the helix that leads into it.
        clears = r.nested & r.winding & ~r.sloped & ~r.stacked
        if (clears[1:] & clears[:-1]).sum() >= 2:
            return Verdict(Strategy.ADAPTIVE, (helix + s.share(clears)) / rings, len(r), ENTERED)
        return Verdict(Strategy.HELIX, helix / rings, len(r), "descending at a constant radius")
    opposite = s.share(r.opposite)
    if opposite > 0.6 * rings:
        return Verdict(Strategy.ZIGZAG, opposite / rings, len(r), "the sense of nested loops alternates")
    nested, deeper = s.share(r.nested), s.share(r.deeper)
    changing = (
        r.levels >= 3 and r.distinct > 0.4 * len(r) and deeper > 0.3 * rings and r.depth > 0.35 * s.tool
    )
    if changing and deeper > nested:
        if r.evenness < 0.5:
            seen = "evenly spaced in the plane, not in depth"
            return Verdict(Strategy.CONTOUR_PARALLEL, deeper / rings, len(r), seen, rival=nested / rings)
        seen = "whose shape changes with the depth"
        return Verdict(Strategy.WATERLINE, deeper / rings, r.levels, seen, rival=nested / rings)
    if nested > 0.5 * rings and (len(r) > 2 or rings > 0.75):
        winding = s.share(r.winding)
        linked = s.share(s.aside)
        if winding > 0.5 * rings and linked < 0.5 * winding:
            # A spiral that its boundary clips leaves arcs around its centre, which are judged before.
            bitten = s.part(s.strokes.bite) > 0.03 and s.strokes.bite.sum() >= 5
            if bitten or helix > 0.005 or s.strokes.length.sum() > 0.3 * s.length:
                return Verdict(Strategy.ADAPTIVE, winding / rings, len(r), ENTERED)
            if _cornered(s) < 0.5:
                return Verdict(Strategy.SPIRAL, winding / rings, len(r), "one winding that never closes")
        rival = deeper / rings if changing else 0.0
        return Verdict(Strategy.CONTOUR_PARALLEL, nested / rings, len(r), "nested", rival=rival)
    moved = s.share(r.moved)
    if moved > 0.4 * rings and len(r) >= 5:
        return Verdict(Strategy.ADAPTIVE, moved / rings, len(r), "small loops move along")
    if s.share(r.alone) > 0.5 * rings and _inside(s) > 0.1:
        return Verdict(Strategy.MIXED, 0.5, 2, "an open pass lies inside a contour")
    # A loop that comes again shows a contour; loops with no relation to any other are contours by default.
    support = 0.6 + 0.4 * s.share(r.repeated) / rings
    rival = max(nested, deeper if changing else 0.0, moved if len(r) >= 5 else 0.0) / rings
    return Verdict(Strategy.PROFILE, support, len(r) + 2, "no nested offsets", rival=rival)


def _cornered(s: Section) -> float:
    """Share of the turning of the windings that is in corners of more than 30 degrees.

    A spiral turns all the time; polygons that step aside in a corner wind without ever turning back, too.
    """
    p, winding = s.pieces, s.rings.index[s.rings.winding]
    chosen = np.zeros(len(p), bool)
    chosen[winding] = True
    turning = np.abs(s.moves.turning[np.repeat(chosen, p.end - p.start)])
    return float(turning[turning > np.pi / 6].sum() / max(turning.sum(), 1e-9))


def _judge_rows(s: Section, rowlike: float) -> Verdict:
    opposite, same = sum(f.opposite for f in s.rows), sum(f.same for f in s.rows)
    count = sum(f.count for f in s.rows)
    if opposite >= same or s.zigzag > 0.5 * rowlike:
        agree = opposite / (opposite + same) if opposite + same else 1.0
        support = rowlike * max(agree, s.zigzag)
        return Verdict(Strategy.ZIGZAG, support, max(count, 3), "half-turns alternate in sign")
    return Verdict(Strategy.ONE_WAY, rowlike * same / (opposite + same), count, "all rows run the same way")


def _judge_arcs(s: Section) -> Verdict | None:
    """Judge circles that the boundary cuts open: rows around a centre in place of along an axis."""
    arcs = find_arcs(s.moves, s.pieces, np.union1d(s.strokes.index, s.rings.index))
    if arcs is None or arcs.count < 5 or arcs.even < 0.5 or arcs.length < 0.65 * s.length:
        return None
    if arcs.opposite + arcs.same < 0.3 * arcs.length:
        return None  # the next is not beside it
    strategy, seen = Strategy.CONTOUR_PARALLEL, "nested"
    if arcs.opposite > arcs.same:
        strategy, seen = Strategy.ZIGZAG, "half-turns alternate in sign"
    elif arcs.spiral > 0.8 * arcs.length:
        strategy, seen = Strategy.SPIRAL, "one winding that never closes"
    return Verdict(strategy, arcs.length / s.length, arcs.count, seen, step=arcs.step)


def _judge_strokes(s: Section) -> Verdict:
    k = s.strokes
    sloped = s.part(k.sloped)
    number = len(k)
    if k.levels >= 4 and sloped < 0.2 and k.distinct > 0.5 * number:
        return Verdict(Strategy.WATERLINE, 0.6, k.levels, "open contours change with the depth")
    if k.distinct <= 1 or k.distinct < 0.67 * number:
        seen = "one open contour" if number == 1 else "an open contour comes again"
        return Verdict(Strategy.PROFILE, 0.8, number + 1, seen)
    extent = s.pieces.box[:, 2:].max(axis=0) - s.pieces.box[:, :2].min(axis=0)
    if k.typical > 0.35 * extent.sum() and sloped < 0.5 and k.distinct <= 5:
        return Verdict(Strategy.PROFILE, 0.4, number, "open strokes as long as the part")
    return Verdict(Strategy.ENGRAVING, 0.8, number, "short strokes that fill nothing")


def _inside(s: Section) -> float:
    """Share of the cutting length in open strokes inside the ring cut before or after them, at its depth.

    Only strokes that come back beside themselves count: a single one leads in or out, and one that encloses
    as much for its length as the ring goes around itself. One that comes nowhere near the ring leaves ground
    uncut between them: that is another contour, which does not quite close.
    """
    p, k, ring = s.pieces, s.strokes.index, s.rings.index
    k = k[p.passes[k] > 1]
    if not len(k):
        return 0.0
    after = np.clip(np.searchsorted(ring, k), 0, len(ring) - 1)
    inside = np.zeros(len(k), bool)
    width = np.abs(p.enclosed) / p.length
    for beside in (ring[after], ring[np.maximum(after - 1, 0)]):
        box = p.box[beside]
        gap = np.column_stack([p.box[k, :2] - box[:, :2], box[:, 2:] - p.box[k, 2:]]).min(axis=1)
        within = (gap >= -0.02) & ((gap < 1.2 * s.tool) | (s.tool == 0))
        filling = width[k] < 0.75 * width[beside]
        inside |= within & filling & (np.abs(p.z[k] - p.z[beside]) < 0.02)
    return float(p.length[k[inside]].sum()) / s.length
