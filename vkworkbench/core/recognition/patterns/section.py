# SPDX-License-Identifier: LGPL-2.1-or-later
"""A section: moves that are judged as one operation, with their measures."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.entries import without_entries
from vkworkbench.core.recognition.patterns.footprints import number_depths
from vkworkbench.core.recognition.patterns.pieces import LOOP, STROKE, WINDING, ZIGZAG, Pieces, cut_pieces, off_line
from vkworkbench.core.recognition.patterns.rings import Rings, relate_rings
from vkworkbench.core.recognition.patterns.rows import Rows, filling, find_rows
from vkworkbench.core.recognition.patterns.spurs import without_spurs
from vkworkbench.core.recognition.patterns.strokes import relate_strokes
from vkworkbench.core.recognition.patterns.tags import joined_over_tags
from vkworkbench.core.recognition.thresholds import (
    LETTERS,
    MAJORITY,
    NEGLIGIBLE,
    NESTS,
    POCKET,
    RINGS,
    ROUNDING,
    ROWS,
    STROKES,
    WINDINGS,
)

_LOW = np.array([1.0, 1.0, -1.0, -1.0])  # with it the lowest of boxes are their outermost sides


class Section:
    """The measures of moves that are judged as one operation.

    Parameters
    ----------
    moves : Areas
        At least one.
    tool : float
        Tool diameter, mm; 0 where unknown.

    Attributes
    ----------
    areas : Areas
        The moves as given.
    moves : Areas
        The pattern: without leads and spurs, with contours over tags joined.
    wound : float
        Share of the length in helical lead-ins, which are not in `moves`.
    in_strokes : float
        Share of the length in contours that are cut in strokes with lifts between them.
    tool : float
        Tool diameter, mm; 0 if unknown.
    pieces : Pieces
    length : float
        Length of all pieces, mm.
    rings : Rings
    aside : (k,) bool
        Rings that step aside to the next ring: windings that turn against their sense and back.
    hunting : (k,) bool
        Rings with continual corrections of the direction, as in adaptive clearing, which keeps its engagement constant.
    lattice : (k,) bool
        Rings that may be rows: passes from wall to wall that wind by chance.
    strokes : Strokes
    families : list of Rows
        Families of parallel passes, at most two.
    rows : list of Rows
        Families that fill an area.
    zigzag : float
        Share of the length in pieces that go back and forth.
    retraced : float
        Share of the length in pieces that go back and forth on one line.
    ring_pieces, row_pieces : (p,) bool
        Pieces that count as rings; pieces that count as rows or strokes.
    """

    def __init__(self, moves: Areas, tool: float) -> None:
        self.areas = moves
        moves, self.in_strokes = joined_over_tags(moves)
        moves, self.wound = without_entries(moves)
        self.moves, self.tool = (moves := without_spurs(moves)), tool
        self.pieces = p = cut_pieces(moves)
        self.length = float(p.length.sum())
        kind = _absorbed(p)
        slots = _retraced(moves, p)
        kind[slots] = STROKE
        self.retraced = float(p.length[slots].sum()) / self.length
        self.rings = r = relate_rings(p, _long(p, (kind == LOOP) | (kind == WINDING)), tool)
        opened = kind == STROKE
        if p.length[opened].sum() < NEGLIGIBLE.LINKS * self.length:
            opened[:] = False
        self.strokes = relate_strokes(p, _long(p, opened))
        angle, places = _turned_against(moves, p, r)
        self.aside = angle > WINDINGS.STEP_ASIDE * TURN
        # Concave corners and links to the next loop are larger turns at few places.
        self.hunting = p.flat[r.index] & (places >= WINDINGS.CORRECTIONS) & (angle < WINDINGS.CORRECTION * places)
        # Wavy loops that are offsets of each other follow a concave contour and are not rows.
        wavy = p.wavy[r.index]
        if wavy.any() and r.nested[wavy].mean() > MAJORITY.SHARE:
            wavy[:] = False
        bouncing = r.winding & ~self.hunting & (r.back > WINDINGS.LATTICE_TURN * TURN)
        self.lattice = ~r.nested & (r.crossing | bouncing | wavy)
        rowlike = (kind == ZIGZAG) | (kind == STROKE)
        rowlike[r.index[self.lattice]] = True
        self.zigzag = float(p.length[kind == ZIGZAG].sum()) / self.length
        self.families, self.rows = self._rows(rowlike, rowlike & (kind == LOOP))
        self.ring_pieces = np.zeros(len(p), bool)
        self.ring_pieces[r.index] = True
        if self.rows:
            closed = r.index[self._two_rows()]
            rowlike[closed] = True
            self.ring_pieces[np.append(closed, r.index[self.lattice])] = False
        self.row_pieces = rowlike & ~self.ring_pieces

    def _rows(self, rowlike: np.ndarray, closed: np.ndarray) -> tuple[list[Rows], list[Rows]]:
        """Return `families` and `rows` of pieces that may contain rows; `closed` marks the loops among the pieces."""
        p = self.pieces
        length = float(p.length[rowlike].sum())
        if length <= NEGLIGIBLE.ROWS * self.length:
            return [], []  # the links between loops
        chosen = np.arange(len(self.moves))
        if not rowlike.all():
            chosen = np.flatnonzero(np.repeat(rowlike, p.end - p.start))
        contour = p.length[closed].sum() > MAJORITY.SHARE * length
        families = find_rows(self.moves, chosen)
        return families, filling(families, self.tool, length=length, contour=contour)

    def _two_rows(self) -> np.ndarray:
        """Return which rings are two neighbouring rows that are closed by links, (k,)."""
        m, p, k = self.moves, self.pieces, self.rings.index
        main = max(self.rows, key=lambda f: f.length)
        along = np.abs(m.dx * np.cos(main.axis) + m.dy * np.sin(main.axis)) > np.cos(ROWS.ALIGNED) * m.length
        of_rows = np.add.reduceat(np.where(along, m.length, 0.0), p.start)[k]
        narrow = 2 * np.abs(p.enclosed[k]) < ROWS.MAX_DISTANCE * main.step * of_rows
        result: np.ndarray = narrow & (of_rows > MAJORITY.SHARE * p.length[k]) & ~self.rings.nested
        return result

    def share(self, rings: np.ndarray) -> float:
        """Return the share of the cutting length in the chosen rings."""
        return float(self.rings.length[rings].sum()) / self.length

    def part(self, strokes: np.ndarray) -> float:
        """Return the share of the cutting length in the chosen strokes."""
        return float(self.strokes.length[strokes].sum()) / self.length

    def cornered(self) -> float:
        """Return the share of the turning of windings in corners.

        A spiral turns continually. Polygons that step aside to the next one in a corner also wind in one sense.
        """
        chosen = np.zeros(len(self.pieces), bool)
        chosen[self.rings.index[self.rings.winding]] = True
        turning = np.abs(self.moves.turning[np.repeat(chosen, self.pieces.end - self.pieces.start)])
        return float(turning[turning > WINDINGS.CORNER].sum() / max(turning.sum(), 1e-9))

    def letters(self) -> bool:
        """Return whether the rings are many small contours of different shapes, like letters."""
        box, length = self.pieces.box[self.rings.index], self.rings.length
        size = box[:, 2:] - box[:, :2]
        shapes = len(np.unique(np.rint(np.column_stack([size, length / 4]) / LETTERS.SHAPE), axis=0))
        extent = self.pieces.box[:, 2:].max(axis=0) - self.pieces.box[:, :2].min(axis=0)
        small = np.median(size.max(axis=1)) < LETTERS.SMALL * extent.max()
        shallow = self.rings.depths <= LETTERS.DEPTHS
        return bool(small and shallow and shapes >= LETTERS.COUNT and shapes > STROKES.DISTINCT * self.rings.distinct)

    def ends_with_contour(self) -> bool:
        """Return whether the cutting ends with a large closed contour at the depths of most of the length: a finishing pass.

        A contour around the part and a contour inside a pocket are both larger than half of the ground that is cut.
        """
        p = self.pieces
        k = np.flatnonzero(p.flat & (p.length > NEGLIGIBLE.PASS * p.length.max()))
        if not len(k):
            return False
        depth = number_depths(p.z[k])
        around, last = np.full((int(depth.max()) + 1, 4), np.inf), np.zeros(int(depth.max()) + 1, np.int64)
        np.minimum.at(around, depth, p.box[k] * _LOW)
        last[depth] = k  # of several pieces of one depth, numpy keeps the last
        large = p.box[last, 2:] - p.box[last, :2] > -MAJORITY.SHARE * (around[:, :2] + around[:, 2:])
        ends = (p.kind[last] == LOOP) & large.all(axis=1) & (np.bincount(depth) > 2)
        return bool(p.length[k][ends[depth]].sum() > MAJORITY.SHARE * p.length[k].sum())

    def bordered(self) -> tuple[float, float]:
        """Return how much rows and rings of one depth belong together.

        Returns
        -------
        float
            Share of the rows' length inside a ring, which is the contour of their walls.
        float
            Share of the rings' length in single level rings amid rows, which are contours of islands.
        """
        p, k, ring = self.pieces, np.flatnonzero(self.row_pieces), self.rings.index
        if not len(k) or not len(ring):
            return 0.0, 0.0
        depth = number_depths(np.concatenate([p.z[k], p.z[ring]]))
        of_row, of_ring, depths = depth[: len(k)], depth[len(k) :], int(depth.max()) + 1
        # The largest rings of each depth; smaller rings go around islands or lie inside.
        order = np.lexsort((-np.hypot(*(p.box[ring, 2:] - p.box[ring, :2]).T), of_ring))
        rank = np.arange(len(ring)) - np.searchsorted(of_ring[order], of_ring[order])
        inside = np.zeros(len(k), bool)
        for place in np.unique(rank)[: RINGS.WALLS]:
            wall, largest = np.full((depths, 4), np.nan), order[rank == place]
            wall[of_ring[largest]] = p.box[ring[largest]]
            inside |= _inward(p.box[k], wall[of_row]) >= -ROUNDING.PLACE
        rows = np.full((depths, 4), np.inf)
        np.minimum.at(rows, of_row, p.box[k] * _LOW)
        amid = p.flat[ring] & ~self.rings.nested & (_inward(p.box[ring], rows[of_ring] * _LOW) >= -ROUNDING.PLACE)
        of_rows = float(p.length[k[inside]].sum() / p.length[k].sum())
        return of_rows, float(self.rings.length[amid].sum() / self.rings.length.sum())

    def _beside(self, k: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Yield the rings cut after pieces k, (k,) int, and the rings cut before them, as pieces.

        Each with the distance of the piece inside the ring's box, mm, and whether both have the same depth.
        """
        p, ring = self.pieces, self.rings.index
        after = np.clip(np.searchsorted(ring, k), 0, len(ring) - 1)
        for beside in (ring[after], ring[np.maximum(after - 1, 0)]):
            yield beside, _inward(p.box[k], p.box[beside]), np.abs(p.z[k] - p.z[beside]) < ROUNDING.HEIGHT

    def filled(self) -> float:
        """Return the share of the cutting length in open strokes that clear the inside of a ring.

        The ring was cut before or after the strokes at the same depth. The strokes go back and forth; a stroke of one pass is a
        lead. No part of a stroke is farther from the ring than the tool reaches; otherwise ground stays uncut, and the stroke is
        another contour that does not quite close. A stroke encloses little area with its chord for its length; a stroke that
        encloses as much as the ring is a repetition of the ring.
        """
        p, k = self.pieces, self.strokes.index
        k = k[p.passes[k] > 1]
        if not len(k):
            return 0.0
        inside = np.zeros(len(k), bool)
        width = np.abs(p.enclosed) / p.length
        for beside, gap, level in self._beside(k):
            within = (gap >= -ROUNDING.PLACE) & ((gap < NESTS.REACH * self.tool) | (self.tool == 0))
            inside |= level & within & (width[k] < POCKET.WIDTH * width[beside])
        return float(p.length[k[inside]].sum()) / self.length


