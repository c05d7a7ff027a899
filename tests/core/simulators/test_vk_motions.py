# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motions that FreeCAD's simulators make of arcs and drilling cycles."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators.motions import motions


def test_chords_of_an_arc_are_one_motion():
    made = motions(
        linearize(
            [
                ("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}),
                ("G3", {"X": -10.0, "Y": 0.0, "I": -10.0, "J": 0.0}),
                ("G3", {"X": 10.0, "Y": 0.0, "I": 10.0, "J": 0.0, "Z": -4.0}),
            ]
        )
    )
    assert np.allclose(made.sweep, [math.pi, math.pi])
    assert np.allclose(made.radius, [10, 10])
    assert np.allclose(made.move, [[-20, 0, 0], [20, 0, -4]])
    assert made.command.tolist() == [1, 2]


@pytest.mark.parametrize("sweep", [0.05, 0.4, 2.0, 3.5, 6.2])
@pytest.mark.parametrize("down", [0.0, 7.0])
def test_arc_of_any_sweep_is_one_motion(sweep, down):
    """The arc is around (0, 0), starts at (10, 0), and is level or goes down."""
    end = {"X": 10 * math.cos(sweep), "Y": 10 * math.sin(sweep), "Z": -down}
    path = linearize([("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}), ("G3", {**end, "I": -10.0, "J": 0.0})])
    made = motions(path)
    assert made.radius == pytest.approx([10.0], rel=1e-3) and made.sweep == pytest.approx([sweep])
    # Each straight move is a separate motion, even if several moves belong to one command.
    straight = motions(replace(path, sweep=np.zeros(len(path))))
    assert len(straight.move) == len(path) and not straight.radius.any()


def test_full_circle_is_one_motion():
    made = motions(linearize([("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}), ("G2", {"X": 10.0, "I": -10.0, "J": 0.0})]))
    assert made.sweep == pytest.approx([-2 * math.pi]) and made.radius == pytest.approx([10.0], rel=1e-5)


def test_arc_in_a_vertical_plane_stays_several_chords():
    path = linearize(
        [
            ("G18", {}),
            ("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}),
            ("G2", {"X": 10.0, "Z": 0.0, "I": 5.0, "K": 0.0}),
        ]
    )
    made = motions(path)
    assert len(made.sweep) == len(path) > 4 and not made.radius.any()


def test_peck_drilling_cycle_is_three_motions():
    made = motions(
        linearize(
            [
                ("G0", {"X": 0.0, "Y": 0.0, "Z": 20.0}),
                ("G83", {"X": 5.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "Q": 1.0, "F": 2.0}),
                ("G83", {"X": 15.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "Q": 1.0}),
                ("G80", {}),
            ]
        )
    )
    vertical = made.level < 1e-9
    assert np.allclose(made.move[vertical, 2], [-12, 12, -12, 12])
    assert made.command.tolist() == [1, 1, 1, 2, 2, 2]
    there = [("G0", {"X": 5.0, "Y": 5.0, "Z": 3.0}), ("G81", {"X": 5.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "F": 2.0})]
    assert np.allclose(motions(linearize(there)).move, [[0, 0, -12], [0, 0, 12]])  # The tool is already over the hole.
    # The cycles begin and end at the retract height over each hole, although the cycle returns to 20 mm.
    assert np.allclose(made.move[~vertical], [[5, 5, -17], [10, 0, 0]])


def test_empty_toolpath_has_no_motions():
    made = motions(linearize([("(nothing)", {})]))
    assert (
        made.move.shape == (0, 3) and len(made.sweep) == len(made.radius) == len(made.command) == len(made.level) == 0
    )
