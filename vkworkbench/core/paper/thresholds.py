# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thresholds below which a move, a direction or a gap is rounding; in the form of recognition/thresholds.py.

Each comment gives the unit (up to the first full stop), the quantity compared, and the error at other values.
``benchmarks/thresholds.py`` prints how the verdicts change with each threshold; ``--rules`` leaves the learned model out.
"""


class MOVES:
    """Which moves have a direction, and where an area ends."""

    #: mm. A coordinate that changes by less is constant. Larger: helices lose their moves and become drilling.
    STILL = 1e-3
    #: mm. A shorter move beside a long one is rounding, and its direction is noise. Larger: links are dropped, and grids
    #: and offsets lose their corners. 0: such a move causes a half turn.
    NOISE = 0.02
    #: share of the longer neighbour. Only moves below this share are dropped as noise. 1: finely sampled paths lose moves.
    NOISE_BESIDE = 0.05
    #: ratio of rise to run. Steeper moves are plunges and lifts. Lower: helices and V-carving become plunges. Higher:
    #: passes over steep walls continue into their links.
    STEEP = 5.0
    #: cosine. Moves before and after a wall that are at least this parallel belong to one pass, and an area that begins
    #: and ends with such moves is straight. 1: links in the air count as cuts, and drilling at feed becomes an engraving.
    ONWARD = 0.98
    #: slope. A move with a larger slope against both axes of a vertical plane makes it the working plane. 0: a signature
    #: may use another plane than its toolpath.
    SLOPED = 0.05


class TURNS:
    """Which turns have no sign, and which are a full turn."""

    #: rad. A turn within this of half a turn is an exact reversal, and a level within this is reached. 0: rounding
    #: decides both.
    EXACT = 1e-6
    #: rad. Coordinates rounded to 0.001 mm may change the sign of a turn within this of half a turn. 0: zigzags with a
    #: contour become mixed or profiles. Larger: corners have no sign, and spirals become profiles.
    UNSIGNED = 0.01
    #: share of all turning of the image of V_k. A smaller part against the main sense is rounding. The threshold only
    #: decides whether the paper's verdict has a sense.
    BACK_AND_FORTH = 0.01


class LOOPS:
    """When the tool has returned to a point."""

    #: mm. A path that returns within this distance is closed. 0: loops that rounding left open become strokes. Larger:
    #: a path closes from row to row and from turn to turn.
    CLOSE = 0.03
    #: share of the side of a square with the area that the path encloses. A path with a smaller gap is closed as well.
    #: 0: contours with a gap between their leads stay open. 1: rows close.
    GAP = 0.03
    #: half-turns. An area whose phi changes by less has no loop. Lower: the same verdicts, but every raster is searched.
    #: Higher: the contour around a zigzag is not found.
    HALF_TURNS = 1.05
    #: share of an area's length. An area with a larger share in loops consists of loops, and its last loop closes. 0: the
    #: level of a zigzag with a loop in it includes the loop's closing turn. 1: the level of linked loops lacks it.
    LOOPED = 0.5
    #: share of the vertices. If fewer lie in loops, wider grids are searched as well. 0: loops that close with a move
    #: as short as rounding are not found.
    FOUND = 0.75
    #: turns. A loop with more absolute turning may be a zigzag that returns to its start. Higher: the contour that is
    #: cut after such a zigzag is not found.
    WAVY = 1.5
    #: share of the turning beyond one turn. A loop with less than this share of an overlapping loop's is the contour.
    #: 0: no loop is, and a zigzag with a contour becomes a zigzag.
    SMOOTHER = 0.5
