# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read a job: copy its operations between Qt's events, linearise their arcs in a thread, and show a preview."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import suppress

from vkworkbench import preferences
from vkworkbench.core import Frame, View
from vkworkbench.core.rendering import CUT, Field, Scene, palette, scene
from vkworkbench.document.simulation.copy import JobCopy, ReadCut
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation, simulate_read
from vkworkbench.gui.qt.background import Background, Busy
from vkworkbench.gui.qt.names import QTimer, QVBoxLayout, QWidget, Signal
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.simulating import ABOVE
from vkworkbench.language import Unusable

_PREVIEW = 120  # longer side of the preview, pixels
_FIRST = 0.3  # s until the first preview
_PAUSE = 3.0  # time between two previews, as a multiple of the time that a preview takes


class Reading(QWidget):
    """Reads a job, and shows the part as machined by the operations read so far."""

    read = Signal(object)  # the whole job was read; the argument is a `SimulatedJob`
    failed = Signal(object)  # reading ended with `Cancelled`, `Unusable` or an error

    def __init__(self, copy: JobCopy, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.copy = copy
        self.view: PartView | None = None  # the widget with the preview; None before the first preview
        self.seen: tuple[Scene, Frame] | None = None  # the shown preview
        self._budget = preferences.read().memory_budget_bytes
        self._cuts: list[ReadCut] = []
        self._steps = copy.copying()
        self._background = Background(self)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._busy = Busy(self._background)
        self._layout.addWidget(self._busy)
        self._background.start(self._text(), self._work, self._take, self._ended)
        QTimer.singleShot(0, self._copy_on)  # delayed, because the caller first has to connect the signal `failed`

    def end(self) -> None:
        """Stop reading."""
        self._background.give_up()

    def _copy_on(self) -> None:
        """Copy one operation, then return to Qt's event loop before the next operation."""
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
        cuts, due = [], time.perf_counter() + _FIRST
        for cut in self.copy.read(going_on):
            yield cut
            cuts.append(cut)
            begin = time.perf_counter()
            if begin >= due and len(cuts) < len(self.copy.names):
                # There is no preview if the operations read so far have no toolpath, or if memory is too short.
                with suppress(Unusable):
                    yield _preview(self.copy.job(cuts), self._budget, going_on)
                due = time.perf_counter() + _PAUSE * (time.perf_counter() - begin)

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
            self.view = PartView(found.job.stock, preferences.DIRECTIONS["Isometric"])
            self._layout.addWidget(self.view, 1)
        frame = self.view.frame
        self.seen = scene(Field(found.zbuffer), frame, palette(CUT), background=self.view.background), frame
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


def _preview(job: SimulatedJob, memory_budget: float, going_on: Callable[[], None]) -> Simulation:
    """Return a coarse simulation of a job from above."""
    done = simulate_read(job, View(ABOVE, _PREVIEW, _PREVIEW), memory_budget, lambda _: going_on())
    done.zbuffer.picture  # noqa: B018 - computed here and not in Qt's main thread
    return done
