# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the G-codes, grouped by function, and convert between names of commands and numbers.

A G-code is stored as ten times its number (200 for G20, 901 for G90.1). Commands that are not G-codes have negative
numbers.
"""

from __future__ import annotations

import re

COMMENT, OTHER, TOOL_CHANGE, MODAL, UNKNOWN = -1, -2, -3, -4, -5

# Motions.
RAPID, FEED, CLOCKWISE, COUNTER_CLOCKWISE = 0, 10, 20, 30
ARCS = (CLOCKWISE, COUNTER_CLOCKWISE)
CHIP_BREAK, PECK, REAMING, BORING, CANCEL = 730, 830, 850, 860, 800
TAPPING = (740, 840)
FEED_OUT = (*TAPPING, REAMING, 880, 890)  # canned cycles that retract at the feed rate
PECKING = (CHIP_BREAK, PECK)
CYCLES = (CHIP_BREAK, 740, 810, 820, PECK, 840, REAMING, BORING, 880, 890)  # canned drilling cycles
MOTIONS = (RAPID, FEED, *ARCS, *CYCLES)
SPLINES = (50, 51)
HOME, HOME_2, MACHINE_COORDINATES = 280, 300, 530  # moves to machine positions, which are not in the program
MACHINE = (HOME, HOME_2, MACHINE_COORDINATES)
PROBES = (382, 383, 384, 385)

# Modal state.
XY_PLANE = 170
PLANES = {XY_PLANE: 17, 180: 18, 190: 19}
DRILLED = {XY_PLANE: "Z", 180: "Y", 190: "X"}  # the drilling axis of canned cycles, by plane
ABSOLUTE, RELATIVE, ABSOLUTE_CENTRES, RELATIVE_CENTRES = 900, 910, 901, 911
TO_START, TO_RETRACT_PLANE = 980, 990  # codes for the height after a canned cycle: the start height, or the R plane
# G98 of Fanuc controls, under which FEED_OUT cycles retract at the feed rate to R, and at rapid to the start height.
# Only this package uses the number 981.
RAPID_TO_START = 981
INVERSE_TIME, PER_MINUTE, PER_TURN = 930, 940, 950
FEED_MODES = (INVERSE_TIME, PER_MINUTE, PER_TURN)
COMPENSATION, END_COMPENSATION = (410, 411, 420, 421), 400
DWELL = 40

# Known codes that do not move the tool. `linearize` reads the modal state that a known code sets, ignores the code, or
# reports that the code is not read.
STATES = (
    DWELL, 70, 80, 150, *PLANES, 200, 210, 400, *COMPENSATION, 430, 431, 432, 490, 500, 540, 550, 560, 570, 580, 590, 591, 592,
    593, 610, 611, 640, 690, CANCEL, ABSOLUTE, ABSOLUTE_CENTRES, RELATIVE, RELATIVE_CENTRES, 921, 922, *FEED_MODES, 960, 970,
    TO_START, TO_RETRACT_PLANE, RAPID_TO_START,
)  # fmt: skip

# `linearize` does not use the groups of codes below, which are only for the text of NC programs. The interpreter adds
# the modal codes in KEPT to the commands, because `linearize` needs them.
KEPT = frozenset([*PLANES, CANCEL, ABSOLUTE, ABSOLUTE_CENTRES, RELATIVE, RELATIVE_CENTRES, TO_START, TO_RETRACT_PLANE])
PROBES_OF_PROGRAMS = frozenset([310, *PROBES])
# Codes that store the position for G28 and G30. If the line also contains axis words, Mach3 homes these axes, and
# LinuxCNC moves the tool.
STORED_POSITIONS = frozenset([281, 301])
# G11 ends data on Fanuc controls, and mirrors or shifts the coordinates on Fagor and Okuma controls.
END_DATA = 110
# Codes that set a mode on Fanuc controls. With axis words, but without a motion in the line, G8 is a tangential arc on
# Fagor controls, G11 shifts the coordinates on Okuma controls, and G63 is a tap at feed on Siemens controls.
MOVES_ALONE = frozenset([80, END_DATA, 630])
MORE_OFFSETS = 541
NUMBERED_OFFSETS = frozenset([MORE_OFFSETS, 1540])  # G54.1 and G154: the P word is the number of the work offset
OFFSETS = NUMBERED_OFFSETS | frozenset([
    540, 550, 560, 570, 580, 590, 591, 592, 593,
    *range(1100, 1300, 10),  # Work offsets of Haas controls.
    5000, *range(5050, 6000, 10),  # Work offsets of Siemens controls.
])  # fmt: skip
# G15 ends G16. Okuma's G15 with an H word selects a work offset. Okuma's G54 to G56 with an H word, or with HA, HB or
# HC, select a tool length offset.
OKUMA_OFFSET = 150
LOCAL = 520  # G52 shifts the coordinates by its axis words.
POSITION, END_SHIFT, SUSPEND_SHIFT, RESUME_SHIFT = 920, 921, 922, 923  # G92 shifts the coordinates to its axis words.
ROTATE, END_ROTATION, SCALE, END_SCALE, MIRROR, END_MIRROR = 680, 690, 510, 500, 511, 501
POLAR = 160
CHANGES_COORDINATES = frozenset([71, LOCAL, 682])
DATA = 100
TOOL_LENGTH = (430, 431, 432, 490)
THREAD, RIGID_TAP = 330, 331
INCHES = frozenset([200, 700, 7000])
UNITS = INCHES | frozenset([210, 710, 7100])
PATTERNS = frozenset([700, 710, 720])
POCKETS = frozenset([120, 130, 1500])
MACRO_CALLS = frozenset([650, 660])
HARMLESS = OFFSETS | STORED_POSITIONS | frozenset([
    80, 90, 110, 150, 200, 210, 400, 401, 410, 411, 412, 420, 421, 422, 430, 431, 432, 434, 435, 440, 490, 500, 600,
    610, 611, 620, 630, 640, 670, 690, 700, 710, 930, 940, 950, 960, 970, 1030, 1870,
    4500, 4510, 6010, 6020, 6030, 6410, 6420, 6430, 6440, 6450,  # Siemens: modes for motion around corners.
])  # fmt: skip

_NAME = re.compile(r"([A-Z])0*(\d{1,9})(?:\.(\d))?", re.ASCII)


def code_of(name: str) -> int:
    """Return the number for a command's name: ten times the number of a G-code, or a negative number defined above.

    ``G01`` and ``g1`` have the same number. A command with an empty name continues the last motion (a modal line).
    """
    name = name.strip().upper()
    if not name:
        return MODAL
    if name[0] in "(;%/":  # "/" begins a disabled line (block delete)
        return COMMENT
    match = _NAME.fullmatch(name)
    if match is None:
        return UNKNOWN
    letter, number, tenth = match[1], int(match[2]), int(match[3] or 0)
    if letter == "G":
        return 10 * number + tenth if number < 1000 else UNKNOWN
    if letter == "M" and number == 6:
        return TOOL_CHANGE
    return OTHER if letter in "MTSNO" else UNKNOWN


def name_of(code: int) -> str:
    """Return the name of a G-code that is given as ten times its number, such as ``"G90.1"`` for 901."""
    return f"G{code // 10}.{code % 10}" if code % 10 else f"G{code // 10}"


MOTION_NAMES = frozenset(map(name_of, MOTIONS))
MOTION_WORDS = frozenset(("G", code / 10) for code in MOTIONS)
