# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict on the safety of a job names its faults, the resolution of the check, and the missing checks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from zbuffer_inputs import toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import (
    PENDING,
    Collision,
    Collisions,
    CrashCheck,
    Source,
    Verdict,
    check_crashes,
    facts,
    simulate_job,
)
from vkworkbench.language import Message, render
from vkworkbench.report import JobVerdict

LABELS = ["Face", "Engrave"]
SOUND = Verdict(pixel=0.12)


def text(verdict):
    return render(verdict.message(LABELS))


def test_job_is_sound_only_if_it_was_checked_and_cuts_the_stock():
    texts = [text(one) for one in (SOUND, PENDING, replace(SOUND, met=False))]
    assert texts == [
        "No collision, gouge or fast plunge, checked to 0.12 mm. Shank, holder and clamps were not checked.",
        "Nothing is checked yet.",
        "Nothing was checked, because no tool meets the stock. Check the stock and its position.",
    ]
    assert [one.is_sound for one in (SOUND, PENDING, replace(SOUND, met=False))] == [True, False, False]


@pytest.mark.parametrize(
    "fault, sentence",
    [
        ({"crashes": 1}, "1 rapid cuts into material."),
        ({"crashes": 3}, "3 rapids cut into material."),
        ({"gouges": 2, "deepest_gouge": 0.5}, "2 gouges are up to 0.5 mm deep in the model."),
        (
            {"lacking": 4.0},
            "The stock is 4 mm too small for the model. Choose a larger stock, or move the model within it.",
        ),
        ({"fast_plunges": 2}, "2 plunges are too fast."),
    ],
)
def test_verdict_on_a_job_begins_with_the_faults(fault, sentence):
    verdict = replace(SOUND, **fault)
    assert text(verdict) == f"{sentence} Checked to 0.12 mm. Shank, holder and clamps were not checked."
    assert not verdict.is_sound


def test_collisions_of_shanks_are_faults():
    """The verdict names the deepest collision of each kind, and the checks that were made."""
    first, second = (Collision("shank", k, Source(k, 0, 0), Source(k, 5, 5), (0, 0, 0), 2.0 + k) for k in range(2))
    checked = replace(SOUND, collisions=Collisions((first, second), 0.1, (True, True), (False, False), 0))
    assert text(checked) == (
        "The shank collides with material 3 mm high. Checked to 0.12 mm. Shank checked; no holder and no clamps given."
    )
    assert not checked.is_sound and replace(checked, collisions=replace(checked.collisions, found=())).is_sound


def test_verdict_on_a_job_with_unread_parts_is_not_sound():
    first, second = Message("of", label="Pocket", sentence=Message("no-tool")), Message("stock-around-cuts")
    unsure = replace(SOUND, unread=(first,))
    assert not unsure.is_sound and text(unsure) == (
        "No collision, gouge or fast plunge was found, checked to 0.12 mm. Not everything could be checked: Pocket: The "
        "operation has no tool. Give it a tool controller. Shank, holder and clamps were not checked."
    )
    assert "for 2 reasons. The first reason: Pocket" in text(replace(SOUND, unread=(first, second)))
    assert text(replace(unsure, crashes=1)).startswith("1 rapid cuts into material. Checked to 0.12 mm. Not everything")
    assert "and its position. Not everything" in text(replace(unsure, met=False))


def test_verdict_names_everything_that_was_not_checked():
    partly = replace(SOUND, compared=False, unjudged=(1,), unchecked=(Source(1, 7, 6),))
    assert text(partly) == (
        "No collision or fast plunge was found, checked to 0.12 mm. "
        "1 move was not checked for lack of time: command 7 of Engrave. "
        "Gouges were not checked, because the job has no model with a volume. "
        "Gouges of Engrave were not checked, because the tool is simulated by a simpler shape. "
        "Shank, holder and clamps were not checked."
    )


@pytest.mark.parametrize(
    "left_out",
    [{"unjudged": (1,)}, {"unchecked": (Source(1, 7, 6),)}, {"walls_checked": False}],
    ids=lambda one: next(iter(one)),
)
def test_verdict_is_not_sound_if_a_check_was_left_out(left_out):
    partly = replace(SOUND, **left_out)
    assert not partly.is_sound and not JobVerdict(partly.message(LABELS), "x").is_sound
    assert text(partly).startswith("No collision, gouge or fast plunge was found, checked to 0.12 mm. ")


STOCK = Stock((0, 0, 0), (40, 30, 10))


def verdict_of(points, rapid=(), model=None, allowed=0.0, **check):
    moves = toolpath(np.array(points, float))
    cut = Cut(replace(moves, rapid=np.isin(np.arange(len(moves)), rapid)), Tool("endmill", 0.1), 0.0, allowed)
    zbuffer = simulate_job([cut], stock=STOCK, view=View(width=20, height=15))
    return facts(zbuffer, check_crashes([cut], STOCK, **check), model=model).verdict


def test_verdict_counts_crashes_between_the_rays_of_the_image():
    """The tool's diameter is a twentieth of a pixel."""
    drilled = [(10.5, 10.5, 12), (10.5, 10.5, 8), (10.5, 10.5, 12)]
    assert verdict_of(drilled, [0]) == Verdict(pixel=2.0, compared=False, crashes=1)
    assert verdict_of(drilled, [0], seconds=0).unchecked == (Source(0, 0, 0),)
    assert verdict_of(drilled).is_sound and verdict_of(drilled).met
    assert not verdict_of([(10, 10, 12), (20, 10, 12)]).met
    assert verdict_of(drilled, model=STOCK, allowed=np.inf).unjudged == (0,)


def test_crash_in_the_image_counts_without_a_crash_check():
    cut = Cut(
        replace(toolpath(np.array([(10, 10, 12), (10, 10, 5)], float)), rapid=np.array([True])), Tool("endmill", 6)
    )
    zbuffer = simulate_job([cut], stock=STOCK, view=View(width=80, height=60))
    assert facts(zbuffer, CrashCheck(unchecked=(Source(0, 0, 0),))).verdict.crashes == 1
