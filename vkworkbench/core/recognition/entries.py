# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the tool enters the material before the pattern of an area begins."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.thresholds import ENOUGH, ENTRY, SAME

LEVEL = 1e-6  # mm; a move that descends by more is no level one
ENTRIES = ("plunge", "ramp", "zigzag ramp", "helix")


def find_entry(moves: Areas) -> str | None:
    """Return how most of the depth is entered: one of `ENTRIES`; None where nothing level follows.

    An entry is what descends at the start of an area, before the first level move: it winds (helix), goes to and fro
    (zigzag ramp), or does neither (ramp). Areas that begin level were plunged into. Where most of what follows
    goes on descending, that is the operation, and no entry: a helical bore, a surface.

    Parameters
    ----------
    moves : Areas
        At least one move.
    """
    descends = moves.dz < -LEVEL
    begin, size = moves.start, moves.end - moves.start
    at = np.arange(len(moves))
    first = np.minimum.reduceat(np.where(descends, len(moves), at), begin)
    first = np.minimum(first, moves.end)
    after = at >= np.repeat(first, size)
    level = np.where(after & (np.abs(moves.dz) < LEVEL), moves.length, 0.0)
    following = np.where(after, moves.length, 0.0).sum()
    if level.sum() <= ENOUGH.SHARE * following or following <= 0:
        return None
    followed = np.add.reduceat(level, begin) > 0
    entry = followed & (first > begin)
    if not entry.any():
        return ENTRIES[0]
    begin, last = begin[entry], first[entry] - 1
    drop = moves.z[begin] - moves.dz[begin] - moves.z[last]
    if drop.max() < SAME.HEIGHT:
        return ENTRIES[0]
    turned = np.abs(moves.phi[last] - moves.phi[begin])
    reversed_ = np.add.accumulate(np.isin(at, moves.unsigned))
    to_and_fro = reversed_[last] > reversed_[begin]
    kind = np.where(turned > ENTRY.WINDS * TURN, 3, np.where(to_and_fro, 2, 1))
    return ENTRIES[int(np.argmax(np.bincount(kind, weights=drop, minlength=len(ENTRIES))))]
