# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks in the tree are outdated after a change of path, tool or stock, and valid again after an undo of the change."""

import FreeCAD
import Part
import Path
import pytest

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document import upkeep
from vkworkbench.document.computer import idle
from vkworkbench.document.job.fingerprint import setting_fingerprint
from vkworkbench.document.job.setting import read_stock
from vkworkbench.document.marks import marks, watcher


@pytest.fixture
def watched(small, zigzag_commands):
    small.first, small.second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    upkeep.watch()
    return small


def outdated(document):
    return [obj.Label for obj in document.Objects if marks.is_outdated(obj)]


def descriptions(document):
    # The keys are names, because FreeCAD 1.1 makes new body objects when a tool changes.
    return {obj.Name: obj.Label2 for obj in document.Objects if obj.Label2}


def edit_path(small):
    small.first.Path = Path.Path(small.first.Path.Commands[:-3])


def test_changed_path_outdates_its_mark_and_the_total(watched):
    document = watched.document
    document.openTransaction("Edit")
    edit_path(watched)
    document.commitTransaction()
    document.recompute()
    assert outdated(document) == [watched.job.Label, "First"]
    assert watched.first.Label2.endswith(" · outdated⟧")
    document.undo()
    assert outdated(document) == []
    document.redo()
    assert outdated(document) == [watched.job.Label, "First"]
    vkworkbench.mark(vkworkbench.analyze(watched.first))
    assert outdated(document) == []


def switch(op, on, commands):
    """Switch an operation off or on, and set the path that FreeCAD's recompute would make."""
    op.Active = on
    op.Path = Path.Path(commands if on else [Path.Command("(inactive operation)")])
    op.Document.recompute()


def test_mark_of_inactive_operation_shows_switched_off(watched, tmp_path):
    document, first = watched.document, watched.first
    commands, before, total = first.Path.Commands, descriptions(document), marks.read(first)
    first.Active = False
    document.recompute()
    # FreeCAD removes the toolpath of a switched-off operation only at the next recompute.
    assert descriptions(document)[first.Name] == before[first.Name]
    switch(first, False, commands)
    assert first.Label2 == "⟦switched off⟧" and first.Strategy == "empty" and outdated(document) == []
    told = marks.read(first)
    assert [remark.code for remark in told.remarks] == ["inactive"] and told.costs == {} and told.length == 0
    assert watched.job.Label2.startswith("⟦1 operation ")
    document.saveAs(str(tmp_path / "off.FCStd"))
    watcher.check(document)
    preferences.write(mark_simulator="z-buffer")
    try:
        upkeep.follow_preferences()
        assert first.Label2 == "⟦switched off⟧"
    finally:
        preferences.write(mark_simulator="own")
        upkeep.follow_preferences()
    switch(first, True, commands)
    assert descriptions(document) == before and marks.read(first) == total and first.Strategy == "zigzag"


def test_undoing_the_switching_off_restores_the_mark(watched):
    document, before = watched.document, descriptions(watched.document)
    document.openTransaction("Off")
    switch(watched.first, False, [])
    document.commitTransaction()
    off = descriptions(document)
    assert off != before
    document.undo()
    assert descriptions(document) == before
    document.redo()
    assert descriptions(document) == off


def test_change_while_inactive_outdates_the_mark(watched):
    first = watched.first
    commands = first.Path.Commands
    switch(first, False, commands)
    switch(first, True, commands[:-3])
    assert first.Label2.endswith(" · outdated⟧")
    switch(first, False, commands)
    assert first.Label2 == "⟦switched off⟧"  # "switched off" is more important to the user than "outdated"
    watched.controller.Tool.Diameter = 4
    watched.document.recompute()
    assert first.Label2 == "⟦switched off⟧" and watched.second.Label2.endswith(" · outdated⟧")
    switch(first, True, commands)
    assert first.Label2.endswith(" · outdated⟧")
    watched.controller.Tool.Diameter = 5
    watched.document.recompute()
    assert outdated(watched.document) == []


def test_mark_made_while_switched_off_is_outdated_when_on(watched):
    commands = watched.first.Path.Commands
    switch(watched.first, False, commands)
    vkworkbench.mark(vkworkbench.analyze(watched.first))
    assert watched.first.Label2 == "⟦switched off⟧"
    switch(watched.first, True, commands)
    assert watched.first.Label2 == "⟦switched off · outdated⟧"


