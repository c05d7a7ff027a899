# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every strategy is recognised, with its evidence, in toolpaths like the toolpaths of several CAM programs."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import programs
import pytest
from drawings import polygon
from hypothesis import given, settings
from hypothesis import strategies as st

from toolpaths import synthetic
from vkworkbench.core import Strategy, Toolpath
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import Span, unknown
from vkworkbench.core.recognition.programs.recognize import recognize
from vkworkbench.language import Message


def cut(points, rapid=()):
    """Return a toolpath through points (n+1, 2) or (n+1, 3). `rapid` lists the trajectories that are rapids."""
    points = np.asarray(points, float)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    path = Toolpath.through(points)
    path.rapid[list(rapid)] = True
    return path


def raster(rows=20, length=50.0, step=2.0):
    k = np.arange(2 * rows)
    return np.column_stack([np.array([0.0, length, length, 0.0])[k % 4], k // 2 * step])


def rings(count=6, step=3.0, linked=True):
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)], float)
    return np.vstack([corners * (5 + k * step) for k in range(count)])


# The arcs on one side of a clipped spiral also fit circles around a shifted centre (docs/recognition.md, "Strategies
# that the toolpath alone does not determine"). So clipped spirals and clipped circles get the strategy that is more
# frequent in the training toolpaths.
OPEN = {"spiral clipped", "circles clipped"}
SEEDS = 6


@pytest.mark.long
def test_synthetic_samples_have_their_intended_strategies():
    """At most one toolpath per sample may be wrong, and 5 % of all may be unknown. Each reason names its strategy."""
    wrong, unknown = {}, []
    for label, accepted, make in synthetic.SAMPLES:
        wrong[label] = []
        for seed in range(SEEDS):
            found = recognize(linearize(make(np.random.default_rng([seed, sum(map(ord, label))]))))
            assert str(found.strategy) in found.reason, (label, seed, found.reason)
            if str(found.strategy) not in accepted:
                wrong[label].append((seed, found.strategy, found.reason))
            if found.strategy is Strategy.UNKNOWN:
                assert "of the votes" in found.reason, (label, seed, found.reason)
            unknown.append(found.strategy is Strategy.UNKNOWN)
    wrong = {label: seeds for label, seeds in wrong.items() if len(seeds) > 1}
    assert set(wrong) <= OPEN, wrong
    assert np.mean(unknown) < 0.05


def test_every_strategy_has_a_synthetic_sample():
    sampled = {strategy for _, accepted, _ in synthetic.SAMPLES for strategy in accepted}
    assert sampled == {strategy.value for strategy in Strategy if strategy.is_answer}


def test_numbers_reported_for_a_zigzag_are_exact():
    found = recognize(cut(raster(rows=20, step=2.0)))
    assert found.strategy is Strategy.ZIGZAG
    assert (found.level, found.passes, found.depths, found.reversals) == (0, 20, 1, 0)
    assert found.stepover == pytest.approx(2.0)
    assert found.direction == pytest.approx(0.0, abs=0.01)
    assert found.phi_range == pytest.approx((0.0, np.pi))
    assert found.sense is None and found.milling is None
    assert "20 rows" in found.reason and "2 mm apart" in found.reason


def test_numbers_reported_for_nested_offsets_are_exact():
    found = recognize(cut(rings(6, step=3.0)), tool_diameter=6.0)
    assert found.strategy is Strategy.CONTOUR_PARALLEL
    assert found.level >= 5 and found.closed_loops == 6 and found.passes == 6
    assert found.stepover == pytest.approx(3.0)
    assert found.sense == "ccw" and found.milling == "climb"
    assert found.direction is None
    back = recognize(cut(rings(6, step=3.0)[::-1]), tool_diameter=6.0)
    assert back.strategy is Strategy.CONTOUR_PARALLEL
    # In reverse, the loops run clockwise and shrink, so the uncut material lies on the right again.
    assert back.level <= -5 and back.sense == "cw" and back.milling == "climb"


def test_single_closed_loop_is_a_profile_with_one_full_turn():
    square = np.array([(0, 0), (30, 0), (30, 20), (0, 20), (0, 0)])
    found = recognize(cut(square))
    assert found.strategy is Strategy.PROFILE
    assert (found.level, found.closed_loops, found.sense) == (1, 1, "ccw")
    assert found.phi_range == pytest.approx((0.0, 2 * np.pi))


