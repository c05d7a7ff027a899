# SPDX-License-Identifier: LGPL-2.1-or-later
"""Send random and mutated programs through the whole core, which may raise only documented ValueErrors.

    python3 tests/fuzz.py [--count 10000] [--seed 0] [--minutes M]

Prints the numbers of programs that were read, refused or failed (with the seed of each failure), the longest time per
command and trajectory, and the peak memory. Exits with 1 if a program failed. Add the seed of a failure to
tests/core/gcode/test_vk_fuzz.py.
"""

from __future__ import annotations

import argparse
import math
import random
import resource
import sys
import time
import traceback
import warnings
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT)]
import programs

from vkworkbench.core import Stock, Strategy, Tool, View, estimate, linearize, machining, recognize, signature
from vkworkbench.core.gcode import Words
from vkworkbench.core.simulators import Conditions, Task, opengl_cost, preflight
from vkworkbench.preferences import DIRECTIONS

# Longest allowed processor time for one program, which is linear: START + EACH * (commands + trajectories).
START, EACH = 0.5, 50e-6  # s

STOCK = Stock((-10, -10, -20), (60, 60, 0))
VIEWS = {name: View(direction, width=80, height=60) for name, direction in DIRECTIONS.items()}
REFUSALS = "tolerance must be", "The arcs and cycles would need"  # how the messages of documented ValueErrors begin

CODES = ["G0", "G1", "G2", "G3", "G00", "G01", "g1", "G17", "G18", "G19", "G20", "G21", "G38.2", "G40", "G43", "G54",
         "G73", "G80", "G81", "G82", "G83", "G85", "G89", "G90", "G91", "G90.1", "G91.1", "G94", "G98", "G99",
         "M3", "M6", "M06", "T1", "F100", "S500", "N10", "N10 ", "X1", "Y-2.5", " Z3", "", " "]  # fmt: skip
STRANGE = ["G", "G-1", "G999", "G12345678901234567890", "G" + "9" * 5000, "X" + "9" * 400, "Z1e5", "N", "%", "/G1 X1",
           ";", "(", "()", "(Ж 🙂 \u200fעברית)", "( = ", "Г1", "G١", "X٣", "ǅ", "ß", "\x00", "\n", "{0}", "<b>", "O100", "E1",
           "G1 X10", "G1.55", "G1.", "M", "(" + "a" * 10000 + ")"]  # fmt: skip
LETTERS = "XYZIJKRQFPSLABCUVWHDNG"
NUMBERS = [0.0, -0.0, 1.0, -1.0, 10.0, 1e-12, 1e-300, 5e-324, 1e-6, 0.1, 1e3, 1e6, -1e6, 1e9, 1e155, 1e300, 1e308, -1e308,
           math.nan, math.inf, -math.inf, 3, True, 2**80, 10**400, None, "7", "1,5", "", "nan", [], 1j]  # fmt: skip
TOOLS = [None, 0.0, 5.0, 6, 0.1, 1e-9, 1e6, -3.0, math.nan, math.inf]


def number(rng):
    return rng.choice(NUMBERS) if rng.random() < 0.3 else rng.uniform(-60, 60) * rng.choice([1, 1, 1, 1e-3, 1e4])


def words(rng):
    letters = LETTERS[:8] if rng.random() < 0.8 else LETTERS
    return {rng.choice(letters): number(rng) for _ in range(rng.randrange(6))}


def command(rng):
    name = rng.choice(CODES if rng.random() < 0.9 else STRANGE)
    return name, rng.choice([{}, None]) if rng.random() < 0.02 else words(rng)


def mutated(rng, commands):
    """Return a program with some of its commands changed, deleted, inserted, reversed, repeated or scaled."""
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        at = rng.randrange(len(commands)) if commands else 0
        to = min(at + rng.randrange(1, 40), len(commands))
        name, values = commands[at] if commands else ("", {})
        values = dict(values or {})
        what = rng.randrange(8)
        if what == 0:
            commands[at:to] = []
        elif what == 1:
            commands[at:to] = commands[at:to] * rng.randrange(2, 20)
        elif what == 2:
            commands.insert(at, command(rng))
        elif what == 3:
            commands[at:to] = commands[at:to][::-1]
        elif what == 4 and values:
            values.pop(rng.choice(list(values)))
            commands[at] = (name, values)
        elif what == 5 and values:
            values[rng.choice(list(values))] = number(rng)
            commands[at] = (name, values)
        elif what == 6 and commands:
            commands[at] = (rng.choice(CODES), values)
        elif what == 7:
            scale = 10.0 ** rng.randrange(-9, 7)
            commands[:] = [(n, {k: scaled(v, scale) for k, v in (w or {}).items()}) for n, w in commands]
    return commands


