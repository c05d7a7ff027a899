# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store one line of an NC program while the words of the line are processed."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class Line:
    """The words of a program line, with the effects of the G-codes in the line.

    Attributes
    ----------
    words : list of (str, float)
        The words in the order of the line.
    letters : set of str
        The letters of the words.
    parameters : dict
        The values of the words that are parameters of the motion, by their letters.
    codes : list of int
        The G-codes of the line that were processed so far, as ten times their numbers (200 for G20).
    motion : int or None
        The G-code of the motion that the line selects, as ten times its number; None if the line selects no motion.
    once : int or None
        G-code, as ten times its number, of a move that is in force in this line only (probe, thread or spline); None if
        there is no such move.
    apart : bool
        Whether the line's axis words are parameters of a code, not the target of a move.
    feeds : bool
        Whether an F word is a feed rate, not a parameter of a code.
    feed_factor : float
        Factor for the F word. In RS274/NGC, an F word in the line of G20 or G21 still has the previous unit.
    """

    words: list[tuple[str, float]]
    letters: set[str]
    parameters: dict[str, float]
    codes: list[int] = field(default_factory=list)
    motion: int | None = None
    once: int | None = None
    apart: bool = False
    feeds: bool = True
    feed_factor: float = 1.0

    @property
    def code(self) -> int:
        """int : The G-code that is being processed, as ten times its number (200 for G20)."""
        return self.codes[-1]

    def lengths(self, unit: float) -> dict[str, float]:
        """Return the X, Y and Z words, mm."""
        return {letter: unit * value for letter, value in self.words if letter in "XYZ"}