def _inward(inner: np.ndarray, outer: np.ndarray) -> np.ndarray:
    """Return the smallest distance of the sides of boxes (k, 4) inside other boxes (k, 4), (k,) mm."""
    least: np.ndarray = ((inner - outer) * _LOW).min(axis=1)
    return least


def _absorbed(p: Pieces) -> np.ndarray:
    """Return the kinds of the pieces, with small loops inside a zigzag joined to the zigzag.

    A zigzag that follows the boundary between its rows makes small loops. Only a loop that surrounds the rows is a contour.
    """
    kind = p.kind.copy()
    zigzag = np.flatnonzero(kind == ZIGZAG)
    if not len(zigzag) or not (kind == LOOP).any():
        return kind
    around = np.full((int(p.area[-1]) + 1, 4), np.nan)
    around[p.area[zigzag]] = p.box[zigzag]
    box = around[p.area]
    low, high = box[:, :2], box[:, 2:]
    slack = RINGS.SURROUNDS * (high - low)
    surrounds = (p.box[:, :2] <= low + slack).all(axis=1) & (p.box[:, 2:] >= high - slack).all(axis=1)
    kind[(kind == LOOP) & ~np.isnan(box[:, 0]) & ~surrounds & ~p.wavy] = ZIGZAG
    return kind


