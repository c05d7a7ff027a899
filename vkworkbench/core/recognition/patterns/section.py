# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure a section, which is the moves that are judged as one operation."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.entries import without_entries
from vkworkbench.core.recognition.patterns.footprints import number_depths
from vkworkbench.core.recognition.patterns.pieces import LOOP, STROKE, WINDING, ZIGZAG, Pieces, cut_pieces, off_line
from vkworkbench.core.recognition.patterns.rings import Rings, relate_rings
from vkworkbench.core.recognition.patterns.rows import Rows, filling, find_rows
from vkworkbench.core.recognition.patterns.spurs import without_spurs
from vkworkbench.core.recognition.patterns.strokes import Strokes, relate_strokes
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

_LOW = np.array([1.0, 1.0, -1.0, -1.0])  # factors of a box's sides; the minimum over several boxes is the outer side


class Corrections(NamedTuple):
    """Turns of k rings against the sense of the winding; the values are 0 for closed loops.

    Attributes
    ----------
    angle : (k,) float
        Sum of the turns against the sense of the winding, rad.
    places : (k,) int
        Number of places with a turn against the sense of the winding.
    """

    angle: np.ndarray
    places: np.ndarray


class Section:
    """The moves that are judged as one operation. Every measure is computed at its first use, and cached.

    Parameters
    ----------
    areas : Areas
        At least one move.
    tool : float
        Tool diameter, mm; 0 if unknown.

    Attributes
    ----------
    moves : Areas
        The moves of `areas` without leads and spurs (detours out and back on one line), and with the parts of contours
        that are lifted over holding tags joined.
    wound : float
        Share of the section's length in helical lead-ins, which are not in `moves`.
    in_strokes : float
        Share of the section's length in contours whose parts between holding tags are cut separately.
    """

    def __init__(self, areas: Areas, tool: float) -> None:
        self.areas, self.tool = areas, tool
        joined, self.in_strokes = joined_over_tags(areas)
        pattern, self.wound = without_entries(joined)
        self.moves = without_spurs(pattern)

    @cached_property
    def pieces(self) -> Pieces:
        """The p pieces (loops, turns of windings, zigzags and strokes) of the section's moves."""
        return cut_pieces(self.moves)

    @cached_property
    def length(self) -> float:
        """Length of all moves of the section, without leads and spurs, mm."""
        return float(self.pieces.length.sum())

    @cached_property
    def _slots(self) -> np.ndarray:
        return _retraced(self.moves, self.pieces)

    @cached_property
    def _kinds(self) -> np.ndarray:
        """Kind of each piece, (p,) int: LOOP, WINDING, ZIGZAG or STROKE.

        A small loop between the rows of a zigzag has the kind ZIGZAG; a slot cut back and forth has the kind STROKE.
        """
        kinds = _absorbed(self.pieces)
        kinds[self._slots] = STROKE
        return kinds

    @cached_property
    def zigzag(self) -> float:
        """Share of the section's length in zigzags."""
        return float((self.pieces.length * (self._kinds == ZIGZAG)).sum()) / self.length

    @cached_property
    def retraced(self) -> float:
        """Share of the section's length in zigzags on one line, such as slots cut back and forth."""
        return float(self.pieces.length[self._slots].sum()) / self.length

    @cached_property
    def rings(self) -> Rings:
        """The k closed loops and turns of windings."""
        index = _long(self.pieces, (self._kinds == LOOP) | (self._kinds == WINDING))
        return relate_rings(self.pieces, index, self.tool)

    @cached_property
    def strokes(self) -> Strokes:
        """The open strokes. Strokes of a short total length are links and are left out."""
        opened = self._kinds == STROKE
        if self.pieces.length[opened].sum() < NEGLIGIBLE.LINKS * self.length:
            opened[:] = False
        return relate_strokes(self.pieces, _long(self.pieces, opened))

    @cached_property
    def _corrections(self) -> Corrections:
        return _turned_against(self.moves, self.pieces, self.rings)

    @cached_property
    def aside(self) -> np.ndarray:
        """Whether each ring turns against the sense of its winding to step aside to the next ring, (k,) bool."""
        return self._corrections.angle > WINDINGS.STEP_ASIDE * TURN

    @cached_property
    def hunting(self) -> np.ndarray:
        """Whether each ring constantly corrects its direction, (k,) bool, as adaptive clearing does.

        Adaptive clearing corrects its direction to keep the engagement constant. Concave corners and links to the next
        loop are larger turns at few places, and are not corrections.
        """
        angle, places = self._corrections
        small: np.ndarray = (places >= WINDINGS.CORRECTIONS) & (angle < WINDINGS.CORRECTION * places)
        return self.pieces.flat[self.rings.index] & small

    @cached_property
    def lattice(self) -> np.ndarray:
        """Whether each ring possibly consists of rows, (k,) bool.

        Passes that bounce from wall to wall (a lattice) can look like a winding by chance.
        """
        rings = self.rings
        wavy = self.pieces.wavy[rings.index]
        # Wavy loops that are offsets of each other follow a concave contour and are not rows.
        if wavy.any() and rings.nested[wavy].mean() > MAJORITY.SHARE:
            wavy[:] = False
        bouncing = rings.winding & ~self.hunting & (rings.back > WINDINGS.LATTICE_TURN * TURN)
        return ~rings.nested & (rings.crossing | bouncing | wavy)

    @cached_property
    def _rowlike(self) -> np.ndarray:
        """Whether each piece possibly contains rows, (p,) bool."""
        rowlike = (self._kinds == ZIGZAG) | (self._kinds == STROKE)
        rowlike[self.rings.index[self.lattice]] = True
        return rowlike

    @cached_property
    def families(self) -> list[Rows]:
        """The families of rows, at most two. A family consists of all parallel passes along one axis."""
        pieces, rowlike = self.pieces, self._rowlike
        if float(pieces.length[rowlike].sum()) <= NEGLIGIBLE.ROWS * self.length:
            return []  # pieces that are short in total are links between loops
        if rowlike.all():
            return find_rows(self.moves, np.arange(len(self.moves)))
        return find_rows(self.moves, np.flatnonzero(np.repeat(rowlike, pieces.end - pieces.start)))

    @cached_property
    def rows(self) -> list[Rows]:
        """Families of rows that cover an area, like the rows in a pocket."""
        length, rowlike = self.pieces.length, self._rowlike
        searched = float(length[rowlike].sum())
        contour = length[rowlike & (self._kinds == LOOP)].sum() > MAJORITY.SHARE * searched
        return filling(self.families, self.tool, length=searched, contour=contour)

    @cached_property
    def _closed_rows(self) -> np.ndarray:
        """Whether each piece is a ring that consists of two neighbouring rows and links, (p,) bool."""
        moves, pieces, rings = self.moves, self.pieces, self.rings
        closed = np.zeros(len(pieces), bool)
        if self.rows and len(rings):
            main = max(self.rows, key=lambda family: family.length)
            along = (
                np.abs(moves.dx * np.cos(main.axis) + moves.dy * np.sin(main.axis))
                > np.cos(ROWS.ALIGNED) * moves.length
            )
            of_rows = np.add.reduceat(np.where(along, moves.length, 0.0), pieces.start)[rings.index]
            narrow = 2 * np.abs(pieces.enclosed[rings.index]) < ROWS.MAX_DISTANCE * main.step * of_rows
            closed[rings.index] = narrow & (of_rows > MAJORITY.SHARE * rings.length) & ~rings.nested
        return closed

    @cached_property
    def ring_pieces(self) -> np.ndarray:
        """Whether each piece counts as a ring, (p,) bool."""
        chosen = ~(self._rowlike | self._closed_rows) if self.rows else np.ones(len(self.pieces), bool)
        found = np.zeros(len(self.pieces), bool)
        found[self.rings.index] = chosen[self.rings.index]
        return found

    @cached_property
    def row_pieces(self) -> np.ndarray:
        """Whether each piece counts as a row or a stroke, (p,) bool."""
        return (self._rowlike | self._closed_rows) & ~self.ring_pieces

    def share(self, rings: np.ndarray) -> float:
        """Return the share of the section's cutting length in the chosen rings."""
        return float(self.rings.length[rings].sum()) / self.length

    def part(self, strokes: np.ndarray) -> float:
        """Return the share of the section's cutting length in the chosen strokes."""
        return float(self.strokes.length[strokes].sum()) / self.length

    def cornered(self) -> float:
        """Return the share of the windings' total turning angle that is in corners.

        A spiral turns continually. Polygons that step to the next polygon in a corner also wind in one sense, but turn
        only in corners.
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
        """Return whether the cut at most depths (weighted by length) ends with a large contour, a finishing pass.

        A finishing contour is larger, in both directions, than half of the bounding box of everything that is cut at
        its depth.
        """
        pieces = self.pieces
        level = np.flatnonzero(pieces.flat & (pieces.length > NEGLIGIBLE.PASS * pieces.length.max()))
        if not len(level):
            return False
        depth = number_depths(pieces.z[level])
        around, last = np.full((int(depth.max()) + 1, 4), np.inf), np.zeros(int(depth.max()) + 1, np.int64)
        np.minimum.at(around, depth, pieces.box[level] * _LOW)
        last[depth] = level  # the last piece cut at each depth, because numpy keeps the last of several assignments
        large = pieces.box[last, 2:] - pieces.box[last, :2] > -MAJORITY.SHARE * (around[:, :2] + around[:, 2:])
        ends = (pieces.kind[last] == LOOP) & large.all(axis=1) & (np.bincount(depth) > 2)
        return bool(pieces.length[level][ends[depth]].sum() > MAJORITY.SHARE * pieces.length[level].sum())

    def bordered(self) -> tuple[float, float]:
        """Return how much of the rows is inside rings, and how much of the rings is amid rows, at the same depths.

        Returns
        -------
        float
            Share of the rows' length inside a ring, which is the contour of the walls around the rows.
        float
            Share of the rings' length in contours of islands: horizontal rings that are not nested and lie amid rows.
        """
        pieces, row, ring = self.pieces, np.flatnonzero(self.row_pieces), self.rings.index
        if not len(row) or not len(ring):
            return 0.0, 0.0
        depth = number_depths(np.concatenate([pieces.z[row], pieces.z[ring]]))
        of_row, of_ring, depths = depth[: len(row)], depth[len(row) :], int(depth.max()) + 1
        # Compare the rows with the largest rings of each depth, because smaller rings go around islands or lie inside
        # other rings.
        order = np.lexsort((-np.hypot(*(pieces.box[ring, 2:] - pieces.box[ring, :2]).T), of_ring))
        rank = np.arange(len(ring)) - np.searchsorted(of_ring[order], of_ring[order])
        inside = np.zeros(len(row), bool)
        for place in np.unique(rank)[: RINGS.WALLS]:
            wall, largest = np.full((depths, 4), np.nan), order[rank == place]
            wall[of_ring[largest]] = pieces.box[ring[largest]]
            inside |= _inward(pieces.box[row], wall[of_row]) >= -ROUNDING.PLACE
        ground = np.full((depths, 4), np.inf)
        np.minimum.at(ground, of_row, pieces.box[row] * _LOW)
        amid = (
            pieces.flat[ring]
            & ~self.rings.nested
            & (_inward(pieces.box[ring], ground[of_ring] * _LOW) >= -ROUNDING.PLACE)
        )
        of_rows = float(pieces.length[row[inside]].sum() / pieces.length[row].sum())
        return of_rows, float(self.rings.length[amid].sum() / self.rings.length.sum())

    def _beside(self, strokes: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Yield the first ring cut after each of the given strokes, (s,) int, and then the last ring cut before each.

        Rings and strokes are given by the indices of their pieces. With each of the two arrays of rings, the iterator
        yields how far the strokes lie inside the rings' bounding boxes, mm, and whether stroke and ring have the same
        depth.
        """
        pieces, ring = self.pieces, self.rings.index
        after = np.clip(np.searchsorted(ring, strokes), 0, len(ring) - 1)
        for beside in (ring[after], ring[np.maximum(after - 1, 0)]):
            yield (
                beside,
                _inward(pieces.box[strokes], pieces.box[beside]),
                np.abs(pieces.z[strokes] - pieces.z[beside]) < ROUNDING.HEIGHT,
            )

    def filled(self) -> float:
        """Return the share of the cutting length in open strokes that clear the inside of a ring.

        The ring is the ring cut last before or first after the stroke, at the same depth. A stroke that clears goes
        back and forth; a stroke of one pass is a lead. A stroke that clears lies within the tool's reach of the ring. A
        stroke that clears encloses less area for its length than the ring; a stroke that encloses as much is a
        repetition of the ring.
        """
        pieces, strokes = self.pieces, self.strokes.index
        strokes = strokes[pieces.passes[strokes] > 1]
        if not len(strokes):
            return 0.0
        inside = np.zeros(len(strokes), bool)
        width = np.abs(pieces.enclosed) / pieces.length
        for beside, gap, level in self._beside(strokes):
            within = (gap >= -ROUNDING.PLACE) & ((gap < NESTS.REACH * self.tool) | (self.tool == 0))
            inside |= level & within & (width[strokes] < POCKET.WIDTH * width[beside])
        return float(pieces.length[strokes[inside]].sum()) / self.length


