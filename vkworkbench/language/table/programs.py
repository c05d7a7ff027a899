# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about NC programs: which lines are ignored, and why a program is not analysed."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

PROGRAMS: dict[str, str | tuple[str, str]] = {
    "at-line": (
        QT_TRANSLATE_NOOP("Sentences", "Line {line:#}: {what}"),
        QT_TRANSLATE_NOOP("Sentences", "Line {line:#} (first of {count:n}): {what}"),
    ),
    # Lines that the add-on ignores, or reads differently than the machine's control would.
    "block-delete": QT_TRANSLATE_NOOP("Sentences", "Lines with a block delete (/) are read like all others."),
    "subprogram-not-read": QT_TRANSLATE_NOOP("Sentences", "A subprogram or macro call is ignored."),
    "jumps-not-followed": QT_TRANSLATE_NOOP("Sentences", "Jumps, loops and calls are ignored."),
    "variables-not-read": QT_TRANSLATE_NOOP("Sentences", "Words with variables or expressions are ignored."),
    "line-with-variables": QT_TRANSLATE_NOOP("Sentences", "Lines with variables or expressions are ignored."),
    "words-not-read": QT_TRANSLATE_NOOP("Sentences", "Lines that do not consist of words like G1 X10 are ignored."),
    "word-twice": QT_TRANSLATE_NOOP("Sentences", "Of two {letter} words in a line, the last one is read."),
    "two-motions": QT_TRANSLATE_NOOP(
        "Sentences", "Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read."
    ),
    "rapid-after-cancel": QT_TRANSLATE_NOOP(
        "Sentences", "After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate."
    ),
    "coordinates-not-changed": QT_TRANSLATE_NOOP(
        "Sentences", "{name} is ignored. The coordinates after it are read as if it were not there."
    ),
    "origin-assumed": QT_TRANSLATE_NOOP(
        "Sentences", "{name} moves the coordinates. The origin before it is not in the program, and is read as 0."
    ),
    "machine-height": QT_TRANSLATE_NOOP(
        "Sentences",
        "The height of a move to a machine position ({name}) is not in the program. The greatest height is used.",
    ),
    "machine-position": QT_TRANSLATE_NOOP(
        "Sentences",
        "Moves to machine positions ({name}) are ignored, because the program does not contain these positions.",
    ),
    "hole-pattern-not-read": QT_TRANSLATE_NOOP("Sentences", "The holes of a pattern ({name}) are ignored."),
    "pocket-not-read": QT_TRANSLATE_NOOP("Sentences", "The cuts of a pocket or circle ({name}) are ignored."),
    "probing-as-rapid": QT_TRANSLATE_NOOP(
        "Sentences",
        "A probing move is read as a rapid to its end. Where the probe touches is not in the program.",
    ),
    "thread-at-pitch": QT_TRANSLATE_NOOP(
        "Sentences", "The feed rate of a thread ({name}) is its pitch times the spindle speed."
    ),
    "feeds-per-second": QT_TRANSLATE_NOOP(
        "Sentences", "Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor."
    ),
    "decimal-commas": QT_TRANSLATE_NOOP("Sentences", "Commas in numbers are read as decimal points."),
    "foreign-text": QT_TRANSLATE_NOOP(
        "Sentences", "Text that does not consist of words like G1 X10 is ignored. The words beside it are read."
    ),
    "spline-as-chords": QT_TRANSLATE_NOOP("Sentences", "A spline ({name}) is read as short lines."),
    "feed-in-old-unit": QT_TRANSLATE_NOOP(
        "Sentences",
        "An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.",
    ),
    "length-before-height": QT_TRANSLATE_NOOP(
        "Sentences",
        "The tool length offset changes before a move without a Z word. The height of the move is unknown.",
    ),
    "spline-as-line": QT_TRANSLATE_NOOP("Sentences", "A spline ({name}) is read as a line."),
    "goes-on": QT_TRANSLATE_NOOP("Sentences", "Lines after M2, M17 or M30 are read as part of the same program."),
    "after-end": QT_TRANSLATE_NOOP("Sentences", "Lines after the end of the program are ignored."),
    # Reasons why reading ends before the end of a program.
    "read-up-to": QT_TRANSLATE_NOOP("Sentences", "The program is read up to this line. {why}"),
    "value-of-machine": QT_TRANSLATE_NOOP("Sentences", "The value of {name} comes from the machine."),
    "value-unread": QT_TRANSLATE_NOOP("Sentences", "The value of {name} is assigned in a line that cannot be read."),
    "name-unset": QT_TRANSLATE_NOOP("Sentences", "A control stops here, because {name} has no value."),
    "no-variable": QT_TRANSLATE_NOOP("Sentences", "A control stops here, because it has no variable {name}."),
    "no-result": QT_TRANSLATE_NOOP(
        "Sentences", "A control stops here, because an expression has no result, such as a division by zero."
    ),
    "alarm": QT_TRANSLATE_NOOP("Sentences", "The program stops here with an alarm (#3000)."),
    "jump-unread": QT_TRANSLATE_NOOP("Sentences", "This jump, loop or call cannot be read."),
    "unclosed": QT_TRANSLATE_NOOP("Sentences", "The end of this loop, condition or subprogram is missing."),
    "no-block": QT_TRANSLATE_NOOP("Sentences", "The program jumps to the block N{number}, which does not exist."),
    "too-many-lines-run": QT_TRANSLATE_NOOP(
        "Sentences", "Loops, jumps and calls would run more than {count:n} lines, which is the limit."
    ),
    "too-many-moves-run": QT_TRANSLATE_NOOP(
        "Sentences", "Loops, jumps and calls would make more than {count:n} moves, which is the limit."
    ),
    "too-many-lines-idle": QT_TRANSLATE_NOOP(
        "Sentences", "A loop runs more than {count:n} lines without a move, which is the limit."
    ),
    "endless": QT_TRANSLATE_NOOP("Sentences", "The program jumps back from here without end."),
    "too-many-steps": QT_TRANSLATE_NOOP(
        "Sentences", "The expressions take more than {count:n} steps to calculate, which is the limit."
    ),
    "too-many-calls": QT_TRANSLATE_NOOP(
        "Sentences", "Calls are nested deeper than {count:n} levels, which is the limit."
    ),
    "variable-unset": QT_TRANSLATE_NOOP(
        "Sentences", "A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty."
    ),
    # Reasons why a program, or one of its operations, is not analysed.
    "other-control": QT_TRANSLATE_NOOP(
        "Sentences",
        "Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.",
    ),
    "no-words": QT_TRANSLATE_NOOP(
        "Sentences",
        "This is not an NC program. {part:n} of its {lines:n} lines do not consist of "
        "words like G1 X10. The first of them is line {line:#}.",
    ),
    "moves-nothing": QT_TRANSLATE_NOOP("Sentences", "This is not an NC program. None of its lines moves a tool."),
    "no-moves-read": QT_TRANSLATE_NOOP("Sentences", "None of the moves can be read. {problems}"),
    "no-text": QT_TRANSLATE_NOOP("Sentences", "This is not an NC program, because it is not text."),
    "archive": QT_TRANSLATE_NOOP("Sentences", "This is not an NC program, but a zip archive. Unpack it first."),
    "freecad-document": QT_TRANSLATE_NOOP(
        "Sentences",
        "This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a "
        "folder of documents, use the macro examples/macros/folder_to_csv.py.",
    ),
    "lathe": QT_TRANSLATE_NOOP(
        "Sentences", "Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it."
    ),
    "printing": QT_TRANSLATE_NOOP(
        "Sentences", "Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it."
    ),
    "wire": QT_TRANSLATE_NOOP(
        "Sentences", "Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it."
    ),
    "rotary": QT_TRANSLATE_NOOP(
        "Sentences", "Line {line:#}: A rotary axis turns while the tool cuts. The tool's path is unknown here."
    ),
    "rapids-not-told": QT_TRANSLATE_NOOP(
        "Sentences",
        "The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.",
    ),
    "tool-not-told": QT_TRANSLATE_NOOP(
        "Sentences", "The program does not contain the tool's diameter, so the cost is unknown."
    ),
    "inches-simulated": QT_TRANSLATE_NOOP(
        "Sentences", "The program has no unit and looks like inches. It is simulated in inches."
    ),
    "section-without-tool": QT_TRANSLATE_NOOP(
        "Sentences",
        "{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before "
        "it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.",
    ),
    "stock-around-cuts": QT_TRANSLATE_NOOP(
        "Sentences", "No stock is given. The simulation uses a box around the cuts."
    ),
    "inches-as-millimetres": QT_TRANSLATE_NOOP(
        "Sentences", "The toolpath looks 25.4 times too small. Inches are probably read as millimeters."
    ),
    "unit-doubtful": QT_TRANSLATE_NOOP(
        "Sentences", "The program has no unit (G20, G21) and is read in millimeters. It can also be in inches."
    ),
    "increments-as-units": QT_TRANSLATE_NOOP(
        "Sentences",
        "The toolpath spans meters in whole numbers. Thousandths without a decimal point "
        "are probably read as whole units.",
    ),
    "feeds-per-minute": QT_TRANSLATE_NOOP(
        "Sentences",
        "Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD's G-code import does not convert them.",
    ),
    # Files that cannot be read or written.
    "file-unreadable": QT_TRANSLATE_NOOP("Sentences", "The file cannot be read: {name}."),
    "no-file": QT_TRANSLATE_NOOP("Sentences", "This is not a file, but a pipe or a device."),
    "too-long": QT_TRANSLATE_NOOP("Sentences", "The analysis was stopped after {time:s}."),
    "worker-died": QT_TRANSLATE_NOOP(
        "Sentences", "The process that read the file ended unexpectedly, perhaps for lack of memory."
    ),
    "file-too-large": QT_TRANSLATE_NOOP("Sentences", "The file is larger than {size:bytes}."),
    "too-many-lines": QT_TRANSLATE_NOOP("Sentences", "The file has more than {lines:n} lines."),
    "line-too-long": QT_TRANSLATE_NOOP(
        "Sentences", "This is not an NC program. It has a line of more than {characters:n} characters."
    ),
    "memory-short": QT_TRANSLATE_NOOP(
        "Sentences", "The memory is not sufficient for this program. Divide it into smaller programs."
    ),
}
