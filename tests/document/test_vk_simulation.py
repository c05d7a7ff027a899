# SPDX-License-Identifier: LGPL-2.1-or-later
"""`simulate`: the simulated operations, their order, tools and stock, and the jobs that it refuses."""

import csv
import json
import signal
import time

import FreeCAD
import numpy as np
import Part
import Path
import pytest
from cases import first_everywhere
from traps import environment_of_traps, lay_traps

import vkworkbench
from vkworkbench import preferences, worker
from vkworkbench.core import Tool, View
from vkworkbench.core.zbuffer import OverBudget, memory_needed
from vkworkbench.document.job.listing import Listing
from vkworkbench.document.simulation import allowed_depth
from vkworkbench.document.simulation.copy import copy_job, read_job
from vkworkbench.document.simulation.simulate import simulate_read
from vkworkbench.language import Message, Unusable, render
from vkworkbench.report import Cancelled
from vkworkbench.worker import Worker, WorkerDied

VIEW = View((0, 0, -1), 120, 80)


def slot(y, z=15.0):
    """Return the commands of a slot along X, 50 mm long."""
    return [
        ("G0", {"X": 5.0, "Y": y, "Z": 30.0}),
        ("G1", {"Z": z, "F": 5.0}),
        ("G1", {"X": 55.0, "F": 10.0}),
        ("G0", {"Z": 30.0}),
    ]


def test_job_is_simulated_in_the_order_of_its_operations(small):
    first, second = small.add("First", slot(10.0)), small.add("Second", slot(12.0))
    for what in (None, small.document, small.job, [second, first]):
        done = vkworkbench.simulate(what, view=VIEW)
        assert [o.label for o in done.job.operations] == ["First", "Second"]
        assert done.trajectories == 6 and done.step == 6 and done.job.remarks == ()
    # The second slot overlaps the first slot by 3 of 5 mm. The second slot adds an area of 100 mm² and, at its ends,
    # the part of a disc outside another disc at a distance of 2 mm.
    fine = vkworkbench.simulate(small.job, view=View((0, 0, -1), 500, 340))
    volumes = [fine.at(3).zbuffer.chip_volume, fine.zbuffer.chip_volume]
    assert volumes == pytest.approx([6 * (250 + 19.6), 6 * (250 + 19.6 + 100 + 9.7)], rel=0.02)
    assert done.source(1)[0].name == first.Name and done.source(1)[1] == 2
    assert done.source(4)[0].name == second.Name and done.source(4)[1] == 2
    assert [o.label for o in vkworkbench.simulate(second, view=VIEW).job.operations] == ["Second"]


def test_repr_of_a_simulation_is_one_line(small):
    small.add("First", slot(10.0))
    assert repr(vkworkbench.simulate(view=VIEW).at(1)) == "<Simulation of 1 operation, 1 of 3 trajectories>"


def test_simulation_does_not_change_the_document(small):
    small.add("First", slot(10.0))
    before = [(obj.Name, sorted(obj.PropertiesList), list(obj.State)) for obj in small.document.Objects]
    vkworkbench.simulate(small.job, view=VIEW)
    assert [(obj.Name, sorted(obj.PropertiesList), list(obj.State)) for obj in small.document.Objects] == before


def test_operation_that_is_not_posted_is_not_simulated(small):
    base = small.add("Base", slot(10.0))
    dressup = small.add("Dress-up", slot(12.0))
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = base
    off = small.add("Off", slot(30.0))
    off.Active = False
    done = vkworkbench.simulate(small.job, view=VIEW)
    assert [o.label for o in done.job.operations] == ["Dress-up"]
    assert [o.label for o in vkworkbench.simulate(base, view=VIEW).job.operations] == ["Base"]


