# SPDX-License-Identifier: LGPL-2.1-or-later
"""Garbage collection while other threads work: only `garbage.collect` collects Python's garbage."""

from __future__ import annotations

import gc
import platform
import sys
import threading
import weakref
from pathlib import Path

import pytest

from vkworkbench.document.computer import garbage


class Ring:
    """An object that refers to itself, so that only Python's cyclic garbage collector removes it."""

    def __init__(self):
        self.itself = self


@pytest.fixture
def collector():
    """Switch the garbage collector on and remove old garbage; restore its settings after the test."""
    threshold = gc.get_threshold()
    gc.enable()
    gc.collect()
    yield gc
    gc.enable()
    gc.set_threshold(*threshold)


def gone():
    """Return a weak reference to an unreachable object that refers to itself (a reference cycle)."""
    return weakref.ref(Ring())


def test_garbage_collection_is_on_after_the_last_release(collector):
    garbage.hold()
    assert not gc.isenabled()
    garbage.hold()
    garbage.release()
    assert not gc.isenabled()
    garbage.release()
    assert gc.isenabled()


def test_garbage_collection_stays_off_if_it_was_off_before(collector):
    gc.disable()
    garbage.hold()
    garbage.release()
    assert not gc.isenabled()


def test_young_garbage_is_collected_above_the_threshold(collector):
    garbage.hold()
    ring = gone()
    gc.set_threshold(1_000_000)
    garbage.collect()
    assert ring() is not None  # the ring is not collected, because there are too few new objects for a collection
    gc.set_threshold(1)
    more = [[] for _ in range(10)]
    garbage.collect()
    assert ring() is None and len(more) == 10
    garbage.release()


@pytest.mark.skipif(sys.version_info >= (3, 14), reason="Python collects a part of what is old each time")
def test_old_garbage_is_not_collected_while_held(collector):
    ring = Ring()
    gc.collect()
    garbage.hold()
    ring, old = None, weakref.ref(ring)
    gc.set_threshold(1)
    more = [[] for _ in range(10)]
    garbage.collect()
    assert old() is not None and len(more) == 10
    garbage.release()


def test_collector_that_the_user_switched_off_stays_off(collector):
    gc.disable()
    garbage.hold()
    ring = gone()
    gc.set_threshold(1)
    more = [[] for _ in range(10)]
    garbage.collect()
    assert ring() is not None and len(more) == 10
    garbage.release()


def resident():
    """Return the resident memory of this process, bytes."""
    (line,) = [line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmRSS:")]
    return 1024 * int(line.split()[1])


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library")
def test_freed_memory_returns_to_the_system(collector):
    kept = []

    def work():
        blocks = [bytes([1]) * 60_000 for _ in range(2_000)]
        # This used block comes last, because the C library keeps freed memory that precedes a used block.
        kept.append(bytes([1]) * 60_000)
        blocks.clear()

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    before = resident()
    garbage.give_back()
    assert before - resident() > 100e6
