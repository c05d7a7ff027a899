# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation repeats at other depths: its pattern is that of one pass."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import Areas
from vkworkbench.core.recognition.footprints import same_ground
from vkworkbench.core.recognition.thresholds import SAME


def without_repeats(moves: Areas) -> Areas:
    """Leave out the areas that an earlier area covers already, seen from above, at another depth.

    A pattern lies in the plane. Cut once more 0.7 mm deeper it is the same pattern, and what is measured between its
    passes must not change.

    Parameters
    ----------
    moves : Areas

    Returns
    -------
    Areas
        The same object where nothing comes again.
    """
    start = moves.start
    if len(start) < 2:
        return moves
    last = np.append(start[1:], len(moves)) - 1
    end_x, end_y = moves.x[last] + moves.dx[last], moves.y[last] + moves.dy[last]
    low, high = np.minimum, np.maximum
    length = np.add.reduceat(moves.length, start)
    box = np.column_stack(
        [
            low(low.reduceat(moves.x, start), end_x),
            low(low.reduceat(moves.y, start), end_y),
            high(high.reduceat(moves.x, start), end_x),
            high(high.reduceat(moves.y, start), end_y),
        ]
    )
    group, groups = same_ground(box, length)
    if groups == len(start):
        return moves
    z = moves.z[start]
    first = np.full(groups, len(start))
    np.minimum.at(first, group, np.arange(len(start)))
    again = np.abs(z - z[first[group]]) > SAME.HEIGHT
    if not again.any():
        return moves
    return moves.only(~again)
