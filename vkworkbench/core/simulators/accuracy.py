# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finest accuracy at which FreeCAD's legacy simulator plays within a budget of time and memory."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench.core.simulators.legacy import LegacyCost, legacy_together
from vkworkbench.core.zbuffer import heaviest, passes_apart
from vkworkbench.given import number, of_kind, positive
from vkworkbench.language import Message, render


@dataclass(frozen=True)
class Accuracy:
    """A position of the legacy simulator's accuracy slider, chosen for a budget of playing.

    Attributes
    ----------
    position : int or None
        The finest position that meets the budget, 1 to 10; None where none does: use fast-forward then.
    seconds, memory_bytes : float
        What playing takes at that position; at the coarsest one where no position meets the budget.
    why : Message
        What it means and what limits it, or what helps where no position does.
    """

    position: int | None
    seconds: float
    memory_bytes: float
    why: Message

    @property
    def explanation(self) -> str:
        """The same as an English sentence without a full stop."""
        return render(self.why)


def best_accuracy(
    costs: Sequence[Sequence[LegacyCost]],
    *,
    memory_bytes: float,
    seconds: float,
    stepover: float | None = None,
    labels: Sequence[str] = (),
) -> Accuracy:
    """Choose the finest position of the accuracy slider with which operations are played within a budget.

    Fast-forward needs no such choice: it makes only one mesh and is as fast at the finest position as at any.

    Parameters
    ----------
    costs : sequence of sequences of LegacyCost
        Of every operation, what it takes at each position of the slider (``legacy.SLIDER``).
    memory_bytes, seconds : float
        The budget for playing them one after another.
    stepover : float, optional
        Smallest distance between passes, mm: says whether the cells tell the passes apart.
    labels : sequence of str, optional
        What the operations are called: the heaviest is named where no position helps.

    Returns
    -------
    Accuracy

    Raises
    ------
    ValueError
        Without an operation, or with a budget that is not a positive number.
    TypeError
        Where an argument is something else.
    """
    memory_bytes = number("memory_bytes", memory_bytes, "a positive number of bytes", positive)
    seconds = number("seconds", seconds, "a positive number of s", positive)
    of_kind("costs", costs, Sequence, "several sequences of LegacyCost")
    if not costs:
        raise ValueError("there is no operation to choose an accuracy for")
    for cost in costs:
        of_kind("each of costs", cost, Sequence, "a sequence of LegacyCost")
        for one in cost:
            of_kind("a cost", one, LegacyCost, "a LegacyCost")
    every = [legacy_together(at_position) for at_position in zip(*costs)]
    met = [
        position
        for position, cost in enumerate(every, 1)
        if cost.play_seconds <= seconds and cost.memory_bytes <= memory_bytes
    ]
    if not met:
        coarsest, finest = every[0], every[-1]
        why = Message(
            "no-accuracy", longer=coarsest.play_seconds, time=finest.fast_forward_seconds,
            heaviest=heaviest(labels, [cost[0].play_seconds for cost in costs]),
        )  # fmt: skip
        return Accuracy(None, coarsest.play_seconds, coarsest.memory_bytes, why)
    position = met[-1]
    chosen = every[position - 1]
    why = Message(
        "accuracy", position=position, positions=len(every), cell=chosen.resolution, time=chosen.play_seconds,
        passes=passes_apart(chosen.resolution, stepover),
    )  # fmt: skip
    return Accuracy(position, chosen.play_seconds, chosen.memory_bytes, why)