def test_view_comes_from_preferences_or_argument(small, monkeypatch):
    small.add("First", slot(10.0))
    assert vkworkbench.simulate(small.job).zbuffer.frame.width == 800
    seen = vkworkbench.simulate(small.job, view="Isometric").zbuffer.frame
    assert seen.direction * np.sqrt(3) == pytest.approx([-1, 1, -1]) and seen.height == 600
    with pytest.raises(TypeError, match="not tuple"):
        vkworkbench.simulate(small.job, view=(0, 0, -1))
    with pytest.raises(ValueError, match="not nan"):
        vkworkbench.simulate(small.job, memory_budget=float("nan"))
    with pytest.raises(ValueError, match=r"Sideways.*Isometric"):
        vkworkbench.simulate(small.job, view="Sideways")


def test_default_image_is_the_finest_that_fits(small):
    small.add("First", slot(10.0))
    job, usual = read_job(small.job), preferences.read().view
    needed = memory_needed(job.cuts, stock=job.stock, view=usual)
    for view in (None, "Isometric"):
        done = vkworkbench.simulate(small.job, view=view, memory_budget=needed / 2)
        frame, (remark,) = done.zbuffer.frame, done.job.remarks
        assert 0.4 < frame.width / usual.width < 0.8 and frame.height == pytest.approx(frame.width * 3 / 4, abs=1)
        assert (
            render(remark) == f"{frame.width} x {frame.height} pixels of {frame.pixel:.2f} mm, limited by the memory."
        )
    assert vkworkbench.simulate(small.job, memory_budget=2 * needed).job.remarks == ()
    with pytest.raises(OverBudget, match=r"Choose an image of 4\d\d x \d+ pixels"):
        vkworkbench.simulate(small.job, view=usual, memory_budget=needed / 2)
    # With the memory budget of the test, the image would be too coarse to be useful, so the simulation is refused.
    with pytest.raises(OverBudget) as refused:
        vkworkbench.simulate(small.job, memory_budget=17e6)
    assert 1 < refused.value.size[0] < usual.width / 3


def test_placement_of_an_operation_moves_its_cuts(small):
    op = small.add("First", slot(10.0))
    op.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 20, 0), FreeCAD.Rotation())
    (cut,) = vkworkbench.simulate(small.job, view=VIEW).job.cuts
    assert (cut.toolpath.points[:, 1] == 30).all()


@pytest.mark.usefixtures("checked_coarsely")
def test_operation_without_tool_is_left_out_with_a_remark(small):
    small.add("Fine", slot(10.0))
    small.add("No tool", slot(20.0), controller=None)
    small.add("Words only", [("(nothing)", {})])
    done = vkworkbench.simulate(small.job, view=VIEW)
    assert [o.label for o in done.job.operations] == ["Fine"]
    (remark,) = done.job.remarks
    assert remark.codes == ("of", "no-tool") and remark.arguments["label"] == "No tool"
    assert "No tool: " in str(done.facts())


@pytest.mark.long
def test_impossible_simulation_is_refused(small):
    with pytest.raises(Unusable, match="nothing to simulate"):
        vkworkbench.simulate(small.job)
    op = small.add("First", slot(10.0))
    with pytest.raises(OverBudget, match=r"limit\. Simulate fewer operations at a time"):
        vkworkbench.simulate(op, memory_budget=1e6)
    with pytest.raises(TypeError, match="only a document, a job or operations have toolpaths, not int"):
        vkworkbench.simulate(7)
    with pytest.raises(ValueError, match="memory_budget must be a number of bytes, at least 0, not 'much'"):
        vkworkbench.simulate(op, memory_budget="much")
    with pytest.raises(TypeError, match="view is a View or the name of a direction, not int"):
        vkworkbench.simulate(op, view=1)
    with pytest.raises(TypeError, match="going_on is a function, not int"):
        vkworkbench.simulate(op, view=VIEW, going_on=1)
    done = vkworkbench.simulate(op, view=VIEW)
    for use, told in (
        (lambda: done.facts(tolerance="much"), "tolerance must be a length of at least 0 mm, not 'much'"),
        (lambda: done.at(1.5), "step must be a whole number, 0 to"),
        (lambda: done.source("first"), "trajectory must be a whole number, not 'first'"),
        (lambda: done.save_png(1), "path is the name of a file, not int"),
        (lambda: done.facts().to_csv(1), "path is the name of a file, not int"),
        (lambda: done.facts().to_json(1), "path is the name of a file, not int"),
        (lambda: done.facts().trajectories_to_csv(1), "path is the name of a file, not int"),
    ):
        with pytest.raises((ValueError, TypeError), match=f"^{told}"):
            use()
    small.job.Stock = None
    with pytest.raises(Unusable, match="no stock"):
        vkworkbench.simulate(op)
    FreeCAD.closeDocument(small.document.Name)
    with pytest.raises(ValueError, match="no document is open"):
        vkworkbench.simulate()


