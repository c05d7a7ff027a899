# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategy follows from rules and votes: measures independent of position, nonsense toolpaths, and reasons."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import numpy as np
import programs
import pytest

from toolpaths import nonsense, synthetic
from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.decide import OF_THE_RULES, STRATEGIES, elect, features
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.model import FILE, Trees, shipped_model
from vkworkbench.core.recognition.verdict.operation import unknown
from vkworkbench.language import Message

# Seeds of nonsense toolpaths. Most of the nonsense toolpaths have 182 to 801 points, and some contain retracts. Longer
# toolpaths would not test more.
SEEDS = (1, 4, 6, 8)
SOME = synthetic.SAMPLES[::3]


def path_of(make, seed=2):
    return linearize(make(np.random.default_rng(seed)))


def measured(path):
    moves = monotonous_areas(path)
    return measure_section(Section(moves, 0.0)) if len(moves) else {}


@pytest.mark.parametrize("label, accepted, make", SOME, ids=[label for label, *_ in SOME])
def test_measures_are_finite_and_do_not_depend_on_position(label, accepted, make):
    path = path_of(make)
    c, s = np.cos(0.7), np.sin(0.7)
    turned = replace(path, points=path.points @ np.array([(c, s, 0), (-s, c, 0), (0, 0, 1)]) + (31.0, -7.0, 2.0))
    one, other = measured(path), measured(turned)
    if one:
        assert set(features(one, Strategy.ZIGZAG, None, tool=True)) == set(shipped_model().names)
        assert np.isfinite(list(one.values())).all()
        changed = {name: (one[name], other[name]) for name in one if abs(one[name] - other[name]) > 0.05}
        # Measures computed from bounding boxes and cell corners change slightly if the toolpath is rotated.
        assert len(changed) <= 0.2 * len(one), changed


@pytest.mark.long
def test_nonsense_toolpaths_are_unknown_with_a_reason():
    found = [
        recognize(linearize(nonsense.commands(kind, np.random.default_rng([seed, 3]))))
        for kind in nonsense.KINDS
        for seed in SEEDS
    ]
    unknown = [one.strategy is Strategy.UNKNOWN for one in found]
    assert np.mean(unknown) > 0.8, [str(one.strategy) for one in found]
    for one in found:
        assert str(one.strategy) in one.reason, one.reason
        assert one.strategy is not Strategy.UNKNOWN or "of the votes" in one.reason, one.reason


def test_span_of_unknown_toolpath_is_first_to_last_command():
    path = linearize(programs.zigzag())
    (span,) = unknown(path, Message("rest")).spans
    assert (span.first, span.last, span.share) == (0, len(path) - 1, 1.0)
    assert (span.first_command, span.last_command) == (path.command[0], path.command[-1])


