# SPDX-License-Identifier: LGPL-2.1-or-later
"""Peculiarities of real programs that must not mislead the recognition."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from vkworkbench.core import Strategy
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition.programs.recognize import recognize

START = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0, "F": 5.0})]


def rows(count=24, length=60.0, step=2.0, scale=1.0):
    """Return the commands of a zigzag."""
    program = list(START)
    for k in range(count):
        x = length if k % 2 == 0 else 0.0
        program.append(("G1", {"X": x * scale, "Y": k * step * scale}))
        program.append(("G1", {"X": x * scale, "Y": (k + 1) * step * scale}))
    return program


def bore(turns=6, radius=8.0):
    """Return the commands of a helical bore that ends with a level turn."""
    program = [("G0", {"X": radius, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0})]
    program += [("G3", {"X": radius, "Y": 0.0, "Z": -1.0 * (k + 1), "I": -radius, "J": 0.0}) for k in range(turns)]
    return [*program, ("G3", {"X": radius, "Y": 0.0, "I": -radius, "J": 0.0})]


def strategy(commands, **options):
    return recognize(linearize(commands), **options).strategy


def test_zigzag_with_thousands_of_exact_reversals_is_a_zigzag():
    # In a public zigzag program with 6,212 exact reversals, the paper's rule as printed finds a contour with 3,103 full
    # turns.
    program = list(START)
    for k in range(3106):
        y = 0.05 * k
        program += [
            ("G1", {"X": 40.0, "Y": y}),
            ("G1", {"X": 0.0, "Y": y}),
            ("G0", {"X": 0.0, "Y": y + 0.05}),
        ]
        if k % 2:
            program.pop()
            program.append(("G1", {"X": 0.0, "Y": y + 0.05}))
    found = recognize(linearize(program))
    assert found.reversals == 3106
    assert found.level == 0 and max(np.abs(found.phi_range)) <= math.pi + 1e-9
    assert found.strategy is Strategy.ZIGZAG


def test_reversals_with_rounding_errors_do_not_add_full_turns():
    # Rounding of 0.001 mm gives turns of almost pi a random sign.
    rng = np.random.default_rng(5)
    program = list(START)
    for k in range(200):
        program += [("G1", {"X": 50.0, "Y": round(k * 1.0 + rng.normal(0, 5e-4), 3)}),
                    ("G1", {"X": 0.0, "Y": round(k * 1.0 + rng.normal(0, 5e-4), 3)}),
                    ("G0", {"Z": 1.0}), ("G0", {"Y": k + 1.0}), ("G1", {"Z": -1.0})]  # fmt: skip
    assert recognize(linearize(program)).level == 0


@pytest.mark.parametrize("scale", [25.4, 1 / 25.4])
def test_zigzag_at_inch_scale_is_a_zigzag(scale):
    assert strategy(rows(scale=scale)) is Strategy.ZIGZAG


def test_bore_with_absolute_arc_centres_is_a_helix():
    absolute = [("G90.1", {}), ("G0", {"X": 28.0, "Y": 10.0, "Z": 5.0}), ("G1", {"Z": 0.0})]
    absolute += [("G3", {"X": 28.0, "Y": 10.0, "Z": -1.0 * (k + 1), "I": 20.0, "J": 10.0}) for k in range(6)]
    found = recognize(linearize(absolute))
    assert found.strategy is Strategy.HELIX and found.sense == "ccw"


@pytest.mark.parametrize("plane, along, depth", [("G18", "X", "I"), ("G19", "Y", "J")])
def test_rows_of_arcs_in_a_vertical_plane_are_a_zigzag(plane, along, depth):
    across = "Y" if along == "X" else "X"
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), (plane, {})]
    for k in range(16):
        end = 40.0 if k % 2 == 0 else 0.0
        centre = 20.0 if k % 2 == 0 else -20.0
        clockwise = (k % 2 == 0) == (plane == "G18")
        program.append(("G2" if clockwise else "G3", {along: end, "Z": 0.0, depth: centre, "K": 30.0}))
        program.append(("G1", {across: 2.0 * (k + 1)}))
    assert strategy(program) is Strategy.ZIGZAG


def test_rows_in_a_vertical_plane_are_a_zigzag():
    program = [("G0", {"X": 0.0, "Y": 7.0, "Z": 0.0})]
    for k in range(12):
        program.append(("G1", {"X": 40.0 - k if k % 2 == 0 else float(k), "Z": -1.5 * k}))
        program.append(("G1", {"X": 39.0 - k if k % 2 == 0 else k + 1.0, "Z": -1.5 * (k + 1)}))
    assert strategy(program) is Strategy.ZIGZAG


def test_rows_of_arcs_with_huge_radius_are_a_zigzag():
    program, radius = list(START), 1e6
    for k in range(24):
        x = 60.0 if k % 2 == 0 else 0.0
        program.append(
            (
                "G2" if k % 3 else "G3",
                {"X": x, "Y": 2.0 * k, "I": 0.0, "J": radius if k % 3 == 0 else -radius},
            )
        )
        program.append(("G1", {"X": x, "Y": 2.0 * (k + 1)}))
    assert strategy(program) is Strategy.ZIGZAG


def test_full_circles_with_equal_ends_are_a_profile():
    program = [("G0", {"X": 10.0, "Y": 0.0, "Z": 5.0})]
    for z in (-1.0, -2.0, -3.0):
        program += [("G1", {"Z": z}), ("G2", {"X": 10.0, "Y": 0.0, "I": -10.0, "J": 0.0}), ("G0", {"Z": 5.0})]
    found = recognize(linearize(program))
    assert found.strategy is Strategy.PROFILE
    assert (found.level, found.sense, found.depths, found.closed_loops) == (-1, "cw", 3, 3)


def test_modal_canned_cycles_are_drilling():
    program = [("G0", {"Z": 5.0}), ("G83", {"X": 0.0, "Y": 0.0, "Z": -8.0, "R": 1.0, "Q": 2.0, "F": 3.0})]
    program += [("G83", {"X": 9.0 * k, "Y": 4.0}) for k in range(1, 7)] + [("G80", {})]
    found = recognize(linearize(program), tool_diameter=5.0)
    assert found.strategy is Strategy.DRILLING and found.passes == 7


def test_line_numbers_and_comments_do_not_change_strategy():
    noisy = [("(%)", {}), ("(program 17, операция «Карман»)", {})]
    for k, (name, words) in enumerate(rows()):
        noisy += [(name, {**words, "N": 10.0 * k}), ("(step)", {})]
    assert strategy(noisy) is Strategy.ZIGZAG


def test_disabled_lines_do_not_change_the_strategy():
    program = rows()
    program[10:10] = [("(/G1 X0 Y0)", {}), ("(;G3 X1 Y1 I5)", {})]
    assert strategy(program) is Strategy.ZIGZAG


def test_moves_of_zero_length_do_not_change_the_strategy():
    stuttering = []
    for name, words in rows():
        stuttering += [(name, words), (name, {a: -0.0 if v == 0 else v for a, v in words.items()})]
    plain, doubled = recognize(linearize(rows())), recognize(linearize(stuttering))
    assert doubled.strategy is plain.strategy
    assert doubled.phi_range == pytest.approx(plain.phi_range) and doubled.passes == plain.passes


def test_bore_of_radius_format_arcs_is_a_helix():
    program = [("G0", {"X": 0.0, "Y": -10.0, "Z": 5.0}), ("G1", {"Z": 0.0})]
    for k in range(7):
        program += [
            ("G3", {"X": 0.0, "Y": 10.0, "Z": -k - 0.5, "R": 10.0}),
            ("G3", {"X": 0.0, "Y": -10.0, "Z": -k - 1.0, "R": 10.0}),
        ]
    found = recognize(linearize(program))
    assert found.strategy is Strategy.HELIX and found.level == 7


def test_rows_with_incremental_words_are_a_zigzag():
    program = [*START, ("G91", {})]
    for k in range(24):
        program += [("G1", {"X": 60.0 if k % 2 == 0 else -60.0}), ("G1", {"Y": 2.0})]
    found = recognize(linearize(program))
    assert found.strategy is Strategy.ZIGZAG and found.stepover == pytest.approx(2.0)


@pytest.mark.parametrize(
    "name, commands, truth",
    [
        ("(2D Pocket3)", rows(), Strategy.ZIGZAG),
        ("(DRILL3)", bore(), Strategy.HELIX),
        ("(Adaptive)", rows(), Strategy.ZIGZAG),
    ],
)
def test_misleading_titles_do_not_change_the_strategy(name, commands, truth):
    assert strategy([(name, {}), *commands]) is truth


def test_noise_of_a_micrometre_adds_no_full_turns():
    rng = np.random.default_rng(2)
    program = list(START)
    for name, words in rows()[2:]:
        program.append((name, words))
        program.append((name, {a: v + rng.normal(0, 1e-3) for a, v in words.items()}))
    found = recognize(linearize(program))
    assert found.strategy is Strategy.ZIGZAG and found.level == 0


def test_phi_of_clockwise_zigzag_stays_between_minus_pi_and_0():
    mirrored = [(n, {a: -v if a == "Y" else v for a, v in w.items()}) for n, w in rows()]
    found = recognize(linearize(mirrored))
    assert found.strategy is Strategy.ZIGZAG and found.level == 0
    assert found.phi_range == pytest.approx((-math.pi, 0.0))


def test_zigzag_that_starts_on_the_boundary_is_a_zigzag():
    # FreeCAD begins a zigzag with a piece of the boundary, so phi lies between an angle a and a + pi, not 0 and pi.
    program = [
        ("G0", {"X": -8.0, "Y": -5.0, "Z": -1.0}),
        ("G1", {"X": -4.0, "Y": -7.0}),
        ("G1", {"X": 0.0, "Y": 0.0}),
        *rows()[2:],
    ]
    assert strategy(program) is Strategy.ZIGZAG


def test_descending_path_around_a_rectangle_is_a_profile():
    corners = [(0.0, 0.0), (50.0, 0.0), (50.0, 20.0), (0.0, 20.0)]
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0})]
    for k in range(1, 25):
        x, y = corners[k % 4]
        program.append(("G1", {"X": x, "Y": y, "Z": -0.25 * k}))
    assert strategy(program) is Strategy.PROFILE


def squares(halves, *, about=(0.0, 0.0), ccw=True, depths=(-1.0,)):
    """Return the commands of squares around a point. Each square is a separate cut, at every depth."""
    (x, y), program = about, []
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1)]
    for z in depths:
        for k, half in enumerate(halves):
            sign = 1 if ccw or k % 2 else -1
            at = [{"X": x + half * u, "Y": y + sign * half * v} for u, v in corners]
            program += [("G0", at[0]), ("G1", {"Z": z}), *[("G1", a) for a in at[1:]], ("G0", {"Z": 5.0})]
    return [START[0], *program]


@pytest.mark.parametrize("ccw", [True, False])
@pytest.mark.parametrize("tool", [None, 10.0])
def test_two_contours_at_every_depth_are_not_a_pocket(ccw, tool):
    # A washer that is cut at three depths has as many equal steps between rings as a pocket.
    washer = squares([30, 12], ccw=ccw, depths=(-1, -2, -3))
    assert strategy(washer, tool_diameter=tool) is Strategy.PROFILE
    # If the tool is as wide as the washer, the strategy is not a zigzag.
    washer = squares([30, 12], ccw=False, depths=(-1, -2, -3))
    assert strategy(washer, tool_diameter=25.0) is not Strategy.ZIGZAG
    # A cut from one contour to the other without a lift clears the area between them.
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1)]
    first, *others = [{"X": half * u, "Y": half * v} for half in (30.0, 12.0) for u, v in corners]
    linked = [START[0]]
    for z in (-1, -2, -3):
        linked += [("G0", first), ("G1", {"Z": z}), *[("G1", at) for at in others], ("G0", {"Z": 5.0})]
    assert strategy(linked) is Strategy.CONTOUR_PARALLEL


@pytest.mark.parametrize("angle", [0.0, 0.2, 0.5, 0.785])
def test_stepover_of_offsets_is_rotation_invariant(angle):
    # If a square is rotated, an offset by one step moves the sides of its bounding box by up to sqrt(2) steps.
    path = linearize(squares([3, 7, 11, 15, 19, 23]))
    c, s = math.cos(angle), math.sin(angle)
    points = path.points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    found = recognize(dataclasses.replace(path, points=points))
    assert found.strategy is Strategy.CONTOUR_PARALLEL
    assert found.stepover == pytest.approx(4.0)


@pytest.mark.parametrize("degrees", [10, 20, 35, 60, 90])
def test_two_fields_of_rows_at_any_angle_are_a_zigzag(degrees):
    # The main axis of both fields together lies between the axes of the fields, where no row lies.
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    program = []
    for turned in (False, True):
        for k in range(16):
            ends = [(0.0, 2.0 * k), (40.0, 2.0 * k)][:: 1 if k % 2 else -1]
            if turned:
                ends = [(100 + c * x - s * y, s * x + c * y) for x, y in ends]
            (x, y), (far_x, far_y) = ends
            program += [("G0", {"X": x, "Y": y}), ("G1", {"Z": -1.0}), ("G1", {"X": far_x, "Y": far_y}),
                        ("G0", {"Z": 5.0})]  # fmt: skip
    found = recognize(linearize([START[0], *program]))
    assert found.strategy is Strategy.ZIGZAG
    assert found.stepover == pytest.approx(2.0)


def test_spiral_repeated_at_depths_is_not_a_helix():
    # Every turn is repeated at the next depth, and rises and falls with the surface.
    program = [START[0]]
    for deep in (0.0, -1.0, -2.0):
        for k in range(36 * 8 + 1):
            angle, r = k * math.pi / 18, 2 + k / 12
            word = {"X": r * math.cos(angle), "Y": r * math.sin(angle), "Z": deep - 0.002 * r * r}
            program.append(("G0" if k == 0 else "G1", word))
        program.append(("G0", {"Z": 5.0}))
    assert strategy(program) is Strategy.SPIRAL


@pytest.mark.parametrize("turns", [4, 20, 100])
@pytest.mark.parametrize(("even", "found", "step"), [(True, Strategy.SPIRAL, 1.0), (False, Strategy.ADAPTIVE, 0.97)])
def test_pocket_after_an_entry_helix_of_any_length_is_recognized(turns, even, found, step):
    program = [START[0]]
    for k in range(36 * turns + 1):
        a = k * math.pi / 18
        program.append(("G1", {"X": 2 * math.cos(a), "Y": 2 * math.sin(a), "Z": -0.5 * k / 36}))
    for k in range(36 * 12 + 1):
        # With a constant engagement, the step grows with the radius, so the first turns are closer together.
        a, r = k * math.pi / 18, 2 + k / 36 - (0 if even else 0.8 * (1 - math.exp(-k / 90)))
        program.append(("G1", {"X": r * math.cos(a), "Y": r * math.sin(a)}))
    told = recognize(linearize(program), tool_diameter=4.0)
    assert told.strategy is found
    assert told.stepover == pytest.approx(step, abs=0.02)


def test_stepover_of_crossed_rows_is_the_period_of_the_pattern():
    # On the way back, the passes lie 0.6 mm beside the passes of the way out.
    program = [START[0]]
    for along, across in (("X", "Y"), ("Y", "X")):
        back = [k * 2.0 + 0.6 for k in range(20)][::-1]
        for k, line in enumerate([*(k * 2.0 for k in range(20)), *back]):
            ends = [0.0, 40.0][:: 1 if k % 2 else -1]
            program += [("G0", {along: ends[0], across: line}), ("G1", {"Z": -1.0}), ("G1", {along: ends[1]}),
                        ("G0", {"Z": 5.0})]  # fmt: skip
    found = recognize(linearize(program))
    assert found.strategy is Strategy.ZIGZAG
    assert found.stepover == pytest.approx(2.0)


def test_reasons_use_the_singular_for_one_and_signs_for_turns():
    one = recognize(linearize(squares([20])))
    assert "over one loop" in one.reason and "+1.00 turns" in one.reason
    straight = recognize(linearize([*START, ("G1", {"X": 50.0})]))
    assert "Phi stays at 0 over one open stroke" in straight.reason


@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("count", [5, 8, 15, 33])
def test_contour_through_the_start_of_a_zigzag_finishes_the_rows(count, turn):
    # The zigzag plus the first half of the contour returns to the start after one net turn, but is not a loop.
    width, step = 30.0, 7.0
    end = (count - 1) * step
    corners = [(0.0, 0.0), (end, 0.0), (end, width), (0.0, width)]
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0})]
    for k in range(count):
        program += [("G1", {"X": k * step}), ("G1", {"Y": width if k % 2 == 0 else 0.0})]
    at = 2 if count % 2 else 1
    for k in range(1, 5):
        x, y = corners[(at + turn * k) % 4]
        program.append(("G1", {"X": x, "Y": y}))
    found = recognize(linearize(program), tool_diameter=10.0)
    assert found.strategy is Strategy.ZIGZAG and found.finishing, found.reason


def inward(wobble=0.0, digits=6, waves=100):
    """Return a spiral inward in moves of 0.12 to 0.18 mm. The radius varies by `wobble` mm, `waves` times per turn."""
    angle = np.arange(0, 9 * math.tau, 0.004)
    radius = 44 - 1.5 * angle / math.tau + wobble * np.sin(waves * angle)
    points = np.round(np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]), digits)
    program = [("G0", {"X": points[0, 0], "Y": points[0, 1], "Z": 5.0}), ("G1", {"Z": -1.0})]
    return program + [("G1", {"X": x, "Y": y}) for x, y in points[1:]]


def test_spiral_with_many_small_corrections_is_adaptive():
    assert strategy(inward(wobble=0.03), tool_diameter=6.0) is Strategy.ADAPTIVE
    assert strategy(inward(wobble=0.13, waves=20), tool_diameter=6.0) is Strategy.ADAPTIVE
    assert strategy(inward(), tool_diameter=6.0) is Strategy.SPIRAL


@pytest.mark.parametrize("digits", [2, 3])
def test_spiral_of_short_rounded_moves_is_a_spiral(digits):
    assert strategy(inward(digits=digits), tool_diameter=6.0) is Strategy.SPIRAL


@pytest.mark.parametrize("pieces", [1, 4])
def test_slopes_of_carved_strokes_are_not_depths(pieces):
    slopes = [((0, 0, -6), (1, 3, 0)), ((60, 0, -5), (58, 2, 0)), ((0, 40, -4), (3, 39, 0)),
              ((60, 40, -3), (59, 37, 0))]  # fmt: skip
    level = [((5, 8, -6), (30, 20, -6)), ((55, 5, -6), (30, 20, -6)), ((30, 20, -6), (33, 40, -6))]
    program = []
    for points in slopes + level:
        ends = np.arange(len(points))
        x, y, z = (np.interp(np.arange(0, ends[-1] * pieces + 1) / pieces, ends, v) for v in zip(*points))
        program += [("G0", {"Z": 5.0}), ("G0", {"X": x[0], "Y": y[0]}), ("G1", {"Z": z[0]})]
        program += [("G1", {"X": a, "Y": b, "Z": c}) for a, b, c in zip(x[1:], y[1:], z[1:])]
    assert strategy(program) is Strategy.ENGRAVING


@pytest.mark.parametrize("degrees", [0, 30])
def test_loops_around_ribs_in_a_row_are_not_trochoids(degrees):
    # Loops of one size lie side by side, each at four depths. In a trochoid, the loops themselves overlap, and not only
    # their bounding boxes.
    program = []
    u, v = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    for z in (-1.0, -2.0, -3.0, -4.0):
        for k in range(6):
            corners = ((10, 14 * k), (70, 14 * k), (70, 14 * k + 9), (10, 14 * k + 9), (10, 14 * k))
            first, *others = [{"X": u * x - v * y, "Y": v * x + u * y} for x, y in corners]
            program += [("G0", first), ("G1", {"Z": z}), *(("G1", words) for words in others), ("G0", {"Z": 5.0})]
    assert strategy(program[: len(program) // 4], tool_diameter=5.0) is Strategy.PROFILE
    assert strategy(program, tool_diameter=5.0) is Strategy.PROFILE


@pytest.mark.parametrize("straight", [False, True])
def test_full_turns_with_many_open_strokes_are_not_a_spiral(straight):
    # Adaptive clearing from outside the stock has full turns while stock remains all around, and then arcs at both
    # ends, or rows along both sides, all climb or all conventional.
    program, gap = [("G0", {"X": 90.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0})], 1.2
    angle = np.arange(0, 12 * math.tau, 0.05)
    shrink = gap * angle / math.tau
    for x, y in zip((90 - shrink) * np.cos(angle), (55 - shrink) * np.sin(angle)):
        program.append(("G1", {"X": x, "Y": y}))
    for k in range(1, 45):
        angle, side = np.linspace(-1.5, 1.5, 40), (-1) ** k
        x, y = 50 - 0.6 * k + 25 * np.cos(angle), (38 - 0.4 * k) * np.sin(angle)
        if straight:
            x, y = np.linspace(45 - 0.2 * k, 0.2 * k - 45, 40), np.full(40, 40 - 0.6 * k)
        x, y = side * x, side * y
        program += [("G0", {"Z": 5.0}), ("G0", {"X": x[0], "Y": y[0]}), ("G1", {"Z": -1.0})]
        program += [("G1", {"X": a, "Y": b}) for a, b in zip(x[1:], y[1:])]
    assert strategy(program, tool_diameter=6.0) is Strategy.ADAPTIVE


@pytest.mark.parametrize("diameter", [3.0, None])
@pytest.mark.parametrize("teeth, width, gap", [(12, 3.5, 6.6), (5, 4.0, 4.0), (9, 6.0, 7.0)])
def test_walls_of_a_comb_are_not_rows(teeth, width, gap, diameter):
    """A profile around a comb runs back and forth in even steps, but is closed, and teeth alternate with gaps."""
    outside, corners = 1.5, [(-1.5, -10.0)]
    for left in np.arange(teeth) * (width + gap):
        corners += [(left - outside, 30.0), (left + width + outside, 30.0)]
        corners += [(left + width + outside, 1.5), (left + width + gap - outside, 1.5)]
    corners = [*corners[:-2], (corners[-3][0], -10.0), corners[0]]
    commands = [("G0", {"X": corners[0][0], "Y": corners[0][1], "Z": 5.0}), ("G1", {"Z": -2.0})]
    commands += [("G1", {"X": float(x), "Y": y}) for x, y in corners[1:]]
    assert recognize(linearize(commands), tool_diameter=diameter).strategy is Strategy.PROFILE


@pytest.mark.parametrize(
    "name, words, code",
    [
        ("G1", {"Y": 3.0, "A": 90.0}, "rotary-cuts"),
        ("M98", {"P": 100.0}, "subprogram-not-read"),
        ("G81", {"X": 10.0, "Y": 0.0, "Z": 0.0, "R": 5.0}, "cycle-outside-xy"),
    ],
)
def test_path_with_hidden_cuts_is_unknown_with_the_reason(name, words, code):
    """A rotary axis that turns, and a subprogram, cut something that the moves in the plane do not show."""
    commands = rows()
    found = recognize(linearize([*commands, ("G19", {}), (name, words)]))
    assert (found.strategy, found.confidence) == ("unknown", 0.0)
    assert found.why.arguments["sentence"].code == code
    assert recognize(linearize(commands)).strategy == "zigzag"


def test_rotary_axis_that_turns_above_the_part_hides_nothing():
    commands = [*rows(), ("G0", {"Z": 5.0}), ("G0", {"A": 90.0})]
    assert recognize(linearize(commands)).strategy == "zigzag"


@pytest.mark.parametrize("plunge", ["first", "last"])
def test_single_plunge_is_not_an_operation(plunge):
    """The plunge parks the tool after the work, or touches the stock before the work."""
    down = [("G0", {"X": -30.0, "Y": -30.0}), ("G1", {"Z": 0.0, "F": 5.0})]
    commands = (
        [*START, *down, ("G0", {"Z": 5.0}), *rows()] if plunge == "first" else [*rows(), ("G0", {"Z": 5.0}), *down]
    )
    found = recognize(linearize(commands), program=True)
    assert [span.strategy for span in found.spans] == ["zigzag"] == [found.strategy]
    holes = [
        *rows(),
        ("G0", {"Z": 5.0}),
        *down,
        ("G0", {"Z": 5.0}),
        ("G0", {"X": -40.0}),
        ("G1", {"Z": 0.0}),
        ("G0", {"Z": 5.0}),
    ]
    assert [span.strategy for span in recognize(linearize(holes), program=True).spans] == ["zigzag", "drilling"]


def test_program_with_one_title_is_one_operation():
    """Without the title, the retract between the zigzag and the nested loops divides the program."""
    loops = [
        ("G1", {"X": 100 + s * a, "Y": 100 + s * b})
        for s in range(20, 2, -2)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
    ]
    both = [*rows(), ("G0", {"Z": 5.0}), ("G0", {"X": 80.0, "Y": 80.0}), ("G1", {"Z": -1.0}), *loops]
    assert recognize(linearize(both), tool_diameter=4.0, program=True).why.code == "sections"
    titled = recognize(linearize([("(Pocket 1)", {}), *both]), tool_diameter=4.0, program=True)
    assert titled.why.code != "sections"
