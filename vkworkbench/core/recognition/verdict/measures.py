# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the dimensionless measures of a section, which the decision trees read."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.pieces import LOOP, WINDING
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import MEASURED, ROUNDING, WINDINGS
from vkworkbench.core.recognition.verdict.crossings import Sample, measure_crossings

#: Attributes of `Rings` whose shares of the section's length are measures.
FLAGS = ("nested", "sloped", "round", "stacked", "deeper", "alone", "moved", "opposite", "crossing")


def measure_section(section: Section) -> dict[str, float]:
    """Return the measures of a section by name: shares, ratios, and logarithms of numbers.

    No measure changes if the section is moved, mirrored, scaled with its tool, or cut in reverse. Rotating the section
    changes only the measures that are relative to its extent.
    """
    moves = section.moves
    # Diagonal of the box around the starts of the moves, mm.
    extent = float(np.hypot(np.ptp(moves.x), np.ptp(moves.y))) or 1.0
    # A sample of the moves is enough to measure shares of the length.
    number = min(len(moves), MEASURED.MOVES)
    sample = Sample.of(moves, ((np.arange(number) + 0.5) * (len(moves) / number)).astype(np.int64))
    return {
        **_measure_areas(section, extent),
        **_measure_moves(moves, sample),
        **_measure_turns(moves),
        **_measure_rings(section, extent),
        **_measure_rows(section, extent),
        **_measure_strokes(section, extent),
        **measure_crossings(moves, sample, extent),
    }


def _measure_areas(section: Section, extent: float) -> dict[str, float]:
    """Measure how much the monotonous areas turn."""
    moves = section.moves
    last = moves.end - 1
    net = moves.phi[last] - moves.phi[moves.start]
    turned = max(float(np.abs(moves.turning).sum()), ROUNDING.HEIGHT)
    # Compute for each area the range of phi, the net turn, and the distance between the area's ends (|V_k| of its last
    # trajectory) divided by the area's length.
    share, number = moves.area_length / moves.area_length.sum(), len(moves.start)
    ranges = moves.phi_extent / TURN
    turns = np.abs(net) / TURN
    v = (
        np.hypot(
            moves.x[last] + moves.dx[last] - moves.x[moves.start], moves.y[last] + moves.dy[last] - moves.y[moves.start]
        )
        / moves.area_length
    )
    closed = v < MEASURED.CLOSED
    low, high = MEASURED.ONE_TURN
    return {
        "wound": section.wound,
        "longest_area": float(share.max()),
        "around_areas": float(share[ranges > 1].sum()),
        "rows_areas": float(share[ranges < MEASURED.HALF_TURN].sum()),
        "area_turns": float((share * np.log1p(turns)).sum()),
        "one_turn": float(share[closed & (turns > low) & (turns < high)].sum()),
        "closed_areas": float(share[closed].sum()),
        "area_v": float((share * v).sum()),
        "areas": float(np.log1p(number)),
        "area_length": float(np.log(section.length / number / extent)),
        "alike_areas": float(-np.log((share * share).sum() * number)),
        "turned": float(np.log1p(turned / TURN)),
        "turned_for_length": float(np.log1p(turned / TURN * extent / section.length)),
        "net_turn": float(np.abs(net).sum()) / turned,
        "one_sense": abs(float(net.sum())) / turned,
    }


def _measure_moves(moves: Areas, sample: Sample) -> dict[str, float]:
    """Measure directions, turns and heights of the sampled moves, weighted by their length."""
    length, turned, climbs = sample.length, np.abs(moves.turning[sample.chosen]), np.abs(moves.dz[sample.chosen])
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


