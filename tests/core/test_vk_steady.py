# SPDX-License-Identifier: LGPL-2.1-or-later
"""Durations of pieces of work, measured with clocks that return prescribed times."""

import os
import time

import numpy as np
import pytest

from vkworkbench.core.steady import processor_clock, steady_seconds


class Workshop:
    """Functions (pieces of work) with prescribed durations, and a clock that advances by these durations."""

    def __init__(self, *times):
        self.now, self.turns = 0.0, []
        self.pieces = [self._piece(place, iter(some)) for place, some in enumerate(times)]

    def _piece(self, place, times):
        def work():
            self.turns.append(place)
            self.now += next(times)

        return work

    def clock(self):
        return self.now


def test_work_is_timed_until_the_shortest_time_comes_three_times():
    shop = Workshop([5.0, 1.0, 9.0, 1.04, 1.2, 1.01, 7.0])
    assert steady_seconds(shop.pieces, most=20, clock=shop.clock) == pytest.approx([1.0])
    assert len(shop.turns) == 6


def test_shortest_time_is_returned_if_times_never_become_steady():
    shop = Workshop([2.0**k for k in range(9, -1, -1)])
    assert steady_seconds(shop.pieces, most=10, clock=shop.clock) == pytest.approx([1.0])


def test_only_work_with_unsteady_times_is_timed_again():
    shop = Workshop([1.0] * 3, [9.0, 3.0, 3.0, 3.0], [1e-3] * 3)
    found = steady_seconds(shop.pieces, most=20, clock=shop.clock)
    assert found == pytest.approx([1.0, 3.0, 1e-3])
    assert shop.turns == [0, 1, 2] * 3 + [1]


def test_callback_between_pieces_is_not_timed_and_may_stop():
    shop = Workshop([1.0] * 3, [2.0] * 3)
    calls = []

    def other_events():
        calls.append(list(shop.turns))
        shop.now += 50.0
        if len(shop.turns) == 4 and ends:
            raise InterruptedError

    ends = False
    assert steady_seconds(shop.pieces, most=20, clock=shop.clock, going_on=other_events) == pytest.approx([1.0, 2.0])
    assert calls == [[0, 1, 0, 1, 0, 1][:done] for done in range(6)]
    shop, ends = Workshop([1.0] * 3, [2.0] * 3), True
    with pytest.raises(InterruptedError):
        steady_seconds(shop.pieces, most=20, clock=shop.clock, going_on=other_events)
    assert shop.turns == [0, 1, 0, 1]


def test_times_on_a_busy_computer_equal_times_on_a_quiet_one():
    rng = np.random.default_rng(7)
    for _ in range(50):
        busy = (0.1 * (1 + rng.choice([0.0, 0.02, rng.uniform(0.1, 3.0)])) for _ in range(99))
        shop = Workshop(busy)
        assert steady_seconds(shop.pieces, most=20, clock=shop.clock) == pytest.approx([0.1], rel=0.03)


@pytest.mark.skipif(os.name == "nt", reason="its clock of the processor is too coarse")
def test_waiting_takes_no_processor_time():
    """The shortest of five waits is tested, because other work of a busy computer may disturb some waits."""
    times = [processor_clock()]
    for _ in range(5):
        time.sleep(0.05)
        times.append(processor_clock())
    assert np.diff(times).min() < 0.04
