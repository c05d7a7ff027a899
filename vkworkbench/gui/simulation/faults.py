# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation shows to be wrong: crashes, gouges, fast plunges; and the worst differences to the model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench.core.zbuffer import TOLERANCE, Deviation, gouges, worst_places
from vkworkbench.gui.simulation.refining import Facts, Told
from vkworkbench.language import Message


@dataclass(frozen=True)
class Fault:
    """Something that is wrong, and where.

    Attributes
    ----------
    cut : int or None
        The operation that made it; None where none did.
    command : int or None
        Its command.
    trajectory : int or None
        The trajectory, numbered through.
    place : (3,) tuple of float
        mm.
    what : Message
    serious : bool
        Whether the part, the tool or the machine suffers.
    """

    cut: int | None
    command: int | None
    trajectory: int | None
    place: tuple[float, float, float]
    what: Message
    serious: bool

    @property
    def of_finished_part(self) -> bool:
        """Whether it is to be seen at the end, not when its trajectory is cut."""
        return self.what.code == "leaves-material"

    @property
    def gouged(self) -> float:
        """How deep it cuts into the model, or how much of that the stock lacks, mm."""
        return self.what.arguments["depth"] if self.what.code in ("cuts-model", "stock-lacks") else 0.0


@dataclass(frozen=True, eq=False)
class Judged:
    """What a simulation shows.

    Attributes
    ----------
    facts : Facts or None
        What is known of the trajectories.
    faults : list of Fault
        What is wrong, gouges beyond the tolerance.
    differences : list of Fault or None
        The worst differences to the model; None where they were not asked for.
    proved : list of Fault or None
        What is wrong whatever tolerance one looks with; None where the picture was too coarse to look at the model.
    """

    facts: Facts | None
    faults: list[Fault]
    differences: list[Fault] | None
    proved: list[Fault] | None


def judge(told: Told, facts: Facts | None, tolerance: float, before: Sequence[Fault], compares: bool) -> Judged:
    """Judge a simulation, in whatever thread: with many operations or pixels it takes a while.

    Parameters
    ----------
    told : Told
    facts : Facts or None
        What is known of the trajectories, of this or of an earlier image.
    tolerance : float
        What is no difference to the model yet, mm.
    before : sequence of Fault
        What other images showed: a gouge that is beside this one, or that one does not see from here, is there all the same.
    compares : bool
        Whether the worst differences are asked for, too.
    """
    crashed = [] if facts is None else [_fault(c, Message("rapid-cuts", volume=c.volume), True) for c in facts.crashes]
    plunged = [] if facts is None else [
        _fault(p, Message("plunges-fast", feed=60 * p.feed, allowed=60 * p.allowed), False) for p in facts.plunges
    ]  # fmt: skip
    # A part is a finer image of the same view, which finds what is deeper; another view may have looked less along a gouge.
    rank = -1 if told.facts is None else 1
    gouged = _gouged(told, tolerance) + [fault for fault in before if fault.gouged > tolerance]
    of_commands: dict[tuple, Fault] = {}
    for fault in sorted(gouged, key=lambda fault: rank * fault.gouged):
        of_commands.setdefault((fault.cut, fault.command), fault)
    deepest = {fault.cut: fault for fault in sorted(of_commands.values(), key=lambda fault: fault.gouged)}
    gouged = sorted(deepest.values(), key=lambda fault: -fault.gouged)
    proved = crashed + _gouged(told, TOLERANCE) if told.judged else None
    worst = differences(told, tolerance) if compares else None
    return Judged(facts, crashed + gouged + plunged, worst, proved)


def _gouged(told: Told, tolerance: float) -> list[Fault]:
    """Return the worst gouge of each operation, and where the stock lacks most."""
    if told.deviations is None:
        return []
    found = gouges(told.simulation.zbuffer, told.deviations, tolerance)
    return [_gouge(one) for one in found]


def differences(told: Told, tolerance: float) -> list[Fault]:
    """Return the places where the finished part differs most from the model: gouges first, then material left."""
    if told.deviations is None:
        return []
    gouged, left = worst_places(told.simulation.zbuffer, told.deviations, tolerance)
    return [
        *map(_gouge, gouged),
        *(_fault(one, Message("leaves-material", depth=one.depth), serious=False) for one in left),
    ]


def _gouge(one: Deviation) -> Fault:
    """Return a place where material of the model is missing: a command cut it away, or the stock never had it."""
    lacks, cut = Message("stock-lacks", depth=one.depth), Message("cuts-model", depth=one.depth)
    return _fault(one, lacks if one.source is None else cut, True)


def _fault(one, what: Message, serious: bool) -> Fault:
    source = one.source
    return Fault(source and source.cut, source and source.command, one.trajectory, one.place, what, serious)
