# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths of lathes are distinguished from toolpaths of a mill that never moves in Y."""

from __future__ import annotations

import pytest

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.recognition.patterns.turned import is_turned

SAFE = 5.0


def turning(passes, length=40.0, depth=1.0, quick=True):
    """Return roughing passes along Z, each nearer to the axis, with a lead-out in X."""
    program = [("G0", {"X": 30.0, "Y": 0.0, "Z": 2.0})]
    for k in range(1, passes + 1):
        x = 30.0 - depth * k
        program += [("G0", {"X": x}), ("G1", {"Z": -length}), ("G1", {"X": x + depth})]
        program.append(("G0" if quick else "G1", {"Z": 2.0}))
    return program


def slots(count, length=14.0, depth=6.0):
    """Return slots in a row along X."""
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": SAFE})]
    for k in range(count):
        x = 20.0 * k
        program += [("G0", {"X": x}), ("G1", {"Z": -depth}), ("G1", {"X": x + length}), ("G0", {"Z": SAFE})]
    return program


def holes(count, up="G0", across="G0"):
    """Return holes in a row along X.

    The moves between the holes can be at feed (G1), because some programs have no rapids.
    """
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": SAFE})]
    for k in range(count):
        program += [(across, {"X": 10.0 * k, "Z": SAFE}), ("G1", {"Z": -20.0}), (up, {"Z": SAFE})]
    return program


@pytest.mark.parametrize("quick", [True, False])
@pytest.mark.parametrize("passes", [3, 12])
def test_roughing_of_a_lathe_is_unknown_with_a_reason(passes, quick):
    found = recognize(linearize(turning(passes, quick=quick)))
    assert found.strategy is Strategy.UNKNOWN
    assert "as on a lathe" in found.reason


@pytest.mark.parametrize(
    "program",
    [slots(1), slots(12), holes(9), holes(9, up="G1"), holes(9, up="G1", across="G1"), turning(2)],
    ids=["slot", "slots", "holes", "holes left at feed", "holes without rapids", "too few passes"],
)
def test_mill_program_without_y_is_not_a_lathe(program):
    assert "lathe" not in recognize(linearize(program)).reason


def test_program_with_a_single_move_in_y_is_not_for_a_lathe():
    program = [*turning(12), ("G1", {"Y": 0.5})]
    assert "lathe" not in recognize(linearize(program)).reason and not is_turned(linearize(program))


def test_rapids_and_flat_ramps_are_not_lathe_passes():
    dashes = [("G0", {"X": 0.0, "Y": 0.0, "Z": 40.0})]
    ramps = list(dashes)
    for k in range(8):
        x = 10.0 * k
        dashes += [("G0", {"X": x}), ("G0", {"Z": -0.2}), ("G1", {"X": x + 5.0}), ("G0", {"Z": 40.0})]
        ramps += [("G0", {"X": x}), ("G1", {"X": x + 6.0, "Z": 35.0}), ("G1", {"X": x + 7.0}), ("G0", {"Z": 40.0})]
    assert not is_turned(linearize(dashes))
    assert not is_turned(linearize(ramps))
    assert is_turned(linearize(turning(3)))


@pytest.mark.parametrize("length, lathe", [(2.0, True), (0.8, False)])
def test_lathe_passes_are_mostly_along_z(length, lathe):
    """Each pass begins 2 mm above Z0 and ends with 2 mm along X. A length of 4 mm along Z is enough, 2.8 mm is not."""
    assert is_turned(linearize(turning(5, length, depth=2.0))) is lathe


def test_lathe_passes_may_all_end_at_one_x():
    """For a lathe, the cuts must differ in X, but their ends may be equal.

    All lead-outs can end at one X, for example at a collar.
    """
    program = [("G0", {"X": 30.0, "Y": 0.0, "Z": 2.0})]
    for x in (29.0, 28.0, 27.0):
        program += [("G0", {"X": x}), ("G1", {"Z": -40.0}), ("G1", {"X": 30.0}), ("G0", {"Z": 2.0})]
    assert is_turned(linearize(program))
    grooves = [("G0", {"X": 30.0, "Y": 0.0, "Z": 2.0})]
    for out in (29.0, 28.0, 27.0):
        grooves += [("G0", {"X": 26.0}), ("G1", {"Z": -40.0}), ("G1", {"X": out}), ("G0", {"Z": 2.0})]
    assert not is_turned(linearize(grooves))


def test_lathe_pass_must_end_with_a_move_along_x():
    """The third pass ends the program, or retracts along its own line."""
    last = [("G0", {"X": 27.0}), ("G1", {"Z": -40.0})]
    assert not is_turned(linearize([*turning(2), *last]))
    assert not is_turned(linearize([*turning(2), *last, ("G1", {"Z": 2.0})]))
    assert is_turned(linearize([*turning(2), *last, ("G0", {"X": 28.0})]))
    assert is_turned(linearize([*turning(2), *last, ("G1", {"X": 28.0})]))


def test_climbing_steps_are_not_lathe_passes():
    """Steps of 0.5 mm up, each followed by a cut along X, climb a slope without a cut downward."""
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": -20.0})]
    for k in range(1, 9):
        program += [("G1", {"Z": -20.0 + 0.5 * k}), ("G1", {"X": 0.3 * k})]
    assert not is_turned(linearize(program))
    down = [(name, {axis: -v if axis == "Z" else v for axis, v in words.items()}) for name, words in program]
    assert is_turned(linearize(down))
