# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands are converted to trajectories: modal words, arcs in every plane and form, canned cycles, and bad input."""

from types import SimpleNamespace

import numpy as np
import pytest

from vkworkbench.core import COORDINATE_LIMIT, linearize


def path(*commands, **options):
    return linearize([(name, dict(words)) for name, words in commands], **options)


def ends(toolpath):
    return toolpath.points[1:].tolist()


START = ("G0", {"X": 0, "Y": 0, "Z": 0})


def test_axis_without_a_word_keeps_its_coordinate():
    toolpath = path(START, ("G1", {"X": 10, "F": 5}), ("G1", {"Y": 5}), ("G0", {"Z": 3}))
    assert ends(toolpath) == [[10, 0, 0], [10, 5, 0], [10, 5, 3]]
    assert toolpath.rapid.tolist() == [False, False, True]
    assert toolpath.feed.tolist() == [5, 5, 0]
    assert toolpath.command.tolist() == [1, 2, 3]


def test_first_move_does_not_start_at_the_origin():
    toolpath = path(("G0", {"Z": 27}), ("G0", {}), ("G0", {"X": 62, "Y": 42}), ("G1", {"Z": 8}))
    assert toolpath.points.tolist() == [[62, 42, 27], [62, 42, 8]]


def test_command_names_with_zeros_small_letters_or_none_are_read():
    commands = [
        SimpleNamespace(Name=n, Parameters=p)
        for n, p in [("g00", {"X": 0.0, "Y": 0.0, "Z": 0.0}), ("G01", {"X": 1.0}), ("", {"X": 2.0}), ("G1", {"Y": 1.0})]
    ]
    assert ends(linearize(commands)) == [[1, 0, 0], [2, 0, 0], [2, 1, 0]]
    assert linearize(iter(commands)).points.shape == (4, 3)


def test_lower_case_words_equal_upper_case_words():
    large = path(START, ("G1", {"X": 2, "F": 5}), ("G2", {"X": 4, "I": 1}))
    small = path(("g0", {"x": 0, "y": 0, "z": 0}), ("g1", {"x": 2, "f": 5}), ("g2", {"x": 4, "i": 1}))
    assert ends(small) == ends(large) and small.feed.tolist() == large.feed.tolist() and not small.problems


def test_line_without_a_name_continues_a_rapid():
    toolpath = path(START, ("", {"X": 2}), ("", {"Y": 1}))
    assert ends(toolpath) == [[2, 0, 0], [2, 1, 0]] and toolpath.rapid.all() and not toolpath.problems


def test_line_numbers_and_axis_words_as_command_names_are_read():
    toolpath = path(
        START,
        ("N10", {"G": 1.0, "X": 1.0}),
        ("X2.5", {"Y": 1.0}),
        ("N20", {}),
        ("N30", {"X": 4.0}),
        ("N40", {"M": 6.0}),
        ("/G1", {"X": 9.0}),
        ("%", {}),
    )
    assert ends(toolpath) == [[1, 0, 0], [2.5, 1, 0], [4, 1, 0]] and not toolpath.problems


def test_moves_of_zero_length_are_dropped():
    toolpath = path(START, ("G1", {"X": -0.0}), ("G1", {"X": 5}), ("G1", {"X": 5}), ("G1", {}), ("G1", {"Y": -0.0}))
    assert ends(toolpath) == [[5, 0, 0]]
    assert not np.signbit(toolpath.points).any()


def test_relative_words_add_to_the_position():
    toolpath = path(START, ("G91", {}), ("G1", {"X": 2}), ("G1", {"X": 2, "Y": 1}), ("G90", {}), ("G1", {"X": 1}))
    assert ends(toolpath) == [[2, 0, 0], [4, 1, 0], [1, 1, 0]]


@pytest.mark.parametrize("sense", [1, -1])
def test_relative_moves_stop_at_the_coordinate_limit(sense):
    far = 0.75 * COORDINATE_LIMIT * sense
    toolpath = path(
        START, ("G91", {}), ("G1", {"X": far, "Y": 3}), ("G1", {"X": far}), ("G1", {"Z": -2}), ("G1", {"X": -far})
    )
    end = COORDINATE_LIMIT * sense
    assert ends(toolpath) == [[far, 3, 0], [end, 3, 0], [end, 3, -2], [far, 3, -2]]
    assert [(problem.what.code, problem.command) for problem in toolpath.problems] == [("position-cut-off", 3)]


