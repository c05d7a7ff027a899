# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which tool changes, titles, depths and links at feed are borders between two operations of a program."""

from __future__ import annotations

import itertools
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import programs
import pytest
from drawings import polygon
from hypothesis import given, settings
from hypothesis import strategies as st

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.programs.parts import (
    _agree,
    _differs,
    _joined,
    _odds_of_difference,
    _short,
    find_borders,
)
from vkworkbench.core.recognition.verdict.operation import _runs, cutting_length, unknown
from vkworkbench.core.recognition.verdict.recognition import Recognition, Span
from vkworkbench.language import Message

TOOL = 5.0
DEEPER = 0.7  # Height in mm that differs from all depth steps of the programs in this file.

MADE = {
    "zigzag": lambda size: programs.SOUND["zigzag"](int(6 * size), 60.0, 3.0, [-1.0]),
    "one-way": lambda size: programs.SOUND["one-way"](int(6 * size), 60.0, 3.0, [-1.0]),
    "contour-parallel": lambda size: programs.SOUND["contour-parallel"](int(4 * size), 36, 3.0, 10.0, [-1.0], 0.0),
    "profile": lambda size: programs.SOUND["profile"](24, 40.0, [-1.0 - k for k in range(int(2 * size))], 0.0),
    "waterline": lambda size: programs.SOUND["waterline"](int(8 * size), 36, 60.0, 1.0),
    "spiral": lambda size: programs.SOUND["spiral"](int(6 * size), 3.0, 48),
    "helix": lambda size: programs.SOUND["helix"](int(5 * size), 15.0, 1.0),
    "drilling": lambda size: programs.SOUND["drilling"](4, int(3 * size), 20.0, "G81"),
    "adaptive": lambda size: programs.SOUND["adaptive"](int(24 * size), 8.0, 1.0),
    "engraving": lambda size: programs.SOUND["engraving"](int(8 * size)),
}
every = pytest.mark.parametrize("name", MADE)


def lifted(path, height):
    """Return the toolpath, moved up by `height`."""
    return replace(path, points=path.points + (0, 0, height))


def after(first, second):
    """Return one toolpath of both toolpaths in sequence, linked by rapids up, across and down."""
    top = max(first.points[:, 2].max(), second.points[:, 2].max()) + 1.0
    a, b = first.points[-1], second.points[0]
    link = np.array([(*a[:2], top), (*b[:2], top), b])
    new = np.abs(np.diff(np.vstack([a, link]), axis=0)).max(axis=1) > 0
    moves = int(new.sum())

    def joined(name, fill, dtype):
        return np.concatenate([getattr(first, name), np.full(moves, fill, dtype), getattr(second, name)])

    return replace(
        first,
        points=np.concatenate([first.points, link[new], second.points[1:]]),
        rapid=joined("rapid", True, bool),
        command=joined("command", len(first) - 1, np.int64),
        feed=joined("feed", 0.0, float),
        sweep=joined("sweep", 0.0, float),
        plane=joined("plane", 17, np.uint8),
        cycle=joined("cycle", False, bool),
    )


@every
@settings(max_examples=5, deadline=None)
@given(times=st.integers(1, 3))
def test_operation_repeated_at_depths_is_one_operation(name, times):
    path = linearize(MADE[name](2))
    whole = path
    for k in range(1, times + 1):
        whole = after(whole, lifted(path, -DEEPER * k))
    once, again = recognize(path, tool_diameter=TOOL), recognize(whole, tool_diameter=TOOL)
    assert once.strategy == name
    assert again.strategy == name, again.reason
    assert again.depths in (0, (times + 1) * once.depths) or name == "waterline"


@every
def test_links_at_feed_do_not_change_the_strategy(name):
    path = linearize(MADE[name](2))
    path = after(path, replace(path, points=path.points + (150.0, 90.0, 0.0)))
    level = path.rapid & (np.diff(path.points[:, 2]) == 0)
    fed = replace(path, rapid=path.rapid & ~level, feed=np.where(level, 50.0, path.feed))
    assert level.any()
    assert recognize(path, tool_diameter=TOOL).strategy == name
    assert recognize(fed, tool_diameter=TOOL).strategy == name


SAME_FAMILY = [("zigzag", "one-way"), ("contour-parallel", "profile"), ("spiral", "profile"), ("waterline", "helix")]


