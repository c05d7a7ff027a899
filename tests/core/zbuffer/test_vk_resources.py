# SPDX-License-Identifier: LGPL-2.1-or-later
"""The estimated cost of a simulation with its error bar, the exact cost, and the image size for a budget."""

from __future__ import annotations

import pickle
from dataclasses import replace
from itertools import count
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from zbuffer_inputs import ConvexStock

from vkworkbench.core import Stock, Strategy, Tool, Toolpath, View
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import Recognition, recognize
from vkworkbench.core.zbuffer.cost.estimate import estimate, estimate_job
from vkworkbench.core.zbuffer.cost.resolution import best_resolution, heaviest
from vkworkbench.core.zbuffer.cost.speed import Speed, fit_speed, measure_speed
from vkworkbench.core.zbuffer.culling.tiles import TILE
from vkworkbench.core.zbuffer.culling.tilted import Tilted
from vkworkbench.core.zbuffer.culling.upright import Upright
from vkworkbench.core.zbuffer.memory.memory import memory_needed
from vkworkbench.core.zbuffer.memory.sampling import sample
from vkworkbench.core.zbuffer.memory.silhouette import seen_areas
from vkworkbench.core.zbuffer.rays.dexels import UNCUT
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.simulate import simulate, simulate_job
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories
from vkworkbench.language import Message

STOCK = Stock((0, 0, 0), (80, 60, 20))
FLAT, BALL = Tool("endmill", 6), Tool("ballend", 6)
TOP, TILTED, ISOMETRIC = (0, 0, -1), (0, 0.5, -0.866), (1, 1, -0.816)


def path(points):
    return Toolpath.through(points)


def zigzag(step=3.0, levels=(16, 12), chords=1):
    points = []
    for z in levels:
        points.append((10, 10, 25))
        for k, y in enumerate(np.arange(10, 50.1, step)):
            x = np.linspace(10, 70, chords + 1)[:: 1 if k % 2 == 0 else -1]
            points += [(u, y, z) for u in x]
        points.append((points[-1][0], points[-1][1], 25))
    return path(points)


def surface(step=2.0, chords=60):
    """Return a zigzag over a wavy surface."""
    points = zigzag(step, (0,), chords).points[1:-1].copy()
    points[:, 2] = 14 + 3 * np.sin(points[:, 0] / 9) * np.cos(points[:, 1] / 11)
    return path(points)


def contours(step=2.5):
    points = []
    for inset in np.arange(0, 18, step):
        corners = [(10, 10), (70, 10), (70, 50), (10, 50), (10, 10)]
        towards = [(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1)]
        points += [(x + inset * u, y + inset * v, 15) for (x, y), (u, v) in zip(corners, towards)]
    return path(points)


def helix():
    angle = np.linspace(0, 12 * pi, 300)
    return path(np.column_stack((40 + 8 * np.cos(angle), 30 + 8 * np.sin(angle), np.linspace(21, 10, 300))))


def drilled():
    points = []
    # The holes lie at different places within their pixels, so their rounding errors differ.
    for x in np.arange(10, 75, 12.3):
        for y in np.arange(10, 55, 12.7):
            points += [(x, y, 22), (x, y, 14), (x, y, 21), (x, y, 9), (x, y, 22)]
    return path(points)


PATHS = {
    "zigzag": (zigzag(), FLAT),
    "surface": (surface(), BALL),
    "contours": (contours(), FLAT),
    "helix": (helix(), FLAT),
    "drilled": (drilled(), Tool("drill", 6)),
    "vee": (contours(7), Tool("vbit", 6)),
    "corners": (contours(), Tool("bullnose", 6, corner_radius=1)),
}


