# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation does in a machinist's words: the same messages as in recognition.py, without the paper's terms.

A key is a code, or a code and that of what is seen, where both together are said otherwise.
"""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

_ROWS = (
    QT_TRANSLATE_NOOP("Sentences", "{count:n} row{spread}, {seen}"),
    QT_TRANSLATE_NOOP("Sentences", "{count:n} rows{spread}, {seen}"),
)
_STROKES = (
    QT_TRANSLATE_NOOP("Sentences", "one open cut{spread}, {seen}"),
    QT_TRANSLATE_NOOP("Sentences", "{count:n} open cuts{spread}, {seen}"),
)
_BITES = "{seen}{spread}"

PLAIN: dict[str, str | tuple[str, str]] = {
    "rows": _ROWS,
    "rows-at-0": _ROWS,
    "strokes": _STROKES,
    "strokes-at-0": _STROKES,
    "strokes bites-overlap": _BITES,
    "strokes-at-0 bites-overlap": _BITES,
    "loops": (
        QT_TRANSLATE_NOOP("Sentences", "one loop{spread}{turning}, {seen}"),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} loops{spread}{turning}, {seen}"),
    ),
    "loops bites-overlap": _BITES,
    "between": "{seen}",
    "vertical": (
        QT_TRANSLATE_NOOP("Sentences", "straight down at one point"),
        QT_TRANSLATE_NOOP("Sentences", "straight down at {count:n} points"),
    ),
    "vertical-somewhere": QT_TRANSLATE_NOOP("Sentences", "straight down at some points"),
    "sections": QT_TRANSLATE_NOOP(
        "Sentences",
        "{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}",
    ),
    "bites-overlap": QT_TRANSLATE_NOOP("Sentences", "{count:n} overlapping bites"),
    "sense-alternates": QT_TRANSLATE_NOOP("Sentences", "one clockwise, the next counter-clockwise"),
    "endless-winding": QT_TRANSLATE_NOOP("Sentences", "all in one cut that winds on and never closes"),
    "nested": QT_TRANSLATE_NOOP("Sentences", "one inside the other"),
    "not-nested": QT_TRANSLATE_NOOP("Sentences", "none inside another"),
    "half-turns-alternate": QT_TRANSLATE_NOOP("Sentences", "cut to and fro"),
    "same-way": QT_TRANSLATE_NOOP("Sentences", "all cut the same way"),
}
