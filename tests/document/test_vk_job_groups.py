# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs made before FreeCAD 0.20 keep their operations in a toolpath compound, which is not an operation itself."""

import FreeCAD
import pytest

import vkworkbench
from vkworkbench.document.job.operations import find, job_of, kind, members
from vkworkbench.document.marks import marks, watcher


def in_compound(small, *operations):
    """Make a compound of operations the job's group; the path of the compound joins the paths of the operations."""
    compound = small.document.addObject("Path::FeatureCompoundPython", "Compound")
    compound.Group = list(operations)
    group = small.job.Operations
    small.job.Operations = compound
    if group.isDerivedFrom("App::DocumentObjectGroup"):
        small.document.removeObject(group.Name)
    small.document.recompute()
    return compound


@pytest.fixture
def old(small, zigzag_commands):
    """A job document whose two operations are in a compound."""
    small.operations = [small.add(label, zigzag_commands, job=False) for label in ("One", "Two")]
    small.compound = in_compound(small, *small.operations)
    return small


def test_compound_of_a_job_is_not_an_operation(old):
    assert old.compound.Path.Size >= sum(op.Path.Size for op in old.operations)
    report = vkworkbench.analyze(old.document)
    assert [row.label for row in report.operations] == ["One", "Two"]
    (total,) = report.totals
    assert total.operations == 2 and total.length == pytest.approx(sum(row.length for row in report.operations))
    for what in (old.job, old.compound, [old.compound, *old.operations]):
        assert [row.label for row in vkworkbench.analyze(what).operations] == ["One", "Two"]


def test_operation_in_a_compound_belongs_to_the_job(old):
    assert kind(old.compound) == "group"
    assert all(job_of(op) is old.job for op in old.operations)
    assert all(
        row.job == old.job.Name and row.error is None for row in vkworkbench.analyze(old.operations[0]).operations
    )


def test_marks_in_a_compound_are_current_after_reopening(old, tmp_path):
    vkworkbench.mark(vkworkbench.analyze(old.document))
    assert not marks.is_marked(old.compound) and old.job.Label2.startswith("⟦2 operations")
    path = str(tmp_path / "old.FCStd")
    old.document.saveAs(path)
    FreeCAD.closeDocument(old.name)
    document = FreeCAD.openDocument(path)
    try:
        watcher.check(document)
        marked = [obj for obj in document.Objects if marks.is_marked(obj)]
        assert len(marked) == 3 and not any(map(marks.is_outdated, marked))
    finally:
        FreeCAD.closeDocument(document.Name)


def test_job_from_an_old_freecad_is_read(old):
    """In an old job, the tool controllers are a list property, not a group of tools."""
    tools = old.job.Tools
    old.job.Proxy = None
    old.job.removeProperty("Tools")
    old.job.addProperty("App::PropertyLinkList", "ToolController").ToolController = tools.Group
    assert kind(old.job) == "job" and kind(old.compound) == "group"
    assert [operation.object for operation in find(old.document)] == old.operations


def test_operations_in_nested_compounds_are_found_in_order(old, zigzag_commands):
    inner = old.document.addObject("Path::FeatureCompound", "Inner")
    third, outer = old.add("Three", zigzag_commands, job=False), old.add("Outside", zigzag_commands, job=False)
    inner.Group = [third]
    old.compound.Group = [old.operations[0], inner, old.operations[1]]
    loose = old.document.addObject("Path::FeatureCompound", "Loose")
    loose.Group = [outer]
    old.document.recompute()
    rows = vkworkbench.analyze(old.document).operations
    assert [(row.label, row.job) for row in rows] == [
        ("One", old.job.Name), ("Three", old.job.Name), ("Two", old.job.Name), ("Outside", None)
    ]  # fmt: skip
    assert [row.label for row in vkworkbench.analyze(inner).operations] == ["Three"]


def test_base_of_a_dress_up_in_a_compound_is_not_in_the_total(old, zigzag_commands):
    dressup = old.add("Dress-up", zigzag_commands, job=False)
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = old.operations[0]
    old.compound.Group = [*old.operations, dressup]
    report = vkworkbench.analyze(old.job)
    assert {row.label: row.counted for row in report.operations} == {"One": False, "Two": True, "Dress-up": True}


def test_operation_in_a_folder_of_the_job_belongs_to_the_job(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands, job=False)
    folder = small.document.addObject("App::DocumentObjectGroup", "Folder")
    folder.Group = [op]
    small.job.Operations.Group += [folder]
    for what in (small.document, small.job, op):
        (row,) = vkworkbench.analyze(what).operations
        assert row.job == small.job.Name and row.counted


def test_operations_in_folders_keep_their_order(small, zigzag_commands):
    one, two, three, four = (small.add(label, zigzag_commands, job=False) for label in ("One", "Two", "Three", "Four"))
    inner, outer = (small.document.addObject("App::DocumentObjectGroup", name) for name in ("Inner", "Outer"))
    inner.Group, outer.Group = [two], [one, inner, three]
    assert [obj.Label for obj in members([outer, four])] == ["One", "Two", "Three", "Four"]
    assert [found.object.Label for found in find([outer, four])] == ["One", "Two", "Three", "Four"]