@pytest.mark.long
@pytest.mark.parametrize("direction", [TOP, TILTED, ISOMETRIC], ids=["top", "tilted", "isometric"])
@pytest.mark.parametrize("name", PATHS)
def test_estimate_equals_the_simulation_within_its_error_bar(name, direction):
    toolpath, tool = PATHS[name]
    view = View(direction, 200, 150)
    exact = simulate(toolpath, tool=tool, stock=STOCK, view=view)
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=view)
    assert found.traces == pytest.approx(exact.traces, rel=0.1)
    assert abs(found.traces - exact.traces) < 3 * found.traces_error + 0.01 * exact.traces
    assert found.dexels == pytest.approx(exact.dexels, rel=0.03)
    assert found.memory_bytes == pytest.approx(exact.peak.bytes(), rel=0.1)


@pytest.mark.long
def test_95_percent_of_estimates_are_within_two_errors():
    within = []
    for name, (toolpath, tool) in PATHS.items():
        frame = View(TOP if name == "helix" else TILTED).frame(STOCK)
        removal = Removal(Cuts([Cut(toolpath, tool)]), STOCK, frame)
        totals = []
        for seed in range(20):
            rays = sample(removal, np.random.default_rng(seed))
            segments, _ = removal.cut(rays.x, rays.y)
            totals.append(rays.total(np.bincount(segments.ray[segments.owner != UNCUT], minlength=len(rays.x))))
        total, error = np.array(totals).T
        within.append(np.abs(total - total.mean()) <= 2 * error)
        # The error estimate must not be so large that it is useless.
        assert error.mean() < 2 * total.std(ddof=1)
    assert np.mean(within) >= 0.95


def test_repeated_estimate_returns_equal_numbers():
    toolpath, tool = PATHS["surface"]
    first, second = (estimate(toolpath, None, tool=tool, stock=STOCK, view=View(ISOMETRIC)) for _ in range(2))
    assert first == second


def test_estimated_counts_grow_with_the_number_of_pixels():
    toolpath, tool = PATHS["contours"]
    coarse, fine = (
        estimate(toolpath, None, tool=tool, stock=STOCK, view=View(width=k * 400, height=k * 300)) for k in (1, 3)
    )
    # Each pixel is either cut or not cut, so the edges of the cut areas may differ by a pixel.
    assert fine.traces == pytest.approx(9 * coarse.traces, abs=18 * coarse.traces_error)
    assert fine.dexels == pytest.approx(9 * coarse.dexels, rel=1e-3)


@pytest.mark.long
@pytest.mark.parametrize("width", [0.3, 0.5, 0.8, 1.0, 2.0])
@pytest.mark.parametrize("direction", [TOP, (0, 1, 0), TILTED, ISOMETRIC], ids=["top", "front", "tilted", "isometric"])
def test_error_bar_includes_the_size_of_the_pixel(width, direction):
    """A narrow slot covers one or two rows of pixels, depending on the place of the pixels, not on the slot's area."""
    stock, view = Stock((0, 0, 0), (120, 90, 20)), View(direction, 320, 240)
    far, inside = 0.0, []
    for turn in np.radians([0, 7, 45, 90]):
        x, y = 30 * np.cos(turn), 30 * np.sin(turn)
        toolpath = linearize([
            ("G0", {"X": 60 - x, "Y": 45 - y, "Z": 25.0}), ("G1", {"Z": 15.0}), ("G1", {"X": 60 + x, "Y": 45 + y}),
        ])  # fmt: skip
        exact = simulate(toolpath, tool=Tool("endmill", width), stock=stock, view=view).traces
        found = estimate(toolpath, None, tool=Tool("endmill", width), stock=stock, view=view)
        inside.append(abs(found.traces - exact) <= 2 * found.traces_error)
        far = max(far, abs(found.traces - exact) / max(found.traces_error, 1.0))
    assert sum(inside) >= 3 and far < 4


def test_estimate_counts_only_the_part_in_the_image():
    toolpath, tool = PATHS["zigzag"]
    view = View(width=100, height=100, pixel=0.1)
    exact = simulate(toolpath, tool=tool, stock=STOCK, view=view)
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=view)
    assert found.dexels == pytest.approx(exact.dexels, rel=0.01) == 10000
    assert found.traces == pytest.approx(exact.traces, rel=0.03) == 20000


