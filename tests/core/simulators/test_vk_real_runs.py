# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user's own simulations teach, and how far off the next prediction is said to be."""

from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core import Stock, Tool, linearize
from vkworkbench.core.simulators import DEFAULTS, SIMULATORS, Seen, Task, legacy_costs, opengl_cost
from vkworkbench.core.simulators.real_runs import stated_factor

LESSONS = {lesson.kind: lesson for simulator in SIMULATORS for lesson in simulator.lessons}
CARD, SOFTWARE = DEFAULTS, replace(DEFAULTS, refresh=0.0, draw=15e-6, frame=42e-3)


def task(commands=1000):
    rows = [("G1", {"X": 10.0 + 60 * (i % 2), "Y": 5.0 + i % 40, "Z": 10.0, "F": 5.0}) for i in range(commands)]
    return Task(linearize(rows), Tool("endmill", 6.0), Stock((0, 0, 0), (100, 60, 20)))


def cost_of(kind, constants, commands=1000):
    if kind == "draw":
        return opengl_cost(task(commands), constants=constants)
    return legacy_costs(task(commands), constants=constants)[0]


def true_run(kind, cost, share=1.0):
    """A run that takes a share of what was predicted, undisturbed."""
    if kind == "draw":
        seconds = share * cost.play_seconds[10]
        return Seen(seconds, seconds, share * cost.frame_seconds, 10)
    seconds = share * (cost.play_seconds if kind == "play" else cost.fast_forward_seconds)
    return Seen(seconds, seconds)


@pytest.mark.parametrize("kind, waits", [("fast-forward", 1.0), ("play", 20.0), ("draw", 0.0)])
def test_a_run_that_took_far_longer_than_processor_and_timers_teaches_nothing(kind, waits):
    lesson, cost = LESSONS[kind], cost_of(kind, SOFTWARE)
    undisturbed = replace(true_run(kind, cost), seconds=5.0 + waits, processor_seconds=5.0)
    assert lesson.kept(cost, undisturbed, SOFTWARE) is not None
    assert lesson.kept(cost, replace(undisturbed, seconds=1.6 * (5.0 + waits)), SOFTWARE) is None


def test_a_fast_forward_waits_a_millisecond_for_each_command():
    """Of 4 s of waiting and 1 s of work, nothing is left to something else."""
    lesson, cost = LESSONS["fast-forward"], cost_of("fast-forward", SOFTWARE, 4000)
    assert lesson.waits(cost, SOFTWARE) == pytest.approx(4.0)
    assert lesson.kept(cost, Seen(5.0, 1.0), SOFTWARE) is not None


@pytest.mark.parametrize("panel", [0.3, 0.9])
def test_a_fast_forward_tells_of_its_panel_however_short_that_was(panel):
    """What it took beyond cutting and its mesh; where it took no longer than these, it tells nothing."""
    lesson, cost = LESSONS["fast-forward"], cost_of("fast-forward", SOFTWARE, 100)
    cutting = cost.fast_forward_seconds - cost.panel_seconds
    seconds = cutting + panel
    assert lesson.kept(cost, Seen(seconds, seconds), SOFTWARE) == pytest.approx((100, panel, seconds))
    assert lesson.kept(cost, Seen(0.9 * cutting, cutting), SOFTWARE) is None


def test_nobody_knows_how_long_a_graphics_card_works():
    lesson, cost = LESSONS["draw"], cost_of("draw", CARD)
    assert lesson.kept(cost, Seen(100.0, 1.0, 0.2, 10), CARD) is not None


@pytest.mark.parametrize("kind", LESSONS)
def test_the_error_of_a_run_is_that_of_what_the_others_teach(kind):
    lesson = LESSONS[kind]
    cost = cost_of(kind, SOFTWARE, 3000)
    runs = [lesson.kept(cost, true_run(kind, cost, share), SOFTWARE) for share in (1.5, 1.5, 1.5, 1.5, 3.0)]
    *same, odd = lesson.errors(runs, SOFTWARE)
    assert same == pytest.approx([1.0] * 4, abs=0.06) and odd == pytest.approx(2.0, rel=0.05)


@pytest.mark.parametrize("kind", ["fast-forward", "draw"])
def test_the_stated_factor_is_of_several_runs(kind):
    lesson = LESSONS[kind]
    cost, before = cost_of(kind, SOFTWARE), getattr(SOFTWARE, lesson.factor)
    runs = [lesson.kept(cost, true_run(kind, cost, share), SOFTWARE) for share in (1.0, 1.05, 0.95, 1.0)]
    for few in range(1, 4):
        assert lesson.taught(runs[:few], SOFTWARE)[lesson.factor] == before
    assert 1.02 < lesson.taught(runs, SOFTWARE)[lesson.factor] < 1.15
    assert lesson.taught((), SOFTWARE) == {}


@pytest.mark.parametrize("late", [0.0, 2.5])
def test_what_a_play_takes_longer_than_predicted_is_its_drawing(late):
    cost = cost_of("play", SOFTWARE, 3000)
    run = true_run("play", cost)
    seconds = cost.play_seconds + late
    shown, drawn, drawing, whole = LESSONS["play"].kept(
        cost, replace(run, seconds=seconds, processor_seconds=seconds), SOFTWARE
    )
    assert (shown, drawn, whole) == (cost.shown, cost.drawn, seconds)
    assert drawing == pytest.approx(cost.display_seconds + late)


def test_runs_are_read_as_so_many_numbers():
    assert LESSONS["draw"].read([1, "2.5"]) == (1.0, 2.5)
    for wrong in ([1.0], [1.0, 2.0, 3.0], []):
        with pytest.raises(ValueError, match="not 2"):
            LESSONS["draw"].read(wrong)
    assert LESSONS["fast-forward"].read((1, 2, 3)) == (1.0, 2.0, 3.0) and len(LESSONS["play"].read([0] * 4)) == 4


def test_a_play_whose_pictures_were_not_timed_teaches_nothing_of_drawing():
    seconds = 100.0
    assert LESSONS["draw"].kept(cost_of("draw", CARD), Seen(seconds, seconds), CARD) is None


def test_an_error_is_the_larger_over_the_smaller_and_endless_where_nothing_was_predicted():
    of_run = replace(LESSONS["draw"], learned=lambda runs, constants: {}, ratio=lambda run, constants: run[0])
    assert of_run.errors([(0.5,), (2.0,), (1.0,), (0.0,), (-1.0,)], CARD) == [2.0, 2.0, 1.0, np.inf, np.inf]


def test_errors_beyond_the_stated_factor_widen_it_at_once():
    assert stated_factor([], 2.0) == 2.0
    assert stated_factor([1.1, 3.0], 2.0) == 3.0
    assert stated_factor([1.1, 1.2, 1.3, 1.25], 2.0) == 1.3


def test_one_odd_run_among_many_does_not_count():
    errors = [1.1] * 11 + [1.4, 50.0]
    assert stated_factor(errors, 2.0) == 1.4
    assert stated_factor(errors[1:], 2.0) == 50.0


@pytest.mark.parametrize("runs, least", [(4, 0.77), (8, 0.85), (15, 0.84)])
def test_the_stated_factor_holds_as_often_as_it_says(runs, least):
    """n / (n + 1) of the next times with the largest of n errors; with the second largest (n - 1) / (n + 1)."""
    errors = np.exp(np.abs(np.random.default_rng(runs).normal(0, 0.3, (4000, runs + 1))))
    inside = [sorted_next <= stated_factor(before, 2.0) for *before, sorted_next in errors.tolist()]
    assert least < np.mean(inside) < least + 0.08
