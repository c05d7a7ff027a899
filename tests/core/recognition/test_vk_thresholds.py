# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thresholds have one home: each has a unit and a reason there and is used, and no other file has numbers of its own."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parents[3] / "vkworkbench/core"
HOMES = [CORE / room / "thresholds.py" for room in ("paper", "recognition")]
DECLARED = [
    (home, subject.name, line.targets[0].id, line)
    for home in HOMES
    for subject in ast.parse(home.read_text(encoding="utf-8")).body
    if isinstance(subject, ast.ClassDef)
    for line in subject.body
    if isinstance(line, ast.Assign)
]
UNITS = [
    "angle",
    "bites",
    "borders",
    "confidence",
    "cosine",
    "count",
    "depths",
    "directions",
    "hypotenuse",
    "isoperimetric",
    "lines",
    "mm",
    "moves",
    "of",
    "pitches",
    "places",
    "rad",
    "ratio",
    "relative",
    "repetitions",
    "rings",
    "rows",
    "share",
    "slope",
    "steps",
    "support",
    "tool",
    "turns",
    "usual",
    "values",
    "visits",
    "half-turns",
]
# What is geometry or bookkeeping: halves, sides of a square, thirds of a cell, columns of a box, two ends of a stretch.
FACTS = {0, 0.5, 1, 2, 3, 4}
# Learned tables, and hashes.
NUMBERS = {"borders.py", "learned.py"}
FILES = sorted(set((CORE / "recognition").glob("*.py")) - set(HOMES))


@pytest.mark.parametrize("home, subject, name, line", DECLARED, ids=[f"{s}.{n}" for _, s, n, _ in DECLARED])
def test_a_threshold_has_a_unit_a_reason_and_a_use(home, subject, name, line):
    above, at = home.read_text(encoding="utf-8").splitlines()[: line.lineno - 1], []
    while above and above[-1].strip().startswith("#:"):
        at.insert(0, above.pop().strip()[2:].strip())
    unit, _, reason = " ".join(at).partition(". ")
    assert unit.split(" ")[0] in UNITS and len(reason) > 20, f"{subject}.{name}: no unit, or no reason"
    use = re.compile(rf"\b{subject}\.{name}\b")
    rooms = [file for room in ("paper", "recognition") for file in (CORE / room).glob("*.py") if file not in HOMES]
    assert any(use.search(file.read_text(encoding="utf-8")) for file in rooms), f"{subject}.{name} decides nothing"


@pytest.mark.parametrize("file", FILES, ids=[file.name for file in FILES])
def test_no_other_file_compares_with_a_number_of_its_own(file):
    found = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Compare):
            numbers = [n for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, (int, float))]
            found += [(n.lineno, n.value) for n in numbers if n.value not in FACTS]
    assert not found, found
