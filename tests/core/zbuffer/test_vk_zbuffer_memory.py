# SPDX-License-Identifier: LGPL-2.1-or-later
"""The peak memory of a simulation: the estimate, the measured peak, and the refusal."""

from __future__ import annotations

import inspect
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from zbuffer_inputs import BOX, TOOLS, surface, toolpath

from vkworkbench.core import View
from vkworkbench.core.zbuffer import OverBudget, best_resolution, estimate, memory_needed
from vkworkbench.core.zbuffer.memory import memory
from vkworkbench.core.zbuffer.memory.counts import Counts
from vkworkbench.core.zbuffer.memory.growth import size_of
from vkworkbench.core.zbuffer.memory.memory import helpers_within, peak_of
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.simulate import simulate, simulate_job
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts

ROOT = Path(__file__).resolve().parents[3]
# The script runs in a separate process, so that memory of earlier tests is neither released nor reused during the
# measurement.
MEASURE = """
import sys
from pathlib import Path
import numpy as np
sys.path[:0] = [{root!r}, {root!r} + "/tests"]
from vkworkbench.core import View
from vkworkbench.core.zbuffer import Cut, memory_needed, simulate
from zbuffer_inputs import BOX, TOOLS, surface, toolpath

def memory(line):
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))

trajectories, direction, width, height, tool = {case!r}
path, tool, view = toolpath(surface(None, trajectories)), TOOLS[tool], View(direction, width, height)
Path("/proc/self/clear_refs").write_text("5")
before = memory("VmRSS")
done = simulate(path, tool=tool, stock=BOX, view=view, processes=1)
done.at(trajectories // 2).picture
done.picture
taken = memory("VmHWM") - before
# Only now: memory that it gives back would be used again, and not be seen to be taken.
print(memory_needed([Cut(path, tool)], stock=BOX, view=view), taken)
"""


def case(trajectories, direction, width, height):
    points = surface(None, trajectories)
    return toolpath(points), {"tool": TOOLS[2], "stock": BOX, "view": View(direction, width, height)}


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="the peak is read from Linux's /proc")
@pytest.mark.parametrize(
    "which",
    [
        (6_000, (0, 0, -1), 300, 225, 2),
        (14_000, (0, 0, -1), 400, 300, 2),
        (3_000, (1, 1, -1), 400, 300, 2),
        (250, (1, 1, -1), 300, 225, 3),
        (1_200, (0, 1, 0), 400, 300, 2),
        (30_000, (0, 0, -1), 90, 68, 2),
    ],
    ids=["records", "pictures", "oblique", "oblique, bull nose", "side", "trajectories"],
)
def test_predicted_memory_equals_process_memory(which):
    script = MEASURE.format(root=str(ROOT), case=which)
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    expected, taken = (float(v) for v in run.stdout.split())
    assert taken < expected < 1.6 * taken


def test_too_large_simulation_is_refused_before_it_starts():
    path, solids = case(2000, (0, 0, -1), 400, 300)
    with pytest.raises(OverBudget) as refused:
        simulate(path, **solids, memory_budget=1e6)
    error = refused.value
    assert isinstance(error, ValueError)
    assert error.allowed == 1e6 and error.needed > 1e7
    said = error.what.arguments
    assert (said["memory"], said["allowed"]) == (error.needed, 1e6) and said["traces"] > 0 and said["dexels"] > 0
    assert "1.0 MB" in str(error) and str(error).endswith("limit. Simulate fewer operations at a time.")
    assert error.size is None
    assert simulate(path, **solids, memory_budget=error.needed * 1.01).traces > 0
    with pytest.raises(OverBudget):  # A budget of 0 is also a limit.
        simulate(path, **solids, memory_budget=0)


@pytest.mark.parametrize("pixel", [None, 0.05])
def test_refusal_names_the_finest_image_that_fits(pixel):
    path, solids = case(2000, (0, 0, -1), 400, 300)
    view = View((0, 0, -1), 400, 300, pixel)
    frame = view.frame(solids["stock"])
    allowed = memory_needed([Cut(path, solids["tool"])], stock=solids["stock"], view=view) / 1.5
    with pytest.raises(OverBudget) as refused:
        simulate(path, **{**solids, "view": view}, memory_budget=allowed)
    width, height = refused.value.size
    assert height == width * 3 // 4 and f"Choose an image of {width} x {height} pixels of " in str(refused.value)
    fits = view.of_size(width, height)
    found = simulate(path, **{**solids, "view": fits}, memory_budget=allowed).frame
    assert found.pixel == pytest.approx(frame.pixel * 400 / width, rel=0.01)  # The field of view has not changed.
    assert refused.value.what.arguments["instead"].arguments["pixel"] == pytest.approx(found.pixel, rel=1e-3)
    assert found.width * found.pixel >= frame.width * frame.pixel * 0.999
    chosen = best_resolution([estimate(path, None, **{**solids, "view": view})], memory_bytes=allowed)
    assert chosen.view == fits


