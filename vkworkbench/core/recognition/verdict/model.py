# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read and evaluate the learned model: decision trees that vote on nonsense toolpaths, and on strategies.

benchmarks/learn_model.py learns the trees from benchmarks/labelled_operations.csv and writes model.npz. The file
model.npz is read once, at the first recognition.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from pathlib import Path

import numpy as np

from vkworkbench.core.recognition.thresholds import VOTES

FILE = Path(__file__).with_name("model.npz")


@dataclass(frozen=True)
class Trees:
    """Decision trees as columns of their n nodes.

    Attributes
    ----------
    feature : (n,) int
        Feature that a node compares; -1 in a leaf.
    most : (n,) float
        Largest value of the feature for which the first child is the next node; infinite in a leaf.
    ahead : (n,) int
        Distance from a node to its first child; 0 in a leaf. The second child directly follows the first child.
    votes : (n, c) int
        Votes of a leaf for each class.
    roots : (t,) int
        Root node of every tree.
    """

    feature: np.ndarray
    most: np.ndarray
    ahead: np.ndarray
    votes: np.ndarray
    roots: np.ndarray

    def shares(self, cases: np.ndarray) -> np.ndarray:
        """Return each class's share of the votes for k cases with m features each, (k, c)."""
        case = np.arange(len(cases))[:, None]
        node = np.broadcast_to(self.roots, (len(cases), len(self.roots)))
        while (asked := self.feature[node]).max() >= 0:
            node = node + self.ahead[node] + (cases[case, asked] > self.most[node])
        votes = self.votes[node].sum(axis=1, dtype=float)
        return votes / votes.sum(axis=1, keepdims=True)


@dataclass(frozen=True)
class Model:
    """The trees that were learned from labelled operations.

    Attributes
    ----------
    names : (m,) str
        Names of the features.
    nonsense : Trees
        Trees that vote whether a toolpath machines a part (class 0) or is nonsense (class 1).
    strategies : Trees
        Trees that vote for a strategy; the classes are `decide.STRATEGIES`.
    calibration : (2,) float
        Offset and slope of the line that calibrates the confidence. The line maps the log odds of the share of the
        votes to the log odds that the elected strategy is right.
    """

    names: np.ndarray
    nonsense: Trees
    strategies: Trees
    calibration: np.ndarray

    def vote(self, features: Mapping[str, float]) -> tuple[float, np.ndarray]:
        """Return the share of the votes for nonsense, and the shares for the strategies, (c,)."""
        case = np.array([[features[name] for name in self.names]], np.float32)
        return float(self.nonsense.shares(case)[0, 1]), self.strategies.shares(case)[0]

    def sureness(self, share: float) -> float:
        """Return the probability that a strategy with this share of the votes is right."""
        offset, slope = self.calibration
        return float(1 / (1 + np.exp(-offset - slope * log_odds(share))))


def log_odds(share: np.ndarray | float) -> np.ndarray:
    """Return the log odds of a share of the votes."""
    share = np.clip(share, VOTES.MIN_SHARE, 1 - VOTES.MIN_SHARE)
    return np.log(share / (1 - share))


def read_trees(arrays: Mapping[str, np.ndarray], name: str) -> Trees:
    """Return the trees from the arrays whose names begin with the prefix `name`."""
    return Trees(*(arrays[f"{name}_{field.name}"] for field in fields(Trees)))


def read_model(file: Path) -> Model:
    """Read a model from a file."""
    with np.load(file, allow_pickle=False) as arrays:
        nonsense, strategies = (read_trees(arrays, name) for name in ("nonsense", "strategies"))
        return Model(arrays["names"], nonsense, strategies, arrays["calibration"])


@lru_cache(maxsize=1)
def shipped_model() -> Model:
    """Return the model that is part of the workbench."""
    return read_model(FILE)
