# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define every threshold of the recogniser, with its unit and with what goes wrong at higher and lower values.

Each limit, such as the tolerance for equal heights, is one threshold that all files share. The comment on a threshold
begins with the threshold's unit, which ends at the first full stop. "X is recognised as Y" means that the rules propose
the strategy Y for toolpaths of the strategy X. These toolpaths are synthetic, or operations made by FreeCAD with a
known tool (benchmarks/make_operations.py). "In real programs" means programs that were not used to write the rules.
`benchmarks/thresholds.py --rules OPERATIONS.jsonl.gz` changes each threshold and prints which proposals of the rules
change. Without --rules, the command prints which recognised strategies change. The recognised strategies depend mostly
on the learned decision trees.
"""


class ROUNDING:
    """Largest differences that rounding and sampling cause between equal lengths, positions or areas."""

    #: mm. Two cuts are at one depth if their heights differ by at most the threshold. With a higher value, all turns of
    #: a helix are at one depth, and the helix is recognised as a profile.
    HEIGHT = 0.02
    #: mm. Two lines, or two sides of bounding boxes, count as one line if their distance is at most the threshold. With
    #: a higher value, all rows are on one line, and zigzags are recognised as engravings. With the value 0, some
    #: zigzags with rounded rows are also recognised as engravings.
    PLACE = 0.02
    #: mm. Largest difference between the bounding boxes of two equal rings (repetitions of one ring), on every side.
    #: With a higher value, all offsets are equal rings, and pockets are recognised as profiles.
    RING = 0.05
    #: share of the ring's size. Additional difference between the bounding boxes of equal rings, allowed for large
    #: rings. With the value 1, all offsets are equal rings.
    RING_OF_SIZE = 0.002
    #: share of the reach (largest distance between nested rings). Upper bound for the sum of RING and RING_OF_SIZE; the
    #: bound is at least RING. Without the bound, helices cut by an unknown tool are recognised as profiles. With the
    #: value 1, contours in real programs are recognised as mixed.
    RING_OF_REACH = 0.25
    #: share of the larger area. Two rings with the same bounding box have different shapes if their enclosed areas
    #: differ by more than the threshold. With the value 0, the turns of a helix made of chords all have different
    #: shapes, and the helix is recognised as a profile.
    AREA = 0.05
    #: mm. Two pieces of the toolpath (loops, zigzags or strokes) have the same footprint if their bounding boxes, and
    #: their lengths, differ by at most the threshold. With a higher value, the contours of a waterline count as
    #: repetitions of one contour.
    GROUND = 0.1


class NEGLIGIBLE:
    """Lengths that are too short to show a strategy, such as links between passes, leads and remnants."""

    #: share of the section's length. If all open strokes together have less than this share, the strokes are links
    #: between loops. With a higher value, bites of adaptive clearing count as links.
    LINKS = 0.02
    #: share of the longest ring or stroke. A ring or stroke that is shorter than this share of the longest ring or
    #: stroke is a link or a lead. With a higher value, the inner offsets of a pocket are ignored.
    PIECE = 0.02
    #: share of the usual pass's length. A pass that is shorter than this share of the usual pass is a link along the
    #: boundary. With a higher value, a raster of a triangle loses its rows.
    PASS = 0.1
    #: share of the section's length. Zigzags, strokes and other pieces that can contain rows are links if they have at
    #: most this share in total. With the value 1, rows cut one way are recognised as offsets.
    ROWS = 0.1
    #: share of the first family of rows. A second family of rows is ignored if its length is below this share of the
    #: first family's length. With the value 1, grids are recognised as profiles.
    FAMILY = 0.1


class MAJORITY:
    """Shares of the length above which a property holds for the whole, and minimum numbers of repetitions."""

    #: share. A property that more than this share of the section's length has is a property of the whole section (the
    #: only majority threshold).
    SHARE = 0.5
    #: count. Minimum number of trochoids, bites, concentric arcs, lines of a grid, neighbouring strokes, or rows beside
    #: loops. A smaller number of such patterns can be caused by chance. With the value 1, open profiles are recognised as
    #: zigzags. With a higher value, trochoids are recognised as profiles.
    REPETITIONS = 5


class ENTRY:
    """Thresholds for how the tool enters the material at a depth."""

    #: turns. A ramp that turns by more than the threshold is a helix. With the value 0, every ramp is a helix. With a
    #: higher value, helices of one turn are recognised as ramps.
    WINDS = 0.75
    #: cosine. A ramp returns along the horizontal lead-in before it if the cosine of the angle between the ramp and the
    #: reversed lead-in is above the threshold. With the value 1, no ramp returns. With the value 0, a ramp around a
    #: corner also counts as returning if the ramp ends where the lead-in began.
    BACK = 0.95
    #: share of the entry's size. The path after an entry must extend beyond the entry's bounding box by more than this
    #: share; otherwise the descent is part of the pattern. With the value 0, helices that end with a horizontal turn
    #: are recognised as profiles. With a higher value, a helix that enters a pocket is recognised as the operation.
    LEADS = 0.25
    #: share of the piece's length. A piece (a loop, zigzag or stroke) has one or several depths if more than this share
    #: of its length is horizontal; the other moves are ramps, or cuts over tags. With a lower value, horizontal parts
    #: of rows on surfaces count as depths. With the value 1, ramped contours have no depth. No recognised strategy
    #: depends on this threshold.
    LEVEL = 0.75
    #: share of the piece's length. A height counts as one of several depths of a piece if at least this share of the
    #: piece's length is horizontal at this height. With the value 0, every height at which a piece is horizontal is a
    #: depth. With the value 1, rows that are cut at several depths without a lift have no depth.
    ONE_OF_SEVERAL = 0.3


class PIECES:
    """How the bounding boxes of loops, zigzags and strokes are computed."""

    #: moves. The moves of all pieces are compared in one loop over the moves if no piece has more moves than the
    #: threshold, because numpy's overhead for one piece is about the time for this number of moves. With the value 0,
    #: measuring the bounding boxes of squares takes longer. With a higher value, measuring takes as long. No result
    #: depends on this threshold.
    FEW = 8


class PASSES:
    """Thresholds that decide whether passes go back and forth or around a contour."""

    #: cosine. A move is part of a pass if the cosine of the angle between the move and the main axis of its stretch is
    #: larger than the threshold. With the value 0, links are passes, and the profile of a comb is recognised as a
    #: zigzag. With the value 1, ramps cut back and forth are recognised as strokes.
    ALONG = 0.9
    #: count. A part of the toolpath with at most this number of passes can be an engraved letter with slanted strokes,
    #: such as N, W or Z. With the value 0, engraved names are recognised as zigzags.
    OF_A_LETTER = 4
    #: cosine. A part of the toolpath with at most OF_A_LETTER passes counts as rows only if the cosine of the angle
    #: between its passes and the axis is larger than the threshold. With the value 0, every part with so few passes
    #: counts as rows. With the value 1, no part with so few passes counts as rows, and ramps cut back and forth are
    #: recognised as letters.
    PARALLEL = 0.99
    #: share of the length of the passes. A part of the toolpath with at most OF_A_LETTER passes counts as rows only if
    #: more than this share of its passes is parallel to the axis, according to PARALLEL. With the value 0, a letter
    #: with one upright stroke is recognised as a zigzag. With the value 1, rows with links nearly parallel to the rows
    #: are recognised as letters.
    SHARE = 0.8
    #: share of the stretch's length. A stretch of moves goes back and forth if more than this share of its passes lies
    #: between half-turns of opposite sign. With the value 1, zigzags with a part of the boundary are recognised as
    #: mixed.
    ALTERNATING = 0.3
    #: ratio. In a zigzag, the passes between half-turns of opposite sign are longer in total, by more than this factor,
    #: than the passes between half-turns of equal sign. With a lower value, grids are recognised as mixed.
    MORE = 2
    #: share of the loop's length. A closed loop goes back and forth if more than this share of its length lies between
    #: half-turns of opposite sign. With the value 0, the finishing pass of a pocket is recognised as a zigzag. With the
    #: value 1, zigzags that end at their start are recognised as loops.
    ALTERNATING_LOOP = 0.55


class WINDINGS:
    """Spirals, helices and other windings, which go around several times without closing."""

    #: turns. A stretch of moves that does not close is a winding, such as a spiral, if its net turn is larger than the
    #: threshold. With a lower value, letters are recognised as windings. With an infinite value, spirals are recognised
    #: as profiles.
    TURN = 1.2
    #: turns. The rest of a winding after its last full turn counts as a full turn if the rest turns by more than the
    #: threshold. With the value 0, round pockets cut in a spiral of few turns are recognised as adaptive clearing. With
    #: the value 1, no turns of windings count as trochoids.
    LAST_TURN = 0.75
    #: share of the usual step. The turns of a winding are evenly spaced, as in a spiral, if their steps differ from the
    #: usual step by less than this share. In adaptive clearing with constant engagement, the steps between the turns of
    #: a winding are not even but grow. With the value 0, spirals with a helical entry are recognised as adaptive
    #: clearing. With a higher value, adaptive clearing of round pockets is recognised as a spiral.
    EQUAL = 0.05
    #: turns. A winding is wavy, like a lattice or a concave contour, if its turns against its sense add up to more than
    #: the threshold. A stroke is not a bite if its turns against its sense add up to more than the threshold. With the
    #: value 0, smoothly linked offsets and sampled spirals are recognised as profiles.
    WAVY_TURN = 0.5
    #: turns. A winding can consist of rows that bounce from wall to wall (a lattice) if its turns against its sense add
    #: up to more than the threshold. With a higher value, grids are recognised as mixed.
    LATTICE_TURN = 0.75
    #: turns. A ring contains a step to the next loop if the ring's turns against the sense of its winding add up to
    #: more than the threshold. With a higher value, smoothly linked offsets are recognised as spirals. With the value
    #: 0, spirals in real programs are recognised as linked offsets.
    STEP_ASIDE = 0.075
    #: rad mm. Bends are ignored if the product of angle and length is smaller than the threshold, because rounding to
    #: 0.01 mm can cause them. With the value 0, smoothly linked offsets are recognised as adaptive clearing. With a
    #: higher value, smoothly linked offsets are recognised as spirals.
    ROUGH = 0.05
    #: places. Minimum number of corrections of the direction in each turn of adaptive clearing. Adaptive clearing
    #: corrects its direction to keep the engagement constant. With a lower value, smoothly linked offsets are
    #: recognised as adaptive clearing. With a higher value, adaptive clearing by FreeCAD is recognised as
    #: contour-parallel.
    CORRECTIONS = 8
    #: rad. Largest mean correction of the direction in adaptive clearing, 10 degrees. With a higher value, links to the
    #: next loop count as corrections.
    CORRECTION = 0.17453292519943295
    #: rad. Turns by more than 30 degrees are corners. With the value 0, spirals consist only of corners and are
    #: recognised as contour-parallel. With the value pi, polygonal windings are recognised as spirals.
    CORNER = 0.5235987755982988


class SPURS:
    """Spurs: detours that go out and back on the same line."""

    #: share of the area's length. Spurs that have less than this share in total are reliefs in corners and are removed.
    #: With the value 0, contours with relieved corners are recognised as adaptive clearing. With the value 1, passes
    #: that are cut back and forth on one line are removed as spurs.
    LENGTH = 0.2


class TAGS:
    """Contours that the tool cuts with lifts over holding tags."""

    #: cosine. A contour continues after a gap if the cosine of the angle between its direction and the gap is larger
    #: than the threshold. With the value 1, circles with tags are recognised as strokes. With the value 0, a stroke
    #: also continues after a corner, if all strokes together close a contour.
    AHEAD = 0.9


class STROKES:
    """Strokes: open parts of the toolpath that neither wind nor go back and forth."""

    #: share of the number of strokes. If the number of different footprints is below this share of the number of
    #: strokes, the strokes are contours repeated at other depths. With the value 0, repeated contours in real programs
    #: are recognised as engravings.
    DISTINCT = 0.67
    #: share of the part's width plus height. If the usual stroke is longer than this share of the part's width plus
    #: height, the strokes are contours. With the value 0, carved strokes are recognised as contours. With a higher
    #: value, the outlines that adaptive clearing leaves on thin stock are recognised as engravings.
    LONG = 0.35
    #: share of the section's length. Strokes are carved by a V-bit, which rises in corners, if the climbs at the ends
    #: of the strokes have more than this share of the section's length. With the value 0, contours with a ramp at the
    #: end count as carved. With the value 1, long V-carved strokes are recognised as contours.
    RISING = 0.05


class LETTERS:
    """Closed contours that are letters and not outlines of parts and holes."""

    #: mm. Two contours have different shapes if the sides of their bounding boxes, or quarters of their lengths, differ
    #: by more than about the threshold.
    SHAPE = 0.2
    #: count. Minimum number of different shapes among contours that are letters. Contours with fewer shapes are
    #: outlines of parts.
    COUNT = 8
    #: depths. Engraved letters are cut at no more than this number of depths. With a higher value, pockets and parts of
    #: many shapes in real programs are recognised as letters.
    DEPTHS = 3
    #: share of the part's size. Contours are letters only if their median size is smaller than this share of the part's
    #: longer side. With the value 1, the outlines of plates are recognised as letters.
    SMALL = 0.15


class NESTS:
    """Rings that lie inside one another."""

    #: mm. Minimum distance between neighbouring rings. With a higher value, no rings are nested, and pockets are
    #: recognised as profiles.
    APART = 0.01
    #: tool diameters. Largest distance between rings, rows or strokes that leave no uncut ground between them. With a
    #: lower value, pockets are recognised as profiles. With a higher value, the contours of washers, and of chamfered
    #: and engraved edges, are recognised as pockets.
    REACH = 1.2
    #: count. Largest number of sides that the bounding boxes of two offsets can share. A pocket in a corner of the part
    #: is open at two sides, which all offsets share. With the value 0, open pockets are recognised as profiles.
    SHARED = 2
    #: rings. Number of later rings that each ring is compared with. With the value 1, pockets with islands are
    #: recognised as profiles if rings of boundary and island are cut alternately. Comparing more rings takes time and
    #: does not improve the recognition.
    NEXT = 3
    #: share of the mean shift. The shifts of the four sides of a bounding box count as equal if they differ by at most
    #: this share of their mean. With a higher value, rows of a lattice (rows that bounce from wall to wall) count as
    #: nested rings.
    EQUAL_SIDES = 0.1
    #: ratio to the distance between two rings. An inner offset is shorter than the outer ring by at most this multiple
    #: of the distance between the two rings. For a circle, the difference in length is 6.3 times the distance, for a
    #: square 8 times; only contours with bays have more. With a higher value, engraved lines around a letter are
    #: recognised as its offset.
    LONGER = 12.0
    #: share of the longer loop. Minimum length of the shorter of two offsets whose lengths differ by more than LONGER
    #: allows, because bays close between the offsets. With the value 0, the lengths of two offsets are not compared.
    #: With the value 1, pockets shaped like combs have no stepover.
    LENGTH_ALIKE = 0.6
    #: share of the distance between two rings. Each side of an inner offset's bounding box lies inside the outer ring's
    #: bounding box by at least this share of the distance between the rings. With the value 0, ramped profiles are
    #: recognised as pockets. With the value 1, waterlines are recognised as contour-parallel.
    SIDE_AT_LEAST = 0.5
    #: ratio to the distance between two rings. The side of an inner offset's bounding box that is shifted least is
    #: shifted by at most this multiple of the distance between the rings. With a lower value, no rings are nested. With
    #: a higher value, the rows of grids count as nested rings.
    SIDE_AT_MOST = 1.5
    #: share of the ring's size. Largest step between two nested rings. With the value 0, no rings are nested. With a
    #: higher value, contours of three sizes at different depths are recognised as a pocket.
    LARGEST_STEP = 0.3
    #: share of the step between two rings. Two steps between nested rings count as equal if they differ by less than
    #: this share. With the value 0, no three rings are nested with equal steps, and pockets of an unknown tool are
    #: recognised as profiles.
    SIMILAR_STEP = 0.3
    #: share of the largest ring. Largest usual distance between nested rings if the tool is unknown. With the value 0,
    #: pockets are recognised as profiles. With a higher value, waterlines are recognised as pockets.
    TOO_LARGE = 0.2
    #: share of the largest ring. If the tool is unknown and no three rings are nested with equal steps, rings whose
    #: distance is larger than this share of the largest ring are separate contours. With the value 0, narrow pockets
    #: around an island are separate contours. With a higher value, engraved contours are recognised as pockets.
    REACH_OF_SIZE = 0.05
    #: steps. Largest distance between nested rings if the tool is unknown, as a multiple of the usual distance between
    #: the rings. With the value 1, every second ring of linked offsets and spirals is not nested.
    STEPS = 2


class RINGS:
    """Shapes of rings, and the shares of rings that decide the strategy."""

    #: isoperimetric quotient 4 pi A / P^2. A ring is a circle if its isoperimetric quotient is larger than the
    #: threshold; the quotient of a square is 0.79. With a lower value, ramped profiles are recognised as helices. With
    #: the value 1, helices that are made of chords are recognised as profiles.
    ROUND = 0.93
    #: share of the ring's drop. A ring descends steadily if its mean height differs from the height halfway between its
    #: ends by less than this share of the height difference between its ends. With the value 0, no helix descends
    #: steadily. With a higher value, profiles with a ramp in their first moves (cut by a known tool) are recognised as
    #: helices.
    STEADY = 0.2
    #: share of the rings' length. Rings are a helix only if circles have more than this share of the rings' length.
    #: With a lower value, profiles with bores are recognised as helices if both are ramped.
    ALL_ROUND = 0.85
    #: share of the zigzag's box. A loop surrounds a zigzag if no side of the loop's bounding box lies inside the
    #: zigzag's bounding box by more than this share of its size. With the value 0, contours near a zigzag count as
    #: parts of the zigzag. With the value 1, the small loops between the rows of a zigzag count as contours.
    SURROUNDS = 0.15
    #: share of the section's length, and of the rings' length. The strategy is decided by nested rings (offsets) if all
    #: rings have more than this share of the section's length, and nested rings have more than this share of the rings'
    #: length. With the value 0, spirals interrupted at the boundary are recognised as adaptive clearing. With the value
    #: 1, linked offsets are recognised as spirals.
    OFFSETS = 0.7
    #: share of the section's length. The rings decide the strategy if rings have more than this share of the section's
    #: length and there are hardly any rows. The rows decide the strategy if rows have at least this share and there are
    #: hardly any rings. With the value 0, strokes are recognised as zigzags. With the value 1, waterlines and helices
    #: are recognised as profiles.
    ALONE = 0.35
    #: share of the section's length. Rows that have less than this share of the section's length are ignored beside
    #: rings. With a higher value, rows with a contour around them are recognised as a profile. With the value 0,
    #: profiles in real programs are recognised as mixed.
    ROWS_BESIDE = 0.15
    #: share of the section's length. Rings that have less than this share of the section's length are ignored beside
    #: rows. With the value 0, every closed link of a zigzag counts as a contour.
    AMONG_ROWS = 0.1
    #: count. Number of the largest rings at each depth that can be the walls of pockets with rows inside. With the
    #: value 1, rows in several pockets, each with a contour, are recognised as mixed. Comparing more rings takes
    #: longer.
    WALLS = 8
    #: share of the steps between rings. Nested rings are cut from inside to outside, or from outside to inside, if more
    #: than this share of the steps between the rings has this direction. Climb or conventional milling is reported only
    #: for rings with one such direction. No recognised strategy depends on this threshold.
    ONE_WAY = 0.75


class WATERLINES:
    """Waterlines: contours whose shape changes with the depth."""

    #: depths. Minimum number of depths of a waterline. With a much higher value, waterlines are recognised as profiles.
    DEPTHS = 3
    #: tool diameters. Minimum height difference between the deepest and the highest ring of a waterline. With the value
    #: 0, deburred edges are recognised as pockets. With a higher value, waterlines are recognised as profiles.
    RANGE = 0.35
    #: share of the rings' length. In a waterline, more than this share of the rings' length is in rings with a ring of
    #: another shape above or below. With the value 0, engraved contours are recognised as waterlines. With the value 1,
    #: waterlines are recognised as profiles.
    DEEPER = 0.3
    #: ratio of two relative spreads. The rings are evenly spaced in the plane and not in depth, like circles on a dome,
    #: if the relative spread of their horizontal distances divided by the relative spread of their vertical distances
    #: is smaller than the threshold. With the value 0, circles on a dome are recognised as waterlines. With a higher
    #: value, waterlines are recognised as contour-parallel.
    EVENER = 0.5
    #: relative spread. This constant is added to the relative spreads of the horizontal and of the vertical distances
    #: between rings, because smaller spreads are rounding errors. With the value 0, a waterline that is rotated or
    #: scaled is recognised as contour-parallel.
    ROUNDING = 0.01
    #: depths. Open contours are a waterline only if they have at least this number of depths. With a lower value,
    #: letters and open profiles are recognised as waterlines. With a higher value, waterlines interrupted at the sides
    #: of the stock are recognised as engravings.
    OPEN_DEPTHS = 4
    #: share of the section's length. Open contours are not a waterline if sloped strokes have more than this share of
    #: the section's length. With the value 0, no open contours are a waterline. With the value 1, V-carving in real
    #: programs is recognised as a waterline.
    SLOPED = 0.2


class TROCHOIDS:
    """Trochoids: loops of one size that advance along a path."""

    #: share of the rings' length. Rings are trochoids if more than this share of their length is in loops that advance
    #: along a path. With the value 0, overlapping contours are recognised as trochoids. With a higher value, adaptive
    #: clearing without lifts is recognised as a profile.
    SHARE = 0.4
    #: share of the range of the four shifts. From one trochoid to the next, some sides of the bounding box shift
    #: inwards, and other sides outwards. The mean shift of the four sides must be less than this share of the range of
    #: the shifts. With the value 0, no loops are trochoids.
    SWAY = 0.35
    #: share of the smaller loop. From one trochoid to the next, the range of the shifts of the bounding box's sides
    #: must be below this share of the smaller loop. With the value 0, no loops advance along a path, and trochoids are
    #: recognised as profiles.
    STEP = 1.2
    #: share of the larger loop. Two loops are trochoids only if the smaller loop's size is above this share of the
    #: larger loop's size. With the value 1, no loops are trochoids.
    SIZE = 0.65


class ROWS:
    """Rows: parallel passes side by side."""

    #: directions in half a turn. Number of classes of directions in the search for the most frequent direction. With
    #: the value 1, grids have no axis.
    DIRECTIONS = 64
    #: values. Largest number of values from which medians are computed, and of passes from which the lines of a family
    #: of rows are found. With the value 1, zigzags are recognised as engravings. A larger sample takes time and does
    #: not improve the recognition.
    SAMPLE = 1000
    #: rad. Largest angle between the moves of a row and the axis of the rows. With the value 0, rows of sampled moves
    #: break up. With a higher value, bites are recognised as rows.
    ALIGNED = 0.05
    #: share of the moves' length. If less than this share of the moves' length is parallel to the mean axis, the moves
    #: have several axes. With the value 0, a grid has a single axis, between its two directions.
    ONE_AXIS = 0.8
    #: share of the moves' length. If less than this share of the moves' length is parallel to the axis, links have
    #: rotated the axis, and the axis is computed again without the links. With the value 0, zigzags along a slanting
    #: boundary are recognised as profiles.
    ALL_ALIGNED = 0.98
    #: usual steps. Largest distance between neighbouring rows. With a lower value, no rows have a neighbour, and rows
    #: cut one way are recognised as offsets.
    MAX_DISTANCE = 1.6
    #: usual steps. Minimum distance between evenly spaced rows. With a higher value, no rows are evenly spaced, and
    #: rows cut one way are recognised as offsets.
    MIN_DISTANCE = 0.6
    #: share. The period of a family of rows is the shortest distance between two rows whose frequency is more than this
    #: share of the frequency of the most frequent distance. With the value 1, twice the true period is sometimes
    #: chosen. With the value 0, a distance that occurs by chance is chosen as the period.
    PITCH_FREQUENCY = 0.8
    #: share of the usual distance between neighbouring rows. Gaps between lines are equal if they differ by less than
    #: this share of the pitch. With the value 0, zigzags that end at their start are recognised as profiles of combs.
    #: With a higher value, only half the stepover is found for rows that bounce from wall to wall (a lattice) if the
    #: lines are nearly evenly spaced.
    SAME_GAP = 0.02
    #: lines. Largest number of lines in a period. With the value 1, all rows count as evenly spaced, and zigzags that
    #: end at their start are recognised as profiles of combs. A higher value gains nothing.
    MAX_PERIOD = 12
    #: pitches. Largest distance between lines in the search for the period. The pitch (distance between neighbouring
    #: rows) is very small if two sets of rows nearly coincide, so that the period is many times the pitch. With a lower
    #: value, a wrong stepover is found for rows that bounce from wall to wall (a lattice). With a higher value,
    #: distances between the lines of different pockets need much memory.
    FARTHEST = 1000
    #: share of the rows' length. Passes are not rows if the passes with a neighbour at the usual distance have no more
    #: than this share of the rows' length. With the value 0, passes of adaptive clearing and waterlines are recognised
    #: as rows. With the value 1, rows cut one way are recognised as offsets.
    WITH_NEIGHBOUR = 0.25
    #: steps. Minimum length of a row. With the value 0, the sides of small contours count as rows. With a higher value,
    #: grids are recognised as engravings.
    MIN_LENGTH = 2.5
    #: steps. Minimum length of a row in a family of many evenly spaced rows (see MANY and EVEN). With a higher value,
    #: zigzags in narrow teeth are recognised as profiles.
    MIN_LENGTH_IF_MANY = 1.5
    #: lines. A family of rows consists of many rows if it has rows on at least this number of different lines. With a
    #: much higher value, zigzags in narrow teeth are recognised as profiles.
    MANY = 10
    #: share of the steps. Rows are evenly spaced if more than this share of their steps is close to the usual step.
    #: With the value 1, zigzags in narrow teeth are recognised as profiles.
    EVEN = 0.8
    #: tool diameters. Passes on fewer than MANY lines are repetitions of one pass if their step is below the threshold.
    #: With the value 0, ramped profiles are recognised as mixed if the tool is known.
    RETRACED = 0.03
    #: mm. Smallest distance between rows. With a higher value, zigzags with rows 0.001 mm apart are recognised as
    #: profiles. With the value 0, rounding of slanted lines divides a row that is interrupted by islands into several
    #: rows.
    FINEST = 5e-4
    #: pitches. The passes of a closed contour are the walls of a comb's teeth if the distance at which the passes
    #: repeat is larger than the threshold. With a lower value, zigzags that end at their start are recognised as
    #: profiles. With a higher value, combs are recognised as zigzags.
    WALLS = 1.05
    #: steps. Rows that are cut consecutively can be farther apart than the tool reaches, because rows cut later lie
    #: between them. The threshold is the largest distance between rows that are cut consecutively, as a multiple of the
    #: period. With the value 1, rows that are cut in two rounds, first every second row, are recognised as engravings.
    #: With a higher value, passes along both sides of uncut ground are recognised as rows.
    LEFT_BETWEEN = 3
    #: share of the length of all possible rows. Two families of rows are a grid if both families together have more
    #: than this share of the length of all moves that can be rows. With the value 0, waterlines and adaptive clearing
    #: are recognised as grids. With the value 1, grids are recognised as engravings.
    GRID = 0.85
    #: count. Number of passes of each family of rows that are tested for crossing the other family. With the value 1,
    #: grids are recognised as engravings. Testing more passes takes longer.
    CROSSING = 100
    #: share of a pass's length. A crossing of two passes is a corner if its distance to the end of a pass is below this
    #: share of the pass's length. With the value 0, the sides of nested contours count as crossing. With the value 0.5,
    #: no passes count as crossing.
    END = 0.05


class ARCS:
    """Concentric arcs: open strokes around one centre."""

    #: cosine. A move lies on a circle if the cosine of its angle to the ray from the centre is smaller than the
    #: threshold. With the value 0, circles interrupted at the boundary are recognised as engravings. With the value 1,
    #: open waterlines are recognised as spirals.
    SQUARE = 0.15
    #: share of the squared trace. Moves have no common centre, because they are nearly parallel, if the determinant of
    #: the matrix of their directions is smaller than this share of the square of its trace. With the value 0, straight
    #: rows cause a division by zero. With the value 1, circles interrupted at the boundary have no common centre.
    STRAIGHT_ROWS = 0.01
    #: share of the stroke's length. A stroke is an arc if more than this share of its length lies on a circle around
    #: the common centre. With the value 0, open waterlines are recognised as spirals.
    ARC = 0.9
    #: steps. Two arcs have different radii if the radii differ by more than the threshold. With the value 0, the
    #: outlines that adaptive clearing leaves on thin stock count as arcs with many radii.
    RADIUS = 0.3
    #: steps. An arc is part of a spiral if its radius changes by more than the threshold in one full turn. With the
    #: value 0, circles interrupted at the boundary are recognised as spirals. With a higher value, adaptive clearing
    #: from a centre is recognised as contour-parallel.
    DRIFT = 0.3


class NEIGHBOURS:
    """Open strokes that lie side by side, such as open offsets."""

    #: count. Number of points on each stroke in the comparison with other strokes. With the value 2, all strokes are
    #: treated as straight lines. More points take time and do not improve the recognition.
    POINTS = 12
    #: share of a stroke's points. Two strokes are neighbours only if, from more than this share of the points of one
    #: stroke, the perpendicular meets the other stroke. With the value 0, the strokes of letters count as neighbours.
    FACING = 0.6
    #: usual steps. Largest distance between neighbouring strokes, as a multiple of the usual distance. With the value
    #: 0, no strokes count as neighbours.
    MAX_DISTANCE = 3
    #: share of the distance between two strokes. The distance between two strokes is constant, as between offsets, if
    #: it varies by less than this share of the median distance. With the value 0, open offsets are recognised as
    #: adaptive clearing. With a higher value, passes of adaptive clearing are recognised as offsets.
    EVEN = 0.3
    #: share of the neighbouring strokes' length. Open strokes are adaptive clearing only if more than this share of
    #: their length has the direction of its neighbour, because adaptive clearing always mills in one direction. With a
    #: lower value, offsets interrupted at a side of the part are recognised as adaptive clearing in real programs.
    ONWARD = 0.9
    #: share of the strokes' length. Open strokes cover an area, and are not letters, if strokes with neighbours have
    #: more than this share of the length of all strokes. With the value 1, open strokes never count as covering an
    #: area. With a lower value, letters count as covering an area.
    SHARE = 0.7


class BITES:
    """Arcs that adaptive clearing cuts out of the stock one after the other."""

    #: turns. Only a stroke that bends by more than the threshold can be a bite. With a higher value, no strokes are
    #: bites, and adaptive clearing is recognised as a spiral or an engraving.
    BENT = 0.25
    #: share of the smaller bite's size. The centres of two consecutive bites must be nearer to each other than this
    #: share of the smaller bite's size. With the value 0, no strokes are bites. With a higher value, curls of a drawing
    #: that overlap by chance are recognised as adaptive clearing.
    MOVED = 0.5
    #: share of the section's length. Strokes are adaptive clearing only if bites have more than this share of the
    #: section's length. With the value 0, spirals and profiles in real programs are recognised as adaptive clearing.
    #: With the value 1, no toolpath is recognised as adaptive clearing because of its bites.
    SHARE = 0.1
    #: bites. Minimum number of bites in adaptive clearing. With the value 1, V-carving and circles interrupted at the
    #: boundary are recognised as adaptive clearing. With a value of 20, adaptive clearing of small pockets is
    #: recognised as a spiral.
    COUNT = 10
    #: share of the bites' length. Bent strokes are letters, and not bites, if the strokes that bend in the opposite
    #: sense have more than this share of the bites' length. With the value 1, letters are recognised as adaptive
    #: clearing. With the value 0, no toolpath is recognised as adaptive clearing because of its bites.
    AGAINST = 0.3


class ADAPTIVE:
    """Differences between adaptive clearing and a spiral or helix that clears a pocket."""

    #: share of the section's length. If bites have more than this share of the section's length, a winding beside the
    #: bites is adaptive clearing that also clears corners. With the value 1, adaptive clearing by FreeCAD is recognised
    #: as a spiral.
    BITES = 0.03
    #: share of the section's length. A winding is adaptive clearing if the tool enters along a helix with more than
    #: this share of the section's length, unless the turns of the winding are evenly spaced circles. With the value 1,
    #: adaptive clearing in real programs is recognised as a spiral.
    ENTRY = 0.005
    #: share of the section's length. If open strokes have more than this share of the section's length, a winding
    #: beside the strokes is not a spiral. With the value 0, spirals are recognised as adaptive clearing. With the value
    #: 1, adaptive clearing with a third of its length in open strokes is recognised as a spiral.
    STROKES = 0.3


class POCKET:
    """Narrow pockets: an open stroke clears the pocket, and a ring around the stroke is the finishing pass."""

    #: share of the section's length. A section is mixed if the open strokes that clear the inside of rings have more
    #: than this share of the section's length. With the value 0, engraved contours in real programs are recognised as
    #: mixed.
    FILLED = 0.1
    #: ratio. An open stroke clears the inside of a ring only if the stroke's enclosed area per length is below this
    #: multiple of the ring's enclosed area per length. With a higher value, contours inside contours are recognised as
    #: mixed in real programs.
    WIDTH = 0.75


class PARTS:
    """How NC programs are divided into operations, and when different operations make the program mixed."""

    #: borders. A program with more borders (trajectories before which another operation possibly begins) than the
    #: threshold is not divided at all, because so many borders do not separate operations, and recognising each section
    #: takes time. With the value 1, circuit boards and programs with several operations are recognised as one
    #: operation.
    BORDERS = 200
    #: share of the number of milled areas. If the number of plunges is below this share of the number of milled areas,
    #: the plunges are not holes, but passes that the boundary shortens to a point. With the value 1, circuit boards are
    #: recognised as profiles.
    DRILLED = 0.25
    #: count. Plunges in a milling program are not holes if they are fewer than this number, unless a canned cycle
    #: drills them: such plunges park the tool or touch the stock. With the value 1, a profile after which the tool is
    #: parked is recognised as mixed.
    HOLES = 2
    #: depths. A toolpath that cuts at more heights than this number cuts a curved surface. With a lower value, circuit
    #: boards engraved at a few depths count as surfaces.
    DEPTHS = 10
    #: share of the program's cutting length. Sections of other operations do not make a program mixed if these sections
    #: have less than this share in total and use the same tool. With the value 0, rasters on surfaces and circuits with
    #: a hole are recognised as mixed.
    ASIDE = 0.05
    #: share of the program's cutting length. After a certain border, such as a tool change, a single section of another
    #: operation makes a program mixed if the section has more than this share of the program's cutting length. With the
    #: value 1, short zigzags before a profile are ignored.
    CERTAIN = 0.001
    #: count. A section without loops and with fewer passes than this number is too short to show a strategy. With the
    #: value 0, rows and rings on surfaces are recognised as profiles.
    PASSES = 3
    #: count. If the program changes back and forth between two strategies, at least this number of times and at
    #: doubtful retracts, both strategies are one operation. With the value 1, any two strategies are recognised as one
    #: operation, such as a pocket followed by another pattern.
    TURNS = 3


class VISITS:
    """Retracts that begin another operation; benchmarks/learn_borders.py learns the model."""

    #: share of the decision trees' votes. Another operation begins at a retract if more than this share of the decision
    #: trees' votes is for it. With the value 0, another operation begins at every retract to the top height, and
    #: pockets are recognised as mixed. With the value 1, no retract begins another operation, and a zigzag followed by
    #: a profile is recognised as one operation.
    BORDER = 0.3
    #: share of the decision trees' votes. If the share of the decision trees' votes for another operation at a retract
    #: is between this threshold and BORDER, the strategies recognised before and after the retract also decide. With
    #: the value 1, the strategies before and after a retract never decide, and a pocket followed by another pattern is
    #: recognised as one operation.
    DOUBTFUL = 0.03
    #: ratio. Another operation begins at a retract if the product of two odds is larger than the threshold: the odds of
    #: the decision trees' votes, and the odds that the strategies recognised before and after the retract are both
    #: right. With the value 0, another operation begins at every doubtful retract between different strategies, and
    #: pockets are recognised as mixed.
    DIFFER = 0.6
    #: visits. Number of previous visits (cuts between two retracts) that each visit is compared with, to find ground
    #: that is cut again. With the value 1, each visit is compared only with the visit before it. Comparing more visits
    #: (cuts between two retracts) improves the recognition only a little.
    EARLIER = 8
    #: visits. Largest number of retracts at which a program is divided into operations. With a higher value, programs
    #: take longer to recognise, because each section is recognised separately. With the value 1, most programs are
    #: recognised as one operation.
    MOST = 60
    #: share of the block's length. A block of a visit (an area or a drilled hole) counts as closed if the distance
    #: between its ends is below this share of the block's length.
    CLOSED = 0.03
    #: share of the larger visit's size. Two visits (cuts between two retracts) cover the same ground if their bounding
    #: boxes differ, on every side, by less than this share of the larger visit's size.
    PLACE = 0.01
    #: share. The feed rates of two visits (cuts between two retracts) are equal if they differ by less than this share
    #: of the higher feed rate.
    FEED = 0.01
    #: mm. Minimum size of a visit (the cuts between two retracts), because the size of a single drilled hole would be
    #: 0.
    SMALL = 0.05


class LATHE:
    """Thresholds for toolpaths of a lathe in X and Z."""

    #: count. Minimum number of X positions of a lathe's passes along Z. With the value 1, a milled slot is recognised
    #: as turned.
    PASSES = 3
    #: ratio. Minimum ratio of the length cut along Z to the length cut along X, for a toolpath of a lathe. With the
    #: value 0, a row of milled slots is recognised as turned. With a higher value, short turned bolts are recognised as
    #: profiles.
    LONGER = 1.5


class MEASURED:
    """Sample sizes and limits of the measures that the decision trees read.

    The decision trees were learned with the values of this class.
    """

    #: moves. Number of sampled moves from which shares of the section's length are computed; the sample is spread
    #: evenly over all moves.
    MOVES = 1000
    #: moves. Number of sampled moves from which sequences of turns are measured; the sample is from the middle of the
    #: cutting order.
    TURNS = 2000
    #: rad. Turns by an angle up to the threshold are caused by rounding and are ignored.
    TURN = 1e-4
    #: turns. An area goes back and forth if the sum of its turns (phi) varies by less than the threshold.
    HALF_TURN = 0.51
    #: turns. A closed area goes around once if its net turn, without the turn at the last corner, is between the two
    #: thresholds.
    ONE_TURN = (0.6, 1.3)
    #: share of the area's length. An area counts as closed in the measures if the distance from its start to its end is
    #: below this share of its length.
    CLOSED = 0.02
    #: turns. An arc of the Gauss map (consecutive turns in one sense) is a half turn, as between alternating rows, if
    #: it differs from a half turn by less than the threshold.
    HALF = 0.1
    #: turns. An arc of the Gauss map (consecutive turns in one sense) that is shorter than the threshold is only a
    #: bend.
    SHORT = 0.3
    #: turns. An arc of the Gauss map (consecutive turns in one sense) that is longer than the threshold belongs to a
    #: contour.
    LONG = 0.75
    #: count. Number of classes into which turns are divided by their size, from no turn to an exact reversal.
    TURNS_BY = 12
    #: rings. Number of sampled rings from which the shares of the kinds of rings are computed.
    RINGS = 500
    #: ratio. Upper bound for the measure `evenness`, which compares the spread of the rings' horizontal distances with
    #: the spread of their vertical distances.
    EVENNESS = 1000


class SCAN:
    """Scan lines across a section. The decision trees were learned with the values of this class."""

    #: lines. Number of scan lines across a section.
    LINES = 12
    #: share of the cutting length. Share of the cutting length, on either side of the section, that no scan line
    #: crosses. Most moves beyond the outermost scan lines are leads and remnants.
    EDGE = 0.04
    #: places. Number of crossings of scan lines with moves after which no further scan lines are used.
    ENOUGH = 1200
    #: ratio. Minimum sine of the angle between a move and a scan line. A move at a smaller angle is nearly parallel to
    #: the scan line and is ignored.
    GRAZING = 0.3
    #: mm. Crossings of a scan line with moves are at one depth if their heights differ by less than about the
    #: threshold.
    DEPTH = 0.05
    #: ratio. Two neighbouring moves on a scan line are parallel if the sine of the angle between them is smaller than
    #: the threshold.
    PARALLEL = 0.35
    #: ratio. Width of the classes into which the logarithms of the distances between passes are divided, to find the
    #: most frequent distance.
    BIN = 0.2
    #: share of the usual distance between passes. Two passes are at the usual distance if their distance differs from
    #: the usual distance by less than the threshold.
    EVEN = 0.3


class VOTES:
    """How the votes of the learned decision trees determine the strategy and its confidence."""

    #: share of the decision trees' votes. The strategy of a section is unknown if more than this share of the decision
    #: trees' votes is for nonsense. With the value 1, a strategy is recognised even for random walks. With the value
    #: 0.5, outlines of snowflakes are recognised as nonsense. With the value 0, engravings are recognised as nonsense.
    NONSENSE = 0.6
    #: share of the decision trees' votes. A share of the votes is increased to at least this value, and lowered to at
    #: most 1 minus this value, before its odds are computed. With the value 0, the log odds of a share of 0 or 1 are
    #: infinite.
    MIN_SHARE = 0.01
    #: confidence. Upper bound for the confidence of a recognised strategy. Even with the highest confidence, about one
    #: in a hundred strategies recognised in unseen programs is wrong.
    SUREST = 0.99
