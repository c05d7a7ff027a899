# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide the verdict on a job's safety as one message: faults, size of the pixels, and the checks that were left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench.core.zbuffer.findings.collisions import Collisions
from vkworkbench.core.zbuffer.sweeps.cuts import Source
from vkworkbench.language import Message

# Sentence of the verdict on a job's safety if shanks, holders and clamps were not checked.
UNATTACHED = Message("attachments-unchecked")


@dataclass(frozen=True)
class Verdict:
    """The faults that a check of a job found, and the extent of the check.

    Attributes
    ----------
    pixel : float or None
        Side of the pixels of the simulation with which the job was checked, mm; None before the check.
    met : bool
        Whether at least one tool can meet the stock. If `met` is False, there was nothing to check.
    compared : bool
        Whether the part was compared with a model.
    crashes, gouges, fast_plunges : int
        Number of rapids that cut, number of gouges in the model, and number of plunges above the vertical feed.
    deepest_gouge, lacking : float
        Depth of the deepest gouge, and largest thickness of material that the model needs but the stock does not have,
        mm.
    unchecked : tuple of Source
        Moves that were not checked within the time limit.
    walls_checked : bool
        Whether all walls of the model were compared with the part, on rays closer than a pixel, within the time limit.
    unjudged : tuple of int
        Numbers of the operations whose gouges are unknown, because their tools were simulated with another shape than
        the real shape.
    collisions : Collisions or None
        Collisions of shanks, holders and clamps; None if they were not checked.
    lines : bool
        Whether the message names commands by their line in the NC program, counted from 1.
    unread : tuple of Message
        Messages on parts of the job that could not be read, and on assumptions made while reading the job. If there is
        a message on an unread part, `is_sound` is False.
    """

    pixel: float | None = None
    met: bool = True
    compared: bool = True
    crashes: int = 0
    gouges: int = 0
    fast_plunges: int = 0
    deepest_gouge: float = 0.0
    lacking: float = 0.0
    unchecked: tuple[Source, ...] = ()
    walls_checked: bool = True
    unjudged: tuple[int, ...] = ()
    collisions: Collisions | None = None
    lines: bool = False
    unread: tuple[Message, ...] = ()

    @property
    def is_checked(self) -> bool:
        """Whether the job was checked, and there was something to check."""
        return self.pixel is not None and self.met

    @property
    def is_sound(self) -> bool:
        """Whether the whole job was read and checked, and no fault was found."""
        return self.is_checked and self._is_complete and not self._faults()

    @property
    def _is_complete(self) -> bool:
        return self.walls_checked and not (self.unread or self.unchecked or self.unjudged)

    def message(self, labels: Sequence[str]) -> Message:
        """Return the verdict on the job's safety as one message.

        Parameters
        ----------
        labels : sequence of str
            Labels of the operations.
        """
        if self.pixel is None:
            return Message("verdict-pending")
        if not self.met:
            return Message("verdict", sentences=(Message("verdict-nothing"), *self._unread()))
        faults = self._faults()
        result = Message("verdict-checked", pixel=self.pixel) if faults else self._no_faults()
        attachments = self.collisions.attachments(labels) if self.collisions else UNATTACHED
        return Message("verdict", sentences=(*faults, result, *self._unread(), *self._left_out(labels), attachments))

    def _no_faults(self) -> Message:
        what = Message("verdict-kinds") if self.compared else Message("verdict-kinds-without-model")
        if self._is_complete:
            return Message("verdict-sound", what=what, pixel=self.pixel)
        return Message("verdict-unsure", what=what, pixel=self.pixel)

    def _unread(self) -> tuple[Message, ...]:
        if not self.unread:
            return ()
        return (Message("verdict-unread", count=len(self.unread), first=self.unread[0]),)

    def _faults(self) -> tuple[Message, ...]:
        found = (
            (self.crashes, Message("verdict-crashes", count=self.crashes)),
            (self.gouges, Message("verdict-gouges", count=self.gouges, depth=self.deepest_gouge)),
            (self.lacking, Message("stock-lacks", depth=self.lacking)),
            (self.fast_plunges, Message("verdict-plunges", count=self.fast_plunges)),
        )
        collided = self.collisions.worst if self.collisions else ()
        return (*(one.what for one in collided), *(message for number, message in found if number))

    def _left_out(self, labels: Sequence[str]) -> tuple[Message, ...]:
        """Return one sentence for each part of the check that was left out."""
        sentences = []
        if self.unchecked:
            first = self.unchecked[0]
            count, label = len(self.unchecked), labels[first.cut]
            sentences.append(
                Message("verdict-unchecked", count=count, command=first.command + (not self.lines), label=label)
            )
        if not self.walls_checked:
            sentences.append(Message("verdict-walls", pixel=self.pixel))
        if not self.compared:
            sentences.append(Message("verdict-no-model"))
        if self.unjudged:
            sentences.append(Message("verdict-unjudged", labels=tuple(labels[cut] for cut in self.unjudged)))
        return tuple(sentences)


# The verdict on the safety of a job that was not checked yet.
PENDING = Verdict()
