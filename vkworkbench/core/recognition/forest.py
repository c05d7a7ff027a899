# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small forest of decision trees, learned elsewhere and kept as numbers."""

from __future__ import annotations

import numpy as np


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

    def __init__(self, trees, classes: int) -> None:
        self._measure, self._below, self._no, self._share, self._roots = [], [], [], [], []
        for tree in trees:
            self._roots.append(len(self._measure))
            self._read(iter(tree.split()), classes)
        self._nodes = self._measure, self._below, self._no, self._roots
        for name in ("_measure", "_below", "_no", "_share", "_roots"):
            setattr(self, name, np.array(getattr(self, name)))

    def _read(self, nodes, classes: int) -> None:
        """Append the next subtree."""
        node, at = next(nodes), len(self._measure)
        share = np.zeros(classes)
        self._measure.append(-1)
        self._below.append(0.0)
        self._no.append(at)
        self._share.append(share)
        if "<" not in node:
            for part in node.split(","):
                name, percent = part.split(":")
                share[int(name)] = float(percent) / 100
            return
        measure, below = node.split("<")
        self._measure[at], self._below[at] = int(measure), float(below)
        self._read(nodes, classes)
        self._no[at] = len(self._measure)
        self._read(nodes, classes)

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
        return self._share[node].mean(axis=1)

    def vote(self, case) -> np.ndarray:
        """Return the mean shares of the classes, (c,), for one case, a sequence of (m,) measures.

        For one case a walk over lists is faster than whole arrays.
        """
        measure, below, no, roots = self._nodes
        leaves = []
        for node in roots:
            while (at := measure[node]) >= 0:
                node = node + 1 if case[at] < below[node] else no[node]
            leaves.append(node)
        return self._share[leaves].mean(axis=0)
