# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulated part as a closed mesh, as an STL file, and as the stock of the next job."""

import FreeCAD
import Mesh
import numpy as np
import Part
import pytest
from cases import first_everywhere
from make_example import cam

import vkworkbench
from vkworkbench.core import Stock, View

POCKET = [("G0", {"X": 20, "Y": 20, "Z": 25}), ("G1", {"Z": 10, "F": 5}), ("G1", {"X": 40}), ("G0", {"Z": 25})]
BORE = [("G0", {"X": 10, "Y": 10, "Z": 25}), ("G1", {"Z": 4, "F": 5}), ("G0", {"Z": 25})]


@pytest.fixture
def pocket(small):
    small.add("Pocket", POCKET)
    return vkworkbench.simulate(small.job)


@pytest.mark.parametrize("view", first_everywhere(["Top", "Isometric", View(width=100, height=80, offset=(20, 0))]))
def test_stl_file_is_closed_and_has_the_volume(small, tmp_path, view):
    """The STL file contains the whole part, even if the image shows only a region of the part."""
    small.add("Pocket", POCKET)
    done = vkworkbench.simulate(small.job, view=view)
    done.save_stl(tmp_path / "part.stl")
    mesh = Mesh.Mesh(str(tmp_path / "part.stl"))
    assert mesh.isSolid() and not mesh.hasNonManifolds() and not mesh.hasSelfIntersections()
    whole = done if view == "Top" else vkworkbench.simulate(small.job, view="Top")
    assert mesh.Volume == pytest.approx(whole.zbuffer.part_volume, rel=1e-5 if view == "Top" else 1e-3)


def test_stl_file_shows_the_chosen_step(pocket, tmp_path):
    pocket.at(0).save_stl(tmp_path / "raw.STL")
    assert Mesh.Mesh(str(tmp_path / "raw.STL")).Volume == pytest.approx(pocket.at(0).zbuffer.part_volume, rel=1e-6)
    with pytest.raises(ValueError, match=r"end with \.stl"):
        pocket.save_stl(tmp_path / "part.png")


def test_mesh_is_added_in_one_undo_step(small, pocket):
    undo, before = small.document.UndoCount, len(small.document.Objects)
    added = pocket.add_mesh()
    assert small.document.UndoCount == undo + 1 and len(small.document.Objects) == before + 1
    assert added.Mesh.isSolid() and added.Mesh.Volume == pytest.approx(pocket.zbuffer.part_volume, rel=1e-5)
    small.document.undo()
    assert len(small.document.Objects) == before


def second_job(small, placement=None):
    job = cam("Main.Job").Create("Second", [small.document.getObject("Block")])
    if placement is not None:
        job.Model.Group[0].Placement = placement
    small.document.recompute()
    op = small.add("Bore", BORE, job=False)
    job.Operations.Group += [op]
    small.document.recompute()
    return job


def test_stock_of_the_next_job_is_the_remaining_part(small, pocket):
    done = vkworkbench.simulate(second_job(small), stock=pocket)
    assert done.at(0).zbuffer.part_volume == pytest.approx(pocket.zbuffer.part_volume, rel=1e-3)
    assert done.zbuffer.part_volume < done.at(0).zbuffer.part_volume
    assert "stock-not-moved" not in [remark.code for remark in done.job.remarks]


def test_stock_from_a_simulation_is_turned_with_the_model(small, pocket):
    """After turning, the pocket of the first job is on the lower side, from Z = 0 to 10 mm."""
    turned = FreeCAD.Placement(FreeCAD.Vector(0, 40, 20), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 180))
    done = vkworkbench.simulate(second_job(small, turned), stock=pocket)
    stock = done.job.stock
    assert stock.lower == pytest.approx((-1, -1, -1), abs=0.01) and stock.upper == pytest.approx((61, 41, 21), abs=0.01)
    assert done.at(0).zbuffer.part_volume == pytest.approx(pocket.zbuffer.part_volume, rel=1e-3)
    picture = done.at(0).zbuffer.picture.depth
    assert np.nanmax(picture) - np.nanmin(picture) < 1e-4  # the upper side is flat, without the pocket
    mesh = done.mesh()
    assert mesh.isSolid() and mesh.Volume == pytest.approx(done.zbuffer.part_volume, rel=1e-5)


def test_stock_for_another_model_is_not_moved_and_has_a_remark(small, pocket):
    other = small.document.addObject("Part::Feature", "Other")
    other.Shape = Part.makeBox(50, 30, 10)
    job = cam("Main.Job").Create("Third", [other])
    small.document.recompute()
    job.Operations.Group += [small.add("Bore", BORE, job=False)]
    done = vkworkbench.simulate(job, stock=pocket)
    assert "stock-not-moved" in [remark.code for remark in done.job.remarks]
    with pytest.raises(TypeError, match="stock is a simulation"):
        vkworkbench.simulate(job, stock="raw")
    assert vkworkbench.simulate(job, stock=Stock((0, 0, 0), (9, 9, 9))).at(0).zbuffer.part_volume == pytest.approx(729)
