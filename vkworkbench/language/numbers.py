# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them: two or three significant digits and a unit."""

from __future__ import annotations

import re
from math import floor, inf, log10, tau

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

# From which factor on a number is said to be "about" and has one digit; from which on it has two.
ROUGH, ESTIMATED = 2.0, 1.05
# Units of time, their lengths, and from which time on the next one is taken, s.
_UNITS = (("ms", 1e-3, 1.0), ("s", 1.0, 60.0), ("min", 60.0, 3600.0), ("h", 3600.0, inf))
ABOUT = QT_TRANSLATE_NOOP("Sentences", "about {number}")
_BETWEEN = QT_TRANSLATE_NOOP("Sentences", "{low} to {high}")
_PERCENT = QT_TRANSLATE_NOOP("Sentences", "{number}%")
# What documents call the simulators; a window calls FreeCAD's own as its menu does.
_SIMULATORS = {
    "z-buffer": QT_TRANSLATE_NOOP("Sentences", "extended z-buffer"),
    "legacy": QT_TRANSLATE_NOOP("Sentences", "legacy simulator"),
    "OpenGL": QT_TRANSLATE_NOOP("Sentences", "OpenGL simulator"),
}
_THOUSANDS = re.compile(r"^-?\d{4,}")


class Reader:
    """How somebody reads: this one English, with millimetres.

    Whoever reads another language, or in other units, is a subclass.

    Attributes
    ----------
    decimal, thousands : str
        What separates the decimals, and groups of three digits.
    """

    decimal, thousands = ".", ","

    def translate(self, context: str, text: str) -> str:
        """Return a text that is marked for translation in the reader's language."""
        return text

    def simulator(self, name: str) -> str:
        """Return what the reader knows a simulator as, by the name of its entry in the table of simulators."""
        return self.translate("Sentences", _SIMULATORS.get(name, name))

    def length_unit(self, millimetres: float) -> tuple[float, str]:
        """Return the unit in which a length of that size is read: how many mm it is, and its name."""
        return 1.0, "mm"

    def length(self, millimetres: float) -> str:
        """Return a length in mm, m from 10 m on."""
        if millimetres < 10_000:
            return f"{self._digits(millimetres)} mm"
        return f"{self._digits(millimetres / 1e3)} m"

    def measure(self, millimetres: float, digits: int) -> str:
        """Return a length with a number of significant digits, e.g. ``"0.125 mm"``."""
        factor, unit = self.length_unit(millimetres)
        return f"{self.number(millimetres / factor, digits)} {unit}"

    def volume(self, cubic_millimetres: float, digits: int) -> str:
        """Return a volume with a number of significant digits, e.g. ``"212 mm³"``, in the unit that its side has."""
        factor, unit = self.length_unit(cubic_millimetres ** (1 / 3))
        return f"{self.number(cubic_millimetres / factor**3, digits)} {unit}³"

    def number(self, value: float, digits: int = 6) -> str:
        """Return a number with a number of significant digits; a large one to the unit."""
        text = f"{value:.{digits}g}"
        if "e+" in text:
            text = f"{value:.0f}"
        return self.separated(_THOUSANDS.sub(lambda number: f"{int(number.group()):,}", text))

    def decimals(self, value: float, places: int) -> str:
        """Return a number with that many decimals."""
        return self.separated(f"{value:.{places}f}")

    def is_one(self, count: int) -> bool:
        """Whether the reader's language says a count as it says one."""
        return count == 1

    def count(self, number: int) -> str:
        """Return how many there are, e.g. ``"5,752"``."""
        return self.separated(f"{number:,}")

    def share(self, share: float) -> str:
        """Return a share of 1 in percent, e.g. ``"98%"``."""
        return self.translate("Sentences", _PERCENT).replace("{number}", f"{100 * share:.0f}")

    def turns(self, angle: float) -> str:
        """Return an angle, rad, in turns, to hundredths: what rounding left is nothing."""
        turns = round(angle / tau, 2)
        return self.separated(f"{turns:+.2f}") if turns else "0"

    def time(self, seconds: float, factor: float = 1.0, finer: int = 0) -> str:
        """Return a duration, e.g. ``"12 ms"``, ``"1.4 s"``, ``"3.0 min"``, ``"2.5 h"``.

        Parameters
        ----------
        seconds : float
        factor : float
            The true time is between this one divided and multiplied by this; it has as many digits as that allows.
        finer : int
            How many digits more an exact one has than usual.
        """
        if factor > ESTIMATED and 0 < seconds < inf:
            return self._rounded_time(seconds, 1 if factor >= ROUGH else 2)
        if seconds < 0.9995:
            return f"{self._digits(seconds * 1e3, finer)} ms"
        if seconds < 60:
            return f"{self._digits(seconds, finer)} s"
        if seconds < 3600:
            return f"{self._digits(seconds / 60, finer)} min"
        return f"{self._digits(seconds / 3600, finer)} h"

    def estimated_time(self, seconds: float, factor: float) -> str:
        """Return a duration, see :meth:`time`, with "about" before it where the true one may be half or twice of it."""
        text = self.time(seconds, factor)
        return self.translate("Sentences", ABOUT).replace("{number}", text) if factor >= ROUGH else text

    def memory(self, size: float, finer: int = 0) -> str:
        """Return a memory size in bytes as kB, MB or GB (powers of 1000), with so many digits more than usual."""
        for unit, factor in (("GB", 1e9), ("MB", 1e6)):
            if size >= 0.9995 * factor:
                return f"{self._digits(size / factor, finer)} {unit}"
        return f"{self._digits(size / 1e3, finer)} kB"

    def between(self, low: str, high: str) -> str:
        """Return two numbers between which the true one is."""
        return self.translate("Sentences", _BETWEEN).replace("{low}", low).replace("{high}", high)

    def _rounded_time(self, seconds: float, digits: int) -> str:
        text = ""
        for unit, length, most in _UNITS:
            value = float(f"{seconds / length:.{digits - 1}e}")
            places = max(digits - 1 - floor(log10(value)), 0)
            text = f"{self.separated(f'{value:,.{places}f}')} {unit}"
            if value * length < most:
                break
            seconds = max(seconds, most)  # 59.7 s are a minute
        return text

    def _digits(self, value: float, finer: int = 0) -> str:
        if value >= 9.95 or value == 0:
            return self.separated(f"{value:,.{finer}f}")
        return self.separated(f"{value:.{1 + finer}f}" if value >= 0.095 else f"{value:.{2 + finer}g}")

    def separated(self, english: str) -> str:
        """Return an English number, alone or in a text without other points and commas, with the reader's separators."""
        return english.translate({ord("."): self.decimal, ord(","): self.thousands})


ENGLISH = Reader()
