# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of NC programs: what in them is not read, and why one is not read at all."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

PROGRAMS: dict[str, str | tuple[str, str]] = {
    "at-line": (
        QT_TRANSLATE_NOOP("Sentences", "{what} (line {line:#})"),
        QT_TRANSLATE_NOOP("Sentences", "{what} ({count:n} times, first in line {line:#})"),
    ),
    # What is not read as a machine would do it.
    "block-delete": QT_TRANSLATE_NOOP("Sentences", "lines with a block delete (/) are read like the others"),
    "subprogram-not-read": QT_TRANSLATE_NOOP("Sentences", "a subprogram or macro call is not read"),
    "jumps-not-followed": QT_TRANSLATE_NOOP("Sentences", "jumps, loops and calls are not followed"),
    "variables-not-read": QT_TRANSLATE_NOOP(
        "Sentences", "variables and expressions are not read: the words with them are left out"
    ),
    "line-with-variables": QT_TRANSLATE_NOOP(
        "Sentences", "variables and expressions are not read: the lines with them are left out"
    ),
    "words-not-read": QT_TRANSLATE_NOOP("Sentences", "lines that are not made of words like G1 X10 are left out"),
    "word-twice": QT_TRANSLATE_NOOP("Sentences", "a line with two {letter} words: the last one is read"),
    "two-motions": QT_TRANSLATE_NOOP("Sentences", "a line with two motions, such as G0 and G1: the last one is read"),
    "coordinates-not-changed": QT_TRANSLATE_NOOP(
        "Sentences", "coordinates that {name} changes are read as if it were not there"
    ),
    "machine-position": QT_TRANSLATE_NOOP(
        "Sentences", "moves to positions of the machine ({name}) are left out: a program does not say where they are"
    ),
    "hole-pattern-not-read": QT_TRANSLATE_NOOP("Sentences", "the holes of a pattern ({name}) are not made"),
    "spline-as-line": QT_TRANSLATE_NOOP("Sentences", "a spline ({name}) is read as a line"),
    "goes-on": QT_TRANSLATE_NOOP("Sentences", "what follows M2 or M30 is read as the same program"),
    "after-end": QT_TRANSLATE_NOOP("Sentences", "what follows the program's end is not read"),
    # Why a program, or one of its operations, is not analysed.
    "other-control": QT_TRANSLATE_NOOP(
        "Sentences",
        "a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read",
    ),
    "no-words": QT_TRANSLATE_NOOP(
        "Sentences",
        "not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}",
    ),
    "moves-nothing": QT_TRANSLATE_NOOP("Sentences", "not an NC program: no line of it moves a tool"),
    "no-moves-read": QT_TRANSLATE_NOOP("Sentences", "none of its moves can be read: {problems}"),
    "no-text": QT_TRANSLATE_NOOP("Sentences", "not an NC program: it is not text"),
    "archive": QT_TRANSLATE_NOOP("Sentences", "not an NC program, but a zip archive: unpack it first"),
    "freecad-document": QT_TRANSLATE_NOOP(
        "Sentences",
        "not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro "
        "examples/macros/folder_to_csv.py",
    ),
    "lathe": QT_TRANSLATE_NOOP(
        "Sentences", "a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it"
    ),
    "printing": QT_TRANSLATE_NOOP(
        "Sentences", "a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it"
    ),
    "wire": QT_TRANSLATE_NOOP(
        "Sentences", "a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it"
    ),
    "rotary": QT_TRANSLATE_NOOP(
        "Sentences", "a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told"
    ),
    "rapids-not-told": QT_TRANSLATE_NOOP(
        "Sentences", "{length:mm4} of rapids are not in the time: a program does not say how fast they are"
    ),
    "tool-not-told": QT_TRANSLATE_NOOP(
        "Sentences", "no tool: the program does not say its diameter, so the cost is not known"
    ),
    "inches-as-millimetres": QT_TRANSLATE_NOOP(
        "Sentences", "it looks 25.4 times too small: inches read as millimeters?"
    ),
    "increments-as-units": QT_TRANSLATE_NOOP(
        "Sentences", "it spans meters in whole numbers: thousandths without a decimal point read as whole units?"
    ),
    "feeds-per-minute": QT_TRANSLATE_NOOP(
        "Sentences", "its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD's importer keeps them as mm/s"
    ),
    # Files.
    "file-unreadable": QT_TRANSLATE_NOOP("Sentences", "the file cannot be read: {name}"),
    "no-file": QT_TRANSLATE_NOOP("Sentences", "this is no file, but a pipe or a device"),
    "too-long": QT_TRANSLATE_NOOP("Sentences", "given up after {time:s}"),
    "worker-died": QT_TRANSLATE_NOOP("Sentences", "the process that read it died, perhaps for lack of memory"),
    "file-too-large": QT_TRANSLATE_NOOP("Sentences", "the file is larger than {size:bytes}"),
}