@pytest.mark.parametrize("tolerance", [1.0, 0.1, 0.01, 0.001])
def test_chord_error_is_just_within_the_tolerance(tolerance):
    toolpath = path(START, ("G3", {"X": 0, "Y": 0, "I": 50, "J": 0}), tolerance=tolerance)
    middles = 0.5 * (toolpath.points[1:] + toolpath.points[:-1])
    sagitta = 50 - np.hypot(middles[:, 0] - 50, middles[:, 1])
    assert sagitta.max() <= tolerance
    assert sagitta.max() > 0.9 * tolerance
    assert toolpath.sweep.sum() == pytest.approx(2 * np.pi, abs=1e-12)


@pytest.mark.parametrize("name, i, j, sweep", [("G2", 5, 0, -np.pi), ("G3", 5, 0, np.pi), ("G3", 10, 0, 2 * np.pi)])
def test_chords_of_an_arc_keep_its_exact_sweep_and_end(name, i, j, sweep):
    end = {"X": 10.0, "Y": 0.0} if abs(sweep) < 4 else {"X": 0.0, "Y": 0.0}
    toolpath = path(START, (name, {**end, "I": i, "J": j}))
    assert toolpath.sweep.sum() == pytest.approx(sweep, abs=1e-12)
    assert toolpath.points[-1, :2].tolist() == [end["X"], end["Y"]]
    assert np.sign(toolpath.points[len(toolpath) // 4, 1]) == (1 if name == "G2" else -1)


@pytest.mark.parametrize("radius, sweep", [(10.0, np.pi / 2), (-10.0, 1.5 * np.pi)])
@pytest.mark.parametrize("name, sign", [("G2", -1), ("G3", 1)])
def test_radius_word_gives_the_centre_of_an_arc(radius, sweep, name, sign):
    toolpath = path(START, (name, {"X": 10, "Y": 10, "R": radius}))
    assert toolpath.sweep.sum() == pytest.approx(sign * sweep)
    centre = np.array([0, 10]) if (name == "G3") == (radius > 0) else np.array([10, 0])
    assert np.allclose(np.hypot(*(toolpath.points[:, :2] - centre).T), 10)


def test_absolute_and_relative_arc_centres_are_read():
    relative = path(("G0", {"X": 20, "Y": 5, "Z": 0}), ("G2", {"X": 30, "Y": 5, "I": 5, "J": 0}))
    absolute = path(("G90.1", {}), ("G0", {"X": 20, "Y": 5, "Z": 0}), ("G2", {"X": 30, "Y": 5, "I": 25, "J": 5}))
    back = path(("G90.1", {}), ("G91.1", {}), ("G0", {"X": 20, "Y": 5, "Z": 0}), ("G2", {"X": 30, "Y": 5, "I": 5}))
    assert np.allclose(relative.points, absolute.points) and np.allclose(relative.points, back.points)


@pytest.mark.parametrize("plane, centre, end, axes", [
    ("G17", {"I": 5}, {"X": 5, "Y": 5}, (0, 1)),
    ("G18", {"K": 5}, {"Z": 5, "X": 5}, (2, 0)),
    ("G19", {"J": 5}, {"Y": 5, "Z": 5}, (1, 2)),
])  # fmt: skip
def test_arcs_turn_clockwise_seen_along_the_plane_normal(plane, centre, end, axes):
    toolpath = path((plane, {}), START, ("G2", {**end, **centre}))
    first, second = axes
    assert toolpath.sweep.sum() == pytest.approx(-np.pi / 2)
    assert set(toolpath.plane.tolist()) == {int(plane[1:])}
    middle = toolpath.points[len(toolpath) // 2]
    assert middle[first] < middle[second]  # A clockwise quarter around (5, 0) begins along the second axis.
    assert toolpath.points[:, 3 - first - second].tolist() == [0] * (len(toolpath) + 1)


def test_helix_descends_evenly():
    toolpath = path(("G0", {"X": 10, "Y": 0, "Z": 0}), ("G3", {"X": 10, "Y": 0, "Z": -2, "I": -10, "J": 0}))
    assert np.allclose(np.diff(toolpath.points[:, 2]), -2 / len(toolpath))
    assert np.allclose(np.hypot(toolpath.points[:, 0], toolpath.points[:, 1]), 10)


def test_arc_with_a_radius_of_kilometres_is_a_line():
    huge = 5e8  # Rounding has moved the centre to the wrong side, so the arc would be nearly a full circle.
    toolpath = path(
        START,
        ("G2", {"X": 100, "Y": 0, "I": 50, "J": 9e5}),
        ("G3", {"X": 200, "Y": 0, "I": 50, "J": -9e5}),
        ("G3", {"X": 250, "Y": 1, "R": huge}),
    )
    assert ends(toolpath)[:2] == [[100, 0, 0], [200, 0, 0]]
    assert len(toolpath) == 3 and not toolpath.sweep.any()


def test_tiny_circles_have_eight_chords():
    toolpath = path(START, ("G2", {"X": 0, "Y": 0, "I": 1e-3}))
    assert len(toolpath) == 8


def test_arc_with_equal_end_points_is_a_full_circle():
    toolpath = path(("G0", {"X": 1, "Y": 2, "Z": 3}), ("G2", {"I": 4, "J": 0}))
    assert toolpath.sweep.sum() == pytest.approx(-2 * np.pi)
    assert toolpath.points[-1].tolist() == [1, 2, 3]


@pytest.mark.parametrize(("code", "sense"), [("G2", -1), ("G3", 1)])
@pytest.mark.parametrize(("x", "y"), [(2.4e-6, 0), (-2.4e-6, 0), (0.01, 0), (0, 0)])
def test_circle_with_rounded_end_is_a_full_circle(code, sense, x, y):
    toolpath = path(("G0", {"X": 1, "Y": 2, "Z": 3}), (code, {"X": 1 + x, "Y": 2 + y, "I": -1.5, "J": 0}))
    assert toolpath.sweep.sum() == pytest.approx(sense * 2 * np.pi)
    # The sweep is 0 if the end of the arc differs from its start only in the distance from the centre. An arc is short
    # if its end is slightly
    # ahead of its start, whether the program gives the centre or the radius.
    assert path(("G0", {"X": 1, "Y": 2, "Z": 3}), (code, {"X": 1.5, "Y": 2, "I": -1.5, "J": 0})).sweep.sum() == 0
    for more in ({"I": -1.5, "J": 0}, {"R": 1.5}):
        on = path(("G0", {"X": 1, "Y": 2, "Z": 3}), (code, {"X": 1, "Y": 2 + sense * 1e-3, **more}))
        assert abs(on.sweep.sum()) == pytest.approx(1e-3 / 1.5, rel=1e-3)


def test_drilling_cycle_returns_to_initial_height_or_r_plane():
    toolpath = path(
        ("G0", {"X": 0, "Y": 0, "Z": 10}),
        ("G98", {}),
        ("G81", {"X": 5, "Y": 5, "Z": -3, "R": 2, "F": 4}),
        ("G99", {}),
        ("G81", {"X": 6, "Y": 5}),
        ("G80", {}),
        ("G0", {"X": 0}),
    )
    assert ends(toolpath) == [
        [5, 5, 10],
        [5, 5, 2],
        [5, 5, -3],
        [5, 5, 10],
        [6, 5, 10],
        [6, 5, 2],
        [6, 5, -3],
        [6, 5, 2],
        [0, 5, 2],
    ]
    assert toolpath.rapid.tolist() == [True, True, False, True, True, True, False, True, True]
    assert toolpath.cycle.tolist() == [True] * 8 + [False]
    assert toolpath.feed[2] == 4


def test_cycle_below_its_retract_plane_rises_first():
    toolpath = path(START, ("G81", {"X": 5, "Y": 0, "Z": -3, "R": 2}), ("G1", {"X": 0}))
    assert ends(toolpath) == [[0, 0, 2], [5, 0, 2], [5, 0, -3], [5, 0, 2], [0, 0, 2]]


@pytest.mark.parametrize("name, deepest", [("G83", [-2, -4, -5]), ("G73", [-2, -4, -5])])
def test_pecks_of_drilling_cycles_reach_their_depths(name, deepest):
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 0}), (name, {"X": 0, "Y": 0, "Z": -5, "R": 0, "Q": 2}))
    feeds = toolpath.points[1:][~toolpath.rapid]
    assert feeds[:, 2].tolist() == deepest
    outs = toolpath.points[1:][toolpath.rapid][:, 2]
    assert outs[0] == (0 if name == "G83" else -1.746)


