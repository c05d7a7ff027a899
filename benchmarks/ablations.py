# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print how the predicted time of the z-buffer worsens when parts of its model are taken out.

    python3 benchmarks/ablations.py

Every ninth operation of benchmarks/learn_effort.py, and adaptive clearing with up to 96,000 trajectories, are simulated
from above and obliquely. All predictions of a model are scaled by one factor, so that the median ratio of predicted to
measured time is 1. The errors are ratios of the larger to the smaller of prediction and processor time.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from learn_effort import LONGEST, SHORTEST, best_time, operations

from vkworkbench.core import Speed, Stock, Tool, Toolpath, View, estimate
from vkworkbench.core.zbuffer.cost.effort import CELLS, TESTS

SPEED = Speed()
VIEWS = {"from above": View((0, 0, -1), 400, 300), "obliquely": View((1, 1, -1), 400, 300)}


def adaptive(step: float) -> Toolpath:
    """Return loops of 2 mm radius that advance by `step` mm, in ten rows over a plate of 100 by 80 mm."""
    along = np.arange(0, 10 * 90, step)
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    x, y = 5 + along % 90, 6 + 7 * (along // 90)
    loops = (x[:, None] + 2 * np.cos(turn), y[:, None] + 2 * np.sin(turn), np.full((len(along), 24), 10.0))
    return Toolpath.through(np.stack(loops, axis=2).reshape(-1, 3))


def samples():
    """Yield the toolpaths that are simulated, with their tools and stocks."""
    for _, toolpath, tool, stock in list(operations(np.random.default_rng(5)))[::9]:
        yield toolpath, tool, stock
    for step in (0.9, 0.225):
        yield adaptive(step), Tool("endmill", 6), Stock((0, 0, 0), (100, 80, 20))


def models(found) -> dict[str, float]:
    """Return the time of a simulation as each model predicts it, s; `found` is the estimate of the simulation."""
    work, constants = found.work, SPEED.constants
    amounts = work.amounts()
    equal, rays = amounts.copy(), amounts.copy()
    equal[4] = 4 * np.sum(work.pairs) * TESTS.mean()
    equal[5] = sum(work.cells) * CELLS.mean()
    rays[2:5], rays[5] = 0, found.candidates * CELLS.mean()
    return {
        "complete model": float(amounts @ constants),
        "no time for sorting intervals": SPEED.seconds(replace(work, unconnected=0.0)),
        "equal costs for all tools and views": float(equal @ constants),
        "trajectories over the sampled rays, no culled tiles": float(rays @ constants),
    }


def main() -> None:
    predicted, seconds, seen = [], [], []
    for toolpath, tool, stock in samples():
        for name, view in VIEWS.items():
            found = estimate(toolpath, None, tool=tool, stock=stock, view=view)
            if found.seconds < LONGEST:
                predicted.append(models(found))
                seconds.append(best_time(toolpath, tool=tool, stock=stock, view=view))
                seen.append(name)
    times, names = np.array(seconds), np.array(seen)
    long = times > SHORTEST
    print(f"{long.sum()} simulations, error median / p90 / worst")
    for model in predicted[0]:
        ratio = np.array([one[model] for one in predicted]) / times
        error = np.exp(np.abs(np.log(ratio / np.median(ratio[long]))))
        texts = [
            f"{name} "
            + " / ".join(f"{value:.2f}" for value in np.percentile(error[long & (names == name)], (50, 90, 100)))
            for name in VIEWS
        ]
        print(f"{model:54}{'   '.join(texts)}")


if __name__ == "__main__":
    main()