def test_estimated_memory_is_the_memory_that_decides_on_refusal():
    toolpath, tool = PATHS["zigzag"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View())
    assert found.memory_bytes == memory_needed([Cut(toolpath, tool)], stock=STOCK, view=View())
    nothing = estimate(path([(0, 0, 50), (9, 0, 50)]), None, tool=tool, stock=STOCK, view=View())
    assert found.stock_bytes == pytest.approx(nothing.memory_bytes, rel=1e-3) and found.stock_bytes < found.memory_bytes


def test_explanation_of_cost_contains_the_cuts_per_pixel():
    toolpath, tool = PATHS["zigzag"]
    found = estimate(toolpath, recognize(toolpath, tool_diameter=6), tool=tool, stock=STOCK, view=View())
    assert found.explanation == "zigzag, stepover 3 mm: each pixel is cut 2.0 times"


def test_explanation_of_cost_contains_strategy_and_stepover():
    toolpath, tool = PATHS["contours"]
    view = View(width=80, height=60)
    for known, words in (
        (None, "toolpath: each"),
        (Recognition(Strategy.PROFILE, 1.0, Message("no-moves")), "profile: each"),
        (Recognition(Strategy.SPIRAL, 1.0, Message("no-moves"), stepover=2.4996), "spiral, stepover 2.5 mm: each"),
    ):
        assert estimate(toolpath, known, tool=tool, stock=STOCK, view=view).explanation.startswith(words)


@pytest.mark.parametrize("direction", [TOP, TILTED], ids=["top", "tilted"])
def test_estimate_keeps_its_inputs_and_speed(direction):
    toolpath, tool = PATHS["contours"]
    speed = Speed(trajectory=7e-6, factor=1.5)
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(direction, 80, 60), speed=speed)
    assert found.trajectory_seconds == pytest.approx(7e-6 * len(toolpath)) and found.work.trajectories == len(toolpath)
    assert (found.factor, found.speed, found.view) == (1.5, speed, View(direction, 80, 60))
    records = found.dexels + found.traces
    assert found.work.records == ((records, 0) if direction == TOP else (0, records))
    assert found.seconds == speed.seconds(found.work) == pytest.approx((speed.constants * found.work.amounts()).sum())


def test_pickled_estimate_has_no_cuts_and_no_stock():
    toolpath, tool = PATHS["contours"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(width=80, height=60))
    sent = pickle.loads(pickle.dumps(found))
    assert found.cuts[0].tool == tool and len(found.cuts[0].toolpath) == len(toolpath) and found.stock is STOCK
    assert sent == found and not sent.cuts and sent.stock is None
    assert "Toolpath" not in repr(found) and "Stock" not in repr(found)


@pytest.mark.parametrize(
    "points",
    [
        [],
        [(10, 10, 25)],
        [(10, 10, 25), (60, 40, 25)],
        [(200, 0, 5), (300, 0, 5)],
        [(10, 10, -30), (20, 10, -30)],
    ],
    ids=["empty", "point", "above", "beside", "under"],
)
def test_estimate_is_close_if_paths_cut_nothing_or_everything(points):
    toolpath = path(points)
    found = estimate(toolpath, recognize(toolpath), tool=FLAT, stock=STOCK, view=View(width=200, height=150))
    exact = simulate(toolpath, tool=FLAT, stock=STOCK, view=View(width=200, height=150))
    assert found.traces == pytest.approx(exact.traces, rel=0.05)
    assert found.dexels == pytest.approx(exact.dexels, rel=0.01)
    assert np.isfinite(found.seconds)
    if not exact.traces:
        assert found.explanation == "no trajectory cuts the stock"
        assert found.traces_error == 0