def test_operations_of_two_jobs_are_refused(small):
    small.add("First", slot(10.0))
    other = type(small)()
    try:
        other.add("Other", slot(10.0))
        with pytest.raises(Unusable, match="several jobs"):
            vkworkbench.simulate([small.job, other.job])
    finally:
        FreeCAD.closeDocument(other.name)


def test_simulation_can_be_stopped(small):
    small.add("First", slot(10.0))
    shares = []
    vkworkbench.simulate(small.job, going_on=shares.append)
    assert shares == sorted(shares) and shares[-1] > 0.5

    def stop(share):
        raise vkworkbench.Cancelled("enough")

    with pytest.raises(vkworkbench.Cancelled):
        vkworkbench.simulate(small.job, going_on=stop)


def test_operations_of_the_example_cut_one_part_in_turn(example):
    done = vkworkbench.simulate(example, view=View((0, 0, -1), 200, 150))
    labels = [o.label for o in done.job.operations]
    assert labels[0] == "Face" and len(labels) >= 7 and "Cut out" not in labels
    moments = [done.at(int(k)).zbuffer.part_volume for k in done.zbuffer.cuts.first]
    assert moments[0] == pytest.approx(np.prod(done.job.stock.upper - done.job.stock.lower), rel=0.02)
    assert all(later < before for before, later in zip(moments, moments[1:]))


