# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialects of G-code. Each entry lists what differs from RS274/NGC; what does not differ has no entry."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Dialect:
    """How a program differs from others that are written with the same words.

    Attributes
    ----------
    feed_time : float
        The time in the unit of feed rates, s.
    feeds_in_mm : frozenset of int
        G-codes, in tenths, that set the unit of lengths and leave feed rates as they are.
    codes : frozenset of int or None
        The only G-codes, in tenths, with their usual meaning; None if all have it.
    data : frozenset of int
        G-codes, in tenths, whose words are data that move nothing.
    has_pole : bool
        Whether I, J and K are the coordinates of a centre that is in force for all arcs that follow.
    calls : bool
        Whether M97 to M99 call subprograms and return from them.
    """

    feed_time: float = 60.0
    feeds_in_mm: frozenset[int] = frozenset()
    codes: frozenset[int] | None = None
    data: frozenset[int] = frozenset()
    has_pole: bool = False
    calls: bool = True


RS274 = Dialect()  # also Fanuc, Haas, Mach3, grbl and LinuxCNC
SIEMENS = Dialect(feeds_in_mm=frozenset([700, 710]))
RAW_PATH = Dialect(feed_time=1.0)  # the text of a path from FreeCAD that no post processor wrote
HEIDENHAIN = Dialect(  # DIN/ISO
    codes=frozenset([0, 10, 20, 30, 40, 170, 180, 190, 400, 410, 420, 700, 710, 900, 910]),
    data=frozenset([300, 310, 990]),  # the blank and the tools
    has_pole=True,
    calls=False,
)
