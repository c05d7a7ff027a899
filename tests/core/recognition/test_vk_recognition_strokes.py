# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open strokes, and contours with additions of CAM programs, in several sizes, directions and formats."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import programs
import pytest

from toolpaths.strokes import SAMPLES, dogbones, entered, open_adaptive, open_offsets, ramps
from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.patterns.spurs import without_spurs
from vkworkbench.core.recognition.verdict.rules import judge_section

SEEDS = 8


@pytest.mark.long
@pytest.mark.parametrize("seed", range(SEEDS))
@pytest.mark.parametrize("label, accepted, make", [pytest.param(*s, id=s[0]) for s in SAMPLES])
def test_synthetic_strokes_have_their_strategy(label, accepted, make, seed):
    path = linearize(make(np.random.default_rng([seed, len(label)])))
    for tool in (
        None,
        0.5 if label.startswith("text") or "word" in label else 4.0,
    ):  # Letters are engraved with a thin tool.
        found = recognize(path, tool_diameter=tool)
        assert str(found.strategy) in accepted, found.reason


@pytest.mark.parametrize("scale", [0.3, 3.0])
@pytest.mark.parametrize(
    "make, strategy", [(open_offsets, Strategy.CONTOUR_PARALLEL), (open_adaptive, Strategy.ADAPTIVE)]
)
def test_open_strokes_keep_strategy_if_scaled_or_mirrored(make, strategy, scale):
    path = linearize(make(np.random.default_rng(3)))
    for points in (scale * path.points, path.points * (1, -1, 1)):
        found = recognize(replace(path, points=points))
        assert found.strategy is strategy, found.reason


@pytest.mark.parametrize("seed", range(SEEDS))
def test_stepover_of_open_offsets_is_their_distance(seed):
    draws = np.random.default_rng(seed)
    draws.uniform()  # The first random value is the angle of the offsets, and the second is their distance.
    step = draws.uniform(0.8, 1.8)
    found = recognize(linearize(open_offsets(np.random.default_rng(seed))))
    assert found.stepover == pytest.approx(step, rel=0.05) and found.passes >= 5


@pytest.mark.parametrize("seed", range(SEEDS))
def test_contour_without_its_corner_reliefs_makes_one_full_turn(seed):
    moves = monotonous_areas(linearize(dogbones(np.random.default_rng(seed), levels=1)))
    kept = without_spurs(moves)
    assert len(moves) - len(kept) == 2 * len(moves.reversals) > 0 and not len(kept.reversals)
    assert kept.phi[-1] == pytest.approx(TURN, abs=1e-3)
    assert kept.length.sum() < moves.length.sum()
    assert recognize(linearize(dogbones(np.random.default_rng(seed), levels=1))).reversals == len(moves.reversals)


def test_passes_cut_back_on_the_same_line_are_not_detours():
    moves = monotonous_areas(linearize(ramps(np.random.default_rng(0), count=6, level=False)))
    assert len(moves.reversals) and without_spurs(moves) is moves


def ramped(to_and_fro):
    """Return a contour that is entered by a ramp along its first side, in one descent or back and forth."""
    down = [(40.0, -1.0), (0.0, -2.0), (40.0, -3.0)] if to_and_fro else [(40.0, -3.0)]
    commands = [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": 0.0})]
    commands += [("G1", {"X": x, "Y": 0.0, "Z": z}) for x, z in down]
    around = [(40.0, 30.0), (0.0, 30.0), (0.0, 0.0), (40.0, 0.0)]
    return commands + [("G1", {"X": x, "Y": y, "Z": -3.0}) for x, y in around]


def test_entry_is_reported_with_the_strategy():
    def told(commands):
        found = recognize(linearize(commands))
        return str(found.strategy), found.entry

    assert told(programs.profile()) == ("profile", "plunge")
    assert told(ramped(False)) == ("profile", "ramp")
    assert told(ramped(True))[1] == "zigzag ramp"
    assert told(programs.helix()) == ("helix", None)
    assert told(programs.drilling())[1] is None
    for seed in range(SEEDS):  # A helical ramp of ten turns before three offsets does not make the strategy a profile.
        assert told(entered(np.random.default_rng(seed))) == ("contour-parallel", "helix")


@pytest.mark.parametrize("tool", [3.0, None])
@pytest.mark.parametrize("share", [0.25, 0.5, 0.7])
def test_open_contour_ramped_back_and_forth_is_a_profile(share, tool):
    """An arc with a radius of 40 mm is cut five times without a lift."""
    there = [(40 * math.cos(a), 40 * math.sin(a)) for a in np.linspace(0, share * TURN, 60)]
    points = [point for k in range(5) for point in there[:: (-1) ** k][k > 0 :]]
    stroke = [(x, y, -5 * k / (len(points) - 1)) for k, (x, y) in enumerate(points)]
    found = recognize(linearize(programs.program([stroke])), tool_diameter=tool)
    assert found.strategy == Strategy.PROFILE and found.confidence > 0.7


@pytest.mark.parametrize("seed", range(4))
def test_curls_of_a_drawing_are_not_bites(seed):
    """The curls have one sense and overlap by chance. The bites of adaptive clearing lie side by side."""
    rng, commands = np.random.default_rng(seed), [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})]
    for k in range(60):
        angles = rng.uniform(0, TURN) - np.linspace(0, rng.uniform(3, 6), 20)
        x, y = (rng.uniform(0, 4) + rng.uniform(0.5, 1) * of(angles) for of in (np.cos, np.sin))
        x += 0.1 * k
        commands += [("G0", {"Z": 5.0}), ("G0", {"X": x[0], "Y": y[0]}), ("G1", {"Z": -0.2, "F": 5.0})]
        commands += [("G1", {"X": a, "Y": b}) for a, b in zip(x[1:], y[1:])]
    assert judge_section(Section(monotonous_areas(linearize(commands)), 0.0)).strategy == "engraving"