def test_image_of_the_part_shows_the_chosen_step(small, tmp_path):
    small.add("First", slot(10.0))
    done = vkworkbench.simulate(small.job, view=VIEW)
    image, before = done.image(), done.at(0).image()
    assert image.shape == before.shape == (80, 120, 3) and image.dtype == np.uint8
    changed = (image != before).any(axis=-1)
    row, column = np.nonzero(changed)
    # The changed pixels show the slot, which is near the front and extends along X.
    assert row.min() > 40 and column.max() - column.min() > 90
    done.save_png(tmp_path / "part.png")
    assert (tmp_path / "part.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(OSError):
        done.save_png(tmp_path / "nowhere" / "part.png")
    done.save_png(str(tmp_path / "PART.PNG"))
    for name in ("part.jpg", "part", ".png"):  # file names without the suffix .png; a lone ".png" is no suffix
        with pytest.raises(ValueError, match=r"must end with \.png"):
            done.save_png(tmp_path / name)
    assert not (tmp_path / "part.jpg").exists()


def test_simulation_facts_contain_a_fault_of_each_kind(small, tmp_path):
    """The slot has a rapid that cuts, a gouge and a plunge that is too fast; elsewhere 1 mm of stock is left."""
    small.controller.VertFeed, small.controller.HorizFeed = "2 mm/s", "10 mm/s"
    small.document.recompute()
    small.add("=Fault", [
        ("G0", {"X": 10.0, "Y": 10.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0}), ("G0", {"X": 30.0}), ("G0", {"Z": 30.0}),
    ])  # fmt: skip
    found = vkworkbench.simulate(small.job, view=View((0, 0, -1), 300, 200)).facts()
    ((label, facts),) = found.operations
    assert label == "=Fault" and facts.cutting_length == 15 and facts.air_length == 0
    (crash,), (plunge,), (gouge,) = facts.crashes, facts.fast_plunges, facts.gouges
    assert crash.source.command == 2 and crash.depth == pytest.approx(6) and (plunge.feed, plunge.allowed) == (5, 2)
    assert gouge.depth == pytest.approx(5)
    (left,) = found.job.left
    assert left.depth == pytest.approx(1) and facts.left == ()
    assert "=Fault" in str(found) and "5.0 mm" in str(found)

    found.to_csv(tmp_path / "facts.csv")
    found.to_json(tmp_path / "facts.json")
    with open(tmp_path / "facts.csv", newline="", encoding="utf-8") as file:
        row, job = csv.DictReader(file)
    assert job["verdict"] and job["crashes"] == "1"
    data = json.loads((tmp_path / "facts.json").read_text(encoding="utf-8"))
    assert row["label"] == "'=Fault" and (row["crashes"], row["first_crash_command"], row["fast_plunges"]) == (
        "1",
        "2",
        "1",
    )
    assert float(row["removed_volume"]) == data["operations"][0]["removed_volume"] == facts.removed_volume
    assert data["operations"][0]["crashes"][0]["place"] == list(crash.place)
    assert data["job"]["left"][0]["command"] is None and float(row["deepest_gouge"]) == gouge.depth

    found.trajectories_to_csv(tmp_path / "trajectories.csv")
    with open(tmp_path / "trajectories.csv", newline="", encoding="utf-8") as file:
        moves = list(csv.DictReader(file))
    assert [move["label"] for move in moves] == ["'=Fault"] * len(moves)
    assert sum(float(move["removed_volume"]) for move in moves) == pytest.approx(facts.removed_volume)
    assert [move["command"] for move in moves if move["rapid"] == "True" and float(move["removed_volume"]) > 0] == ["2"]


@pytest.mark.parametrize("depth, told", first_everywhere([(0.15, True), (0.05, False), (0.25, True)]))
def test_only_cuts_deeper_than_the_tolerance_are_gouges(small, depth, told):
    """The top of the model is at Z = 20 mm, and the slot is `depth` deeper."""
    small.add("Deep", slot(10.0, z=20 - depth))
    done = vkworkbench.simulate(small.job, view=View((0, 0, -1), 300, 200))
    assert bool(done.facts().job.gouges) is told
    assert bool(done.facts(tolerance=0.2).job.gouges) is (depth > 0.2)


def test_move_times_use_feed_or_rapid_speed(small):
    """The feed moves are 15 mm at 5 mm/s and 60 mm at 10 mm/s, the rapids 15 mm up at 30 mm/s and 15 mm at 50 mm/s."""
    sheet = small.job.SetupSheet
    sheet.HorizRapid, sheet.VertRapid = "50 mm/s", "30 mm/s"
    small.document.recompute()
    small.add("Times", [
        ("G0", {"X": 0.0, "Y": 0.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0}), ("G1", {"X": 60.0, "F": 10.0}),
        ("G0", {"Z": 30.0}), ("G0", {"Y": 15.0}),
    ])  # fmt: skip
    assert vkworkbench.simulate(small.job, view=VIEW).job.seconds == pytest.approx([3.0, 6.0, 0.5, 0.3])


def test_simulation_has_remarks_on_ignored_commands(small):
    """
    An operation has a remark if its result is unknown or incomplete.

    Examples: an unknown code, a rotary axis that turns while the tool cuts, and a path without usable numbers.
    """
    small.add("Odd", [*slot(10.0), ("G999", {})])
    small.add("Turned", [("G0", {"X": 5.0, "Y": 20.0, "Z": 30.0}), ("G1", {"Z": 10.0}), ("G1", {"X": 50.0, "A": 90.0})])
    lost = small.add("Lost", [("G1", {"X": float("nan")}), ("G1", {"X": 1e30})])
    small.add("Silent", [("(nothing)", {})])
    done = vkworkbench.simulate(small.job, view=VIEW)
    assert [operation.label for operation in done.job.operations] == ["Odd"]
    odd, turned, nowhere = map(render, done.job.remarks)
    assert odd.startswith("Odd: ") and "G999" in odd
    assert turned.startswith("Turned: ") and "The tool's path is unknown here." in turned
    assert nowhere.startswith("Lost: ") and "X words that are not usable numbers" in nowhere
    with pytest.raises(Unusable, match=r"Lost: Command 1 \(first of 2\): X words that are not usable numbers"):
        vkworkbench.simulate(lost)


@pytest.mark.long
@pytest.mark.usefixtures("checked_coarsely")
def test_simulated_faults_are_not_shown_for_another_toolpath(small):
    first, second = small.add("First", slot(10.0)), small.add("Second", slot(20.0))
    found = vkworkbench.simulate(small.job, view=VIEW).facts()
    (total,) = vkworkbench.analyze(small.job).with_facts(found).totals
    assert total.simulated is found.job
    first.Path = second.Path
    report = vkworkbench.analyze(small.job).with_facts(found)
    assert [row.simulated is None for row in report.operations] == [True, False]
    assert report.totals[0].simulated is None


@pytest.mark.long
@pytest.mark.usefixtures("checked_coarsely")
def test_report_contains_simulation_findings(small, tmp_path):
    slot = small.add("Slot", [("G0", {"X": 10.0, "Y": 10.0, "Z": 30.0}), ("G1", {"Z": 15.0}), ("G0", {"X": 30.0})])
    small.add("More", [("G0", {"X": 10.0, "Y": 20.0, "Z": 30.0}), ("G1", {"Z": 16.0}), ("G1", {"X": 30.0})])
    before = vkworkbench.analyze(small.job)
    found = vkworkbench.simulate(small.job, view=View((0, 0, -1), 150, 100)).facts()
    report = before.with_facts(found)
    assert [o.simulated for o in report.operations] == [facts for _, facts in found.operations]
    (total,) = report.totals
    assert total.simulated is found.job and before.totals[0].simulated is None
    part = vkworkbench.simulate(slot, view=View((0, 0, -1), 150, 100)).facts()
    partly = before.with_facts(part)
    assert [o.simulated is None for o in partly.operations] == [False, True] and partly.totals[0].simulated is None
    with pytest.raises(TypeError, match=r"what a simulation's facts\(\) returns, not Simulation"):
        before.with_facts(vkworkbench.simulate(slot, view=View((0, 0, -1), 15, 10)))

    lines = {}
    for name, one in (("before", before), ("after", report)):
        one.to_csv(tmp_path / f"{name}.csv")
        one.to_json(tmp_path / f"{name}.json")
        with open(tmp_path / f"{name}.csv", newline="", encoding="utf-8") as file:
            lines[name] = list(csv.DictReader(file))
    # The CSV file has the same columns before and after a simulation.
    assert list(lines["before"][0]) == list(lines["after"][0])
    assert lines["before"][0]["simulated_crashes"] == "" and lines["after"][0]["simulated_crashes"] == "1"
    volume = found.operations[1][1].removed_volume
    assert float(lines["after"][1]["simulated_removed_volume"]) == volume > 0
    data = json.loads((tmp_path / "after.json").read_text(encoding="utf-8"))
    assert data["operations"][1]["simulated"]["removed_volume"] == volume
    assert data["operations"][0]["simulated"]["crashes"][0]["command"] == 2
    assert data["totals"][0]["simulated"]["removed_volume"] == pytest.approx(found.job.removed_volume)
    assert json.loads((tmp_path / "before.json").read_text(encoding="utf-8"))["operations"][0]["simulated"] is None


@pytest.mark.long
def test_simulated_example_has_no_fault(example):
    found = vkworkbench.simulate(example).facts()
    assert found.job.crashes == found.job.fast_plunges == found.job.gouges == ()
    assert all(facts.removed_volume > 100 and 0 <= facts.air_length_share < 0.5 for _, facts in found.operations)
    assert sum(facts.removed_volume for _, facts in found.operations) == pytest.approx(found.job.removed_volume)
    # Stock is left in sharp inside corners of the model, in corners that facing leaves, at the ends of the drilled
    # holes (the drill's tip stops at the model's bottom), and in the dish if no operation cuts the dish.
    dish = "Dish" in [label for label, _ in found.operations]
    area = sum(left.area for left in found.job.left)
    assert 120 < area < 180 if dish else 1060 < area < 1120


def test_job_is_copied_and_read_operation_by_operation(small):
    for label, y in (("First", 10.0), ("Second", 20.0)):
        small.add(label, [("G0", {"X": 5.0, "Y": y, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 10.0}), ("G1", {"X": 55.0})])
    copy = copy_job(small.job)
    copying, reading = copy.copying(), copy.read()
    next(copying)
    assert next(reading).operation.label == "First"
    second = small.document.getObjectsByLabel("Second")[0]
    second.Path = type(second.Path)(second.Path.Commands[:-1])
    next(copying)
    assert len(next(reading).cut.toolpath) == 1
    assert next(copying, "no more") == "no more" == next(reading, "no more")


def test_reading_a_job_can_be_cancelled(small):
    small.add("First", [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 10.0})])
    looks = []

    def going_on():
        looks.append(1)
        if len(looks) > 2:
            raise Cancelled("given up")

    with pytest.raises(Cancelled):
        next(copy_job(small.job).read(going_on))


