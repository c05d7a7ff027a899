# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in a thread of its own while the window lives on: progress, results piece by piece, and a way out."""

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

_AT_ONCE = 0.03  # s for showing results, then other events come
_WATCH = 50  # ms between two looks whether a thread has ended
_PATIENCE = 300  # ms; shorter work shows no progress
_LINGER = 200  # ms between two works that are pieces of one


class Background(QObject):
    """Does one work at a time; a new one takes the place of the one before.

    Parameters
    ----------
    look : int
        ms between two looks at what the thread has done.

    Attributes
    ----------
    began : Signal of str
        A work began; what it does.
    over : Signal
        It has ended, or was given up.
    """

    began = Signal(str)
    over = Signal()

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
        """Begin a work.

        Parameters
        ----------
        text : str
            What is being done.
        work : callable
            Given a function that raises `Cancelled` once the work has been given up; yields results, in a thread of
            its own that sees neither documents nor the window.
        show : callable
            Called with each result, in the window's thread.
        ended : callable
            Called when the work is over, with None, with `Cancelled` where the user gave it up, or with the exception
            that ended it; not called where it was given up otherwise.
        """
        self.give_up()
        given_up, results = threading.Event(), SimpleQueue()
        self._given_up, self._results = given_up, results
        self._show, self._ended = show, ended
        thread = threading.Thread(target=_run, args=(work, given_up, results), daemon=True)
        # After a ms, so that what waited while FreeCAD copied a path comes before.
        QTimer.singleShot(1, lambda: _threads.begin(thread, work))
        self.began.emit(text)
        self._timer.start()

    def give_up(self) -> None:
        """End the work, if there is one: its thread ends at its next step."""
        if self._given_up is not None:
            self._given_up.set()
            self._end()

    def cancel(self) -> None:
        """Give the work up because the user wants it."""
        if self.works:
            self.give_up()
            self._ended(Cancelled("given up"))

    def _end(self) -> None:
        self._given_up, self._results = None, SimpleQueue()
        self._timer.stop()
        self.over.emit()

    def _look(self) -> None:
        until = time.monotonic() + _AT_ONCE
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
    """The threads that work; nothing of Qt is destroyed in them, see `garbage`.

    A thread destroys what it is the last to let go of, such as the tab that its work belongs to: so that is kept until the
    thread has ended.
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
        results.put((False, error))  # nobody looks where it was given up


class Busy(QWidget):
    """A line that says what is being done, after a while in which nothing needs to be said, with a button to cancel.

    Parameters
    ----------
    background : Background
        What is shown of; hidden where it does nothing.
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
        self._later, self._at_last = single_shot(self.show, self, _PATIENCE), single_shot(self.hide, self, _LINGER)
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
