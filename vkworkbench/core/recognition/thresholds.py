# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of the recogniser: its unit, what it tells apart and what goes wrong without it.

One idea has one threshold, however many places ask for it. How the verdicts change when one moves is printed by
`benchmarks/thresholds.py`, which reads the unit (up to the first full stop) from the comments here.
"""


class SAME:
    #: mm. Heights closer than this are one depth.
    HEIGHT = 0.02
    #: mm. Lines and sides of boxes closer than this in the plane are one line.
    PLACE = 0.02
    #: mm. Rings whose boxes differ by less on every side are one ring.
    RING = 0.05
    #: share of the ring's size. Large rings may differ by so much more.
    RING_OF_SIZE = 0.002
    #: share of the reach. But by no more than this of the distance at which two rings are neighbours.
    RING_OF_REACH = 0.25
    #: share of the larger area. Two rings in one box that differ more are two shapes.
    AREA = 0.05
    #: mm. Boxes this close are one footprint, whatever their depth.
    GROUND = 0.1


class LITTLE:
    #: share of the length. Open strokes in all that are less are the links between loops.
    LINKS = 0.02
    #: share of the longest. Shorter rings and strokes are links and leads.
    PIECE = 0.02
    #: share of the longest pass. Shorter ones along the rows are links that run along the boundary.
    PASS = 0.1
    #: share of the length. Where less may be rows, it is links.
    ROWS = 0.1
    #: share of the first family of rows. Less in other directions is no second family.
    FAMILY = 0.1


class ENOUGH:
    #: share. What more than half of it is, it is.
    SHARE = 0.5
    #: count. Fewer repetitions are chance.
    TIMES = 5


class PASSES:
    #: cosine. A move so close to the axis of its stretch is part of a pass.
    ALONG = 0.9
    #: share of the length. A stretch of which more lies between half-turns that alternate goes back and forth.
    ALTERNATING = 0.3
    #: ratio. So many times as long as what lies between half-turns of one sense.
    MORE = 2
    #: share of the length. The same of closed loops.
    ALTERNATING_LOOP = 0.55


class WINDINGS:
    #: turns. A winding that turns by more against its sense steps aside to the next loop.
    ASIDE = 0.075
    #: turns. A stretch with a larger net turn is a winding.
    TURN = 1.2
    #: turns. A winding that turns back by more in all is wavy, a stroke no bite.
    WAVERING = 0.5
    #: places. A winding that is corrected at fewer is no hunt for the engagement.
    CORRECTIONS = 8
    #: rad. Nor where it turns by more at each.
    CORRECTION = 0.17453292519943295
    #: rad mm. What bends by less over its length may be rounding to 0.01 mm.
    ROUGH = 0.05
    #: turns. A winding that turns back by more may be passes of a lattice.
    BOUNCING = 0.75
    #: rad. Turns that are larger are corners.
    CORNER = 0.5235987755982988


class STROKES:
    #: share of the strokes. Where fewer are different, they are the same contour at other depths.
    DISTINCT = 0.67
    #: share of width and height of the part together. Longer strokes are contours.
    LONG = 0.35


class NESTS:
    #: mm. Rings that lie closer are not beside one another.
    APART = 0.01
    #: tool diameters. Farther apart two rings, rows or strokes leave ground uncut between them.
    REACH = 1.2
    #: rings. Each is compared with so many of those cut after it: around islands the rings of two nests take turns.
    NEXT = 3
    #: share of the mean. Offsets of a wavy ring move all sides of its box by the same to this.
    EQUAL_SIDES = 0.1
    #: share of the distance. No side of an offset's box moves by less.
    SIDE_AT_LEAST = 0.5
    #: ratio to the distance. Nor all of them by more.
    SIDE_AT_MOST = 1.5
    #: share of the ring's size. Two rings with a longer step between them are no nest.
    LARGEST_STEP = 0.3
    #: share of the step. Steps that differ by less are the same step again.
    SIMILAR_STEP = 0.3
    #: share of the steps. And so many of them must be equal.
    EQUAL_STEPS = 0.6
    #: share of the largest ring. Without a tool, a usual step that is larger is none.
    TOO_LARGE = 0.2
    #: share of the largest ring. Without a tool and a usual step, rings farther apart are two contours.
    REACH_OF_SIZE = 0.05
    #: steps. The reach where the tool is unknown or wrong.
    STEPS = 2


class WATERLINES:
    #: share of the length. And no more of it is sloped.
    SLOPED = 0.2
    #: relative spread. Spreads of steps are compared beyond this: rounding is no unevenness.
    ROUNDING = 0.01
    #: depths. A waterline has so many.
    DEPTHS = 3
    #: tool diameters. It goes deeper than this.
    RANGE = 0.35
    #: share of the length in rings. So many have another below or above.
    DEEPER = 0.3
    #: ratio of spreads. Below it the plane is divided evenly and not the depth.
    EVENER = 0.5
    #: depths. An open waterline has so many.
    OPEN_DEPTHS = 4


class RINGS:
    #: share of the length. Fewer rows are none beside rings.
    ROWS_BESIDE = 0.15
    #: isoperimetric quotient 4 pi A / P^2. A ring above it is a circle; a square has 0.79.
    ROUND = 0.93
    #: share of the drop. A ring whose mean height is so close to the middle of its drop descends all along.
    STEADY = 0.2
    #: share of the zigzag's box. A loop that is smaller by more on any side does not surround it.
    SURROUNDS = 0.15
    #: share of the length in rings. So much in circles is all.
    ALL_ROUND = 0.85
    #: share of the length. So much in rings of which so many are nested is enough to judge by the rings alone.
    OFFSETS = 0.7
    #: share of the length. So much in rings where there are hardly any rows.
    ALONE = 0.35
    #: share of the length. Fewer rings are none among rows.
    AMONG_ROWS = 0.1
    #: share of the steps. Nests of which more go one way are cut in that order.
    ONE_WAY = 0.75


class TROCHOIDS:
    #: share of the length in rings. So many that move along are trochoids.
    SHARE = 0.4
    #: share of the range. Trochoids move aside: the sides of their boxes move both ways, in the mean by less.
    SWAY = 0.35
    #: share of the smaller loop. They move by no more.
    STEP = 1.2
    #: share of the larger loop. And are of one size.
    SIZE = 0.65


class ROWS:
    #: directions in half a turn. The densest direction is looked for among so many.
    DIRECTIONS = 64
    #: values. So many are enough for a median.
    SAMPLE = 1000
    #: rad. A move this close to the axis belongs to a row.
    ALIGNED = 0.05
    #: share of the length. Where less keeps to the main axis, there are several.
    ONE_AXIS = 0.8
    #: share of the length. Where less does, the links have turned the axis.
    ALL_ALIGNED = 0.98
    #: steps. A neighbour is no farther away.
    FARTHER = 1.6
    #: steps. And no nearer.
    NEARER = 0.6
    #: share of the pitch. Gaps that differ by more in turn are those of two sets of lines.
    TWO_PITCHES = 0.1
    #: share of the length. Where less has a neighbour, the passes are no rows.
    BESIDE = 0.25
    #: steps. Rows are longer.
    LONG = 2.5
    #: steps. Many even rows are longer than this.
    LONG_IF_MANY = 1.5
    #: lines. So many are many.
    MANY = 10
    #: share of the steps. Rows with more usual steps are even.
    EVEN = 0.8
    #: tool diameters. Passes closer than this are the same pass again.
    RETRACED = 0.03
    #: pitches. A contour's rows that come again later are the walls of teeth.
    WALLS = 1.05
    #: share of the length. Two families of rows that are more are a grid.
    GRID = 0.85


class ARCS:
    #: cosine. A move at so right an angle to the ray from the centre is part of a circle around it.
    SQUARE = 0.15
    #: share of the squared length. Moves that are more alike in direction have no centre.
    STRAIGHT_ROWS = 0.01
    #: share of the length. A stroke of which more lies on the circle is an arc.
    ARC = 0.9
    #: steps. Radii that differ by less are one.
    RADIUS = 0.3
    #: steps. An arc that drifts by more in a turn is part of a spiral.
    DRIFT = 0.3


class BITES:
    #: turns. A stroke that bends by more may be a bite.
    BENT = 0.25
    #: share of the length. or so much
    SHARE = 0.1
    #: bites. by so many is adaptive.
    COUNT = 10
    #: share of the bites. But not where more bend the other way.
    AGAINST = 0.3


class POCKET:
    #: ratio. Strokes that enclose less for their length than the ring fill it.
    WIDTH = 0.75
    #: share of the length. So much in strokes inside a ring fills it.
    FILLED = 0.1


class ADAPTIVE:
    #: share of the length. Windings with so much in bites are adaptive,
    BITES = 0.03
    #: share of the length. or with so much in a helix,
    ENTRY = 0.005
    #: share of the length. or with so much left to open strokes.
    STROKES = 0.3


class PARTS:
    #: borders. More are no operations, and each section takes its time.
    BORDERS = 200
    #: share of the areas. Fewer holes beside the milling are passes clipped to a point.
    DRILLED = 0.25
    #: depths. Where there are more, heights are those of a surface.
    DEPTHS = 10
    #: share of the length. Sections that differ and are less do not make a program mixed.
    ASIDE = 0.05
    #: share of the length. So much is enough behind a border that is certain.
    CERTAIN = 0.01


class VISITS:
    #: share of the votes. So many say that another operation begins.
    BORDER = 0.3
    #: visits. More sections are no operations, and each takes its time.
    MOST = 60
    #: share of the length. A block whose ends lie closer together is closed.
    CLOSED = 0.03
    #: share of the size. Visits whose boxes differ by less on every side cover the same ground.
    PLACE = 0.01
    #: share. Feeds that differ by less are one feed.
    FEED = 0.01
    #: mm. What is smaller counts as so large, that a hole has a size.
    SMALL = 0.05


class CONFIDENCE:
    #: confidence. Below it no strategy is defended: the answer is "unknown".
    DEFENDED = 0.65
    #: confidence. Of drilling.
    DRILLING = 0.98
    #: confidence. That of a verdict for which hardly anything is seen.
    LEAST = 0.62
    #: confidence. What support and number may add.
    SPAN = 0.35
    #: repetitions. After so many the confidence has grown by two thirds of what the number may add.
    TIMES = 1.5
    #: support. Of a pattern that is there, whatever its share.
    GIVEN = 0.6
    #: support. Of a pocket of one ring and one stroke inside.
    POCKET = 0.5
    #: support. Of open strokes that have no pattern among them.
    STROKES = 0.8
    #: support. Of open strokes that are called contours because they are long.
    LONG_STROKES = 0.4
