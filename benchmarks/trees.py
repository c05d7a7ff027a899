# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grow random forests (Breiman 2001) with weighted rows and few leaves, with numpy only."""

from __future__ import annotations

import heapq

import numpy as np

from vkworkbench.core.recognition.verdict.forest import Forest


def grow(x, y, weight, *, trees: int, leaves: int, seed: int = 0, tried: float = 0.5) -> list[str]:
    """Return grown trees in the form that :class:`Forest` reads.

    Parameters
    ----------
    x : (n, m) float
    y : (n,) int
        Class of each row.
    weight : (n,) float
    trees, leaves : int
        Number of trees, and number of leaves of each tree.
    seed : int
    tried : float
        Share of the measures that are tried at every node.
    """
    rng = np.random.default_rng(seed)
    # The measures are rounded to four digits. A threshold between two of them then has at most five digits, and does
    # not change when it is written and read again.
    x = np.array([[float(f"{value:.4g}") for value in row] for row in x])
    y, grown = y.astype(np.uint8), []
    for _ in range(trees):
        drawn, times = np.unique(rng.integers(len(y), size=len(y)), return_counts=True)
        grown.append(_tree(x[drawn], y[drawn], weight[drawn] * times, leaves, max(1, int(tried * x.shape[1])), rng))
    return grown


def forest(x, y, weight, classes: int, **options) -> Forest:
    """Return a grown forest that computes the shares of the classes."""
    return Forest(grow(x, y, weight, **options), classes)


def _split(x, y, weight, tried, rng):
    """Return the gain, the measure and the threshold of the best split by random measures; None if no split has a gain.

    The best split has the least weighted Gini impurity on both sides. This means the largest sum of the classes'
    squared weights on each side, divided by the total weight on this side.
    """
    able = np.flatnonzero(x.max(axis=0) > x.min(axis=0))
    whole = np.bincount(y, weight)
    if not len(able) or np.count_nonzero(whole) < 2:
        return None
    some = rng.permutation(able)[:tried]
    order = np.argsort(x[:, some], axis=0)
    value, of, weight = np.take_along_axis(x[:, some], order, axis=0), y[order], weight[order]
    # For each row, compute the weight of the row's class up to this row, by cumulative sums over the rows sorted by
    # class.
    by_class = np.argsort(of, axis=0, kind="stable")
    has = np.empty_like(weight)
    np.put_along_axis(has, by_class, np.cumsum(np.take_along_axis(weight, by_class, axis=0), axis=0), axis=0)
    has -= (np.cumsum(whole) - whole)[of]
    # Adding the weight w to a class with the weight a increases its square by (a + w)^2 - a^2 = w (2 (a + w) - w).
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
    """Grow one tree. The node with the largest gain is split first."""
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
