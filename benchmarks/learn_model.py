#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn the model of the recognition from the labelled operations, and judge it on sources left out of the learning.

    python3 benchmarks/learn_model.py              # learns and writes vkworkbench/core/recognition/verdict/model.npz
    python3 benchmarks/learn_model.py --check      # fails if the shipped model is not the one that the table gives
    python3 benchmarks/learn_model.py --judge      # prints the accuracy on sources left out of the learning

The table is benchmarks/labelled_operations.csv, which make_table.py writes. The script needs the version of
scikit-learn in tests/tools.txt.
"""

from __future__ import annotations

import argparse
import csv
import sys
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from sklearn.ensemble import ExtraTreesClassifier, RandomForestClassifier
from sklearn.linear_model import LogisticRegression

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from make_table import COLUMNS, TABLE
from reliability import calibration_error, two_class

from vkworkbench.core import Strategy
from vkworkbench.core.recognition.thresholds import VOTES
from vkworkbench.core.recognition.verdict.decide import STRATEGIES, elect, features
from vkworkbench.core.recognition.verdict.model import FILE, Model, Trees, log_odds, read_model

VALUES = tuple(s.value for s in STRATEGIES)
UNKNOWN = STRATEGIES.index(Strategy.UNKNOWN)
FOLDS = 10
#: Weights of a table row, by its kind, in three fits: of the strategies, of nonsense toolpaths, and of the confidence.
#: Programs have large weights, because users mostly analyse programs and the table has few programs.
WEIGHTS = {
    "program": (4.0, 6.0, 1.0),
    "program, told": (3.0, 0.0, 1.0),
    "freecad": (1.5, 1.0, 0.5),
    "freecad without tool": (1.0, 1.0, 0.0),
    "made": (3.0, 2.0, 0.0),
    "nonsense": (0.0, 2.0, 0.0),
}
BEST = 2.0  # weight of a row's best label in the fit of the strategies; all other labels of the row have the weight 1
# Random forests (Breiman 2001) recognise the strategy more accurately. Extremely randomised trees (Geurts, Ernst and
# Wehenkel 2006) recognise more kinds of nonsense toolpaths that the learning did not use. More trees or leaves
# improve the accuracy only a little, and the model's file already has 200 kB.
OF_STRATEGIES = {"n_estimators": 80, "max_leaf_nodes": 160, "max_features": 0.3, "random_state": 1, "n_jobs": -1}
OF_NONSENSE = {"n_estimators": 60, "max_leaf_nodes": 160, "max_features": 0.5, "random_state": 1, "n_jobs": -1}
SHARES = 255  # number of votes that a leaf divides among the classes


@dataclass
class Examples:
    """The n rows of the table of labelled operations.

    Attributes
    ----------
    kind, group, system : (n,) str
        `kind` is the key of the row's WEIGHTS. `group` is the repository, part or kind of toolpath whose rows are left
        out of the learning together. `system` is the CAM system, by which rows can be left out instead.
    x : (n, m) float
        Features.
    accepted : (n, c) bool
        STRATEGIES that count as right.
    best : (n,) int
        The best strategy of the row.
    rules : (n,) int
        The strategy that the rules propose. UNKNOWN marks a toolpath of a lathe, for which no trees vote.
    paper : (n,) int
        The verdict of the paper's own rule.
    names : (m,) str
        Names of the features.
    """

    kind: np.ndarray
    group: np.ndarray
    system: np.ndarray
    x: np.ndarray
    accepted: np.ndarray
    best: np.ndarray
    rules: np.ndarray
    paper: np.ndarray
    names: np.ndarray

    @classmethod
    def read(cls, table: Path = TABLE) -> Examples:
        """Read the table of labelled operations."""
        with open(table, newline="") as file:
            rows = list(csv.DictReader(file))
        measures = [name for name in rows[0] if name not in COLUMNS]
        told = {(row["source"], row["place"]) for row in rows if float(row["tool"])}
        found = []
        for row in rows:
            rules, paper, tool = Strategy(row["rules"]), Strategy(row["letter"]), float(row["tool"]) > 0
            known = features({name: float(row[name]) for name in measures}, rules, paper, tool=tool)
            right = [VALUES.index(name) for name in row["strategies"].split()]
            found.append(
                (
                    kind_of(row, told=(row["source"], row["place"]) in told, tool=tool),
                    row["group"],
                    row["system"],
                    list(known.values()),
                    np.isin(np.arange(len(VALUES)), right),
                    right[0],
                    STRATEGIES.index(rules),
                    STRATEGIES.index(paper),
                )
            )
        return cls(*map(np.array, zip(*found)), np.array(list(known)))

    def weight(self, which: int) -> np.ndarray:
        """Return the weight of every row in one of the three fits; `which` is the position of the fit in WEIGHTS."""
        return np.array([WEIGHTS[kind][which] for kind in self.kind])

    def folds(self, by: str) -> np.ndarray:
        """Return the fold of every row, from 0 to FOLDS - 1. All rows of a group or system have the same fold."""
        sources = np.unique(getattr(self, by))
        fold = np.empty(len(sources), int)
        fold[np.random.default_rng(0).permutation(len(sources))] = np.arange(len(sources)) % FOLDS
        return fold[np.searchsorted(sources, getattr(self, by))]


def kind_of(row: dict[str, str], *, told: bool, tool: bool) -> str:
    """Return the key of a row's WEIGHTS. `told` is true if another row of the operation has the tool's diameter."""
    if row["kind"] == "program" and tool:
        return "program, told"
    return "freecad without tool" if row["kind"] == "freecad" and told and not tool else row["kind"]


def exported(forest, classes: int) -> Trees:
    """Return the trees of a scikit-learn forest. A class's share of a leaf, 0 to 1, is stored as 0 to SHARES."""
    columns, roots, count = [], [], 0
    for tree in (one.tree_ for one in forest.estimators_):
        leaf = tree.children_left < 0
        assert (tree.children_right[~leaf] == tree.children_left[~leaf] + 1).all()
        share = tree.value[:, 0] / tree.value[:, 0].sum(axis=1, keepdims=True)
        votes = np.zeros((len(leaf), classes), np.uint8)
        votes[np.ix_(leaf, forest.classes_)] = np.rint(SHARES * share[leaf])
        ahead = np.where(leaf, 0, tree.children_left - np.arange(len(leaf)))
        columns.append((np.where(leaf, -1, tree.feature), np.where(leaf, np.inf, tree.threshold), ahead, votes))
        roots.append(count)
        count += len(leaf)
    feature, most, ahead, votes = map(np.concatenate, zip(*columns))
    return Trees(feature.astype(np.int16), most.astype(np.float16), ahead.astype(np.int16), votes, np.array(roots))


