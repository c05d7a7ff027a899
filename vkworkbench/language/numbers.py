# SPDX-License-Identifier: LGPL-2.1-or-later
"""Format numbers for people, with few significant digits and a unit."""

from __future__ import annotations

import re
from math import floor, inf, log10, tau

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

# An estimate that can be wrong by the factor ROUGH or more is shown with one digit and "about". An estimate that can be
# wrong by more than the factor ESTIMATED is shown with two digits. With a lower value of ROUGH or ESTIMATED, useful
# digits are not shown. With a higher value of ROUGH or ESTIMATED, meaningless digits are shown.
ROUGH, ESTIMATED = 2.0, 1.05
# Units of time: the name, the length, s, and the duration from which the next larger unit is used, s.
_UNITS = (("s", 1.0, 60.0), ("min", 60.0, 3600.0), ("h", 3600.0, inf))
_SHORTEST = 1e-3  # s; shorter durations are shown as this duration
ABOUT = QT_TRANSLATE_NOOP("Sentences", "about {number}")
_BETWEEN = QT_TRANSLATE_NOOP("Sentences", "{low} to {high}")
_PERCENT = QT_TRANSLATE_NOOP("Sentences", "{number}%")
# Names of the simulators in documents. The user interface shows the names from FreeCAD's menu instead.
_SIMULATORS = {
    "z-buffer": QT_TRANSLATE_NOOP("Sentences", "Simulate Toolpaths simulator"),
    "legacy": QT_TRANSLATE_NOOP("Sentences", "legacy simulator"),
    "OpenGL": QT_TRANSLATE_NOOP("Sentences", "OpenGL simulator"),
}
_CLOCK = re.compile(r"(\d{1,3}:)?\d{1,3}:[0-5]\d", re.ASCII)
_THOUSANDS = re.compile(r"^-?\d{4,}")


