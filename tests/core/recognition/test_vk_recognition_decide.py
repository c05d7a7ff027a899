# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joint decisions of the rules and the votes: measures that do not depend on the position, nonsense, and reasons."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest

from toolpaths import nonsense, synthetic
from vkworkbench.core import Family, Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict import learned
from vkworkbench.core.recognition.verdict.decide import (
    CLASS,
    LEARNED,
    NO_LETTER,
    OF_THE_RULES,
    STRATEGIES,
    Proposal,
    elect,
    grounds,
    proposal,
    standing,
    sureness,
)
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.operation import unknown
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.language import Message

# Seeds of nonsense toolpaths, which have 182 to 801 points in most kinds; some retract. Longer paths show no more.
SEEDS = (1, 4, 6, 8)
SOME = synthetic.SAMPLES[::3]


def path_of(make, seed=2):
    return linearize(make(np.random.default_rng(seed)))


def proposed_by(rules, letter=None, tool=False):
    return Proposal(STRATEGIES.index(rules), list(Family).index(letter) if letter else NO_LETTER, tool)


def measured(path):
    moves = monotonous_areas(path)
    return measure_section(Section(moves, 0.0)) if len(moves) else {}


@pytest.mark.parametrize("label, accepted, make", SOME, ids=[label for label, *_ in SOME])
def test_measures_are_finite_and_invariant(label, accepted, make):
    path = path_of(make)
    c, s = np.cos(0.7), np.sin(0.7)
    turned = replace(path, points=path.points @ np.array([(c, s, 0), (-s, c, 0), (0, 0, 1)]) + (31.0, -7.0, 2.0))
    one, other = measured(path), measured(turned)
    if one:
        assert tuple(one) == learned.MEASURES
        assert np.isfinite(list(one.values())).all()
        changed = {name: (one[name], other[name]) for name in one if abs(one[name] - other[name]) > 0.05}
        assert len(changed) <= 0.2 * len(one), changed  # what boxes and corners of cells tell changes a little


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


def test_unknown_spans_first_to_last_command():
    path = linearize(programs.zigzag())
    (span,) = unknown(path, Message("rest")).spans
    assert (span.first, span.last, span.share) == (0, len(path) - 1, 1.0)
    assert (span.first_command, span.last_command) == (path.command[0], path.command[-1])


def test_few_holes_do_not_name_a_nonsense_path():
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
    assert len(monotonous_areas(path).holes) >= 30  # enough holes that runs of holes become sections
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
    """Koch's, as complex numbers."""
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
def test_what_pupils_draw_first_is_a_profile(corners, tool):
    assert recognize(drawn(corners), tool_diameter=tool).strategy is Strategy.PROFILE


@pytest.mark.parametrize("make", [nonsense.moore, nonsense.sierpinski])
def test_closed_plane_filling_curve_is_not_a_contour(make):
    curve = max((make(np.random.default_rng(seed)) for seed in range(8)), key=len)
    assert recognize(drawn(curve)).strategy is Strategy.UNKNOWN


def test_only_the_rules_say_mixed_and_drilling():
    for said in np.flatnonzero(OF_THE_RULES):
        votes = np.eye(len(STRATEGIES))[said]
        proposed = proposed_by(Strategy.ZIGZAG)
        assert elect(votes, proposed) == proposed.rules


def test_what_the_papers_rule_leaves_open_speaks_for_no_class():
    """Without a tool and votes, only the strategy that the rules propose and its class have a score."""
    assert not np.isin(NO_LETTER, CLASS)
    votes, rules = np.zeros(len(STRATEGIES)), STRATEGIES.index(Strategy.PROFILE)
    has = standing(votes, Proposal(rules, NO_LETTER, False))
    assert np.flatnonzero(has).tolist() == np.flatnonzero((CLASS[rules] == CLASS) & ~OF_THE_RULES).tolist()


@pytest.mark.parametrize(("tool", "rules"), [(True, 0.5), (False, 0.1)])
def test_the_rules_lose_against_more_votes_than_theirs(tool, rules):
    """With a tool, the rules lose against a share of more than 0.425 of the votes.

    A strategy's votes count 1.6 times, once for itself and 0.6 times for its class. The rules and their class have
    0.5 + 0.6 * 0.3 with a tool.
    """
    profile = STRATEGIES.index(Strategy.PROFILE)
    theirs = (rules + 0.6 * 0.3) / 1.6
    for share, said in ((theirs - 0.01, Strategy.ZIGZAG), (theirs + 0.01, Strategy.PROFILE)):
        votes = np.zeros(len(STRATEGIES))
        votes[profile] = share
        assert STRATEGIES[elect(votes, proposed_by(Strategy.ZIGZAG, tool=tool))] is said


