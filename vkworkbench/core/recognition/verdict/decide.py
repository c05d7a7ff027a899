# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decision: learned trees vote on the measures, the proposal of the rules and the paper's literal verdict."""

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
# Only the rules name the parts of a mixed operation; and where something is milled, nothing else is drilling.
OF_THE_RULES = np.array([s in (Strategy.MIXED, Strategy.DRILLING, Strategy.UNKNOWN) for s in STRATEGIES])
# The classes of the paper, rows and around, and beside them adaptive clearing, which bites, and the other families.
CLASSES = [-1 if s is Strategy.ADAPTIVE else list(Family).index(s.family) for s in STRATEGIES]
ALIKE = np.equal.outer(CLASSES, CLASSES)
#: The paper's literal verdict as a number between its two classes; 0 where it is open.
LETTERS = {Strategy.ZIGZAG: -1, Strategy.CONTOUR_PARALLEL: 1}


def features(values: dict[str, float], rules: Strategy, paper: Strategy | None, *, tool: bool) -> dict[str, float]:
    """Return the features that the trees ask for, by name.

    Parameters
    ----------
    values : dict
        Measures of a section.
    rules : Strategy
        What the rules propose.
    paper : Strategy or None
        The paper's literal verdict.
    tool : bool
        Whether the tool's diameter is known; many rules measure in tool diameters.
    """
    proposed = {f"rules: {s.value}": float(s is rules) for s in STRATEGIES}
    return {**values, **proposed, "letter": float(LETTERS.get(paper, 0) if paper else 0), "tool": float(tool)}


def decide(s: Section, rules: Verdict, paper: PaperVerdict | None) -> tuple[Verdict, float]:
    """Decide what a section is.

    Parameters
    ----------
    s : Section
    rules : Verdict
        What the rules say of it.
    paper : PaperVerdict or None
        The paper's literal verdict.

    Returns
    -------
    Verdict
        That of the rules, or another strategy where most votes are for it, or UNKNOWN where the section is like nothing
        that machines.
    float
        How often such verdicts are right, 0..1.
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
    """Return the strategy that most votes are for, within the class that most votes are for, and its probability.

    Its probability is its share of the votes of the trees for strategies, times the share of the votes against nonsense.

    Parameters
    ----------
    nonsense : float
        Share of the votes for what machines nothing.
    votes : (c,) float
        Shares of the votes for STRATEGIES.
    rules : int
        What the rules propose, an index of STRATEGIES.
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
