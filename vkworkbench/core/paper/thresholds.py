# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thresholds below which a move, a direction or a gap is rounding; in the form of recognition/thresholds.py.

Each has its unit (up to the first full stop), what it tells apart, and what goes wrong without it. How the verdicts
change when one moves is printed by benchmarks/thresholds.py, those of the rules alone with --rules.
"""


class MOVES:
    """Which moves have a direction, and where an area ends."""

    #: mm. A coordinate that changes by less stands still. Larger: helices stand still and are drilling.
    STILL = 1e-3
    #: mm. A move this short beside a long one is rounding, and its direction is noise. Larger: links are, and grids and
    #: offsets lose their corners; at 0 such a move turns by half a turn.
    NOISE = 0.02
    #: share of the longer neighbour. Beside it the move is short. At 1, finely sampled paths lose moves.
    NOISE_BESIDE = 0.05
    #: ratio of rise to run. Steeper moves are plunges and lifts. Less: helices and V-carving are; larger: passes over
    #: steep walls go on into their links.
    STEEP = 5.0
    #: cosine. Moves before and after a wall that are so parallel are one pass over it, and an area that begins and ends
    #: with such moves is straight. At 1 links in the air are cuts: drilling at feed is an engraving.
    ONWARD = 0.98
    #: slope. A move that slopes by more against both axes of a vertical plane makes that the working plane. At 0, by
    #: tests, a signature is seen in another plane than its toolpath.
    SLOPED = 0.05


class TURNS:
    """When a turn has no sign, and when it is a full one."""

    #: rad. A turn this close to half a turn is an exact reversal, and a level this close is reached. At 0 rounding
    #: decides both.
    EXACT = 1e-6
    #: rad. Coordinates rounded to 0.001 mm may change the sign of a turn this close to half a turn. At 0 zigzags with a
    #: contour are mixed and profiles; larger: corners have no sign, and spirals are profiles.
    UNSIGNED = 0.01
    #: share of all turning of the image of V_k. Less than this against its sense is rounding; it decides whether the
    #: paper's verdict has a sense, and no verdict of ours.
    TO_AND_FRO = 0.01


class LOOPS:
    """When the tool has come back to a point."""

    #: mm. A path that comes back this close is closed. At 0 loops that rounding left open are strokes; larger: a path
    #: closes from row to row and from turn to turn.
    CLOSE = 0.03
    #: share of the side of a square as large as what the path encloses. A path with so small a gap is closed as well.
    #: At 0 contours that leads leave open are; at 1 rows close.
    GAP = 0.03
    #: half-turns. An area in which phi changes by less has no loop. Less: no verdict, but every raster is searched;
    #: larger: the contour around a zigzag is not found.
    HALF_TURNS = 1.05
    #: share of an area's length. An area with more of it in loops is made of loops, and its last one closes. At 0 the
    #: level told of a zigzag with a loop in it counts that loop's closing turn; at 1 that of linked loops lacks it.
    LOOPED = 0.5
    #: share of the vertices. Where fewer lie in loops, they are looked for once more on wider grids. At 0, by tests,
    #: loops that close with a move as short as rounding are not found.
    FOUND = 0.75
    #: turns. A loop that turns by more in all, to and fro, may be a zigzag that comes back to its start. Larger: the
    #: contour that is cut after it is not found.
    WAVY = 1.5
    #: share of the turning beyond one turn. A loop with less than this of the loop it overlaps is the contour.
    #: At 0 none is, and a zigzag with a contour is a zigzag.
    SMOOTHER = 0.5
