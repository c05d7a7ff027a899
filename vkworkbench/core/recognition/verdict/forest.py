# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evaluate a small forest of decision trees. The trees are learned elsewhere and stored as text."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np


class _Nodes(NamedTuple):
    """The nodes of all trees as columns, and the first node of each tree.

    The columns are arrays and not lists, because the numbers of a list are scattered in memory and slow to read.
    """

    measure: array[int]
    below: array[float]
    no: array[int]
    share: list[np.ndarray]
    roots: list[int]

    def read(self, nodes: Iterator[str], classes: int) -> None:
        """Read the next subtree and append its nodes."""
        asked, inner, below = next(nodes).partition("<")
        at, share = len(self.measure), np.zeros(classes)
        self.measure.append(int(asked) if inner else -1)
        self.below.append(float(below) if inner else np.nan)
        self.no.append(at)
        self.share.append(share)
        if not inner:
            for part in asked.split(","):
                name, percent = part.split(":")
                share[int(name)] = float(percent) / 100
            return
        self.read(nodes, classes)
        self.no[at] = len(self.measure)
        self.read(nodes, classes)


class Forest:
    """Decision trees that each return the shares of the classes. The forest returns their mean.

    Parameters
    ----------
    trees : sequence of str
        Each text is a tree in prefix order, with spaces between the nodes. The node "3<0.25" asks whether measure 3 is
        below 0.25. The next subtree is for yes, and the subtree after it is for no. The node "2:70,5:30" is a leaf with
        70 percent for class 2 and 30 percent for class 5.
    classes : int
        Number of classes.
    """

    def __init__(self, trees: Iterable[str], classes: int) -> None:
        nodes = _Nodes(array("h"), array("d"), array("i"), [], [])
        for tree in trees:
            nodes.roots.append(len(nodes.measure))
            nodes.read(iter(tree.split()), classes)
        self._measure, self._below, self._no = np.array(nodes.measure), np.array(nodes.below), np.array(nodes.no)
        self._share, self._roots = np.array(nodes.share), np.array(nodes.roots)
        self._nodes = nodes

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

        For a single case, following the nodes of each tree one by one is faster than computing with arrays.
        """
        measure, below, no, _, roots = self._nodes
        values, leaves = [float(value) for value in case], []
        for node in roots:
            while (asked := measure[node]) >= 0:
                node = node + 1 if values[asked] < below[node] else no[node]
            leaves.append(node)
        result: np.ndarray = self._share[leaves].mean(axis=0)
        return result
