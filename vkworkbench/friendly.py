# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them: two or three significant digits and a unit."""

from __future__ import annotations

import math


def time(seconds: float) -> str:
    """Return a duration, e.g. ``"12 ms"``, ``"1.4 s"``, ``"3 min"``, ``"2.5 h"``."""
    if seconds < 0.9995:
        return f"{_digits(seconds * 1e3)} ms"
    if seconds < 60:
        return f"{_digits(seconds)} s"
    if seconds < 3600:
        return f"{_digits(seconds / 60)} min"
    return f"{_digits(seconds / 3600)} h"


# From which factor on a number is said to be "about".
ROUGH = 2.0
ABOUT = "about "


def about(text: str, factor: float) -> str:
    """Return the text of a number, with "about" before it where the true one may be half or twice of it."""
    return ABOUT + text if factor >= ROUGH else text


def memory(size: float) -> str:
    """Return a memory size in bytes as kB, MB or GB (powers of 1000)."""
    for unit, factor in (("GB", 1e9), ("MB", 1e6)):
        if size >= 0.9995 * factor:
            return f"{_digits(size / factor)} {unit}"
    return f"{_digits(size / 1e3)} kB"


def length(millimetres: float) -> str:
    """Return a length in mm, m from 10 m on."""
    if millimetres < 10_000:
        return f"{_digits(millimetres)} mm"
    return f"{_digits(millimetres / 1e3)} m"


def turns(angle: float) -> str:
    """Return an angle in rad as turns, signed, to hundredths: what rounding left is nothing."""
    turned = round(angle / math.tau, 2)
    return f"{turned:+.2f}" if turned else "0"


def _digits(value: float) -> str:
    if value >= 9.95 or value == 0:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 0.095 else f"{value:.2g}"
