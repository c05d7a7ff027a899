# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of a program's commands, compared with a list of (name, parameters), and the memory of a long program."""

from __future__ import annotations

from counting import memory

from vkworkbench.core.gcode import read_program
from vkworkbench.core.gcode.moves.commands import Commands

PAIRS = [
    ("G1", {"X": 1.5, "Y": -2.0, "F": 10.0}),
    ("", {"X": 2.0}),
    ("T5", {}),
    ("M6", {"T": 5}),
    ("G1", {"Y": 3.0, "X": 1.5}),
]


def commands(pairs):
    made = Commands()
    for pair in pairs:
        made.append(pair)
    return made


def test_commands_return_the_appended_names_and_parameters():
    made = commands(PAIRS)
    assert list(made) == PAIRS and len(made) == 5 and made[4] == PAIRS[4]
    assert made.names == ["G1", "", "T5", "M6", "G1"]
    assert list(made[4][1]) == ["Y", "X"]  # The parameters of the command keep their order.


def test_replacing_a_command_does_not_change_other_commands():
    made, pairs = commands(PAIRS), list(PAIRS)
    for at, other in [(2, ("M6", {"T": 7.0})), (0, ("G94", {})), (3, ("G94", {})), (0, ("G0", {"X": 1.0, "Z": 2.0}))]:
        made[at] = pairs[at] = other
        assert list(made) == pairs and len(made) == 5


def test_long_program_needs_few_bytes_per_command():
    """A tuple with a dictionary would need 500 bytes for each line of the program."""
    read_program("G1 X1 F100")  # The first call compiles regular expressions.
    text = "".join(f"G1 X{x / 1000:.3f} Y{x / 700:.3f} Z-{x / 900:.3f} F1200\n" for x in range(4_000))
    program, taken, _ = memory(lambda: read_program(text))
    assert program.commands[7] == ("G1", {"X": 0.007, "Y": 0.01, "Z": -0.008, "F": 20.0})
    assert taken < 80 * len(program.commands)