def _retraced(moves: Areas, p: Pieces) -> np.ndarray:
    """Return the indices of zigzags that stay on one line, such as ramps into a slot. They are not rows."""
    index = np.flatnonzero(p.kind == ZIGZAG)
    # Zigzags on a line enclose no area.
    index = index[np.abs(p.enclosed[index]) < ROUNDING.PLACE * p.length[index]]
    on_line: np.ndarray = index[off_line(moves, p.start[index], p.end[index]) < ROUNDING.PLACE]
    return on_line


def _long(p: Pieces, which: np.ndarray) -> np.ndarray:
    """Return the indices of the chosen pieces without short ones, which are links and leads."""
    index = np.flatnonzero(which)
    if not len(index):
        return index
    length = p.length[index]
    result: np.ndarray = index[length > NEGLIGIBLE.PIECE * length.max()]
    return result


def _turned_against(moves: Areas, p: Pieces, r: Rings) -> tuple[np.ndarray, np.ndarray]:
    """Return the turning of each winding against its sense, rad, and the number of places.

    Bends within rounding do not count, because finely sampled spirals have many of them.
    """
    angle: np.ndarray = np.zeros(len(r))
    places: np.ndarray = np.zeros(len(r), np.int64)
    some = np.flatnonzero(r.winding)
    if len(some):
        ring = np.full(len(p), -1)
        ring[r.index[some]] = some
        of = np.repeat(ring, p.end - p.start)
        inside = np.flatnonzero(of >= 0)
        of = of[inside]
        turning = -moves.turning[inside] * np.sign(p.net[r.index])[of]
        run = np.flatnonzero(np.append(True, ((turning[1:] > 0) != (turning[:-1] > 0)) | (of[1:] != of[:-1])))
        bent, of = np.add.reduceat(turning, run), of[run]
        true = bent * np.add.reduceat(moves.length[inside], run) > WINDINGS.ROUGH
        angle = np.bincount(of[true], weights=bent[true], minlength=len(r))
        places = np.bincount(of[true], minlength=len(r))
    return angle, places
