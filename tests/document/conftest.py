# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small job in FreeCAD, whose operations get their toolpaths from the test."""

from __future__ import annotations

import FreeCAD
import Path
import pytest
from coarse import coarse_check
from make_example import cam

from vkworkbench.document.job.results import RESULTS


@pytest.fixture(autouse=True)
def nothing_known():
    """Forget the results of earlier analyses."""
    RESULTS.clear()


@pytest.fixture
def checked_coarsely():
    """Check the simulated jobs of a test coarsely, because the test does not judge small faults."""
    with coarse_check():
        yield


class JobDocument:
    """A document with one CAM job on a block of 60 x 40 x 20 mm with a 5 mm end mill."""

    def __init__(self):
        self.document = FreeCAD.newDocument("Small")
        self.name = self.document.Name
        block = self.document.addObject("Part::Box", "Block")
        block.Length, block.Width, block.Height = 60, 40, 20
        self.document.recompute()
        self.job = cam("Main.Job").Create("Job", [block])
        self.document.recompute()
        self.controller = self.job.Tools.Group[0]
        if self.controller.Tool.Diameter.Value != 5:  # FreeCAD 1.1 models the tool again even if nothing changes
            self.controller.Tool.Diameter = 5
            self.document.recompute()
        self.document.UndoMode = 1

    def add(self, label, commands, controller=True, job=True):
        """Add an operation with a fixed path and without a proxy, as in a file of another FreeCAD version."""
        op = self.document.addObject("Path::FeaturePython", "Op")
        op.Label = label
        op.addProperty("App::PropertyLink", "ToolController", "Path")
        op.addProperty("App::PropertyBool", "Active", "Path")
        op.Active = True
        op.ToolController = self.controller if controller is True else controller
        op.Path = Path.Path([Path.Command(name, words) for name, words in commands])
        if job:
            self.job.Operations.Group += [op]
        self.document.recompute()
        op.purgeTouched()
        return op


@pytest.fixture
def small():
    """A JobDocument, closed after the test."""
    small = JobDocument()
    yield small
    if small.name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(small.name)


def zigzag(rows=10, z=15.0):
    """Commands of a zigzag over the block."""
    commands = [("G0", {"Z": 30.0}), ("G0", {"X": 5.0, "Y": 5.0}), ("G1", {"Z": z, "F": 5.0})]
    for row in range(rows):
        x = 55.0 if row % 2 == 0 else 5.0
        commands += [("G1", {"X": x, "F": 10.0}), ("G1", {"Y": 5.0 + 3.0 * (row + 1)})]
    return [*commands, ("G0", {"Z": 30.0})]


@pytest.fixture
def zigzag_commands():
    return zigzag()