def removal(tool, direction, points=((10, 15, 5), (30, 15, 5)), *, others=(), offset=(0, 0)):
    view = View(direction, 80, 60, 0.5, offset)
    cuts = Cuts([Cut(toolpath(np.array(points, float)), one) for one in (tool, *others)])
    return Removal(cuts, BOX, view.frame(BOX))


def test_peak_memory_grows_with_dexels_traces_pixels_and_moves():
    """Full arrays of dexels, traces and gaps are enlarged by an eighth. Two standard errors are added to the traces."""
    flat = removal(TOOLS[0], (0, 0, -1))
    nothing = Counts(*[0] * 9, 4800)

    def more(trajectories=0, **counted):
        return peak_of(replace(nothing, **counted), trajectories, flat).bytes() - peak_of(nothing, 0, flat).bytes()

    assert (
        more(dexels=1000.0) == more(traces=1000.0) == more(gaps=1000.0) == 9000 and more(traces_error=1000.0) == 18000
    )
    # Each trajectory needs at least the memory of its start point.
    assert more(band=1000.0) > 0 and more(trajectories=1000) >= 1000 * 8 * 3
    large = Removal(Cuts([]), BOX, View((0, 0, -1), 160, 60).frame(BOX))
    assert peak_of(nothing, 0, large).bytes() - peak_of(nothing, 0, flat).bytes() == 8 * 80 * 60


def test_peak_memory_counts_pictures_after_processes_end(monkeypatch):
    """For the pictures, each trace element needs 14 bytes in addition to its own 8 bytes."""
    flat = removal(TOOLS[0], (0, 0, -1))
    some, many = (Counts(*[0] * 3, 1e8 * share, *[0] * 5, 4800) for share in (0.5, 1.0))
    assert many.traces == 1e8
    assert peak_of(many, 0, flat).bytes() - peak_of(some, 0, flat).bytes() == pytest.approx(22 * 0.5e8)
    monkeypatch.setattr(memory, "count", lambda _: many)
    assert helpers_within(peak_of(many, 0, flat).bytes(), flat, 0) > 0


def test_each_process_adds_its_memory_and_its_dexels_and_traces(monkeypatch):
    flat, plenty = removal(TOOLS[0], (0, 0, -1)), 1e15

    def each(band, trajectories):
        counts = Counts(*[0] * 8, band, 4800)
        assert counts.band == band
        monkeypatch.setattr(memory, "count", lambda _: counts)
        peak = peak_of(counts, trajectories, flat).bytes()
        taken = plenty / helpers_within(peak + plenty, flat, trajectories)
        fit = [helpers_within(peak + share * taken, flat, trajectories) for share in (-9, 0, 0.99, 1.01, 2.5)]
        assert fit == [0, 0, 0, 1, 2]
        return taken

    alone = each(0, 0)
    # A process needs memory for Python with numpy, and for the temporary arrays of a band of the image.
    assert 20e6 < alone < 500e6
    record, trajectory = each(1_000_000, 0) - alone, each(0, 1_000_000) - alone
    # A dexel or trace element has 8 bytes, and a trajectory has a start point of 24 bytes.
    assert record > 8e6 and trajectory > 24e6
    assert each(1_000_000, 1_000_000) == pytest.approx(alone + record + trajectory, rel=1e-5)