def test_copying_a_job_ends_if_an_operation_was_deleted(small):
    small.add("First", [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 10.0})])
    small.add("Second", [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 10.0})])
    copying = copy_job(small.job).copying()
    next(copying)
    small.document.removeObject(small.document.getObjectsByLabel("Second")[0].Name)
    with pytest.raises(ReferenceError):
        next(copying)


@pytest.mark.parametrize("comment", ["(a comment)", "(two\nlines)", "(ä, ö)"])
def test_line_of_a_listing_is_the_code_of_its_command(comment):
    lines = ["G0 X1 Y2", "G1 F3 Z-1.05", "G2 I0 J-10 X100.000001 Y0.5"]
    shown = ["G0 X1 Y2", "G1 F180 Z-1.05", "G2 I0 J-10 X100 Y0.5"]
    path = Path.Path([Path.Command(line) for line in (comment, *lines)])
    listing = Listing(path.toGCode(), path.Commands)
    expected = [path.Commands[0].toGCode().replace("\n", " "), *shown]
    assert [listing[number] for number in range(len(listing))] == expected
    with pytest.raises(IndexError):
        listing[4]


def test_worker_runs_in_a_python_that_freecad_finds():
    """The worker's Python must have the same numpy as FreeCAD; with another numpy the worker would not start."""
    one = Worker(len)
    assert one("abc") == 3
    one.end()
    assert worker.processes() >= 1


