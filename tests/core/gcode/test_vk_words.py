# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands are converted to columns in chunks, so that the conversion needs little more memory than the columns."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import programs
import pytest
from counting import memory

from vkworkbench.core.gcode import Words, used_up
from vkworkbench.core.gcode.moves import words


class Command:
    """A command like FreeCAD's, which creates its name and parameters anew at each access."""

    @property
    def Name(self):
        return "G1"

    @property
    def Parameters(self):
        return {"X": 1.0, "Y": 2.0, "F": 3.0}


@pytest.fixture
def many(monkeypatch):
    """Return the number of commands, and reduce the chunk size to an eighth of it.

    With small chunks, few commands suffice to see that the memory depends on the chunk and not on the whole.
    """
    monkeypatch.setattr(words, "_PIECE", 1_500)
    return 12_000


def test_very_many_commands_take_little_memory(many):
    commands = [Command()] * many
    read, _, peak = memory(lambda: Words(commands))
    assert len(read) == len(commands) and (read.column("Y")[0] == 2).all()
    # A dictionary of three numbers takes 256 bytes, and a name 50.
    assert peak < 150 * len(commands), f"{peak / len(commands):.0f} bytes a command"


class Keeping:
    """A command like FreeCAD's that keeps its parameters after the first access."""

    Name = "G1"

    @cached_property
    def Parameters(self):
        return {"X": 1.0, "Y": 2.0, "F": 3.0}


def test_commands_that_are_used_up_go_with_what_they_keep(many):
    commands = [Keeping() for _ in range(many)]
    count = len(commands)
    read, _, peak = memory(lambda: Words(used_up(commands)))
    assert commands == [] and len(read) == count and (read.column("Y")[0] == 2).all()
    assert peak < 200 * count, f"{peak / count:.0f} bytes a command"


@pytest.mark.parametrize("piece", [1, 3, 7])
def test_pieces_read_what_the_whole_reads(piece, monkeypatch):
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
            assert np.array_equal(one, other, equal_nan=one.dtype == float)