def test_estimate_is_close_for_a_tool_larger_than_the_stock():
    toolpath = path([(0, 30, 12), (80, 30, 12)])
    found = estimate(toolpath, None, tool=Tool("endmill", 200), stock=STOCK, view=View(width=200, height=150))
    assert found.traces == pytest.approx(200 * 150, rel=1e-3)


def test_ten_times_the_chords_need_few_more_tests_per_chord(monkeypatch):
    tested = []
    intervals = Removal.intervals

    def counted(self, x, y, item):
        tested.append(len(item))
        return intervals(self, x, y, item)

    monkeypatch.setattr(Removal, "intervals", counted)
    pairs = []
    for chords in (150, 1500):
        toolpath = surface(step=1.0, chords=chords)
        tested.clear()
        estimate(toolpath, None, tool=BALL, stock=STOCK, view=View())
        pairs.append(sum(tested) / len(toolpath))
    assert 0 < pairs[1] < 1.5 * pairs[0]


def covered(stock, view):
    area, gaps = seen_areas(stock, view.frame(stock), np.random.default_rng(1))
    assert gaps == 0
    return area


def test_areas_of_silhouettes_are_exact():
    tilt = radians(30)
    assert covered(STOCK, View((0, sin(tilt), -cos(tilt)))) == pytest.approx(80 * (60 * cos(tilt) + 20 * sin(tilt)))
    assert covered(STOCK, View(width=10, height=10, pixel=1)) == pytest.approx(100)
    cylinder = ConvexStock.cylinder((0, 0, 0), radius=10, height=30)
    assert covered(cylinder, View()) == pytest.approx(pi * 100)
    assert covered(cylinder, View((1, 0, 0))) == pytest.approx(20 * 30, rel=0.005)


def test_noisy_time_measurements_give_positive_constants():
    amounts = 1 / np.array(Speed().constants) * (np.eye(7) + 0.1)
    seconds = amounts @ Speed().constants * [1e-6, 5, 1, 1, 1, 1, 1]
    assert (fit_speed(amounts, seconds).constants > 0).all()


@pytest.mark.parametrize("direction", [TOP, TILTED, ISOMETRIC], ids=["top", "tilted", "isometric"])
def test_candidates_are_pixels_passed_by_trajectories(direction):
    """The path follows the edge of the stock, and also lies beside the stock.

    Pixels are candidates only where the path passes over the stock.
    """
    toolpath = path([(20, 20, 10), (60, 40, 10), (20, 40, 12), (-2, -2, 8), (-2, 90, 8)])
    view = View(direction, 240, 180)
    frame = view.frame(STOCK)
    row, column = np.divmod(np.arange(240 * 180), 240)
    _, passes = Removal(Cuts([Cut(toolpath, FLAT)]), STOCK, frame).cut(*frame.pixel_centres(column, row))
    found = estimate(toolpath, None, tool=FLAT, stock=STOCK, view=view)
    assert found.candidates == pytest.approx(passes.sum(), rel=0.08)


@pytest.mark.long
@pytest.mark.parametrize("direction", [TOP, TILTED], ids=["top", "tilted"])
def test_estimated_work_of_a_job_includes_all_operations(direction):
    """An operation of many moves does not hide an operation of few moves in another place."""
    cuts = [Cut(*PATHS[name]) for name in ("zigzag", "surface", "helix")] + [Cut(zigzag(0.5, chords=40), FLAT)]
    view = View(direction, 320, 240)
    exact = simulate_job(cuts, stock=STOCK, view=view, processes=1)
    found = estimate_job(cuts, stock=STOCK, view=view).work
    assert 4 * np.sum(found.pairs) + sum(found.cells) == pytest.approx(exact.candidates, rel=0.15)


