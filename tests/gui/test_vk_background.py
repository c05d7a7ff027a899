# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in threads: objects of Qt must be destroyed in the thread of the window."""

import gc
import threading

from PySide import QtCore

from vkworkbench.gui.qt.background import Background, Busy


class Tells:
    """An object that appends the thread in which it is destroyed to a list."""

    def __init__(self, where):
        self.where, self.itself = where, self

    def __del__(self):
        self.where.append(threading.get_ident())


def test_thread_does_not_collect_garbage(window):
    where, ended, going, parent = [], [], threading.Event(), QtCore.QObject()

    def work(going_on):
        going.wait(20)
        yield [[] for _ in range(300_000)]  # many objects, so that Python starts a garbage collection

    window.wait(gc.isenabled)
    Background(parent).start("", work, lambda result: None, ended.append)
    window.idle(0.1)
    gc.collect()
    Tells(where)
    going.set()
    window.wait(lambda: ended)
    window.wait(gc.isenabled)
    gc.collect()
    assert ended == [None] and where == [threading.get_ident()]


def test_work_is_destroyed_in_the_windows_thread(window):
    where, parent = [], QtCore.QObject()
    background, going = Background(parent), threading.Event()

    class Work(Tells):
        def __init__(self):
            super().__init__(where)
            self.itself = None

        def __call__(self, going_on):
            yield 1
            going.wait(20)

    background.start("", Work(), lambda result: background.give_up(), lambda error: None)
    window.wait(lambda: not background.works)
    assert where == []  # the work was cancelled, but its thread still runs
    going.set()
    window.wait(lambda: where)
    assert where == [threading.get_ident()]
    window.wait(gc.isenabled)


def test_progress_line_stays_between_two_tasks(window):
    pieces, hidden = [], []
    background = Background()
    busy = Busy(background)

    class Hidden(QtCore.QObject):
        def eventFilter(self, watched, event):
            if event.type() == QtCore.QEvent.Hide:
                hidden.append(len(pieces))
            return False

    watch = Hidden()
    busy.installEventFilter(watch)

    def work(going_on):
        gone.wait(20)
        yield 1

    def begin(error=None):
        gone.clear()
        pieces.append(error)
        if len(pieces) < 4:
            QtCore.QTimer.singleShot(0, lambda: background.start("piece", work, lambda result: None, begin))

    gone = threading.Event()
    begin()
    for number in (1, 2, 3):
        window.wait(lambda: background.works and len(pieces) == number)
        window.wait(busy.isVisible)
        gone.set()
        window.wait(lambda: len(pieces) > number)
    window.wait(lambda: not busy.isVisible())
    assert hidden == [4]
