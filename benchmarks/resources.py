# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the estimated cost of the extended z-buffer with the cost of exact simulations.

    python3 benchmarks/resources.py [time] [FILE.jsonl.gz ...]

Each line of a file is an operation: label, strategy, accept, tool_diameter, stock, commands. Without a file, the
operations come from toolpaths/synthetic.py. The exact simulations run at 800 x 600 pixels. Simulations with many
candidate pixels run at 400 x 300 pixels to limit their time, although small holes are then not round. Errors are ratios
of the larger to the smaller of estimate and exact value. Times are processor times. The speed of a shared computer
changes, so the speed is measured before each operation, and for a time budget also between the three simulations of an
operation. With `time`, the script only predicts the time of a simulation, for every third operation.
"""

from __future__ import annotations

import math
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from closed_form import closed_form, swept
from records import with_stock
from zbuffer_cases import CASES, stock_of

from toolpaths.synthetic import SAMPLES
from vkworkbench.core import Strategy, Tool, View
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import recognize
from vkworkbench.core.zbuffer import (
    RECORD_BYTES,
    Cut,
    Speed,
    best_resolution,
    cauchy_crofton,
    estimate,
    fit_speed,
    measure_speed,
    memory_needed,
    simulate,
)

MANY = 1.5e6  # number of candidate pixels above which a smaller image is simulated
ALLOWED = 2e9  # memory limit, bytes; `simulate` refuses simulations that need more
MOST = 25  # maximum number of operations from each file
VIEWS = {"top": (0, 0, -1), "tilted 30": (0, 0.5, -math.sqrt(0.75)), "isometric": (1, 1, -math.sqrt(2 / 3))}
FEWEST = 1000  # operations with fewer trace elements are left out, because ratios of small numbers are meaningless
SPEEDS = 5  # number of averaged measurements of the computer's speed


def main() -> None:
    names = [name for name in sys.argv[1:] if name != "time"]
    operations = [o for name in names for o in of_file(name)] if names else list(synthetic())
    if "time" in sys.argv[1:]:
        operations = operations[::3]
    print(f"{len(operations)} operations, {sum(len(o[1]) for o in operations)} trajectories")
    rows = {name: [] for name in VIEWS}
    for label, toolpath, found, tool, stock in operations:
        speed = mean_speed()
        for name, direction in VIEWS.items():
            view = View(direction)
            if estimate(toolpath, found, tool=tool, stock=stock, view=view).candidates > MANY:
                view = View(direction, 400, 300)
            row = measure(toolpath, found, tool, stock, view, speed)
            rows[name].append({"label": label, **row})
    if "time" in sys.argv[1:]:
        print_speed([r for name in VIEWS for r in rows[name]])
        return
    for name in VIEWS:
        print_errors(name, [r for r in rows[name] if r["traces"] >= FEWEST])
    print_times([r for name in VIEWS for r in rows[name]])
    print_speed([r for name in VIEWS for r in rows[name]])
    print_budgets(operations[:: max(1, len(operations) // 8)])
    print_papers_case()


def of_file(name: str):
    """Yield the operations in a file of JSON lines. 3D surfaces get a ball end mill, and carvings get a V-bit."""
    for record, stock in with_stock(name, MOST):
        toolpath = linearize(record["commands"])
        shape = {"Surface": "ballend", "Waterline": "ballend", "Vcarve": "vbit"}.get(record["label"].split(":")[0])
        tool = Tool(shape or "endmill", record["tool_diameter"])
        found = recognize(toolpath, tool_diameter=tool.diameter)
        if str(found.strategy) not in record["accept"]:
            found = replace(found, strategy=Strategy(record["strategy"]))
        if len(toolpath):
            yield record["label"], toolpath, found, tool, stock


def synthetic():
    """Yield operations of every strategy with a stock around them."""
    rng = np.random.default_rng(1)
    for label, accept, maker in SAMPLES:
        toolpath = linearize(maker(rng))
        found = recognize(toolpath, tool_diameter=5)
        if found.strategy not in accept:
            found = replace(found, strategy=Strategy(min(accept)))
        yield label, toolpath, found, Tool("endmill", 5), stock_of(toolpath)


def measure(toolpath, found, tool, stock, view, speed) -> dict[str, float]:
    """Return the exact counts and every estimate for one operation in one view."""
    solids = {"tool": tool, "stock": stock, "view": view}
    runs = []
    for _ in range(2):
        begin = time.process_time()
        exact = simulate(toolpath, **solids, processes=1)
        runs.append(time.process_time() - begin)
    durations = []
    for _ in range(3):
        begin = time.process_time()
        guess = estimate(toolpath, found, **solids, speed=speed)
        durations.append(time.process_time() - begin)
    return {
        "n": len(toolpath), "vertical": not any(view.direction[:2]),
        "traces": exact.traces, "dexels": exact.dexels, "seconds": min(runs),
        "rays": guess.traces, "rays error": guess.traces_error, "rays dexels": guess.dexels,
        "duration": min(durations), "closed form": closed_form(toolpath, found, **solids),
        "blind": swept(toolpath, **solids),
        "Cauchy-Crofton": cauchy_crofton(toolpath, stock=stock, view=view),
        "predicted": guess.seconds,
        "work": guess.work.amounts(),
    }  # fmt: skip


def mean_speed() -> Speed:
    """Return the mean of several measured speeds, because the speed of a shared processor changes within a second."""
    return Speed(*np.mean([measure_speed().constants for _ in range(SPEEDS)], axis=0))


def ratios(rows, estimated, true) -> np.ndarray:
    a, b = (np.maximum([r[name] for r in rows], 1e-9) for name in (estimated, true))
    return np.maximum(a / b, b / a)


def line(name: str, values: np.ndarray) -> str:
    median, p90, worst = np.percentile(values, (50, 90, 100))
    return f"  {name:36}{median:9.3f}{p90:9.3f}{min(worst, 99999):9.2f}"


def print_errors(view: str, rows) -> None:
    heading = f"{view}: {len(rows)} operations"
    print(f"\n{heading:38}   median      p90    worst")
    for name, estimated in (
        ("rays", "rays"),
        ("closed form, strategy known", "closed form"),
        ("swept area, strategy-blind", "blind"),
        ("Cauchy-Crofton", "Cauchy-Crofton"),
    ):
        print(line(f"traces, {name}", ratios(rows, estimated, "traces")))
    print(line("dexels, rays", ratios(rows, "rays dexels", "dexels")))
    inside = [abs(r["rays"] - r["traces"]) <= 2 * r["rays error"] for r in rows]
    print(f"  within two standard errors: {100 * np.mean(inside):.1f} %")
    for r in sorted(rows, key=lambda r: -ratios([r], "rays", "traces")[0])[:3]:
        print(
            f"    {r['label']}: {r['rays'] / r['traces']:.3f} of {r['traces']}, "
            f"{(r['rays'] - r['traces']) / r['rays error']:+.1f} standard errors"
        )


def print_times(rows) -> None:
    print("\ntime of an estimate, ms (best of 3)")
    for name, vertical in (("top", True), ("oblique", False)):
        some = [r for r in rows if r["vertical"] == vertical]
        longest = max(some, key=lambda r: r["duration"])
        print(
            f"  {name}: median {1e3 * np.median([r['duration'] for r in some]):.1f}, "
            f"longest {1e3 * longest['duration']:.0f} ({longest['n']} trajectories)"
        )
    gain = np.median([r["seconds"] / r["duration"] for r in rows])
    print(f"  the exact simulation takes {gain:.0f} times as long (median)")


def print_speed(rows) -> None:
    print("\nseconds of a simulation, predicted against really run     median      p90    worst")
    for name, some in (
        ("top", [r for r in rows if r["vertical"]]),
        ("oblique", [r for r in rows if not r["vertical"]]),
    ):
        print(line(f"  {name}", ratios(some, "predicted", "seconds")))
    seconds = np.array([r["seconds"] for r in rows])
    fitted = fit_speed(np.array([r["work"] for r in rows]), seconds)
    print(f"  fitted to all simulations: {fitted}")
    durations = []
    for _ in range(5):
        begin = time.process_time()
        measured = measure_speed()
        durations.append(time.process_time() - begin)
    print(f"  measured in {np.median(durations):.2f} s: {measured}")


def print_budgets(operations) -> None:
    print("\nbudgets: what came out, as a share of what was asked for")
    shares = {"memory_bytes": [], "seconds": []}
    for label, toolpath, found, tool, stock in operations:
        words = [f"  {label:28.28}"]
        for name, budget, asked in (("memory_bytes", 200e6, "200 MB"), ("seconds", 1.0, "1 s")):
            speed = mean_speed()
            guess = estimate(toolpath, found, tool=tool, stock=stock, view=View(), speed=speed)
            chosen = best_resolution([guess], **{"memory_bytes": ALLOWED, name: budget})
            if chosen.view is None:
                words.append(chosen.explanation)
                continue
            solids = {"tool": tool, "stock": stock, "view": chosen.view}
            if name == "seconds":
                came_out = seconds_at(speed, toolpath, **solids)
            else:
                came_out = memory_needed([Cut(toolpath, tool)], stock=stock, view=chosen.view)
            shares[name].append(came_out / budget)
            words.append(f"{asked}: {shares[name][-1]:.3f} at {chosen.view.width} x {chosen.view.height}")
        print("   ".join(words))
    for name, values in shares.items():
        low, median, high = np.percentile(values, (0, 50, 100))
        print(f"  {name}: median {median:.3f}, {low:.3f} to {high:.3f}")


def seconds_at(speed: Speed, toolpath, tool, stock, view) -> float:
    """Return the median time of three simulations, s, corrected to the computer's speed at the beginning."""
    durations, speeds = [], [speed]
    for _ in range(3):
        begin = time.process_time()
        simulate(toolpath, tool=tool, stock=stock, view=view, processes=1)
        durations.append(time.process_time() - begin)
        speeds.append(mean_speed())
    done = estimate(toolpath, None, tool=tool, stock=stock, view=view).work
    expected = np.array([each.seconds(done) for each in speeds])
    return float(np.median(durations / ((expected[:-1] + expected[1:]) / 2) * expected[0]))


def print_papers_case() -> None:
    toolpath, tool, stock = CASES["the paper's"]
    print(f"\nthe paper's case: zigzag, {len(toolpath)} trajectories, 800 x 600; in the paper 6 MB and 51 MB")
    for name, direction in VIEWS.items():
        view = View(direction)
        guess = estimate(toolpath, None, tool=tool, stock=stock, view=view)
        exact = simulate(toolpath, tool=tool, stock=stock, view=view)
        true_d, d = (RECORD_BYTES * z.dexels / 1e6 for z in (exact, guess))
        true_t, t, error = (RECORD_BYTES * n / 1e6 for n in (exact.traces, guess.traces, guess.traces_error))
        print(f"  {name:10} dexels {true_d:.1f} MB, estimated {d:.1f}; ", end="")
        print(f"traces {true_t:.0f} MB, estimated {t:.0f} +- {error:.1f}")


if __name__ == "__main__":
    main()
