# SPDX-License-Identifier: LGPL-2.1-or-later
"""Remove spurs, which are short moves out and back on one line, such as dogbone reliefs in corners."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.paper import Areas, closing_turns
from vkworkbench.core.recognition.thresholds import ROUNDING, SPURS


def without_spurs(moves: Areas) -> Areas:
    """Return the areas, without the spurs of closed areas.

    A spur is a move and its exact reversal, shorter than the moves before and after. The half turn of a spur has no
    sign, so that the turns of a contour with reliefs in its corners do not add up to 2 pi. Without the spur, the tool
    turns from the move before the spur to the move after the spur. If the spurs have a large share of an area's length,
    they are rows and are not removed.
    """
    out = moves.reversals - 1
    if not len(out):
        return moves
    inside = np.ones(len(moves) + 2, bool)  # whether a move of the same area precedes each move; False at the end
    inside[moves.start] = inside[len(moves) :] = False
    out = out[inside[out] & inside[out + 2]]
    back_x = moves.dx[out] + moves.dx[out + 1]
    back_y = moves.dy[out] + moves.dy[out + 1]
    level = np.abs(moves.dz[out]) + np.abs(moves.dz[out + 1]) < ROUNDING.HEIGHT
    shorter = moves.length[out] < np.minimum(moves.length[out - 1], moves.length[out + 2])
    out = out[level & shorter & (np.hypot(back_x, back_y) < ROUNDING.PLACE)]
    area = np.searchsorted(moves.start, out, side="right") - 1
    spent = np.bincount(area, moves.length[out] + moves.length[out + 1], len(moves.start))
    out = out[moves.closed[area] & (spent[area] < SPURS.LENGTH * moves.area_length[area])]
    out = out[np.diff(out, prepend=-4) > 2]  # if one spur directly follows another spur, only the first spur is removed
    if not len(out):
        return moves
    after = out + 2
    turn = closing_turns(moves.alpha, after, out)
    more = np.zeros(len(moves))
    more[after] = turn - moves.turning[np.array([out, out + 1, after])].sum(axis=0)  # change of phi without the spur
    turning = moves.turning.copy()
    turning[after] = turn
    more = np.cumsum(more)
    phi = moves.phi + more - np.repeat(more[moves.start], moves.end - moves.start)
    kept = np.ones(len(moves), bool)
    kept[out] = kept[out + 1] = False
    unsigned, reversals = (at[~np.isin(at, after)] for at in (moves.unsigned, moves.reversals))
    return some_moves(replace(moves, turning=turning, phi=phi, unsigned=unsigned, reversals=reversals), kept)


def some_moves(moves: Areas, kept: np.ndarray) -> Areas:
    """Return the areas with only the moves that `kept` (m,) bool selects, at least one in every area.

    If the first moves of an area are removed, the cumulative angle phi begins at 0 with the first kept move.
    """
    place = np.cumsum(kept) - 1
    names = ("index", "x", "y", "z", "dx", "dy", "dz", "length", "alpha", "turning", "phi")
    parts = {name: getattr(moves, name)[kept] for name in names}
    begin = place[moves.start] + ~kept[moves.start]
    size = np.diff(begin, append=len(parts["index"]))
    parts["phi"] -= np.repeat(parts["phi"][begin], size)
    parts["turning"][begin] = 0.0
    for name in ("unsigned", "reversals"):
        at = getattr(moves, name)
        at = place[at[kept[at]]]
        parts[name] = at[~np.isin(at, begin)]
    return replace(moves, start=begin, **parts)
