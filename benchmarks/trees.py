# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grow forests of extremely randomised trees (Geurts, Ernst and Wehenkel 2006) in plain numpy."""

from __future__ import annotations

import heapq

import numpy as np

from vkworkbench.core.recognition.forest import Forest


def grow(x, y, weight, classes: int, *, trees: int, leaves: int, seed: int = 0, tried: float = 0.5) -> list[str]:
    """Return trees as :class:`Forest` reads them.

    Parameters
    ----------
    x : (n, m) float
    y : (n,) int
        Classes.
    weight : (n,) float
    classes, trees, leaves : int
        Number of classes, of trees, and of leaves of each tree.
    seed : int
    tried : float
        Share of the measures that are tried at every node, each with one random threshold.
    """
    rng = np.random.default_rng(seed)
    weights = np.zeros((len(y), classes))
    weights[np.arange(len(y)), y] = weight
    return [_tree(x, weights, leaves, max(1, int(tried * x.shape[1])), rng) for _ in range(trees)]


def forest(x, y, weight, classes: int, **options) -> Forest:
    """Return a grown forest."""
    return Forest(grow(x, y, weight, classes, **options), classes)


def _impurity(sums):
    """Weighted Gini impurity of sums of weights by class, (..., c)."""
    total = sums.sum(axis=-1)
    return total - (sums * sums).sum(axis=-1) / np.maximum(total, 1e-12)


def _split(x, weights, tried, rng):
    """Return the gain, measure and threshold of the best of some random splits; None where none parts anything."""
    low, high = x.min(axis=0), x.max(axis=0)
    able = np.flatnonzero(high > low)
    if not len(able) or (weights.sum(axis=0) > 0).sum() < 2:
        return None
    some = rng.permutation(able)[:tried]
    below = low[some] + (high - low)[some] * rng.uniform(0, 1, len(some))
    below = np.array([float(f"{b:.4g}") for b in below])
    yes = x[:, some] < below
    left = yes.T.astype(float) @ weights
    whole = weights.sum(axis=0)
    gain = _impurity(whole) - _impurity(left) - _impurity(whole - left)
    gain[~(yes.any(axis=0) & ~yes.all(axis=0))] = -1.0
    best = int(np.argmax(gain))
    return (float(gain[best]), int(some[best]), float(below[best])) if gain[best] > 0 else None


def _tree(x, weights, leaves, tried, rng) -> str:
    """Grow one tree, the node that gains most first."""
    nodes, heap = [], []

    def add(rows):
        nodes.append({"rows": rows})
        split = _split(x[rows], weights[rows], tried, rng)
        if split:
            heapq.heappush(heap, (-split[0], len(nodes) - 1, split[1], split[2]))
        return len(nodes) - 1

    add(np.arange(len(x)))
    while heap and (len(nodes) + 1) // 2 < leaves:
        _, at, measure, below = heapq.heappop(heap)
        rows = nodes[at]["rows"]
        yes = x[rows, measure] < below
        nodes[at].update(measure=measure, below=below, yes=add(rows[yes]), no=add(rows[~yes]))

    def told(at):
        node = nodes[at]
        if "measure" in node:
            return [f"{node['measure']}<{node['below']:.4g}", *told(node["yes"]), *told(node["no"])]
        sums = weights[node["rows"]].sum(axis=0)
        percent = np.rint(100 * sums / max(sums.sum(), 1e-12)).astype(int)
        return [",".join(f"{k}:{p}" for k, p in enumerate(percent) if p)]

    return " ".join(told(0))