def test_lost_path_of_an_active_operation_outdates_its_mark(watched):
    watched.first.Path = Path.Path()
    watched.document.recompute()
    assert watched.first.Label2.endswith(" · outdated⟧")


@pytest.fixture
def looked_at(monkeypatch):
    """A list of compared operations: label, whether the path and whether the setting may have changed."""
    looked_at = []
    refresh = marks.refresh

    def noted(obj, settings_of, **changed):
        looked_at.append((obj.Label, *changed.values()))
        return refresh(obj, settings_of, **changed)

    monkeypatch.setattr(marks, "refresh", noted)
    return looked_at


def test_only_possible_changes_are_compared(watched, looked_at):
    document = watched.document
    for rename in ("Another", "Third"):
        document.openTransaction("Rename")
        watched.second.Label = rename
        document.commitTransaction()
        document.undo()
    document.addObject("Path::FeaturePython", "Unmarked")
    document.recompute()
    assert looked_at == []
    edit_path(watched)
    document.recompute()
    assert looked_at == [("First", True, False)]


def test_check_compares_path_and_setting_of_all_marks(watched, zigzag_commands, looked_at):
    watched.add("Third", zigzag_commands)
    looked_at.clear()
    watcher.check(watched.document)
    assert looked_at == [("First", True, True), ("Second", True, True)]


def test_undone_mark_is_compared_with_current_state(watched):
    """The job's tool was changed between the two markings, outside any transaction."""
    document = watched.document
    document.UndoMode = 0
    watched.controller.Tool.Diameter = 7
    document.recompute()
    document.UndoMode = 1
    vkworkbench.mark(vkworkbench.analyze(document))
    assert outdated(document) == []
    document.undo()
    assert "First" in outdated(document)


@pytest.mark.parametrize("change", ["tool", "stock", "placement", "rapids"])
def test_change_of_tool_or_stock_outdates_the_marks(watched, change):
    document = watched.document
    fresh = descriptions(document)

    def set_to(value):
        if change == "tool":
            watched.controller.Tool.Diameter = 5 + value
        elif change == "stock":
            watched.job.Stock.ExtZpos = 1 + value
        elif change == "rapids":
            # Since FreeCAD 1.0 an expression copies the speed from the setup sheet.
            watched.controller.setExpression("HorizRapid", None)
            watched.controller.HorizRapid = 50 + value
        else:
            watched.first.Placement.Base = FreeCAD.Vector(value, 0, 0)
        document.recompute()

    if change in ("stock", "rapids"):
        set_to(0)
        vkworkbench.mark(vkworkbench.analyze(document))
        fresh = descriptions(document)
    set_to(2)
    assert "First" in outdated(document) and watched.job.Label in outdated(document)
    assert ("Second" in outdated(document)) == (change != "placement")
    set_to(0)
    assert descriptions(document) == fresh


def test_total_time_is_multiplied_after_a_change_of_fixtures(watched):
    once = marks.read(watched.job).machining_seconds
    for fixtures in (["G54", "G55"], ["G54", "G55", "G59"], ["G54"]):
        watched.job.Fixtures = fixtures
        watched.document.recompute()
        assert outdated(watched.document) == []
        assert marks.read(watched.job).machining_seconds == pytest.approx(len(fixtures) * once)


def test_irrelevant_changes_keep_marks_current(watched):
    watched.first.Label = "Renamed"
    watched.second.Label2 = "own words " + watched.second.Label2
    watched.job.Label = "Another"
    watched.document.addObject("Part::Box", "Unrelated").Length = 7
    watched.document.recompute()
    assert outdated(watched.document) == []


def test_new_operation_without_a_mark_outdates_the_total(watched, zigzag_commands):
    document = watched.document
    third = watched.add("Third", zigzag_commands)
    document.recompute()
    assert outdated(document) == [watched.job.Label]
    document.removeObject(third.Name)
    document.recompute()
    assert outdated(document) == []


def test_total_is_updated_when_an_operation_is_deleted(watched):
    document, before = watched.document, watched.job.Label2
    document.openTransaction("Delete")
    document.removeObject(watched.second.Name)
    document.commitTransaction()
    assert outdated(document) == [] and watched.job.Label2.startswith("⟦1 operation · ")
    (only,) = vkworkbench.analyze(document).totals
    told = marks.read(watched.job)
    assert told.machining_seconds == pytest.approx(only.machining_seconds)
    assert told.cost(preferences.read().simulator) == pytest.approx(only.cost(preferences.read().simulator))
    document.undo()
    assert outdated(document) == [] and watched.job.Label2 == before
    edit_path(watched)
    document.removeObject(watched.second.Name)
    document.recompute()
    assert outdated(document) == [watched.job.Label, "First"] and marks.read(watched.job).operations == 1


