# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faults of a job, as far as its pictures have shown them: in words, on the time line, in marks and results."""

from __future__ import annotations

from vkworkbench.document.simulation.faults import keep_faults
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.faults import Fault
from vkworkbench.gui.simulation.time_line import Warned
from vkworkbench.gui.tree import pills

_SERIOUS, _FAST = "#d32f2f", "#e08000"  # crashes and gouges, fast plunges


class KnownFaults:
    """What is known to be wrong with a job.

    Parameters
    ----------
    job : SimulatedJob
    clock : Clock
    """

    def __init__(self, job: SimulatedJob, clock: Clock) -> None:
        self.job, self.clock = job, clock
        # Of all views: a gouge that one does not see is there all the same.
        self._proved: dict[tuple, Fault] = {}
        self._judged = False  # whether a picture was fine enough to look for all of them
        self._holds = False  # whether the document is known to say what was simulated

    def text(self, fault: Fault) -> str:
        """Return where and what a fault is."""
        if fault.cut is None:
            return translate("Vk_Simulate", "raw stock: {}").format(sentence(fault.what))
        text = translate("Vk_Simulate", "{}, command {}: {} ({})")
        label, code = self.job.operations[fault.cut].label, self.job.listings[fault.cut][fault.command]
        return text.format(label, fault.command + 1, sentence(fault.what), code)

    def text_with_place(self, fault: Fault) -> str:
        """Return where and what a fault is, and at which point: one command, or the raw stock, may have several."""
        factor, unit = user().length_unit(max(map(abs, fault.place)))
        x, y, z = (user().number(round(value / factor, 3), 5) for value in fault.place)
        return translate("Vk_Simulate", "{}, at X {} Y {} Z {} {}").format(self.text(fault), x, y, z, unit)

    def marks(self, found: list[Fault]) -> tuple[Warned, ...]:
        """Return faults as marks of the time line; what the raw stock lacks has no moment."""
        return tuple(
            Warned(
                float(self.clock.ends[fault.trajectory + 1]),
                lambda fault=fault: self.text(fault),
                _SERIOUS if fault.serious else _FAST,
            )
            for fault in found
            if fault.trajectory is not None
        )

    @property
    def gouges(self) -> list[Fault]:
        """What is known to cut into the model."""
        return [fault for fault in self._proved.values() if fault.gouged]

    def keep(self, proved: list[Fault]) -> None:
        """Keep what a picture has shown, for marks and results to tell."""
        for fault in proved:
            key = fault.cut, fault.what.code, fault.command
            # The newest facts, and how deep it is where one looks least along it.
            if key not in self._proved or fault.gouged <= self._proved[key].gouged:
                self._proved[key] = fault
        self._judged = True
        self._tell()

    def follow(self, holds: bool) -> None:
        """Let marks and results tell it for as long as the document says what was simulated."""
        self._holds = holds
        self._tell()

    def _tell(self) -> None:
        if not (self._holds and self._judged):
            return
        wrong = sorted(self._proved.values(), key=lambda fault: fault.what.code != "rapid-cuts")
        changed = keep_faults({
            operation: [(fault.command, fault.what) for fault in wrong if fault.cut == number]
            for number, operation in enumerate(self.job.operations)
        })  # fmt: skip
        if changed:
            pills.show()
            results = docks.find(docks.RESULTS)
            if results is not None:
                results.refresh()
