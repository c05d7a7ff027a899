# SPDX-License-Identifier: LGPL-2.1-or-later
"""What could not be used of an operation's commands."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

COMMANDS: dict[str, str | tuple[str, str]] = {
    "in-commands": (
        QT_TRANSLATE_NOOP("Sentences", "{sentence} (command {command:#})"),
        QT_TRANSLATE_NOOP("Sentences", "{sentence} ({count:n} times, first at command {command:#})"),
    ),
    "words-without-motion": QT_TRANSLATE_NOOP("Sentences", "words without a motion before them are ignored"),
    "unusable-feed": QT_TRANSLATE_NOOP("Sentences", "a feed rate that is not a usable number is ignored"),
    "unusable-centre": QT_TRANSLATE_NOOP("Sentences", "center words (I, J, K) that are not usable numbers are ignored"),
    "unusable-word": QT_TRANSLATE_NOOP("Sentences", "{letter} words that are not usable numbers are ignored"),
    "position-cut-off": QT_TRANSLATE_NOOP("Sentences", "positions beyond a kilometer are cut off there"),
    "cycle-without-depth": QT_TRANSLATE_NOOP("Sentences", "a drilling cycle without a depth (Z) drills nothing"),
    "cycle-without-retract": QT_TRANSLATE_NOOP("Sentences", "a drilling cycle without R starts at the current height"),
    "cycle-outside-xy": QT_TRANSLATE_NOOP("Sentences", "a drilling cycle outside the XY plane is read as one in XY"),
    "arc-before-start": QT_TRANSLATE_NOOP("Sentences", "an arc whose start is not known is ignored"),
    "arc-as-line": QT_TRANSLATE_NOOP("Sentences", "an arc without a usable center or radius is read as a line"),
    "arc-of-changing-radius": QT_TRANSLATE_NOOP(
        "Sentences", "an arc whose end is not on its circle is read with a changing radius"
    ),
    "absolute-centres": QT_TRANSLATE_NOOP(
        "Sentences", "the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles"
    ),
    "unknown-code": QT_TRANSLATE_NOOP("Sentences", "the unknown code {name} is ignored"),
    "unknown-code-with-words": QT_TRANSLATE_NOOP(
        "Sentences", "the unknown code {name} is ignored, and with it the {letters} words of its line"
    ),
    "more-unknown-codes": (
        QT_TRANSLATE_NOOP("Sentences", "1 more unknown code is ignored"),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} more unknown codes are ignored"),
    ),
    # What a machine understands and is not read here.
    "rotary-cuts": QT_TRANSLATE_NOOP(
        "Sentences", "a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told"
    ),
    "rotary-not-read": QT_TRANSLATE_NOOP("Sentences", "turns of a rotary axis ({letter}) are not followed"),
    "word-not-read": QT_TRANSLATE_NOOP("Sentences", "{letter} words are not read"),
    "repeats-not-read": QT_TRANSLATE_NOOP("Sentences", "a cycle's repeats ({letter}) are not made"),
    "turns-not-read": QT_TRANSLATE_NOOP("Sentences", "further turns of an arc (P) are not made"),
    "inches-not-read": QT_TRANSLATE_NOOP("Sentences", "inches (G20) are not followed: lengths are read in mm"),
    "compensation-not-read": QT_TRANSLATE_NOOP(
        "Sentences", "cutter compensation ({name}) is not followed: the path is the programmed one"
    ),
    "feed-mode-not-read": QT_TRANSLATE_NOOP("Sentences", "feeds after {name} are not read"),
    "dwell-untimed": QT_TRANSLATE_NOOP("Sentences", "dwells are not in the time"),
    "probing-untimed": QT_TRANSLATE_NOOP("Sentences", "probing moves are not in the time"),
    "too-many-moves": QT_TRANSLATE_NOOP(
        "Sentences",
        "the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance",
    ),
}