@pytest.mark.long
@pytest.mark.parametrize("direction", [TOP, TILTED], ids=["top", "tilted"])
@pytest.mark.parametrize("names", [("zigzag",), ("surface",), ("helix",), ("zigzag", "surface", "helix")])
def test_estimated_work_equals_the_work_of_the_simulator(names, direction, monkeypatch):
    """The estimate uses a few tiles.

    The test compares the number of tested pairs of a tile or pixel and a trajectory. The test also compares the number
    of batches, which are calls of the simulator for pairs of one kind.
    """
    worked = []
    divided = Trajectories.by_kind
    bounds = Upright if direction == TOP else Tilted

    def counted(function):
        def count_and_go_on(self, *arguments):
            item = arguments[0].item if len(arguments) < 5 else arguments[3]
            worked.append(len(list(divided(self.trajectories, item))))
            return function(self, *arguments)

        return count_and_go_on

    cuts, view = [Cut(*PATHS[name]) for name in names], View(direction, 400, 300)
    found = estimate_job(cuts, stock=STOCK, view=view)
    monkeypatch.setattr(bounds, "quarters", counted(bounds.quarters))
    monkeypatch.setattr(bounds, "removals", counted(bounds.removals))
    exact = simulate_job(cuts, stock=STOCK, view=view, processes=1)
    assert found.work.amounts()[3] == pytest.approx(sum(worked), rel=0.3)
    assert 4 * np.sum(found.work.pairs) + sum(found.work.cells) == pytest.approx(exact.candidates, rel=0.3)
    assert found.seconds == pytest.approx(found.speed.constants @ found.work.amounts())


def test_kinds_of_trajectories_in_a_band_are_batched_separately():
    row, behind = path([(5, 5, 15), (75, 5, 15)]), path([(5, 55, 15), (75, 55, 15)])
    view = View(TOP, 640, 480)  # The 60 mm of the stock are 7.5 bands of 64 rows of pixels.

    def work(*cuts):
        return estimate_job(
            [Cut(toolpath, Tool("endmill", size)) for toolpath, size in cuts], stock=STOCK, view=view
        ).work

    assert work((row, 6)).kinds == work((row, 6), (behind, 6)).kinds == 1
    assert work((row, 6), (row, 4)).kinds == pytest.approx(2, abs=0.2)
    apart = work((row, 6), (behind, 4))
    assert apart.kinds < 0.7 and apart.bands == pytest.approx(7.5, rel=0.15)
    assert work((row, 6)).bands == pytest.approx(1 + 6 / 8, rel=0.15)
    assert work((path([(5, 5, 30), (75, 5, 30)]), 6)).bands == 0  # The path is above the stock.
    # The part of the path outside the image reaches no bands.
    assert work((path([(40, -50, 15), (40, 10, 15)]), 6)).bands == pytest.approx(1 + 13 / 8)
    # The number of bands is limited to the bands of the image.
    assert work((path([(40, -50, 15), (40, 110, 15)]), 6)).bands == 8