@pytest.mark.parametrize(
    ("seen", "rules"),
    [(Strategy.HELIX, 0.25), (Strategy.ADAPTIVE, 0.25), (Strategy.SPIRAL, 0.5)],
)
def test_what_the_rules_see_without_a_tool_counts_more(seen, rules):
    """Without a tool, strategies that the rules recognise without a tool count 0.25 or 0.5 instead of 0.1."""
    votes = np.zeros(len(STRATEGIES))
    for more, said in ((-0.01, seen), (0.01, Strategy.ENGRAVING)):
        votes[STRATEGIES.index(Strategy.ENGRAVING)] = (rules + 0.6 * 0.3) / 1.6 + more
        assert STRATEGIES[elect(votes, proposed_by(seen))] is said
    votes[STRATEGIES.index(Strategy.ENGRAVING)] -= 0.02
    assert STRATEGIES[elect(votes, proposed_by(Strategy.WATERLINE))] is Strategy.ENGRAVING


@pytest.mark.parametrize("other", ["adaptive", "zigzag", "engraving"])
def test_votes_that_are_split_within_one_class_are_not_lost(other):
    votes = np.zeros(len(STRATEGIES))
    for name, share in (("contour-parallel", 0.3), ("spiral", 0.2), ("profile", 0.17), (other, 0.33)):
        votes[STRATEGIES.index(Strategy(name))] = share
    assert STRATEGIES[elect(votes, proposed_by(Strategy.UNKNOWN))] is Strategy.CONTOUR_PARALLEL


def test_paper_verdict_decides_between_classes_only():
    votes = np.zeros(len(STRATEGIES))
    for name, share in (("zigzag", 0.3), ("profile", 0.3), ("spiral", 0.2), ("adaptive", 0.2)):
        votes[STRATEGIES.index(Strategy(name))] = share
    for letter, said in ((Family.ROWS, Strategy.ZIGZAG), (Family.AROUND, Strategy.PROFILE)):
        assert STRATEGIES[elect(votes, proposed_by(Strategy.UNKNOWN, letter))] is said


@pytest.mark.parametrize(("ahead", "said"), [(0.24, Strategy.ZIGZAG), (0.26, Strategy.PROFILE)])
def test_paper_verdict_counts_a_quarter_of_votes(ahead, said):
    votes = np.zeros(len(STRATEGIES))
    votes[STRATEGIES.index(Strategy.ZIGZAG)], votes[STRATEGIES.index(Strategy.PROFILE)] = 0.3, 0.3 + ahead
    assert STRATEGIES[elect(votes, proposed_by(Strategy.UNKNOWN, Family.ROWS))] is said


def test_more_votes_make_a_verdict_surer():
    of = proposed_by(Strategy.SPIRAL)
    sure = [
        sureness(grounds(np.eye(len(STRATEGIES))[of.rules] * share, of), LEARNED.sureness) for share in (0.2, 0.6, 1.0)
    ]
    assert sure == sorted(sure) and sure[0] < sure[-1] <= VOTES.SUREST < 1


def test_one_case_has_the_votes_of_many():
    x = np.random.default_rng(0).uniform(-1, 3, (20, len(learned.MEASURES)))
    for forest in (LEARNED.strategies, LEARNED.nonsense):
        assert np.array([forest.vote(case.tolist()) for case in x]) == pytest.approx(forest.shares(x))


def test_grounds_are_six_numbers():
    votes = np.zeros(len(STRATEGIES))
    votes[STRATEGIES.index(Strategy.ZIGZAG)], votes[STRATEGIES.index(Strategy.ENGRAVING)] = 0.7, 0.3
    odds = np.log((0.7 + VOTES.MIN_SHARE) / (0.3 + VOTES.MIN_SHARE))
    # The rules propose zigzag with a tool, so the shares of the rules and of their class are added to zigzag's votes.
    ahead = 0.7 + VOTES.RULES + VOTES.CLASS * (0.7 + VOTES.RULES_OF_CLASS)
    second = max(VOTES.CLASS * (0.7 + VOTES.RULES_OF_CLASS), (1 + VOTES.CLASS) * 0.3)
    proposed = proposed_by(Strategy.ZIGZAG, Family.ROWS, tool=True)
    assert grounds(votes, proposed) == pytest.approx([1, odds, 1, 1, ahead - second, 1])
    told = grounds(votes, proposed_by(Strategy.WATERLINE, Family.AROUND))
    assert told[[0, 2, 3, 5]].tolist() == [1, 0, 0, 0] and told[1] == pytest.approx(odds)


def test_sureness_is_a_logistic_function():
    assert sureness(np.zeros(6), np.ones(6)) == VOTES.SUREST / 2
    evidence = np.array([[1.0, 2.0, 0.0, 0.0, 0.5, 1.0], [1.0, 0.0, 1.0, 0.0, 0.0, 0.0]])
    weights = np.array([-1.0, 0.5, 3.0, 7.0, 2.0, 0.25])
    assert sureness(evidence, weights) == pytest.approx(VOTES.SUREST / (1 + np.exp([-1.25, -2.0])))


@pytest.mark.parametrize("diameter", [0.0, 6.0])
def test_what_is_proposed_tells_whether_a_tool_is_known(diameter):
    section = Section(monotonous_areas(path_of(synthetic.SAMPLES[0][2])), diameter)
    rules, paper = Verdict(Strategy.SPIRAL, 1, Message("rest")), None
    assert proposal(section, rules, paper) == proposed_by(Strategy.SPIRAL, tool=diameter > 0)
