# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decision: the rules propose a strategy, trees that know other people's operations vote, and both count."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.recognition import learned
from vkworkbench.core.recognition.forest import Forest
from vkworkbench.core.recognition.measures import measures
from vkworkbench.core.recognition.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict import Verdict
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.language import Message

_BY_VALUE = {strategy.value: strategy for strategy in Strategy}
STRATEGIES = tuple(_BY_VALUE[value] for value in learned.STRATEGIES)
# Only the rules name the parts of a mixed operation; and where something is milled, nothing else is drilling.
OF_THE_RULES = np.array([s in (Strategy.MIXED, Strategy.DRILLING, Strategy.UNKNOWN) for s in STRATEGIES])
ADAPTIVE = np.array([s is Strategy.ADAPTIVE for s in STRATEGIES])
# The classes of the paper, rows and around, and beside them adaptive clearing, which bites, and the other families.
CLASS = np.where(ADAPTIVE, -1, [list(Family).index(s.family) for s in STRATEGIES])
ALIKE = np.array(CLASS[:, None] == CLASS, float)


@dataclass(frozen=True)
class Learned:
    """What was learned from labelled operations (benchmarks/learn_verdicts.py).

    Attributes
    ----------
    strategies : Forest
        Votes for STRATEGIES.
    nonsense : Forest
        Votes for what machines something, and for what machines nothing.
    sureness : (5,) float
        Weights of the :func:`grounds` for a verdict.
    """

    strategies: Forest
    nonsense: Forest
    sureness: tuple[float, ...]


LEARNED = Learned(Forest(learned.TREES, len(STRATEGIES)), Forest(learned.NONSENSE, 2), learned.SURENESS)


def decide(s: Section, rules: Verdict) -> tuple[Verdict, float]:
    """Decide what a section is.

    Parameters
    ----------
    s : Section
    rules : Verdict
        What the rules say of it.

    Returns
    -------
    Verdict
        That of the rules, or another strategy where the votes are clearly for it, or UNKNOWN where the section is like
        nothing that machines.
    float
        How often such verdicts are right, 0..1.
    """
    values = measures(s)
    case = [values[name] for name in learned.MEASURES]
    nonsense = float(LEARNED.nonsense.vote(case)[1])
    if nonsense > VOTES.NONSENSE:
        seen = Message("like-nothing", share=nonsense)
        return replace(rules, strategy=Strategy.UNKNOWN, seen=seen, parts=(), step=None), nonsense
    votes, proposed = LEARNED.strategies.vote(case), STRATEGIES.index(rules.strategy)
    said = elect(votes, proposed)
    if said != proposed:
        seen = Message("like-others", share=float(votes[said]))
        rules = replace(rules, strategy=STRATEGIES[said], seen=seen, parts=(), step=None)
    return rules, float(sureness(grounds(votes, proposed, s.tool > 0), LEARNED.sureness))


def standing(votes: np.ndarray, proposed: int) -> np.ndarray:
    """Return what each strategy has, (c,).

    That is its share of the votes, and that of the rules for the one they propose; and less of the same for its class,
    as the class is told apart more surely than the strategies in it. Adaptive clearing leaves both classes of the paper,
    so it has to be ahead of them.
    """
    rules = np.zeros(len(votes))
    rules[proposed] = 1.0
    has = votes + VOTES.RULES * rules + VOTES.CLASS * (ALIKE * (votes + VOTES.RULES_OF_CLASS * rules)).sum(axis=1)
    has -= VOTES.BITES * ADAPTIVE
    return np.where(OF_THE_RULES & (rules == 0), 0.0, has)


def elect(votes: np.ndarray, proposed: int) -> int:
    """Return the strategy that has most."""
    return int(np.argmax(standing(votes, proposed)))


def grounds(votes: np.ndarray, proposed: int, tool: bool) -> np.ndarray:
    """Return what tells how sure the elected strategy is.

    Parameters
    ----------
    votes : (c,) float
        Shares of the trees' votes.
    proposed : int
        The strategy that the rules propose.
    tool : bool
        Whether the tool's diameter is known.

    Returns
    -------
    (5,) float
        One; the logarithm of the odds of its votes; whether the rules propose it; how far it is ahead; `tool`.
    """
    has = standing(votes, proposed)
    said = int(np.argmax(has))
    ahead = has[said] - np.delete(has, said).max()
    odds = np.log((votes[said] + VOTES.NONE) / (1 + VOTES.NONE - votes[said]))
    return np.array([1.0, odds, said == proposed, ahead, tool], float)


def sureness(evidence: np.ndarray, weights: Sequence[float] | np.ndarray) -> np.ndarray:
    """Return the confidence, (...,), for grounds (..., 5): a logistic function of their weighted sum."""
    result: np.ndarray = VOTES.SUREST / (1 + np.exp(-(evidence * np.asarray(weights)).sum(axis=-1)))
    return result
