# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a section measures, without a unit of length: the evidence that learned trees read."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.pieces import LOOP, WINDING
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import MEASURED, ROUNDING, WINDINGS
from vkworkbench.core.recognition.verdict.crossings import Sample, scan

FLAGS = ("nested", "sloped", "round", "stacked", "deeper", "alone", "moved", "opposite", "crossing")  # of rings


def measures(s: Section) -> dict[str, float]:
    """Return the measures of a section by name: shares, ratios, and logarithms of counts.

    None changes where the section is turned, mirrored, moved, scaled with the tool, or cut the other way round.
    """
    m = s.moves
    extent = float(np.hypot(np.ptp(m.x), np.ptp(m.y))) or 1.0  # of the starts of the moves, mm
    # Shares of the length need not look at every move.
    number = min(len(m), MEASURED.MOVES)
    sample = Sample.of(m, ((np.arange(number) + 0.5) * (len(m) / number)).astype(np.int64))
    return {
        **_of_areas(s, extent),
        **_of_moves(m, sample),
        **_of_turns(m),
        **_of_rings(s, extent),
        **_of_rows(s, extent),
        **_of_strokes(s, extent),
        **scan(m, sample, extent),
    }


def _of_areas(s: Section, extent: float) -> dict[str, float]:
    """Measure how the areas turn as a whole."""
    m = s.moves
    last = m.end - 1
    net = m.phi[last] - m.phi[m.start]
    turned = max(float(np.abs(m.turning).sum()), ROUNDING.HEIGHT)
    # The paper's quantities, area by area: how far phi ranges, its net turn, and V_k of the last trajectory.
    share, number = m.area_length / m.area_length.sum(), len(m.start)
    ranges = m.phi_extent / TURN
    turns = np.abs(net) / TURN
    v = np.hypot(m.x[last] + m.dx[last] - m.x[m.start], m.y[last] + m.dy[last] - m.y[m.start]) / m.area_length
    closed = v < MEASURED.CLOSED
    low, high = MEASURED.ONE_TURN
    return {
        "wound": s.wound,
        "longest_area": float(share.max()),
        "around_areas": float(share[ranges > 1].sum()),
        "rows_areas": float(share[ranges < MEASURED.HALF_TURN].sum()),
        "area_turns": float((share * np.log1p(turns)).sum()),
        "one_turn": float(share[closed & (turns > low) & (turns < high)].sum()),
        "closed_areas": float(share[closed].sum()),
        "area_v": float((share * v).sum()),
        "areas": float(np.log1p(number)),
        "area_length": float(np.log(s.length / number / extent)),
        "alike_areas": float(-np.log((share * share).sum() * number)),
        "turned": float(np.log1p(turned / TURN)),
        "turned_for_length": float(np.log1p(turned / TURN * extent / s.length)),
        "net_turn": float(np.abs(net).sum()) / turned,
        "one_sense": abs(float(net.sum())) / turned,
    }


def _of_moves(m: Areas, sample: Sample) -> dict[str, float]:
    """Measure directions, turns and heights of some moves by their length."""
    length, turned, climbs = sample.length, np.abs(m.turning[sample.chosen]), np.abs(m.dz[sample.chosen])
    total, whole = float(length.sum()), max(float(turned.sum()), ROUNDING.HEIGHT)
    return {
        "climbs": float(climbs.sum()) / total,
        "level": float(length[climbs <= ROUNDING.HEIGHT * length].sum()) / total,
        "corners": float(turned[turned > WINDINGS.CORNER].sum()) / whole,
        "smooth": float(turned[turned < WINDINGS.CORNER / 2].sum()) / whole,
        "one_way": float(np.hypot(sample.dx.sum(), sample.dy.sum())) / total,
        "one_axis": float(np.hypot(sample.double_x.sum(), sample.double_y.sum())) / total,
        "two_axes": float(np.hypot(sample.four_x.sum(), sample.four_y.sum())) / total,
    }