def test_same_rows_at_several_depths_are_one_zigzag():
    program = []
    for z in (-2.0, -4.0, -6.0):
        program += [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": z})]
        program += [("G1", {"X": float(x), "Y": float(y)}) for x, y in raster(rows=8)]
    found = recognize(linearize(program))
    assert found.strategy is Strategy.ZIGZAG and found.depths == 3 and len(found.spans) == 1
    assert found.spans[0].share == 1.0


@pytest.mark.parametrize("tool", [None, 0, -3, float("nan"), float("inf"), 4.0])
def test_strategy_is_found_without_a_tool(tool):
    assert recognize(cut(raster()), tool_diameter=tool).strategy is Strategy.ZIGZAG
    assert recognize(cut(rings()), tool_diameter=tool).strategy is Strategy.CONTOUR_PARALLEL


def test_contours_farther_apart_than_the_tool_are_profiles():
    washer = np.vstack([rings(1) * 4, rings(1) * 2])
    path = cut(washer, rapid=[4])
    assert recognize(path, tool_diameter=3.0).strategy is Strategy.PROFILE


def test_spans_of_a_mixed_toolpath_cover_all_cuts():
    raster_beside = [("G1", {"X": (0.0, 40.0)[(k + 1) // 2 % 2], "Y": 2.0 * (k // 2)}) for k in range(24)]
    aside = [(100.0, 0.0), (160.0, 0.0), (160.0, 60.0), (100.0, 60.0), (100.0, 0.0)]
    contour = [("G0", {"X": 100.0, "Y": 0.0}), *(("G1", {"X": x, "Y": y}) for x, y in aside)]
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), *raster_beside, *contour])
    found = recognize(path)
    assert found.strategy is Strategy.MIXED and len(found.spans) >= 2, found.reason
    assert not found.finishing
    assert {s.strategy for s in found.spans} == {Strategy.ZIGZAG, Strategy.PROFILE}
    assert sum(s.share for s in found.spans) == pytest.approx(1.0, abs=0.02)
    assert all(a.last < b.first for a, b in zip(found.spans, found.spans[1:]))
    for span in found.spans:
        assert path.command[span.first] == span.first_command and path.command[span.last] == span.last_command


def test_tool_changes_divide_a_program_into_spans():
    found = recognize(linearize(synthetic.program(np.random.default_rng(1))))
    assert found.strategy is Strategy.MIXED
    assert [s.strategy for s in found.spans] == [Strategy.ZIGZAG, Strategy.DRILLING, Strategy.PROFILE]


def test_comment_alone_does_not_divide_a_toolpath():
    rows = [("G1", {"X": float(x), "Y": float(y)}) for x, y in raster()]
    plain = [("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), *rows]
    titled = [("(Pocket)", {}), *plain[:15], ("(finish)", {}), *plain[15:], ("(Profile)", {})]
    found = recognize(linearize(titled))
    assert found.strategy is Strategy.ZIGZAG and len(found.spans) == 1


def test_toolpath_without_cuts_is_empty():
    nothing = linearize([])
    assert recognize(nothing).strategy is Strategy.EMPTY and recognize(nothing).reason
    rapids = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"X": 9.0})])
    assert recognize(rapids).strategy is Strategy.EMPTY
    assert "rapid" in recognize(rapids).reason


def test_strategy_prints_its_value():
    assert str(Strategy.ZIGZAG) == "zigzag" and f"{Strategy.ONE_WAY}" == "one-way"
    assert Strategy("contour-parallel") is Strategy.CONTOUR_PARALLEL


@pytest.mark.parametrize("make", [raster, rings], ids=["zigzag", "offsets"])
@pytest.mark.parametrize("angle", [0.0, 0.3, 1.57, 2.5, 4.0])
def test_strategy_does_not_depend_on_direction_or_position(make, angle):
    points = make()
    c, s = np.cos(angle), np.sin(angle)
    turned = points @ np.array([[c, s], [-s, c]]) + (1000.0, -777.7)
    assert recognize(cut(turned)).strategy is recognize(cut(points)).strategy


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.tuples(*[st.integers(-5, 5)] * 3), min_size=1, max_size=60),
    st.lists(st.booleans(), min_size=60, max_size=60),
    st.sampled_from([None, 0.0, 2.0]),
)
def test_recognition_of_random_toolpaths_raises_no_exception(points, fast, tool):
    points = np.array(points, float)
    keep = np.concatenate([[True], (points[1:] != points[:-1]).any(axis=1)])
    path = cut(points[keep], rapid=[i for i in range(keep.sum() - 1) if fast[i]])
    found = recognize(path, tool_diameter=tool)
    assert 0.0 <= found.confidence <= 1.0 and found.reason
    assert (found.strategy is Strategy.EMPTY) == bool(path.rapid.all())
    if found.spans:
        assert found.spans[0].first >= 0 and found.spans[-1].last < len(path)