def test_few_holes_do_not_make_a_nonsense_path_drilling():
    rng = np.random.default_rng(4)
    places = np.cumsum(rng.normal(size=(600, 2)), axis=0)
    lifted = rng.random(len(places)) < 0.4
    commands = []
    for (x, y), up in zip(places, lifted):
        if up or not commands:
            commands += [("G0", {"Z": 5.0}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": -1.0, "F": 10.0})]
        else:
            commands.append(("G1", {"X": x, "Y": y, "F": 10.0}))
    path = linearize([*commands, ("G0", {"Z": 5.0})])
    assert len(monotonous_areas(path).holes) >= 30  # There are enough holes that successive holes form sections.
    assert recognize(path).strategy is Strategy.UNKNOWN


def drawn(corners):
    """Return a toolpath once around a polygon, 1 mm deep."""
    (x, y), *others = np.vstack([corners, corners[:1]]).tolist()
    program = [("G0", {"Z": 5.0}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": -1.0, "F": 2.0})]
    return linearize([*program, *(("G1", {"X": x, "Y": y, "F": 10.0}) for x, y in others), ("G0", {"Z": 5.0})])


def on_circle(radii, strides=1):
    angle = np.pi / 2 + 2 * np.pi * strides * np.arange(len(radii)) / len(radii)
    return np.transpose(radii * np.array([np.cos(angle), np.sin(angle)]))


def snowflake(times):
    """Return the corners of Koch's snowflake, computed with complex numbers."""
    corners = 60 * np.exp(2j * np.pi * np.array([0, 1 / 3, 2 / 3]))
    for _ in range(times):
        third = (np.roll(corners, -1) - corners) / 3
        bump = third * np.exp(-1j * np.pi / 3)
        corners = np.ravel(np.column_stack([corners, corners + third, corners + third + bump, corners + 2 * third]))
    return np.column_stack([corners.real, corners.imag])


def gear(teeth):
    return on_circle(np.repeat(np.resize([23.0, 27.0], 2 * teeth), 2))


T = np.linspace(0, 2 * np.pi, 60, endpoint=False)
DRAWN = {
    **{f"star of {n}": on_circle(np.resize([25.0, 10.0], 2 * n)) for n in (5, 8, 9)},
    **{f"star in one stroke {n}/{k}": on_circle(np.full(n, 25.0), k) for n, k in ((5, 2), (7, 2), (8, 3), (11, 5))},
    **{f"polygon of {n}": on_circle(np.full(n, 25.0)) for n in (3, 5, 12)},
    "house": np.array([(0, 0), (40, 0), (40, 30), (20, 45), (0, 30)]),
    "cross": np.array([(0, 1), (1, 1), (1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2)])
    * 12,
    "flash": np.array([(0, 0), (10, 20), (4, 20), (14, 45), (-2, 24), (5, 24)]),
    "heart": np.column_stack([16 * np.sin(T) ** 3, 13 * np.cos(T) - 5 * np.cos(2 * T) - 2 * np.cos(3 * T)]),
    **{f"gear of {n}": gear(n) for n in (12, 40, 60)},
    **{f"snowflake of {n}": snowflake(n) for n in (1, 2, 3)},
    "star of 16": on_circle(np.resize([25.0, 12.0], 32)),
    "eight": np.column_stack([25 * np.sin(T), 12 * np.sin(2 * T)]),
}


@pytest.mark.parametrize("tool", [None, 3.0])
@pytest.mark.parametrize("corners", DRAWN.values(), ids=DRAWN)
def test_simple_outlines_are_profiles(corners, tool):
    assert recognize(drawn(corners), tool_diameter=tool).strategy is Strategy.PROFILE


@pytest.mark.parametrize("make", [nonsense.moore, nonsense.sierpinski])
def test_closed_plane_filling_curve_is_not_a_contour(make):
    curve = max((make(np.random.default_rng(seed)) for seed in range(8)), key=len)
    assert recognize(drawn(curve)).strategy is Strategy.UNKNOWN


def votes_for(**shares):
    """Return the share of votes for each strategy; an underscore in a name stands for a hyphen."""
    votes = np.zeros(len(STRATEGIES))
    for name, share in shares.items():
        votes[STRATEGIES.index(Strategy(name.replace("_", "-")))] = share
    return votes


def elected(votes, rules, nonsense=0.0):
    said, share = elect(nonsense, votes, STRATEGIES.index(rules))
    return STRATEGIES[said], share


def test_votes_cannot_elect_mixed_or_drilling():
    for said in np.flatnonzero(OF_THE_RULES):
        votes = votes_for(zigzag=0.2) + 0.8 * np.eye(len(STRATEGIES))[said]
        assert elected(votes, Strategy.ZIGZAG) == (Strategy.ZIGZAG, 1.0)
        assert elected(votes, STRATEGIES[said]) == (STRATEGIES[said], pytest.approx(0.8))


def test_strategy_without_votes_has_confidence_zero():
    assert elected(votes_for(mixed=1.0), Strategy.ZIGZAG)[1] == 0


@pytest.mark.parametrize("other", ["adaptive", "zigzag", "engraving"])
def test_votes_for_strategies_of_one_family_are_added(other):
    votes = votes_for(contour_parallel=0.3, spiral=0.2, profile=0.17, **{other: 0.33})
    assert elected(votes, Strategy.UNKNOWN) == (Strategy.CONTOUR_PARALLEL, pytest.approx(0.3))


@pytest.mark.parametrize(("nonsense", "said"), [(0.59, Strategy.SPIRAL), (0.61, Strategy.UNKNOWN)])
def test_path_with_sixty_percent_of_nonsense_votes_is_unknown(nonsense, said):
    assert elected(votes_for(spiral=0.9, helix=0.1), Strategy.SPIRAL, nonsense)[0] is said


def test_votes_for_nonsense_lower_the_probability():
    assert elected(votes_for(spiral=0.9, helix=0.1), Strategy.SPIRAL, 0.2)[1] == pytest.approx(0.72)


def test_more_votes_make_the_confidence_higher():
    sure = [shipped_model().sureness(share) for share in (0.2, 0.6, 1.0)]
    assert sure == sorted(sure) and 0 < sure[0] < sure[-1] < 1


def test_tree_follows_its_questions_to_a_leaf():
    """The first tree votes for class 0 if x[1] <= 2.

    Otherwise, the first tree gives half of its vote to each class if x[0] <= 0.5, and votes for class 1 if x[0] > 0.5.
    The second tree votes for class 1.
    """
    trees = Trees(
        feature=np.array([1, -1, 0, -1, -1, -1]),
        most=np.array([2.0, np.inf, 0.5, np.inf, np.inf, np.inf]),
        ahead=np.array([1, 0, 1, 0, 0, 0]),
        votes=np.array([[0, 0], [4, 0], [0, 0], [2, 2], [0, 4], [0, 4]]),
        roots=np.array([0, 5]),
    )
    cases = np.array([(9.0, 2.0), (0.5, 2.1), (0.6, 2.1)])
    assert trees.shares(cases).tolist() == [[0.5, 0.5], [0.25, 0.75], [0.0, 1.0]]


@pytest.mark.parametrize(("paper", "letter"), [(Strategy.ZIGZAG, -1), (Strategy.CONTOUR_PARALLEL, 1), (None, 0)])
def test_features_contain_rules_paper_verdict_and_tool(paper, letter):
    told = features({"climbs": 0.25}, Strategy.SPIRAL, paper, tool=paper is None)
    assert (told["climbs"], told["letter"], told["tool"]) == (0.25, letter, paper is None)
    assert [name for name, value in told.items() if name.startswith("rules: ") and value] == ["rules: spiral"]


def test_model_file_is_read_only_for_recognition():
    script = "import sys, vkworkbench.core; from vkworkbench.core.recognition.verdict import model; print(model.shipped_model.cache_info().currsize)"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "0"
    assert FILE.stat().st_size <= 200_000
