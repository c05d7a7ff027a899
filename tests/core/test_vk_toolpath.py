# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath, the parts into which it is cut, and the problems found while it was read."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import (
    Stock,
    Tool,
    Toolpath,
    View,
    estimate,
    linearize,
    machining,
    recognize,
    simulate,
    simulate_job,
)
from vkworkbench.core.toolpath import Problem
from vkworkbench.language import Message

COMMANDS = [
    ("(begin)", {}), ("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), ("G1", {"X": 3.0, "Y": 4.0, "F": 5.0}), ("M6", {"T": 1.0}),
    ("G1", {"X": 3.0, "Y": 4.0, "Z": 12.0}), ("(middle)", {}), ("G0", {"X": 0.0, "Y": 0.0}), ("M6", {"T": 2.0}),
    ("(end)", {}), ("G1", {"X": 8.0, "Y": 6.0}), ("G999", {}),
]  # fmt: skip


def test_toolpath_has_the_lengths_of_its_moves():
    path = linearize(COMMANDS)
    assert len(path) == 4 and path.lengths == pytest.approx([5, 12, 5, 10])
    assert len(linearize([])) == 0 and linearize([]).lengths.shape == (0,)


def test_toolpath_made_of_points_has_no_commands():
    path = linearize(COMMANDS)
    alone = Toolpath(path.points, path.rapid, path.command, path.feed, path.sweep, path.plane, path.cycle)
    assert (alone.commands, len(alone.tool_changes), alone.comments, alone.problems) == (0, 0, (), ())


def test_part_of_a_toolpath_keeps_inner_tool_changes():
    path = linearize(COMMANDS)
    assert path.tool_changes.tolist() == [1, 3] and [at for at, _ in path.comments] == [0, 2, 3]
    part = path.part(1, 4)
    assert len(part) == 3 and part.lengths == pytest.approx([12, 5, 10])
    for name in ("rapid", "command", "feed", "sweep", "plane", "cycle"):
        assert getattr(part, name).tolist() == getattr(path, name)[1:].tolist(), name
    assert part.tool_changes.tolist() == [
        2
    ]  # a change of tools before the part's first move does not belong to the part
    assert [at for at, _ in part.comments] == [1, 2]
    assert part.commands == path.commands == len(COMMANDS) and path.problems and part.problems == ()
    middle = path.part(1, 3)
    assert middle.tool_changes.tolist() == [] and [at for at, _ in middle.comments] == [1]
    assert np.array_equal(middle.points, path.points[1:4])


def test_problem_names_its_first_command_and_its_count():
    (problem,) = linearize([*COMMANDS, ("G999", {})]).problems
    assert problem == Problem(10, problem.what, 2) and not problem.of_time
    assert problem.message == "The unknown code 'G999' is ignored."
    assert problem.remark == Message("in-commands", sentence=problem.what, count=2, command=11)
    # The text numbers commands from 1.
    assert str(problem) == "Command 11 (first of 2): The unknown code 'G999' is ignored."
    assert str(Problem(4, problem.what)) == "Command 5: The unknown code 'G999' is ignored."
    assert not problem.takes_time


def test_problem_that_hides_cuts_is_divided_by_operations():
    problem = Problem.at([3, 9], Message("jumps-not-followed"))
    assert problem.hides_cuts and not problem.takes_time
    assert problem.within(5, 20) == Problem(9, problem.what) and problem.within(4, 9) is None
    assert not Problem(3, Message("word-not-read", letter="U")).hides_cuts


def test_toolpath_argument_of_wrong_type_has_a_clear_error():
    commands, tool = [("G1", {"X": 0.0}), ("G1", {"X": 5.0})], Tool("endmill", 6)
    stock, view = Stock((0, 0, 0), (9, 9, 9)), View(width=8, height=6)
    for use in (
        recognize,
        machining,
        lambda given: simulate(given, tool=tool, stock=stock, view=view),
        lambda given: estimate(given, None, tool=tool, stock=stock, view=view),
    ):
        with pytest.raises(TypeError, match="a toolpath is the Toolpath that linearize makes of commands, not list"):
            use(commands)
    path = linearize(commands)
    with pytest.raises(TypeError, match=r"a tool is a Tool\(shape, diameter, ...\), not int"):
        simulate(path, tool=6, stock=stock, view=view)
    with pytest.raises(TypeError, match=r"each of a job is a Cut\(toolpath, tool\), not tuple"):
        simulate_job([(path, tool)], stock=stock, view=view)


def test_unread_dwell_affects_time_and_rotary_axis_also_length():
    dwell, turned = Problem(4, Message("dwell-untimed")), Problem(4, Message("rotary-not-read", letter="A"))
    assert dwell.of_time and dwell.takes_time
    assert turned.takes_time and not turned.of_time


def test_toolpath_through_points_equals_that_of_commands():
    points = [(0.0, 0.0, 5.0), (10.0, 0.0, 5.0), (10.0, 8.0, 4.0)]
    commands = [("G1", {**dict(zip("XYZ", point)), "F": 10.0}) for point in points]
    made, read = Toolpath.through(points), linearize(commands)
    for name in ("points", "rapid", "feed", "sweep", "plane", "cycle"):
        ours, theirs = getattr(made, name), getattr(read, name)
        assert np.array_equal(ours, theirs) and ours.dtype == theirs.dtype
    assert made.command.tolist() == [0, 1] and made.commands == 2
    assert len(Toolpath.through([])) == len(Toolpath.through([(1, 2, 3)])) == 0


def test_problem_with_times_is_limited_to_a_range_of_commands():
    """For a range of commands, a problem with times keeps only its commands in the range.

    Other problems keep all their commands.
    """
    dwells = Problem.at([4, 6, 9], Message("dwell-untimed"))
    assert dwells == Problem(4, dwells.what, 3) and hash(dwells) == hash(Problem(4, dwells.what, 3))
    assert "commands" not in repr(dwells)
    assert dwells.within(5, 10) == Problem(6, dwells.what, 2) and dwells.within(4, 6) == Problem(4, dwells.what)
    assert dwells.within(5, 10).commands.tolist() == [6, 9] and dwells.within(5, 6) is None
    unknown = Problem.at([4, 6], Message("no-moves"))
    assert unknown.within(4, 5) == unknown and unknown.within(5, 7) is None and not len(unknown.commands)
