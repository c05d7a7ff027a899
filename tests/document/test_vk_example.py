# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import importlib.util

import pytest

LABELS = ["Face", "Pocket zigzag", "Pocket around island", "Adaptive pocket", "Bore", "Drill holes", "Dish",
          "Cut out with tags"]  # fmt: skip


def test_example_has_every_operation_in_order(example):
    labels = [op.Label for op in example.getObject("Job").Operations.Group]
    if not importlib.util.find_spec("opencamlib"):
        LABELS.remove("Dish")
    assert labels == LABELS


@pytest.mark.parametrize("label", LABELS)
def test_example_operation_cuts(example, label):
    found = example.getObjectsByLabel(label)
    if label == "Dish" and not found:
        pytest.skip("OpenCAMLib is not installed")
    (op,) = found
    feeds = [command for command in op.Path.Commands if command.Name in ("G1", "G2", "G3", "G81", "G83")]
    assert len(feeds) > 5
    assert op.isValid()