def test_worker_runs_no_code_from_a_hostile_folder(monkeypatch, tmp_path):
    ran = lay_traps(tmp_path / "traps")
    for name, value in environment_of_traps(tmp_path / "traps").items():
        monkeypatch.setenv(name, value)
    monkeypatch.chdir(tmp_path / "traps")
    one = Worker(len)
    assert one("abc") == 3 and ran() == []
    one.end()


@pytest.mark.skipif(not hasattr(signal, "SIGPIPE"), reason="there is no such signal")
def test_dead_worker_does_not_end_freecad():
    """
    A write to a dead worker raises the signal SIGPIPE, which can end FreeCAD.

    Python's own programs ignore SIGPIPE, but a Python embedded in FreeCAD may not.
    """
    before = signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    try:
        one = Worker(len)
        one.get_ready()
        one.kill()
        with pytest.raises(WorkerDied):
            one(b"x" * 10_000_000)
        assert not one.lives and signal.SIGPIPE not in signal.pthread_sigmask(signal.SIG_BLOCK, [])
    finally:
        signal.signal(signal.SIGPIPE, before)


def test_simulation_shared_with_workers_gives_the_same_result(small, monkeypatch):
    small.add("First", slot(10.0))
    small.add("Second", slot(12.0))
    view = View((1, 1, -1), 300, 200)
    monkeypatch.setattr(worker, "processes", lambda: 1)
    alone = vkworkbench.simulate(small.job, view=view).zbuffer.records
    monkeypatch.setattr(worker, "processes", lambda: 2)
    monkeypatch.setattr("vkworkbench.core.zbuffer.simulator.sharing._ALONE", -1.0)
    helped, original = [], Worker.__call__
    monkeypatch.setattr(Worker, "__call__", lambda self, region: helped.append(region) or original(self, region))
    began = time.monotonic()

    def going_on(share):
        while share and not helped and time.monotonic() < began + 60:
            time.sleep(0.01)

    shared = vkworkbench.simulate(small.job, view=view, going_on=going_on).zbuffer.records
    assert helped
    for part in ("index", "entry", "far", "owner"):
        assert np.array_equal(getattr(alone, part), getattr(shared, part))


