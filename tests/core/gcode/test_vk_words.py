# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands are converted to columns of numbers in batches, which need little more memory than the columns."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import programs
import pytest
from counting import memory

from vkworkbench.core.gcode import Words, linearize, used_up
from vkworkbench.core.gcode.moves import words


class Command:
    """A command that creates its name and parameters anew at each access, like a command of FreeCAD."""

    @property
    def Name(self):
        return "G1"

    @property
    def Parameters(self):
        return {"X": 1.0, "Y": 2.0, "F": 3.0}


@pytest.fixture
def many(monkeypatch):
    """Return the number of commands, and reduce the batch size to an eighth of this number.

    With small batches, a test with few commands shows whether the memory grows with the number of commands.
    """
    monkeypatch.setattr(words, "_PIECE", 1_500)
    return 12_000


def test_many_commands_need_little_memory(many):
    commands = [Command()] * many
    read, _, peak = memory(lambda: Words(commands))
    assert len(read) == len(commands) and (read.column("Y")[0] == 2).all()
    # The limit is lower than a dictionary of three numbers (256 bytes) plus a name (50 bytes) per command.
    assert peak < 150 * len(commands), f"{peak / len(commands):.0f} bytes a command"


class Keeping:
    """A command that keeps its parameters in memory after the first access, like a command of FreeCAD."""

    Name = "G1"

    @cached_property
    def Parameters(self):
        return {"X": 1.0, "Y": 2.0, "F": 3.0}


def test_commands_that_were_converted_free_their_memory(many):
    commands = [Keeping() for _ in range(many)]
    count = len(commands)
    read, _, peak = memory(lambda: Words(used_up(commands)))
    assert commands == [] and len(read) == count and (read.column("Y")[0] == 2).all()
    assert peak < 200 * count, f"{peak / count:.0f} bytes a command"


@pytest.mark.parametrize("piece", [1, 3, 7])
def test_reading_in_batches_equals_reading_at_once(piece, monkeypatch):
    commands = [c for make in programs.SOUND.values() for c in make()[:40]]
    commands += [
        ("X10", {"Y": 1.0}),
        ("N10", {"G": 2.0, "X": 3.0}),
        ("G1", None),
        ("G1", {"X": "7", "Ab": 2}),
        ("", {}),
    ]
    whole = Words(commands)
    monkeypatch.setattr(words, "_PIECE", piece)
    pieces = Words(commands)
    assert pieces.names == whole.names and pieces.letters == whole.letters
    assert np.array_equal(pieces.codes, whole.codes)
    for letter in whole.letters:
        for one, other in zip(pieces.column(letter), whole.column(letter)):
            np.testing.assert_array_equal(one, other)  # Two NaN values count as equal.


BEFORE_CODES = [("G0", {"Z": 25}), ("G0", {"X": 15, "Y": 20}), ("G1", {"Z": 18, "F": 2})]


@pytest.mark.parametrize(("commands", "length"), [
    ([("G17", {"G": 2, "X": 15, "Y": 20, "I": 10, "J": 0, "F": 10})], 62.832), ([("G90", {"G": 1, "X": 45})], 30),
    ([("G91", {"G": 1, "X": 20}), ("G90", {})], 20), ([("G18", {"G": 3, "X": 5, "Z": 8, "I": -10, "K": 0})], 15.708),
    ([("M3", {"S": 1000, "G": 1, "X": 45})], 30), ([("G1", {"G": 90, "X": 45})], 30),
    ([("G98", {"G": 81, "X": 40, "Y": 10, "Z": 5, "R": 22}), ("G80", {})], 17),
    ([("G1", {"X": 45}), ("G54", {"G": 1, "X": 15})], 60), ([("G17", {"G": 90, "X": 45})], 30),
])  # fmt: skip
def test_commands_with_two_codes_are_read_with_both(commands, length):
    path = linearize([*BEFORE_CODES, *commands, ("G0", {"Z": 25})], tolerance=1e-5)
    cut = np.linalg.norm(np.diff(path.points, axis=0), axis=1)[~path.rapid].sum() - 7
    assert cut == pytest.approx(length, abs=1e-3)
    assert [problem.what.code for problem in path.problems] == ["two-codes"]


def test_words_beside_a_modal_code_continue_the_motion():
    path = linearize([*BEFORE_CODES, ("G90", {"X": 45})])
    assert path.points[-1].tolist() == [45, 20, 18] and not path.rapid[-1] and not path.problems


def test_modal_code_beside_g28_stays_in_force():
    path = linearize([*BEFORE_CODES, ("G28", {"G": 91, "Z": 0}), ("G1", {"X": 1})])
    assert path.points[-1].tolist() == [16, 20, 25]


def test_unknown_second_code_has_a_remark():
    path = linearize([*BEFORE_CODES, ("G90", {"G": 777, "X": 45})])
    assert [problem.what.code for problem in path.problems] == ["two-codes", "unknown-code"]


@pytest.mark.parametrize(
    ("name", "words", "code"),
    [
        ("G20", {"G": 1, "X": 3}, "inches-not-read"), ("G41", {"D": 1, "X": 5}, "compensation-not-read"),
        ("G93", {"G": 1, "X": 5, "F": 2}, "feed-mode-not-read"), ("G4", {"G": 1, "X": 5}, None), ("G80", {"X": 3}, "word-not-read"),
    ],
)  # fmt: skip
def test_ignored_code_has_a_remark_beside_a_second_code(name, words, code):
    """The second code or the axis words move the tool; the first code is still ignored."""
    path = linearize([("G1", {"X": 0, "Y": 0, "Z": 0, "F": 1}), (name, words)])
    assert [problem.what.code for problem in path.problems if problem.what.code != "two-codes"] == [code] * (
        code is not None
    )
    assert len(path.dwells) == (name == "G4")
