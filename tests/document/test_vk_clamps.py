# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes of shanks and holders from tool bits, and the clamps of a job."""

import FreeCAD
import Part
import pytest

from vkworkbench import preferences
from vkworkbench.core.zbuffer import Cuts, holder_collisions
from vkworkbench.document.job.clamps import clamp_solids, clamps_of, has_solid, set_clamps, shapes_of
from vkworkbench.document.job.fingerprint import read_setting_fingerprints
from vkworkbench.document.job.setting import read_tool
from vkworkbench.document.simulation.copy import copy_job, read_job
from vkworkbench.language import Unusable

SLOT = [("G0", {"X": -10, "Y": 20, "Z": 25}), ("G1", {"Z": 12, "F": 5}), ("G1", {"X": 70}), ("G0", {"Z": 25})]


@pytest.fixture
def slot(small):
    bit = small.controller.Tool
    bit.CuttingEdgeHeight, bit.ShankDiameter, bit.Length = 6, 8, 40
    return small.add("Slot", SLOT)


def box(small, name, *corner_and_size):
    obj = small.document.addObject("Part::Feature", name)
    obj.Label = name
    obj.Shape = Part.makeBox(*corner_and_size[3:], FreeCAD.Vector(*corner_and_size[:3]))
    small.document.recompute()
    return obj


def told(job):
    return [(one.body, one.source.command, round(one.depth, 1), one.clamp)
            for one in holder_collisions(Cuts(job.cuts), job.stock, clamps=job.clamps).found]  # fmt: skip


def test_sizes_of_shank_and_flutes_are_read_from_a_tool_bit(slot):
    tool = read_tool(slot)
    assert (tool.cutting_edge_height, tool.shank_diameter, tool.length, tool.holder_diameter) == (6, 8, 40, None)
    assert told(read_job(slot)) == [("flutes", 2, 3.0, ""), ("shank", 2, 3.0, "")]


def test_holder_of_the_tool_bit_overrides_the_preferences(small, slot):
    before = preferences.read()
    try:
        preferences.write(holder_diameter=30.0, holder_length=50.0)
        (cut,) = read_job(slot).cuts
        assert (cut.tool.holder_diameter, cut.tool.holder_length) == (30, 50)
        small.controller.Tool.addProperty("App::PropertyLength", "HolderDiameter", "Holder")
        small.controller.Tool.HolderDiameter = 20
        (cut,) = read_job(slot).cuts
        assert (cut.tool.holder_diameter, cut.tool.holder_length) == (20, None)
    finally:
        preferences.write(**vars(before))


def test_another_shank_changes_the_fingerprint(small, slot):
    before = read_setting_fingerprints(slot, small.job)
    small.controller.Tool.ShankDiameter = 9
    assert read_setting_fingerprints(slot, small.job) != before
    small.controller.Tool.ShankDiameter = 8
    assert read_setting_fingerprints(slot, small.job) == before


def test_clamps_of_a_job_are_set_in_one_undo_step(small, slot):
    clamp = box(small, "Clamp", -20, 10, 0, 15, 20, 30)
    states = [obj.State for obj in small.document.Objects]
    undo = small.document.UndoCount
    set_clamps(small.job, [clamp])
    assert small.document.UndoCount == undo + 1 and clamps_of(small.job) == (clamp,)
    assert [obj.State for obj in small.document.Objects] == states
    assert ("tool", 1, 18.0, "Clamp") in told(read_job(slot))
    small.document.undo()
    assert clamps_of(small.job) == () and read_job(slot).clamps == {}


def test_clamps_argument_overrides_clamps_of_the_job(small, slot):
    clamp, other = box(small, "Clamp", -20, 10, 0, 15, 20, 30), box(small, "Other", -20, 100, 0, 15, 20, 30)
    set_clamps(small.job, [clamp])
    assert list(read_job(slot).clamps) == ["Clamp"]
    assert list(read_job(slot, [other]).clamps) == ["Other"] and read_job(slot, []).clamps == {}


def test_moved_clamp_outdates_the_simulation(small, slot):
    clamp = box(small, "Clamp", -20, 10, 0, 15, 20, 30)
    set_clamps(small.job, [clamp])
    copy = copy_job(slot)
    list(copy.copying())

    def is_same():
        steps = copy.comparing(())
        while True:
            try:
                next(steps)
            except StopIteration as end:
                return end.value

    assert is_same()
    clamp.Shape = Part.makeBox(15, 20, 40, FreeCAD.Vector(-20, 10, 0))
    assert not is_same()


def test_clamp_in_a_part_is_moved_by_the_placement_of_the_part(small):
    """Both the solid in the part and the part itself can be a clamp."""
    clamp, part = box(small, "Clamp", 0, 0, 0, 10, 10, 10), small.document.addObject("App::Part", "Vice")
    part.addObject(clamp)
    part.Placement.Base = FreeCAD.Vector(0, 100, 5)
    small.document.recompute()
    for obj in (clamp, part):
        (solid,) = clamp_solids([obj]).values()
        assert solid.lower.tolist() == pytest.approx([0, 100, 5]) and has_solid(obj)
    moved = shapes_of([clamp])[0]
    assert moved.BoundBox.YMin == pytest.approx(100) and clamp.Shape.BoundBox.YMin == pytest.approx(0)


def test_setting_the_same_clamps_leaves_no_open_transaction(small, slot):
    clamp = box(small, "Clamp", -20, 100, 0, 15, 20, 30)
    set_clamps(small.job, [clamp])
    set_clamps(small.job, [clamp])
    assert not small.document.HasPendingTransaction and FreeCAD.getActiveTransaction() is None


def test_object_without_solid_is_refused_as_clamp(small):
    line = small.document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine((0, 0, 0), (1, 1, 1))
    with pytest.raises(Unusable, match="Line: The surface of the solid is not closed"):
        set_clamps(small.job, [line])
    assert clamps_of(small.job) == ()