@pytest.mark.parametrize(("depth", "pecks"), [(4.0, 2), (4.1, 3), (2.0, 1), (0.5, 1), (0.9, 1)])
def test_last_peck_is_the_remaining_depth(depth, pecks):
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 3}), ("G83", {"X": 1, "Y": 2, "Z": -depth, "R": 0, "Q": 2}))
    feeds = toolpath.points[1:][~toolpath.rapid]
    assert feeds[:, 2].tolist() == [-2.0 * k for k in range(1, pecks)] + [-depth]
    assert (toolpath.points[1:, :2] == [1, 2]).all() and toolpath.points[-1, 2] == 3


def test_rounding_does_not_add_a_peck():
    """The floating-point quotient 1.1 / 0.1 is more than 11, so rounding could add an empty peck."""
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 3}), ("G83", {"X": 1, "Y": 2, "Z": -1.1, "R": 0, "Q": 0.1}))
    feeds = toolpath.points[1:][~toolpath.rapid]
    assert feeds[:, 2] == pytest.approx([-0.1 * k for k in range(1, 12)])
    at_retract = toolpath.points[1:][toolpath.rapid][:, 2] == 0
    # The tool is at the retract height once before the hole, and 10 times between the pecks.
    assert at_retract.sum() == 1 + 10


