# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reasons for strategies, in the paper's terms."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

RECOGNITION: dict[str, str | tuple[str, str]] = {
    "rows": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi stays between {low:turns} and {high:turns} turns over {count:n} "
            "rows{spread}, {seen}: {strategy:strategy}.",
        ),
    ),
    "rows-at-0": (
        QT_TRANSLATE_NOOP("Sentences", "Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}."),
        QT_TRANSLATE_NOOP("Sentences", "Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}."),
    ),
    "strokes": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi stays between {low:turns} and {high:turns} turns over one open "
            "stroke{spread}, {seen}: {strategy:strategy}.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi stays between {low:turns} and {high:turns} turns over {count:n} open "
            "strokes{spread}, {seen}: {strategy:strategy}.",
        ),
    ),
    "strokes-at-0": (
        QT_TRANSLATE_NOOP("Sentences", "Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}."),
        QT_TRANSLATE_NOOP(
            "Sentences", "Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}."
        ),
    ),
    "loops": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.",
        ),
    ),
    "between": QT_TRANSLATE_NOOP(
        "Sentences", "Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}."
    ),
    "vertical": (
        QT_TRANSLATE_NOOP(
            "Sentences", "Phi is not defined, because the moves are vertical at one point: {strategy:strategy}."
        ),
        QT_TRANSLATE_NOOP(
            "Sentences", "Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}."
        ),
    ),
    "vertical-somewhere": QT_TRANSLATE_NOOP(
        "Sentences", "Phi is not defined, because the moves are vertical at some points: {strategy:strategy}."
    ),
    "sections": QT_TRANSLATE_NOOP(
        "Sentences",
        "{count:n} sections, separated by tool changes, titles, retracts or drilling, "
        "show {strategies:strategy}: {strategy:strategy}.",
    ),
    "with-others": QT_TRANSLATE_NOOP("Sentences", "{told} A small part is {strategies:strategy}."),
    "only-rapids": QT_TRANSLATE_NOOP("Sentences", "No move cuts, because there are only rapid moves."),
    "no-moves": QT_TRANSLATE_NOOP("Sentences", "No move cuts, because there are no moves."),
    # Parts of sentences: distances and directions of rows, strokes or loops.
    "apart-at-depths": QT_TRANSLATE_NOOP("Sentences", ", {step:mm3} apart at {depths:n} depths"),
    "apart": QT_TRANSLATE_NOOP("Sentences", ", {step:mm3} apart"),
    "at-depths": QT_TRANSLATE_NOOP("Sentences", " at {depths:n} depths"),
    "counter-clockwise": QT_TRANSLATE_NOOP("Sentences", ", counter-clockwise"),
    "clockwise": QT_TRANSLATE_NOOP("Sentences", ", clockwise"),
    # Entries and finishing passes, which follow the sentence about the pattern.
    "with-layers": "{told}{entry}{finishing}",
    "entered-by-ramp": QT_TRANSLATE_NOOP("Sentences", " The tool enters on a ramp."),
    "entered-by-zigzag-ramp": QT_TRANSLATE_NOOP("Sentences", " The tool enters on a ramp that goes back and forth."),
    "entered-by-helix": QT_TRANSLATE_NOOP("Sentences", " The tool enters on a helix."),
    "finished-by-contour": QT_TRANSLATE_NOOP("Sentences", " A contour around the rows finishes the area."),
    "finished-by-loop": QT_TRANSLATE_NOOP("Sentences", " A closed contour finishes the walls."),
    "like-a-lathe": QT_TRANSLATE_NOOP(
        "Sentences", "All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}."
    ),
    # Parts of sentences: measured evidence for the strategy.
    "bites-overlap": QT_TRANSLATE_NOOP("Sentences", "{count:n} engagements in the same direction overlap"),
    "rows-and-loops": QT_TRANSLATE_NOOP(
        "Sentences", "rows ({rows:%} of the length) and loops ({loops:%}) fill the same area"
    ),
    "constant-radius": QT_TRANSLATE_NOOP("Sentences", "descending at a constant radius"),
    "constant-radius-up": QT_TRANSLATE_NOOP("Sentences", "climbing at a constant radius"),
    "sense-alternates": QT_TRANSLATE_NOOP("Sentences", "the direction of nested loops alternates"),
    "even-in-plane": QT_TRANSLATE_NOOP("Sentences", "evenly spaced in the plane, not in depth"),
    "shape-changes": QT_TRANSLATE_NOOP("Sentences", "with a shape that changes with the depth"),
    "winding-with-entry": QT_TRANSLATE_NOOP(
        "Sentences", "a winding with a helical entry or with extra cuts in the corners"
    ),
    "endless-winding": QT_TRANSLATE_NOOP("Sentences", "one winding that never closes"),
    "nested": QT_TRANSLATE_NOOP("Sentences", "nested"),
    "not-nested": QT_TRANSLATE_NOOP("Sentences", "no nested offsets"),
    "partly-nested": QT_TRANSLATE_NOOP("Sentences", "only {share:%} of their length nested"),
    "in-strokes": QT_TRANSLATE_NOOP("Sentences", "cut in strokes, as between holding tags"),
    "loops-move": QT_TRANSLATE_NOOP("Sentences", "small loops that advance along the path"),
    "pass-inside": QT_TRANSLATE_NOOP("Sentences", "an open pass lies inside a contour"),
    "half-turns-alternate": QT_TRANSLATE_NOOP("Sentences", "half-turns alternate in sign"),
    "same-way": QT_TRANSLATE_NOOP("Sentences", "all rows run the same way"),
    "open-contours-change": QT_TRANSLATE_NOOP("Sentences", "open contours change with the depth"),
    "one-open-contour": QT_TRANSLATE_NOOP("Sentences", "one open contour"),
    "open-contour-again": QT_TRANSLATE_NOOP("Sentences", "an open contour is repeated"),
    "open-offsets": QT_TRANSLATE_NOOP("Sentences", "open strokes side by side at an even distance"),
    "open-passes": QT_TRANSLATE_NOOP("Sentences", "open strokes side by side, from one wall to the other"),
    "many-shapes": QT_TRANSLATE_NOOP("Sentences", "many small contours of different shapes"),
    "long-strokes": QT_TRANSLATE_NOOP("Sentences", "open strokes as long as the part"),
    "rising-strokes": QT_TRANSLATE_NOOP("Sentences", "strokes that rise toward their ends, as in V-carving"),
    "short-strokes": QT_TRANSLATE_NOOP("Sentences", "short strokes that do not fill an area"),
    # Parts of sentences: evidence from the votes of the learned decision trees.
    "like-others": QT_TRANSLATE_NOOP("Sentences", "arranged as in known toolpaths ({share:%} of the votes)"),
    "like-nothing": QT_TRANSLATE_NOOP("Sentences", "unlike any known machining ({share:%} of the votes)"),
}
