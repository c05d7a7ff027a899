# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths one after the other, each with its tool: every trajectory tried on every ray."""

from __future__ import annotations

import numpy as np
from zbuffer_reference.dexels import Pieces, first_cuts
from zbuffer_reference.removal import Removal


def pieces_of_job(cuts, stock, frame) -> Pieces:
    """The pieces of all rays of an image, by pixel and depth, cut by pairs of a toolpath and a tool."""
    row, column = np.divmod(np.arange(frame.width * frame.height), frame.width)
    x, y = frame.pixel_centres(column, row)
    near, far = stock.chords(frame.origins(x, y), frame.direction)
    found, first = [], 0
    for toolpath, tool in cuts:
        removal = Removal(toolpath, tool, stock, frame)
        ray, item = (pairs.ravel() for pairs in np.indices((len(x), len(removal.index))))
        enter, leave = removal._intervals(x[ray], y[ray], item)
        found.append((ray, removal.index[item] + first, enter, leave))
        first += len(toolpath)
    return first_cuts(near, far, *(np.concatenate(columns) for columns in zip(*found)))
