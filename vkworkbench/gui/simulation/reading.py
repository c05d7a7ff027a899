# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that is being read: copied between two events, linearised in a thread, and seen as far as it has come."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import suppress

from vkworkbench import preferences
from vkworkbench.core import Frame, View
from vkworkbench.core.rendering import CUT, Scene, palette, scene
from vkworkbench.document.simulation.copy import JobCopy, ReadCut
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation, simulate_read
from vkworkbench.gui.qt.background import Background, Busy
from vkworkbench.gui.qt.names import QTimer, QVBoxLayout, QWidget, Signal
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.language import Unusable

_ABOVE = (0.0, 0.0, -1.0)
_GLIMPSE = 120  # pixels, the longer side
_SOON = 0.3  # s after which something is to be seen
_RARELY = 3.0  # times as long as a glimpse takes is read before the next one


class Reading(QWidget):
    """Reads a job, and shows from above what the operations read so far make of the stock.

    Parameters
    ----------
    copy : JobCopy
        What is to be read.

    Attributes
    ----------
    view : PartView or None
        None until there is something to be seen.
    seen : Scene and Frame, or None
        What is shown.
    read : Signal of SimulatedJob
        All has been read.
    failed : Signal of Exception
        Something prevents it: `Cancelled`, `Unusable`, or an error.
    """

    read, failed = Signal(object), Signal(object)

    def __init__(self, copy: JobCopy, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.copy = copy
        self.view: PartView | None = None
        self.seen: tuple[Scene, Frame] | None = None
        self._budget = preferences.read().memory_budget_bytes
        self._cuts: list[ReadCut] = []
        self._steps = copy.copying()
        self._background = Background(self)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._busy = Busy(self._background)
        self._layout.addWidget(self._busy)
        self._background.start(self._text(), self._work, self._take, self._ended)
        QTimer.singleShot(0, self._copy_on)  # when somebody listens to what prevents it

    def end(self) -> None:
        """Give up."""
        self._background.give_up()

    def _copy_on(self) -> None:
        """Copy an operation, then let other events come."""
        if not self._background.works:
            return
        try:
            next(self._steps)
        except StopIteration:
            return
        except Exception as error:
            self._background.give_up()
            self.failed.emit(error)
        else:
            QTimer.singleShot(0, self._copy_on)

    def _work(self, going_on: Callable[[], None]) -> Iterator[ReadCut | Simulation]:
        cuts, due = [], time.perf_counter() + _SOON
        for cut in self.copy.read(going_on):
            yield cut
            cuts.append(cut)
            begin = time.perf_counter()
            if begin >= due and len(cuts) < len(self.copy.names):
                with suppress(Unusable):  # nothing yet, or too much
                    yield _glimpse(self.copy.job(cuts), self._budget, going_on)
                due = time.perf_counter() + _RARELY * (time.perf_counter() - begin)

    def _text(self) -> str:
        done, labels = len(self._cuts), self.copy.labels
        return translate("Vk_Simulate", "Reading {} ({} of {})…").format(labels[done], done + 1, len(labels))

    def _take(self, found: ReadCut | Simulation) -> None:
        if isinstance(found, ReadCut):
            self._cuts.append(found)
            if len(self._cuts) < len(self.copy.labels):
                self._busy.label.setText(self._text())
            return
        if self.view is None:
            self.view = PartView(found.job.stock, _ABOVE)
            self._layout.addWidget(self.view, 1)
        zbuffer = found.zbuffer
        self.seen = scene(zbuffer, palette(CUT), background=self.view.background), zbuffer.frame
        self.view.show_scene(*self.seen)

    def _ended(self, error: Exception | None) -> None:
        if error is not None:
            self.failed.emit(error)
            return
        try:
            job = self.copy.job(self._cuts)
        except Unusable as nothing:
            self.failed.emit(nothing)
        else:
            self.read.emit(job)


def _glimpse(job: SimulatedJob, memory_budget: float, going_on: Callable[[], None]) -> Simulation:
    """Simulate a job coarsely, from above."""
    done = simulate_read(job, View(_ABOVE, _GLIMPSE, _GLIMPSE), memory_budget, lambda _: going_on())
    done.zbuffer.picture  # noqa: B018 - here, not in the window
    return done