def test_work_for_another_image_size_needs_no_new_estimate():
    toolpath, tool = PATHS["surface"]
    few, many = (
        estimate(toolpath, None, tool=tool, stock=STOCK, view=View(TILTED, w, w * 3 // 4)) for w in (400, 1200)
    )
    assert few.work.amounts(9.0) == pytest.approx(many.work.amounts(), rel=0.35)
    assert few.seconds_in(9.0) == pytest.approx(many.seconds, rel=0.15)
    assert few.seconds_in(1.0) == few.seconds
    growing = [few.seconds_in(growth) for growth in (1e-6, 1e-3, 0.5, 1.0, 2.0, 50.0)]
    assert growing == sorted(growing)


def test_time_per_pixel_is_similar_in_large_images():
    """Rows cut each pixel twice.

    With 16 times as many pixels, a measurement showed 0.9 times as much time per pixel.
    """
    toolpath, tool = PATHS["zigzag"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View())
    assert 0.83 < found.seconds_in(16.0) / 16 / found.seconds < 1


def test_speed_is_computed_from_measured_times():
    rng = np.random.default_rng(3)
    true = Speed().constants * [2, 3, 2, 3, 2, 3, 2]
    amounts = rng.uniform(0.1, 1, (2000, 7)) / true
    assert fit_speed(amounts, amounts @ true).constants == pytest.approx(true, rel=0.02)
    # With few and noisy times, the constants stay within a factor of 4.
    for _ in range(50):
        few = amounts[rng.choice(2000, 6)]
        found = fit_speed(few, few @ true * rng.uniform(0.7, 1.4, 6)).constants
        assert ((found > true / 4) & (found < 4 * true)).all()


def test_speed_is_measured_in_runs_below_a_tenth_of_a_second(monkeypatch):
    """Each run uses only this process and an image of whole tiles, and takes below 0.1 s at the default speed.

    The work of each timed simulation is an input of the fit.
    """
    runs, works = [], []
    monkeypatch.setattr("vkworkbench.core.zbuffer.cost.speed.steady_seconds", lambda pieces, **_: runs.extend(pieces))
    monkeypatch.setattr("vkworkbench.core.zbuffer.cost.speed.fit_speed", lambda amounts, _: works.extend(amounts))
    measure_speed()
    assert len(runs) == len(works) == 6
    for run, work in zip(runs, works):
        assert 0.025 < Speed().constants @ work < 0.1
        asked = {name: run.keywords[name] for name in ("tool", "stock", "view")}
        assert run.keywords["processes"] == 1 and asked["view"].width == asked["view"].height
        assert asked["view"].width % TILE == 0
        assert work.tolist() == estimate(*run.args, None, **asked).work.amounts().tolist()


@pytest.mark.long
def test_speed_of_this_computer_can_be_measured():
    ticks = count(step=0.25)  # Every simulation has the same duration.
    speed = measure_speed(clock=lambda: next(ticks))
    assert (speed.constants > 0).all() and speed.factor < Speed().factor


@pytest.mark.long
@pytest.mark.parametrize("direction", [(0, 0, -1), TILTED])
@pytest.mark.parametrize("name", PATHS)
def test_simulation_and_pictures_stay_within_memory_budget(name, direction):
    toolpath, tool = PATHS[name]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(direction))
    for budget in (60e6, 1e9):
        chosen = best_resolution([found], memory_bytes=budget)
        needed = memory_needed([Cut(toolpath, tool)], stock=STOCK, view=chosen.view)
        assert 0.96 * budget < needed <= budget  # The memory budget of the test is large enough for the simulation.
        assert 0.97 * budget < chosen.memory_bytes <= 0.98 * budget
        assert "limited by the memory" in chosen.explanation


def test_image_size_for_a_time_budget_uses_the_whole_budget():
    toolpath, tool = PATHS["surface"]
    speed = Speed(trajectory=1e-5)
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(), speed=speed)
    chosen = best_resolution([found], seconds=found.seconds / 3, memory_bytes=1e12)
    again = estimate(toolpath, None, tool=tool, stock=STOCK, view=chosen.view, speed=speed)
    # The time differs slightly from the budget, because the image has whole pixels.
    assert chosen.seconds == pytest.approx(found.seconds / 3, rel=5e-3)
    # Each image draws its own random sample of tiles.
    assert again.seconds == pytest.approx(found.seconds / 3, rel=0.1)
    assert "limited by the time" in chosen.explanation


def test_best_resolution_keeps_the_field_of_view():
    toolpath, tool = PATHS["zigzag"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(width=200, height=100, pixel=0.2))
    chosen = best_resolution([found], memory_bytes=found.peak.bytes(4.001) / 0.98)
    assert (chosen.view.width, chosen.view.height) == (400, 200)
    assert chosen.view.pixel == pytest.approx(0.1)


@pytest.mark.parametrize("pixels, sides", [(650, (2, 254)), (40, (1, 40)), (1, (1, 1))])
def test_image_with_3_pixels_in_a_row_stays_within_the_budget(pixels, sides):
    for turn in (1, -1):
        width, height = (3, 300)[::turn]
        found = estimate(*PATHS["zigzag"][:1], None, tool=FLAT, stock=STOCK, view=View(width=width, height=height))
        budget = found.peak.bytes((pixels + 0.01) / 900) / 0.98
        chosen = best_resolution([found], memory_bytes=budget)
        assert (chosen.view.width, chosen.view.height) == sides[::turn]
        assert chosen.memory_bytes <= 0.98 * budget


