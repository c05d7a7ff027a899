# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grow random forests (Breiman 2001), weighted and with few leaves, in plain numpy."""

from __future__ import annotations

import heapq

import numpy as np

from vkworkbench.core.recognition.verdict.forest import Forest


def grow(x, y, weight, *, trees: int, leaves: int, seed: int = 0, tried: float = 0.5) -> list[str]:
    """Return trees as :class:`Forest` reads them.

    Parameters
    ----------
    x : (n, m) float
    y : (n,) int
        Classes.
    weight : (n,) float
    trees, leaves : int
        Number of trees, and of leaves of each.
    seed : int
    tried : float
        Share of the measures that are tried at every node.
    """
    rng = np.random.default_rng(seed)
    # Four digits: what lies between two of these has five, and is the same when it is read again.
    x = np.array([[float(f"{value:.4g}") for value in row] for row in x])
    y, grown = y.astype(np.uint8), []
    for _ in range(trees):
        drawn, times = np.unique(rng.integers(len(y), size=len(y)), return_counts=True)
        grown.append(_tree(x[drawn], y[drawn], weight[drawn] * times, leaves, max(1, int(tried * x.shape[1])), rng))
    return grown


def forest(x, y, weight, classes: int, **options) -> Forest:
    """Return a grown forest that tells the shares of some classes."""
    return Forest(grow(x, y, weight, **options), classes)


def _split(x, y, weight, tried, rng):
    """Return the gain, measure and threshold of the best split by some random measures; None where none parts anything.

    The best leaves the least weighted Gini impurity on both sides: the largest sum of squares of what each class has there,
    for the sum of all.
    """
    able = np.flatnonzero(x.max(axis=0) > x.min(axis=0))
    whole = np.bincount(y, weight)
    if not len(able) or np.count_nonzero(whole) < 2:
        return None
    some = rng.permutation(able)[:tried]
    order = np.argsort(x[:, some], axis=0)
    value, of, weight = np.take_along_axis(x[:, some], order, axis=0), y[order], weight[order]
    # What the class of each row has up to that row: sums that run through class after class.
    by_class = np.argsort(of, axis=0, kind="stable")
    has = np.empty_like(weight)
    np.put_along_axis(has, by_class, np.cumsum(np.take_along_axis(weight, by_class, axis=0), axis=0), axis=0)
    has -= (np.cumsum(whole) - whole)[of]
    # (a + w)^2 is w (2 (a + w) - w) more than a^2.
    below, squares = np.cumsum(weight, axis=0), np.cumsum(weight * (2 * has - weight), axis=0)
    all_squares, total = whole @ whole, whole.sum()
    above_squares = all_squares - 2 * np.cumsum(weight * whole[of], axis=0) + squares
    gain = (squares / below)[:-1] + (above_squares[:-1] / (total - below[:-1])) - all_squares / total
    gain[value[1:] == value[:-1]] = -1.0
    last, best = np.unravel_index(np.argmax(gain), gain.shape)
    if gain[last, best] <= 1e-9 * total:
        return None
    middle = (value[last, best] + value[last + 1, best]) / 2
    return float(gain[last, best]), int(some[best]), float(f"{middle:.5g}")


def _tree(x, y, weight, leaves, tried, rng) -> str:
    """Grow one tree, the node that gains most first."""
    nodes, heap = [], []

    def add(rows):
        nodes.append({"rows": rows})
        split = _split(x[rows], y[rows], weight[rows], tried, rng)
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
            return [f"{node['measure']}<{node['below']:.5g}", *told(node["yes"]), *told(node["no"])]
        sums = np.bincount(y[node["rows"]], weight[node["rows"]])
        percent = np.rint(100 * sums / sums.sum()).astype(int)
        return [",".join(f"{k}:{p}" for k, p in enumerate(percent) if p)]

    return " ".join(told(0))