def scaled(value, scale):
    return value * scale if isinstance(value, float) else value


def program(seed):
    """Return the input of the core for a seed: commands, tolerance, tool diameter and the name of the view."""
    rng = random.Random(f"view {seed}")
    commands, tolerance, diameter = flat_program(seed)
    if rng.random() < 0.3:
        commands = slanted(commands, rng.choice([-2.0, -0.5, -0.1, 0.1, 0.5, 2.0]))
    return commands, tolerance, diameter, rng.choice(list(VIEWS))


def slanted(commands, slope):
    """Return the program with every move in X converted to a ramp."""
    return [
        (name, {**words, "Z": slope * words["X"]} if words and usable(words.get("X")) else words)
        for name, words in commands
    ]


def usable(value):
    return isinstance(value, float) and abs(value) < 1e100


def flat_program(seed):
    """Return commands, tolerance and tool diameter. The commands are random words or mutated valid programs."""
    rng = random.Random(seed)
    if rng.random() < 0.5:
        commands = [command(rng) for _ in range(int(10 ** rng.uniform(0, 2.5)) - 1)]
    else:
        makers = list(programs.SOUND.values())
        commands = [c for _ in range(rng.choice([1, 1, 1, 2, 3])) for c in rng.choice(makers)()]
        commands = mutated(rng, commands)
    # Most programs are short, a few are long, and one in 5,000 is very long.
    repeat = rng.random()
    if commands and repeat < 0.01:
        length = 1_000_000 if repeat < 0.0002 else 100_000 if repeat < 0.001 else 10_000
        commands = (commands * (length // len(commands) + 1))[:length]
    tolerance = rng.choice([0.01] * 20 + [0.1, 1e-3, 1.0, 1e6, 1e-300, 0.0, -1.0, math.nan, math.inf])
    return commands, tolerance, rng.choice(TOOLS)


@dataclass
class Result:
    """The outcome, size and processor time of one program."""

    outcome: str  # "read", "refused" or a description of the failure
    commands: int
    trajectories: int
    seconds: float

    @property
    def failed(self):
        return self.outcome not in ("read", "refused")

    @property
    def allowed(self):
        return START + EACH * (self.commands + self.trajectories)


def feed(seed):
    """Send the program of a seed through the core and check the results."""
    return feed_program(*program(seed))


def feed_program(commands, tolerance=0.01, diameter=5.0, view="Top"):
    count, path = len(commands), ()
    start = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            # Numpy 1.17 warns if NaN is compared with a number.
            warnings.filterwarnings("ignore", "invalid value encountered in (less|greater)")
            try:
                words = Words(commands)
                path = linearize(words, tolerance=tolerance)
            except ValueError as error:
                assert str(error).startswith(REFUSALS), error
                return Result("refused", count, 0, time.process_time() - start)
            check_toolpath(path, count)
            found = recognize(path, tool_diameter=diameter)
            check_recognition(found, path)
            measured = machining(path)
            assert math.isfinite(measured.cutting_length) and measured.cutting_length >= 0
            phi = signature(path.points).phi
            assert len(phi) == len(path) and np.isfinite(phi).all()
            try:
                tool = Tool("endmill", diameter)
            except (TypeError, ValueError):  # without a valid diameter, no cost can be estimated
                tool = None
            if tool is not None:
                cost = estimate(path, found, tool=tool, stock=STOCK, view=VIEWS[view])
                check_estimate(cost)
                opengl_cost(Task(path, tool, STOCK))
            preflight(Task(path, tool, STOCK, words), {}, Conditions(version=(1, 0)))
    except Exception as error:
        return Result(where(error), count, len(path), time.process_time() - start)
    result = Result("read", count, len(path), time.process_time() - start)
    if result.seconds > result.allowed:
        result.outcome = f"slow: {result.seconds:.2f} s"
    return result


def where(error):
    """Return the error and the line of this repository that raised the error."""
    # Make file names absolute, because in Python 3.8 a script's own name is the path in the command line.
    frames = [f for f in traceback.extract_tb(error.__traceback__) if ROOT in Path(f.filename).resolve().parents]
    frame = frames[-1]
    return f"{type(error).__name__}: {error} at {Path(frame.filename).name}:{frame.lineno} {frame.line}"


def check_toolpath(path, count):
    n = len(path)
    assert path.commands == count and path.points.shape == ((n + 1, 3) if len(path.points) else (0, 3))
    assert np.isfinite(path.points).all() and np.isfinite(path.feed).all() and np.isfinite(path.sweep).all()
    assert (path.lengths > 0).all() and (path.feed >= 0).all()
    assert n == 0 or (path.command.min() >= 0 and path.command.max() < count and (np.diff(path.command) >= 0).all())
    assert all(0 <= at <= n for at, _ in path.comments) and all(str(problem) for problem in path.problems)


def check_recognition(found, path):
    assert isinstance(found.strategy, Strategy) and 0 <= found.confidence <= 1 and found.reason
    assert math.isfinite(found.phi_range[0]) and math.isfinite(found.phi_range[1])
    assert all(0 <= span.first <= span.last < len(path) and 0 <= span.share <= 1 + 1e-9 for span in found.spans)
    assert (found.strategy is Strategy.EMPTY) == bool(path.rapid.all())


def check_estimate(cost):
    for value in (cost.dexels, cost.traces, cost.traces_error, cost.memory_bytes, cost.seconds):
        assert math.isfinite(value) and value >= 0


def main(arguments=None):
    """Run a number of programs, or programs for a number of minutes, print a summary, and return 1 if one failed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--minutes", type=float)
    chosen = parser.parse_args(arguments)
    until = time.monotonic() + 60 * chosen.minutes if chosen.minutes else math.inf
    most, count = chosen.count or (10**12 if chosen.minutes else 10_000), 0
    warm = feed_program(programs.zigzag())
    assert not warm.failed, warm.outcome
    outcomes, commands, trajectories, peak_of = Counter(), 0, 0, ""
    begin, peak, worst, longest = time.perf_counter(), peak_memory(), (0.0, 0), (0.0, 0)
    for seed in range(chosen.seed, chosen.seed + most):
        if time.monotonic() > until:
            break
        count += 1
        result = feed(seed)
        if result.outcome.startswith("slow"):
            result = feed(seed)  # try again, because the computer may have paused during the first try
        commands, trajectories = commands + result.commands, trajectories + result.trajectories
        outcomes["failed" if result.failed else result.outcome] += 1
        if result.failed:
            print(f"seed {seed}, {result.commands} commands: {result.outcome}", flush=True)
        if result.commands >= 1000:
            worst = max(worst, (result.seconds / (result.commands + result.trajectories), seed))
        longest = max(longest, (result.seconds / result.allowed, seed))
        if peak_memory() > peak:
            peak, peak_of = (
                peak_memory(),
                f"at seed {seed}: {result.commands:,} commands, {result.trajectories:,} trajectories",
            )
    print(f"{count:,} programs, {commands:,} commands, {trajectories:,} trajectories in "
          f"{time.perf_counter() - begin:.0f} s: {outcomes['read']} read, {outcomes['refused']} refused, "
          f"{outcomes['failed']} failed")  # fmt: skip
    print(
        f"most time per command and trajectory in programs of 1,000 commands or more: {1e6 * worst[0]:.0f} us (seed {worst[1]})"
    )
    print(f"most of the allowed time, {START} s + {1e6 * EACH:.0f} us per command and trajectory: "
          f"{longest[0]:.0%} (seed {longest[1]})")  # fmt: skip
    print(f"peak memory of the process: {peak / 1e6:.0f} MB {peak_of}")
    return 1 if outcomes["failed"] else 0


def peak_memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


if __name__ == "__main__":
    sys.exit(main())
