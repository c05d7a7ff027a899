# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of the recogniser, with its unit and what goes wrong with higher and lower values.

One idea has one threshold, wherever it is used. Comments begin with the unit, up to the first full stop. "becomes" tells what the
rules propose for synthetic toolpaths and for operations made by FreeCAD (benchmarks/make_operations.py), which have a tool;
"in real programs" means programs that had no part in the rules. `benchmarks/thresholds.py --rules OPERATIONS.jsonl.gz` moves each
threshold and prints the changes; without --rules it prints the changes of the final verdicts, which the trees dominate.
"""


class ROUNDING:
    """Differences that rounding and sampling leave between equal things."""

    #: mm. Largest difference of two heights of one depth. Higher: the turns of a helix have one depth and become
    #: profiles.
    HEIGHT = 0.02
    #: mm. Largest distance of lines, or of sides of boxes, that count as one line. Higher: all rows are one line, and
    #: zigzags become engravings. 0: so do some zigzags with rounded rows.
    PLACE = 0.02
    #: mm. Largest difference of the boxes of equal rings, on every side. Higher: all offsets are equal, and pockets
    #: become profiles.
    RING = 0.05
    #: share of the ring's size. Additional difference that is allowed for large rings. 1: all offsets are equal rings.
    RING_OF_SIZE = 0.002
    #: share of the reach. Upper limit for RING + RING_OF_SIZE, if larger than RING. Without a limit and without a tool,
    #: helices become profiles. 1: contours in real programs become mixed.
    RING_OF_REACH = 0.25
    #: share of the larger area. Rings with one box whose areas differ by more have different shapes. 0: the turns of a
    #: helix made of chords all differ, and the helix becomes a profile.
    AREA = 0.05
    #: mm. Largest difference of boxes and lengths of pieces with one footprint. Higher: the contours of a waterline
    #: count as repetitions.
    GROUND = 0.1


class NEGLIGIBLE:
    """Lengths that are too short to decide: links between passes, leads, remnants."""

    #: share of the length. Open strokes with less length in all are links between loops. Higher: bites become links.
    LINKS = 0.02
    #: share of the longest. Shorter rings and strokes are links and leads. Higher: the inner offsets of a pocket are
    #: ignored.
    PIECE = 0.02
    #: share of the usual pass. Shorter passes are links along the boundary. Higher: a raster of a triangle loses its
    #: rows.
    PASS = 0.1
    #: share of the length. Rows with less length are links. 1: rows cut one way become offsets.
    ROWS = 0.1
    #: share of the first family of rows. A second family needs more length. 1: grids become profiles.
    FAMILY = 0.1


class MAJORITY:
    """Minimum shares and counts."""

    #: share. A property of more than this share of the length is a property of the whole (the only majority threshold).
    SHARE = 0.5
    #: count. Fewer repetitions are chance: rows that share an area with loops, trochoids, bites, arcs, lines of a grid,
    #: equal steps. 1: open profiles become zigzags. Higher: trochoids become profiles.
    REPETITIONS = 5


class ENTRY:
    """How a depth is entered."""

    #: turns. A ramp that winds more is a helix. 0: every ramp is a helix. Higher: helices of one turn become ramps.
    WINDS = 0.75
    #: cosine. A ramp that reverses by at least this cosine comes back on the level lead-in before it. 1: no ramp comes
    #: back. 0: a ramp around a corner comes back, too, if it ends where the lead-in began.
    BACK = 0.95
    #: share of its size. The path behind an entry leads farther by this share, otherwise the descent is part of the
    #: pattern. 0: helices that end with a flat turn become profiles. Higher: helices before clearing become the
    #: operation.
    LEADS = 0.25
    #: share of a piece. The height of a piece is where at least this share of it is level; the rest are ramps and tags.
    #: Lower: rows on surfaces lie at plateaus. 1: ramped contours have no height. No verdict depends on it.
    LEVEL = 0.75
    #: share of a piece. Minimum level share of each depth of a piece with several depths. 0: every plateau is a depth.
    #: 1: rows with ramps to several depths in one stroke have no depth.
    ONE_OF_SEVERAL = 0.3


class PIECES:
    """Measuring pieces."""

    #: moves. If no piece has more moves, boxes are measured move by move, because starting a piece takes numpy as long
    #: as this number of moves. 0: squares take longer. Higher: no gain. No result depends on it.
    FEW = 8


class PASSES:
    """Back and forth, or around."""

    #: cosine. A move that is this parallel to the axis of its stretch is part of a pass. 0: links are passes, and the
    #: profile of a comb becomes a zigzag. 1: ramps cut back and forth become strokes.
    ALONG = 0.9
    #: count. A stretch with at most this number of passes may be a letter, such as N, W and Z, whose strokes are
    #: slanted. 0: engraved names become zigzags.
    OF_A_LETTER = 4
    #: cosine. A stretch of at most OF_A_LETTER passes counts as rows only if its passes are this parallel to the axis.
    #: 0: every short stretch counts. 1: none does, and ramps cut back and forth become letters.
    PARALLEL = 0.99
    #: share of the length of the passes. Minimum share that is parallel by PARALLEL. 0: a letter with one upright
    #: stroke becomes a zigzag. 1: rows whose links run along them become letters.
    SHARE = 0.8
    #: share of the length. A stretch goes back and forth if a larger share lies between alternating half-turns. 1:
    #: zigzags with a piece of the boundary become mixed.
    ALTERNATING = 0.3
    #: ratio. Minimum ratio of the length between alternating half-turns to the length between other half-turns. Lower:
    #: grids become mixed.
    MORE = 2
    #: share of the length. ALTERNATING for closed loops. 0: the finishing pass of a pocket becomes a zigzag. 1: zigzags
    #: that end at their start become loops.
    ALTERNATING_LOOP = 0.55


class WINDINGS:
    """Stretches that go around several times without closing."""

    #: turns. A stretch with a larger net turn is a winding. Lower: letters become windings. Without a limit, spirals
    #: become profiles.
    TURN = 1.2
    #: turns. The rest of a winding after its last full turn counts as a ring only if it turns more. 0: round pockets
    #: cut in a spiral of few turns become adaptive. 1: nothing in windings moves along.
    LAST_TURN = 0.75
    #: share of the step. Turns whose distances differ by less are evenly spaced, as in a spiral; constant engagement
    #: needs growing steps. 0: spirals with a helical entry become adaptive. Higher: adaptive clearing of round pockets
    #: becomes a spiral.
    EQUAL = 0.05
    #: turns. A winding whose turns against its sense add up to more is wavy, and a stroke is then not a bite. 0:
    #: smoothly linked offsets and sampled spirals become profiles.
    WAVY_TURN = 0.5
    #: turns. A winding whose turns against its sense add up to more may be passes of a lattice. Higher: grids become
    #: mixed.
    LATTICE_TURN = 0.75
    #: turns. A single turn against the sense by more is a step aside to the next loop. Higher: smoothly linked offsets
    #: become spirals. 0: spirals in real programs become linked offsets.
    STEP_ASIDE = 0.075
    #: rad mm. Bends with a smaller product of angle and length may come from rounding to 0.01 mm. 0: smoothly linked
    #: offsets become adaptive. Higher: they become spirals.
    ROUGH = 0.05
    #: places. Minimum number of corrections of the direction in one turn of adaptive clearing, which keeps its
    #: engagement constant. Lower: smoothly linked offsets become adaptive. Higher: adaptive clearing of FreeCAD becomes
    #: a pocket.
    CORRECTIONS = 8
    #: rad. Largest correction, 10 degrees. Higher: links to the next loop count as corrections.
    CORRECTION = 0.17453292519943295
    #: rad. Larger turns are corners, 30 degrees. 0: spirals consist of corners and become contour-parallel. pi: spirals
    #: with straight sides become spirals.
    CORNER = 0.5235987755982988


class SPURS:
    """Detours out and back on the same line."""

    #: share of the area's length. Spurs with less length in all are reliefs in corners. 0: contours with such corners
    #: become adaptive. 1: passes that are cut twice are lost.
    LENGTH = 0.2


class TAGS:
    """Contours lifted over holding tags."""

    #: cosine. A contour continues behind a gap if its direction agrees by this cosine. 1: circles with tags become
    #: strokes. 0: strokes around a corner continue, too, if all strokes together close a contour.
    AHEAD = 0.9


class STROKES:
    """Open pieces that neither wind nor go back and forth."""

    #: share of the strokes. If a smaller share has different footprints, the strokes are contours repeated at other
    #: depths. 0: such contours in real programs become engravings.
    DISTINCT = 0.67
    #: share of width and height of the part together. If the usual stroke is longer, strokes are contours. 0: carved
    #: strokes become contours. Higher: the outlines that adaptive clearing leaves on thin stock become engravings.
    LONG = 0.35
    #: share of the length. Strokes that climb to their ends over a larger share are carved by a V-bit, which rises in
    #: corners. 0: contours with a ramp at the end are carved. 1: long carved strokes become contours.
    RISING = 0.05


class LETTERS:
    """Closed contours that are letters and not outlines of parts and holes."""

    #: mm. Contours whose boxes and lengths differ by more have different shapes.
    SHAPE = 0.2
    #: count. Minimum number of contours of different shapes that are letters. Fewer contours are outlines of parts.
    COUNT = 8
    #: depths. Largest number of depths of engraved letters. Higher: pockets and parts of many shapes in real programs
    #: become letters.
    DEPTHS = 3
    #: share of the ground. Largest usual size of letters. 1: the contours of plates become letters.
    SMALL = 0.15


class NESTS:
    """Rings that lie inside one another."""

    #: mm. Minimum distance between neighbouring rings. Higher: no rings are neighbours, and pockets become profiles.
    APART = 0.01
    #: tool diameters. Largest distance of rings, rows and strokes without uncut ground between them. Lower: pockets
    #: become profiles. Higher: the contours of washers, and of chamfered and engraved edges, become pockets.
    REACH = 1.2
    #: count. Largest number of sides of their boxes that offsets share: a pocket in a corner of the part is open at two
    #: sides. 0: open pockets become profiles.
    SHARED = 2
    #: rings. Number of later rings that each ring is compared with. 1: pockets with islands, whose rings are cut in
    #: turn, become profiles. More rings take time without gain.
    NEXT = 3
    #: share of the mean. Largest deviation of the shifts of the four sides, for a wavy ring or one of the other sense.
    #: Higher: passes of a lattice that wind by chance are nested.
    EQUAL_SIDES = 0.1
    #: ratio to the distance. Largest difference in length between a ring and its inner offset; a circle has 6.3, a
    #: square 8, and more needs bays. Higher: engraved lines around a letter become its offset.
    LONGER = 12.0
    #: share of the longer loop. Minimum length of the shorter loop where bays close. 0: the lengths are not compared.
    #: 1: combs have no stepover.
    LENGTH_ALIKE = 0.6
    #: share of the distance. Minimum shift of each side of an offset's box. 0: ramped profiles become pockets. 1:
    #: waterlines become contour-parallel.
    SIDE_AT_LEAST = 0.5
    #: ratio to the distance. At least one side is shifted by no more than this. Lower: nothing is nested. Higher: grids
    #: are nested.
    SIDE_AT_MOST = 1.5
    #: share of the ring's size. Largest step between nested rings. 0: no rings are nested. Higher: contours of three
    #: sizes at different depths become a pocket.
    LARGEST_STEP = 0.3
    #: share of the step. Largest difference of equal steps. 0: no nest has three rings, and pockets without a tool
    #: become profiles.
    SIMILAR_STEP = 0.3
    #: share of the largest ring. Largest usual step without a tool. 0: pockets become profiles. Higher: waterlines
    #: become pockets.
    TOO_LARGE = 0.2
    #: share of the largest ring. Without a tool and with fewer than three rings, rings that are farther apart are
    #: separate contours. 0: narrow pockets around an island are separate contours. Higher: engraved contours become
    #: pockets.
    REACH_OF_SIZE = 0.05
    #: steps. Reach without a tool. 1: linked offsets and spirals lose every other ring.
    STEPS = 2


class RINGS:
    """Rings, and how many of them stand for the whole."""

    #: isoperimetric quotient 4 pi A / P^2. A ring with a larger quotient is a circle; a square has 0.79. Lower: ramped
    #: profiles become helices. 1: helices made of chords become profiles.
    ROUND = 0.93
    #: share of the drop. A ring descends steadily if its mean height is this close to the middle of its drop. 0: no
    #: helix descends steadily. Higher, with a tool: profiles with a ramp in their first moves become helices.
    STEADY = 0.2
    #: share of the rings' length. A smaller share of circles belongs to other contours. Lower: profiles with bores,
    #: ramped alike, become helices.
    ALL_ROUND = 0.85
    #: share of the zigzag's box. A loop surrounds a zigzag if no side lies farther inside. 0: contours beside a zigzag
    #: belong to it. 1: the small loops between its rows are contours.
    SURROUNDS = 0.15
    #: share of the length, and of the rings' length. Minimum share of rings, and of nested rings among them, for
    #: offsets. 0: clipped spirals become adaptive. 1: linked offsets become spirals.
    OFFSETS = 0.7
    #: share of the length. Rings, or rows, decide with this share if the other kind is hardly there. 0: strokes become
    #: zigzags. 1: waterlines and helices become profiles.
    ALONE = 0.35
    #: share of the length. A smaller share of rows beside rings is ignored. Higher: rows and their contour become a
    #: profile. 0: profiles in real programs become mixed.
    ROWS_BESIDE = 0.15
    #: share of the length. A smaller share of rings among rows is ignored. 0: every closed link of a zigzag is a
    #: contour.
    AMONG_ROWS = 0.1
    #: count. Number of the largest rings of a depth that may be the walls of its pockets. 1: pockets beside the largest
    #: one become mixed. More rings take longer.
    WALLS = 8
    #: share of the steps. If a larger share of steps goes inward, or outward, the nest has an order of cutting and
    #: mills climb or conventional. No verdict depends on it.
    ONE_WAY = 0.75


class WATERLINES:
    """Contours that change with the depth."""

    #: depths. Minimum number of depths of a waterline. Without it, waterlines become profiles.
    DEPTHS = 3
    #: tool diameters. Minimum depth of a waterline. 0: deburred edges become pockets. Higher: waterlines become
    #: profiles.
    RANGE = 0.35
    #: share of the rings' length. Minimum share with a ring of another shape below or above. 0: engraved contours
    #: count. 1: waterlines become profiles.
    DEEPER = 0.3
    #: ratio of spreads. If the spread of the steps in the plane is a smaller share of the spread in depth, the plane is
    #: divided evenly and not the depth, as for circles on a dome. 0: these become waterlines. Higher: waterlines become
    #: contour-parallel.
    EVENER = 0.5
    #: relative spread. Two spreads that are both smaller are equal up to rounding. 0: a waterline that is turned or
    #: scaled becomes contour-parallel.
    ROUNDING = 0.01
    #: depths. Minimum number of depths of open contours for a waterline. Lower: letters and open profiles become
    #: waterlines. Higher: waterlines cut open by the stock become engravings.
    OPEN_DEPTHS = 4
    #: share of the length. If a larger share of open contours is sloped, they are not a waterline. 0: no waterline is
    #: open. 1: V-carving in real programs becomes a waterline.
    SLOPED = 0.2


class TROCHOIDS:
    """Loops of one size that move along."""

    #: share of the rings' length. Minimum share of loops that move along. 0: overlapping contours become trochoids.
    #: Higher: adaptive clearing without lifts becomes a profile.
    SHARE = 0.4
    #: share of the range. The sides of the boxes of trochoids move in both directions, by a mean below this. 0: there
    #: are no trochoids.
    SWAY = 0.35
    #: share of the smaller loop. Largest shift from loop to loop. 0: no loops move along, and trochoids become
    #: profiles.
    STEP = 1.2
    #: share of the larger loop. Minimum size of the smaller loop. 1: no two loops have one size.
    SIZE = 0.65


class ROWS:
    """Parallel passes side by side."""

    #: directions in half a turn. Number of directions for the search of the densest one. 1: grids have no axis.
    DIRECTIONS = 64
    #: values. Sample size for medians, and for the lines of a family. 1: zigzags become engravings. More values take
    #: time without gain.
    SAMPLE = 1000
    #: rad. Largest angle between a move of a row and the axis. 0: rows of sampled moves break up. Higher: bites become
    #: rows.
    ALIGNED = 0.05
    #: share of the length. If a smaller share keeps to the mean axis, there are several axes. 0: grids have one axis,
    #: between their directions.
    ONE_AXIS = 0.8
    #: share of the length. If a smaller share keeps to the axis, links have turned the axis, and it is computed again
    #: without them. 0: zigzags along a slanting boundary become profiles.
    ALL_ALIGNED = 0.98
    #: usual steps. Largest distance of neighbouring rows. Lower: no rows are neighbours, and rows cut one way become
    #: offsets.
    MAX_DISTANCE = 1.6
    #: usual steps. Minimum distance of evenly spaced rows. Higher: no steps are even, and rows cut one way become
    #: offsets.
    MIN_DISTANCE = 0.6
    #: share. The pitch is the shortest distance with this share of the most frequent distance's count. 1: twice the
    #: stepover may be chosen. 0: the next family may be chosen.
    PITCH_FREQUENCY = 0.8
    #: share of the pitch. Gaps that differ by less are equal. 0: zigzags that end at their start become walls. Higher:
    #: lattices with nearly even lines have half their stepover.
    SAME_GAP = 0.02
    #: lines. Largest number of lines in a period. 1: all lines are evenly spaced, and zigzags that end at their start
    #: become walls. Higher: no gain.
    MAX_PERIOD = 12
    #: pitches. Largest stepover; two families may nearly coincide. Lower: stepovers of lattices are wrong. Higher:
    #: distant pockets take memory.
    FARTHEST = 1000
    #: share of the length. Passes of which a smaller share has a neighbour are not rows. 0: adaptive clearing and
    #: waterlines have rows. 1: rows cut one way become offsets.
    WITH_NEIGHBOUR = 0.25
    #: steps. Minimum length of a row. 0: the sides of small contours are rows. Higher: grids become engravings.
    MIN_LENGTH = 2.5
    #: steps. Minimum length of many even rows. Higher: zigzags in narrow teeth become profiles.
    MIN_LENGTH_IF_MANY = 1.5
    #: lines. Number of rows that are many. Without it, zigzags in narrow teeth become profiles.
    MANY = 10
    #: share of the steps. Many rows are even if a larger share of their steps is. 1: zigzags in narrow teeth become
    #: profiles.
    EVEN = 0.8
    #: tool diameters. Fewer than MANY passes that are closer are one pass cut again. 0: ramped profiles with a tool
    #: become mixed.
    RETRACED = 0.03
    #: mm. Smallest distance of rows. Higher: zigzags with rows 0.001 mm apart become profiles. 0: the rounding
    #: of slanted lines divides rows that are interrupted by islands.
    FINEST = 5e-4
    #: pitches. Rows of a contour with a larger period are the walls of its teeth. Lower: zigzags that end at their
    #: start become profiles. Higher: combs become zigzags.
    WALLS = 1.05
    #: steps. Largest distance of rows, beyond the tool's reach, with later rows between them. 1: rows that are cut in
    #: two goes become engravings. Higher: passes along both sides of uncut ground become rows.
    LEFT_BETWEEN = 3
    #: share of the length. Two families of rows with a larger share are a grid. 0: waterlines and adaptive clearing
    #: become grids. 1: grids become engravings.
    GRID = 0.85
    #: count. Number of passes of each family that are tested for crossing. 1: grids become engravings. More passes take
    #: longer.
    CROSSING = 100
    #: share of its length. A crossing nearer to the end of a pass is a corner. 0: the sides of nested contours cross.
    #: 0.5: nothing crosses.
    END = 0.05


class ARCS:
    """Open strokes around one centre."""

    #: cosine. A move this perpendicular to the ray from the centre lies on a circle. 0: circles that the boundary cuts
    #: open become engravings. 1: open waterlines become spirals.
    SQUARE = 0.15
    #: share of the squared length. Moves with more similar directions have no centre. 0: division by zero for straight
    #: rows. 1: clipped circles have no centre.
    STRAIGHT_ROWS = 0.01
    #: share of the length. A stroke with a larger share on the circle is an arc. 0: open waterlines become spirals.
    ARC = 0.9
    #: steps. Radii that differ by more are different. 0: the outlines that adaptive clearing leaves on thin stock have
    #: many radii.
    RADIUS = 0.3
    #: steps. An arc whose radius changes by more in a turn is part of a spiral. 0: clipped circles are spirals. Higher:
    #: adaptive clearing from a centre becomes contour-parallel.
    DRIFT = 0.3


class NEIGHBOURS:
    """Open strokes side by side."""

    #: count. Number of points in which each stroke is compared. 2: all strokes are straight. More points take time
    #: without gain.
    POINTS = 12
    #: share of the points. Minimum share of a stroke's points beside its neighbour. 0: letters are neighbours.
    FACING = 0.6
    #: usual steps. Largest distance of a neighbour. 0: there are no neighbours.
    MAX_DISTANCE = 3
    #: share of the step. Largest variation of an offset's distance. 0: open offsets become adaptive. Higher: passes of
    #: adaptive clearing become offsets.
    EVEN = 0.3
    #: share of the length. Minimum share of strokes in the direction of their neighbours in adaptive clearing, which
    #: mills one way. Lower: offsets cut open by a side become adaptive in real programs.
    ONWARD = 0.9
    #: share of the length. Minimum share of strokes with neighbours that fill an area. 1: open strokes never fill an
    #: area. Lower: letters fill an area.
    SHARE = 0.7


class BITES:
    """Arcs that adaptive clearing cuts out of the stock one after the other."""

    #: turns. A stroke that bends more may be a bite. Higher: there are no bites, and adaptive clearing becomes a spiral
    #: or engraving.
    BENT = 0.25
    #: share of the smaller size. Largest distance between the middles of one bite and the next. 0: there are no bites.
    #: Higher: curls of a drawing, which overlap by chance, become adaptive.
    MOVED = 0.5
    #: share of the length. Minimum share of bites in adaptive clearing. 0: spirals and profiles in real programs become
    #: adaptive. 1: nothing is adaptive.
    SHARE = 0.1
    #: bites. Minimum number of bites in adaptive clearing. 1: V-carving and circles that are cut open become adaptive.
    #: Twice as many: small adaptive clearing becomes a spiral.
    COUNT = 10
    #: share of the bites. If a larger share bends the other way, the bites are letters. 1: letters become adaptive. 0:
    #: nothing is adaptive.
    AGAINST = 0.3


class ADAPTIVE:
    """Adaptive clearing against a spiral or a helix that clears a pocket."""

    #: share of the length. A winding with this share of bites clears corners. 1: such clearing, on parts cut by
    #: FreeCAD, becomes a spiral.
    BITES = 0.03
    #: share of the length. A winding with this share of a helix was entered by the helix. 1: adaptive clearing in real
    #: programs becomes a spiral.
    ENTRY = 0.005
    #: share of the length. A winding with this share of open strokes is not a spiral. 0: spirals become adaptive. 1:
    #: clearing with a third of open strokes becomes a spiral.
    STROKES = 0.3


class POCKET:
    """A ring whose inside is cleared by an open stroke: the narrowest pocket with a finishing pass."""

    #: share of the length. Minimum share of strokes inside rings that clear the rings. 0: engraved contours in real
    #: programs become mixed.
    FILLED = 0.1
    #: ratio. Largest ratio of the areas that strokes and ring enclose, each for its length. Higher: contours inside
    #: contours become mixed in real programs.
    WIDTH = 0.75


class PARTS:
    """Where a program is divided, and when the parts make it mixed."""

    #: borders. Largest number of borders; more are not operations, and each section takes time. 1: boards and programs
    #: are one operation.
    BORDERS = 200
    #: share of the areas. Fewer holes beside the milling are passes clipped to a point. 1: boards become profiles.
    DRILLED = 0.25
    #: count. Fewer plunges beside milling, without a canned cycle, park the tool or touch the stock. 1: a profile after
    #: which the tool is parked is mixed.
    HOLES = 2
    #: depths. More heights are heights of a surface. Lower: boards engraved at a few depths are surfaces.
    DEPTHS = 10
    #: depths. Plunges to at least this number of depths, all of them milled, are what is left of contours. 1: holes
    #: drilled as deep as a pocket are contours. Higher: waterlines on gentle slopes become mixed.
    LAYERS = 2
    #: share of the length. Different sections with a smaller share do not make a program mixed, unless another tool
    #: cuts them. 0: rasters on surfaces and circuits with a hole become mixed.
    ASIDE = 0.05
    #: share of the length. ASIDE for a section behind a certain border. 1: short zigzags before a profile are lost.
    CERTAIN = 0.001
    #: count. A section with fewer passes and without loops is too short to show a strategy. 0: rows and rings on
    #: surfaces become profiles.
    PASSES = 3
    #: count. Two strategies that alternate this often at doubtful retracts are one operation. 1: all pairs are one
    #: operation, also a pocket with another pattern behind it.
    TURNS = 3
    #: share of the size. Largest difference of the boxes of a cleared area and the contour that finishes its walls. 0:
    #: no contour finishes walls, and rows with a contour become mixed. Higher: nothing changes in real programs.
    AROUND = 0.05
    #: count. Largest number of nested loops that may be finishing passes of walls. 0: only loops that are not nested
    #: finish walls. Higher: pockets behind another clearing become its finishing pass.
    WALLS = 2


class VISITS:
    """Retracts that begin another operation; benchmarks/learn_borders.py learns the model."""

    #: share of the votes. A retract with a larger share begins another operation. 0: every visit is an operation, and
    #: pockets become mixed. 1: none is, and a zigzag with a profile behind it is one operation.
    BORDER = 0.3
    #: share of the votes. Between this share and BORDER, the verdicts before and after the retract count, too. 1: they
    #: never count, and a pocket with another pattern behind it is one operation.
    DOUBTFUL = 0.03
    #: ratio. Minimum product of two odds for another operation: of the votes, and of both verdicts being right if they
    #: differ. 0: every doubtful retract between different verdicts is a border, and pockets become mixed.
    DIFFER = 0.6
    #: share of the votes. With a larger share, a contour around a cleared area is another operation, too.
    SURE = 0.5
    #: visits. Number of previous visits that are compared for ground cut again. 1: only neighbours are compared. More
    #: visits gain little.
    EARLIER = 8
    #: visits. Largest number of sections; more are not operations, and each takes time. 1: most programs are one
    #: operation.
    MOST = 60
    #: count. How often sections are divided again. 0: operations between two tool changes are one if the tool is
    #: changed higher up. Higher: stairs of retracts take long.
    NESTED = 4
    #: share of the length. A block whose ends are closer is closed, for the measure.
    CLOSED = 0.03
    #: share of the size. Visits whose boxes differ by less on every side cover the same ground, for the measure.
    PLACE = 0.01
    #: share. Feeds that differ by less are equal, for the measure.
    FEED = 0.01
    #: mm. Minimum size, so that a hole has a size.
    SMALL = 0.05


class LATHE:
    """Toolpaths of a lathe in X and Z."""

    #: count. Minimum number of X positions of passes along Z. 1: a slot is turned.
    PASSES = 3
    #: ratio. Minimum ratio of the length along Z to the length along X. 0: a row of slots is turned. Higher: short
    #: bolts become profiles.
    LONGER = 1.5


class MEASURED:
    """Sample sizes and limits of the measures; the trees were learned with these."""

    #: moves. Sample size, evenly among all moves, for shares of the length.
    MOVES = 1000
    #: moves. Sample size, from the middle of the time, for sequences of turns.
    TURNS = 2000
    #: rad. Smaller turns are rounding.
    TURN = 1e-4
    #: turns. An area in which phi has a smaller range goes back and forth.
    HALF_TURN = 0.51
    #: turns. Range of the net turn, without the closing turn, of a closed area that goes around once: all turns except
    #: the last corner.
    ONE_TURN = (0.6, 1.3)
    #: share of the length. If V_k of the last trajectory is shorter, the area is closed, for the measure.
    CLOSED = 0.02
    #: turns. An arc of the Gauss map this close to a half turn is a half turn, as between alternating rows.
    HALF = 0.1
    #: turns. A shorter arc is a bend.
    SHORT = 0.3
    #: turns. A longer arc goes around.
    LONG = 0.75
    #: count. Number of classes of turns, from none to an exact reversal.
    TURNS_BY = 12
    #: rings. Sample size for shares of rings.
    RINGS = 500
    #: ratio. Upper limit of the evenness of rings in the plane.
    EVENNESS = 1000


class SCAN:
    """Scan lines across a section; the trees were learned with these."""

    #: lines. Number of scan lines.
    LINES = 12
    #: share of the length. Share outside all lines on either side, for leads and remnants.
    EDGE = 0.04
    #: places. Largest number of crossings that are used.
    ENOUGH = 1200
    #: ratio. Minimum sine of the angle between a move and a line; at a smaller angle the move lies along the line.
    GRAZING = 0.3
    #: mm. Crossings whose heights differ by less have one depth.
    DEPTH = 0.05
    #: ratio. Neighbours with a smaller sine of the angle between them are parallel.
    PARALLEL = 0.35
    #: ratio. Distances whose logarithms differ by less are equal in the search for the usual distance.
    BIN = 0.2
    #: share of the usual distance. Neighbours whose distance differs by less are at the usual distance.
    EVEN = 0.3


class VOTES:
    """How the votes of the learned trees make a verdict, and its confidence."""

    #: share of the votes. With a larger share for nonsense, a section is unknown. 1: random walks are machining. 0.5:
    #: outlines of snowflakes are nonsense. 0: engravings are nonsense.
    NONSENSE = 0.6
    #: share of the votes. Smallest share in the odds of a verdict. 0: the odds of all votes, and of none, are infinite.
    MIN_SHARE = 0.01
    #: confidence. Upper limit: one in a hundred of the surest verdicts on unseen programs is wrong.
    SUREST = 0.99
