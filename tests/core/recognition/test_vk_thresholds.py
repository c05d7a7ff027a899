# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each threshold of the recognition is in one of the threshold files, with a unit and a reason, and is used."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.sources

CORE = Path(__file__).resolve().parents[3] / "vkworkbench/core"
HOMES = [CORE / room / "thresholds.py" for room in ("paper", "recognition")]
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
# Numbers that are not thresholds: halves, sides of a square, thirds of a cell, columns of a box, ends of a stretch.
FACTS = {0, 0.5, 1, 2, 3, 4}
# This file contains a table of numbers that a training program computed.
NUMBERS = {"borders.py"}
FILES = sorted(set((CORE / "recognition").rglob("*.py")) - set(HOMES))


def declared(home, parse):
    """Yield the name of each threshold of a file, such as ``ROWS.MIN_LENGTH``, and the comment above the threshold."""
    lines = home.read_text(encoding="utf-8").splitlines()
    for subject in parse(home).body:
        for line in subject.body if isinstance(subject, ast.ClassDef) else ():
            if isinstance(line, ast.Assign):
                above, comment = lines[: line.lineno - 1], []
                while above and above[-1].strip().startswith("#:"):
                    comment.insert(0, above.pop().strip()[2:].strip())
                yield f"{subject.name}.{line.targets[0].id}", " ".join(comment)


def used():
    """Return all dotted names, such as ``ROWS.MIN_LENGTH``, in the files that may use thresholds."""
    rooms = [file for room in ("paper", "recognition") for file in (CORE / room).rglob("*.py") if file not in HOMES]
    return {name for file in rooms for name in re.findall(r"\b[A-Z]\w*\.\w+", file.read_text(encoding="utf-8"))}


def test_each_threshold_has_a_unit_a_reason_and_a_use(parse):
    thresholds = dict(one for home in HOMES for one in declared(home, parse))
    assert len(thresholds) > 100
    undescribed, names = [], used()
    for name, comment in thresholds.items():
        unit, _, reason = comment.partition(". ")
        if unit.split(" ")[0] not in UNITS or len(reason) <= 20:
            undescribed.append(name)
    assert undescribed == [], "no unit, or no reason"
    assert [name for name in thresholds if name not in names] == [], "no file uses the threshold"


def test_files_in_core_recognition_compare_with_no_bare_numbers(parse):
    found = []
    for file in FILES:
        for node in ast.walk(parse(file)):
            if isinstance(node, ast.Compare):
                numbers = [n for n in ast.walk(node) if isinstance(n, ast.Constant)]
                numbers = [n for n in numbers if isinstance(n.value, (int, float)) and n.value not in FACTS]
                found += [(file.name, n.lineno, n.value) for n in numbers]
    assert found == []