def test_operations_of_a_job_share_one_stock():
    toolpath, tool = PATHS["zigzag"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View())
    one, two = (best_resolution([found] * k, memory_bytes=4e9) for k in (1, 2))
    per_image = found.peak.bytes(1001) - found.peak.bytes(1000)
    above = estimate(path([(0, 0, 50), (9, 0, 50)]), None, tool=tool, stock=STOCK, view=View())
    of_stock = above.peak.bytes(1001) - above.peak.bytes(1000)
    ratio = sqrt(per_image / (2 * per_image - of_stock))
    assert two.view.width == pytest.approx(ratio * one.view.width, rel=2e-3)


def test_job_memory_has_largest_temporary_arrays_and_all_traces():
    """Temporary arrays of 1 and 3 GB need 3 GB, because only one is held at a time.

    The memory for trajectories, dexels and traces is added up.
    """
    found = estimate(*PATHS["zigzag"][:1], None, tool=FLAT, stock=STOCK, view=View())
    small, large = (replace(found, peak=replace(found.peak, work=work)) for work in (1e9, 3e9))

    def needed(*estimates):
        # With a budget of one byte, the result has the memory for an image of one pixel.
        return best_resolution(estimates, memory_bytes=1.0).memory_bytes

    assert needed(small, large) == needed(large, small)
    assert needed(small, large) - needed(small, small) == pytest.approx(2e9)
    many = replace(small, peak=replace(small.peak, trajectories=10**9))
    assert needed(many, many) - needed(many) == pytest.approx(needed(many) - 1e9, rel=1e-3)


def test_budget_too_small_for_any_resolution_gives_advice():
    toolpath, tool = PATHS["surface"]
    found = estimate(toolpath, None, tool=tool, stock=STOCK, view=View(), speed=Speed(trajectory=1.0))
    chosen = best_resolution([found], seconds=10)
    assert chosen.view is None
    assert chosen.explanation.startswith("None, because the moves alone take")
    assert "fewer operations" in chosen.explanation
    one = 1 / (found.view.width * found.view.height)
    assert (chosen.seconds, chosen.memory_bytes) == (found.seconds_in(one), found.peak.bytes(one))
    assert (
        best_resolution([found], memory_bytes=10).explanation
        == "None, because not even a single pixel fits into the memory."
    )


def test_explanation_names_the_slowest_of_several_operations():
    assert heaviest(["Face", "Bore"], [1.0, 3.0]).arguments == {"label": "Bore", "time": 3.0}
    assert heaviest(["Face"], [1.0]) is None and heaviest([], [1.0, 3.0]) is None


def test_passes_are_visible_with_four_pixels_per_stepover():
    found = estimate(*PATHS["zigzag"][:1], None, tool=FLAT, stock=STOCK, view=View())
    assert (
        "For passes 3 mm apart, 0.75 mm is fine enough."
        in best_resolution([found], memory_bytes=2e7, stepover=3).explanation
    )
    assert "Passes 3 mm apart need 0.75 mm." in best_resolution([found], memory_bytes=1.44e7, stepover=3).explanation
    assert "passes" not in best_resolution([found], memory_bytes=2e7).explanation  # The stepover is unknown.


@pytest.mark.parametrize("budget", [{}, {"seconds": 0}, {"memory_bytes": float("nan")}, {"seconds": -1.0}])
def test_impossible_budgets_are_refused(budget):
    found = estimate(*PATHS["zigzag"][:1], None, tool=FLAT, stock=STOCK, view=View())
    with pytest.raises(ValueError, match="positive number"):
        best_resolution([found], **budget)
    with pytest.raises(ValueError, match="no operation"):
        best_resolution([], seconds=1)
