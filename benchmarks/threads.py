# SPDX-License-Identifier: LGPL-2.1-or-later
"""What two threads gain: the bands of an image cut by one thread and by two, in turns.

    python3 benchmarks/threads.py

The cases of zbuffer_cases.py, from above at 800 x 600 and from (1, 1, -1) at 400 x 300. Printed is the wall time of one thread, the
median of the gains of two, and the best: on a computer with something else to do only the best tells.
The records are the same to the last bit, which is checked.
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

from vkworkbench.core import Cut, View
from vkworkbench.core.zbuffer.bands import cut_band
from vkworkbench.core.zbuffer.culling import TILE, culled
from vkworkbench.core.zbuffer.cuts import Cuts
from vkworkbench.core.zbuffer.removal import Removal
from vkworkbench.core.zbuffer.tilted import Tilted
from vkworkbench.core.zbuffer.upright import Upright

THREADS, TURNS = 2, 3


def main() -> None:
    print(
        f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}\n{'one thread, s':>48}   gain of {THREADS}, median / best"
    )
    for name, (toolpath, tool, stock) in CASES.items():
        for seen, view in (("from above", View()), ("from (1, 1, -1)", View((1, 1, -1), 400, 300))):
            one, gains = measured([Cut(toolpath, tool)], stock, view)
            print(f"{name:16}{seen:18}{one:14.2f}   {np.median(gains):.2f} / {max(gains):.2f}", flush=True)


def measured(cuts, stock, view):
    """Seconds of one thread, the best, and the gains of more in each turn."""
    numbered, frame = Cuts(cuts), view.frame(stock)
    removal = Removal(numbered, stock, frame)
    bounds = Upright(removal) if removal.sine == 0 else Tilted(removal)

    def band(bottom):
        return cut_band(removal, bounds, culled(removal, bounds, bottom), len(numbered), bottom)[0]

    def bands(threads):
        begin = time.perf_counter()
        with ThreadPoolExecutor(threads) as pool:
            records = list(pool.map(band, range(0, frame.height, TILE)))
        return time.perf_counter() - begin, records

    seconds, gains = [], []
    for _ in range(TURNS):
        one, expected = bands(1)
        more, found = bands(THREADS)
        for a, b in zip(expected, found):
            assert all(
                np.array_equal(getattr(a, part), getattr(b, part)) for part in ("index", "entry", "far", "owner")
            )
        seconds.append(one)
        gains.append(one / more)
    return min(seconds), gains


if __name__ == "__main__":
    main()