@pytest.mark.parametrize("pair", SAME_FAMILY)
@pytest.mark.parametrize("sizes", [(3, 2), (2, 3)])
@pytest.mark.parametrize("turned", [False, True])
def test_tool_change_divides_operations_of_any_length(pair, sizes, turned):
    one, two = pair[::-1] if turned else pair
    found = recognize(linearize([*MADE[one](sizes[0]), ("M6", {"T": 2.0}), *MADE[two](sizes[1])]), tool_diameter=TOOL)
    assert [str(s.strategy) for s in found.spans] == [one, two], found.reason
    assert found.strategy is Strategy.MIXED


@pytest.mark.long
@every
def test_two_sections_of_one_strategy_are_not_mixed(name):
    # The second section is in another place, at another depth, or cut with another tool.
    sections = [linearize(MADE[name](size)) for size in (1, 2)]
    assert all(recognize(s, tool_diameter=TOOL).strategy == name for s in sections)
    one, two = sections
    for depth in (0.0, -0.3, -2.0):
        path = after(one, replace(two, points=two.points + (31.0, 17.0, depth)))
        at = len(path) - len(two)
        for border in ({"tool_changes": np.array([at])}, {"comments": ((at, "the second"),)}):
            found = recognize(replace(path, **border), tool_diameter=TOOL)
            assert found.strategy == name, (depth, border, found.reason)


def test_several_holes_in_sequence_are_one_operation():
    rest = [("G0", {"Z": 5.0})]
    rectangle = [
        ("G1", {"Z": -1.0}),
        *[("G1", {"X": x, "Y": y}) for x, y in ((30.0, 0.0), (30.0, 9.0), (0.0, 0.0))],
        *rest,
    ]
    hole = [("G1", {"Z": -9.0}), *rest]
    start = ("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})
    away = ("G0", {"X": 50.0})
    milled_first = linearize([start, *rectangle, away, *hole, away, ("G0", {"X": 70.0}), *hole])
    # Trajectories: plunge 0, rectangle 1 to 3, up 4, across 5, hole 6, up 7, across 8, hole 9, up 10.
    assert find_borders(milled_first, monotonous_areas(milled_first)) == {4: True, 10: True}
    drilled_first = linearize([start, *hole, away, *hole, start, *rectangle])
    # Trajectories: hole 0, up 1, across 2, hole 3, up 4.
    assert find_borders(drilled_first, monotonous_areas(drilled_first)) == {4: True}
    to = [("G0", {"X": x}) for x in (70.0, 90.0, 110.0)]
    around = linearize([start, *hole, away, *hole, to[0], *rectangle, to[1], *hole, to[2], *hole])
    # Trajectories: hole 0, up 1, across 2, hole 3, up 4, across 5, down 6, rectangle 7 to 9, up 10, across 11, hole 12,
    # up 13, across 14, hole 15.
    assert find_borders(around, monotonous_areas(around)) == {4: True, 10: True, 16: True}


def test_retract_at_feed_belongs_to_the_operation_before():
    """A steep lift after milling, and the retract from a tapped hole, are not separate operations."""
    milled = [
        ("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}),
        ("G1", {"Z": -1.0, "F": 5.0}),
        ("G1", {"X": 60.0}),
        ("G1", {"Y": 40.0}),
    ]
    lifted = [("G1", {"Y": 40.1, "Z": 1.0}), ("G0", {"Z": 5.0})]
    tapped = [
        command
        for x in (10.0, 30.0, 50.0)
        for command in (("G0", {"X": x, "Y": 20.0}), ("G1", {"Z": -9.0}), ("G1", {"Z": 2.0}), ("G0", {"Z": 5.0}))
    ]
    path = linearize([*milled, *lifted, *tapped, *milled, ("G0", {"Z": 5.0})])
    borders = find_borders(path, monotonous_areas(path))
    assert len(borders) == 2
    assert path.rapid[list(borders)].all()
    found = recognize(path, program=True)
    assert [str(span.strategy) for span in found.spans] == ["profile", "drilling", "profile"]


def test_single_canned_cycle_between_cuts_is_its_own_operation():
    milling = programs.one_way(40)
    drilled = [("G0", {"X": 300.0, "Y": 0.0, "Z": 5.0}), ("G81", {"X": 300.0, "Y": 0.0, "Z": -9.0, "R": 2.0, "F": 5.0})]
    plunged = [("G0", {"X": 300.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 300.0, "Y": 0.0, "Z": -9.0})]
    for hole, certain in ((drilled, True), (plunged, False)):
        path = linearize([*milling, *hole, ("G0", {"Z": 5.0}), *milling])
        found = find_borders(replace(path, comments=()), monotonous_areas(path))
        down = int(np.argmin(path.points[:, 2])) - 1  # The trajectory that ends at the bottom of the hole.
        last = np.flatnonzero(~path.rapid[:down])[-1]
        assert found == ({int(last) + 1: True, down + 1: True} if certain else {})


def test_plunge_beside_at_most_four_passes_is_a_hole():
    """A plunge beside five passes is not a hole: it is a pass that the boundary clips to a point."""
    plunge = [("G0", {"X": 300.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 300.0, "Y": 0.0, "Z": -9.0}), ("G0", {"Z": 5.0})]
    for rows, borders in ((4, True), (5, False)):
        path = replace(linearize([*programs.one_way(rows), *plunge]), comments=())
        moves = monotonous_areas(path)
        assert (len(moves.start), len(moves.holes)) == (rows, 1)
        last = int(np.flatnonzero(~path.rapid)[-2])
        assert sorted(find_borders(path, moves)) == ([last + 1, len(path) - 1] if borders else [])


@pytest.mark.parametrize("heights, borders", [(10, True), (11, False)])
def test_plunges_of_a_surface_are_clipped_passes(heights, borders):
    strokes = [[(0.0, 3.0 * k, -0.7 * k), (40.0, 3.0 * k, -0.7 * k)] for k in range(heights)]
    plunges = [[(100.0 + 9 * k, 0.0, -20.3 - k)] for k in range(4)]
    path = linearize(programs.program([*strokes, *plunges]))
    moves = monotonous_areas(path)
    assert (len(moves.start), len(moves.holes)) == (heights, 4)
    assert bool(find_borders(path, moves)) is borders


def test_span_of_unknown_rapids_covers_all_moves():
    path = linearize(
        [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"X": 5.0}), ("(turn)", {}), ("G0", {"Y": 5.0, "Z": 9.0})]
    )
    found = unknown(path, Message("moves-nothing"))
    assert (found.strategy, found.confidence) == (Strategy.UNKNOWN, 0.0)
    assert found.spans == (Span(0, 1, 1, 3, Strategy.UNKNOWN, 1.0),)


