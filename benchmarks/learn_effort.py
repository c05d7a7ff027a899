# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn the time for each kind of the z-buffer's work, for `core/zbuffer/cost/effort.py`.

    python3 benchmarks/learn_effort.py

Every toolpath of toolpaths/synthetic.py and zbuffer_cases.py is simulated with tools of two or four shapes, in two of
five image sizes and in one of four views. The processor time is the better of two runs. The processor time is modelled
as a sum of amounts of work times unknown costs. The costs minimise the squared relative errors, are not negative, and
are pulled slightly towards usual costs. The script prints the errors for toolpaths that were left out of the fit, the
tables of effort.py and the constants of `Speed`. benchmarks/resources.py tests the learned costs with other toolpaths.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from zbuffer_cases import CASES, stock_of

from toolpaths.synthetic import SAMPLES
from vkworkbench.core import Tool, View, estimate, simulate
from vkworkbench.core.gcode import linearize

RUNS = 2
# Widths of the simulated images, pixels. In large images, most of the time is spent on the pixels themselves, because
# few pairs of a tile and a trajectory belong to each pixel.
SIZES = (240, 400, 640, 1600, 3200)
DIRECTIONS = ((0, 0, -1), (0, 0, -1), (1, 1, -1), (0, 0.5, -1), (1, -2, -0.3))
# Simulations with a longer estimated time, s, are left out because they take too long. Simulations with a shorter
# measured time are left out because their time cannot be distinguished from noise.
LONGEST, SHORTEST = 2.0, 3e-3
FOLDS = 10
# Approximate cost of each amount of work, s. The ridge regression adds one equation for each approximate cost, with the
# weight RIDGE; the equation of a measured run has the weight 1.
USUAL = 1e-6 * np.array([2, 0.03, 0.005, 300, 0.035, 0.18, *[0.06, 0.35] * 8, *[0.05, 0.4] * 8, 0.1])
RIDGE = 0.3
STEPS = 20_000
# Columns of the amounts of work (see `Work`): trajectories, pixels, pairs of a trajectory and a tile of the largest
# size, and batches; then the stored records (dexels, trace elements and gaps) in a vertical and in an oblique view; then
# tests and cells (pairs of a pixel and a trajectory that cuts its ray) by kind of trajectory; then sorted cells.
PLAIN, RECORDS, TESTS, CELLS, SORTED = slice(0, 4), slice(4, 6), slice(6, 22), slice(22, 38), slice(38, 39)


def main() -> None:
    learn(*map(np.array, zip(*runs())))


def runs():
    """Return the amounts of work, the time, s, and the number of the toolpath for each simulation."""
    rng = np.random.default_rng(5)
    for source, toolpath, tool, stock in operations(rng):
        direction = DIRECTIONS[rng.integers(len(DIRECTIONS))]
        for width in rng.permutation(SIZES)[:2].tolist():
            solids = {"tool": tool, "stock": stock, "view": View(direction, width, width * 3 // 4)}
            found = estimate(toolpath, None, **solids)
            if found.seconds < LONGEST:
                yield amounts(found.work), best_time(toolpath, **solids), source


def operations(rng):
    """Yield the number of its toolpath, the toolpath, the tool and the stock of each operation."""
    for source, (_, _, maker) in enumerate(SAMPLES):
        toolpath = linearize(maker(rng))
        for shape in rng.permutation(4)[:2]:
            yield source, toolpath, tool_of(shape, rng.uniform(3, 10)), stock_of(toolpath)
    for source, (toolpath, tool, stock) in enumerate(CASES.values(), len(SAMPLES)):
        yield source, toolpath, tool, stock
        for shape in range(4):
            yield source, toolpath, tool_of(shape, rng.uniform(3, 10)), stock


def tool_of(shape: int, diameter: float) -> Tool:
    """Return a tool with a flat, pointed, ball or bull-nose end."""
    if shape == 3:
        return Tool("bullnose", diameter, corner_radius=diameter / 5)
    return Tool(("endmill", "vbit", "ballend")[shape], diameter)


def best_time(toolpath, **solids) -> float:
    """Return the processor time of the fastest run, s."""
    times = []
    for _ in range(RUNS):
        begin = time.process_time()
        simulate(toolpath, **solids, processes=1)
        times.append(time.process_time() - begin)
    return min(times)


def amounts(work) -> np.ndarray:
    """Return the amounts of each kind of work in one simulation, (39,)."""
    blocks = work.amounts()[3]
    plain = [work.trajectories, work.pixels, work.first, blocks]
    tests, sorted_ = 4 * np.reshape(work.pairs, (-1, 16)).sum(axis=0), work.unconnected * sum(work.cells)
    return np.concatenate((plain, work.records, tests, work.cells, [sorted_]))


def learn(rows: np.ndarray, seconds: np.ndarray, source: np.ndarray) -> None:
    """Fit the costs of the amounts (k, 39) to the times of runs. Print the costs, and errors on left-out toolpaths."""
    long = seconds > SHORTEST
    rows, seconds, source = rows[long], seconds[long], source[long]
    predicted = np.empty(len(seconds))
    for fold in range(FOLDS):
        out = source % FOLDS == fold
        predicted[out] = rows[out] @ costs_of(rows[~out] / seconds[~out, None])
    off = np.exp(np.abs(np.log(predicted / seconds)))
    above = rows[:, RECORDS][:, 0] > 0
    for seen, some in (("from above", above), ("obliquely", ~above)):
        median, p90, worst = np.percentile(off[some], (50, 90, 100))
        print(f"{seen}: {some.sum()} runs of toolpaths left out: median {median:.2f}, p90 {p90:.2f}, worst {worst:.2f}")
    costs = costs_of(rows / seconds[:, None])
    test, cell, record = costs[TESTS].max(), costs[CELLS].max(), costs[RECORDS][0]
    np.set_printoptions(suppress=True, linewidth=120)
    for name, values in (
        ("TESTS", costs[TESTS] / test), ("CELLS", costs[CELLS] / cell), ("SORTED", costs[SORTED] / cell),
        ("RECORDS", costs[RECORDS] / record),
    ):  # fmt: skip
        print(f"{name} = {', '.join(f'{value:.3f}' for value in values)}")
    print("Speed:", ", ".join(f"{value:.3g}" for value in (*costs[PLAIN], test, cell, record)))


def costs_of(relative: np.ndarray) -> np.ndarray:
    """Return the costs (39,) for which `relative` (k, 39), amounts / measured times, @ costs is about 1."""
    return positive(
        np.vstack((relative, RIDGE * np.diag(1 / USUAL))), np.append(np.ones(len(relative)), np.full(len(USUAL), RIDGE))
    )


def positive(rows: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return the non-negative costs (n,) with the least squared error of `rows` @ costs (Lee and Seung 2001)."""
    scale = rows.max(axis=0)
    rows = rows / scale
    costs = np.full(rows.shape[1], 1 / rows.sum(axis=1).mean())
    wanted, square = rows.T @ right, rows.T @ rows
    for _ in range(STEPS):
        costs *= wanted / (square @ costs + 1e-300)
    result: np.ndarray = costs / scale
    return result


if __name__ == "__main__":
    main()