def test_hole_with_whole_pecks_ends_at_its_bottom():
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 3}), ("G83", {"X": 1, "Y": 2, "Z": -0.5, "R": 0, "Q": 0.25}))
    assert toolpath.points[1:][~toolpath.rapid][:, 2].tolist() == [-0.25, -0.5]


@pytest.mark.parametrize("peck", [0.0, -1.0, 1e-5])
def test_hole_with_unusable_peck_depth_has_one_peck(peck):
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 3}), ("G83", {"X": 0, "Y": 0, "Z": -4, "R": 0, "Q": peck}))
    assert toolpath.points[1:][~toolpath.rapid][:, 2].tolist() == [-4]


def test_cycle_returns_to_its_start_height_or_r_plane():
    begin = ("G0", {"X": 0, "Y": 0, "Z": 5})
    for mode, height in (("G98", 5), ("G99", 1)):
        toolpath = path(begin, (mode, {}), ("G81", {"X": 1, "Z": -2, "R": 1}), ("G0", {"X": 9}))
        assert toolpath.points[-1].tolist() == [9, 0, height] and toolpath.points[-2].tolist() == [1, 0, height]
    again = path(begin, ("G99", {}), ("G98", {}), ("G81", {"X": 1, "Z": -2, "R": 1}))
    assert again.points[-1, 2] == 5
    from_below = path(("G0", {"X": 0, "Y": 0, "Z": 0.5}), ("G98", {}), ("G81", {"X": 1, "Z": -2, "R": 1}))
    assert from_below.points[-1, 2] == 1  # The R plane is higher than the start.
    no_height = path(("G81", {"X": 1, "Y": 0, "Z": -2, "R": 1}))
    assert no_height.points[:, 2].max() == 1 and no_height.points[:, 2].min() == -2


@pytest.mark.parametrize("name", ["G74", "G81", "G82", "G84", "G85", "G86", "G88", "G89"])
def test_other_canned_cycles_reach_their_depth_once(name):
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 5}), (name, {"X": 1, "Y": 0, "Z": -5, "R": 1, "P": 0.5}))
    (deepest,) = np.flatnonzero(toolpath.points[:, 2] == -5)
    assert toolpath.rapid[deepest] == (name in ("G81", "G82", "G86"))
    assert toolpath.rapid[-1] == (name in ("G81", "G82", "G85", "G86"))
    assert toolpath.points[-1, 2] == 5
    assert toolpath.dwells.tolist() == [[1, 0.5]] and not toolpath.problems


