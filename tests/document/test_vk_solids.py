# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stocks, models and tools of FreeCAD are converted into solids and tools of the simulation."""

from math import pi
from types import SimpleNamespace

import FreeCAD
import numpy as np
import Part
import pytest

import vkworkbench
from vkworkbench.core import Cylinder, Mesh, Stock, View, linearize
from vkworkbench.document.job.setting import ShapeCache, placed, read_stock, read_tool, tool_remark
from vkworkbench.document.job.solids import form_of_stock, model_shapes, model_solid, stock_solid
from vkworkbench.language import Unusable, render

VIEW = View((1, 1, -1), 200, 150)
SHAPES = {
    "box": (Part.makeBox(60, 40, 20), Stock),
    "cylinder": (Part.makeCylinder(20, 15, FreeCAD.Vector(30, 20, 2)), Cylinder),
    "lying cylinder": (Part.makeCylinder(8, 50, FreeCAD.Vector(5, 20, 10), FreeCAD.Vector(1, 0, 0)), Mesh),
    "tube": (Part.makeCylinder(20, 15).cut(Part.makeCylinder(10, 15)), Mesh),
    "hollow": (Part.makeBox(60, 40, 20).cut(Part.makeSphere(8, FreeCAD.Vector(30, 20, 10))), Mesh),
    "turned box": (Part.makeBox(30, 20, 10, FreeCAD.Vector(10, 5, 0), FreeCAD.Vector(1, 1, 1)), Mesh),
    "two": (Part.Compound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(20, 0, 0))]), Mesh),
}


def with_stock(small, shape):
    solid = small.document.addObject("Part::Feature", "Solid")
    solid.Shape = shape
    small.job.Stock = solid
    small.document.recompute()
    return small.job


def test_triangles_do_not_depend_on_the_displayed_mesh():
    shown, new = (Part.makeCylinder(8, 50) for _ in range(2))
    shown.tessellate(1e-3)
    finely, newly = (model_solid((shape,)) for shape in (shown, new))
    assert len(finely.triangles) == len(newly.triangles)


def test_wavy_face_is_divided_into_few_triangles():
    """
    The face is a gear's flank with waves 0.01 mm high; adjacent triangles may differ by half a radian.

    `tessellate` would allow a tenth of this angle, and take minutes for thousands of poles.
    """
    turns = np.linspace(0, 2 * pi, 500, endpoint=False)
    radius = 20 + 0.01 * np.cos(100 * turns)
    points = [FreeCAD.Vector(r * np.cos(t), r * np.sin(t), 0) for r, t in zip(radius, turns)]
    curve = Part.BSplineCurve()
    curve.interpolate(points, PeriodicFlag=True)
    gear = Part.Face(Part.Wire(curve.toShape())).extrude(FreeCAD.Vector(0, 0, 6))
    model = model_solid((gear,))
    assert np.allclose([*model.lower, *model.upper], [-20, -20, 0, 20, 20, 6], atol=0.03)
    assert len(model.triangles) < len(gear.copy().tessellate(0.01)[1]) / 2


@pytest.mark.parametrize("name", SHAPES)
def test_shape_of_a_stock_decides_the_kind_of_solid(small, name):
    shape, kind = SHAPES[name]
    job = with_stock(small, shape)
    solid, remark = stock_solid(job, read_stock(job))
    assert type(solid) is kind and remark is None
    assert np.allclose([*solid.lower, *solid.upper], [*read_stock(job).lower, *read_stock(job).upper], atol=0.05)
    small.add("Beside", [("G0", {"X": -50.0, "Y": 0.0, "Z": 30.0}), ("G1", {"X": -60.0, "F": 5.0})])
    done = vkworkbench.simulate(small.job, view=VIEW)
    assert done.zbuffer.part_volume == pytest.approx(shape.Volume, rel=0.01)
    assert stock_solid(job, read_stock(job))[0] is solid


@pytest.mark.parametrize(
    "name, form",
    [("box", ()), ("cylinder", ("Cylinder",)),
     ("two", ("Mesh", *(f"{1.0037 * measure:.4e}" for measure in (2 * 10**3, 2 * 600, 15, 5, 5))))],
)  # fmt: skip
def test_form_of_a_stock_is_empty_for_a_box_only(small, name, form):
    """
    The expected form of "two" contains the volume, area and centre of two cubes of 10 mm that are 20 mm apart.

    The factor 1.0037 changes the expected values, so that none is halfway between two rounded values.
    """
    job = with_stock(small, SHAPES[name][0])
    assert form_of_stock(job, read_stock(job)) == form


def test_stock_without_a_volume_is_simulated_as_its_box(small, zigzag_commands):
    job = with_stock(small, Part.makeBox(60, 40, 20).Shells[0])
    small.add("Rows", zigzag_commands)
    (row,) = vkworkbench.analyze(job).operations
    assert "simulated as the box around it" in row.error and row.estimate.traces > 0
    assert [remark.code for remark in vkworkbench.simulate(job, view=VIEW).job.remarks] == ["stock-as-box"]


def test_estimate_for_a_cylinder_uses_its_round_outline(small, zigzag_commands):
    small.add("Rows", zigzag_commands)
    job = with_stock(small, SHAPES["cylinder"][0])
    estimate = vkworkbench.analyze(job).operations[0].estimate
    assert estimate.dexels == pytest.approx(pi / 4 * 600 * 600, rel=0.02)