def _inward(inner: np.ndarray, outer: np.ndarray) -> np.ndarray:
    """Return how far boxes `inner` (k, 4) lie inside boxes `outer` (k, 4), the smallest of four sides, (k,) mm."""
    return ((inner - outer) * _LOW).min(axis=1)


def _absorbed(pieces: Pieces) -> np.ndarray:
    """Return the kind of each piece, where small loops inside a zigzag have the kind ZIGZAG.

    A zigzag that follows the boundary between its rows makes small loops. A loop is a contour, and not a part of the
    zigzag, only if the loop surrounds the zigzag's rows.
    """
    kind = pieces.kind.copy()
    zigzag = np.flatnonzero(kind == ZIGZAG)
    if not len(zigzag) or not (kind == LOOP).any():
        return kind
    around = np.full((int(pieces.area[-1]) + 1, 4), np.nan)
    around[pieces.area[zigzag]] = pieces.box[zigzag]
    box = around[pieces.area]
    low, high = box[:, :2], box[:, 2:]
    slack = RINGS.SURROUNDS * (high - low)
    surrounds = (pieces.box[:, :2] <= low + slack).all(axis=1) & (pieces.box[:, 2:] >= high - slack).all(axis=1)
    kind[(kind == LOOP) & ~np.isnan(box[:, 0]) & ~surrounds & ~pieces.wavy] = ZIGZAG
    return kind


