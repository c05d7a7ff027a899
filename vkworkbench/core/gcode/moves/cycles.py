# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert canned drilling cycles into moves, many cycles at once."""

from __future__ import annotations

from math import isnan, nan

import numpy as np

from vkworkbench.core.gcode.moves.codes import FEED_OUT, PECK, PECKING

# mm, height above the bottom of the last peck to which G73 retracts, and at which the return of G83 ends, as in
# LinuxCNC.
CLEARANCE = 0.254
MOST_PECKS = 10_000  # largest number of pecks in a hole; a Q word that needs more is ignored to save memory


class Heights:
    """The R and Z words in force for canned cycles, from which the heights of each cycle are computed."""

    def __init__(self) -> None:
        self._begin: float | None = None  # Height at the start of the series of cycles; None between two series.
        # Whether R is higher than the start of the series, so that the tool rises to R before it moves to the hole.
        self.rises = False
        self._level = self._depth = 0.0
        self._r = self._z = nan

    def part(self) -> None:
        """End the series of cycles, as another motion or G80 does."""
        self._begin = None

    def drill(
        self, height: float | None, r: float, z: float, *, relative: bool, to_retract_plane: bool
    ) -> tuple[float, float, float, float]:
        """Return four heights, mm: before the cycle, of the R plane, of the hole's bottom, and after the cycle.

        Parameters
        ----------
        height : float or None
            Height before the cycle, mm. If None, the height of the tool is unknown, and the cycle starts at its R
            plane.
        r, z : float
            R and Z word, mm; NaN where absent.
        relative, to_retract_plane : bool
            Whether G91 and G99 are in force; see :func:`heights`.
        """
        own_r, own_z = not isnan(r), not isnan(z)
        self._r, self._z = r if own_r else self._r, z if own_z else self._z
        if height is None:
            height = 0.0 if isnan(self._r) else self._r
        begins = self._begin is None
        begin = self._begin = height if self._begin is None else self._begin
        if begins or own_r:
            self._level = begin if isnan(self._r) else self._r + (begin if relative else 0.0)
        if begins or own_z or (own_r and relative):
            self._depth = self._level if isnan(self._z) else self._z + (self._level if relative else 0.0)
        clear = min if self._depth > self._level else max
        self.rises = clear(begin, self._level) != begin
        return height, self._level, self._depth, self._level if to_retract_plane else clear(begin, self._level)