def test_band_of_an_image_needs_least_memory_seen_from_above():
    nothing = Counts(*[0] * 9, 4800)
    flat, ball, bullnose, vee = TOOLS[0], TOOLS[2], TOOLS[3], TOOLS[5]
    above, closed, other = (
        {peak_of(nothing, 0, removal(tool, direction)).bytes() for tool, direction in some}
        for some in (
            [(tool, (0, 0, -1)) for tool in TOOLS],
            [(flat, (1, 1, -1)), (ball, (0, 1, -1)), (ball, (0, 1, 1)), (flat, (0.1, 0, 1)), (flat, (0, 0, 1))],
            [(bullnose, (1, 1, -1)), (vee, (1, 1, -1)), (flat, (0, 1, -0.5)), (flat, (0, 1, 0))],
        )
    )
    assert max(above) < min(closed) < min(other)
    assert peak_of(nothing, 0, removal(flat, (1, 1, -1), others=[bullnose])).bytes() in other


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (1, 1, -1)])
def test_small_simulation_needs_no_sampled_rays(direction, monkeypatch):
    monkeypatch.setattr(memory, "count", None)
    path, solids = case(20, direction, 80, 60)
    simulate(path, **solids)
    with pytest.raises(TypeError):  # Rays are sampled only if the memory may not suffice.
        simulate(path, **solids, memory_budget=1e6)


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (1, 1, -1), (0, 1, 0)])
def test_boxes_of_moves_bound_the_number_of_dexels_and_traces(direction):
    for points in (surface(None, 60), [(-20, -20, 3), (60, 50, 3)], [(10, 10, 5), (10, 10, 2)]):
        moves = toolpath(np.array(points, float))
        z = simulate(moves, tool=TOOLS[0], stock=BOX, view=View(direction, 80, 60))
        bound = memory._most_records(Removal(Cuts([Cut(moves, TOOLS[0])]), BOX, z.frame))
        assert z.dexels + z.traces <= bound <= 80 * 60 * (1 + 2 * len(moves))


def test_bounding_box_of_a_move_limits_the_number_of_its_traces():
    """A move of 20 mm covers 26 x 6 mm in pixels of 0.5 mm, plus an edge, clipped to the image.

    Except in vertical views, each pixel in the box may need two dexels or traces for the move.
    """
    assert memory._most_records(removal(TOOLS[0], (0, 0, -1))) == 80 * 60 + 53 * 13
    assert (
        memory._most_records(removal(TOOLS[0], (0, 0, -1), [(10, 15, 5), (90, 15, 5)])) == 80 * 60 + (80 - 14 + 1) * 13
    )
    assert memory._most_records(removal(TOOLS[0], (0, 0, -1), [(-50, 15, 5), (30, 15, 5)])) == 80 * 60 + (66 + 1) * 13
    assert memory._most_records(removal(TOOLS[0], (0, 0, -1), [(20, 28, 5), (30, 28, 5)])) == 80 * 60 + 33 * (
        60 - 50 + 1
    )
    assert memory._most_records(removal(TOOLS[0], (0, 0, -1), [(20, 2, 5), (30, 2, 5)])) == 80 * 60 + 33 * (10 + 1)
    for aside in ((30, 0), (0, 30), (-60, 0), (0, -60)):  # The image does not show the move.
        assert memory._most_records(removal(TOOLS[0], (0, 0, -1), [(5, 5, 5), (20, 5, 5)], offset=aside)) == 80 * 60
    # The bounding box of the sweep is 26 mm wide and 5 mm high.
    assert memory._most_records(removal(TOOLS[0], (0, 1, 0))) == 80 * 60 + 2 * 53 * 11


def test_huge_image_is_refused_by_default():
    path, solids = case(2000, (0, 0, -1), 20_000, 16_000)
    with pytest.raises(OverBudget):
        simulate(path, **solids)


def test_each_dexel_or_segment_of_a_trace_has_eight_bytes():
    path, solids = case(2000, (0, 0, -1), 200, 150)
    z = simulate(path, **solids)
    segments = z.traces + z.dexels
    assert z.records.far.nbytes + z.records.owner.nbytes == 8 * segments
    assert z.memory_bytes == 8 * segments + 8 * 200 * 150 + 4
    assert np.array_equal(np.diff(z.records.index.astype(int)).sum(), segments)


@pytest.mark.parametrize("function", [simulate, simulate_job])
def test_default_memory_budget_is_two_gigabytes(function):
    """docs/cost.md states this default."""
    assert inspect.signature(function).parameters["memory_budget"].default == 2e9


@pytest.mark.parametrize("side", [(1, 1), (1000, 1), (1, 999_999), (65_536, 65_536), (1_000_000, 4000)])
def test_enlarged_image_stays_within_view_limits(side):
    image = View(width=side[0], height=side[1])
    width, height = size_of(image, 2.0**60)
    assert image.of_size(width, height).width == width
    assert max(width, height) > 0.99e6 or width * height > 0.99 * 2**32
