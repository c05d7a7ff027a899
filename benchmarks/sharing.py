# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the speed gain of several processes and of threads, compared with one process.

    python3 benchmarks/sharing.py

The script simulates the cases of zbuffer_cases.py at 800 x 600 pixels, from above and obliquely, alternately with one
and with several processes. The script prints the wall time of one process, the measured and the predicted gain of two
processes (and of more, if there are more cores), and the gain of two threads, as medians of several turns. The script
checks that the dexels and trace elements of all simulations are exactly equal. The results are valid only on an idle
computer.
"""

from __future__ import annotations

import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parent.parent), str(Path(__file__).resolve().parent)]

from zbuffer_cases import CASES

from vkworkbench.core import Cut, View, simulate_job
from vkworkbench.core.zbuffer import shared_seconds
from vkworkbench.core.zbuffer.simulator.cut_image import CutImage
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.worker import processes

TURNS = 3


def main() -> None:
    several = sorted({2, processes()} - {1})
    gains = "".join(f"{n:6} processes, told" for n in several)
    print(f"{processes()} cores, load {os.getloadavg()[0]:.1f}\n{'one process, s':>48}{gains}     2 threads")
    for name, (toolpath, tool, stock) in CASES.items():
        for seen, view in (("from above", View()), ("from (1, 1, -1)", View((1, 1, -1)))):
            cuts = [Cut(toolpath, tool)]
            alone, shared, threads = measured(cuts, stock, view, several)
            told = "".join(
                f"{alone / seconds:16.2f}{alone / shared_seconds(alone, n):6.2f}" for n, seconds in zip(several, shared)
            )
            print(f"{name:16}{seen:18}{alone:14.2f}{told}{threads:14.2f}", flush=True)


def measured(cuts, stock, view, several):
    """Return the time of one process, s, the times of several processes, s, and the gain of two threads."""
    alone, shared, threads = [], [], []
    for _ in range(TURNS):
        seconds, expected = timed(lambda: simulate_job(cuts, stock=stock, view=view, processes=1))
        alone.append(seconds)
        times = []
        for count in several:
            seconds, found = timed(lambda count=count: simulate_job(cuts, stock=stock, view=view, processes=count))
            times.append(seconds)
            for part in ("index", "entry", "far", "owner"):
                assert np.array_equal(getattr(expected.records, part), getattr(found.records, part))
        shared.append(times)
        image = CutImage(Cuts(cuts), stock, view.frame(stock))
        one, _ = timed(lambda: [image(band) for band in image.bands])
        with ThreadPoolExecutor(2) as pool:
            two, _ = timed(lambda: list(pool.map(image, image.bands)))
        threads.append(one / two)
    return np.median(alone), np.median(shared, axis=0), np.median(threads)


def timed(function):
    begin = time.perf_counter()
    result = function()
    return time.perf_counter() - begin, result


if __name__ == "__main__":
    main()