def contour(depths, closed=True):
    """Return the commands of one contour at some depths."""
    program = []
    for z in depths:
        program += [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": z})]
        corners = [(60, 0), (60, 40), (0, 40), (0, 0)][: 4 if closed else 2]
        program += [("G1", {"X": float(x), "Y": float(y)}) for x, y in corners]
    return program


@pytest.mark.parametrize("closed", [True, False])
def test_contour_cut_once_is_not_called_repeated(closed):
    once = recognize(linearize(contour([-1.0], closed)))
    assert once.strategy is Strategy.PROFILE
    assert "again" not in once.reason and "depths" not in once.reason and "repeated" not in once.reason
    thrice = recognize(linearize(contour([-1.0, -2.0, -3.0], closed)))
    assert thrice.strategy is Strategy.PROFILE and "at 3 depths" in thrice.reason


@pytest.mark.parametrize(
    ("loops", "passes", "short"),
    [(0, None, True), (1, 2, True), (2, 2, False), (1, 3, False), (0, 3, False), (2, None, False)],
)
def test_two_loops_or_three_passes_show_a_strategy(loops, passes, short):
    one = Recognition(Strategy.PROFILE, 0.9, Message("moves-nothing"), closed_loops=loops, passes=passes)
    assert _short(one, 2) is short


def beside(drilled, change=()):
    """Return a pocket of twelve loops, 2.5 m long, and `drilled` times 2 holes, 15 mm deep, beside the pocket."""
    pocket = programs.SOUND["contour-parallel"](12, 36, 3.0, 10.0, [-1.0], 0.0)
    return [*pocket, *change, ("G0", {"X": 300.0}), *programs.SOUND["drilling"](drilled, 2, 20.0, "G81")]


@pytest.mark.parametrize("program", [False, True])
def test_pattern_with_few_holes_keeps_its_strategy(program):
    found = recognize(linearize(beside(3)), tool_diameter=TOOL, program=program)
    assert found.strategy is Strategy.CONTOUR_PARALLEL
    assert [s.strategy for s in found.spans] == [Strategy.CONTOUR_PARALLEL, Strategy.DRILLING]
    assert found.spans[1].share < 0.05
    assert found.reason.endswith(" A small part is drilling."), found.reason
    assert found.passes == 12  # Only the loops of the pocket are counted.


@pytest.mark.parametrize("program", [False, True])
@pytest.mark.parametrize(("drilled", "change"), [(3, [("M6", {"T": 2.0})]), (9, [])])
def test_many_holes_or_another_tool_make_an_operation(drilled, change, program):
    found = recognize(linearize(beside(drilled, change)), tool_diameter=TOOL, program=program)
    assert found.strategy is Strategy.MIXED
    assert [s.strategy for s in found.spans] == [Strategy.CONTOUR_PARALLEL, Strategy.DRILLING]
    assert found.reason.endswith("retracts or drilling, show contour-parallel, drilling: mixed.")


def with_a_contour(pattern, share, *before):
    """Return a pattern and a square contour with a share of the total length; 10 mm of the contour are its plunge."""
    path = linearize(pattern)
    length = cutting_length(path, 0, len(path) - 1) * share / (1 - share)
    square = programs.program([polygon((length - 10) / 4, x=500)])
    return linearize([*pattern, *before, *square])


@pytest.mark.parametrize("program", [False, True])
@pytest.mark.parametrize(("share", "strategy"), [(0.047, Strategy.ZIGZAG), (0.053, Strategy.MIXED)])
def test_titled_section_of_five_percent_makes_a_program_mixed(share, strategy, program):
    path = with_a_contour(programs.zigzag(20, 60.0, 3.0), share, ("(Contour)", {}))
    assert recognize(path, tool_diameter=TOOL, program=program).strategy is strategy


@pytest.mark.parametrize(("share", "others"), [(0.0009, 0), (0.0011, 1)])
def test_short_section_of_another_tool_is_an_operation(share, others):
    pocket = programs.SOUND["contour-parallel"](70, 36, 3.0, 10.0, [-1.0], 0.0)
    found = recognize(with_a_contour(pocket, share, ("M6", {"T": 2.0})), tool_diameter=TOOL, program=True)
    assert len(found.spans) == 1 + others


def in_holes(depths, remark=True):
    """Return three holes of FreeCAD's adaptive clearing with its remarks.

    Each hole is entered on a helix and widened.
    """
    commands = []
    for depth, hole in itertools.product(depths, range(3)):
        down, out = np.arange(0, 6 * 2 * np.pi, 0.3), np.arange(0, 3 * 2 * np.pi, 0.3)
        radius = np.concatenate([np.full(len(down), 1.2), 1.2 + 0.5 * out / (2 * np.pi)])
        turn = np.concatenate([down, out])
        x, y = 40 * hole + radius * np.cos(turn), radius * np.sin(turn)
        z = depth + np.concatenate([6 - down / (2 * np.pi), np.zeros(len(out))])
        points = [("G1", {"X": a, "Y": b, "Z": c, "F": 10.0}) for a, b, c in zip(x, y, z)]
        commands += [(f"(Helix to depth: {depth:.6f})", {}), ("G0", {"Z": 9.0}), ("G0", {"X": x[0], "Y": y[0]})]
        commands += [*points[: len(down)], (f"(Adaptive - depth: {depth:.6f})", {}), *points[len(down) :]]
        commands.append(("G0", {"Z": 9.0}))
    return [command for command in commands if remark or not command[0].startswith("(")]


@pytest.mark.parametrize("depths", [(-6.0,), (-6.0, -12.0, -18.0)])
def test_freecad_remark_within_operation_does_not_divide(depths):
    path = linearize(in_holes(depths))
    assert len(path.comments) == 6 * len(depths) and not find_borders(path, monotonous_areas(path))
    found, plain = (recognize(one, tool_diameter=3.0) for one in (path, linearize(in_holes(depths, remark=False))))
    assert (found.strategy, found.confidence, len(found.spans)) == (plain.strategy, plain.confidence, len(plain.spans))
    assert find_borders(replace(path, comments=((30, "Pocket"),)), monotonous_areas(path)) == {30: False}


@pytest.mark.parametrize(("loops", "other"), [(12, "zigzag"), (70, "drilling")])
def test_another_tool_is_another_operation_in_a_program(loops, other):
    """The second tool cuts four short rows, or drills holes with less than a thousandth of the length."""
    pocket = programs.SOUND["contour-parallel"](loops, 36, 3.0, 10.0, [-1.0], 0.0)
    little = {
        "zigzag": programs.SOUND["zigzag"](4, 15.0, 3.0, [-1.0]),
        "drilling": programs.SOUND["drilling"](2, 1, 20.0, "G81"),
    }[other]
    path = linearize([*pocket, ("M6", {"T": 2.0}), ("G0", {"X": 500.0}), *little])
    found = recognize(path, tool_diameter=TOOL, program=True)
    assert found.strategy is Strategy.MIXED
    assert [str(span.strategy) for span in found.spans] == ["contour-parallel", other]
    assert found.spans[1].share < (0.05 if other == "zigzag" else 0.001)


@pytest.mark.parametrize("titles, borders", [(200, 200), (201, 0)])
def test_more_than_two_hundred_titles_do_not_divide_a_program(titles, borders):
    path = linearize(programs.one_way(210))
    path = replace(path, comments=tuple((at, "title") for at in range(1, titles + 1)), tool_changes=np.array([5]))
    # The tool change at trajectory 5 is one of the borders between operations, or the only border.
    found = find_borders(path, monotonous_areas(path))
    assert len(found) == max(borders, 1) and found[5] is True and sum(found.values()) == 1


def told(strategy, *spans, **numbers):
    """Return a recognition result with the given spans, each (first trajectory, last trajectory, strategy, share)."""
    spans = tuple(Span(first, last, first, last, one, share) for first, last, one, share in spans)
    return Recognition(strategy, numbers.pop("confidence", 0.9), Message("moves-nothing"), spans, **numbers)


def test_loops_and_rows_in_one_section_are_separate_spans():
    """The six pieces of the toolpath are a ring, a link, two rows, a link and a ring, with one to three moves each."""
    rings, rows = Strategy.PROFILE, Strategy.ZIGZAG
    section = SimpleNamespace(
        ring_pieces=np.array([1, 0, 0, 0, 0, 1], bool), row_pieces=np.array([0, 0, 1, 1, 0, 0], bool),
        moves=SimpleNamespace(index=np.array([4, 5, 7, 10, 11, 12, 14, 15, 20, 22])),
        pieces=SimpleNamespace(start=np.array([0, 2, 3, 5, 6, 8])),
    )  # fmt: skip
    verdict = SimpleNamespace(parts=(told(rings), told(rows)))
    assert _runs(section, verdict, 2, 25) == [(2, 7, rings), (10, 15, rows), (20, 25, rings)]
    section.ring_pieces[0] = False  # The first piece is a lead-in, which belongs to the rows after the lead-in.
    assert _runs(section, verdict, 2, 25) == [(2, 15, rows), (20, 25, rings)]
    section.ring_pieces[1] = True  # The link belongs to the ring after the link.
    assert _runs(section, verdict, 2, 25) == [(2, 7, rings), (10, 15, rows), (20, 25, rings)]


def test_odds_of_a_difference_are_computed_from_confidences():
    zigzag, helix = told(Strategy.ZIGZAG, confidence=0.8), told(Strategy.HELIX, confidence=0.5)
    assert _odds_of_difference(zigzag, helix) == pytest.approx(0.4 / 0.6) == _odds_of_difference(helix, zigzag)
    assert _odds_of_difference(zigzag, told(Strategy.ZIGZAG)) == 0
    for other in (told(Strategy.UNKNOWN), told(Strategy.EMPTY)):
        assert _odds_of_difference(zigzag, other) == 0 == _odds_of_difference(other, zigzag)
    # Adaptive clearing cuts a round area as a spiral, so spiral and adaptive do not count as different strategies.
    spiral, adaptive = told(Strategy.SPIRAL), told(Strategy.ADAPTIVE)
    assert (
        _odds_of_difference(spiral, adaptive) == 0 == _odds_of_difference(adaptive, spiral)
        and _odds_of_difference(spiral, zigzag) > 0
    )


def test_equal_neighbouring_spans_of_one_operation_are_joined():
    rows, contour = Strategy.ZIGZAG, Strategy.PROFILE
    found = [
        told(rows, (0, 4, rows, 1.0)),
        told(Strategy.MIXED, (6, 8, rows, 0.5), (9, 12, contour, 0.5)),
        told(contour, (14, 20, contour, 1.0)),
    ]
    assert _joined(found, np.array([0, 0, 0])) == [(0, 8, rows), (9, 20, contour)]
    assert _joined(found, np.array([0, 1, 1])) == [(0, 4, rows), (6, 8, rows), (9, 20, contour)]
    assert _joined(found, np.array([0, 0, 1])) == [(0, 8, rows), (9, 12, contour), (14, 20, contour)]
    assert _joined(found[::2], np.array([2, 2])) == [(0, 4, rows), (14, 20, contour)]


ROWS, AROUND, STROKES = Strategy.ZIGZAG, Strategy.PROFILE, Strategy.ENGRAVING


@pytest.mark.parametrize(
    "one, loops, passes, main, sure, program, differs",
    [
        (ROWS, 0, 3, AROUND, False, False, True),
        (ROWS, 0, 2, AROUND, False, False, False),  # Two passes do not show a strategy.
        (ROWS, 0, None, AROUND, True, False, False),
        (AROUND, 1, None, ROWS, False, False, True),
        (AROUND, 1, 1, ROWS, True, False, True),
        (ROWS, 0, 3, Strategy.ONE_WAY, False, False, False),  # Zigzag and one-way both consist of rows.
        (ROWS, 0, 3, Strategy.ONE_WAY, True, False, True),
        (ROWS, 0, 3, ROWS, True, False, False),
        (ROWS, 0, 0, Strategy.ONE_WAY, True, True, True),
        (ROWS, 0, 0, ROWS, True, True, False),
        (ROWS, 0, 0, AROUND, False, True, False),
        (STROKES, 0, 9, ROWS, False, False, False),  # A title does not separate strokes.
        (STROKES, 0, 9, ROWS, True, False, True),
        (ROWS, 0, 9, STROKES, False, False, False),
        (Strategy.UNKNOWN, 0, 9, ROWS, True, True, False),
        (ROWS, 0, 9, Strategy.UNKNOWN, True, True, False),
    ],
)
def test_border_divides_sections_whose_strategies_clearly_differ(one, loops, passes, main, sure, program, differs):
    assert _differs(told(one, closed_loops=loops, passes=passes), told(main), sure, program) is differs


def test_longest_section_wins_if_none_has_the_whole_strategy():
    path = linearize(programs.one_way(10))
    whole, one = told(AROUND, (0, 39, AROUND, 1.0)), np.zeros(2, int)

    def agreed(*found, share=(0.4, 0.6), whole=whole):
        return _agree(path, whole, list(found), np.array(share), one)

    rows = told(ROWS, (2, 9, ROWS, 1.0), passes=5)
    arcs = told(STROKES, (12, 30, STROKES, 1.0), passes=5)
    (span,) = agreed(rows, arcs).spans
    assert (span.first, span.last, span.strategy) == (2, 30, STROKES)
    assert agreed(rows, arcs, share=(0.6, 0.4)).spans[0].strategy is ROWS
    assert agreed(rows, told(AROUND, (12, 30, AROUND, 1.0), passes=5)) is whole
    short, unknown_one = (told(s, (12, 30, s, 1.0), passes=1) for s in (STROKES, Strategy.UNKNOWN))
    for little in (short, unknown_one):
        assert agreed(rows, little) is whole  # The longest section has 0.6 of the length, but no strategy.
        assert agreed(rows, little, share=(0.6, 0.4)).spans[0].strategy is ROWS
    mixed = told(Strategy.MIXED, (12, 20, AROUND, 0.5), (21, 30, ROWS, 0.5), closed_loops=2)
    spans = [(s.first, s.last, s.strategy) for s in agreed(rows, mixed).spans]
    assert spans == [(2, 9, ROWS), (12, 20, AROUND), (21, 30, ROWS)]
