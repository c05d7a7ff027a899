# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of a job: clamps, the job before it, and the simulated part as a mesh or an STL file."""

import FreeCAD
import FreeCADGui as Gui
import Mesh
import pytest
from make_example import cam
from PySide import QtCore, QtGui

from vkworkbench.document.job.clamps import clamps_of
from vkworkbench.document.job.previous import previous_job


@pytest.fixture
def vice(document):
    clamp = document.addObject("Part::Box", "Vice")
    clamp.Label = "Vice jaw"
    clamp.Placement.Base = FreeCAD.Vector(0, -60, 0)
    document.recompute()
    return clamp


def job_in(document):
    return document.getObject("Job")


def select(*objects):
    Gui.Selection.clearSelection()
    for obj in objects:
        Gui.Selection.addSelection(obj)


def test_button_sets_the_selected_clamps(document, vice, window):
    job, undo = job_in(document), document.UndoCount
    select(vice)
    window.click("Set Clamps from Selection")
    assert clamps_of(job) == (vice,) and document.UndoCount == undo + 1
    assert window.main.statusBar().currentMessage() == f"Clamps of {job.Label}: Vice jaw."
    window.screenshot("clamps-set")
    document.undo()
    assert clamps_of(job) == ()


def test_button_shows_and_removes_the_clamps(document, vice, window):
    select(job_in(document))
    window.click("Set Clamps from Selection")
    (text,) = window.dismiss()
    assert "has no clamps. To set clamps, select their solids" in text
    select(vice, job_in(document))
    window.click("Set Clamps from Selection")
    select()
    window.click("Set Clamps from Selection")
    (box,) = window.boxes()
    assert "Vice jaw" in box.text()
    window.screenshot("clamps-shown")
    next(button for button in box.buttons() if button.text() == "Remove Clamps").click()
    window.settle()
    assert clamps_of(job_in(document)) == ()
    window.dismiss()


def test_part_is_added_as_mesh_and_saved(document, window, tmp_path):
    before, undo = len(document.Objects), document.UndoCount
    select(job_in(document))
    Gui.runCommand("Vk_AddMesh")
    assert len(document.Objects) == before + 1 and document.UndoCount == undo + 1
    mesh = document.Objects[-1].Mesh
    assert mesh.isSolid() and mesh.Volume > 0
    window.screenshot("mesh-added")
    path = tmp_path / "part.stl"
    title = window.answer_file_dialog(path, lambda: Gui.runCommand("Vk_SaveStl"))
    assert title == "Save Simulated Part as STL"
    assert Mesh.Mesh(str(path)).Volume == pytest.approx(mesh.Volume, rel=1e-4)
    document.undo()
    assert len(document.Objects) == before


def test_second_job_begins_with_the_part_of_the_first(document, window):
    job = job_in(document)
    select(job)
    Gui.runCommand("Vk_PreviousJob")
    assert window.dismiss() == [f"No other job of this document machines the part of {job.Label}."]
    model = job.Model.Group[0]
    second = cam("Main.Job").Create("Second", [model.Objects[0] if hasattr(model, "Objects") else model])
    second.Label = "Second"
    document.recompute()
    select(second)
    Gui.runCommand("Vk_PreviousJob")
    (dialog,) = window.top_level(QtGui.QInputDialog)
    assert dialog.comboBoxItems() == ["The stock of Second", f"1. {job.Label}"]
    assert [label.textFormat() for label in dialog.findChildren(QtGui.QLabel)] == [QtCore.Qt.PlainText]
    window.screenshot("previous-job")
    dialog.setTextValue(f"1. {job.Label}")
    dialog.accept()
    window.settle()
    assert previous_job(second) == job
    assert window.main.statusBar().currentMessage() == f"Second begins with the part that {job.Label} leaves."
