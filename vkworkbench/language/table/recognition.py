# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why an operation has its strategy, in the paper's terms."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

RECOGNITION: dict[str, str | tuple[str, str]] = {
    "rows": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: "
            "{strategy:strategy}",
        ),
    ),
    "rows-at-0": (
        QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}"),
        QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}"),
    ),
    "strokes": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: "
            "{strategy:strategy}",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: "
            "{strategy:strategy}",
        ),
    ),
    "strokes-at-0": (
        QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}"),
        QT_TRANSLATE_NOOP(
            "Sentences", "phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}"
        ),
    ),
    "loops": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}",
        ),
    ),
    "between": QT_TRANSLATE_NOOP(
        "Sentences", "phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}"
    ),
    "vertical": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}",
        ),
    ),
    "vertical-somewhere": QT_TRANSLATE_NOOP(
        "Sentences", "phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}"
    ),
    "sections": QT_TRANSLATE_NOOP(
        "Sentences",
        "{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: "
        "{strategy:strategy}",
    ),
    "with-others": QT_TRANSLATE_NOOP("Sentences", "{told}, with a little {strategies:strategy} beside it"),
    "only-rapids": QT_TRANSLATE_NOOP("Sentences", "nothing cuts: there are only rapid moves"),
    "no-moves": QT_TRANSLATE_NOOP("Sentences", "nothing cuts: there are no moves"),
    # How the rows, strokes or loops lie.
    "apart-at-depths": QT_TRANSLATE_NOOP("Sentences", ", {step:mm3} apart at {depths:n} depths"),
    "apart": QT_TRANSLATE_NOOP("Sentences", ", {step:mm3} apart"),
    "at-depths": QT_TRANSLATE_NOOP("Sentences", " at {depths:n} depths"),
    "counter-clockwise": QT_TRANSLATE_NOOP("Sentences", ", counter-clockwise"),
    "clockwise": QT_TRANSLATE_NOOP("Sentences", ", clockwise"),
    # The layers beside the pattern.
    "with-layers": "{told}{entry}{finishing}",
    "entered-by-ramp": QT_TRANSLATE_NOOP("Sentences", ", entered by a ramp"),
    "entered-by-zigzag-ramp": QT_TRANSLATE_NOOP("Sentences", ", entered by a ramp to and fro"),
    "entered-by-helix": QT_TRANSLATE_NOOP("Sentences", ", entered by a helix"),
    "finished-by-contour": QT_TRANSLATE_NOOP("Sentences", ", finished by a contour around the rows"),
    "like-a-lathe": QT_TRANSLATE_NOOP(
        "Sentences",
        "moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}",
    ),
    # What shows the strategy.
    "bites-overlap": QT_TRANSLATE_NOOP("Sentences", "{count:n} bites of one sense overlap"),
    "rows-and-loops": QT_TRANSLATE_NOOP(
        "Sentences", "rows ({rows:%} of the length) and loops ({loops:%}) share the area"
    ),
    "constant-radius": QT_TRANSLATE_NOOP("Sentences", "descending at a constant radius"),
    "sense-alternates": QT_TRANSLATE_NOOP("Sentences", "the sense of nested loops alternates"),
    "even-in-plane": QT_TRANSLATE_NOOP("Sentences", "evenly spaced in the plane, not in depth"),
    "shape-changes": QT_TRANSLATE_NOOP("Sentences", "whose shape changes with the depth"),
    "winding-with-entry": QT_TRANSLATE_NOOP("Sentences", "a winding with a helical entry or bites out of the corners"),
    "endless-winding": QT_TRANSLATE_NOOP("Sentences", "one winding that never closes"),
    "nested": QT_TRANSLATE_NOOP("Sentences", "nested"),
    "not-nested": QT_TRANSLATE_NOOP("Sentences", "no nested offsets"),
    "in-strokes": QT_TRANSLATE_NOOP("Sentences", "cut in strokes, as between tags"),
    "loops-move": QT_TRANSLATE_NOOP("Sentences", "small loops move along"),
    "pass-inside": QT_TRANSLATE_NOOP("Sentences", "an open pass lies inside a contour"),
    "half-turns-alternate": QT_TRANSLATE_NOOP("Sentences", "half-turns alternate in sign"),
    "same-way": QT_TRANSLATE_NOOP("Sentences", "all rows run the same way"),
    "open-contours-change": QT_TRANSLATE_NOOP("Sentences", "open contours change with the depth"),
    "one-open-contour": QT_TRANSLATE_NOOP("Sentences", "one open contour"),
    "open-contour-again": QT_TRANSLATE_NOOP("Sentences", "an open contour comes again"),
    "open-offsets": QT_TRANSLATE_NOOP("Sentences", "open strokes side by side at an even distance"),
    "open-passes": QT_TRANSLATE_NOOP("Sentences", "open strokes side by side, from one wall to the other"),
    "many-shapes": QT_TRANSLATE_NOOP("Sentences", "many small contours of different shapes"),
    "long-strokes": QT_TRANSLATE_NOOP("Sentences", "open strokes as long as the part"),
    "rising-strokes": QT_TRANSLATE_NOOP("Sentences", "strokes that rise to their ends, as V-carving does"),
    "short-strokes": QT_TRANSLATE_NOOP("Sentences", "short strokes that fill nothing"),
    # What the votes of learned trees say against the rules.
    "like-others": QT_TRANSLATE_NOOP("Sentences", "which lie like those of known toolpaths ({share:%} of the votes)"),
    "like-nothing": QT_TRANSLATE_NOOP("Sentences", "unlike anything that machines ({share:%} of the votes)"),
}
