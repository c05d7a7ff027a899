# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines with plain moves are read many at a time, into columns, and give the same commands as line by line."""

import random

import numpy as np
import pytest

from vkworkbench.core.gcode import plain_lines, read_program
from vkworkbench.language import Unusable

OTHER_LINES = (
    "G20", "G21", "G90", "G91", "G90.1", "G91.1", "G17", "G18", "G93", "G94", "G95", "G98", "G99", "G80", "S900 M3", "M6 T2", "T3", "M5",
    "(Pocket)", "; remark", "M30", "M0", "G4 P1", "G43 H1", "G49", "G55", "G54", "G92 X0 Y0", "G92.1", "G52 X5", "G28", "G28 X0 Z0", "G53 G0 Z0",
    "G81 X1 Y2 Z-3 R1 F90", "G83 Z-5 R1 Q1 L0", "X5 Y5", "G2 X1 Z1 K1", "G3 X2 Z2 R5", "G1 X1 X2", "G0 G1 X3", "G1 Y2 P3", "G1 A90 X4",
    "/G1 X7", "G1 X1E1", "G1 X+5", "G1 X", "G1 X.", "G1 X1.2.3", "G1 X1234567890123456", "G1 X0.12345678901234567", "N10", "N10 G1", "G1 F50",
    "F60", "F0", "F1.5", "G1X1Y2", "g1 x1 y2", "G1  X 5", "\tG1\tX6", "G01 X-.5", "G1.0 X3", "G1.5 X3", "G5 X1 Y1", "X1 é", "X1,5", "X#1", "#1=5",
    "X[1+2]", "M98 P5", "M98 P7 L2", "O5", "M99", "G33 Z-3 K1", "M70", "M72", "U1", "E5 X1", "G1 X1 * 35", "%", "", "  ", "$H", "M117 X1",
    "F5 X1 Y1", "X1 F5 Y1 F6", "G0 Z5 M8", "G31 Z-1", "G2 X5 Y5 I2 J0 P2", "G1 @5 ^30", "G10 L20 P1 X0", "G1 R5", "G2 I5", "X-0", "Y-0.000", "G68 X0 Y0 R30", "G69", "G51 X0 Y0 P2000",
    "G50", "G51.1 X5", "G50.1", "G41 D1", "(T2 D=6 end mill)", "G42", "G40", "G10 L2 P1 R20", "G10 L2 P2 X5", "M1", "G86 Z-3 R1 P2", "G54.1 P2",
    "G5 X9 Y9 I1 J1 P1 Q1", "G12 I5 F50", "G38.2 Z-2 F20", "G73 X1 Z-2 R1 Q0.5", "G64 P0.1", "G16", "G15", "G96", "G70 I5 J0 L3",
)  # fmt: skip


def random_line(random_numbers):
    words = [f"{letter}{number(random_numbers)}" for letter in "XYZIJKR" if random_numbers.random() < 0.35]
    if random_numbers.random() < 0.2:
        words.append(f"F{random_numbers.randint(1, 2000)}")
    if random_numbers.random() < 0.1:
        random_numbers.shuffle(words)
    if random_numbers.random() < 0.5:
        words.insert(0, random_numbers.choice(["G0", "G1", "G01", "G2", "G03", "g1"]))
    if random_numbers.random() < 0.3:
        words.insert(0, f"N{random_numbers.randint(1, 99999)}")
    return random_numbers.choice([" ", " ", "", "  "]).join(words)


def number(random_numbers):
    if random_numbers.random() < 0.2:
        return str(random_numbers.randint(-3, 3))
    return f"{random_numbers.uniform(-200, 200):.{random_numbers.randint(0, 9)}f}"


def random_program(seed):
    random_numbers = random.Random(seed)
    lines = [random_numbers.choice(["G21 G90", "G20", "G91", "%", "G71 X1 CR=5"]), "T1 M6", "G0 X0 Y0 Z5"]
    others = random_numbers.choice([0.0, 0.02, 0.1, 0.3])
    for _ in range(random_numbers.randint(1, 60)):
        other = random_numbers.random() < others
        lines.append(random_numbers.choice(OTHER_LINES) if other else random_line(random_numbers))
    return "\n".join([*lines, random_numbers.choice(["M30", "", "M30\nO5\nG1 X9 Y9\nX8\nM99\nO7\nG1 Z-1\nM99"])])


def everything(text):
    """Return everything that is read from a program, or the reason why the program is refused."""
    try:
        program = read_program(text)
    except Unusable as refused:
        return str(refused)
    problems = [(one.what, one.command, one.count, np.asarray(one.commands).tolist()) for one in program.problems]
    return repr((
        list(program.commands), program.lines.tolist(), program.comments, program.in_calls, program.inverse_time,
        program.inches, program.unit_told, program.other, program.rotary, problems,
    ))  # fmt: skip


def line_by_line(text, monkeypatch):
    with monkeypatch.context() as patched:
        patched.setattr(plain_lines.PlainLines, "read", lambda _self, _machine, index, _end: (index, 0))
        return everything(text)


@pytest.mark.long
@pytest.mark.parametrize("first", range(0, 600, 100))
def test_random_programs_equal_reading_line_by_line(first, monkeypatch):
    for seed in range(first, first + 100):
        text = random_program(seed)
        assert everything(text) == line_by_line(text, monkeypatch), seed


@pytest.mark.long
def test_programs_in_several_batches_equal_line_by_line(monkeypatch):
    monkeypatch.setattr(plain_lines, "_LINES", 7)
    monkeypatch.setattr(plain_lines, "_CHARACTERS", 90)
    for seed in range(150):
        text = random_program(seed)
        assert everything(text) == line_by_line(text, monkeypatch), seed


@pytest.mark.parametrize("line", OTHER_LINES)
def test_line_between_plain_lines_is_read_as_if_read_alone(line, monkeypatch):
    run = [f"G1 X{k} Y{k * k}\nX{k + 0.5} F{k}" for k in range(1, 9)]
    text = "\n".join(["G0 X0 Y0 Z5", *run, line, *run, line, "G1 Z-1", *run])
    assert everything(text) == line_by_line(text, monkeypatch)


def test_numbers_in_plain_lines_equal_python_floats(monkeypatch):
    random_numbers = random.Random(5)
    texts = ["".join(random_numbers.choices("0123456789", k=random_numbers.randint(1, 17))) for _ in range(5000)]
    texts = [f"{text[:place]}.{text[place:]}" for text in texts for place in [random_numbers.randint(0, len(text))]]
    program = read_program("G0 X1 Y0 Z0\n" + "".join(f"X-{text}\n" for text in texts))
    read = [-words["X"] for _, words in program.commands if "X" in words][1:]
    assert read == [float(text) for text in texts]


def test_plain_lines_are_read_without_the_interpreter(monkeypatch):
    """The interpreter reads only the lines before and after the plain lines."""
    lines = []
    block = plain_lines.Interpreter.block

    def note(machine, number, *words, **given):
        lines.append(number)
        return block(machine, number, *words, **given)

    monkeypatch.setattr(plain_lines.Interpreter, "block", note)
    run = "".join(f"N{k} G1 X{k} Y{k % 7}\nX{k + 0.25} Z-1\n\n" for k in range(1, 50))
    program = read_program(f"G21 G90\nG0 X0 Y0 Z5\n{run}M5\n{run}M30\n")
    assert lines == [1, 2, 150, 298] and len(program.commands) == 2 + 4 * 49
