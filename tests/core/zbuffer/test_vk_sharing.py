# SPDX-License-Identifier: LGPL-2.1-or-later
"""An image cut by several processes has the same dexels and traces, even if processes fail, and no process remains."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from zbuffer_inputs import BOX, PATHS, TOOLS, toolpath

from vkworkbench import worker
from vkworkbench.core import Cut, Mesh, Speed, View, estimate, simulate
from vkworkbench.core.zbuffer import memory_needed, shared_seconds
from vkworkbench.core.zbuffer.memory.memory import helpers_within
from vkworkbench.core.zbuffer.rays.records import side_by_side
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator import sharing
from vkworkbench.core.zbuffer.simulator.cut_image import CutImage
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.worker import Worker

ROOT = Path(__file__).resolve().parents[3]
WIDE = View((1, 1, -1), 180, 200)


@pytest.fixture
def workers(monkeypatch):
    """Let worker processes help from the beginning, and record the regions of each worker."""
    made = []

    class Watched(Worker):
        def __init__(self, work):
            super().__init__(work)
            self.regions = []
            made.append(self)

        def __call__(self, region):
            found = super().__call__(region)
            self.regions.append(region)
            return found

    monkeypatch.setattr(sharing, "_ALONE", -1.0)
    monkeypatch.setattr(sharing, "Worker", Watched)
    yield made
    assert not any(each.lives for each in made)


def until(done):
    """Return a callback that waits at most a minute until `done` returns True."""

    def going_on(_):
        end = time.monotonic() + 60
        while not done() and time.monotonic() < end:
            time.sleep(0.01)

    return going_on


def case(view=WIDE, stock=BOX, moves=120):
    points = PATHS[0](np.random.default_rng(5), moves)
    return toolpath(points), {"tool": TOOLS[0], "stock": stock, "view": view}


def same(one, other):
    for part in ("index", "entry", "far", "owner"):
        expected, found = getattr(one.records, part), getattr(other.records, part)
        assert found.dtype == expected.dtype and np.array_equal(found, expected)
    return True


def hollow():
    """Return a block with a cavity, in which many rays have two dexels before any cut."""
    corner = np.array([[(0, 40)[i & 1], (0, 30)[i >> 1 & 1], (0, 10)[i >> 2]] for i in range(8)], float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    outer = np.array([corner[[a, b, c]] for q in quads for a, b, c in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))])
    return Mesh(np.concatenate((outer, outer * 0.5 + (10, 7, 2))))


@pytest.mark.long
@pytest.mark.parametrize(
    "stock, view",
    [
        (BOX, View((0, 0, -1), 300, 200)),
        (hollow(), View((0, 0, -1), 130, 70)),
        (BOX, View((1, 0.5, -0.3), 130, 70)),
        (hollow(), WIDE),
    ],
    ids=["box, from above", "hollow, from above", "box, oblique", "hollow, oblique"],
)
def test_shared_dexels_and_traces_equal_those_of_one_process(view, stock, workers):
    path, solids = case(view, stock)
    alone = simulate(path, **solids, processes=1)
    assert not workers
    helped = until(lambda: not workers or any(each.regions for each in workers))
    shared = simulate(path, **solids, processes=3, going_on=helped)
    assert same(alone, shared) and shared.candidates == pytest.approx(alone.candidates, rel=0.01)
    assert len(workers) == 2
    assert any(each.regions for each in workers)


def test_short_simulation_stays_in_one_process(monkeypatch):
    path, solids = case(View((0, 0, -1), 60, 130), moves=5)
    monkeypatch.setattr(sharing, "Worker", None)
    monkeypatch.setattr(sharing, "_ALONE", 60.0)
    assert simulate(path, **solids, processes=4).traces > 0
    monkeypatch.setattr(sharing, "_ALONE", -1.0)
    with pytest.raises(TypeError):  # `Worker` is None, so starting a worker process fails.
        simulate(path, **solids, processes=4)


def test_number_of_workers_is_the_number_of_other_cores(workers, monkeypatch):
    monkeypatch.setattr(worker, "processes", lambda: 2)
    path, solids = case(moves=20)
    simulate(path, **solids)
    assert len(workers) == 1
    monkeypatch.setattr(worker, "processes", lambda: 1)
    simulate(path, **solids)
    assert len(workers) == 1


@pytest.mark.long
def test_work_stays_in_this_process_if_memory_runs_out(monkeypatch):
    """Memory runs out while dexels and traces are received, and then in the thread that serves the worker."""

    def no_memory(*_):
        raise MemoryError

    path, solids = case()
    monkeypatch.setattr(sharing, "_ALONE", -1.0)
    alone = simulate(path, **solids, processes=1)
    for of, name in ((worker.pickle, "load"), (sharing.Worker, "__call__")):
        with monkeypatch.context() as patched:
            patched.setattr(of, name, no_memory)
            patched.setattr(threading, "excepthook", lambda _: None)
            assert same(alone, simulate(path, **solids, processes=3))


@pytest.mark.long
@pytest.mark.parametrize("regions", [0, 2])
def test_work_of_a_dead_process_is_done_by_other_processes(regions, workers, monkeypatch):
    """The worker dies before its first region, and then after two regions."""
    done = []

    def dying(self, region):
        done.append(region)
        if len(done) > regions:
            self._process.kill()
        return original(self, region)

    path, solids = case()
    alone = simulate(path, **solids, processes=1)
    original = Worker.__call__
    monkeypatch.setattr(Worker, "__call__", dying)
    dead = until(lambda: not workers or len(done) > regions)
    assert same(alone, simulate(path, **solids, processes=2, going_on=dead))
    assert len(done) == regions + 1 and len(workers[0].regions) == regions


def test_without_an_interpreter_one_process_does_all_work(workers, monkeypatch):
    monkeypatch.setattr(worker, "interpreter", lambda: None)
    path, solids = case()
    assert same(simulate(path, **solids, processes=1), simulate(path, **solids, processes=3))
    assert not workers


def test_worker_with_another_numpy_version_is_not_used(workers, monkeypatch):
    monkeypatch.setattr(worker.np, "__version__", "1.2.3")
    path, solids = case()
    ended = until(lambda: not workers or not workers[0].lives)
    assert same(simulate(path, **solids, processes=1), simulate(path, **solids, processes=2, going_on=ended))
    assert len(workers) == 1 and not workers[0].regions


class Stopped(Exception):
    pass


@pytest.mark.parametrize("moment", ["before", "while they start", "while they cut"])
def test_stopping_ends_all_processes(moment, workers):
    """The fixture `workers` asserts that no process remains."""
    cutting = until(lambda: any(each.regions for each in workers))

    def going_on(share):
        if not workers and moment != "before":
            return
        if moment == "while they cut":
            cutting(share)
        raise Stopped

    path, solids = case()
    with pytest.raises(Stopped):
        simulate(path, **solids, processes=3, going_on=going_on)
    assert len(workers) == (0 if moment == "before" else 2)


@pytest.mark.long
def test_progress_of_shared_simulation_grows_from_zero(workers):
    told, helped = [], until(lambda: not workers or len(workers[0].regions) > 1)

    def going_on(share):
        told.append(share)
        helped(share)

    path, solids = case()
    simulate(path, **solids, processes=2, going_on=going_on)
    assert told[0] == 0 and told == sorted(told) and told[-1] < 1
    # The progress includes finished regions of all processes, even before the first band of the image is finished.
    assert 0 < min(filter(None, told)) < 64 / 200 and len(set(told)) > 2


def test_remaining_bands_are_divided_among_the_processes():
    image = CutImage(Cuts([Cut(case()[0], TOOLS[0])]), BOX, View((0, 0, -1), 700, 200).frame(BOX))
    assert [(band.left, band.right, band.bottom, band.top) for band in image.bands] == [
        (0, 700, 0, 64), (0, 700, 64, 128), (0, 700, 128, 192), (0, 700, 192, 200),
    ]  # fmt: skip
    shared = sharing._Shared(image.bands)
    first = shared.take()
    shared.divide(1)
    regions = [shared.take() for _ in range(shared.left)]
    assert shared.take() is None
    # 33 tiles are divided into twelve regions of two tiles each. The last region of a band has the remaining tiles.
    assert [(region.left, region.right) for region in regions[:6]] == [
        (k, min(k + 128, 700)) for k in range(0, 700, 128)
    ]
    assert {region.bottom for region in regions} == {64, 128, 192} and len(regions) == 18
    shared.give(first, (None, 0))
    assert shared.share == 0.25 and shared.has(first) and not shared.has(image.bands[1])
    for region in regions[:6]:
        shared.give(region, (None, 0))
    assert shared.share == 0.5 and shared.has(image.bands[1])
    fewest = sharing._Shared(image.bands[:1])
    fewest.divide(50)
    assert fewest.left == 11 and fewest.take().right == 64  # A region has at least one tile.


def test_wait_ends_if_the_band_is_done_or_a_region_is_free(monkeypatch):
    over = []
    monkeypatch.setattr(threading.Condition, "wait_for", lambda _, done, seconds: over.append(bool(done())))
    first, second = bands = CutImage(Cuts([Cut(case()[0], TOOLS[0])]), BOX, View((0, 0, -1), 64, 128).frame(BOX)).bands
    shared = sharing._Shared(bands)
    shared.wait(second, 1.0)  # No process works on a region yet.
    assert (shared.take(), shared.take()) == (first, second)
    shared.wait(second, 1.0)
    shared.give(first, (None, 0))
    shared.wait(second, 1.0)
    shared.wait(first, 1.0)
    shared.give_back(second)
    shared.wait(second, 1.0)
    assert over == [True, False, False, True, True]


def test_joined_bands_equal_the_whole_image():
    path, solids = case(View((0, 0, -1), 200, 50))
    image = CutImage(Cuts([Cut(path, solids["tool"])]), BOX, solids["view"].frame(BOX))
    (band,) = image.bands
    whole, tested = image(band)
    assert simulate(path, **solids, processes=1).candidates == tested
    parts = [image(band._replace(left=a, right=b)) for a, b in ((0, 64), (64, 192), (192, 200))]
    joined = side_by_side([records for records, _ in parts], 50)
    for part in ("index", "entry", "far", "owner"):
        assert np.array_equal(getattr(joined, part), getattr(whole, part))
        assert getattr(joined, part).dtype == getattr(whole, part).dtype
    assert joined.trajectories == whole.trajectories and sum(n for _, n in parts) == pytest.approx(tested, rel=0.01)


def test_work_is_divided_after_the_other_processes_have_started():
    assert shared_seconds(0.4, 8) == 0.4 and shared_seconds(20.0, 1) == 20.0
    assert 10 < shared_seconds(20.0, 2) < 11
    assert shared_seconds(0.85, 5) == 0.85 and shared_seconds(30.85, 5) == pytest.approx(0.85 + 6)


def test_estimate_uses_at_most_one_process_per_band():
    path, solids = case(View((1, 1, -1), 300, 200), moves=300)
    alone = estimate(path, None, **solids, speed=replace(Speed(), cell=1e-3)).seconds
    assert alone > 5
    # The 200 rows of pixels are four bands, and the path reaches all four bands.
    for processes, used in ((2, 2), (3, 3), (64, 4)):
        told = estimate(path, None, **solids, speed=replace(Speed(), cell=1e-3, processes=processes))
        assert told.seconds == pytest.approx(shared_seconds(alone, used))


def test_number_of_workers_is_limited_by_memory():
    path, solids = case()
    cuts = [Cut(path, solids["tool"])]
    removal = Removal(Cuts(cuts), BOX, WIDE.frame(BOX))
    needed = memory_needed(cuts, stock=BOX, view=WIDE)
    assert helpers_within(needed, removal, len(path)) == 0 == helpers_within(0.0, removal, len(path))
    assert helpers_within(needed + 65e6, removal, len(path)) == 0
    assert helpers_within(needed + 2 * 90e6, removal, len(path)) == 2
    assert helpers_within(np.inf, removal, len(path)) > 1000


def test_scarce_memory_allows_only_one_process(workers):
    path, solids = case()
    needed = memory_needed([Cut(path, solids["tool"])], stock=BOX, view=WIDE)
    assert simulate(path, **solids, memory_budget=1.01 * needed, processes=2).traces > 0
    assert not workers
    simulate(path, **solids, memory_budget=needed + 1e8, processes=2)
    assert len(workers) == 1


MEASURE = """
import resource, sys
from bisect import bisect_left
from pathlib import Path
sys.path[:0] = [{root!r}, {root!r} + "/tests"]
from vkworkbench.core import View
from vkworkbench.core.zbuffer import Cut, simulate
from vkworkbench.core.zbuffer.memory import memory as needs
from vkworkbench.core.zbuffer.simulator import sharing
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.rays.removal import Removal
from zbuffer_inputs import BOX, TOOLS, surface, toolpath