def test_many_areas_are_recognised_without_python_loops():
    # Each of 20,000 strokes is an area. A Python loop over areas would be slow.
    strokes = np.zeros((40_000, 3))
    strokes[:, 0] = np.tile([0.0, 10.0, 10.0, 0.0], 10_000)
    strokes[:, 1] = np.repeat(np.arange(20_000), 2) * 0.5
    path = cut(strokes, rapid=range(1, 39_999, 2))
    found = recognize(path)
    assert found.strategy is Strategy.ZIGZAG and found.passes == 20_000


def test_unknown_toolpath_has_no_stepover_and_no_other_numbers():
    path = replace(cut([(0, 0), (5, 0), (5, 5)]), command=np.array([3, 7]))
    found = unknown(path, Message("moves-nothing"))
    assert "moves a tool" in found.reason
    assert vars(found) == {
        "strategy": Strategy.UNKNOWN, "confidence": 0.0, "why": Message("moves-nothing"), "level": 0, "phi_range": (0.0, 0.0),
        "spans": (Span(0, 1, 3, 7, Strategy.UNKNOWN, 1.0),), "reversals": 0, "sense": None, "stepover": None, "passes": None,
        "depths": 0, "direction": None, "closed_loops": 0, "milling": None, "entry": None, "finishing": False, "paper": None,
    }  # fmt: skip


def test_span_of_an_operation_is_first_to_last_cut():
    way = [("G0", {"Z": 5.0}), *(("G0", {"X": x}) for x in (9.0, 19.0, 29.0))]
    path = linearize([*way, *programs.profile(depths=(-1.0,)), ("G0", {"X": 0.0, "Y": 0.0})])
    cuts = np.flatnonzero(~path.rapid)
    (span,) = recognize(path).spans
    before, behind = cuts[0], len(path) - 1 - cuts[-1]
    assert (span.first, span.last) == (cuts[0], cuts[-1]) and before > behind > 1
    assert (span.first_command, span.last_command, span.share) == (*path.command[cuts[[0, -1]]], 1.0)


@pytest.mark.parametrize(
    "tool, known", [(0.5, True), (0, False), (-0.5, False), (None, False), (math.nan, False), (math.inf, False)]
)
def test_tiny_tool_diameter_is_used_and_a_diameter_of_0_is_not(tool, known):
    """Two contours are 0.7 mm apart.

    A tool of 0.5 mm leaves material between the contours. Without a tool, the contours are a pocket.
    """
    path = linearize(programs.program([polygon(60.0), polygon(58.6)]))
    assert recognize(path, tool_diameter=tool).stepover == (None if known else pytest.approx(0.7))


@pytest.mark.parametrize("commands", [[], [("G0", {"X": 5.0})]])
def test_toolpath_without_cuts_is_empty_with_certainty(commands):
    found = recognize(linearize(commands))
    assert (found.strategy, found.confidence) == (Strategy.EMPTY, 1.0)


def rectangle(x, y, width, height):
    """Return the commands of a closed loop with a plunge, from a corner at (x, y)."""
    ways = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
    commands = [("G0", {"Z": 5.0}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": -1.0, "F": 5.0})]
    return commands + [("G1", {"X": a, "Y": b, "F": 10.0}) for a, b in ways[1:]]


def test_large_loops_decide_the_stepover():
    """Small loops with smaller steps clear the corners of the pocket."""
    corners = [(x, y) for x in (-20, 120) for y in (-20, 100)]
    loops = [(4.2 * k, 4.2 * k, 100 - 8.4 * k, 80 - 8.4 * k) for k in range(4)]
    loops += [(x + 1.5 * k, y + 1.5 * k, 9 - 3 * k, 8 - 3 * k) for x, y in corners for k in (0, 1)]
    commands = [command for loop in loops for command in rectangle(*loop)]
    found = recognize(linearize(commands), tool_diameter=6.0)
    assert found.strategy == "contour-parallel"
    assert found.stepover == pytest.approx(4.2)


def test_loop_around_islands_is_one_stepover_inside_the_wall():
    """The second loop follows an island.

    The second loop is longer than the first and encloses less, but all its sides moved by the same step.
    """
    bay = [(4.2, 4.2), (95.8, 4.2), (95.8, 75.8), (4.2, 75.8), (4.2, 50), (40, 50), (40, 30), (4.2, 30), (4.2, 4.2)]
    inner = [("G0", {"Z": 5.0}), ("G0", {"X": 4.2, "Y": 4.2}), ("G1", {"Z": -1.0})]
    inner += [("G1", {"X": x, "Y": y}) for x, y in bay[1:]]
    found = recognize(linearize(rectangle(0, 0, 100, 80) + inner), tool_diameter=6.0)
    assert found.stepover == pytest.approx(4.2)
