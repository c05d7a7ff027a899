# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths in inches that were read as mm have the strategy of their true size, and keep their lengths as read."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.gcode import INCH
from vkworkbench.core.recognition import recognize_inches
from vkworkbench.language import Message

TOOL = 6.0
PROGRAMS = {
    "zigzag": programs.zigzag(10, 50.0, 3.0, depths=(0.0, -2.0)),
    "contour-parallel": programs.offsets(depths=(0.0, -2.0)),
    "profile": programs.profile(),
}


def steps_of(message):
    """Yield the values of all arguments named `step` in a message and in the messages inside it."""
    for name, value in message.arguments.items():
        if name == "step":
            yield value
        for one in value if isinstance(value, tuple) else (value,):
            if isinstance(one, Message):
                yield from steps_of(one)


@pytest.mark.parametrize("name", PROGRAMS)
def test_toolpath_in_inches_has_the_same_strategy(name):
    own = linearize(PROGRAMS[name])
    small = replace(own, points=own.points / INCH)
    true, found = recognize(own, tool_diameter=TOOL), recognize_inches(small, tool_diameter=TOOL)
    assert found.strategy == true.strategy == Strategy(name) and found.confidence == pytest.approx(true.confidence)
    if true.stepover is None:
        assert found.stepover is None
    else:
        assert found.stepover == pytest.approx(true.stepover / INCH)
        assert list(steps_of(found.why)) == pytest.approx([step / INCH for step in steps_of(true.why)])
    assert found.paper.v == pytest.approx(np.array(true.paper.v) / INCH)
    assert found.why.code == true.why.code and found.depths == true.depths
    assert recognize_inches(small, tool_diameter=TOOL, program=True).spans == found.spans


def test_reason_of_several_operations_is_the_same_in_inches():
    """The reason for the strategy "mixed" names the strategies of both operations, but contains no lengths."""
    own = linearize([*PROGRAMS["zigzag"], *PROGRAMS["profile"]])
    own = replace(own, comments=(), tool_changes=np.array([len(linearize(PROGRAMS["zigzag"]))]))
    true = recognize(own, tool_diameter=TOOL, program=True)
    found = recognize_inches(replace(own, points=own.points / INCH), tool_diameter=TOOL, program=True)
    assert true.strategy is Strategy.MIXED and found.why == true.why


def test_operation_in_inches_is_not_divided_at_its_retracts():
    own = replace(linearize([*PROGRAMS["zigzag"], *PROGRAMS["profile"]]), comments=())
    small = replace(own, points=own.points / INCH)
    true, found = recognize(own, tool_diameter=TOOL), recognize_inches(small, tool_diameter=TOOL)
    assert found.spans == true.spans != recognize_inches(small, tool_diameter=TOOL, program=True).spans


def test_drilling_has_no_result_of_the_papers_rule_in_inches():
    drilled = linearize(programs.drilling())
    found = recognize_inches(replace(drilled, points=drilled.points / INCH))
    assert found.strategy is Strategy.DRILLING and found.paper is None and found.stepover is None
