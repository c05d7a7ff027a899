# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of the recogniser: its unit, what it tells apart, and what goes wrong without it.

One idea has one threshold, however many places ask for it. "Without" means at the end of its range. What is wrong then
is what the rules propose, of made toolpaths and of those that benchmarks/make_operations.py has FreeCAD make, which
tell their tool: `benchmarks/thresholds.py --rules OPERATIONS.jsonl.gz` moves each and prints it. The trees outvote much
of that, as the same command prints without the option. It reads the unit from the comment, up to the first full stop.
"By tests" says what only a toolpath of tests/core/recognition needs, "by real code" what only programs of others need,
which had no part in the rules.
"""


class SAME:
    """What rounding and sampling leave between two things that are one."""

    #: mm. Heights closer than this are one depth. Larger: the turns of helices lie at one depth and are profiles.
    HEIGHT = 0.02
    #: mm. Lines and sides of boxes closer than this are one line. Larger: all rows lie on one, and zigzags are
    #: engravings. At 0 so are a few whose rows were rounded.
    PLACE = 0.02
    #: mm. Rings whose boxes differ by less on every side are one ring. Larger: all offsets are, and pockets profiles.
    RING = 0.05
    #: share of the ring's size. Large rings may differ by this much more. At 1 all offsets are one ring.
    RING_OF_SIZE = 0.002
    #: share of the reach. But by no more than this of it, where that is more than RING. With no such bound, and no
    #: tool, helices are profiles; at 1, by real code, contours are mixed.
    RING_OF_REACH = 0.25
    #: share of the larger area. Two rings in one box whose areas differ by more are two shapes. At 0 the turns of a
    #: helix in chords are all different, and it is a profile.
    AREA = 0.05
    #: mm. Pieces with boxes and lengths this close have one footprint. Larger: the contours of a waterline repeat.
    GROUND = 0.1


class LITTLE:
    """What is too little to decide: links from pass to pass, leads, remnants."""

    #: share of the length. Open strokes in all that are less are the links between loops. Larger: bites are links.
    LINKS = 0.02
    #: share of the longest. Shorter rings and strokes are links and leads. Larger: the inner offsets of a pocket are.
    PIECE = 0.02
    #: share of the usual pass. Shorter ones are links along the boundary. Larger: a raster of triangles loses its rows.
    PASS = 0.1
    #: share of the length. What may be rows is links where it is less. At 1 rows cut one way are offsets.
    ROWS = 0.1
    #: share of the first family of rows. Less in other directions is no second family. At 1 grids are profiles.
    FAMILY = 0.1


class ENOUGH:
    """How much of something makes the whole."""

    #: share. What more than half of it is, the whole is. Nothing else can say so: at 0 everything is everything.
    SHARE = 0.5
    #: count. Fewer repetitions are chance: rows that share an area with loops, trochoids, bites, arcs, lines of a grid,
    #: equal steps. At 1 open profiles are zigzags, larger: trochoids are profiles.
    TIMES = 5


class ENTRY:
    """How a depth is entered."""

    #: turns. A ramp that winds more is a helix. At 0 every ramp is, larger: helices of one turn are ramps.
    WINDS = 0.75
    #: cosine. A ramp that turns about by more comes back on the level way before it. By tests: at 1 none does; at 0
    #: a ramp that goes on around a corner does, too, if it ends where that way began.
    BACK = 0.95
    #: share of its size. What follows leads so much farther, or the way down is a part of the pattern. At 0, by tests,
    #: helices that end by a flat turn are profiles; larger: helices before clearing are the operation.
    LEADS = 0.25
    #: share of a piece. At the height where so much of it is level it lies, and the rest leads there or over tags. Less:
    #: rows on surfaces lie at plateaus; at 1 ramped contours lie nowhere. It changes no verdict.
    LEVEL = 0.75
    #: share of a piece. A height with less of it is no depth of a piece that lies at several. At 0 every plateau is one; at 1
    #: rows that are ramped into at several depths in one stroke lie nowhere.
    ONE_OF_SEVERAL = 0.3


class PIECES:
    """How pieces are measured."""

    #: moves. Where no piece has more, boxes are measured move by move: numpy takes as long to begin a piece as for so
    #: many moves. At 0 squares take longer; larger: nothing is gained. No result depends on it.
    FEW = 8


class PASSES:
    """Back and forth, or around."""

    #: cosine. A move so parallel to the axis of its stretch is part of a pass. At 0 links are passes, and the
    #: profile of a comb is a zigzag; at 1 ramps cut to and fro are strokes.
    ALONG = 0.9
    #: count. So few passes may be the strokes of a letter, as of N, W and Z, which lean. At 0 names are zigzags.
    OF_A_LETTER = 4
    #: cosine. So few are rows where they are as parallel as that to their axis. At 0 all are; at 1 ramps cut to and fro are
    #: letters.
    PARALLEL = 0.99
    #: share of the length of the passes. So much of them is. At 0 a letter with one upright stroke is a zigzag; at 1 rows
    #: whose links run along them are letters.
    SHARE = 0.8
    #: share of the length. A stretch goes back and forth where more of it lies between half-turns that alternate.
    #: At 1 zigzags with a piece of the boundary are mixed.
    ALTERNATING = 0.3
    #: ratio. And it is so many times as long as what lies between half-turns that do not. Less: grids are mixed.
    MORE = 2
    #: share of the length. The same of closed loops. At 0 the finishing pass of a pocket is taken for a zigzag; at 1
    #: zigzags that end where they began are loops.
    ALTERNATING_LOOP = 0.55


class WINDINGS:
    """What goes around several times without closing."""

    #: turns. A stretch with a larger net turn is a winding. Less: letters are; with no limit, spirals are profiles.
    TURN = 1.2
    #: turns. What is left of a winding behind its last turn is no ring where it turns by less. At 0 round pockets cut in a
    #: spiral of few turns are adaptive; at 1 nothing in windings moves along.
    WHOLE = 0.75
    #: share of the step. Turns at distances that differ by less are at one distance, as those of a spiral; to keep its
    #: engagement, a tool steps more the wider it winds. At 0 spirals that a helix leads into are adaptive; larger: adaptive
    #: clearing of round pockets is a spiral.
    EQUAL = 0.05
    #: turns. A winding that turns back by more in all is wavy, a stroke that does is no bite. At 0 smoothly linked
    #: offsets and sampled spirals are profiles.
    WAVERING = 0.5
    #: turns. A winding that turns back by more may be passes of a lattice. Larger: grids are mixed.
    BOUNCING = 0.75
    #: turns. A winding that turns by more against its sense steps aside to the next loop. Larger: smoothly linked
    #: offsets are spirals; at 0, by real code, spirals are linked offsets.
    ASIDE = 0.075
    #: rad mm. A bend may be made by rounding to 0.01 mm where angle times length is less. At 0 smoothly linked offsets
    #: are adaptive; larger: they are spirals.
    ROUGH = 0.05
    #: places. Adaptive clearing that keeps its engagement corrects its direction at so many places in a winding.
    #: Fewer: smoothly linked offsets are adaptive; more: by other parts that FreeCAD cut, such clearing is a pocket.
    CORRECTIONS = 8
    #: rad. And by no more than this at each, 10 degrees. Larger: links to the next loop are corrections.
    CORRECTION = 0.17453292519943295
    #: rad. Larger turns are corners, 30 degrees. At 0 spirals are all corners and contour-parallel; at pi, spirals of
    #: straight sides are spirals.
    CORNER = 0.5235987755982988


class SPURS:
    """Ways out and back on one line."""

    #: share of the area's length. Less in spurs are reliefs in corners. At 0 contours with such corners are adaptive;
    #: at 1 passes that go over themselves again are lost.
    LENGTH = 0.2


class TAGS:
    """What contours are lifted over."""

    #: cosine. Behind a gap a contour goes on ahead by this. At 1 circles with tags are strokes; at 0 what is cut around a
    #: corner goes on, too, if all that is cut so closes a contour.
    AHEAD = 0.9


class STROKES:
    """What is open and neither winds nor goes back and forth."""

    #: share of the strokes. Where fewer have different footprints, they are contours at other depths. At 0, by real
    #: code, such contours are engravings.
    DISTINCT = 0.67
    #: share of width and height of the part together. Strokes that are usually longer are contours. At 0 carved ones
    #: are; larger: the outlines that adaptive clearing leaves on thin stock are engravings.
    LONG = 0.35
    #: share of the length. Strokes along which more climbs to their ends are carved by a V-bit, which rises in corners. At 0
    #: contours that are left on a ramp are; at 1 long carved strokes are contours.
    RISING = 0.05


class LETTERS:
    """Closed contours that are letters, and not the outlines of parts and holes."""

    #: mm. Contours whose boxes and lengths differ by more have two shapes.
    SHAPE = 0.2
    #: count. So many contours of different shapes are letters. Fewer are those of parts.
    COUNT = 8
    #: depths. Letters are engraved at no more. Larger, by real code: pockets and parts of many shapes are letters.
    DEPTHS = 3
    #: share of the ground. They are usually no larger than this. At 1 the contours of plates are letters.
    SMALL = 0.15


class NESTS:
    """Rings that lie inside one another."""

    #: mm. Rings that lie closer are no neighbours. Larger: none are, and pockets are profiles.
    APART = 0.01
    #: tool diameters. Rings, rows and strokes farther apart leave ground uncut between them. Less: pockets are
    #: profiles; more: the contours of a washer, and of chamfered and engraved edges, are pockets.
    REACH = 1.2
    #: count. Offsets share no more sides of their boxes: pockets in a corner of the part are open at two. At 0, by
    #: tests, open pockets are profiles.
    SHARED = 2
    #: rings. Each is compared with so many that are cut after it. At 1 pockets with islands, around which the rings of
    #: two nests are cut in turn, are profiles; comparing with all takes time and gains nothing.
    NEXT = 3
    #: share of the mean. All sides of the box of a wavy ring, or of one that turns the other way, move by the same to
    #: this. Larger, by tests: passes of a lattice that wind by chance are nested.
    EQUAL_SIDES = 0.1
    #: ratio to the distance. A loop is longer than its offset inwards by less than this, or has bays; a circle is by
    #: 6.3, a square by 8. Larger, by tests: what is engraved around a letter is its offset.
    LONGER = 12.0
    #: share of the longer loop. Where bays close, the shorter loop still has as much. At 0 the lengths say nothing; at 1
    #: combs have no stepover.
    LENGTH_ALIKE = 0.6
    #: share of the distance. No side of an offset's box moves by less. At 0 ramped profiles are pockets; at 1
    #: waterlines are contour-parallel.
    SIDE_AT_LEAST = 0.5
    #: ratio to the distance. And not all sides by more. Less: nothing is nested; larger, by tests: grids are.
    SIDE_AT_MOST = 1.5
    #: share of the ring's size. Rings with a longer step between them are no nest. At 0 none are; larger: contours of
    #: three sizes at different depths are a pocket.
    LARGEST_STEP = 0.3
    #: share of the step. Steps that differ by less are the same step again. At 0 no nest has three rings, and without
    #: a tool pockets are profiles.
    SIMILAR_STEP = 0.3
    #: share of the largest ring. Without a tool, a step that is usually longer than this is none. At 0 pockets are
    #: profiles; larger: waterlines are pockets.
    TOO_LARGE = 0.2
    #: share of the largest ring. Without a tool and without three rings, two that lie farther apart are two contours.
    #: At 0 narrow pockets around an island are; larger: engraved contours are pockets.
    REACH_OF_SIZE = 0.05
    #: steps. The reach where no tool is known. At 1 linked offsets and spirals lose every other ring.
    STEPS = 2


class RINGS:
    """What rings are, and how many stand for the whole."""

    #: isoperimetric quotient 4 pi A / P^2. A ring above it is a circle; a square has 0.79. Less: ramped profiles are
    #: helices; at 1 helices in chords are profiles.
    ROUND = 0.93
    #: share of the drop. A ring descends all along where its mean height is so close to the middle of its drop. At 0
    #: no helix does; larger, with a tool: profiles that ramp in over their first moves are helices.
    STEADY = 0.2
    #: share of the rings' length. Circles that are less are part of other contours. Less: profiles with bores, ramped
    #: alike, are helices.
    ALL_ROUND = 0.85
    #: share of the zigzag's box. A loop surrounds a zigzag where no side lies farther inside than this. At 0 contours
    #: beside a zigzag are part of it; at 1 the small loops between its rows are contours.
    SURROUNDS = 0.15
    #: share of the length, and of the rings' length. So much in rings, and of these in nested ones, is offsets. At 0
    #: clipped spirals are adaptive; at 1 linked offsets are spirals.
    OFFSETS = 0.7
    #: share of the length. So much in rings is judged by them where there are hardly any rows, so much in rows by
    #: these. At 0 strokes are zigzags; at 1 waterlines and helices are profiles.
    ALONE = 0.35
    #: share of the length. Less in rows is none beside rings. Larger: rows and their contour are a profile; at 0, by real
    #: code, profiles are mixed.
    ROWS_BESIDE = 0.15
    #: share of the length. Less in rings is none among rows. At 0 every closed link of a zigzag is a contour.
    AMONG_ROWS = 0.1
    #: count. So many rings of a depth, the largest, may be the walls of its pockets. At 1 the pockets beside the largest
    #: one are mixed; more take longer.
    WALLS = 8
    #: share of the steps. Where more go inward, or outward, the nest is cut in that order and mills climb or
    #: conventional; otherwise neither is said. It changes no verdict.
    ONE_WAY = 0.75


class WATERLINES:
    """Contours that change with the depth."""

    #: depths. A waterline has at least so many. With no such depth, waterlines are profiles.
    DEPTHS = 3
    #: tool diameters. It goes deeper than this. At 0 deburred edges are pockets; larger: waterlines are profiles.
    RANGE = 0.35
    #: share of the rings' length. So much has a ring of another shape below or above. At 0 engraved contours do; at 1
    #: waterlines are profiles.
    DEEPER = 0.3
    #: ratio of spreads. Where the steps in the plane spread by less than this of those in depth, the plane is divided
    #: and not the depth: circles on a dome. At 0 these are waterlines; larger: waterlines are contour-parallel.
    EVENER = 0.5
    #: relative spread. Two spreads that are both smaller are equal: rounding left them. At 0, by tests, a waterline
    #: that is turned or scaled is contour-parallel.
    ROUNDING = 0.01
    #: depths. So many of open contours are a waterline. Less: letters and open profiles are; more: waterlines cut open
    #: by the stock are engravings.
    OPEN_DEPTHS = 4
    #: share of the length. Where more of open contours is sloped, they are none. At 0 no waterline is open; at 1, by
    #: real code, V-carving is one.
    SLOPED = 0.2


class TROCHOIDS:
    """Loops of one size that move along."""

    #: share of the rings' length. So much in loops that move along is trochoids. At 0 contours that overlap are;
    #: larger: adaptive clearing that is not lifted is a profile.
    SHARE = 0.4
    #: share of the range. They move aside: some sides of their boxes move one way, some the other, in the mean by less
    #: than this. At 0 none do.
    SWAY = 0.35
    #: share of the smaller loop. They move by no more. At 0 none do, and trochoids are profiles.
    STEP = 1.2
    #: share of the larger loop. The smaller one is no smaller. At 1 no two are of one size.
    SIZE = 0.65


class ROWS:
    """Parallel passes side by side."""

    #: directions in half a turn. The densest direction is looked for among so many. At 1 grids have no axis.
    DIRECTIONS = 64
    #: values. So many are enough for a median, and for the lines of a family. At 1 zigzags are engravings; taking all
    #: takes time and gains nothing.
    SAMPLE = 1000
    #: rad. A move this close to the axis belongs to a row. At 0 rows of sampled moves break up; larger: bites are rows.
    ALIGNED = 0.05
    #: share of the length. Where less keeps to the mean axis, there are several. At 0 grids have one, between theirs.
    ONE_AXIS = 0.8
    #: share of the length. Where less does, the links have turned the axis, and it is taken again without them. At 0
    #: zigzags along a slanting boundary are profiles.
    ALL_ALIGNED = 0.98
    #: usual steps. A row's neighbour is no farther away. Less: no row has one, and rows cut one way are offsets.
    FARTHER = 1.6
    #: usual steps. Steps are even where they are no shorter. Larger: none are, and rows cut one way are offsets.
    NEARER = 0.6
    #: share. The shortest distance that comes nearly as often as any. At 1 twice the stepover may be it; at 0 the next set is.
    OFTEN = 0.8
    #: share of the pitch. Gaps that differ by less are one gap. At 0 zigzags that end where they began are walls; larger:
    #: lattices whose lines lie nearly evenly have half their stepover.
    SAME_GAP = 0.02
    #: lines. Lines come again after so many others at most. At 1 all are evenly spaced, and zigzags that end where they
    #: began are walls; more: nothing is gained.
    SETS = 12
    #: pitches. No stepover is larger: two sets may nearly lie on one another. Less: those of lattices are wrong; larger: pockets
    #: that lie far apart take memory.
    FARTHEST = 1000
    #: share of the length. Where less has a neighbour, passes are no rows. At 0 adaptive clearing and waterlines have
    #: some; at 1 rows cut one way are offsets.
    BESIDE = 0.25
    #: steps. Rows are longer. At 0 the sides of small contours are rows; larger: grids are engravings.
    LONG = 2.5
    #: steps. Many even rows are longer than this. Larger: zigzags in narrow teeth are profiles.
    LONG_IF_MANY = 1.5
    #: lines. So many rows are many. At infinity zigzags in narrow teeth are profiles.
    MANY = 10
    #: share of the steps. Where more are even, many rows are even. At 1 zigzags in narrow teeth are profiles.
    EVEN = 0.8
    #: tool diameters. Passes that lie closer are one pass retraced. At 0, with a tool, ramped profiles are mixed.
    RETRACED = 0.03
    #: pitches. Rows of a contour that come again only after more than this are the walls of its teeth. Less: zigzags
    #: that end where they began are profiles; larger, by tests: combs are zigzags.
    WALLS = 1.05
    #: steps. Rows farther apart than the tool reaches leave no more to others that are cut later. At 1 rows that are cut in two
    #: goes are engravings; larger: passes along both sides of what is left are rows.
    LEFT_BETWEEN = 3
    #: share of the length. Two families of rows with more of it are a grid. At 0 waterlines and adaptive clearing are;
    #: at 1 grids are engravings.
    GRID = 0.85
    #: count. Of each family so many passes are looked at for whether they cross. At 1 grids are engravings; more takes longer.
    CROSSING = 100
    #: share of its length. What crosses a pass nearer to its end meets it in a corner. At 0 the sides of nested contours cross;
    #: at 0.5 nothing does.
    END = 0.05


class ARCS:
    """Open strokes around one centre."""

    #: cosine. A move at so right an angle to the ray from the centre lies on a circle around it. At 0 circles that the
    #: boundary cuts open are engravings; at 1 open waterlines are spirals.
    SQUARE = 0.15
    #: share of the squared length. Moves that are more alike in direction have no centre. At 0 that of straight rows is
    #: divided by 0; at 1 clipped circles have none.
    STRAIGHT_ROWS = 0.01
    #: share of the length. A stroke of which more lies on the circle is an arc. At 0 open waterlines are spirals.
    ARC = 0.9
    #: steps. Radii that differ by more are two. At 0 the outlines that adaptive clearing leaves on thin stock have
    #: many.
    RADIUS = 0.3
    #: steps. An arc whose radius changes by more in a turn is part of a spiral. At 0 clipped circles are; larger:
    #: adaptive clearing from a centre is contour-parallel.
    DRIFT = 0.3


class NEIGHBOURS:
    """Open strokes that lie side by side."""

    #: count. Each stroke is looked at in so many points. At 2 all strokes are straight; more takes time and gains nothing.
    POINTS = 12
    #: share of the points. More of a stroke's points lie beside its neighbour. At 0 letters lie side by side.
    FACING = 0.6
    #: usual steps. A neighbour is no farther away. At 0 there are none.
    FARTHER = 3
    #: share of the step. An offset's distance varies by less. At 0 open offsets are adaptive; larger: passes of adaptive
    #: clearing are offsets.
    EVEN = 0.3
    #: share of the length. Adaptive clearing mills one way: so much runs the same way as its neighbour. Less, by real
    #: code: offsets that an open side cuts are adaptive.
    ONWARD = 0.9
    #: share of the length. So much in neighbours fills an area. At 1 nothing open does; less: letters do.
    SHARE = 0.7


class BITES:
    """The arcs that an adaptive tool bites out of the stock one after the other."""

    #: turns. A stroke that bends by more may be one. Larger: none is, and adaptive clearing is a spiral or engraving.
    BENT = 0.25
    #: share of the length. So much in bites is adaptive. At 0, by real code, spirals and profiles are; at 1 nothing is.
    SHARE = 0.1
    #: bites. And so many. At 1 V-carving and circles that are cut open are; twice as many: small adaptive clearing is
    #: a spiral.
    COUNT = 10
    #: share of the bites. Where more bends the other way, they are letters. At 1 these are adaptive; at 0 nothing is.
    AGAINST = 0.3


class ADAPTIVE:
    """What else tells adaptive clearing from a spiral or a helix that clears a pocket."""

    #: share of the length. A winding with so much in bites clears corners. At 1, by other parts that FreeCAD cut, such
    #: clearing is a spiral.
    BITES = 0.03
    #: share of the length. A winding with so much in a helix was entered by it. At 1, by real code, adaptive clearing
    #: is a spiral.
    ENTRY = 0.005
    #: share of the length. A winding that leaves so much to open strokes is no spiral. At 0 spirals are adaptive; at 1,
    #: by tests, clearing of which a third is open strokes is a spiral.
    STROKES = 0.3


class POCKET:
    """A ring that is cleared inside by an open stroke: the narrowest pocket with a finishing pass."""

    #: share of the length. So much in strokes inside rings clears them. At 0, by real code, engraved contours are
    #: mixed.
    FILLED = 0.1
    #: ratio. Strokes that enclose no more than this of what the ring does, both for their length. Larger, by real code:
    #: contours inside contours are mixed.
    WIDTH = 0.75


class PARTS:
    """Where a program is divided, and when that makes it mixed."""

    #: borders. More are no operations, and each section takes its time. At 1 boards and programs are one operation.
    BORDERS = 200
    #: share of the areas. Fewer holes beside the milling are passes clipped to a point. At 1 boards are profiles.
    DRILLED = 0.25
    #: depths. Where there are more, heights are those of a surface. Less: boards engraved at a few depths are.
    DEPTHS = 10
    #: depths. Plunges to so many depths, all of which are milled, too, are what is left of contours. At 1 holes drilled as
    #: deep as a pocket are; larger: waterlines on gentle slopes are mixed.
    LAYERS = 2
    #: share of the length. Sections that differ and are less do not make it mixed, unless another tool cuts them. At 0
    #: rasters on surfaces and circuits with a hole are.
    ASIDE = 0.05
    #: share of the length. Behind a border that is certain, so much does. At 1 short zigzags before a profile are lost.
    CERTAIN = 0.001
    #: count. A section with fewer passes and hardly a loop is too little to show a strategy. At 0 rows and rings on surfaces
    #: are profiles.
    PASSES = 3
    #: count. Two strategies that meet so often at retracts in doubt take turns within one operation. At 1 all do, and a
    #: pocket with another pattern behind it is one.
    TURNS = 3
    #: share of the size. A contour whose box differs by less on every side from that of what is cleared finishes its
    #: walls. At 0 none does, and rows with a contour around them are mixed; larger: by real code, nothing changes.
    AROUND = 0.05
    #: count. So many loops in one another may be two walls that are finished. At 0 only those that are none in one another
    #: are; larger: pockets cut behind another clearing are its finishing pass.
    WALLS = 2


class VISITS:
    """Which retracts begin another operation; how that was learned, benchmarks/learn_borders.py tells."""

    #: share of the votes. So many say that another operation begins. At 0 every visit does, and pockets are mixed; at 1
    #: none does, and a zigzag with a profile behind it is one.
    BORDER = 0.3
    #: share of the votes. Where fewer say so, but more than this, the verdicts on both sides count, too. At 1 none
    #: does, and a pocket with another pattern behind it is one.
    DOUBTFUL = 0.03
    #: ratio. The odds by the votes, times the odds that both verdicts are right where they differ. Above it another
    #: operation begins. At 0 every retract in doubt with two names beside it is a border, and pockets are mixed.
    DIFFER = 0.6
    #: share of the votes. Where more say so, even a contour around what was cleared before is another operation.
    SURE = 0.5
    #: visits. So many before are looked at for ground that is cut again. At 1 only neighbours are; more gains little.
    EARLIER = 8
    #: visits. More sections are no operations, and each takes its time. At 1 most programs are one.
    MOST = 60
    #: count. So many times what lies between two borders is divided in turn. At 0 operations between two tool changes
    #: are one where the tool is changed higher up; larger: stairs of retracts take long.
    NESTED = 4
    #: share of the length. A block whose ends lie closer together is closed, as the measure says.
    CLOSED = 0.03
    #: share of the size. Visits whose boxes differ by less on every side cover the same ground, as the measure says.
    PLACE = 0.01
    #: share. Feeds that differ by less are one feed, as the measure says.
    FEED = 0.01
    #: mm. What is smaller counts as so large, that a hole has a size.
    SMALL = 0.05


class LATHE:
    """What tells a lathe's toolpath in X and Z from a mill's."""

    #: count. A lathe's passes along Z lie at so many X at least. At 1 a slot is turned.
    PASSES = 3
    #: ratio. They are so much longer than what is cut along X. At 0 a row of slots is turned; larger: short bolts are
    #: profiles.
    LONGER = 1.5


class MEASURED:
    """How much of a section its measures look at; the trees were learned with these."""

    #: moves. So many, evenly among all, are enough for what is a share of the length.
    MOVES = 1000
    #: moves. So many, from the middle of the time, are enough for how turns follow one another.
    TURNS = 2000
    #: rad. Turns that are smaller are none.
    TURN = 1e-4
    #: turns. Where phi ranges over less in an area, the area goes to and fro.
    HALF_TURN = 0.51
    #: turns. The net turn of a closed area without its closing turn, that goes around once: all but the last corner.
    ONE_TURN = (0.6, 1.3)
    #: share of the length. Where V_k of the last trajectory is shorter, the area is closed, as the measure says.
    CLOSED = 0.02
    #: turns. An arc of the Gauss map that is so near to a half turn is one, as where rows alternate.
    HALF = 0.1
    #: turns. A shorter arc is a bend.
    SHORT = 0.3
    #: turns. A longer arc goes around.
    LONG = 0.75
    #: count. Kinds of turns that are told apart, from none to an exact reversal.
    TURNS_BY = 12
    #: rings. So many are enough for their shares.
    RINGS = 500
    #: ratio. The evenness of rings in the plane counts no more than this.
    EVENNESS = 1000


class SCAN:
    """Scan lines across a section; the trees were learned with these."""

    #: lines. So many at most; more take time and gain nothing.
    LINES = 12
    #: share of the length. So much lies outside all lines, on either side: leads and remnants.
    EDGE = 0.04
    #: places. So many crossings are enough.
    ENOUGH = 1200
    #: ratio. The sine of the angle at which a move crosses a line; at a smaller one it lies along it.
    GRAZING = 0.3
    #: mm. Crossings whose heights differ by less are at one depth.
    DEPTH = 0.05
    #: ratio. Neighbours are parallel where the sine of the angle between them is smaller.
    PARALLEL = 0.35
    #: ratio. Distances whose logarithms differ by less are one distance, where the usual one is looked for.
    BIN = 0.2
    #: share of the usual distance. Neighbours at a distance that differs by less are at the usual one.
    EVEN = 0.3


class VOTES:
    """How the votes of the trees and the rules come to a verdict, and how sure that is."""

    #: share of the votes. The rules count as so many. At 0 the trees alone decide, and operations of FreeCAD that the
    #: rules know are lost; at 1 the rules alone do, and real code that has no part in them is.
    RULES = 0.5
    #: share of the votes. Where no tool is known, many of the rules have nothing to measure by. As much as with a tool:
    #: real code that names none is judged by rules that guess.
    RULES_WITHOUT_TOOL = 0.1
    #: share of the votes. As much, for a helix, which the rules find without a tool by its one pitch, and adaptive clearing,
    #: by its bites; a spiral, which only itself looks like, counts as with a tool. At 0.1 bores of few turns are profiles; at
    #: 1 whatever descends evenly is a bore.
    RULES_THAT_NEED_NO_TOOL = 0.25
    #: ratio. So much counts the share of the whole class, rows or around, beside that of the strategy. At 0 a class can
    #: lose whose votes are split among its strategies; larger: the class decides alone.
    CLASS = 0.6
    #: share of the votes. The rules count as so many for the class. At 0 only trees speak for it.
    RULES_OF_CLASS = 0.3
    #: share of the votes. Where no tool is known, the paper's rule to the letter counts as so many for the class it
    #: tells. At 0 it is right more often than we are; at 1 adaptive clearing is offsets.
    LETTER = 0.4
    #: share of the votes. Where more say that a section is like nothing that machines, it is unknown. At 1 random walks are
    #: machining; at 0 engravings are nonsense.
    NONSENSE = 0.5
    #: share of the length. Where more is in loops, with an area inside, it is no nonsense. Less: scribbles are contours; at 1
    #: gears and snowflakes cut at one depth are nonsense.
    LOOPS = 0.95
    #: isoperimetric quotient, 4 pi area / length^2. Loops have an area inside where it is larger. At 0 curves that close after
    #: they have filled the plane are contours; at 1 gears and snowflakes cut at one depth are nonsense.
    ROUNDNESS = 0.06
    #: share of the votes. No share counts as fewer or more but for this, that its odds are finite.
    NONE = 0.02
    #: confidence. No verdict is surer: of the surest on programs that nobody here has made, one in a hundred is wrong.
    SUREST = 0.99
