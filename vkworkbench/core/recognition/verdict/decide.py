# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decision: the rules propose a strategy, trees that know other people's operations vote, and both count."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict import learned
from vkworkbench.core.recognition.verdict.forest import Forest
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.core.strategy import Family, Strategy
from vkworkbench.language import Message

_BY_VALUE = {strategy.value: strategy for strategy in Strategy}
STRATEGIES = tuple(_BY_VALUE[value] for value in learned.STRATEGIES)
# Only the rules name the parts of a mixed operation; and where something is milled, nothing else is drilling.
OF_THE_RULES = np.array([s in (Strategy.MIXED, Strategy.DRILLING, Strategy.UNKNOWN) for s in STRATEGIES])
# The classes of the paper, rows and around, and beside them adaptive clearing, which bites, and the other families.
CLASS = np.array([-1 if s is Strategy.ADAPTIVE else list(Family).index(s.family) for s in STRATEGIES])
ALIKE = np.array(CLASS[:, None] == CLASS, float)
# What the rules count where no tool is known, for each strategy that they propose.
_SEEN_WITHOUT = {
    Strategy.SPIRAL: VOTES.RULES,
    Strategy.HELIX: VOTES.RULES_THAT_NEED_NO_TOOL,
    Strategy.ADAPTIVE: VOTES.RULES_THAT_NEED_NO_TOOL,
}
NO_TOOL = np.array([_SEEN_WITHOUT.get(s, VOTES.RULES_WITHOUT_TOOL) for s in STRATEGIES])
# What the paper's rule to the letter speaks for: nothing where it is open.
LETTER = {Strategy.ZIGZAG: Family.ROWS, Strategy.CONTOUR_PARALLEL: Family.AROUND}
NO_LETTER = -2


@dataclass(frozen=True)
class Learned:
    """What was learned from labelled operations (benchmarks/learn_verdicts.py).

    Attributes
    ----------
    strategies : Forest
        Votes for STRATEGIES.
    nonsense : Forest
        Votes for what machines something, and for what machines nothing.
    sureness : (6,) float
        Weights of the :func:`grounds` for a verdict.
    """

    strategies: Forest
    nonsense: Forest
    sureness: tuple[float, ...]


LEARNED = Learned(
    Forest([*learned.EARLIER, *learned.TREES], len(STRATEGIES)),
    Forest([*learned.EARLIER_NONSENSE, *learned.NONSENSE], 2),
    learned.SURENESS,
)


class Proposal(NamedTuple):
    """What speaks for a strategy beside the votes.

    Attributes
    ----------
    rules : int
        The strategy that the rules propose, an index of STRATEGIES.
    letter : int
        The class that the paper's rule to the letter tells, as in CLASS; NO_LETTER where it leaves it open.
    tool : bool
        Whether the tool's diameter is known, which many of the rules measure by.
    """

    rules: int
    letter: int
    tool: bool


def proposal(s: Section, rules: Verdict, paper: PaperVerdict | None) -> Proposal:
    """Return what the rules and the paper's rule to the letter say of a section."""
    family = LETTER.get(paper.strategy) if paper else None
    letter = list(Family).index(family) if family else NO_LETTER
    return Proposal(STRATEGIES.index(rules.strategy), letter, s.tool > 0)


def decide(s: Section, rules: Verdict, paper: PaperVerdict | None) -> tuple[Verdict, float]:
    """Decide what a section is.

    Parameters
    ----------
    s : Section
    rules : Verdict
        What the rules say of it.
    paper : PaperVerdict or None
        What the paper's rule says of it to the letter.

    Returns
    -------
    Verdict
        That of the rules, or another strategy where the votes are clearly for it, or UNKNOWN where the section is like
        nothing that machines.
    float
        How often such verdicts are right, 0..1.
    """
    values = measure_section(s)
    case = [values[name] for name in learned.MEASURES]
    nonsense = float(LEARNED.nonsense.vote(case)[1])
    if nonsense > VOTES.NONSENSE and not _encloses(values):
        seen = Message("like-nothing", share=nonsense)
        return replace(rules, strategy=Strategy.UNKNOWN, seen=seen, parts=(), step=None), nonsense
    votes, proposed = LEARNED.strategies.vote(case), proposal(s, rules, paper)
    said = elect(votes, proposed)
    if said != proposed.rules:
        seen = Message("like-others", share=float(votes[said]))
        rules = replace(rules, strategy=STRATEGIES[said], seen=seen, parts=(), step=None)
    return rules, float(sureness(grounds(votes, proposed), LEARNED.sureness))


def _encloses(values: dict[str, float]) -> bool:
    """Tell whether all is contours: loops that turn by one whole turn (paper, section 3.2) and have an area inside.

    Hopf's Umlaufsatz: a closed curve that does not cross itself turns by 2 pi. Walks and rolling curves hardly ever do.
    """
    return values["loops"] > VOTES.LOOPS and values["roundness"] > VOTES.ROUNDNESS


def standing(votes: np.ndarray, proposed: Proposal) -> np.ndarray:
    """Return what each strategy has, (c,).

    That is its share of the votes, that of the rules for the one they propose, and less of the same for its class. Where
    no tool is known the rules count less, and the paper's rule to the letter, which needs none, counts for the class.
    """
    rules = np.zeros(len(votes))
    rules[proposed.rules] = 1.0
    has = votes + (VOTES.RULES if proposed.tool else NO_TOOL) * rules
    has += VOTES.CLASS * (ALIKE * (votes + VOTES.RULES_OF_CLASS * rules)).sum(axis=1)
    if not proposed.tool:
        has += VOTES.LETTER * (proposed.letter == CLASS)
    return np.where(OF_THE_RULES & (rules == 0), 0.0, has)


def elect(votes: np.ndarray, proposed: Proposal) -> int:
    """Return the strategy that has most."""
    return int(np.argmax(standing(votes, proposed)))


def grounds(votes: np.ndarray, proposed: Proposal) -> np.ndarray:
    """Return what tells how sure the elected strategy is.

    Parameters
    ----------
    votes : (c,) float
        Shares of the trees' votes.
    proposed : Proposal

    Returns
    -------
    (6,) float
        One; the logarithm of the odds of its votes; whether the rules propose it; whether the paper's rule tells its
        class; how far it is ahead; whether the tool is known.
    """
    has = standing(votes, proposed)
    said = int(np.argmax(has))
    ahead = has[said] - np.partition(has, -2)[-2]
    odds = np.log((votes[said] + VOTES.MIN_SHARE) / (1 + VOTES.MIN_SHARE - votes[said]))
    return np.array([1.0, odds, said == proposed.rules, CLASS[said] == proposed.letter, ahead, proposed.tool], float)


def sureness(evidence: np.ndarray, weights: Sequence[float] | np.ndarray) -> np.ndarray:
    """Return the confidence, (...,), for grounds (..., 6): a logistic function of their weighted sum."""
    result: np.ndarray = VOTES.SUREST / (1 + np.exp(-(evidence * np.asarray(weights)).sum(axis=-1)))
    return result
