# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about strategies in a machinist's words: some codes of recognition.py without the paper's terms.

A key is the code of a message, or that code followed by the code of its argument ``seen``.
"""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

_ROWS = (
    QT_TRANSLATE_NOOP("Sentences", "{count:n} row{spread}, {seen}."),
    QT_TRANSLATE_NOOP("Sentences", "{count:n} rows{spread}, {seen}."),
)
_STROKES = (
    QT_TRANSLATE_NOOP("Sentences", "One open cut{spread}, {seen}."),
    QT_TRANSLATE_NOOP("Sentences", "{count:n} open cuts{spread}, {seen}."),
)
_BITES = QT_TRANSLATE_NOOP("Sentences", "{seen}{spread}.")

PLAIN: dict[str, str | tuple[str, str]] = {
    "rows": _ROWS,
    "rows-at-0": _ROWS,
    "strokes": _STROKES,
    "strokes-at-0": _STROKES,
    "strokes bites-overlap": _BITES,
    "strokes-at-0 bites-overlap": _BITES,
    "loops": (
        QT_TRANSLATE_NOOP("Sentences", "One loop{spread}{turning}, {seen}."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} loops{spread}{turning}, {seen}."),
    ),
    "loops bites-overlap": _BITES,
    "between": QT_TRANSLATE_NOOP("Sentences", "{seen}."),
    "vertical": (
        QT_TRANSLATE_NOOP("Sentences", "Straight down at one point."),
        QT_TRANSLATE_NOOP("Sentences", "Straight down at {count:n} points."),
    ),
    "vertical-somewhere": QT_TRANSLATE_NOOP("Sentences", "Straight down at some points."),
    "sections": QT_TRANSLATE_NOOP(
        "Sentences",
        "{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.",
    ),
    "bites-overlap": QT_TRANSLATE_NOOP("Sentences", "{count:n} overlapping engagements"),
    "sense-alternates": QT_TRANSLATE_NOOP("Sentences", "one clockwise, the next counter-clockwise"),
    "endless-winding": QT_TRANSLATE_NOOP("Sentences", "all in one continuous cut that never closes"),
    "nested": QT_TRANSLATE_NOOP("Sentences", "one inside the other"),
    "not-nested": QT_TRANSLATE_NOOP("Sentences", "none inside another"),
    "half-turns-alternate": QT_TRANSLATE_NOOP("Sentences", "cut back and forth"),
    "same-way": QT_TRANSLATE_NOOP("Sentences", "all cut in the same direction"),
}
