# SPDX-License-Identifier: LGPL-2.1-or-later
"""Send random and mutated programs through the core. For more programs, run python3 tests/fuzz.py --count 10000."""

from __future__ import annotations

import fuzz
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.gcode.moves.linearize import MOST_TRAJECTORIES

# Seeds of random programs with which the core once failed, by the cause of the failure.
FAILED = {
    "chords finer than any number": [116, 147, 302, 441],
    "a list as a word": [201],
    "a feed rate whose time overflows": [1362, 1583],
    "moves of no length left": [323, 1273],
    "a negative count of dexels": [36, 59, 166],
    "a chord of next to nothing": [9389],
    "rows on one line": [1342, 1427, 1749],
    "no row along the densest direction": [2065],
}


@pytest.mark.long
@pytest.mark.parametrize("first", range(0, 200, 50))
def test_random_programs_do_not_fail(first):
    failures = {seed: result.outcome for seed in range(first, first + 50) if (result := fuzz.feed(seed)).failed}
    assert failures == {}


@pytest.mark.parametrize("seed", [seed for seeds in FAILED.values() for seed in seeds])
def test_programs_that_once_failed_do_not_fail(seed):
    result = fuzz.feed_program(*fuzz.flat_program(seed))
    assert not result.failed, result.outcome


def test_flat_end_moving_almost_along_the_ray_does_not_fail():
    result = fuzz.feed(62133)  # `feed` draws a view that is not the view from above.
    assert not result.failed, result.outcome


RAMP = [
    ("G0", {"X": 0.0, "Y": 25.0, "Z": 5.0}),
    ("G1", {"X": 50.0, "Z": -15.0, "F": 5.0}),
    ("G1", {"X": 0.0, "Z": 4.0}),
]


@pytest.mark.parametrize("diameter", [0.5, 5.0, 40.0])
@pytest.mark.parametrize("view", fuzz.VIEWS)
def test_ramps_are_simulated_in_every_view(view, diameter):
    result = fuzz.feed_program(RAMP, diameter=diameter, view=view)
    assert result.outcome == "read", result.outcome


HOLE = {"X": 0.0, "Y": 0.0, "Z": -100.0, "R": 1.0, "Q": 0.02, "F": 5.0}
CIRCLE = {"X": 900.0, "Y": 0.0, "I": -900.0, "J": 0.0, "F": 5.0}
HOSTILE = {
    "away by moves of no length and back": [("G1", {"X": x * 6e-10, "Y": 0.0, "Z": 0.0}) for x in (0, 1, 2, 0, 100, 0, 1, 2, 0)],
    "code of 5,000 digits": [("G" + "9" * 5000, {}), ("N" + "9" * 5000, {"X": 1.0})],
    "text for a code behind a line number": [("N10", {"G": "one", "X": 1.0}), ("N20", {"G": float("nan")})],
    "digits of another script": [("G١", {"X": 1.0}), ("X٣", {})],
    "no words at all": [("G1", None), ("N10", None), ("X1", None), ("G81", None), ("G2", None)],
    "relative moves out of this world": [("G91", {}), *[("G1", {"X": 1e6, "Z": 1e6, "F": 1.0})] * 2000],
    "relative cycles out of this world": [("G91", {}), *[("G83", {**HOLE, "Z": -1e6, "R": 1e6, "Q": 1e6})] * 2000],
    "the same point again and again": [("G1", {"X": 1.0, "Y": 1.0, "Z": 1.0, "F": 1.0})] * 2000,
    "back and forth without end": [("G1", {"X": float(i % 2), "F": 1.0}) for i in range(5000)],
    "a tool change before every move": [c for i in range(500) for c in [("M6", {}), ("G1", {"X": float(i), "F": 1.0})]],
    "a heading before every move": [c for i in range(500) for c in [(f"(Op {i})", {}), ("G1", {"X": float(i), "F": 1.0})]],
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_programs_written_to_break_the_reader_are_read(name):
    result = fuzz.feed_program(HOSTILE[name])
    assert result.outcome == "read", result.outcome


@pytest.mark.parametrize("command", [("G83", HOLE), ("G2", CIRCLE)])
def test_program_beyond_memory_is_refused(command):
    at_start = ("G0", {"X": 900.0, "Y": 0.0, "Z": 5.0})
    with pytest.raises(ValueError, match=r"moves at a tolerance of 1e-06 mm\. Choose a larger tolerance"):
        linearize([at_start] + [command] * (MOST_TRAJECTORIES // 5000), tolerance=1e-6)


@pytest.mark.parametrize("tolerance, chords", [(1e-6, 66644), (1e-2, 667), (10.0, 22), (1e3, 8), (1e300, 8)])
def test_number_of_chords_of_a_circle_follows_tolerance(tolerance, chords):
    path = linearize([("G0", {"X": 900.0, "Y": 0.0, "Z": 5.0}), ("G2", CIRCLE)], tolerance=tolerance)
    assert len(path) == chords
    assert path.sweep.sum() == pytest.approx(-2 * 3.141592653589793)
