# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decide the strategy: learned trees vote, given the measures, the proposal of the rules and the paper's verdict."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.model import shipped_model
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.language import Message

STRATEGIES = tuple(s for s in Strategy if s is not Strategy.EMPTY)
# Strategies that only the rules can propose, and for which the votes of the decision trees are ignored.
OF_THE_RULES = np.array([s in (Strategy.MIXED, Strategy.DRILLING, Strategy.UNKNOWN) for s in STRATEGIES])
# Strategies of one family are one class in the vote; only adaptive clearing is a class of its own.
CLASSES = [-1 if s is Strategy.ADAPTIVE else list(Family).index(s.family) for s in STRATEGIES]
ALIKE = np.equal.outer(CLASSES, CLASSES)
#: Feature value for the strategy by the paper's literal rule: 0 for all strategies that are not in this table.
LETTERS = {Strategy.ZIGZAG: -1, Strategy.CONTOUR_PARALLEL: 1}


def features(values: dict[str, float], rules: Strategy, paper: Strategy | None, *, tool: bool) -> dict[str, float]:
    """Return the values that the decision trees read, by name.

    Parameters
    ----------
    values : dict
        Measures of a section.
    rules : Strategy
        Strategy that the rules propose.
    paper : Strategy or None
        Strategy by the paper's literal rule, without this recogniser's corrections.
    tool : bool
        Whether the tool's diameter is known, which matters because many rules measure in tool diameters.
    """
    proposed = {f"rules: {s.value}": float(s is rules) for s in STRATEGIES}
    return {**values, **proposed, "letter": float(LETTERS.get(paper, 0) if paper else 0), "tool": float(tool)}


def decide(s: Section, rules: Verdict, paper: PaperVerdict | None) -> tuple[Verdict, float]:
    """Decide which strategy a section follows.

    Parameters
    ----------
    s : Section
    rules : Verdict
        Strategy that the rules propose for the section, and its reason.
    paper : PaperVerdict or None
        Result of the paper's literal rule, without this recogniser's corrections.

    Returns
    -------
    Verdict
        The strategy that the rules propose, unless the trees' votes elect another strategy. The strategy is UNKNOWN if
        the trees vote that the toolpath is nonsense, which means that it does not look like any operation that machines
        a part.
    float
        Probability that the returned strategy is right, 0..1.
    """
    model = shipped_model()
    known = features(measure_section(s), rules.strategy, paper.strategy if paper else None, tool=s.tool > 0)
    nonsense, votes = model.vote(known)
    said, share = elect(nonsense, votes, STRATEGIES.index(rules.strategy))
    if STRATEGIES[said] is not rules.strategy:
        nothing = STRATEGIES[said] is Strategy.UNKNOWN
        seen = Message("like-nothing", share=share) if nothing else Message("like-others", share=share)
        rules = replace(rules, strategy=STRATEGIES[said], seen=seen, parts=(), step=None)
    return rules, min(VOTES.SUREST, model.sureness(share))


def elect(nonsense: float, votes: np.ndarray, rules: int) -> tuple[int, float]:
    """Return the strategy with most votes, as an index of STRATEGIES, and the probability that it is right.

    The strategy is elected from the class (strategies of one family) with most votes. The class's probability is its
    share of the votes for strategies, times the share of the votes against nonsense. If the share of the votes for
    nonsense exceeds VOTES.NONSENSE, return UNKNOWN and this share.

    Parameters
    ----------
    nonsense : float
        Share of the votes for nonsense.
    votes : (c,) float
        Shares of the votes for STRATEGIES.
    rules : int
        Strategy that the rules propose, an index of STRATEGIES.
    """
    if nonsense > VOTES.NONSENSE:
        return STRATEGIES.index(Strategy.UNKNOWN), nonsense
    able = ~OF_THE_RULES
    able[rules] = True
    shares = np.where(able, votes, 0.0)
    shares /= shares.sum() or 1.0
    of_class = (ALIKE * shares).sum(axis=1)
    said = int(np.argmax(np.where(of_class == of_class.max(), shares, -1.0)))
    return said, float((1 - nonsense) * shares[said])
