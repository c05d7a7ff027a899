#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn what operations of each strategy measure and how sure a verdict is, and write the table of the recognition.

    python3 benchmarks/learn_verdicts.py OPERATIONS.jsonl.gz ... [--write]

The files have the format that benchmarks/recognition.py reads. Toolpaths of synthetic.py, strokes.py and nonsense.py in
toolpaths/ are added. A tenth of the repositories, parts and kinds is left out of the learning at a time; the verdicts on
that tenth are printed, and the confidence is fitted on them. --write learns from all operations and writes
vkworkbench/core/recognition/verdict/learned.py. That file keeps the trees that were learned earlier, in part from programs
that are lost: old and new trees vote together.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from records import SEEDS, Record, made, operations, rng_of
from trees import grow

from toolpaths import nonsense
from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import monotonous_areas, paper_verdict
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict.decide import (
    STRATEGIES,
    Learned,
    Proposal,
    elect,
    grounds,
    proposal,
    sureness,
)
from vkworkbench.core.recognition.verdict.forest import Forest
from vkworkbench.core.recognition.verdict.learned import EARLIER, EARLIER_NONSENSE
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.rules import judge_section

OF_STRATEGIES = {"trees": 60, "leaves": 160, "tried": 0.3, "seed": 1}
OF_NONSENSE = {"trees": 80, "leaves": 160, "tried": 0.3, "seed": 1}
ELSEWHERE = (0.35, 0.4, 0.45, 0.55)  # where else nonsense might begin: what it costs, and what it gains
FOLDS = 10
#: Folds of the kinds that joined later: those of all others stay, so that figures before and after can be compared.
JOINED = {"odometer": 7, "wunderlich": 3}
#: Weights in the learning of the strategies, of what is nonsense, and of the confidence. Real code is what is rare.
WEIGHTS = {
    "real": (3.0, 4.0, 2.0),
    "real with tools": (0.0, 0.0, 2.0),
    "freecad": (1.0, 1.0, 1.0),
    "freecad without tools": (0.7, 1.0, 0.0),
    "synthetic": (3.0, 1.0, 0.0),
    "nonsense": (0.0, 3.0, 0.0),
}
TABLE = HERE.parent / "vkworkbench" / "core" / "recognition" / "verdict" / "learned.py"


def that_machine_nothing() -> Iterator[Record]:
    """Yield the paths of toolpaths/nonsense.py."""
    for make in nonsense.KINDS:
        name = make.__name__
        for seed in range(SEEDS):
            path = linearize(nonsense.commands(make, rng_of(name, seed)))
            yield Record(name, name, name, "unknown", frozenset({"unknown"}), None, None, path, (), name)


def labelled(files: list[str]) -> Iterator[tuple[str, Record]]:
    """Yield all toolpaths to learn from, by kind: real, with and without tools, freecad, synthetic and nonsense."""
    for r in operations(files):
        yield kind_of(r), r
    for r in made():
        yield "synthetic", r
    for r in that_machine_nothing():
        yield "nonsense", r


def kind_of(r: Record) -> str:
    if "__" not in r.id:
        return "freecad"
    return "real with tools" if r.tool else "real"


