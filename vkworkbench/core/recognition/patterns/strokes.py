# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure open strokes, which are cuts (bites) of adaptive clearing, open contours or letters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import TURN
from vkworkbench.core.recognition.patterns.footprints import count_depths, footprints
from vkworkbench.core.recognition.patterns.pieces import Pieces
from vkworkbench.core.recognition.patterns.rows import weighted_median
from vkworkbench.core.recognition.thresholds import BITES, MAJORITY, ROUNDING, WINDINGS


@dataclass(frozen=True)
class Strokes:
    """Measures of k open strokes.

    Attributes
    ----------
    index : (k,) int
        Index of each stroke's piece.
    length : (k,) float
        Length of each stroke, mm.
    bite : (k,) bool
        Whether the stroke bends by more than a quarter turn in the sense of most strokes, and lies close to the bent
        stroke before or after it at the same depth. Adaptive clearing cuts many bent strokes side by side, one after
        the other.
    against : (k,) bool
        Whether the stroke bends by more than a quarter turn in the sense opposite to most strokes.
    sloped : (k,) bool
        Whether the height of the stroke changes.
    distinct, depths : int
        Number of different footprints of the strokes, and number of depths of the horizontal strokes.
    typical : float
        Median length of the strokes, weighted by length, mm.
    """

    index: np.ndarray
    length: np.ndarray
    bite: np.ndarray
    against: np.ndarray
    sloped: np.ndarray
    distinct: int
    depths: int
    typical: float

    def __len__(self) -> int:
        """Return the number of strokes."""
        return len(self.index)


def relate_strokes(pieces: Pieces, index: np.ndarray) -> Strokes:
    """Measure the open strokes.

    Parameters
    ----------
    pieces : Pieces
    index : (k,) int
        Indices of the pieces that are open strokes.
    """
    length = pieces.length[index]
    if not len(index):
        none = np.zeros(0, bool)
        return Strokes(index, length, none, none, none, 0, 0, 0.0)
    bends = np.abs(pieces.net[index]) > BITES.BENT * TURN
    bent = np.flatnonzero(bends & (pieces.back[index] < WINDINGS.WAVY_TURN * TURN))
    sense = np.sign(pieces.net[index[bent]])
    common = np.sign((length[bent] * sense).sum())
    box, z = pieces.box[index[bent]], pieces.z[index]
    centre, size = (box[:, :2] + box[:, 2:]) / 2, np.hypot(*(box[:, 2:] - box[:, :2]).T)
    moved = np.hypot(*np.diff(centre, axis=0).T)
    meets = moved < BITES.MOVED * np.minimum(size[1:], size[:-1])
    meets &= np.abs(np.diff(z[bent])) < ROUNDING.HEIGHT
    beside = np.zeros(len(bent), bool)
    beside[:-1] |= meets
    beside[1:] |= meets
    bite, against = np.zeros(len(index), bool), np.zeros(len(index), bool)
    with_most = sense == common
    # Most strokes that bend in the common sense of rotation must be close to a neighbouring bent stroke. If fewer
    # strokes are close, they are so by chance, and are not bites.
    if np.count_nonzero(with_most & beside) >= MAJORITY.SHARE * np.count_nonzero(with_most):
        bite[bent[with_most & beside]] = True
    against[bent[sense == -common]] = True
    _, distinct = footprints(pieces, index)
    return Strokes(
        index=index,
        length=length,
        bite=bite,
        against=against,
        sloped=~pieces.flat[index],
        distinct=distinct,
        depths=count_depths(z[pieces.flat[index]]),
        typical=weighted_median(length, length),
    )