def learn(e: Examples, chosen: np.ndarray, calibration=(0.0, 1.0)) -> Model:
    """Learn the trees from the chosen rows, (n,) bool."""
    row, label = np.nonzero(e.accepted & (np.arange(len(VALUES)) != UNKNOWN) & (e.best != UNKNOWN)[:, None])
    share = np.where(label == e.best[row], BEST, 1.0)
    share /= np.bincount(row, share)[row]
    weight = e.weight(0)[row] * share
    some = chosen[row] & (weight > 0)
    strategies = RandomForestClassifier(**OF_STRATEGIES).fit(e.x[row[some]], label[some], weight[some])
    weight = e.weight(1)
    some = chosen & (weight > 0) & (e.rules != UNKNOWN)
    nonsense = ExtraTreesClassifier(**OF_NONSENSE).fit(e.x[some], (e.best == UNKNOWN)[some].astype(int), weight[some])
    return Model(e.names, exported(nonsense, 2), exported(strategies, len(STRATEGIES)), np.array(calibration))


def verdicts(model: Model, e: Examples, some: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the recognised strategies for some table rows, (k,), and their shares of the votes, (k,)."""
    x = e.x[some].astype(np.float32)
    voted = zip(model.nonsense.shares(x)[:, 1], model.strategies.shares(x), e.rules[some])
    said, share = map(np.array, zip(*(elect(nonsense, votes, rules) for nonsense, votes, rules in voted)))
    lathe = e.rules[some] == UNKNOWN
    return np.where(lathe, UNKNOWN, said), np.where(lathe, 1.0, share)


def calibrated(share: np.ndarray, right: np.ndarray, weight: np.ndarray) -> tuple[float, float]:
    """Return the offset and the slope that convert shares of votes to the probability that the verdict is right."""
    some = weight > 0
    found = LogisticRegression(C=100.0).fit(log_odds(share[some])[:, None], right[some], weight[some])
    return float(found.intercept_[0]), float(found.coef_[0, 0])


@dataclass
class LeftOut:
    """Verdicts on every row by a model that was learned without the row's source.

    Attributes
    ----------
    fold, said : (n,) int
    confidence : (n,) float
        Confidence of each verdict, calibrated on the other folds.
    right : (n,) bool
    models : list of Model
        The models that were learned without each fold.
    calibration : tuple of float
        Calibration of the confidence on all folds.
    """

    fold: np.ndarray
    said: np.ndarray
    confidence: np.ndarray
    right: np.ndarray
    models: list[Model]
    calibration: tuple[float, float]


def leave_out(e: Examples, by: str) -> LeftOut:
    """Learn several times, each time without one fold of the groups or systems; return the verdicts on the folds."""
    fold, weight = e.folds(by), e.weight(2)
    said, share, models = np.empty(len(fold), int), np.empty(len(fold)), []
    for k in range(FOLDS):
        models.append(learn(e, fold != k))
        said[fold == k], share[fold == k] = verdicts(models[k], e, fold == k)
    right, confidence = e.accepted[np.arange(len(said)), said], np.empty(len(fold))
    for k in range(FOLDS):
        seen = fold != k
        fitted = calibrated(share[seen], right[seen], weight[seen])
        models[k] = Model(models[k].names, models[k].nonsense, models[k].strategies, np.array(fitted))
        sure = [min(VOTES.SUREST, models[k].sureness(one)) for one in share[~seen]]
        confidence[~seen] = sure
    return LeftOut(fold, said, confidence, right, models, calibrated(share, right, weight))


def judge(e: Examples) -> None:
    """Print the accuracy on sources that are left out of the learning, as a table."""
    print(
        "| left out, a tenth at a time | toolpaths | number | right | two-class | the paper's literal rule | calibration error |"
    )
    print("|---|---|---|---|---|---|---|")
    for by, what in (("group", "repositories, parts, kinds"), ("system", "CAM systems")):
        found = leave_out(e, by)
        for kind in WEIGHTS:
            of = np.flatnonzero(e.kind == kind)
            right, sure = found.right[of], found.confidence[of]
            print(
                f"| {what} | {kind} | {len(of)} | {right.mean():.3f} | {two_classes(e, of, found.said[of])} | "
                f"{two_classes(e, of, e.paper[of])} | {calibration_error(sure, right):.3f} |"
            )


def two_classes(e: Examples, of: np.ndarray, said: np.ndarray) -> str:
    """Return the share of the rows `of` (k,) whose recognised strategies `said` (k,) are in the right class."""
    names = [[VALUES[s] for s in np.flatnonzero(e.accepted[i])] for i in of]
    told = [two_class(VALUES[e.best[i]], set(n), VALUES[s]) for i, n, s in zip(of, names, said)]
    known = [one for one in told if one is not None]
    return f"{np.mean(known):.3f} of {len(known)}" if known else ""


def arrays_of(model: Model) -> dict[str, np.ndarray]:
    """Return the arrays of the model's file."""
    trees = {
        f"{of}_{field.name}": getattr(getattr(model, of), field.name)
        for of in ("nonsense", "strategies")
        for field in fields(Trees)
    }
    return {"names": model.names, **trees, "calibration": np.round(model.calibration, 4)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--judge", action="store_true")
    options = parser.parse_args()
    e = Examples.read()
    if options.judge:
        judge(e)
        return 0
    found = arrays_of(learn(e, np.ones(len(e.x), bool), leave_out(e, "group").calibration))
    if options.check:
        shipped = arrays_of(read_model(FILE))
        other = [name for name in found if not np.array_equal(found[name], shipped[name])]
        print(
            f"not what the table gives: {', '.join(other)}"
            if other
            else "The model that ships is what the table gives."
        )
        return len(other)
    np.savez_compressed(FILE, **found)
    print(f"{FILE}: {FILE.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
