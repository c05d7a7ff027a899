# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about commands that the add-on ignores, or reads differently than the machine's control would."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

COMMANDS: dict[str, str | tuple[str, str]] = {
    "in-commands": (
        QT_TRANSLATE_NOOP("Sentences", "Command {command:#}: {sentence}"),
        QT_TRANSLATE_NOOP("Sentences", "Command {command:#} (first of {count:n}): {sentence}"),
    ),
    "words-without-motion": QT_TRANSLATE_NOOP("Sentences", "Words without a motion before them are ignored."),
    "unusable-feed": QT_TRANSLATE_NOOP("Sentences", "A feed rate that is not a usable number is ignored."),
    "unusable-centre": QT_TRANSLATE_NOOP(
        "Sentences", "Center words (I, J, K) that are not usable numbers are ignored."
    ),
    "unusable-word": QT_TRANSLATE_NOOP("Sentences", "{letter} words that are not usable numbers are ignored."),
    "position-cut-off": QT_TRANSLATE_NOOP(
        "Sentences", "Positions farther than a kilometer from the origin are limited to a kilometer."
    ),
    "cycle-without-depth": QT_TRANSLATE_NOOP("Sentences", "A drilling cycle without a depth (Z) drills no hole."),
    "cycle-without-retract": QT_TRANSLATE_NOOP("Sentences", "A drilling cycle without R starts at the current height."),
    "cycle-outside-xy": QT_TRANSLATE_NOOP(
        "Sentences", "A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized."
    ),
    "tiny-pecks": QT_TRANSLATE_NOOP(
        "Sentences", "A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once."
    ),
    "arc-before-start": QT_TRANSLATE_NOOP("Sentences", "An arc with an unknown start is ignored."),
    "arc-as-line": QT_TRANSLATE_NOOP("Sentences", "An arc without a usable center or radius is read as a line."),
    "arc-of-changing-radius": QT_TRANSLATE_NOOP(
        "Sentences", "An arc that does not end on its circle is read with a changing radius."
    ),
    "absolute-centres": QT_TRANSLATE_NOOP(
        "Sentences", "The centers of arcs are read as positions (as with G90.1). The arcs only close this way."
    ),
    "circles-alone": QT_TRANSLATE_NOOP(
        "Sentences",
        "The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). "
        "They are read as offsets.",
    ),
    "two-codes": QT_TRANSLATE_NOOP(
        "Sentences",
        "A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.",
    ),
    "unknown-code": QT_TRANSLATE_NOOP("Sentences", "The unknown code {name} is ignored."),
    "unknown-code-with-words": QT_TRANSLATE_NOOP(
        "Sentences", "The unknown code {name} is ignored, and the {letters} words of its line with it."
    ),
    "more-unknown-codes": (
        QT_TRANSLATE_NOOP("Sentences", "1 more unknown code is ignored."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} more unknown codes are ignored."),
    ),
    # Functions of machine controls that the add-on ignores.
    "rotary-cuts": QT_TRANSLATE_NOOP(
        "Sentences", "A rotary axis ({letter}) turns while the tool cuts. The tool's path is unknown here."
    ),
    "rotary-not-read": QT_TRANSLATE_NOOP("Sentences", "Moves of a rotary axis ({letter}) are ignored."),
    "word-not-read": QT_TRANSLATE_NOOP("Sentences", "{letter} words are ignored."),
    "pecks-not-read": QT_TRANSLATE_NOOP(
        "Sentences", "The pecks of {name} are ignored. Each hole is drilled in one move."
    ),
    "repeats-limited": QT_TRANSLATE_NOOP(
        "Sentences", "A cycle with more than {most:n} repeats is read with {most:n} repeats."
    ),
    "repeats-not-read": QT_TRANSLATE_NOOP("Sentences", "The repeats of a cycle ({letter}) are ignored."),
    "turns-not-read": QT_TRANSLATE_NOOP("Sentences", "A number of turns of an arc (P) that is not usable is ignored."),
    "inches-not-read": QT_TRANSLATE_NOOP("Sentences", "Inches (G20) are ignored. Lengths are read in mm."),
    "compensation-not-read": QT_TRANSLATE_NOOP(
        "Sentences", "Cutter compensation ({name}) is ignored. The programmed path is used."
    ),
    "compensation-of-linuxcnc": QT_TRANSLATE_NOOP(
        "Sentences",
        "Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. "
        "On Fanuc controls, they can differ by up to the diameter of the tool.",
    ),
    "feed-mode-not-read": QT_TRANSLATE_NOOP("Sentences", "Feeds after {name} are ignored."),
    "dwell-untimed": QT_TRANSLATE_NOOP("Sentences", "Dwell times are not included in the machining time."),
    "probing-untimed": QT_TRANSLATE_NOOP("Sentences", "Probing moves are not included in the machining time."),
    "too-many-moves": QT_TRANSLATE_NOOP(
        "Sentences",
        "The arcs and cycles would need {moves:n} moves at a tolerance of "
        "{tolerance:mm}. Choose a larger tolerance in the preferences.",
    ),
}