def holds(copy, changed=()):
    """Return whether the job in the document still equals its copy."""
    steps = copy.comparing(set(changed))
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


def larger_stock(small):
    small.job.Stock.ExtZpos = 5.0


def without_stock(small):
    small.job.Stock = None


def larger_tool(small):
    small.controller.Tool.Diameter = 6.0
    small.document.recompute()


def quicker_rapids(small):
    small.job.SetupSheet.HorizRapid = "50 mm/s"
    small.document.recompute()


def moved(small):
    small.document.getObjectsByLabel("First")[0].Placement.Base.y = 2.0


def another_path(small):
    small.document.getObjectsByLabel("First")[0].Path = Path.Path([Path.Command("G1 X5 Y5 Z5 F5")])


def other_order(small):
    small.job.Operations.Group = small.job.Operations.Group[::-1]


def one_more(small):
    small.add("Third", slot(30.0))


def one_less(small):
    small.document.removeObject(small.document.getObjectsByLabel("Second")[0].Name)


def switched_off(small):
    small.document.getObjectsByLabel("Second")[0].Active = False


def another_model(small):
    small.document.Block.Height = 21
    small.document.recompute()


def another_model_in_the_same_stock(small):
    part = small.document.addObject("Part::Feature", "Part")
    part.Shape = small.document.Block.Shape.cut(Part.makeBox(10, 10, 10))
    small.job.Model.Group = [part]
    small.document.recompute()


def one_more_body_of_the_model(small):
    small.job.Model.Group += [small.document.addObject("Part::Box", "Within")]
    small.document.recompute()


CHANGES = [larger_stock, without_stock, larger_tool, quicker_rapids, moved, another_path, other_order, one_more, one_less,
           switched_off, another_model, another_model_in_the_same_stock, one_more_body_of_the_model]  # fmt: skip


@pytest.mark.parametrize("change", CHANGES)
def test_copied_job_differs_after_a_change_of_the_document(small, change):
    for label, y in (("First", 10.0), ("Second", 20.0)):
        small.add(label, slot(y))
    copy = copy_job(small.job)
    for _ in copy.copying():
        pass
    job = copy.job(copy.read())
    names = [obj.Name for obj in small.job.Operations.Group]
    assert [operation.name for operation in job.operations] == names and holds(copy, names)
    small.document.openTransaction("change")
    change(small)
    small.document.commitTransaction()
    small.document.recompute()
    assert not holds(copy, names)
    small.document.undo()
    assert holds(copy, names)


def test_copied_job_differs_after_a_change_of_one_model_body(small):
    small.add("First", slot(10.0))
    one_more_body_of_the_model(small)
    copy = copy_job(small.job)
    for _ in copy.copying():
        pass
    assert holds(copy)
    small.document.Within.Height = 5
    small.document.recompute()
    assert not holds(copy)


def test_only_paths_named_as_changed_are_compared(small):
    op = small.add("First", slot(10.0))
    copy = copy_job(small.job)
    for _ in copy.copying():
        pass
    list(copy.read())
    another_path(small)
    assert holds(copy) and not holds(copy, [op.Name])


def test_repeated_simulation_finds_the_same_objects_again(small):
    first, second = small.add("First", slot(10.0)), small.add("Second", slot(20.0))
    one, job, all_of_it = copy_job([second]), copy_job(small.job), copy_job(small.document)
    small.add("Third", slot(30.0))
    for copy, expected in (
        (one, ["Second"]),
        (job, ["First", "Second", "Third"]),
        (all_of_it, ["First", "Second", "Third"]),
    ):
        assert list(copy_job(copy.asked()).labels) == expected
    small.document.removeObject(second.Name)
    assert list(copy_job(one.asked()).labels) == ["First", "Third"] and first.Label == "First"