@pytest.mark.parametrize("code", ["G84", "G74"])
@pytest.mark.parametrize(
    "words, feed",
    [
        ({"F": 0.8, "S": 500}, 0.8 * 500 / 60),  # F is the pitch of the thread, as FreeCAD 1.1 writes F.
        ({"F": 400, "S": 500}, 400),  # F is the feed in mm/min, as in imported programs.
        ({"F": 6.5}, 6.5),
        ({"F": 0.8, "S": 0}, 0.8),
    ],
)
def test_tap_feed_is_pitch_times_speed(code, words, feed):
    tapped = linearize([("G0", {"X": 10, "Y": 5, "Z": 10}), (code, {"X": 10, "Y": 5, "Z": 0, "R": 4, **words})])
    # One feed move goes into the hole, the other goes out.
    assert tapped.feed[~tapped.rapid] == pytest.approx([feed, feed])


@pytest.mark.parametrize("feed", [-3.0, 0.0, 1e-7, float("nan"), float("inf")])
def test_unusable_feed_is_ignored(feed):
    toolpath = path(START, ("G1", {"X": 1, "F": 5}), ("G1", {"X": 2, "F": feed}))
    assert toolpath.feed[-2:].tolist() == [5, 5]
    told = [(problem.command, problem.what.code) for problem in toolpath.problems]
    assert told == ([] if feed == 0.0 else [(2, "unusable-feed")])


def test_modal_and_relative_cycle_lines_drill_holes():
    modal = path(("G0", {"X": 0, "Y": 0, "Z": 5}), ("G81", {"X": 1, "Z": -1, "R": 1}), ("", {"X": 2}), ("", {"X": 3}))
    assert (modal.points[:, 2] == -1).sum() == 3
    relative = path(
        ("G0", {"X": 0, "Y": 0, "Z": 5}), ("G91", {}), ("G81", {"X": 1, "Z": -3, "R": -4}), ("G81", {"X": 1})
    )
    assert relative.points[relative.points[:, 2] == -2, 0].tolist() == [1, 2]


def test_comments_and_tool_changes_are_stored_with_their_move():
    toolpath = path(("(first)", {}), START, ("G1", {"X": 1}), ("(second)", {}), ("M6", {"T": 2}), ("G1", {"X": 2}))
    assert toolpath.comments == ((0, "first"), (1, "second"))
    assert toolpath.tool_changes.tolist() == [1]
    assert toolpath.commands == 6 and not toolpath.problems


def messages(toolpath):
    return [str(problem) for problem in toolpath.problems]


def test_words_with_unusable_numbers_are_named_and_skipped():
    toolpath = path(
        START,
        ("G1", {"X": float("nan"), "Y": 3}),
        ("G1", {"X": float("inf")}),
        ("G1", {"X": "ten"}),
        ("G1", {"X": 1e308}),
        ("G1", {"X": None, "Y": 4}),
    )
    assert ends(toolpath) == [[0, 3, 0], [0, 4, 0]]
    assert messages(toolpath) == ["Command 2 (first of 5): X words that are not usable numbers are ignored."]


@pytest.mark.parametrize("before", [[], [("G81", {"X": 1, "Y": 0, "Z": -2, "R": 1, "F": 1}), ("G80", {})]])
def test_axis_words_without_a_motion_code_move_nothing(before):
    toolpath = path(*before, ("", {"X": 50}))
    assert [problem.what.code for problem in toolpath.problems] == ["words-without-motion"]
    assert 50 not in toolpath.points[:, 0]


def test_unknown_codes_have_a_remark():
    toolpath = path(START, ("G999", {}), ("Ж7", {}), ("G1", {"X": 1}), ("M3", {"S": 1000}), ("G54", {}))
    assert messages(toolpath) == [
        "Command 2: The unknown code 'G999' is ignored.",
        "Command 3: The unknown code 'Ж7' is ignored.",
    ]


