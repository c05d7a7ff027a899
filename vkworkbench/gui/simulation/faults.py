# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faults of a checked job: collisions, crashes, gouges, fast plunges, and the largest differences from the model.

Faults are listed in a menu, drawn on the time line, and passed to the marks in the tree and to the results panel.
"""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.core.zbuffer import PENDING, TOLERANCE, Deviation, Verdict, worst_places
from vkworkbench.document.simulation.faults import keep_faults, keep_verdict
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.plain_text import shortened
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.moment import Clock
from vkworkbench.gui.simulation.simulating import Findings
from vkworkbench.gui.simulation.time_line import Warned
from vkworkbench.gui.tree import pills
from vkworkbench.language import Message


@dataclass(frozen=True)
class Fault:
    """A fault with its place on the part."""

    cut: int | None  # number of the operation that caused the fault; None if no operation caused it
    command: int | None  # number of the command in the operation
    trajectory: int | None  # number of the trajectory, counted over all operations
    place: tuple[float, float, float]  # position of the fault, mm
    what: Message
    serious: bool  # whether the fault damages the part, the tool or the machine

    @property
    def of_finished_part(self) -> bool:
        """Whether the fault can be seen only on the finished part (leftover material)."""
        return self.what.code == "leaves-material"

    @property
    def gouged(self) -> float:
        """Depth of a cut into the model, or of missing stock, mm; 0 for other faults."""
        return self.what.arguments["depth"] if self.what.code in ("cuts-model", "stock-lacks") else 0.0


@dataclass(frozen=True, eq=False)
class Judgement:
    """The faults of a job."""

    faults: list[Fault]  # collisions, crashes, gouges deeper than the chosen tolerance, and fast plunges
    differences: list[Fault] | None  # the largest differences from the model; None if not requested
    proved: list[Fault]  # collisions, crashes, and gouges deeper than the default tolerance


def judge(findings: Findings, tolerance: float, compares: bool) -> Judgement:
    """Find the faults of a job. This function is slow, and any thread may run it.

    `tolerance` is the allowed difference between the part and the model, mm. If `compares` is True, the largest
    differences from the model are found, too.
    """
    job = findings.facts.job
    collided = [_fault(one, one.what, True) for one in (*job.collisions, *job.crashes)]
    plunged = [_fault(one, one.what, False) for one in job.fast_plunges]
    beyond = job if tolerance == TOLERANCE else findings.along_axis.facts(tolerance).job
    gouged = [_gouge(one) for one in beyond.gouges]
    worst = differences(findings, tolerance) if compares else None
    return Judgement(collided + gouged + plunged, worst, collided + [_gouge(one) for one in job.gouges])


def differences(findings: Findings, tolerance: float) -> list[Fault]:
    """Return the places where the finished part differs most from the model: gouges, then leftover material."""
    if findings.deviations is None:
        return []
    gouged, left = worst_places(findings.along_axis.zbuffer, findings.deviations, tolerance)
    return [
        *map(_gouge, gouged),
        *(_fault(one, Message("leaves-material", depth=one.depth), serious=False) for one in left),
    ]


def _gouge(one: Deviation) -> Fault:
    """Return the fault for missing material, which either a command has cut away or the stock never had."""
    return _fault(one, one.gouge_message, True)


def _fault(one, what: Message, serious: bool) -> Fault:
    source = one.source
    return Fault(source and source.cut, source and source.command, one.trajectory, one.place, what, serious)


_SERIOUS, _FAST = "#d32f2f", "#e08000"  # colours on the time line: serious faults, and fast plunges


class KnownFaults:
    """The faults of a job that the marks in the tree and the results panel show."""

    def __init__(self, job: SimulatedJob, clock: Clock) -> None:
        self.job, self.clock = job, clock
        self._proved: list[Fault] | None = None  # faults at the default tolerance; None until the job was checked
        self._verdict = PENDING
        self._holds = False  # whether the document is unchanged since the job was read

    def text(self, fault: Fault) -> str:
        """Return a fault as text, with the operation, the command's number and the G-code of the command."""
        if fault.cut is None:
            return translate("Vk_Simulate", "Stock: {}").format(sentence(fault.what))
        text = translate("Vk_Simulate", "{}, command {} ({}): {}")
        label, code = self.job.operations[fault.cut].label, self.job.listings[fault.cut][fault.command]
        return text.format(shortened(label), fault.command + 1, code, sentence(fault.what))

    def text_with_place(self, fault: Fault) -> str:
        """Return a fault as text with its position, which distinguishes several faults of one command."""
        factor, unit = user().length_unit(max(map(abs, fault.place)))
        x, y, z = (user().number(round(value / factor, 3), 5) for value in fault.place)
        return translate("Vk_Simulate", "{} (X {} Y {} Z {} {})").format(self.text(fault), x, y, z, unit)

    def marks(self, found: list[Fault]) -> tuple[Warned, ...]:
        """Return the warnings for the time line, without missing stock, which no trajectory causes."""
        return tuple(
            Warned(
                float(self.clock.ends[fault.trajectory + 1]),
                lambda fault=fault: self.text(fault),
                _SERIOUS if fault.serious else _FAST,
            )
            for fault in found
            if fault.trajectory is not None
        )

    def keep(self, proved: list[Fault], verdict: Verdict) -> None:
        """Store the faults and the verdict of a check, and show them in the marks in the tree and the results panel."""
        self._proved, self._verdict = proved, verdict
        self._publish()

    def follow(self, holds: bool) -> None:
        """Show the faults in the tree's marks and the results panel only while the document is unchanged (`holds`)."""
        self._holds = holds
        self._publish()

    def _publish(self) -> None:
        if self._proved is None or not self._holds:
            return
        changed = keep_faults({
            operation: [(fault.command, fault.what) for fault in self._proved if fault.cut == number]
            for number, operation in enumerate(self.job.operations)
        })  # fmt: skip
        judged = keep_verdict(self.job, self._verdict)
        if changed or judged:
            pills.show()
            results = docks.find(docks.RESULTS)
            if results is not None:
                results.refresh()