def memory(line):
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))

sharing._ALONE = -1.0
trajectories, direction, width, height = {case!r}
path, view = toolpath(surface(None, trajectories)), View(direction, width, height)
Path("/proc/self/clear_refs").write_text("5")
before = memory("VmRSS")
simulate(path, tool=TOOLS[2], stock=BOX, view=view, processes=2)
taken = memory("VmHWM") - before + 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
removal = Removal(Cuts([Cut(path, TOOLS[2])]), BOX, view.frame(BOX))
counts = needs.count(removal)
needs.count = lambda _: counts  # hundreds of rays for each budget that is tried
budget = needs.peak_of(counts, len(path), removal).bytes()
more = bisect_left(range(1000), 1, key=lambda mb: needs.helpers_within(budget + 1e6 * mb, removal, len(path)))
print(budget + 1e6 * more, taken)
"""


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="the peak is read from Linux's /proc")
@pytest.mark.parametrize(
    "which",
    [(6_000, (0, 0, -1), 320, 240), (3_000, (1, 1, -1), 400, 300), (40_000, (0, 0, -1), 120, 190)],
    ids=["records", "oblique", "trajectories"],
)
def test_processes_stay_within_memory_budget(which):
    script = MEASURE.format(root=str(ROOT), case=which)
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    budget, taken = (float(v) for v in run.stdout.split())
    assert taken < budget < 1.6 * taken
