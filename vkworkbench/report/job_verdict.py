# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict of a simulation on a whole job, and the fingerprint of the job for which the verdict is valid."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from vkworkbench.language import Message, render


@dataclass(frozen=True)
class JobVerdict:
    """The verdict of a simulation on a job: whether the job is sound, or which faults it has.

    Attributes
    ----------
    what : Message
        The verdict as one message.
    valid_for : str
        Fingerprint of the simulated job, see `fingerprint_of_job`.
    outdated : bool
        Whether the job has changed since the simulation.
    """

    what: Message
    valid_for: str
    outdated: bool = False

    @property
    def is_sound(self) -> bool:
        """Whether a check of the whole job found no fault, and the job has not changed since the check."""
        return "verdict-sound" in self.what.codes and not self.outdated

    @property
    def message(self) -> Message:
        """The verdict, or a message that the verdict is outdated."""
        return Message("verdict-outdated") if self.outdated else self.what

    def __str__(self) -> str:
        return render(self.message)


def fingerprint_of_job(operations: Iterable[str], surroundings: str) -> str:
    """Return a job's fingerprint, from the fingerprints of its operations and the fingerprint of its surroundings.

    The surroundings are the model, the clamps and the holder.
    """
    return " ".join([*operations, surroundings])