def test_thread_that_simulates_does_not_call_freecad(small, monkeypatch):
    small.add("First", slot(10.0))
    job = read_job(small.job)
    monkeypatch.setattr(FreeCAD, "ParamGet", None)
    assert simulate_read(job, VIEW, 1e8).trajectories == 3


def test_feeds_in_a_listing_are_in_mm_per_min(small):
    own = Path.Path(
        [Path.Command(line) for line in ("(F20.000000)", "G1 F20 X133.388398 Y-0.0001", "G1 F3.3333333 Z0.001")]
    )
    listing = Listing(own.toGCode(), own.Commands)
    assert [listing[k] for k in range(3)] == ["(F20.000000)", "G1 F1200 X133.388 Y0", "G1 F200 Z0.001"]
    # Feeds of imported paths are in mm/min, as in their file; an operation of FreeCAD has F20 (mm/s) for the same feed.
    small.add("Own", [("G1", {"X": 5.0, "Y": 5.0, "Z": 15.0}), ("G1", {"X": 55.0, "F": 20.0})])
    small.add("Imported", [("G1", {"X": 5.0, "Y": 5.0, "Z": 15.0}), ("G1", {"X": 55.0, "F": 1200.0})])
    job = read_job(small.job)
    assert [listing[1] for listing in job.listings] == ["G1 F1200 X55"] * 2
    assert [cut.toolpath.feed[-1] for cut in job.cuts] == pytest.approx([20.0, 20.0])


@pytest.mark.long
def test_simulation_facts_are_the_same_from_every_view(small):
    """The job is a rapid plunge, 3 mm deep, with a tool thinner than the pixels of the view."""
    small.controller.Tool.Diameter = 0.5
    small.add("Thin", [("G0", {"X": 10.3, "Y": 10.3, "Z": 30.0}), ("G0", {"Z": 17.0}), ("G0", {"Z": 30.0})])
    found = [vkworkbench.simulate(small.job, view=View(way, 30, 20)).facts() for way in ((0, 0, -1), (-1, 1, -1))]
    assert [[crash.source.command for crash in one.job.crashes] for one in found] == [[1]] * 2
    assert [[gouge.depth for gouge in one.job.gouges] for one in found] == [[pytest.approx(3)]] * 2
    assert len({str(one) for one in found}) == 1 and "1 rapid cuts into material. " in str(found[0])
    volume = np.pi / 16 * 4  # mm^3; the hole is 3 mm deep in the model, and the stock is 1 mm higher
    assert abs(found[0].job.removed_volume - volume) <= found[0].job.removed_volume_error <= 0.01 * volume
    assert found[0].job.pixel == found[0].verdict.pixel == 0.5 / 16


@pytest.mark.parametrize(
    "name, given, depth",
    [
        ("Engrave", {"StartDepth": 12.0, "FinalDepth": 11.5}, 0.5),
        ("Vcarve", {"StartDepth": 12.0, "FinalDepth": 10.0}, 2.0),
        ("Deburr", {"Width": 1.0, "ExtraDepth": 0.25}, 1.25),
        ("Profile", {"StartDepth": 12.0, "FinalDepth": 10.0}, 0.0),
    ],
)
def test_engraving_and_deburring_may_cut_the_model(small, monkeypatch, name, given, depth):
    operation = small.add("Lines", slot(10.0))
    for key, value in given.items():
        setattr(operation.addProperty("App::PropertyFloat", key), key, value)
    monkeypatch.setattr(allowed_depth.freecad, "operation_name", lambda obj: name)
    cone = Tool("vbit", 6, tip_angle=np.pi / 2)
    assert allowed_depth.allowed_depth(operation, cone, None) == pytest.approx(depth)
    simplified = Message("tool-simplified", label="Saw", instead=Message("as-end-mill"))
    assert allowed_depth.allowed_depth(operation, cone, simplified) == np.inf