def _retraced(moves: Areas, pieces: Pieces) -> np.ndarray:
    """Return the indices of zigzags that stay on one line and so are not rows, such as ramps into a slot."""
    index = np.flatnonzero(pieces.kind == ZIGZAG)
    # Zigzags on a line enclose no area.
    index = index[np.abs(pieces.enclosed[index]) < ROUNDING.PLACE * pieces.length[index]]
    return index[off_line(moves, pieces.start[index], pieces.end[index]) < ROUNDING.PLACE]


def _long(pieces: Pieces, which: np.ndarray) -> np.ndarray:
    """Return the indices of the chosen pieces without short pieces, which are links and leads."""
    index = np.flatnonzero(which)
    if not len(index):
        return index
    length = pieces.length[index]
    return index[length > NEGLIGIBLE.PIECE * length.max()]


def _turned_against(moves: Areas, pieces: Pieces, rings: Rings) -> Corrections:
    """Return the turns of each winding that are opposite to its sense of rotation.

    Bends within rounding do not count, because finely sampled spirals have many such bends.
    """
    number = len(rings)
    if not rings.winding.any():
        return Corrections(np.zeros(number), np.zeros(number, np.int64))
    ring_of_piece = np.full(len(pieces), -1)
    ring_of_piece[rings.index[rings.winding]] = np.flatnonzero(rings.winding)
    ring = np.repeat(ring_of_piece, pieces.end - pieces.start)
    inside = np.flatnonzero(ring >= 0)
    ring = ring[inside]
    against = -moves.turning[inside] * np.sign(pieces.net[rings.index])[ring]
    begin = np.flatnonzero(np.append(True, ((against[1:] > 0) != (against[:-1] > 0)) | (ring[1:] != ring[:-1])))
    bend, ring = np.add.reduceat(against, begin), ring[begin]
    counts = bend * np.add.reduceat(moves.length[inside], begin) > WINDINGS.ROUGH
    bend, ring = bend[counts], ring[counts]
    return Corrections(np.bincount(ring, weights=bend, minlength=number), np.bincount(ring, minlength=number))