@pytest.mark.parametrize("arc, message", [
    ({"X": 1, "Y": 1}, "An arc without a usable center or radius is read as a line."),
    ({"X": 10, "Y": 0, "R": 1}, "An arc without a usable center or radius is read as a line."),
    ({"X": 10, "Y": 0, "I": 2, "J": 0}, "An arc that does not end on its circle is read with a changing radius."),
    ({"X": 20, "Y": 0, "I": -5, "J": 0}, "An arc that does not end on its circle is read with a changing radius."),
])  # fmt: skip
def test_impossible_arcs_end_at_their_target(arc, message):
    toolpath = path(START, ("G2", arc))
    assert toolpath.points[-1, :2].tolist() == [arc["X"], arc["Y"]]
    assert toolpath.problems[0].message == message


def test_arc_with_an_unknown_start_has_a_remark_and_no_chords():
    toolpath = path(("G2", {"X": 1, "Y": 1, "I": 1}), ("G1", {"X": 5}))
    assert messages(toolpath) == ["Command 1: An arc with an unknown start is ignored."]
    assert toolpath.points.tolist() == [[1, 1, 0], [5, 1, 0]]


def test_commands_without_moves_have_no_trajectories():
    for commands in ([], [("(empty)", {})], [("G0", {})], [("M30", {})]):
        toolpath = linearize(commands)
        assert len(toolpath) == 0 and toolpath.feed.shape == (0,)


@pytest.mark.parametrize("tolerance", [0, -1, float("nan"), float("inf")])
def test_tolerance_must_be_positive(tolerance):
    with pytest.raises(ValueError, match="tolerance"):
        linearize([], tolerance=tolerance)


def test_tolerance_that_needs_too_many_chords_is_refused():
    circles = [("G0", {"X": 0, "Y": 0, "Z": 0})] + [("G2", {"I": 9000.0, "J": 0.0})] * 5000
    with pytest.raises(ValueError, match="larger tolerance"):
        linearize(circles, tolerance=1e-4)


def test_arc_needs_a_known_start_in_both_axes_of_its_plane():
    half = ("G2", {"X": 10.0, "Y": 0.0, "I": 5.0, "J": 0.0})
    told = [problem.what.code for problem in path(("G1", {"X": 0.0}), half).problems]
    assert told == ["arc-before-start"]
    assert not path(("G1", {"X": 0.0, "Y": 0.0}), half).problems  # An arc in the XY plane does not need a known height.


def test_arc_with_centre_and_radius_uses_the_centre():
    centre = {"X": 10.0, "Y": 0.0, "I": 5.0, "J": 0.0}
    assert np.array_equal(path(START, ("G2", {**centre, "R": 8.0})).points, path(START, ("G2", centre)).points)


def test_too_short_radius_makes_a_line():
    assert len(path(START, ("G2", {"X": 4.0, "Y": 0.0, "R": 1.9991}))) > 1
    short = path(START, ("G2", {"X": 4.0, "Y": 0.0, "R": 1.9985}))
    assert len(short) == 1
    assert [problem.what.code for problem in short.problems] == ["arc-as-line"]


def test_arc_with_its_centre_at_its_start_is_a_line():
    around = path(START, ("G2", {"X": 4.0, "Y": 0.0, "I": 0.0, "J": 0.0}))
    assert len(around) == 1 and [problem.what.code for problem in around.problems] == ["arc-as-line"]


def test_arc_centres_in_commands_are_always_offsets():
    """Arc centres can be coordinates only in program files. FreeCAD's import converts all centres to offsets."""
    arc = ("G2", {"X": 110.0, "Y": 100.0, "I": 105.0, "J": 100.0})
    assert [p.what.code for p in path(("G0", {"X": 100, "Y": 100, "Z": 1}), arc).problems] == ["arc-of-changing-radius"]


@pytest.mark.parametrize(
    "radius, grows, told", [(5, 0.09, False), (5, 0.12, True), (20, 0.19, False), (20, 0.22, True), (50, 0.6, True)]
)
def test_radius_of_an_arc_may_change_slightly_along_the_arc(radius, grows, told):
    quarter = ("G3", {"X": 0, "Y": radius + grows, "I": -radius, "J": 0})
    found = path(("G0", {"X": radius, "Y": 0, "Z": 1}), quarter).problems
    assert [problem.what.code for problem in found] == ["arc-of-changing-radius"] * told


