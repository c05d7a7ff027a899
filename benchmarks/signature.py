#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the time for the signature with the time for plain numpy steps, for different numbers of trajectories.

    python3 benchmarks/signature.py

The paper says: "for the machining program composed of more than 17,000 trajectories, the execution time is about less
than one milli-second". Only ratios within one run are comparable, because the times depend on the computer.
"""

import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from vkworkbench.core import signature


def obvious(points):
    """Return alpha, the turns and phi, computed by plain numpy steps."""
    step = np.diff(points, axis=0)
    alpha = np.arctan2(step[:, 1], step[:, 0])
    turning = (np.diff(alpha) + np.pi) % (2 * np.pi) - np.pi
    return alpha, turning, np.concatenate([[0.0], np.cumsum(turning)])


def zigzag(count):
    """Return rows of 1,000 short trajectories each, as on a sculptured surface."""
    k = np.arange(count + 1)
    row, place = np.divmod(k, 1000)
    x = np.where(row % 2 == 0, place, 1000 - place) * 0.1
    return np.column_stack([x, 0.5 * row + 0.01 * np.sin(0.3 * k)])


def best_pair(first, second, runs):
    """Return the shortest time of each of two functions, which are called alternately to run at the same speed."""
    times = np.empty((runs, 2))
    for run in range(runs):
        for column, function in enumerate((first, second)):
            begin = time.perf_counter()
            function()
            times[run, column] = time.perf_counter() - begin
    return times.min(axis=0)


def main():
    points = zigzag(17_000)
    assert np.allclose(signature(points).phi, obvious(points)[2])
    ours, theirs = best_pair(lambda: signature(points).level, lambda: obvious(points), 200)
    everything, _ = best_pair(lambda: signature(points).theta_level, lambda: obvious(points), 200)
    print(f"17,000 trajectories, numpy {np.__version__}")
    print(f"  alpha, turning, phi, level, reversals  {ours * 1e3:6.3f} ms  {ours / theirs:5.2f} x the obvious pipeline")
    print(f"  the same and V_k, theta_level          {everything * 1e3:6.3f} ms  {everything / theirs:5.2f} x")
    print(f"  obvious: arctan2, wrap, cumsum         {theirs * 1e3:6.3f} ms   1.00 x")
    print("growth")
    for count in (1_000, 10_000, 100_000, 1_000_000):
        points = zigzag(count)
        ours, theirs = best_pair(lambda: signature(points).level, lambda: obvious(points), max(5, 10**6 // count // 5))
        print(f"  {count:9,} trajectories  {ours / count * 1e9:6.1f} ns each  {ours / theirs:5.2f} x")


if __name__ == "__main__":
    main()
