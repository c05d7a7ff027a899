# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small forest of decision trees, learned elsewhere and kept as numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np


class _Nodes(NamedTuple):
    """The nodes of all trees as columns, and the first of each tree."""

    measure: list[int]
    below: list[float]
    no: list[int]
    share: list[np.ndarray]
    roots: list[int]

    def read(self, nodes: Iterator[str], classes: int) -> int:
        """Append the next subtree and return how many questions it asks at most."""
        node, at = next(nodes), len(self.measure)
        share = np.zeros(classes)
        self.measure.append(-1)
        self.below.append(-np.inf)  # no case is below that: a leaf leads to itself
        self.no.append(at)
        self.share.append(share)
        if "<" not in node:
            for part in node.split(","):
                name, percent = part.split(":")
                share[int(name)] = float(percent) / 100
            return 0
        measure, below = node.split("<")
        self.measure[at], self.below[at] = int(measure), float(below)
        yes = self.read(nodes, classes)
        self.no[at] = len(self.measure)
        return 1 + max(yes, self.read(nodes, classes))


class Forest:
    """Decision trees that each give the shares of the classes; their mean is the answer.

    Parameters
    ----------
    trees : sequence of str
        Each a tree in prefix order, its nodes parted by spaces. "3<0.25" asks whether measure 3 is below 0.25: the
        node that follows is for yes, the one after that subtree for no. "2:70,5:30" is a leaf with the shares of the
        classes in percent.
    classes : int
        Number of classes.
    """

    def __init__(self, trees: Iterable[str], classes: int) -> None:
        nodes = _Nodes([], [], [], [], [])
        self._deep = 0
        for tree in trees:
            nodes.roots.append(len(nodes.measure))
            self._deep = max(self._deep, nodes.read(iter(tree.split()), classes))
        self._measure, self._below, self._no = np.array(nodes.measure), np.array(nodes.below), np.array(nodes.no)
        self._share, self._roots = np.array(nodes.share), np.array(nodes.roots)
        self._yes = np.arange(len(self._no)) + 1

    def shares(self, measures: np.ndarray) -> np.ndarray:
        """Return the mean shares of the classes.

        Parameters
        ----------
        measures : (k, m) float

        Returns
        -------
        (k, c) float
        """
        case = np.arange(len(measures))[:, None]
        node = np.broadcast_to(self._roots, (len(measures), len(self._roots)))
        while (inner := self._measure[node] >= 0).any():
            yes = measures[case, self._measure[node]] < self._below[node]
            node = np.where(inner, np.where(yes, node + 1, self._no[node]), node)
        result: np.ndarray = self._share[node].mean(axis=1)
        return result

    def vote(self, case: Sequence[float]) -> np.ndarray:
        """Return the mean shares of the classes, (c,), for one case, a sequence of (m,) measures.

        For one case it is faster to answer the questions of all nodes at once than those of one tree after the other.
        """
        onward = np.where(np.asarray(case)[self._measure] < self._below, self._yes, self._no)
        node = self._roots
        for _ in range(self._deep):
            node = onward[node]
        result: np.ndarray = self._share[node].mean(axis=0)
        return result
