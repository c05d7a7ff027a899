# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the estimated and the exact cost of simulating a job in the extended z-buffer.

    freecadcmd "$PWD/benchmarks/job_totals.py"

The jobs are the example job, and random jobs of toolpaths from toolpaths/synthetic.py in a box around all toolpaths.
The script prints the exact cost, the estimated total, and the sum of the operations' separate estimates. Errors are
ratios of the larger to the smaller value. Then the script prints the processor time of analyses, the best of three.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "benchmarks")]

from make_example import make_example
from zbuffer_cases import stock_of

import vkworkbench
from toolpaths.synthetic import SAMPLES
from vkworkbench.core import Cut, Tool, View, estimate, simulate_job
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators import zbuffer
from vkworkbench.core.zbuffer import Speed, measure_speed
from vkworkbench.document.job.results import RESULTS
from vkworkbench.document.simulation.copy import read_job

JOBS, RUNS = 20, 3
DIRECTIONS = {"from above": (0, 0, -1), "from (1, 1, -1)": (1, 1, -1)}
# A copy of the standard output, because FreeCAD writes its progress to the original.
OUT = os.fdopen(os.dup(1), "w")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


def main() -> None:
    speed = Speed(*np.mean([measure_speed().constants for _ in range(3)], axis=0))
    with tempfile.TemporaryDirectory() as folder:
        document = make_example(Path(folder) / "example.FCStd")
        job = read_job(document)
        jobs = list(random_jobs(np.random.default_rng(15)))
        for name, direction in DIRECTIONS.items():
            print(f"\n{name}                  true      total         sum of each alone", file=OUT)
            told(job.cuts, job.stock, View(direction), speed)
            rows = [errors(cuts, stock, View(direction, 400, 300), speed) for cuts, stock in jobs]
            for number, what in enumerate(("traces", "memory", "time")):
                total, alone = np.array([row[number] for row in rows]).T
                print(
                    f"{len(rows)} random jobs, {what}: total {spread(total)}, sum {spread(alone)}", file=OUT, flush=True
                )
        analyses(document)


def told(cuts, stock, view, speed) -> None:
    """Print the exact and the estimated cost of the example job."""
    whole, alone = estimates(cuts, stock, view, speed)
    begin = time.process_time()
    true = simulate_job(cuts, stock=stock, view=view, processes=1)
    seconds = time.process_time() - begin
    added = summed(alone)
    for what, real, total, before in (
        ("memory, MB", true.peak.bytes() / 1e6, whole.memory_bytes / 1e6, added.memory_bytes / 1e6),
        ("traces, millions", true.traces / 1e6, whole.traces / 1e6, sum(e.traces for e in alone) / 1e6),
        ("time, s", seconds, whole.seconds, added.seconds),
    ):
        print(f"  the example job: {what:18}{real:8.2f}{total:11.2f}{before:11.2f}", file=OUT, flush=True)


def estimates(cuts, stock, view, speed):
    """Return the cost of the job, and the costs of its operations simulated separately."""
    alone = [estimate(cut.toolpath, None, tool=cut.tool, stock=stock, view=view, speed=speed) for cut in cuts]
    return zbuffer.together(alone), alone


def summed(alone) -> zbuffer.ZBufferCost:
    """Return the sum of the operations' costs, as the add-on does if operations are known only from their marks."""
    return zbuffer.together([zbuffer.ZBufferCost(e.seconds, e.memory_bytes, e.factor, e.stock_bytes) for e in alone])


def errors(cuts, stock, view, speed):
    """Return the errors of traces, memory and time, for a job's total and for the sum of its operations."""
    whole, alone = estimates(cuts, stock, view, speed)
    begin = time.process_time()
    true = simulate_job(cuts, stock=stock, view=view, processes=1)
    seconds = time.process_time() - begin
    added = summed(alone)
    return (
        (ratio(whole.traces, true.traces), ratio(sum(e.traces for e in alone), true.traces)),
        (ratio(whole.memory_bytes, true.peak.bytes()), ratio(added.memory_bytes, true.peak.bytes())),
        (ratio(whole.seconds, seconds), ratio(added.seconds, seconds)),
    )


def random_jobs(rng):
    """Yield cuts and stock of jobs of two to six operations that overlap each other."""
    for _ in range(JOBS):
        cuts = []
        for number in rng.choice(len(SAMPLES), rng.integers(2, 7)):
            toolpath = linearize(SAMPLES[number][2](rng))
            cuts.append(Cut(toolpath, Tool(str(rng.choice(["endmill", "ballend"])), float(rng.choice([4, 6, 10])))))
        yield cuts, stock_of(*(cut.toolpath for cut in cuts))


def ratio(one: float, other: float) -> float:
    return max(one, other) / max(min(one, other), 1e-9)


def spread(values) -> str:
    return f"{np.median(values):.2f} median, {max(values):.2f} worst"


def analyses(document) -> None:
    """Print the times for an analysis of the example job, for its operations' z-buffer costs, and for its total cost."""
    least = [np.inf] * 3
    for _ in range(RUNS):
        RESULTS.clear()
        begin = time.process_time()
        report = vkworkbench.analyze(document)
        analysed = time.process_time()
        for operation in report.operations:
            operation.cost("z-buffer")
        alone = time.process_time()
        report.totals[0].cost("z-buffer")
        times = analysed - begin, alone - analysed, time.process_time() - alone
        least = [min(pair) for pair in zip(least, times)]
    print(
        "\nthe example job, ms: an analysis {:.0f}, its operations in the z-buffer {:.0f}, its total {:.0f}".format(
            *(1e3 * seconds for seconds in least)
        ),
        file=OUT,
        flush=True,
    )


main()