@pytest.fixture
def waiting(monkeypatch):
    """A list of the functions that wait until the window is idle."""
    waiting = []
    monkeypatch.setattr(idle, "_soon", None)
    idle.use(waiting.append)
    return waiting


def test_copy_in_another_document_is_outdated_when_idle(watched, waiting):
    """A pasted object is neither recomputed nor saved, so its mark is compared when FreeCAD is idle."""
    other = FreeCAD.newDocument("Other")
    closed = FreeCAD.newDocument("Closed")
    for document in (other, closed):
        document.copyObject(watched.first, False)
    assert outdated(other) == []
    FreeCAD.closeDocument(closed.Name)
    try:
        while waiting:
            waiting.pop(0)()
        assert outdated(other) == ["First"] and outdated(watched.document) == []
    finally:
        FreeCAD.closeDocument(other.Name)


def test_marks_are_compared_after_reopening(watched, tmp_path):
    path = str(tmp_path / "job.FCStd")
    watched.document.saveAs(path)
    name = watched.document.Name
    FreeCAD.closeDocument(name)
    document = FreeCAD.openDocument(path)
    try:
        watcher.check(document)
        assert outdated(document) == [] and sum(marks.is_marked(obj) for obj in document.Objects) == 3
        stale = document.getObjectsByLabel("First")[0]
        stale.VkWorkbenchMark = stale.VkWorkbenchMark.replace(marks.read(stale).fingerprint, "of:another")
        watcher.check(document)
        assert "First" in outdated(document)
    finally:
        FreeCAD.closeDocument(document.Name)


def test_mark_of_a_real_operation_is_outdated_until_undo(example):
    vkworkbench.mark(vkworkbench.analyze(example))
    upkeep.watch()
    example.UndoMode = 1
    assert outdated(example) == []
    drill = example.getObjectsByLabel("Drill holes")[0]
    example.openTransaction("Depth")
    drill.setExpression("FinalDepth", None)
    drill.FinalDepth = drill.FinalDepth.Value + 1
    example.recompute()
    example.commitTransaction()
    assert outdated(example) == ["Job", "Drill holes"]
    example.undo()
    assert outdated(example) == []


def test_marks_are_not_compared_while_a_file_is_opened(watched, tmp_path, looked_at):
    path = str(tmp_path / "job.FCStd")
    watched.document.saveAs(path)
    FreeCAD.closeDocument(watched.document.Name)
    looked_at.clear()
    document = FreeCAD.openDocument(path)
    document.save()
    assert looked_at == []
    FreeCAD.closeDocument(document.Name)


# Stocks with curved faces, and their setting fingerprints, which are equal in FreeCAD 0.20.2, 1.0.0 and 1.1.3.
CURVED = {
    "round": (lambda: Part.makeCylinder(25.4 / 8, 20, FreeCAD.Vector(30, 20, 0)), "9aa4b6c64a753d85"),
    "tilted": (lambda: Part.makeCylinder(30, 20, FreeCAD.Vector(1, 2, 0), FreeCAD.Vector(1, 1, 3)), "becb408387289149"),
    "torus": (lambda: Part.makeTorus(20, 5), "b8547f8fa43d8adb"),
    "drilled": (lambda: Part.makeBox(60, 40, 20).cut(
        Part.makeCylinder(5, 40, FreeCAD.Vector(30, 20, -5), FreeCAD.Vector(0.3, 0.1, 1))), "88088bbf8f0b76f0"),
}  # fmt: skip


@pytest.mark.parametrize("name", CURVED)
def test_displayed_mesh_of_a_stock_does_not_outdate_marks(watched, name):
    make, fingerprint = CURVED[name]
    watched.job.Stock.Proxy = None  # the proxy would replace the shape that is set below at the next recompute
    watched.job.Stock.Shape = make()
    vkworkbench.mark(vkworkbench.analyze(watched.document))
    box = str(watched.job.Stock.Shape.BoundBox)
    watched.job.Stock.Shape.tessellate(0.5)
    assert str(watched.job.Stock.Shape.BoundBox) != box
    watcher.check(watched.document)
    assert outdated(watched.document) == []
    assert setting_fingerprint(None, read_stock(watched.job)) == fingerprint
