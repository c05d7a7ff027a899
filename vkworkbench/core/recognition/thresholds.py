# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define every threshold of the recogniser, with its unit and with what goes wrong at higher and lower values.

Each idea has one threshold, which is used everywhere. A comment begins with the unit, up to the first full stop. "X
becomes Y" means that the rules propose the strategy Y for toolpaths of the strategy X. The toolpaths are synthetic, or
operations made by FreeCAD with a known tool (benchmarks/make_operations.py). "In real programs" means programs that
were not used to write the rules. `benchmarks/thresholds.py --rules OPERATIONS.jsonl.gz` changes each threshold and
prints which proposals change. Without --rules, the command prints which final verdicts change. The final verdicts
depend mostly on the learned trees.
"""


class ROUNDING:
    """Differences between equal lengths, places or areas, caused by rounding and sampling."""

    #: mm. Largest difference between two heights at one depth. With a higher value, all turns of a helix are at one
    #: depth, and the helix becomes a profile.
    HEIGHT = 0.02
    #: mm. Largest distance between lines, or between sides of boxes, that count as one line. With a higher value, all
    #: rows are on one line, and zigzags become engravings. With 0, some zigzags with rounded rows also become
    #: engravings.
    PLACE = 0.02
    #: mm. Largest difference between the boxes of equal rings, on every side. With a higher value, all offsets are
    #: equal rings, and pockets become profiles.
    RING = 0.05
    #: share of the ring's size. Additional difference that is allowed for large rings. With 1, all offsets are equal
    #: rings.
    RING_OF_SIZE = 0.002
    #: share of the reach. Upper bound for the sum of RING and RING_OF_SIZE; the bound is at least RING. Without this
    #: bound and without a tool, helices become profiles. With 1, contours in real programs become mixed.
    RING_OF_REACH = 0.25
    #: share of the larger area. Rings with one box whose areas differ by more than this share have different shapes.
    #: With 0, the turns of a helix made of chords all have different shapes, and the helix becomes a profile.
    AREA = 0.05
    #: mm. Largest difference between the boxes, and between the lengths, of pieces with one footprint. With a higher
    #: value, the contours of a waterline count as repetitions of one contour.
    GROUND = 0.1


class NEGLIGIBLE:
    """Lengths that are too short to show a strategy, such as links between passes, leads and remnants."""

    #: share of the length. If the open strokes have less than this share in total, they are links between loops. With a
    #: higher value, bites count as links.
    LINKS = 0.02
    #: share of the longest. Rings and strokes that are shorter than this share of the longest one are links and leads.
    #: With a higher value, the inner offsets of a pocket are ignored.
    PIECE = 0.02
    #: share of the usual pass. Passes that are shorter than this share are links along the boundary. With a higher
    #: value, a raster of a triangle loses its rows.
    PASS = 0.1
    #: share of the length. Rows with less than this share in total are links. With 1, rows cut one way become offsets.
    ROWS = 0.1
    #: share of the first family of rows. A second family of rows with less length is ignored. With 1, grids become
    #: profiles.
    FAMILY = 0.1


class MAJORITY:
    """Minimum shares and counts."""

    #: share. A property of more than this share of the length is a property of the whole (the only majority threshold).
    SHARE = 0.5
    #: count. Minimum number of trochoids, bites, concentric arcs, lines of a grid, neighbouring strokes, or rows beside
    #: loops. A smaller number can be chance. With 1, open profiles become zigzags. With a higher value, trochoids
    #: become profiles.
    REPETITIONS = 5


class ENTRY:
    """How a depth is entered."""

    #: turns. A ramp that winds by more than this is a helix. With 0, every ramp is a helix. With a higher value,
    #: helices of one turn become ramps.
    WINDS = 0.75
    #: cosine. A ramp returns along the level lead-in before it if the cosine of their reversal is at least this value.
    #: With 1, no ramp returns. With 0, a ramp around a corner also counts as returning if it ends where the lead-in
    #: began.
    BACK = 0.95
    #: share of its size. The path after an entry must extend beyond the entry's box by more than this share; otherwise
    #: the descent is part of the pattern. With 0, helices that end with a level turn become profiles. With a higher
    #: value, helices that enter a clearing become the operation.
    LEADS = 0.25
    #: share of a piece. A piece has a height if at least this share of it is level; the rest is ramps and tags. With a
    #: lower value, plateaus of rows on surfaces count as heights. With 1, ramped contours have no height. No verdict
    #: depends on this threshold.
    LEVEL = 0.75
    #: share of a piece. Minimum share that is level at each depth, for a piece with several depths. With 0, every
    #: plateau is a depth. With 1, rows with ramps to several depths in one stroke have no depth.
    ONE_OF_SEVERAL = 0.3


class PIECES:
    """How pieces are measured."""

    #: moves. Boxes are measured move by move if no piece has more moves than this, because numpy's overhead for each
    #: piece is about the time for this number of moves. With 0, measuring squares takes longer. A higher value gains
    #: nothing. No result depends on this threshold.
    FEW = 8


class PASSES:
    """Whether passes go back and forth or around a contour."""

    #: cosine. A move is part of a pass if the cosine of its angle to the axis of its stretch is larger than this value.
    #: With 0, links are passes, and the profile of a comb becomes a zigzag. With 1, ramps cut back and forth become
    #: strokes.
    ALONG = 0.9
    #: count. A stretch with at most this number of passes is possibly a letter with slanted strokes, such as N, W or Z.
    #: With 0, engraved names become zigzags.
    OF_A_LETTER = 4
    #: cosine. A stretch of at most OF_A_LETTER passes counts as rows only if the cosine of the angle between its passes
    #: and the axis is larger than this value. With 0, every short stretch counts. With 1, no short stretch counts, and
    #: ramps cut back and forth become letters.
    PARALLEL = 0.99
    #: share of the length of the passes. Minimum share of a short stretch that is parallel to the axis according to
    #: PARALLEL. With 0, a letter with one upright stroke becomes a zigzag. With 1, rows whose links run along them
    #: become letters.
    SHARE = 0.8
    #: share of the length. A stretch goes back and forth if more than this share of its passes lies between half-turns
    #: of opposite sign. With 1, zigzags with a piece of the boundary become mixed.
    ALTERNATING = 0.3
    #: ratio. Minimum ratio between the length of passes between half-turns of opposite sign and the length of passes
    #: between half-turns of equal sign. With a lower value, grids become mixed.
    MORE = 2
    #: share of the length. The same minimum share as ALTERNATING, for closed loops. With 0, the finishing pass of a
    #: pocket becomes a zigzag. With 1, zigzags that end at their start become loops.
    ALTERNATING_LOOP = 0.55


class WINDINGS:
    """Stretches that go around several times without closing."""

    #: turns. A stretch with a net turn of more than this is a winding. With a lower value, letters become windings.
    #: Without a limit, spirals become profiles.
    TURN = 1.2
    #: turns. The rest of a winding after its last full turn counts as a full turn if it turns by more than this. With
    #: 0, round pockets cut in a spiral of few turns become adaptive. With 1, no turns of windings count as trochoids.
    LAST_TURN = 0.75
    #: share of the step. Turns whose distances differ by less than this share are evenly spaced, as in a spiral.
    #: Constant engagement needs growing steps instead. With 0, spirals with a helical entry become adaptive. With a
    #: higher value, adaptive clearing of round pockets becomes a spiral.
    EQUAL = 0.05
    #: turns. A winding is wavy if its turns against its sense add up to more than this. A stroke is not a bite if its
    #: turns against its sense add up to more than this. With 0, smoothly linked offsets and sampled spirals become
    #: profiles.
    WAVY_TURN = 0.5
    #: turns. A winding is possibly the passes of a lattice if its turns against its sense add up to more than this.
    #: With a higher value, grids become mixed.
    LATTICE_TURN = 0.75
    #: turns. A ring steps aside to the next loop if its turns against the sense of its winding add up to more than
    #: this. With a higher value, smoothly linked offsets become spirals. With 0, spirals in real programs become linked
    #: offsets.
    STEP_ASIDE = 0.075
    #: rad mm. Bends are ignored if the product of angle and length is smaller than this value, because rounding to 0.01
    #: mm can cause them. With 0, smoothly linked offsets become adaptive. With a higher value, smoothly linked offsets
    #: become spirals.
    ROUGH = 0.05
    #: places. Minimum number of corrections of the direction in each turn of adaptive clearing, which corrects its
    #: direction to keep the engagement constant. With a lower value, smoothly linked offsets become adaptive. With a
    #: higher value, adaptive clearing by FreeCAD becomes contour-parallel.
    CORRECTIONS = 8
    #: rad. Largest mean correction of the direction in adaptive clearing, 10 degrees. With a higher value, links to the
    #: next loop count as corrections.
    CORRECTION = 0.17453292519943295
    #: rad. Turns by more than this angle, 30 degrees, are corners. With 0, spirals consist only of corners and become
    #: contour-parallel. With pi, polygonal windings become spirals.
    CORNER = 0.5235987755982988


class SPURS:
    """Spurs: moves out and back on the same line."""

    #: share of the area's length. Spurs with less than this share in total are reliefs in corners and are removed. With
    #: 0, contours with such corners become adaptive. With 1, passes that are cut twice are lost.
    LENGTH = 0.2


class TAGS:
    """Contours that the tool cuts with lifts over holding tags."""

    #: cosine. A contour continues after a gap if the cosine of the angle between its direction and the gap is larger
    #: than this value. With 1, circles with tags become strokes. With 0, strokes around a corner also continue one
    #: another if all strokes together close a contour.
    AHEAD = 0.9


class STROKES:
    """Strokes: open pieces that neither wind nor go back and forth."""

    #: share of the strokes. If the number of different footprints is less than this share of the number of strokes, the
    #: strokes are contours repeated at other depths. With 0, repeated contours in real programs become engravings.
    DISTINCT = 0.67
    #: share of the part's width plus height. If the usual stroke is longer than this share, the strokes are contours.
    #: With 0, carved strokes become contours. With a higher value, the outlines that adaptive clearing leaves on thin
    #: stock become engravings.
    LONG = 0.35
    #: share of the length. Strokes are carved by a V-bit, which rises in corners, if they climb to their ends over more
    #: than this share. With 0, contours with a ramp at the end count as carved. With 1, long V-carved strokes become
    #: contours.
    RISING = 0.05


class LETTERS:
    """Closed contours that are letters and not outlines of parts and holes."""

    #: mm. Contours have different shapes if their boxes or lengths differ by more than about this.
    SHAPE = 0.2
    #: count. Minimum number of different shapes among contours that are letters. Contours with fewer shapes are
    #: outlines of parts.
    COUNT = 8
    #: depths. Largest number of depths of engraved letters. With a higher value, pockets and parts of many shapes in
    #: real programs become letters.
    DEPTHS = 3
    #: share of the ground. Contours are letters only if their median size is smaller than this share of the whole. With
    #: 1, the contours of plates become letters.
    SMALL = 0.15


class NESTS:
    """Rings that lie inside one another."""

    #: mm. Minimum distance between neighbouring rings. With a higher value, no rings are nested, and pockets become
    #: profiles.
    APART = 0.01
    #: tool diameters. Largest distance between rings, rows or strokes that leave no uncut ground between them. With a
    #: lower value, pockets become profiles. With a higher value, the contours of washers, and of chamfered and engraved
    #: edges, become pockets.
    REACH = 1.2
    #: count. Largest number of sides that the boxes of two offsets have in common, because a pocket in a corner of the
    #: part is open at two sides. With 0, open pockets become profiles.
    SHARED = 2
    #: rings. Number of later rings that each ring is compared with. With 1, pockets with islands become profiles if
    #: rings of boundary and island are cut alternately. Comparing more rings takes time without gain.
    NEXT = 3
    #: share of the mean. Largest difference between the shifts of the four sides that count as equal, for wavy rings
    #: and for rings of opposite sense. With a higher value, passes of a lattice that wind by chance are nested.
    EQUAL_SIDES = 0.1
    #: ratio to the distance. Largest ratio of the difference in length between a ring and its inner offset to their
    #: distance. The ratio is 6.3 for circles and 8 for squares, and larger only with bays. With a higher value,
    #: engraved lines around a letter become its offset.
    LONGER = 12.0
    #: share of the longer loop. Minimum length of the shorter loop if bays close between two offsets. With 0, the
    #: lengths are not compared. With 1, pockets shaped like combs have no stepover.
    LENGTH_ALIKE = 0.6
    #: share of the distance. Minimum shift of each side of an offset's box. With 0, ramped profiles become pockets.
    #: With 1, waterlines become contour-parallel.
    SIDE_AT_LEAST = 0.5
    #: ratio to the distance. Upper bound for the smallest shift of a side of an offset's box. With a lower value, no
    #: rings are nested. With a higher value, grids are nested rings.
    SIDE_AT_MOST = 1.5
    #: share of the ring's size. Largest step between two nested rings. With 0, no rings are nested. With a higher
    #: value, contours of three sizes at different depths become a pocket.
    LARGEST_STEP = 0.3
    #: share of the step. Largest difference between two steps that count as equal. With 0, no three rings are nested
    #: with equal steps, and pockets without a tool become profiles.
    SIMILAR_STEP = 0.3
    #: share of the largest ring. Largest usual step in a nest if the tool is unknown. With 0, pockets become profiles.
    #: With a higher value, waterlines become pockets.
    TOO_LARGE = 0.2
    #: share of the largest ring. If the tool is unknown and there are fewer than three nested rings, rings at a
    #: distance of more than this share are separate contours. With 0, narrow pockets around an island are separate
    #: contours. With a higher value, engraved contours become pockets.
    REACH_OF_SIZE = 0.05
    #: steps. Largest distance between rings of one nest if the tool is unknown. With 1, linked offsets and spirals lose
    #: every other ring.
    STEPS = 2


class RINGS:
    """Shapes of rings, and the shares of rings that decide the strategy."""

    #: isoperimetric quotient 4 pi A / P^2. A ring is a circle if its quotient is larger than this value; the quotient
    #: of a square is 0.79. With a lower value, ramped profiles become helices. With 1, helices that are made of chords
    #: become profiles.
    ROUND = 0.93
    #: share of the drop. A ring descends steadily if its mean height differs from the middle of its drop by less than
    #: this share. With 0, no helix descends steadily. With a higher value and a tool, profiles with a ramp in their
    #: first moves become helices.
    STEADY = 0.2
    #: share of the rings' length. Rings are a helix only if circles have more than this share. With a lower value,
    #: profiles with bores become helices if both are ramped.
    ALL_ROUND = 0.85
    #: share of the zigzag's box. A loop surrounds a zigzag if no side of the loop's box lies farther inside the
    #: zigzag's box than this share. With 0, contours near a zigzag count as parts of the zigzag. With 1, the small
    #: loops between the rows of a zigzag count as contours.
    SURROUNDS = 0.15
    #: share of the length, and of the rings' length. Rings decide the strategy as offsets if rings have more than this
    #: share of the length, and nested rings more than this share of the rings. With 0, clipped spirals become adaptive.
    #: With 1, linked offsets become spirals.
    OFFSETS = 0.7
    #: share of the length. Rings with more than this share decide the strategy if there are hardly any rows; rows with
    #: at least this share decide if there are hardly any rings. With 0, strokes become zigzags. With 1, waterlines and
    #: helices become profiles.
    ALONE = 0.35
    #: share of the length. Rows with less than this share are ignored beside rings. With a higher value, rows with a
    #: contour around them become a profile. With 0, profiles in real programs become mixed.
    ROWS_BESIDE = 0.15
    #: share of the length. Rings with less than this share are ignored beside rows. With 0, every closed link of a
    #: zigzag counts as a contour.
    AMONG_ROWS = 0.1
    #: count. Number of the largest rings at each depth that are compared with the rows as walls of pockets. With 1,
    #: pockets beside the largest one become mixed. Comparing more rings takes longer.
    WALLS = 8
    #: share of the steps. A nest is cut from inside to outside, or from outside to inside, if more than this share of
    #: its steps has this direction. Only then is climb or conventional milling reported. No verdict depends on this
    #: threshold.
    ONE_WAY = 0.75


class WATERLINES:
    """Waterlines: contours whose shape changes with the depth."""

    #: depths. Minimum number of depths of a waterline. With a much higher value, waterlines become profiles.
    DEPTHS = 3
    #: tool diameters. Minimum height difference between the deepest and the highest ring of a waterline. With 0,
    #: deburred edges become pockets. With a higher value, waterlines become profiles.
    RANGE = 0.35
    #: share of the rings' length. Minimum share of rings that have a ring of another shape below or above. With 0,
    #: engraved contours become waterlines. With 1, waterlines become profiles.
    DEEPER = 0.3
    #: ratio of spreads. If the spread of the steps in the plane divided by the spread of the steps in depth is smaller
    #: than this value, the rings are evenly spaced in the plane and not in depth, like circles on a dome. With 0,
    #: circles on a dome become waterlines. With a higher value, waterlines become contour-parallel.
    EVENER = 0.5
    #: relative spread. Value that is added to both relative spreads, because smaller spreads are rounding. With 0, a
    #: waterline that is rotated or scaled becomes contour-parallel.
    ROUNDING = 0.01
    #: depths. Minimum number of depths of open contours for a waterline. With a lower value, letters and open profiles
    #: become waterlines. With a higher value, waterlines cut open by the stock become engravings.
    OPEN_DEPTHS = 4
    #: share of the length. Open contours are not a waterline if sloped strokes have more than this share. With 0, no
    #: open contours are a waterline. With 1, V-carving in real programs becomes a waterline.
    SLOPED = 0.2


class TROCHOIDS:
    """Trochoids: loops of one size that advance along a path."""

    #: share of the rings' length. Minimum share of loops that advance along a path. With 0, overlapping contours become
    #: trochoids. With a higher value, adaptive clearing without lifts becomes a profile.
    SHARE = 0.4
    #: share of the range. From one trochoid to the next, the sides of the box shift inwards and outwards. The mean
    #: shift must be less than this share of the range of the shifts. With 0, no loops are trochoids.
    SWAY = 0.35
    #: share of the smaller loop. Upper bound for the range of the sides' shifts from loop to loop. With 0, no loops
    #: advance, and trochoids become profiles.
    STEP = 1.2
    #: share of the larger loop. Minimum size of the smaller of two trochoids. With 1, no two loops have the same size.
    SIZE = 0.65


class ROWS:
    """Parallel passes side by side."""

    #: directions in half a turn. Number of classes of directions in the search for the densest direction. With 1, grids
    #: have no axis.
    DIRECTIONS = 64
    #: values. Sample size for medians, and for the lines of a family. With 1, zigzags become engravings. A larger
    #: sample takes time without gain.
    SAMPLE = 1000
    #: rad. Largest angle between the moves of a row and the axis of the rows. With 0, rows of sampled moves break up.
    #: With a higher value, bites become rows.
    ALIGNED = 0.05
    #: share of the length. If less than this share is parallel to the mean axis, there are several axes. With 0, a grid
    #: has a single axis, between its two directions.
    ONE_AXIS = 0.8
    #: share of the length. If less than this share is parallel to the axis, links have rotated the axis, and the axis
    #: is computed again without the links. With 0, zigzags along a slanting boundary become profiles.
    ALL_ALIGNED = 0.98
    #: usual steps. Largest distance between neighbouring rows. With a lower value, no rows are neighbours, and rows cut
    #: one way become offsets.
    MAX_DISTANCE = 1.6
    #: usual steps. Minimum distance between evenly spaced rows. With a higher value, no steps are even, and rows cut
    #: one way become offsets.
    MIN_DISTANCE = 0.6
    #: share. The period is the shortest distance between lines whose frequency is more than this share of the largest
    #: frequency. With 1, twice the period is sometimes chosen. With 0, a distance that occurs by chance is chosen.
    PITCH_FREQUENCY = 0.8
    #: share of the pitch. Gaps are equal if they differ by less than this share. With 0, zigzags that end at their
    #: start count as walls of teeth. With a higher value, lattices with nearly even lines are given half their
    #: stepover.
    SAME_GAP = 0.02
    #: lines. Largest number of lines in a period. With 1, all lines are evenly spaced, and zigzags that end at their
    #: start count as walls of teeth. A higher value gains nothing.
    MAX_PERIOD = 12
    #: pitches. Largest distance between lines in the search for the period. The pitch is tiny if two sets of lines
    #: nearly coincide. With a lower value, the stepovers of lattices are wrong. With a higher value, distances between
    #: distant pockets take memory.
    FARTHEST = 1000
    #: share of the length. Passes are not rows if passes with a neighbour have less than this share. With 0, adaptive
    #: clearing and waterlines have rows. With 1, rows cut one way become offsets.
    WITH_NEIGHBOUR = 0.25
    #: steps. Minimum length of a row. With 0, the sides of small contours count as rows. With a higher value, grids
    #: become engravings.
    MIN_LENGTH = 2.5
    #: steps. Minimum length of a row if there are many evenly spaced rows. With a higher value, zigzags in narrow teeth
    #: become profiles.
    MIN_LENGTH_IF_MANY = 1.5
    #: lines. Minimum number of rows that counts as many rows. With a much higher value, zigzags in narrow teeth become
    #: profiles.
    MANY = 10
    #: share of the steps. Many rows are evenly spaced if more than this share of the steps is close to the usual step.
    #: With 1, zigzags in narrow teeth become profiles.
    EVEN = 0.8
    #: tool diameters. Fewer than MANY passes at a smaller distance are repetitions of one pass. With 0, ramped profiles
    #: become mixed if the tool is known.
    RETRACED = 0.03
    #: mm. Smallest distance between rows. With a higher value, zigzags with rows 0.001 mm apart become profiles. With
    #: 0, rounding of slanted lines divides a row that is interrupted by islands into several rows.
    FINEST = 5e-4
    #: pitches. If the period of a closed contour's passes is larger than this value, the passes are the walls of teeth.
    #: With a lower value, zigzags that end at their start become profiles. With a higher value, combs become zigzags.
    WALLS = 1.05
    #: steps. Largest distance, in periods, between consecutive rows that are farther apart than the tool's reach,
    #: because rows cut later lie between them. With 1, rows that are cut in two rounds become engravings. With a higher
    #: value, passes along both sides of uncut ground become rows.
    LEFT_BETWEEN = 3
    #: share of the length. Two families of rows are a grid if their share is larger than this value. With 0, waterlines
    #: and adaptive clearing become grids. With 1, grids become engravings.
    GRID = 0.85
    #: count. Number of passes of each family that are tested for crossing. With 1, grids become engravings. Testing
    #: more passes takes longer.
    CROSSING = 100
    #: share of its length. A crossing that is nearer to the end of a pass than this share is a corner. With 0, the
    #: sides of nested contours count as crossing. With 0.5, no passes cross.
    END = 0.05


class ARCS:
    """Open strokes around one centre."""

    #: cosine. A move lies on a circle if the cosine of its angle to the ray from the centre is smaller than this value.
    #: With 0, circles that the boundary cuts open become engravings. With 1, open waterlines become spirals.
    SQUARE = 0.15
    #: share of the squared length. Moves have no common centre if the determinant of their directions is smaller than
    #: this value. With 0, straight rows cause a division by zero. With 1, circles that the boundary cuts open have no
    #: centre.
    STRAIGHT_ROWS = 0.01
    #: share of the length. A stroke is an arc if more than this share of it lies on a circle around the centre. With 0,
    #: open waterlines become spirals.
    ARC = 0.9
    #: steps. Radii are different if they differ by more than this. With 0, the outlines that adaptive clearing leaves
    #: on thin stock count as arcs with many radii.
    RADIUS = 0.3
    #: steps. An arc is part of a spiral if its radius changes by more than this in one turn. With 0, circles that the
    #: boundary cuts open become spirals. With a higher value, adaptive clearing from a centre becomes contour-parallel.
    DRIFT = 0.3


class NEIGHBOURS:
    """Open strokes side by side."""

    #: count. Number of points on each stroke in the comparison with other strokes. With 2, all strokes count as
    #: straight. More points take time without gain.
    POINTS = 12
    #: share of the points. Minimum share of a stroke's points from which the perpendicular meets the neighbour. With 0,
    #: letters become neighbours.
    FACING = 0.6
    #: usual steps. Largest distance between neighbouring strokes. With 0, no strokes are neighbours.
    MAX_DISTANCE = 3
    #: share of the step. Largest variation of the distance between two offsets. With 0, open offsets become adaptive.
    #: With a higher value, passes of adaptive clearing become offsets.
    EVEN = 0.3
    #: share of the length. Minimum share of strokes in the direction of their neighbours in adaptive clearing, which
    #: always mills in one direction. With a lower value, offsets that a side of the part cuts open become adaptive in
    #: real programs.
    ONWARD = 0.9
    #: share of the length. Open strokes fill an area if strokes with neighbours have more than this share. With 1, open
    #: strokes never fill an area. With a lower value, letters count as filling an area.
    SHARE = 0.7


class BITES:
    """Arcs that adaptive clearing cuts out of the stock one after the other."""

    #: turns. Only a stroke that bends by more than this can be a bite. With a higher value, no strokes are bites, and
    #: adaptive clearing becomes a spiral or an engraving.
    BENT = 0.25
    #: share of the smaller size. Largest distance between the centres of consecutive bites. With 0, no strokes are
    #: bites. With a higher value, curls of a drawing that overlap by chance become adaptive.
    MOVED = 0.5
    #: share of the length. Minimum share of bites in adaptive clearing. With 0, spirals and profiles in real programs
    #: become adaptive. With 1, no toolpath is adaptive by its bites.
    SHARE = 0.1
    #: bites. Minimum number of bites in adaptive clearing. With 1, V-carving and circles that the boundary cuts open
    #: become adaptive. With twice the value, adaptive clearing of small pockets becomes a spiral.
    COUNT = 10
    #: share of the bites. Bites are letters if the strokes that bend in the opposite sense have more than this share.
    #: With 1, letters become adaptive. With 0, no toolpath is adaptive by its bites.
    AGAINST = 0.3


class ADAPTIVE:
    """Differences between adaptive clearing and a spiral or helix that clears a pocket."""

    #: share of the length. A winding with more than this share of bites beside it is adaptive clearing that also clears
    #: corners. With 1, adaptive clearing by FreeCAD becomes a spiral.
    BITES = 0.03
    #: share of the length. A winding that is entered by a helix with more than this share is adaptive clearing, unless
    #: its turns are evenly spaced circles. With 1, adaptive clearing in real programs becomes a spiral.
    ENTRY = 0.005
    #: share of the length. A winding with more than this share of open strokes beside it is not a spiral. With 0,
    #: spirals become adaptive. With 1, adaptive clearing that consists of open strokes to a third becomes a spiral.
    STROKES = 0.3


class POCKET:
    """Narrow pockets: an open stroke clears the inside of a ring, which is the finishing pass."""

    #: share of the length. Minimum share of the open strokes that clear the inside of rings. With 0, engraved contours
    #: in real programs become mixed.
    FILLED = 0.1
    #: ratio. Upper bound for the ratio of a stroke's enclosed area per length to the ring's enclosed area per length.
    #: With a higher value, contours inside contours become mixed in real programs.
    WIDTH = 0.75


class PARTS:
    """Borders between the parts of a program, and when different parts make the program mixed."""

    #: borders. Largest number of borders that divide a program. More borders do not separate operations, and
    #: recognising each section takes time. With 1, circuit boards and programs are one operation.
    BORDERS = 200
    #: share of the areas. If there are fewer holes than this share of the milled areas, the holes are passes clipped to
    #: a point. With 1, circuit boards become profiles.
    DRILLED = 0.25
    #: count. Fewer plunges than this number beside milling are not holes, unless a canned cycle drills them, because
    #: the tool is parked or touches the stock. With 1, a profile after which the tool is parked becomes mixed.
    HOLES = 2
    #: depths. A toolpath with more heights than this number cuts a surface. With a lower value, circuit boards engraved
    #: at a few depths count as surfaces.
    DEPTHS = 10
    #: depths. Plunges are contours clipped to a point if they reach at least this number of depths and all these depths
    #: are also milled. With 1, holes that are as deep as a pocket count as contours. With a higher value, waterlines on
    #: gentle slopes become mixed.
    LAYERS = 2
    #: share of the length. Sections of other operations do not make a program mixed if their total share is smaller
    #: than this value and they use the same tool. With 0, rasters on surfaces and circuits with a hole become mixed.
    ASIDE = 0.05
    #: share of the length. A single section of another operation after a certain border makes a program mixed if its
    #: share is larger than this value. With 1, short zigzags before a profile are ignored.
    CERTAIN = 0.001
    #: count. A section with fewer passes than this number and without loops is too short to show a strategy. With 0,
    #: rows and rings on surfaces become profiles.
    PASSES = 3
    #: count. Two strategies that alternate this often at doubtful retracts are one operation. With 1, any two
    #: strategies are one operation, such as a pocket followed by another pattern.
    TURNS = 3
    #: share of the size. Largest difference between the box of a cleared area and the box of the contour that finishes
    #: its walls. With 0, no contour finishes walls, and rows with a contour become mixed. With a higher value, nothing
    #: changes in real programs.
    AROUND = 0.05
    #: count. Largest number of nested loops that can be the finishing passes of walls. With 0, only loops that are not
    #: nested finish walls. With a higher value, a pocket that is cut after another clearing becomes the finishing pass
    #: of the clearing.
    WALLS = 2


class VISITS:
    """Retracts that begin another operation; benchmarks/learn_borders.py learns the model."""

    #: share of the votes. A retract with more than this share begins another operation. With 0, every visit is an
    #: operation, and pockets become mixed. With 1, no visit is an operation, and a zigzag followed by a profile is one
    #: operation.
    BORDER = 0.3
    #: share of the votes. If the share for a border is between this share and BORDER, the verdicts before and after the
    #: retract also count. With 1, the verdicts never count, and a pocket followed by another pattern is one operation.
    DOUBTFUL = 0.03
    #: ratio. A retract begins another operation if the product of two odds is larger than this value: the odds of the
    #: votes for a border, and the odds that two different verdicts are both right. With 0, every doubtful retract
    #: between different verdicts is a border, and pockets become mixed.
    DIFFER = 0.6
    #: share of the votes. With more than this share for a border, even a contour around a cleared area is another
    #: operation and not its finishing pass.
    SURE = 0.5
    #: visits. Number of previous visits that are compared for ground cut again. With 1, each visit is compared only
    #: with the visit before it. Comparing more visits gains little.
    EARLIER = 8
    #: visits. Largest number of borders at retracts. More borders do not separate operations, and each section takes
    #: time. With 1, most programs are one operation.
    MOST = 60
    #: count. Number of times that visits are divided again. With 0, all operations between two tool changes are one
    #: operation if the tool is changed at a greater height. With a higher value, programs with retracts to many heights
    #: take long.
    NESTED = 4
    #: share of the length. A block counts as closed in the measures of a visit if its ends are closer than this share.
    CLOSED = 0.03
    #: share of the size. Two visits cover the same ground in the measures if their boxes differ by less than this on
    #: every side.
    PLACE = 0.01
    #: share. Two feeds are equal in the measures of visits if they differ by less than this share of the higher feed.
    FEED = 0.01
    #: mm. Minimum size of a visit in the measures, so that a hole has a size.
    SMALL = 0.05


class LATHE:
    """Toolpaths of a lathe in X and Z."""

    #: count. Minimum number of X positions of passes along Z. With 1, a milled slot counts as turned.
    PASSES = 3
    #: ratio. Minimum ratio of the length cut along Z to the length cut along X. With 0, a row of milled slots counts as
    #: turned. With a higher value, short turned bolts become profiles.
    LONGER = 1.5


class MEASURED:
    """Sample sizes and limits of the measures. The trees were learned with these values."""

    #: moves. Sample size for shares of the length; the sample is spread evenly over all moves.
    MOVES = 1000
    #: moves. Sample size for sequences of turns; the sample is from the middle of the cutting order.
    TURNS = 2000
    #: rad. Turns by less than this angle are caused by rounding and are ignored.
    TURN = 1e-4
    #: turns. An area goes back and forth if the range of phi in the area is smaller than this.
    HALF_TURN = 0.51
    #: turns. Range of the net turn of a closed area that goes around once. The net turn does not include the turn at
    #: the last corner.
    ONE_TURN = (0.6, 1.3)
    #: share of the length. An area counts as closed in the measures if the distance from its start to its end is less
    #: than this share.
    CLOSED = 0.02
    #: turns. An arc of the Gauss map is a half turn, as between alternating rows, if it differs from a half turn by
    #: less than this.
    HALF = 0.1
    #: turns. An arc of the Gauss map that is shorter than this is only a bend.
    SHORT = 0.3
    #: turns. An arc of the Gauss map that is longer than this goes around a contour.
    LONG = 0.75
    #: count. Number of classes for the sizes of turns, from no turn to an exact reversal.
    TURNS_BY = 12
    #: rings. Sample size for the shares of kinds of rings.
    RINGS = 500
    #: ratio. Upper bound for the measured evenness of rings in the plane.
    EVENNESS = 1000


class SCAN:
    """Scan lines across a section. The trees were learned with these values."""

    #: lines. Number of scan lines across a section.
    LINES = 12
    #: share of the length. Share of the cutting length outside the scan lines on either side, where leads and remnants
    #: lie.
    EDGE = 0.04
    #: places. Number of crossings after which no further scan lines are used.
    ENOUGH = 1200
    #: ratio. Minimum sine of the angle between a move and a scan line. At a smaller angle the move lies along the line
    #: and is ignored.
    GRAZING = 0.3
    #: mm. Crossings whose heights differ by less than this are at one depth.
    DEPTH = 0.05
    #: ratio. Two neighbouring moves on a scan line are parallel if the sine of the angle between them is smaller than
    #: this value.
    PARALLEL = 0.35
    #: ratio. Width of the classes of logarithms in the search for the usual distance between passes.
    BIN = 0.2
    #: share of the usual distance. Two passes are at the usual distance if their distance differs from the usual
    #: distance by less than this.
    EVEN = 0.3


class VOTES:
    """How the votes of the learned trees make a verdict, and its confidence."""

    #: share of the votes. A section is unknown if the share of the votes for nonsense is larger than this value. With
    #: 1, random walks are given a strategy. With 0.5, outlines of snowflakes are called nonsense. With 0, engravings
    #: are called nonsense.
    NONSENSE = 0.6
    #: share of the votes. Lower bound for a share of the votes before its odds are computed. With 0, the log odds of a
    #: share of 0 or 1 are infinite.
    MIN_SHARE = 0.01
    #: confidence. Upper bound for the confidence, because about one in a hundred of the most confident verdicts on
    #: unseen programs is wrong.
    SUREST = 0.99