def _of_turns(m: Areas) -> dict[str, float]:
    """Measure how the image on the Gauss map goes to and fro, in moves from the middle of the time.

    A run of turns in one sense is an arc of that image: half turns where rows alternate, whole ones around a contour.
    Of walks and noise any turn is as likely as any other, and either sense follows.
    """
    spare = max(0, len(m) - MEASURED.TURNS)
    middle = slice(spare // 2, len(m) - (spare + 1) // 2)
    turning = m.signed[0][middle]
    at = np.flatnonzero(np.abs(turning) > MEASURED.TURN)
    spread = float(np.log(m.length[middle]).std())
    if not len(at):
        return {
            "half_arcs": 0.0,
            "short_arcs": 0.0,
            "long_arcs": 0.0,
            "sense_keeps": 0.0,
            "surprise": 0.0,
            "spread": spread,
        }
    turning, area = turning[at], np.searchsorted(m.start, at + middle.start, side="right")
    together = area[1:] == area[:-1]
    keeps = (turning[1:] > 0) == (turning[:-1] > 0)
    run = np.flatnonzero(np.append(True, ~(keeps & together)))
    arc = np.abs(np.add.reduceat(turning, run))
    whole = float(arc.sum())
    share = np.bincount((np.abs(turning) * (MEASURED.TURNS_BY / TURN * 2)).astype(int)) / len(turning)
    share = share[share > 0]
    return {
        "half_arcs": float(arc[np.abs(arc - TURN / 2) < MEASURED.HALF * TURN].sum()) / whole,
        "short_arcs": float(arc[arc < MEASURED.SHORT * TURN].sum()) / whole,
        "long_arcs": float(arc[arc > MEASURED.LONG * TURN].sum()) / whole,
        "sense_keeps": np.count_nonzero(keeps & together) / max(1, int(np.count_nonzero(together))),
        "surprise": float(-(share * np.log(share)).sum()),  # Shannon's entropy of the turns
        "spread": spread,
    }


def _of_rings(s: Section, extent: float) -> dict[str, float]:
    """Measure the share of the length in each kind of ring, and what the rings have in common."""
    r, p = s.rings, s.pieces
    length, number = float(r.length.sum()), max(len(r), 1)
    every = slice(None, None, len(r) // MEASURED.RINGS + 1)
    some = r.length[every]
    flags = np.array([*(getattr(r, name)[every] for name in FLAGS), s.hunting[every], s.aside[every]])
    shares = (flags * some).sum(axis=1) * (length / (float(some.sum()) or 1.0) / s.length)
    # How straight the rings move on: trochoids do, and come back nowhere.
    box = p.box[r.index[every]]
    centre = (box[:, :2] + box[:, 2:]) / 2
    moved = float(np.hypot(*(centre[1:] - centre[:-1]).T).sum())
    # The mean isoperimetric quotient by length: 1 for circles.
    round_ = 4 * np.pi * float((np.abs(p.enclosed[r.index]) / r.length).sum())
    return {
        **dict(zip((*FLAGS, "hunting", "aside"), shares.tolist())),
        "loops": float(p.length[p.kind == LOOP].sum()) / s.length,
        "windings": float(p.length[p.kind == WINDING].sum()) / s.length,
        "ring_step": float(np.log1p(100 * r.step / extent)) if np.isfinite(r.step) else -1.0,
        "roundness": round_ / length if length else 0.0,
        "rings": float(np.log1p(len(r))),
        "distinct": r.distinct / number,
        "ring_depths": float(np.log1p(r.depths)),
        "evenness": float(np.log1p(min(r.evenness, MEASURED.EVENNESS))),
        "drift": float(np.hypot(*(centre[-1] - centre[0]))) / moved if moved > ROUNDING.PLACE * number else 0.0,
        "ring_length": length / number / extent,
    }


def _of_rows(s: Section, extent: float) -> dict[str, float]:
    """Measure the families of rows; -1 where there are none."""
    rows = s.rows
    main = max(rows, key=lambda f: f.length) if rows else None
    return {
        "rows": sum(f.length for f in rows) / s.length,
        "rows_opposite": sum(f.opposite for f in rows) / s.length,
        "rows_same": sum(f.same for f in rows) / s.length,
        "zigzags": s.zigzag,
        "lines_of_rows": float(np.log1p(main.lines)) if main else 0.0,
        "row_count": float(np.log1p(sum(f.count for f in rows))),
        "row_slender": float(np.log1p(main.typical / max(main.step, ROUNDING.PLACE))) if main else -1.0,
        "row_even": main.even if main else -1.0,
        "row_length": main.typical / extent if main else -1.0,
    }


def _of_strokes(s: Section, extent: float) -> dict[str, float]:
    """Measure the open strokes."""
    k = s.strokes
    return {
        "strokes": float(k.length.sum()) / s.length,
        "bites": s.part(k.bite),
        "against": s.part(k.against),
        "stroke_slopes": s.part(k.sloped),
        "stroke_length": k.typical / extent,
        "stroke_count": float(np.log1p(len(k))),
    }
