# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the dialects of G-code, by the properties in which they differ from RS274/NGC."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Dialect:
    """The meanings of words that differ between dialects. The default values of the fields describe RS274/NGC.

    Attributes
    ----------
    feed_time : float
        The time unit of feed rates, s: 60 for feed rates per minute.
    feeds_in_mm : frozenset of int
        G-codes, as ten times their numbers (200 for G20), that set the unit of lengths and do not change the unit
        of feed rates.
    codes : frozenset of int or None
        G-codes (as ten times their numbers) that have their usual meaning in this dialect; None if all G-codes have
        their usual meaning.
    data : frozenset of int
        G-codes (as ten times their numbers) whose words are data and do not move the tool.
    has_pole : bool
        Whether I, J and K words are the coordinates of a centre, which is used for all later arcs.
    calls : bool
        Whether M97 and M98 call subprograms, and M99 returns from a subprogram.
    modes_in_line : bool
        Whether G90 and G91 apply only to the coordinates after them, also within a line.
    to_machine : frozenset of int
        M-codes with which the coordinates of a line are a machine position.
    """

    feed_time: float = 60.0
    feeds_in_mm: frozenset[int] = frozenset()
    codes: frozenset[int] | None = None
    data: frozenset[int] = frozenset()
    has_pole: bool = False
    calls: bool = True
    modes_in_line: bool = False
    to_machine: frozenset[int] = frozenset()


RS274 = Dialect()  # the dialect of LinuxCNC, Fanuc, Haas, Mach3 and grbl
SIEMENS = Dialect(feeds_in_mm=frozenset([700, 710]))
RAW_PATH = Dialect(feed_time=1.0)  # The text of a FreeCAD path, not converted by a post processor.
HEIDENHAIN = Dialect(  # Heidenhain programs in DIN/ISO.
    codes=frozenset([0, 10, 20, 30, 40, 170, 180, 190, 400, 410, 420, 700, 710, 900, 910]),
    data=frozenset([300, 310, 980, 990]),  # G30, G31, G98 and G99 define the stock, labels and tools
    has_pole=True,
    calls=False,
    modes_in_line=True,
    to_machine=frozenset([91, 92]),
)