def test_hole_without_a_known_start_height_begins_at_0():
    assert path(("G81", {"X": 5, "Y": 5, "Z": -2.0})).points[:, 2].tolist() == [0, -2, 0]


def test_allowed_radius_error_of_an_arc_grows_with_its_chord():
    toolpath = path(("G0", {"X": 0, "Y": 0, "Z": 0}), ("G2", {"X": 200, "R": 99.99}))
    assert toolpath.sweep.sum() == pytest.approx(-np.pi) and toolpath.problems == ()


def test_arc_radius_changes_evenly_to_the_end():
    spiral = path(START, ("G3", {"X": 9.0, "Y": 0.0, "I": 5.0, "J": 0.0}), tolerance=1e-5).points
    below = spiral[spiral[:, 1] < -1]  # In the spiral's lower half turn, the radius changes from 5 to 4 mm.
    middle = below[np.argmin(np.abs(below[:, 0] - 5))]
    assert np.hypot(middle[0] - 5, middle[1]) == pytest.approx(4.5, abs=0.002)


@pytest.mark.parametrize(
    "commands",
    [
        None,
        5,
        "G1 X5",
        ["G1 X5"],
        [None],
        [5],
        [("G1", "X5")],
        [("G1", [5])],
        [({"X": 5}, "G1")],
        [(None, {"X": 5})],
        {"G1": {}},
    ],
)
def test_invalid_command_raises_a_clear_error(commands):
    with pytest.raises(
        TypeError, match=r"commands are \(name, parameters\) pairs, or objects with Name and Parameters"
    ):
        linearize(commands)


@pytest.mark.parametrize(
    "commands",
    [
        [("G53", {}), ("G0", {"Z": -3})],
        [("G53", {}), ("G1", {"Z": -3, "F": 1})],
        [("G0", {}), ("G53", {"Z": -3})],
        [("G28", {"Z": 0})],
        [("G91", {}), ("G28", {"Z": 0}), ("G90", {})],
        [("G28", {}), ("G91", {"Z": 0}), ("G90", {})],
    ],
)
def test_machine_height_is_at_least_the_highest_move(commands):
    """FreeCAD splits a G53 line into two commands.

    The second command is not a move to Z-3 in the part's coordinates.
    """
    begin = [("G0", {"X": 0, "Y": 0, "Z": 5}), ("G1", {"Z": -5, "F": 1}), ("G1", {"X": 50})]
    path = linearize([*begin, *commands, ("G0", {"X": 0, "Y": 40}), ("G1", {"Z": -5})])
    assert path.points[2:].tolist() == [[50, 0, -5], [50, 0, 5], [0, 40, 5], [0, 40, -5]]
    assert path.rapid.tolist() == [False, False, True, True, False] and not path.problems


def test_machine_position_in_x_and_y_is_ignored_with_a_remark():
    begin = [("G0", {"X": 0, "Y": 0, "Z": 5}), ("G1", {"Z": -5, "F": 1})]
    for away in ([("G53", {}), ("G0", {"X": 7, "Y": 9})], [("G28", {"X": 0})], [("G53", {}), ("G53", {"Y": 3})]):
        path = linearize([*begin, *away])
        assert path.points.tolist() == [[0, 0, 5], [0, 0, -5]] and not path.problems
        assert not linearize(away).problems  # A program whose only moves are to machine positions has no remark.
        path = linearize([*begin, *away, ("G1", {"X": 4})])
        assert path.points[1:].tolist() == [[0, 0, -5], [4, 0, -5]]
        assert [problem.what.code for problem in path.problems] == ["machine-position"]


def test_machine_height_is_computed_after_relative_moves():
    path = linearize(
        [("G0", {"X": 0, "Y": 0, "Z": 5}), ("G91", {}), ("G1", {"Z": -6, "F": 1}), ("G28", {"Z": 0}), ("G1", {"X": 9})]
    )
    assert path.points.tolist() == [[0, 0, 5], [0, 0, -1], [0, 0, 5], [9, 0, 5]]
