# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that needs more travel than the machine has gets a remark."""

from dataclasses import replace

import pytest

from vkworkbench.language import render
from vkworkbench.preferences import Preferences
from vkworkbench.program.analysis import analyze_file

PROGRAM = """G21
(Left)
T1 M6
G0 X0 Y0 Z5
G1 Z-1 F600
G1 X100
G0 Z5
(Right)
T2 M6
G0 X300 Y20
G1 Z-1
G1 X310.5
G0 Z5
M30
"""


@pytest.fixture
def told(tmp_path):
    """Return a function that takes the machine's travel and returns the remarks on exceeded travel, by operation."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM)

    def remarks(x=0.0, y=0.0, z=0.0):
        rows = analyze_file(path, replace(Preferences(), travel_x=x, travel_y=y, travel_z=z))
        return [[render(one) for one in row.remarks if one.code == "beyond-travel"] for row in rows]

    return remarks


def test_all_operations_together_may_exceed_the_travel(told):
    """Each operation alone stays within the machine's travel."""
    assert told(x=310) == [["The job moves 310.5 mm along X, but the travel of the machine is 310 mm."], []]


def test_exceeded_travel_names_each_axis(told):
    assert [len(remarks) for remarks in told(x=300, y=19, z=5)] == [3, 0]


def test_enough_or_unknown_travel_has_no_remark(told):
    assert told() == told(x=310.5, y=20, z=6) == [[], []]
