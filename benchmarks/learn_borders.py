#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn which retracts of a program separate operations, and write vkworkbench/core/recognition/programs/borders.npz.

    python3 benchmarks/learn_borders.py PROGRAMS.jsonl.gz OPERATIONS.jsonl.gz ... [--write]

PROGRAMS contains whole programs and OPERATIONS contains single operations, in the forms that benchmarks/records.py
describes. Random pairs of operations from the same part are also joined by a rapid, so that the border between them is
certain. The printed accuracy is measured by cross-validation: each tenth of the repositories and parts is judged by a
model that was learned without this tenth. The script needs the version of scikit-learn in tests/tools.txt.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import fields
from pathlib import Path

import numpy as np
from sklearn.ensemble import RandomForestClassifier

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from learn_model import exported
from records import JOINED, Record, joined, operations, programs

from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.programs.visits import FILE, compare_visits, find_visits
from vkworkbench.core.recognition.thresholds import VISITS
from vkworkbench.core.recognition.verdict.model import Trees

FOREST = {"n_estimators": 32, "max_leaf_nodes": 100, "max_features": 0.5, "random_state": 1, "n_jobs": -1}
MANY = 60  # maximum number of a program's retracts inside sections, because a raster can have very many retracts
FOLDS = 10
# Weights of a retract in the fit of the trees: a retract between two operations of a program, because programs have few
# such retracts; and any retract in single and joined operations. All other retracts in programs have the weight 1.
BORDERS_OF_PROGRAMS, OF_JOINED = 4.0, 0.5


def examples(path, sections) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the measures of retracts; and 0 for a retract inside a section, 1 for a retract between two sections.

    Return None if the program has no retract.
    """
    visits = find_visits(path, monotonous_areas(path))
    if visits is None:
        return None
    before, after = visits.last[:-1], visits.first[1:]
    border = np.full(len(before), -1)
    for s in sections:
        border[(before >= s.first) & (after <= s.last)] = 0
    for one, two in zip(sections, sections[1:]):
        border[(after > one.last) & (before < two.first)] = 1
    inside = np.flatnonzero(border == 0)
    if len(inside) > MANY:
        inside = np.random.default_rng(0).choice(inside, MANY, replace=False)
    chosen = np.union1d(inside, np.flatnonzero(border == 1))
    return np.column_stack(list(compare_visits(visits).values()))[chosen], border[chosen]


def retracts(of_programs: list[Record], single: list[Record]) -> tuple[np.ndarray, ...]:
    """Return five arrays on all retracts: measures, whether they are borders, groups, weights in the fit, kinds."""
    x, y, group, weight, kind = [], [], [], [], []
    single = [r for r in single if len(r.path) < JOINED]
    sources = ("programs", of_programs), ("operations", single), ("joined", joined(single, 500))
    for name, records in sources:
        for r in records:
            if (found := examples(r.path, r.sections)) is None:
                continue
            measures, border = found
            x.append(measures)
            y.append(border)
            group += [r.group] * len(border)
            of_program = np.where(border == 1, BORDERS_OF_PROGRAMS, 1.0)
            weight.append(of_program if name == "programs" else np.full(len(border), OF_JOINED))
            kind += [name] * len(border)
    return np.vstack(x), np.concatenate(y), np.array(group), np.concatenate(weight), np.array(kind)


def learn(x, y, weight) -> Trees:
    """Learn the trees from n retracts: their measures x (n, m), y (n,) = 1 between two operations, and weights (n,)."""
    return exported(RandomForestClassifier(**FOREST).fit(x, y, weight), 2)


def left_out(x, y, group, weight) -> tuple[dict[str, Trees], np.ndarray]:
    """Learn the trees several times, each time without the retracts in one fold of the groups (repositories and parts).

    Return for every group the trees that were learned without it, and for every retract the share of votes that it
    is a border between two operations.
    """
    groups = sorted(set(group))
    fold = dict(zip(np.random.default_rng(0).permutation(groups).tolist(), (np.arange(len(groups)) % FOLDS).tolist()))
    of = np.array([fold[g] for g in group])
    share, trees = np.empty(len(y)), []
    for k in range(FOLDS):
        out = of == k
        trees.append(learn(x[~out], y[~out], weight[~out]))
        share[out] = trees[k].shares(x[out])[:, 1]
    return {g: trees[k] for g, k in fold.items()}, share


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs")
    parser.add_argument("operations", nargs="+")
    parser.add_argument("--write", action="store_true", help="write the model")
    options = parser.parse_args()
    records = list(programs(options.programs)), list(operations(options.operations))
    x, y, group, weight, kind = retracts(*records)
    _, share = left_out(x, y, group, weight)
    said = share > VISITS.BORDER
    for name in dict.fromkeys(kind):
        of, true = kind == name, y == 1
        print(
            f"{name:10s} borders found {(said & true & of).sum()} of {(true & of).sum()}, "
            f"said inside an operation {(said & ~true & of).sum()} of {(~true & of).sum()} retracts"
        )
    if options.write:
        trees = learn(x, y, weight)
        np.savez_compressed(FILE, **{f"borders_{field.name}": getattr(trees, field.name) for field in fields(Trees)})


if __name__ == "__main__":
    main()
