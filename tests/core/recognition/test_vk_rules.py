# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies that the rules propose without the votes of the trees, for toolpaths drawn for one rule each.

The votes mostly agree with the rules, so the final strategies would not show a wrong rule.
"""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest
from drawings import arc, polygon, winding

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.entries import share_rising
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.rules import judge_section

TOOL = 6.0


def rows(count=10, length=50.0, step=3.0, x=0.0, y=0.0, z=0.0):
    """Return rows cut back and forth in one stroke."""
    ends = [((x, x + length) if row % 2 == 0 else (x + length, x)) for row in range(count)]
    return [(end, y + row * step, z) for row in range(count) for end in ends[row]]


def waves(count, step, *, grows=0.0, alternate=False):
    """Return open wavy strokes side by side. The distance to the next stroke grows by `grows` mm along the stroke."""
    x = np.linspace(0, 160, 41)
    strokes = []
    for i in range(count):
        y = 6 * np.sin(x / 12) + i * step + grows * i * x / 160
        points = list(zip(x, y, np.zeros(41)))
        strokes.append(points[::-1] if alternate and i % 2 else points)
    return strokes


def letters(count, z=0.0):
    """Return short open strokes, each with another shape."""
    return [
        [(12.0 * i + a, b, z) for a, b in ((0, 0), (3 + 0.3 * i, 6), (5, 1 + 0.4 * i), (1, 4))] for i in range(count)
    ]


def carved(y, rises=8.0):
    """Return a stroke of 160 mm for a V-bit: a level groove that rises at its end, in a corner."""
    return [(500, y, -4.0), (600, y + 3, -4.0), (660 - rises, y, -4.0), (660, y + rises, -4.0 + rises / 2)]


def rectangle(inside):
    """Return a rectangle of 80 x 40 mm, or its offset `inside` mm inside."""
    low, right, top = inside, 80 - inside, 40 - inside
    return [(low, low, 0.0), (right, low, 0.0), (right, top, 0.0), (low, top, 0.0), (low, low, 0.0)]


squares = [polygon(side) for side in (48, 44, 40, 36, 32)]
crooked = [(x, -40 + math.sin(1.3 * i), 0.0) for i, x in enumerate(np.linspace(44, 96, 14))]
there_and_back = crooked + [(x, y + 1, z) for x, y, z in crooked[::-1]]
CASES = {
    "bites that overlap": ([arc(8.0 * i) for i in range(12)], "adaptive", "bites-overlap", 12),
    "just enough bites": ([arc(8.0 * i) for i in range(10)], "adaptive", "bites-overlap", 10),
    "too few bites": ([arc(8.0 * i) for i in range(9)], "engraving", "short-strokes", 9),
    "bites one way and the other": ([arc(8.0 * i, clockwise=i % 3 == 0) for i in range(18)], "engraving", "short-strokes", 18),
    "arcs around one centre": ([arc(radius=10.0 + 2 * i) for i in range(8)], "contour-parallel", "nested", 8),
    "arcs around one centre, to and fro": (
        [arc(radius=10.0 + 2 * i)[:: -1 if i % 2 else 1] for i in range(8)], "zigzag", "half-turns-alternate", 8),
    "offsets": (squares, "contour-parallel", "nested", 5),
    "offsets to and fro": (
        [ring[:: -1 if i % 2 else 1] for i, ring in enumerate(squares)], "zigzag", "sense-alternates", 5),
    "offsets beside some rows": (
        [*(rectangle(2.0 * i) for i in range(5)), rows(length=32, y=-300)], "contour-parallel", "nested", 5),
    "two contours": ([polygon(60), polygon(20)], "profile", "not-nested", 2),
    "a contour at three depths": ([polygon(40, z=z) for z in (0.0, -2.0, -4.0)], "profile", "not-nested", 3),
    "a spiral": ([winding(2, 26, 8)], "spiral", "endless-winding", 9),
    "a helix": ([winding(10, 10, 8, drop=8)], "helix", "constant-radius", 8),
    "a helix, and circles beside it": (
        [winding(10, 10, 8, drop=8), *(polygon(20, x=60.0 * k, corners=36, z=-8) for k in (1, 2, 3))],
        "helix", "constant-radius", 11),
    "a helix that clears at its ground": (
        [winding(10, 10, 20, drop=12) + winding(10, 12, 1, z=-12)[1:] + winding(12, 15, 1, z=-12)[1:]
         + winding(15, 19, 1, z=-12)[1:]], "adaptive", "winding-with-entry", 3),
    "a helix that leads into a spiral": (
        [winding(10, 10, 20, drop=12) + winding(10, 19, 3, z=-12)[1:]], "spiral", "endless-winding", 3),
    "a helix, and a spiral at its ground after a lift": (
        [winding(10, 10, 20, drop=12), winding(10, 19, 3, z=-12)], "spiral", "endless-winding", 23),
    "a helix, and windings that step wider after a lift": (
        [winding(10, 10, 20, drop=12), winding(10, 12, 1, z=-12) + winding(12, 15, 1, z=-12)[1:]
         + winding(15, 19, 1, z=-12)[1:]], "adaptive", "winding-with-entry", 23),
    "a spiral entered by a helix": ([winding(2, 2, 2, drop=2) + winding(2, 26, 8, z=-2)[1:]], "spiral", "endless-winding", 9),
    "a spiral of three turns and a half with a circle around it": (
        [winding(2, 9, 3.5), polygon(18, x=70 - 9, y=-40 - 9, corners=36)], "spiral", "endless-winding", 5),
    "a square ramped as helices are": (
        [[(x, y, -2.0 * (k + i / 4)) for k in range(5) for i, (x, y, _) in enumerate(polygon(40)[:-1])]],
        "profile", "not-nested", 4),
    "walls that widen": ([polygon(20 + 2 * i, z=-1.0 * i) for i in range(8)], "waterline", "shape-changes", 8),
    "walls that widen at three depths": (
        [polygon(side, z=z) for side, z in ((20, 0.0), (24, -3.0), (34, -3.0), (40, -6.0))], "waterline", "shape-changes", 3),
    "an edge that is broken": ([polygon(20 + i, z=-0.25 * i) for i in range(8)], "profile", "not-nested", 8),
    "walls that widen at two depths": ([polygon(20 + 2 * i, z=-3.0 * i) for i in range(2)], "profile", "not-nested", 2),
    "circles on a dome": (
        [polygon(2 * r, z=math.sqrt(1600 - r * r) - 40, corners=48) for r in np.linspace(5, 36, 12)],
        "contour-parallel", "even-in-plane", 12),
    "circles that move along": ([polygon(16, x=1.0 * i, corners=24) for i in range(8)], "adaptive", "loops-move", 8),
    "four circles that overlap": ([polygon(16, x=2.0 * i, corners=24) for i in range(4)], "profile", "not-nested", 4),
    "five circles that move along": (
        [polygon(16, x=2.0 * i, corners=24) for i in range(5)], "adaptive", "loops-move", 5),
    "circles that move along among others": (
        [*(polygon(16, x=1.0 * i, corners=24) for i in range(8)), polygon(40, x=100), polygon(40, x=200),
         *letters(9)], "adaptive", "loops-move", 10),
    "a pass inside a narrow contour": (
        [polygon(60, ratio=0.2), there_and_back], "mixed", "pass-inside", 2),
    "rows": ([rows()], "zigzag", "half-turns-alternate", 10),
    "rows one way": ([[(0, y, 0), (50, y, 0)] for y in np.arange(0, 30, 3.0)], "one-way", "same-way", 10),
    "rows within a contour": ([rows(x=46, y=-54, length=48), polygon(54)], "zigzag", "half-turns-alternate", 10),
    "rows beside contours": (
        [rows(), *(polygon(side, x=200) for side in (80, 74, 68, 62))], "mixed", "rows-and-loops", 10),
    "open offsets": (waves(6, 3.0), "contour-parallel", "open-offsets", 6),
    "open offsets to and fro": (waves(6, 3.0, alternate=True), "zigzag", "open-offsets", 6),
    "open passes that part": (waves(8, 1.0, grows=4.0), "adaptive", "open-passes", 8),
    "open contours that change with the depth": (
        [[(x + i * i, y * (1 + i / 5), -2.0 * i) for x, y, _ in arc(radius=30)] for i in range(4)],
        "waterline", "open-contours-change", 4),
    "one open contour": ([arc(radius=30)], "profile", "one-open-contour", 1),
    "an open contour at three depths": ([arc(radius=30, z=-2.0 * i) for i in range(3)], "profile", "open-contour-again", 3),
    "two short open contours at three depths": (
        [arc(x, radius=5, z=-2.0 * i) for i in range(3) for x in (0, 100)], "profile", "open-contour-again", 6),
    "a few long strokes": (
        [[(500, 0, 0), (560, 10, 0), (590, 0, 0)], [(500, 40, 0), (550, 60, 0), (595, 45, 0)]], "profile", "long-strokes", 2),
    "long strokes that rise to their ends": ([carved(0), carved(40)], "engraving", "rising-strokes", 2),
    "one stroke that rises to its end": ([carved(0)], "engraving", "rising-strokes", 1),
    "a stroke that rises to its end, at three depths": (
        [[(x, y, z - 3.0 * i) for x, y, z in carved(0)] for i in range(3)], "profile", "open-contour-again", 3),
    "long strokes with a short way out": (
        [carved(0, rises=2.0), carved(40, rises=2.0)], "profile", "long-strokes", 2),
    "letters": (letters(12), "engraving", "short-strokes", 12),
    "letters at two depths": (letters(12) + letters(12, z=-1.0), "engraving", "short-strokes", 24),
    "closed letters": (
        [polygon(3 + 0.5 * i, x=12.0 * i, corners=3 + i % 5, ratio=1 + 0.1 * i) for i in range(12)],
        "engraving", "many-shapes", 12),
}  # fmt: skip


def proposed(strokes, tool=TOOL):
    return judge_section(Section(monotonous_areas(linearize(programs.program(strokes))), tool))


@pytest.mark.parametrize("strokes, strategy, seen, count", CASES.values(), ids=CASES)
def test_rule_proposes_the_intended_strategy_of_a_drawn_toolpath(strokes, strategy, seen, count):
    found = proposed(strokes)
    assert (found.strategy, found.seen.code, found.count) == (strategy, seen, count)


def test_only_a_rise_at_the_end_of_a_stroke_counts_as_rising():
    over_tags = [(500, 0, -4.0), (540, 0, -4.0), (546, 0, -2.0), (552, 0, -4.0), (560, 0, -4.0)]
    upward = [(500, 0, -4.0), (530, 40, 0.0), (560, 0, 4.0)]
    for strokes, share in (
        ([carved(0)], 11.3), ([over_tags], 0.0), ([carved(0)[::-1]], 0.0), ([arc(radius=30)], 0.0), ([upward], 100.0)
    ):  # fmt: skip
        moves = monotonous_areas(linearize(programs.program(strokes)))
        assert share_rising(moves) * moves.length.sum() == pytest.approx(share, abs=0.1)


def test_mixed_operation_has_shares_and_strategies_of_its_parts():
    found = proposed(CASES["rows beside contours"][0])
    assert found.seen.arguments["rows"] + found.seen.arguments["loops"] == pytest.approx(1.0)
    assert found.seen.arguments["loops"] == pytest.approx(4 * 284 / (4 * 284 + 527), rel=0.05)
    rings, of_rows = found.parts
    assert (rings.strategy, of_rows.strategy) == ("contour-parallel", "zigzag")


def test_rows_inside_a_contour_are_finished_by_the_contour():
    assert proposed(CASES["rows within a contour"][0]).finished and not proposed(CASES["rows"][0]).finished


@pytest.mark.parametrize("name, step", [("open offsets", 3.0), ("arcs around one centre", 2.0)])
def test_step_of_passes_that_are_not_rings_is_measured(name, step):
    assert proposed(CASES[name][0]).step == pytest.approx(step, rel=0.1)


def beside(strokes, others, share):
    """Return strokes, followed by other strokes with a share of the whole length.

    `others` is a function that draws the other strokes with a given total length.
    """
    length = sum(math.dist(a[:2], b[:2]) for stroke in strokes for a, b in zip(stroke, stroke[1:]))
    return [*strokes, *others(length * share / (1 - share))]


def contours(length, count=4):
    """Return separate squares."""
    return [polygon(length / count / 4, x=500.0 * k, y=-600) for k in range(count)]


def few_rows(length, count=6):
    return [rows(count, (length - 3.0 * (count - 1)) / count, y=-300)]


def scribbles(length, count=20):
    """Return open strokes of three sides, each with another shape."""
    side, strokes = length / count / 3, []
    for k in range(count):
        points = [(15.0 * k, 200.0, 0.0)]
        for angle in (0.3 + 0.1 * k, 2.0 + 0.05 * k, 4.0 + 0.13 * k):
            points.append((points[-1][0] + side * math.cos(angle), points[-1][1] + side * math.sin(angle), 0.0))
        strokes.append(points)
    return strokes


def bites(length, count=6):
    radius = length / count / (0.4 * 2 * math.pi)
    return [arc(0.8 * radius * k, y=300, radius=radius) for k in range(count)]


def entered(share):
    """Return a spiral of 1781 mm whose spacing grows, entered by a helix of two turns with a share of this length."""
    radii, way_in = [10 + 2 * k + k * k / 4 for k in range(11)], 1781 * share / (4 * math.pi)
    turns = [winding(*pair, 1) for pair in zip(radii, radii[1:])]
    return [
        [*winding(way_in, way_in, 2, z=2.0, drop=2), *turns[0], *(point for turn in turns[1:] for point in turn[1:])]
    ]


def divided(ratio):
    """Return squares at depth steps of 1 mm +- 50 %, whose offsets in the plane vary by ratio * 50 %."""
    at = np.linspace(-0.5, 0.5, 11)
    sides, heights = (np.append(0, np.cumsum(step)) for step in (4 * (1 + ratio * at), -(1 + at)))
    return [polygon(20 + side, z=z) for side, z in zip(sides, heights)]


# For each case: the value at which the strategy changes, the function that draws the toolpath for a value, and the
# strategies below and above the value. Values without a unit are shares of the whole length.
BORDERS = {
    "bites among contours": (0.1, lambda share: beside(bites(300, 12), contours, 1 - share), "profile", "adaptive"),
    "contours among scribbles": (0.35, lambda share: beside(contours(480), scribbles, 1 - share), "engraving", "profile"),
    "rows among scribbles": (0.35, lambda share: beside([rows()], scribbles, 1 - share), "engraving", "zigzag"),
    "rows beside contours": (0.15, lambda share: beside(contours(480), few_rows, share), "profile", "mixed"),
    "a contour beside rows": (
        0.1, lambda share: beside([rows()], lambda length: contours(length, 1), share), "zigzag", "mixed"),
    "bites beside a spiral": (0.03, lambda share: beside([winding(2, 26, 8)], bites, share), "spiral", "adaptive"),
    "scribbles beside a spiral": (0.3, lambda share: beside([winding(2, 26, 8)], scribbles, share), "spiral", "adaptive"),
    "a helix before windings": (0.005, entered, "spiral", "adaptive"),
    "a pass inside a contour, among others": (  # The pass has 0.42 of the total length of the pass and its contour.
        0.1, lambda share: beside([polygon(60, ratio=0.2), there_and_back], contours, 1 - share / 0.42), "profile", "mixed"),
    "walls that widen, among contours": (
        0.3, lambda share: beside([polygon(20 + 2 * i, z=-1.0 * i) for i in range(8)], contours, 1 - share),
        "profile", "waterline"),
    "walls that widen, by how deep they are, mm": (
        2.1, lambda depth: [polygon(20 + 2 * i, z=-depth / 7 * i) for i in range(8)], "profile", "waterline"),
    "steps in the plane, by how much they spread beside those in depth": (0.5, divided, "contour-parallel", "waterline"),
}  # fmt: skip


@pytest.mark.parametrize("at, draw, under, over", BORDERS.values(), ids=BORDERS)
def test_strategy_changes_at_the_threshold_of_its_rule(at, draw, under, over):
    assert [proposed(draw(value * at)).strategy for value in (0.94, 1.06)] == [under, over]


@pytest.mark.parametrize("sloped, strategy", [(3, "waterline"), (5, "engraving")])
def test_descending_open_contours_are_not_a_waterline(sloped, strategy):
    """Twenty contours are cut at five depths."""
    strokes = [
        [
            (x + k * k / 4 + 60 * (k % 2), y * (1 + k / 15), z - 2.0 * (k // 4))
            for x, y, z in arc(radius=30, drop=2.0 * (k < sloped))
        ]
        for k in range(20)
    ]
    assert proposed(strokes).strategy == strategy


@pytest.mark.parametrize("wider, strategy", [(0.25, "engraving"), (0.1, "profile")])
def test_contours_of_similar_size_have_one_shape(wider, strategy):
    """The contours are nine letters, or nine holes in a row."""
    assert proposed([polygon(6 + wider * k, x=12.0 * k) for k in range(9)]).strategy == strategy
