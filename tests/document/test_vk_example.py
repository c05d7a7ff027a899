# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import pytest

TOOL_DIAMETERS = {  # mm, by the operation's label, in the order of the job
    "Face": 16,
    "Pocket zigzag": 6,
    "Pocket around island": 6,
    "Adaptive pocket": 6,
    "Bore": 6,
    "Drill holes": 5,
    "Dish": 6,
    "Cut out with tags": 6,
}


def operations(doc):
    return {op.Label: op for op in doc.getObject("Job").Operations.Group}


def test_example_has_all_operations_in_order(example):
    labels = list(operations(example))
    assert labels in (list(TOOL_DIAMETERS), [label for label in TOOL_DIAMETERS if label != "Dish"])


@pytest.mark.parametrize("label", TOOL_DIAMETERS)
def test_example_operation_cuts_with_its_tool(example, label):
    op = operations(example).get(label)
    if op is None and label == "Dish":
        pytest.skip("needs OpenCAMLib")
    feeds = [command for command in op.Path.Commands if command.Name in ("G1", "G2", "G3", "G81", "G83")]
    assert len(feeds) >= 10
    assert op.isValid()
    if label != "Cut out with tags":  # this operation is a dress-up, which has no tool controller of its own
        assert op.ToolController.Tool.Diameter.Value == TOOL_DIAMETERS[label]


def test_example_job_has_all_tools(example):
    assert [tc.ToolNumber for tc in example.getObject("Job").Tools.Group] == [1, 2, 3, 4]
