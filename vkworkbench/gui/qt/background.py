# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run tasks in a background thread, and show their progress and results in the window. The user can cancel a task."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterable
from queue import Empty, SimpleQueue

from vkworkbench.document.computer import garbage
from vkworkbench.gui.qt.names import (
    QHBoxLayout,
    QLabel,
    QObject,
    QProgressBar,
    QPushButton,
    QTimer,
    QWidget,
    Signal,
    single_shot,
)
from vkworkbench.gui.qt.plain_text import as_plain
from vkworkbench.gui.qt.text import translate
from vkworkbench.report import Cancelled

_SLICE = 0.03  # longest time for showing results before Qt handles other events, s
_WATCH = 50  # ms between two checks whether a thread has ended
_DELAY = 300  # ms after which the progress line appears; shorter tasks do not show it
_LINGER = 200  # ms for which the progress line stays after a task, to avoid flicker if another task follows


class Background(QObject):
    """Runs one task at a time. A new task replaces the running one.

    The results of the thread are read every `look` ms.
    """

    began = Signal(str)  # a task has begun; the argument is its description
    over = Signal()  # the task has ended or was cancelled

    def __init__(self, parent: QObject | None = None, look: int = 20) -> None:
        super().__init__(parent)
        self._timer = QTimer(self)
        self._timer.setInterval(look)
        self._timer.timeout.connect(self._look)
        self._given_up: threading.Event | None = None

    @property
    def works(self) -> bool:
        return self._given_up is not None

    def start(self, text: str, work: Callable[[Callable], Iterable], show: Callable, ended: Callable) -> None:
        """Begin a task, which `text` describes.

        The generator function `work` yields results. Its argument is a function that raises `Cancelled` after a cancel.
        The generator runs in another thread, so it must use neither documents nor the window. In Qt's main thread,
        `show` is called with each result, and `ended` at the end: with None, with `Cancelled` if the user cancelled the
        task, or with the exception that ended the task. After `give_up`, `ended` is not called.
        """
        self.give_up()
        given_up, results = threading.Event(), SimpleQueue()
        self._given_up, self._results = given_up, results
        self._show, self._ended = show, ended
        thread = threading.Thread(target=_run, args=(work, given_up, results), daemon=True)
        # Start the thread after 1 ms, so that Qt first handles the events that waited while FreeCAD copied a path.
        QTimer.singleShot(1, lambda: _threads.begin(thread, work))
        self.began.emit(text)
        self._timer.start()

    def give_up(self) -> None:
        """End the running task without calling `ended`. The thread ends at the next step of the task."""
        if self._given_up is not None:
            self._given_up.set()
            self._end()

    def cancel(self) -> None:
        """End the running task because the user cancelled it."""
        if self.works:
            self.give_up()
            self._ended(Cancelled("given up"))

    def _end(self) -> None:
        self._given_up, self._results = None, SimpleQueue()
        self._timer.stop()
        self.over.emit()

    def _look(self) -> None:
        until = time.monotonic() + _SLICE
        while self.works and time.monotonic() < until:
            try:
                is_result, what = self._results.get_nowait()
            except Empty:
                return
            if is_result:
                self._show(what)
            else:
                self._end()
                self._ended(what)
                return


class _Threads:
    """Keeps references to the work of running threads, so that no thread destroys Qt objects (see `garbage`).

    A thread would destroy objects to which it holds the last reference, such as the tab that started it. Therefore this
    class refers to the thread's work until the thread has ended.
    """

    def __init__(self) -> None:
        self._works: dict[threading.Thread, Callable] = {}

    def begin(self, thread: threading.Thread, work: Callable) -> None:
        if not self._works:
            garbage.hold()
            QTimer.singleShot(_WATCH, self._watch)
        self._works[thread] = work
        thread.start()

    def _watch(self) -> None:
        garbage.collect()
        for thread in [thread for thread in self._works if not thread.is_alive()]:
            del self._works[thread]
        if self._works:
            QTimer.singleShot(_WATCH, self._watch)
        else:
            garbage.release()


_threads = _Threads()


def _run(work: Callable, given_up: threading.Event, results: SimpleQueue) -> None:
    def going_on() -> None:
        if given_up.is_set():
            raise Cancelled("given up")

    try:
        for result in work(going_on):
            results.put((True, result))
            going_on()
        results.put((False, None))
    except Exception as error:
        results.put((False, error))  # no function reads the error after `give_up`


class Busy(QWidget):
    """A line with the running task and a button to cancel the task, which appears after a delay.

    The line is hidden while no task runs.
    """

    def __init__(self, background: Background) -> None:
        super().__init__()
        self.label, bar = as_plain(QLabel()), QProgressBar()
        bar.setRange(0, 0)
        bar.setMaximumWidth(120)
        bar.setTextVisible(False)
        self.button = QPushButton(translate("Vk_Analyze", "Cancel"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.label, bar, self.button):
            row.addWidget(widget)
        row.addStretch(1)
        self.hide()
        self._later, self._at_last = single_shot(self.show, self, _DELAY), single_shot(self.hide, self, _LINGER)
        background.began.connect(self._announce)
        background.over.connect(self._end)
        self.button.clicked.connect(background.cancel)
        self.button.clicked.connect(self.hide)

    def _announce(self, text: str) -> None:
        self.label.setText(text)
        self._at_last.stop()
        if not self.isVisible():
            self._later.start()

    def _end(self) -> None:
        self._later.stop()
        self._at_last.start()
