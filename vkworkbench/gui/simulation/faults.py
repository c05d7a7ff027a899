# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation shows to be wrong: crashes, gouges, fast plunges; and the worst differences to the model."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.core.zbuffer import gouges, worst_places
from vkworkbench.gui.simulation.refining import Told
from vkworkbench.language import Message

# What is no difference to the model, mm, until the user says otherwise.
TOLERANCE = 0.1


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


@dataclass(frozen=True, eq=False)
class Judged:
    """What a simulation shows.

    Attributes
    ----------
    told : Told
        What it told.
    faults : list of Fault
        What is wrong, gouges beyond the tolerance.
    differences : list of Fault
        The worst differences to the model; empty where they were not asked for.
    proved : list of Fault
        What is wrong whatever tolerance one looks with; empty where the picture was too coarse to look at the model.
    """

    told: Told
    faults: list[Fault]
    differences: list[Fault]
    proved: list[Fault]


def judge(told: Told, tolerance: float, compares: bool) -> Judged:
    """Judge a simulation, in whatever thread: with many operations or pixels it takes a while.

    Parameters
    ----------
    told : Told
    tolerance : float
        What is no difference to the model yet, mm.
    compares : bool
        Whether the worst differences are asked for, too.
    """
    proved = [fault for fault in faults(told, TOLERANCE) if fault.serious] if told.judged else []
    worst = differences(told, tolerance) if compares else []
    return Judged(told, faults(told, tolerance), worst, proved)


def faults(told: Told, tolerance: float) -> list[Fault]:
    """Return what is wrong: rapid moves that cut, the worst gouge of each operation, fast plunges.

    Parameters
    ----------
    told : Told
    tolerance : float
        What is no gouge yet, mm.
    """
    found = [_fault(c, Message("rapid-cuts", volume=c.volume), serious=True) for c in told.crashes]
    if told.deviations is not None:
        gouged = gouges(told.simulation.zbuffer, told.deviations, tolerance)
        found += [_fault(g, Message("cuts-model", depth=g.depth), serious=True) for g in gouged]
    return found + [
        _fault(p, Message("plunges-fast", feed=60 * p.feed, allowed=60 * p.allowed), serious=False)
        for p in told.plunges
    ]


def differences(told: Told, tolerance: float) -> list[Fault]:
    """Return the places where the finished part differs most from the model: gouges first, then material left."""
    if told.deviations is None:
        return []
    gouged = worst_places(told.simulation.zbuffer, told.deviations.gouged, tolerance)
    left = worst_places(told.simulation.zbuffer, told.deviations.left, tolerance)
    return [
        *(_fault(one, Message("cuts-model", depth=one.depth), serious=True) for one in gouged),
        *(_fault(one, Message("leaves-material", depth=one.depth), serious=False) for one in left),
    ]


def _fault(one, what: Message, serious: bool) -> Fault:
    source = one.source
    return Fault(source and source.cut, source and source.command, one.trajectory, one.place, what, serious)
