# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job for the second side of a part, whose stock is the part that the job for the first side leaves."""

import FreeCAD
import Mesh
import numpy as np
import Part
import pytest
from make_example import cam

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document.job.previous import possible_previous_jobs, previous_job, set_previous_job
from vkworkbench.document.marks import marks, watcher
from vkworkbench.language import Unusable

POCKET = [("G0", {"X": 20, "Y": 20, "Z": 25}), ("G1", {"Z": 10, "F": 5}), ("G1", {"X": 40}), ("G0", {"Z": 25})]
BORE = [("G0", {"X": 10, "Y": 10, "Z": 25}), ("G1", {"Z": 4, "F": 5}), ("G0", {"Z": 25})]
TURNED = FreeCAD.Placement(FreeCAD.Vector(0, 40, 20), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 180))


def job_of(small, label, model, placement=None):
    job = cam("Main.Job").Create(label, [model])
    job.Label = label
    if placement is not None:
        job.Model.Group[0].Placement = placement
    small.document.recompute()
    job.Operations.Group += [small.add("Bore", BORE, job=False)]
    small.document.recompute()
    return job


@pytest.fixture
def second(small):
    """A second job that drills the turned block, after the first job has cut a pocket into the first side."""
    small.add("Pocket", POCKET)
    return job_of(small, "Second", small.document.getObject("Block"), TURNED)


def test_second_job_begins_with_the_part_of_the_first(small, second):
    first = vkworkbench.simulate(small.job)
    undo = small.document.UndoCount
    states = [obj.State for obj in small.document.Objects]
    set_previous_job(second, small.job)
    assert small.document.UndoCount == undo + 1 and [obj.State for obj in small.document.Objects] == states
    done = vkworkbench.simulate(second)
    assert done.at(0).zbuffer.part_volume == pytest.approx(first.zbuffer.part_volume, rel=1e-3)
    assert done.job.remarks == () and done.job.valid_for
    mesh = done.mesh()
    assert mesh.isSolid() and not mesh.hasNonManifolds()
    assert mesh.Volume == pytest.approx(done._of_solid().part_volume, rel=1e-5)
    small.document.undo()
    assert previous_job(second) is None


def test_only_jobs_of_the_same_part_are_offered_as_previous(small, second):
    other = small.document.addObject("Part::Feature", "Other")
    other.Shape = Part.makeBox(50, 30, 10)
    job_of(small, "Third", other)
    assert possible_previous_jobs(second) == [small.job] and possible_previous_jobs(small.job) == [second]
    set_previous_job(second, small.job)
    assert possible_previous_jobs(small.job) == []
    with pytest.raises(Unusable, match="already begins with what this job leaves"):
        set_previous_job(small.job, second)
    with pytest.raises(Unusable, match="already begins"):
        set_previous_job(small.job, small.job)


@pytest.mark.usefixtures("checked_coarsely")
def test_change_of_the_first_job_outdates_the_second_verdict(small, second):
    set_previous_job(second, small.job)
    facts = vkworkbench.simulate(second).facts()
    vkworkbench.mark(vkworkbench.analyze(small.document).with_facts(facts))
    assert marks.read(second).verdict.what == facts.sentence and marks.read(small.job).verdict is None
    pocket = small.job.Operations.Group[0]
    pocket.Path = type(pocket.Path)(pocket.Path.Commands[:-1])
    watcher.check(small.document)
    assert marks.read(second).verdict.outdated


def test_error_names_a_previous_job_without_operations(small):
    second = job_of(small, "Second", small.document.getObject("Block"))
    set_previous_job(second, small.job)
    with pytest.raises(Unusable, match="Job: There is nothing to simulate"):
        vkworkbench.simulate(second)


@pytest.mark.long
def test_second_side_of_the_example_gives_a_closed_stl_file(example, tmp_path):
    """The example's part is turned over and drilled; its STL file is closed and has the simulated volume."""
    before = preferences.read()
    job = example.getObject("Job")
    model = job.Model.Group[0]
    box = model.Shape.BoundBox
    turn = FreeCAD.Placement(FreeCAD.Vector(0, box.YMin + box.YMax, box.ZMin + box.ZMax), TURNED.Rotation)
    second = cam("Main.Job").Create("Second", [model.Objects[0] if hasattr(model, "Objects") else model])
    second.Model.Group[0].Placement = turn.multiply(second.Model.Group[0].Placement)
    example.recompute()
    drill = example.addObject("Path::FeaturePython", "Drill")
    drill.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = job.Tools.Group[0]
    stock = second.Stock.Shape.BoundBox
    x, y, top = stock.Center.x, stock.Center.y, stock.ZMax
    drill.Path = type(job.Path)(f"G0 Z{top + 5}\nG0 X{x} Y{y}\nG1 Z{top - 3} F5\nG0 Z{top + 5}\n")
    second.Operations.Group += [drill]
    set_previous_job(second, job)
    try:
        preferences.write(time_budget=20.0)
        first, done = vkworkbench.simulate(job, view="Top"), vkworkbench.simulate(second, view="Top")
    finally:
        preferences.write(**vars(before))
    assert done.at(0).zbuffer.part_volume == pytest.approx(first.zbuffer.part_volume, rel=0.005)
    assert done.zbuffer.part_volume < done.at(0).zbuffer.part_volume
    assert "stock-not-moved" not in [remark.code for remark in done.job.remarks]
    done.save_stl(tmp_path / "part.stl")
    a, b, c = np.moveaxis(done.triangles(), 1, 0)
    volume = np.einsum("ti,ti->", a, np.cross(b, c)) / 6
    assert volume == pytest.approx(done.zbuffer.part_volume, rel=1e-5)
    mesh = Mesh.Mesh(str(tmp_path / "part.stl"))
    assert mesh.isSolid() and not mesh.hasNonManifolds()
    assert mesh.Volume == pytest.approx(volume, rel=1e-4)  # FreeCAD adds the volumes with single precision
