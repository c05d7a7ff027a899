# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the simulations tell that a user runs: constants, and how far predictions are off."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from vkworkbench.core.simulators.constants import Constants

# A run that took so many times as long as the processor worked and timers waited was disturbed.
_DISTURBED = 1.5
# From so many runs on their errors are stated; from so many, the largest counts as an odd one.
_ENOUGH, _MANY = 4, 13


@dataclass(frozen=True)
class Seen:
    """One simulation as it was seen.

    Attributes
    ----------
    seconds : float
        From the press of the button to the finished part.
    processor_seconds : float
        What FreeCAD's process used of the processors meanwhile.
    frame_seconds : float
        Each of the last pictures, where pictures are what takes the time; else 0.
    speed : int
        Steps for each picture.
    """

    seconds: float
    processor_seconds: float
    frame_seconds: float = 0.0
    speed: int = 1


@dataclass(frozen=True)
class Lesson:
    """How constants are learned from the simulations of one kind that the user runs.

    Attributes
    ----------
    kind : str
        Name of these runs in the calibration's file.
    run : callable
        ``run(cost, seen, constants)`` returns what is kept of a run, a tuple of numbers, where `cost` was predicted with
        `constants`; None where nothing can be learned from it.
    numbers : int
        How many numbers are kept of a run.
    learned : callable
        ``learned(runs, constants)`` returns the constants that follow from all runs kept, by name.
    waits : callable
        ``waits(cost, constants)`` returns how long an undisturbed run waits at most for timers and the screen, s.
    ratio : callable
        ``ratio(run, constants)`` returns the predicted time of a whole run over its true one.
    factor : str or None
        The constant that states how far predictions are off.
    """

    kind: str
    run: Callable[[Any, Seen, Constants], tuple[float, ...] | None]
    numbers: int
    learned: Callable[[Sequence[Any], Constants], dict[str, float]]
    waits: Callable[[Any, Constants], float]
    ratio: Callable[[tuple[float, ...], Constants], float]
    factor: str | None = None

    def read(self, run: Sequence[Any]) -> tuple[float, ...]:
        """Return a run as it was kept, from the calibration's file; ValueError or TypeError where it is none."""
        numbers = tuple(map(float, run))
        if len(numbers) != self.numbers:
            raise ValueError(f"a run of {len(numbers)} numbers, not {self.numbers}")
        return numbers

    def kept(self, cost: Any, seen: Seen, constants: Constants) -> tuple[float, ...] | None:
        """Return what is kept of a run; None where it was disturbed, or teaches nothing."""
        if seen.seconds > _DISTURBED * (seen.processor_seconds + self.waits(cost, constants)):
            return None
        return self.run(cost, seen, constants)

    def taught(self, runs: Sequence[tuple[float, ...]], constants: Constants) -> dict[str, float]:
        """Return the constants that follow from all runs kept, the factor of their errors among them."""
        if not runs:
            return {}
        found = dict(self.learned(runs, constants))
        if self.factor:
            found[self.factor] = stated_factor(self.errors(runs, constants), getattr(constants, self.factor))
        return found

    def errors(self, runs: Sequence[tuple[float, ...]], constants: Constants) -> list[float]:
        """How far each run is from what the others teach: the larger of prediction and truth over the smaller."""
        found = []
        for place, run in enumerate(runs):
            others = [*runs[:place], *runs[place + 1 :]]
            known = replace(constants, **self.learned(others, constants)) if others else constants
            ratio = self.ratio(run, known)
            found.append(max(ratio, 1 / ratio) if ratio > 0 else float("inf"))
        return found


def stated_factor(errors: Sequence[float], before: float) -> float:
    """Return the factor within which the next time is, by the errors of those before it.

    A next error is as likely to be at any place among n others (conformal prediction; Vovk, Gammerman and Shafer 2005):
    within the largest of them with probability n / (n + 1), within the second largest with (n - 1) / (n + 1). The first
    counts from four errors on, which is 0.8; from thirteen on the second, which is 0.86: the largest may be an odd one.

    Parameters
    ----------
    errors : sequence of float
        Each at least 1.
    before : float
        What was stated before anything was seen; fewer errors make it no smaller.
    """
    if len(errors) < _ENOUGH:
        return max(before, *errors) if errors else before
    return sorted(errors)[-2 if len(errors) >= _MANY else -1]
