# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros in examples/macros do what their descriptions promise, on the example and on test jobs."""

import csv
import shutil

import FreeCAD
import Path as CAM
import pytest
from macros.color_by_strategy import color_by_strategy
from macros.compare_versions import compare, old_and_new
from macros.export_for_spreadsheet import export
from macros.folder_to_csv import folder_to_csv
from macros.stop_heavy_job import too_heavy

import vkworkbench
from vkworkbench import core


def state(document):
    return [(obj.Name, obj.Label2, list(obj.State), tuple(obj.PropertiesList)) for obj in document.Objects]


def test_folder_of_documents_is_exported_to_one_table(example_path, tmp_path):
    for name in ("a", "deeper/b"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(example_path, tmp_path / f"{name}.FCStd")
    open_before = set(FreeCAD.listDocuments())
    count = folder_to_csv(tmp_path, tmp_path / "all.csv")
    assert set(FreeCAD.listDocuments()) == open_before
    with open(tmp_path / "all.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == count and count % 2 == 0
    half = [row["strategy"] for row in rows[: count // 2]]
    assert half == [row["strategy"] for row in rows[count // 2 :]] and "zigzag" in half
    assert {row["document"] for row in rows} == {str(tmp_path / "a.FCStd"), str(tmp_path / "deeper" / "b.FCStd")}
    with pytest.raises(ValueError, match="no FreeCAD document"):
        folder_to_csv(tmp_path / "deeper" / "nothing", tmp_path / "none.csv")


def test_document_that_was_open_stays_open_after_export(example, example_path, tmp_path):
    shutil.copy(example_path, tmp_path / "mine.FCStd")
    mine = FreeCAD.openDocument(str(tmp_path / "mine.FCStd"))
    try:
        mine.getObject("Job").Operations.Group[0].Label = "Not saved"
        folder_to_csv(tmp_path, tmp_path / "all.csv")
        assert mine.Name in FreeCAD.listDocuments() and mine.getObjectsByLabel("Not saved")
        assert "Not saved" in (tmp_path / "all.csv").read_text(encoding="utf-8")
    finally:
        FreeCAD.closeDocument(mine.Name)


def test_broken_document_is_left_out_of_the_table(example_path, tmp_path):
    (tmp_path / "a.FCStd").write_text("no document")
    shutil.copy(example_path, tmp_path / "b.FCStd")
    assert folder_to_csv(tmp_path, tmp_path / "all.csv") > 0
    assert "b.FCStd" in (tmp_path / "all.csv").read_text(encoding="utf-8")


def test_toolpaths_get_the_colours_of_their_strategies(example):
    colors = color_by_strategy(example)
    known = {o.name: o.strategy for o in vkworkbench.analyze(example).operations}
    assert colors and len(set(colors.values())) == len({known[name] for name in colors})
    for name, color in colors.items():
        assert known[name].color == "#" + "".join(f"{round(255 * share):02x}" for share in color)


def test_macro_names_a_heavy_job_and_its_simulator(example):
    hangs = [line for line in too_heavy(example, 1e9, 1e15) if "for good" not in line and "hang" not in line]
    assert hangs == []
    label = example.getObject("Job").Label
    slow = too_heavy(example, 0.0, 1e15)
    assert any(line.startswith(f"{label}, z-buffer: ") for line in slow) and any("legacy" in line for line in slow)
    assert len(too_heavy(example, 1e9, 0.0)) == len(slow)


def test_compare_macro_lists_differences_of_two_versions(example, example_path, tmp_path):
    shutil.copy(example_path, tmp_path / "old.FCStd")
    old = FreeCAD.openDocument(str(tmp_path / "old.FCStd"))
    before = state(old)
    try:
        assert compare(old, example) == []
        first, *_, last = example.getObject("Job").Operations.Group
        label = first.Label
        first.Path = CAM.Path(first.Path.Commands[: first.Path.Size // 2])
        last.Label = "Another name"
        found = compare(old, example)
        assert any(line.startswith(f"{label}: length ") and " became " in line for line in found)
        assert sum(line.endswith(": is missing") for line in found) == 1
        assert any(line.startswith("Another name: is new") for line in found)
        assert state(old) == before
    finally:
        FreeCAD.closeDocument(old.Name)


@pytest.mark.parametrize("names", ["ab", "ba"])
def test_active_document_is_the_new_version(names):
    opened = [FreeCAD.newDocument(name) for name in names]
    try:
        assert [document.Name for document in old_and_new()][-1] == opened[1].Name
        FreeCAD.setActiveDocument(opened[0].Name)
        assert [document.Name for document in old_and_new()][-1] == opened[0].Name
    finally:
        for document in opened:
            FreeCAD.closeDocument(document.Name)


@pytest.mark.parametrize(("point", "parted"), [(".", ","), (",", ";")])
def test_exported_table_can_be_read_by_a_spreadsheet(example, tmp_path, point, parted):
    operation = example.getObject("Job").Operations.Group[0]
    operation.Label = "\t=1+1"
    count = export(example, tmp_path / "sheet.csv", point)
    with open(tmp_path / "sheet.csv", newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file, delimiter=parted))
    report = vkworkbench.analyze(example)
    assert len(rows) == count == len(report.operations) and rows[0]["Operation"] == "'\t=1+1"
    for row, o in zip(rows, report.operations):
        assert float(row["Cutting length (m)"].replace(point, ".")) == pytest.approx(o.length / 1000, abs=1e-3)
        assert row["Strategy"] == str(o.strategy)


def test_core_accepts_quantities_of_freecad(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    bit, box = small.controller.Tool, small.job.Stock.Shape.BoundBox
    path = core.linearize(op.Path.Commands, tolerance=FreeCAD.Units.Quantity("0.01 mm"))
    tool, stock = (
        core.Tool("endmill", bit.Diameter),
        core.Stock((box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)),
    )
    assert core.recognize(path, tool_diameter=bit.Diameter) == core.recognize(path, tool_diameter=5)
    assert tool == core.Tool("endmill", 5)
    assert core.simulate(path, tool=tool, stock=stock, view=core.View(width=40, height=30)).traces > 0
    speeds = {"horizontal_rapid": FreeCAD.Units.Quantity("100 mm/s"), "vertical_rapid": small.controller.VertRapid}
    found = core.machining(path, **speeds, top=FreeCAD.Units.Quantity("20 mm"))
    assert found == core.machining(path, horizontal_rapid=100, top=20)
    with pytest.raises(TypeError, match="not Path"):
        core.linearize(op.Path)