class Reader:
    """The language, units and number format of a reader.

    This class formats for English and mm; subclasses are for other languages and units.

    Attributes
    ----------
    decimal, thousands : str
        Decimal separator, and separator of groups of three digits.
    """

    decimal, thousands = ".", ","

    def translate(self, context: str, text: str) -> str:
        """Return the translation of a text, which is marked with `QT_TRANSLATE_NOOP`, into the reader's language."""
        return text

    def simulator(self, name: str) -> str:
        """Return the name of a simulator in the reader's language. `name` is the name in the table of simulators."""
        return self.translate("Sentences", _SIMULATORS.get(name, name))

    def length_unit(self, millimetres: float) -> tuple[float, str]:
        """Return the length in mm and the name of the unit in which a length is shown."""
        return 1.0, "mm"

    def length(self, millimetres: float) -> str:
        """Return a length as text, in mm if it is below 10 m, and in m otherwise."""
        if millimetres < 10_000:
            return f"{self._digits(millimetres)} mm"
        return f"{self._digits(millimetres / 1e3)} m"

    def measure(self, millimetres: float, digits: int) -> str:
        """Return a length as text, such as ``"0.125 mm"``, with the given number of significant digits."""
        factor, unit = self.length_unit(millimetres)
        return f"{self.number(millimetres / factor, digits)} {unit}"

    def volume(self, cubic_millimetres: float, digits: int) -> str:
        """Return a volume as text, such as ``"212 mm³"``, with the given number of significant digits.

        The volume is shown in mm³ if the side of a cube with this volume would be shown in mm; likewise for other
        units.
        """
        factor, unit = self.length_unit(cubic_millimetres ** (1 / 3))
        return f"{self.number(cubic_millimetres / factor**3, digits)} {unit}³"

    def number(self, value: float, digits: int = 6) -> str:
        """Return a number as text with the given number of significant digits.

        Large numbers are rounded to integers.
        """
        text = f"{value:.{digits}g}"
        if "e+" in text:
            text = f"{value:.0f}"
        return self.separated(_THOUSANDS.sub(lambda number: f"{int(number.group()):,}", text))

    def decimals(self, value: float, places: int) -> str:
        """Return a number as text with the given number of decimals."""
        return self.separated(f"{value:.{places}f}")

    def is_one(self, count: int) -> bool:
        """Return whether the reader's language uses the singular for a count."""
        return count == 1

    def count(self, number: int) -> str:
        """Return a count as text, such as ``"5,752"``."""
        return self.separated(f"{number:,}")

    def share(self, share: float) -> str:
        """Return a share of 1 as text in percent, such as ``"98%"``."""
        return self.translate("Sentences", _PERCENT).replace("{number}", f"{100 * share:.0f}")

    def turns(self, angle: float) -> str:
        """Return an angle, given in rad, as text in turns with two decimals. An angle that rounds to 0 is ``"0"``."""
        turns = round(angle / tau, 2)
        return self.separated(f"{turns:+.2f}") if turns else "0"

    def time(self, seconds: float, factor: float = 1.0, extra_digits: int = 0) -> str:
        """Return a duration as text, such as ``"0.12 s"``, ``"1.4 s"``, ``"3.0 min"`` or ``"2.5 h"``.

        Parameters
        ----------
        factor : float
            The true time is between `seconds` / `factor` and `seconds` * `factor`. A large factor reduces the number of
            digits.
        extra_digits : int
            Number of additional digits. Only exact durations, with a factor near 1, get additional digits.
        """
        seconds = max(seconds, _SHORTEST) if seconds > 0 else seconds
        if factor > ESTIMATED and 0 < seconds < inf:
            return self._rounded_time(seconds, 1 if factor >= ROUGH else 2)
        if seconds < 60:
            return f"{self._digits(seconds, extra_digits)} s"
        if seconds < 3600:
            return f"{self._digits(seconds / 60, extra_digits)} min"
        return f"{self._digits(seconds / 3600, extra_digits)} h"

    def clock(self, seconds: float) -> str:
        """Return a machining time as machinists write it, such as ``"0:45"``, ``"15:04"`` or ``"1:02:30"``."""
        minutes, rest = divmod(max(round(seconds), 1) if seconds else 0, 60)
        hours, minutes = divmod(minutes, 60)
        return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"

    @staticmethod
    def seconds_of(clock: str) -> float | None:
        """Return the duration in s of a text such as ``"0:45"``, ``"17:30"`` or ``"1:02:30"``; None for other texts."""
        if not _CLOCK.fullmatch(clock.strip()):
            return None
        hours, minutes, seconds = [0, 0, *map(int, clock.strip().split(":"))][-3:]
        return 3600.0 * hours + 60.0 * minutes + seconds

    def estimated_time(self, seconds: float, factor: float) -> str:
        """Return a duration as :meth:`time` does. If `factor` is at least `ROUGH`, the text begins with "about"."""
        text = self.time(seconds, factor)
        return self.translate("Sentences", ABOUT).replace("{number}", text) if factor >= ROUGH else text

    def memory(self, size: float, extra_digits: int = 0) -> str:
        """Return a memory size, given in bytes, as text in kB, MB or GB (powers of 1000)."""
        for unit, factor in (("GB", 1e9), ("MB", 1e6)):
            if size >= 0.9995 * factor:
                return f"{self._digits(size / factor, extra_digits)} {unit}"
        return f"{self._digits(size / 1e3, extra_digits)} kB"

    def between(self, low: str, high: str) -> str:
        """Return a range of numbers as text, such as ``"2 to 5"``."""
        return self.translate("Sentences", _BETWEEN).replace("{low}", low).replace("{high}", high)

    def _rounded_time(self, seconds: float, digits: int) -> str:
        text = ""
        for unit, length, most in _UNITS:
            value = float(f"{seconds / length:.{digits - 1}e}")
            places = max(digits - 1 - floor(log10(value)), 0)
            text = f"{self.separated(f'{value:,.{places}f}')} {unit}"
            if value * length < most:
                break
            seconds = max(seconds, most)  # a duration that rounds to 60 s is shown as 1 min
        return text

    def _digits(self, value: float, extra_digits: int = 0) -> str:
        if value >= 9.95 or value == 0:
            return self.separated(f"{value:,.{extra_digits}f}")
        return self.separated(f"{value:.{1 + extra_digits}f}" if value >= 0.095 else f"{value:.{2 + extra_digits}g}")

    def separated(self, english: str) -> str:
        """Return an English number with the reader's separators.

        The text must not contain points or commas other than the number's separators.
        """
        return english.translate({ord("."): self.decimal, ord(","): self.thousands})


ENGLISH = Reader()
