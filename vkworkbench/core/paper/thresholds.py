# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thresholds for moves, turns and loops. Most thresholds separate real differences from rounding.

A comment has the form of the comments in recognition/thresholds.py: the unit up to the first full stop, the quantity
that is compared with the threshold, and the errors at other values. ``benchmarks/thresholds.py`` prints how the
recognised strategies change with each threshold; its option ``--rules`` leaves out the learned model.
"""


class MOVES:
    """Thresholds that decide which moves have a direction, and where a monotonous area ends."""

    #: mm. A coordinate that changes by no more than the threshold is constant. If the value is larger, the moves of
    #: helices count as plunges, and helices are recognised as drilling.
    STILL = 1e-3
    #: mm. A move that is shorter than the threshold, beside a long move, is rounding, and its direction is noise. If
    #: the value is larger, links between passes are dropped, and grids and offset loops lose their corners. If the
    #: value is 0, moves from rounding remain and cause half turns.
    NOISE = 0.02
    #: share of the longer neighbouring trajectory's length. A short move is noise only if its length is below this
    #: share of the longer neighbouring trajectory's length. If the value is 1, finely sampled paths lose moves.
    NOISE_BESIDE = 0.05
    #: ratio of rise to run. Moves that are steeper than the threshold are plunges and lifts. If the value is lower,
    #: helices and V-carving count as plunges. If the value is higher, a pass over a steep wall and the link to the next
    #: pass are joined into one monotonous area.
    STEEP = 5.0
    #: cosine. Two moves have the same direction if the cosine of the angle between them is above the threshold. Moves
    #: in the same direction before and after a wall belong to one pass. A link in the air is straight: its first and
    #: its last move have the same direction. If the value is 1, links in the air count as cuts, and holes drilled with
    #: links at feed are recognised as an engraving.
    ONWARD = 0.98
    #: slope. A vertical plane is the working plane if a cutting move in the plane is neither nearly horizontal nor
    #: nearly vertical: the ratio of the move's shorter to its longer component is above the threshold. If the value is
    #: 0, the signature of a polyline and the areas of the same toolpath can have different planes.
    SLOPED = 0.05


class TURNS:
    """Thresholds that decide which turns have no sign, and when a full turn is complete."""

    #: rad. A turn that differs from half a turn by less than the threshold is an exact reversal, and a level (number of
    #: whole turns) is reached if phi is short of the level by less than the threshold. If the value is 0, rounding
    #: decides whether a turn is an exact reversal and whether a level is reached.
    EXACT = 1e-6
    #: rad. A turn that differs from half a turn by less than the threshold has no sign, because coordinates rounded to
    #: 0.001 mm can change the sign. If the value is 0, zigzags with a contour are recognised as mixed or as profiles.
    #: If the value is larger, turns at sharp corners have no sign, and spirals are recognised as profiles.
    UNSIGNED = 0.01
    #: share of all turning of the direction of V_k. If the turning against the main sense of rotation has at most this
    #: share, it is caused by rounding, and the direction of V_k counts as turning in one sense. The threshold only
    #: decides whether the result of the paper's rule has a sense of rotation.
    BACK_AND_FORTH = 0.01


class LOOPS:
    """Thresholds that decide when the tool has returned to a point."""

    #: mm. A path whose end is within the threshold of its start is closed. If the value is 0, loops that rounding left
    #: open are recognised as strokes. If the value is larger, rows or turns of a spiral that are one step apart count
    #: as closed loops.
    CLOSE = 0.03
    #: share of the side of a square with the area that the path encloses. A path is also closed if the gap between its
    #: end and its start is at most this share of the side. If the value is 0, contours with a gap between lead-in and
    #: lead-out count as open. If the value is 1, two neighbouring rows count as closed.
    GAP = 0.03
    #: half-turns. An area contains no loop if the range of its phi (sum of the turns) is no larger than the threshold.
    #: If the value is lower, the recognised strategies are the same, but the search for loops also takes time in every
    #: raster. If the value is higher, the contour around a zigzag is not found.
    HALF_TURNS = 1.05
    #: share of an area's length. If closed loops have more than this share, the area's level (number of whole turns)
    #: includes the closing turn of the last loop, from the loop's last move into its first. If the value is 0, the
    #: level of a zigzag includes the closing turn of a single loop. If the value is 1, the level of linked loops
    #: includes no closing turn.
    LOOPED = 0.5
    #: share of the vertices. If less than this share of the vertices is in closed loops, the search for loops is
    #: repeated with wider grid cells. If the value is 0, loops that close with a move as short as rounding are not
    #: found.
    FOUND = 0.75
    #: turns. A loop whose absolute turning is above the threshold can be a zigzag that returns to its start. If the
    #: value is higher, the contour that is cut after such a zigzag is not found.
    WAVY = 1.5
    #: share of the earlier loop's turning beyond one full turn. A loop replaces an overlapping loop that began earlier
    #: if the later loop's turning beyond one turn is below this share of the earlier loop's turning beyond one turn. If
    #: the value is 0, no loop is replaced, and a zigzag with a contour is recognised as a zigzag only.
    SMOOTHER = 0.5