def heights(
    z: np.ndarray,
    relative: np.ndarray,
    rows: np.ndarray,
    series: np.ndarray,
    retract: np.ndarray,
    bottom: np.ndarray,
    to_retract_plane: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Compute the Z coordinates of all commands in a program with canned cycles.

    Each cycle starts at the height where the previous motion ended.

    An R or Z word stays in force for the rest of a series of cycles. Under G91, R is relative to the height at the
    start of the series, and Z is relative to R, so all holes in a series have equal depths.

    Parameters
    ----------
    z : (n,) float64
        Z words of the commands that are not cycles, mm; NaN elsewhere.
    relative : (n,) bool
        Whether G91 is in force.
    rows : (m,) int
        Indices of the commands that are cycles, ascending.
    series : (m,) int
        For each cycle, the number of the series to which the cycle belongs. Another motion or G80 ends a series.
    retract, bottom : (m,) float64
        The cycles' own R and Z words, mm; NaN where absent.
    to_retract_plane : (m,) bool
        Whether G99 is in force, under which a cycle ends at R. Under G98, a cycle ends at the height at the start of
        its series, or at R if R is higher. If the hole is drilled upwards, a cycle under G98 ends at the lower of both
        heights.

    Returns
    -------
    z : (n,) float64
        Absolute Z after each command that sets Z, mm; NaN elsewhere.
    heights : (m, 4) float64
        Four heights of each cycle, mm: before the cycle, of its R plane, of the hole's bottom, and after the cycle.
    rises : (m,) bool
        Whether R is higher than the start of the series. The tool then rises to R before it moves to the hole, as in
        LinuxCNC.
    """
    absolute = z.copy()
    resolved, rises = np.empty((len(rows), 4)), np.zeros(len(rows), bool)
    height: float | None = None
    number, state = -1, Heights()
    cycle_at = dict(zip(rows.tolist(), range(len(rows))))
    for row in np.flatnonzero(~np.isnan(z) | np.isin(np.arange(len(z)), rows)).tolist():
        i = cycle_at.get(row)
        if i is None:
            height = float(z[row]) + (height if relative[row] and height is not None else 0.0)
        else:
            if series[i] != number:
                state.part()
                number = int(series[i])
            resolved[i] = state.drill(height, float(retract[i]), float(bottom[i]), relative=bool(relative[row]),
                                      to_retract_plane=bool(to_retract_plane[i]))  # fmt: skip
            height, rises[i] = float(resolved[i, 3]), state.rises
        absolute[row] = height
    return absolute, resolved, rises


def has_tiny_pecks(heights: np.ndarray, peck: np.ndarray) -> np.ndarray:
    """Return whether the Q word of each cycle needs more than `MOST_PECKS` pecks, (m,) bool; see :func:`moves`."""
    return (peck > 0) & (peck * MOST_PECKS <= heights[:, 1] - heights[:, 2])


def move_counts(code: np.ndarray, heights: np.ndarray, peck: np.ndarray) -> np.ndarray:
    """Return the number of moves of each cycle, (m,) int; see :func:`moves` for the parameters."""
    depth = np.maximum(heights[:, 1] - heights[:, 2], 0.0)
    pecking = np.isin(code, PECKING) & (peck > 0) & ~has_tiny_pecks(heights, peck)
    pecks = np.ceil(depth / np.where(pecking, peck, np.inf) - 1e-9)
    # Each cycle has 3 moves to approach, 3 moves for each peck except for the last peck (feed, retract, return), a feed
    # to the bottom, a feed out of the hole (FEED_OUT only), and a retract. The return of G73 has zero length.
    return 3 + 3 * (np.maximum(pecks, 1.0).astype(np.int64) - 1) + 2 + np.isin(code, FEED_OUT)


def moves(
    code: np.ndarray,
    start: np.ndarray,
    hole: np.ndarray,
    heights: np.ndarray,
    peck: np.ndarray,
    rises: np.ndarray,
    leaves: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the moves of m cycles.

    Parameters
    ----------
    code : (m,) int
        G-code of each cycle, as ten times its number (810 for G81).
    start : (m, 3) float64
        Position before the cycle, mm.
    hole : (m, 2) float64
        X and Y of the hole, mm.
    heights : (m, 4) float64
        Four heights of each cycle, mm: before the cycle, of its R plane, of the hole's bottom, and after the cycle
        (G98/G99).
    peck : (m,) float64
        Q word, depth of one peck, mm; NaN where absent.
    rises : (m,) bool
        Whether the tool rises to R before it moves to the hole.
    leaves : (m,) float64
        Height up to which a cycle of FEED_OUT leaves the hole at feed, mm.

    Returns
    -------
    points : (k, 3) float64
        End point of each move, mm; some moves have zero length.
    rapid : (k,) bool
        Whether each move is a rapid.
    """
    _, retract, bottom, after = heights.T
    counts = move_counts(code, heights, peck)
    cycle = np.repeat(np.arange(len(code)), counts)
    first = np.cumsum(counts) - counts
    step = np.arange(len(cycle)) - first[cycle]
    level = retract[cycle] - step // 3 * peck[cycle]
    back = np.minimum(level + CLEARANCE, retract[cycle])
    out = np.where(code[cycle] == PECK, retract[cycle], back)

    points = np.empty((len(cycle), 3))
    points[:, :2] = hole[cycle]
    points[:, 2] = np.choose(step % 3, [level, out, back])
    rapid = step % 3 != 0
    clear = np.where(bottom > retract, np.minimum(start[:, 2], retract), np.maximum(start[:, 2], retract))
    clear = np.where(rises, retract, clear)
    points[first] = np.column_stack([start[:, :2], np.where(rises, retract, start[:, 2])])
    points[first + 1, 2] = clear
    points[first + 2, 2] = retract
    rapid[first] = True
    last = first + counts - 1
    feeds_out = np.isin(code, FEED_OUT)
    out_of_hole = last[feeds_out] - 1
    points[out_of_hole, 2] = leaves[feeds_out]
    rapid[out_of_hole] = False
    deepest = last - 1 - feeds_out
    points[deepest, 2] = bottom
    rapid[deepest] = False
    points[last, 2] = after
    rapid[last] = True
    return points, rapid
