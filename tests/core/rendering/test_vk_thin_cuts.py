# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts that are narrower than the rays' distance are lines in the picture."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from vkworkbench.core import Cut, Stock, Tool, View, linearize, simulate_job
from vkworkbench.core.rendering import CUT, Field, palette, scene

PLATE = Stock((0, 0, 0), (600, 400, 20))
LINE = [("G0", {"X": 50, "Y": 60, "Z": 25}), ("G1", {"Z": 19.7}), ("G1", {"X": 550, "Y": 341}), ("G0", {"Z": 25})]
# Both tools cut less than 1 mm wide, and the pixels of the simulation are 1 mm.
NARROW = {"end mill": Tool("endmill", 0.2), "V-bit": Tool("vbit", 6.0, tip_angle=pi / 3)}


def drawn(tool, direction=(0, 0, -1), step=None, moves=LINE, colors=None, **choices):
    done = simulate_job([Cut(linearize(moves), tool)], stock=PLATE, view=View(width=600, height=400))
    frame = View(direction, 600, 400).frame(PLATE)
    field = Field(done if step is None else done.at(step))
    return scene(field, frame, palette(CUT) if colors is None else colors, **choices)


@pytest.mark.parametrize("direction", [(0, 0, -1), (-1, 1, -1), (0.2, 1, -0.4)])
@pytest.mark.parametrize("tool", NARROW.values(), ids=NARROW)
def test_engraving_is_a_line_without_gaps(tool, direction):
    before, after = drawn(tool, direction, step=0), drawn(tool, direction)
    changed = (before.pixels != after.pixels).any(axis=0)
    columns = np.flatnonzero(changed)
    assert len(columns) > 100 and changed[columns[0] : columns[-1]].all()
    assert (np.isnan(before.depth) == np.isnan(after.depth)).all()


def test_engraved_line_grows_with_the_simulated_moves():
    shown = [int((drawn(NARROW["end mill"], step=step).owner >= 0).sum()) for step in range(4)]
    assert max(shown[:2]) <= 1 and min(shown[2:]) > 400


def test_engraved_line_has_the_number_of_its_trajectory():
    shown = drawn(NARROW["end mill"], lit=(1, 2))
    assert (shown.owner == 1).sum() > 400 and (shown.owner >= 2).sum() <= 1
    lit = shown.pixels[::-1] != drawn(NARROW["end mill"]).pixels[::-1]
    assert (lit == (shown.owner == 1)).all()


def test_engraving_behind_the_part_is_hidden():
    """From the right, a wall of 15 mm hides the engraving of the pocket floor beside it."""
    floor = [("G0", {"X": 300, "Y": -30, "Z": 25}), ("G1", {"Z": 5}), ("G1", {"Y": 430}), ("G0", {"Z": 25})]
    line = [("G0", {"X": 302, "Y": 20}), ("G1", {"Z": 4.9}), ("G1", {"Y": 380}), ("G0", {"Z": 25})]
    done = simulate_job(
        [Cut(linearize(floor), Tool("endmill", 20)), Cut(linearize(line), Tool("endmill", 0.2))],
        stock=PLATE, view=View(width=600, height=400),
    )  # fmt: skip
    first = done.cuts.first[1]
    for direction, is_seen in (((0, 0, -1), True), ((-1, 0, -0.5), False)):
        shown = scene(Field(done), View(direction, 600, 400).frame(PLATE), palette(CUT))
        assert ((shown.owner >= first).sum() > 300) == is_seen


def test_wide_cuts_are_not_drawn_as_lines_nor_views_from_below():
    for tool, direction in ((Tool("endmill", 6), (0, 0, -1)), (NARROW["end mill"], (0, 1, 1))):
        before, after = drawn(tool, direction, step=0), drawn(tool, direction)
        dark = (after.image.astype(int).sum(axis=-1) < 0.7 * before.image.astype(int).sum(axis=-1)).mean()
        assert dark < 0.001


def test_scallops_of_a_ball_nose_are_not_lines():
    rows = [("G0", {"X": 50, "Y": 50, "Z": 25})]
    for row in range(20):
        ends = (50, 90) if row % 2 == 0 else (90, 50)
        rows += [("G1", {"X": x, "Y": 50.3 + 1.3 * row, "Z": 19.0}) for x in ends]
    shown = drawn(Tool("ballend", 6.0), moves=rows)
    alone = drawn(Tool("ballend", 6.0), moves=rows, colors=np.tile(palette(CUT)[1], (400, 600, 1)))
    assert (shown.owner >= 0).sum() > 500
    inside = shown.owner[::-1] >= 0
    assert alone.image[inside].astype(int).sum(axis=-1).min() > 0.5 * int(palette(CUT)[1].astype(int).sum())
