# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thresholds below which a move, a direction or a gap is rounding; in the form of recognition/thresholds.py.

Each has its unit (up to the first full stop), what it tells apart, and what goes wrong without it. How the verdicts
change when one moves is printed by benchmarks/thresholds.py.
"""


class MOVES:
    """Which moves have a direction, and where an area ends."""

    #: mm. A coordinate that changes by less stands still.
    STILL = 1e-3
    #: mm. A move this short beside a long one is rounding, and its direction is noise.
    NOISE = 0.02
    #: share of the longer neighbour. Beside it the move is short.
    NOISE_BESIDE = 0.05
    #: ratio of rise to run. Steeper moves are plunges and lifts.
    STEEP = 5.0
    #: cosine. Moves on both sides of a wall that keep their direction so well are one pass over it.
    ONWARD = 0.98
    #: slope. A move that slopes by more against both axes of a vertical plane makes that the working plane.
    SLOPED = 0.05


class TURNS:
    """When a turn has no sign, and when it is a full one."""

    #: rad. A turn this close to half a turn is an exact reversal, and a level this close is reached.
    EXACT = 1e-6
    #: rad. Coordinates rounded to 0.001 mm may change the sign of a turn this close to half a turn.
    UNSIGNED = 0.01
    #: share of all turning of the image of V_k. Less than this against its sense is rounding.
    TO_AND_FRO = 0.01


class LOOPS:
    """When the tool has come back to a point."""

    #: mm. A path that comes back this close is closed.
    CLOSE = 0.03
    #: share of the side of a square as large as what the path encloses. A path with so small a gap is closed as well.
    GAP = 0.03
    #: half-turns. An area in which phi changes by less has no loop.
    HALF_TURNS = 1.05
    #: share of the vertices. Where fewer lie in loops, they are looked for once more on wider grids.
    FOUND = 0.75
    #: turns. A loop that turns by more in all, to and fro, may be a zigzag that comes back to its start.
    WAVY = 1.5
    #: share of the turning beyond one turn. A loop with less than this of the loop it overlaps is the contour.
    SMOOTHER = 0.5