@dataclass
class Examples:
    """What n toolpaths measure, and what they are.

    Attributes
    ----------
    kind, group, system : (n,) str
        Which WEIGHTS they have; what is left out together, repositories or parts; or, instead, CAM systems.
    x : (n, m) float
    y : (n,) int
        The true strategy, as an index of STRATEGIES.
    proposed : list of Proposal
        What the rules and the paper's rule to the letter say.
    accepted : list of set of int
        The strategies that count as right.
    names : tuple of str
        Names of the measures.
    """

    kind: np.ndarray
    group: np.ndarray
    system: np.ndarray
    x: np.ndarray
    y: np.ndarray
    proposed: list[Proposal]
    accepted: list[set[int]]
    names: tuple[str, ...]

    @classmethod
    def measured(cls, toolpaths) -> Examples:
        """Measure (kind, record) pairs; those of FreeCAD once more without their tools."""
        strategies, rows = [s.value for s in STRATEGIES], []
        for kind, r in toolpaths:
            moves = monotonous_areas(r.path)
            if not len(moves):
                continue  # drilling, which needs no vote
            accepted = {strategies.index(name) for name in r.accepted}
            for of_kind, tool in ((kind, r.tool or 0.0), (f"{kind} without tools", 0.0)):
                if of_kind in WEIGHTS:
                    section = Section(moves, tool)
                    values = measure_section(section)
                    proposed = proposal(section, judge_section(section), paper_verdict(moves))
                    rows.append(
                        (
                            of_kind,
                            r.group,
                            r.system,
                            list(values.values()),
                            strategies.index(r.strategy),
                            proposed,
                            accepted,
                        )
                    )
        *arrays, proposed, accepted = zip(*rows)
        return cls(*map(np.array, arrays), list(proposed), list(accepted), tuple(values))

    def weight(self, which: int) -> np.ndarray:
        """Return weights of every example, see WEIGHTS."""
        return np.array([WEIGHTS[kind][which] for kind in self.kind])

    def folds(self, by: str = "group") -> dict[str, int]:
        """Return which groups, or systems, are left out together, the same in every run."""
        groups = sorted(set(getattr(self, by)) - JOINED.keys())
        order = np.random.default_rng(0).permutation(groups).tolist()
        return {**dict(zip(order, (np.arange(len(groups)) % FOLDS).tolist())), **JOINED}

    def judged(self, votes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the grounds of the verdicts, (n, 6), and whether they are right, (n,), for votes (n, c)."""
        cases = list(zip(votes, self.proposed, self.accepted))
        right = np.array([elect(v, proposed) in accepted for v, proposed, accepted in cases])
        return np.array([grounds(v, proposed) for v, proposed, _ in cases]), right

    def left_out_votes(self, learned: dict[int, Learned]) -> np.ndarray:
        """Return the votes on each sample, (n, c), by trees that were learned without its fold."""
        of_group = self.folds()
        return np.array([learned[of_group[g]].strategies.vote(case) for g, case in zip(self.group, self.x)])


def grown(e: Examples, chosen: np.ndarray) -> tuple[list[str], list[str]]:
    """Grow the trees for strategies and those for nonsense from the chosen examples, (n,) bool."""
    found = []
    for which, y, size in ((0, e.y, OF_STRATEGIES), (1, (e.kind == "nonsense").astype(int), OF_NONSENSE)):
        weight = e.weight(which)
        some = chosen & (weight > 0)
        found.append(grow(e.x[some], y[some], weight[some], **size))
    return found[0], found[1]


def fit(evidence, right, weight) -> np.ndarray:
    """Return the weights of a logistic regression, a little drawn to zero (Newton's method)."""
    found = np.zeros(evidence.shape[1])
    for _ in range(40):
        p = sureness(evidence, found) / VOTES.SUREST
        curvature = (evidence.T * (weight * p * (1 - p))) @ evidence + 0.01 * np.eye(len(found))
        found += np.linalg.solve(curvature, evidence.T @ (weight * (right - p)) - 0.01 * found)
    return found


def left_out(e: Examples, by: str = "group") -> tuple[dict[int, Learned], np.ndarray]:
    """Learn without each fold of groups, or of systems, in turn.

    Returns
    -------
    dict
        What is learned without fold k.
    (6,) float
        The weights of the grounds, from the votes on all folds by trees that did not see them.
    """
    of_group = e.folds(by)
    fold = np.array([of_group[g] for g in getattr(e, by)])
    votes, forests = np.empty((len(e.y), len(STRATEGIES))), {}
    for k in range(FOLDS):
        strategies, about = grown(e, fold != k)
        forests[k] = Forest([*EARLIER, *strategies], len(STRATEGIES)), Forest([*EARLIER_NONSENSE, *about], 2)
        votes[fold == k] = forests[k][0].shares(e.x[fold == k])
    (evidence, right), weight = e.judged(votes), e.weight(2)
    learned = {
        k: Learned(*forests[k], fit(evidence[fold != k], right[fold != k], weight[fold != k])) for k in range(FOLDS)
    }
    return learned, fit(evidence, right, weight)


def write(e: Examples, weights: np.ndarray) -> None:
    """Write the table, learned from all examples; the earlier trees stay."""
    strategies, about = grown(e, np.ones(len(e.y), bool))
    head, _ = TABLE.read_text().split("MEASURES = ")

    def told(name, values):
        return f"{name} = (\n" + "".join(f'    "{value}",\n' for value in values) + ")\n"

    TABLE.write_text(
        head
        + told("MEASURES", e.names)
        + told("STRATEGIES", [s.value for s in STRATEGIES])
        + f"SURENESS = ({', '.join(f'{w:.4g}' for w in weights)})\n"
        + told("TREES", strategies)
        + told("NONSENSE", about)
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("operations", nargs="+")
    parser.add_argument("--write", action="store_true", help="write the table")
    options = parser.parse_args()
    e = Examples.measured(labelled(options.operations))
    learned, weights = left_out(e)
    of_group = e.folds()
    _, right = e.judged(e.left_out_votes(learned))
    for kind in WEIGHTS:
        of = np.flatnonzero(e.kind == kind)
        fold = [of_group[g] for g in e.group[of]]
        nonsense = np.array([learned[k].nonsense.vote(case)[1] for k, case in zip(fold, e.x[of])])
        rules = np.mean([e.proposed[i].rules in e.accepted[i] for i in of])
        print(
            f"{kind:22s} {len(of):5d}: right by the rules {rules:.3f}, "
            f"with the votes {right[of].mean():.3f}; unlike anything that machines {np.mean(nonsense > VOTES.NONSENSE):.3f}"
        )
        print(" " * 23 + "; ".join(f"{np.mean(nonsense > at):.3f} from {at} of the votes on" for at in ELSEWHERE))
    if options.write:
        write(e, weights)


if __name__ == "__main__":
    main()