def test_model_of_a_job_is_read(small):
    model = model_solid(model_shapes(small.job))
    assert np.allclose([*model.lower, *model.upper], [0, 0, 0, 60, 40, 20])
    small.job.Model.Group[0].Objects[0].Height = 25
    small.document.recompute()
    assert model_solid(model_shapes(small.job)).upper[2] == pytest.approx(25)
    small.job.Model.Group = []
    assert model_solid(model_shapes(small.job)) is None


def test_wire_beside_a_solid_is_not_part_of_the_model(small):
    wire = small.document.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([FreeCAD.Vector(x, 0, 90) for x in (0, 10, 30)])
    small.job.Model.Group = [*small.job.Model.Group, wire]
    assert model_solid(model_shapes(small.job)).upper[2] == pytest.approx(20)
    small.job.Model.Group = [wire]
    assert model_solid(model_shapes(small.job)) is None


def operation(**bit):
    bit = SimpleNamespace(Diameter=10.0, Label="T", **bit)
    return SimpleNamespace(Name="Op", ToolController=SimpleNamespace(Label="TC", Tool=bit))


def test_chamfer_mills_and_engravers_have_a_flat_tip():
    for shape in ("chamfer", "v-bit", "engraver"):
        tool = read_tool(operation(ShapeName=shape, CuttingEdgeAngle=90.0, TipDiameter=4.0))
        assert (tool.shape, tool.tip) == ("vbit", 2.0)
        assert tool.height([1, 2, 5]) == pytest.approx([0, 0, 3])
    assert read_tool(operation(ShapeName="vbit", CuttingEdgeAngle=60.0)).tip == 0


@pytest.mark.parametrize("measures, corner", [({"FlatRadius": 3.0}, 2.0), ({"CornerRadius": 1.5}, 1.5), ({}, 0.0)])
def test_corner_radius_of_bull_nose_is_read_in_all_versions(measures, corner):
    """The tool's diameter is 10 mm. Before FreeCAD 1.1, a bull-nose tool has the radius of its flat part."""
    tool = read_tool(operation(ShapeName="bullnose", **measures))
    assert (tool.shape, tool.corner_radius) == ("bullnose", corner)


@pytest.mark.parametrize(
    "file, shape, exact",
    [
        ("C:\\Program Files\\FreeCAD 1.0\\Mod\\CAM\\Tools\\Shape\\ballend.fcstd", "ballend", True),
        ("/usr/share/freecad/Mod/Path/Tools/Shape/endmill.fcstd", "endmill", True),
        ("v-bit.fcstd", "vbit", True),
        ("mine.fcstd", "endmill", False),
        ("", "endmill", False),
        (None, "endmill", False),
    ],
)
def test_tool_shape_comes_from_its_file_name(file, shape, exact):
    of = operation(ShapeType="Custom", ShapeID=file)
    assert read_tool(of).shape == shape and (tool_remark(of) is None) == exact


@pytest.mark.parametrize("far, usable", [(0.9e6, True), (1.1e6, False), (float("nan"), False)])
def test_operation_placed_over_a_kilometre_away_is_refused(far, usable):
    path = linearize([("G0", {"X": 1.0, "Y": 2.0, "Z": 3.0}), ("G1", {"X": 4.0})])
    place = FreeCAD.Placement(FreeCAD.Vector(0, far, 0), FreeCAD.Rotation())
    if usable:
        assert placed(path, place).points[:, 1] == pytest.approx(2 + far)
    else:
        with pytest.raises(Unusable, match="placement"):
            placed(path, place)


@pytest.mark.parametrize(
    "shape, simulated, told",
    [("dovetail", "endmill", "largest"), ("SlotCutter", "endmill", "largest"), ("thread-mill", "endmill", "largest"),
     ("TaperedBallNose", "ballend", "ball end"), ("slittingsaw", "endmill", "largest"), ("endmill", "endmill", None),
     ("ballend", "ballend", None), ("drill", "drill", None), ("chamfer", "vbit", None)],
)  # fmt: skip
def test_inexact_tool_shape_has_a_remark(shape, simulated, told):
    op = operation(ShapeName=shape)
    assert read_tool(op).shape == simulated
    remark = tool_remark(op)
    assert (remark is None) == (told is None)
    if told:
        assert render(remark).startswith("TC is simulated only approximately") and told in render(remark)


def test_results_of_the_last_used_shapes_are_kept():
    kept, asked = ShapeCache(3), []

    def found(number):
        return kept.of(shapes[number], lambda: asked.append(number) or f"of {number}")

    shapes = [Part.makeBox(1, 1, 1) for _ in range(4)]
    for number in (0, 1, 2, 0, 1, 2):
        assert found(number) == f"of {number}"
    assert asked == [0, 1, 2]
    found(0)
    found(3)  # shape 3 replaces shape 1 in the cache of three shapes, because shape 0 was used later
    assert [found(number) for number in (0, 2, 3)] == ["of 0", "of 2", "of 3"] and asked == [0, 1, 2, 3]
    assert found(1) == "of 1" and asked == [0, 1, 2, 3, 1]
