# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the dialects of G-code, by the properties in which they differ from RS274/NGC."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Dialect:
    """Properties of a dialect: the same words can have different meanings in other dialects.

    Attributes
    ----------
    feed_time : float
        The time in the unit of feed rates, s.
    feeds_in_mm : frozenset of int
        G-codes, in tenths, that set the unit of lengths and do not change the unit of feed rates.
    codes : frozenset of int or None
        The only G-codes, in tenths, that have their usual meaning; None if all G-codes have their usual meaning.
    data : frozenset of int
        G-codes, in tenths, whose words are data and do not move the tool.
    has_pole : bool
        Whether I, J and K are the coordinates of a centre, which stays in force for all later arcs.
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
    data=frozenset([300, 310, 990]),  # definitions of the blank and of tools
    has_pole=True,
    calls=False,
)