def _measure_turns(moves: Areas) -> dict[str, float]:
    """Measure the arcs of the Gauss map, for moves from the middle of the cutting order.

    The Gauss map shows the directions of the moves as points on the unit circle. Consecutive turns in one
    sense form an arc of the Gauss map. The arc between alternating rows is a half turn, and the arc of a contour is a
    whole turn. In random walks and noise, all turns and both senses are equally likely.
    """
    spare = max(0, len(moves) - MEASURED.TURNS)
    middle = slice(spare // 2, len(moves) - (spare + 1) // 2)
    turning = moves.signed[0][middle]
    at = np.flatnonzero(np.abs(turning) > MEASURED.TURN)
    spread = float(np.log(moves.length[middle]).std())
    if not len(at):
        return {
            "half_arcs": 0.0,
            "short_arcs": 0.0,
            "long_arcs": 0.0,
            "sense_keeps": 0.0,
            "surprise": 0.0,
            "spread": spread,
        }
    turning, area = turning[at], np.searchsorted(moves.start, at + middle.start, side="right")
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


def _measure_rings(section: Section, extent: float) -> dict[str, float]:
    """Measure the share of the length in each kind of ring, and the number, distance and shape of the rings."""
    rings, pieces = section.rings, section.pieces
    length, number = float(rings.length.sum()), max(len(rings), 1)
    every = slice(None, None, len(rings) // MEASURED.RINGS + 1)
    some = rings.length[every]
    flags = np.array([*(getattr(rings, name)[every] for name in FLAGS), section.hunting[every], section.aside[every]])
    shares = (flags * some).sum(axis=1) * (length / (float(some.sum()) or 1.0) / section.length)
    # Measure how straight the path of the ring centres is, because the rings of a trochoid advance and never return.
    box = pieces.box[rings.index[every]]
    centre = (box[:, :2] + box[:, 2:]) / 2
    moved = float(np.hypot(*(centre[1:] - centre[:-1]).T).sum())
    # Mean isoperimetric quotient, 4 pi area / length^2, weighted by length: 1 for circles.
    round_ = 4 * np.pi * float((np.abs(pieces.enclosed[rings.index]) / rings.length).sum())
    return {
        **dict(zip((*FLAGS, "hunting", "aside"), shares.tolist())),
        "loops": float((pieces.length * (pieces.kind == LOOP)).sum()) / section.length,
        "windings": float((pieces.length * (pieces.kind == WINDING)).sum()) / section.length,
        "ring_step": float(np.log1p(100 * rings.step / extent)) if np.isfinite(rings.step) else -1.0,
        "roundness": round_ / length if length else 0.0,
        "rings": float(np.log1p(len(rings))),
        "distinct": rings.distinct / number,
        "ring_depths": float(np.log1p(rings.depths)),
        "evenness": float(np.log1p(min(rings.evenness, MEASURED.EVENNESS))),
        "drift": float(np.hypot(*(centre[-1] - centre[0]))) / moved if moved > ROUNDING.PLACE * number else 0.0,
        "ring_length": length / number / extent,
    }


def _measure_rows(section: Section, extent: float) -> dict[str, float]:
    """Measure the families of rows. The measures of the rows' shape are -1 if there are no rows."""
    rows = section.rows
    main = max(rows, key=lambda family: family.length) if rows else None
    return {
        "rows": sum(family.length for family in rows) / section.length,
        "rows_opposite": sum(family.opposite for family in rows) / section.length,
        "rows_same": sum(family.same for family in rows) / section.length,
        "zigzags": section.zigzag,
        "lines_of_rows": float(np.log1p(main.lines)) if main else 0.0,
        "row_count": float(np.log1p(sum(family.count for family in rows))),
        "row_slender": float(np.log1p(main.typical / max(main.step, ROUNDING.PLACE))) if main else -1.0,
        "row_even": main.even if main else -1.0,
        "row_length": main.typical / extent if main else -1.0,
    }


def _measure_strokes(section: Section, extent: float) -> dict[str, float]:
    """Measure the open strokes."""
    strokes = section.strokes
    return {
        "strokes": float(strokes.length.sum()) / section.length,
        "bites": section.part(strokes.bite),
        "against": section.part(strokes.against),
        "stroke_slopes": section.part(strokes.sloped),
        "stroke_length": strokes.typical / extent,
        "stroke_count": float(np.log1p(len(strokes))),
    }
