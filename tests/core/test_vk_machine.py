# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machining times with acceleration, compared with formulas and with a planner that works move by move."""

from __future__ import annotations

from math import inf, pi, sqrt

import numpy as np
import pytest

from vkworkbench.core import MACHINES, Machine, Toolpath, linearize, machine_of_grbl, machining, trajectory_seconds

MACHINE = Machine((100.0, 100.0, 100.0), (200.0, 200.0, 200.0), 0.01)


def total(points, feed=20.0, machine=MACHINE):
    return machine.seconds(Toolpath.through(points, feed=feed)).sum()


def test_long_move_accelerates_and_brakes():
    assert total([(0, 0, 0), (100, 0, 0)]) == pytest.approx(100 / 20 + 20 / 200)


def test_short_move_does_not_reach_its_feed():
    # The tool accelerates for 0.5 mm at 200 mm/s^2, and brakes for 0.5 mm.
    assert total([(0, 0, 0), (1, 0, 0)]) == pytest.approx(2 * sqrt(2 * 0.5 / 200))


def test_collinear_moves_take_as_long_as_one_move():
    assert total([(x, 0, 0) for x in range(101)]) == pytest.approx(100 / 20 + 20 / 200)


def test_reversal_stops_the_tool():
    assert total([(0, 0, 0), (100, 0, 0), (0, 0, 0)]) == pytest.approx(2 * total([(0, 0, 0), (100, 0, 0)]))


def test_corner_speed_is_the_speed_on_its_rounding():
    # The rounding is a circle, tangent to both moves and 0.01 mm from the corner. The centre of the circle lies at 45
    # degrees.
    radius = 0.01 * sqrt(0.5) / (1 - sqrt(0.5))
    corner = sqrt(200 * sqrt(2) * radius)
    one = 100 / 20 + 20 / 200 / 2 + (20 - corner) ** 2 / (2 * 200 * 20)
    assert total([(0, 0, 0), (100, 0, 0), (100, 100, 0)]) == pytest.approx(2 * one)


def test_zero_deviation_stops_at_each_corner():
    stopping = Machine(MACHINE.rates, MACHINE.accelerations, 0.0)
    sides = total([(0, 0, 0), (100, 0, 0), (100, 100, 0)], machine=stopping)
    assert sides == pytest.approx(2 * total([(0, 0, 0), (100, 0, 0)]))


def test_slowest_axis_limits_a_slope():
    machine = Machine((100.0, 100.0, 10.0), (200.0, 200.0, 50.0), 0.01)
    seconds = total([(0, 0, 0), (300, 0, -400)], feed=100.0, machine=machine)
    assert seconds == pytest.approx(500 / 12.5 + 12.5 / 62.5)


def test_rapids_use_the_rates_of_the_axes():
    path = linearize([("G0", {"X": 0, "Y": 0, "Z": 0}), ("G0", {"X": 300, "Y": 400})])
    assert MACHINE.seconds(path).sum() == pytest.approx(500 / 125 + 125 / 250)


@pytest.mark.parametrize(("plane", "axes"), [("G17", "XY"), ("G18", "ZX"), ("G19", "YZ")])
def test_circle_is_limited_by_its_centripetal_acceleration(plane, axes):
    first, second = axes
    offset = {"X": "I", "Y": "J", "Z": "K"}[first]
    path = linearize([
        ("G0", {"X": 0, "Y": 0, "Z": 0}), (plane, {}),
        ("G3", {first: 0, second: 0, offset: -1, "F": 100}),
    ])  # fmt: skip
    speed = sqrt(200 * 1)
    assert MACHINE.seconds(path).sum() == pytest.approx(2 * pi / speed + speed / 200, rel=0.01)


def test_tangent_arc_does_not_stop():
    line = ("G1", {"X": 50, "F": 5})
    tangent = [("G0", {"X": 0, "Y": 0, "Z": 0}), line, ("G3", {"X": 50, "Y": 20, "I": 0, "J": 10, "F": 5})]
    path = linearize(tangent)
    assert MACHINE.seconds(path).sum() == pytest.approx((50 + 10 * pi) / 5 + 5 / 200, rel=1e-4)


def test_move_without_feed_has_no_time():
    path = linearize([("G0", {"X": 0, "Y": 0, "Z": 0}), ("G1", {"X": 10}), ("G1", {"X": 20, "F": 10})])
    seconds = MACHINE.seconds(path)
    assert np.isnan(seconds).tolist() == [True, False] and seconds[1] == pytest.approx(10 / 10 + 10 / 200)


def test_short_lookahead_slows_tiny_moves():
    tiny = [(x / 1000, 0, 0) for x in range(10_001)]
    few = Machine(MACHINE.rates, MACHINE.accelerations, 0.01, lookahead=15)
    # The tool must always be able to stop within 15 moves.
    assert total(tiny, machine=few) == pytest.approx(10 / sqrt(2 * 200 * 0.015), rel=0.02)
    assert total(tiny) < total(tiny, machine=few) / 3


def test_factor_of_the_machine_multiplies_the_time():
    taught = Machine(MACHINE.rates, MACHINE.accelerations, 0.01, factor=1.5)
    assert total([(0, 0, 0), (9, 0, 0)], machine=taught) == pytest.approx(1.5 * total([(0, 0, 0), (9, 0, 0)]))


def planned(path, machine):
    """Plan lines move by move: corners, a backward pass, a forward pass, and trapezoids."""
    moves = np.diff(path.points, axis=0)
    lengths = [float(np.linalg.norm(move)) for move in moves]
    units = [move / length for move, length in zip(moves, lengths)]

    def least(limits, unit):
        return min(limit / abs(part) if part else inf for limit, part in zip(limits, unit))

    speeds = [least(machine.rates, unit) if rapid else min(feed, least(machine.rates, unit))
              for unit, rapid, feed in zip(units, path.rapid, path.feed)]  # fmt: skip
    gains = [2 * least(machine.accelerations, unit) * length for unit, length in zip(units, lengths)]
    corners = [0.0]
    for number in range(1, len(moves)):
        before, after = units[number - 1], units[number]
        half = sqrt(min(max((1 + float(before @ after)) / 2, 0.0), 1.0))  # Sine of half the angle between the moves.
        limit = min(speeds[number - 1], speeds[number]) ** 2
        if half < 1 - 1e-12:
            turn = after - before
            allowed = least(machine.accelerations, turn / np.linalg.norm(turn)) * machine.deviation
            limit = min(limit, allowed * half / (1 - half))
        corners.append(min(limit, sum(gains[number : number + machine.lookahead])))
    corners.append(0.0)
    for number in reversed(range(len(moves))):
        corners[number] = min(corners[number], corners[number + 1] + gains[number])
    for number in range(len(moves)):
        corners[number + 1] = min(corners[number + 1], corners[number] + gains[number])
    seconds = 0.0
    for number, length in enumerate(lengths):
        acceleration = gains[number] / (2 * length)
        enter, leave = sqrt(corners[number]), sqrt(corners[number + 1])
        peak = min(speeds[number], sqrt((enter**2 + leave**2) / 2 + acceleration * length))
        run = length - (peak**2 - enter**2 + peak**2 - leave**2) / (2 * acceleration)
        seconds += (peak - enter + peak - leave) / acceleration + max(run, 0.0) / peak
    return seconds


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("step", [0.01, 1.0, 50.0])
def test_machine_time_agrees_with_a_plan_move_by_move(machine, step):
    random = np.random.default_rng(int(100 * step))
    points = np.cumsum(random.normal(size=(301, 3)) * step * [1, 1, 0.1], axis=0)
    path = Toolpath.through(points, feed=30.0)
    path.rapid[:] = random.random(300) < 0.2
    machine = MACHINES[machine]
    assert machine.seconds(path).sum() == pytest.approx(planned(path, machine), rel=1e-6)


def test_machining_uses_the_machines_acceleration():
    path = linearize([("G0", {"X": 0, "Y": 0, "Z": 0}), ("G0", {"X": 100}), ("G1", {"X": 200, "F": 20})])
    found = machining(path, machine=MACHINE)
    assert found.complete and found.seconds == pytest.approx(MACHINE.seconds(path).sum())
    assert trajectory_seconds(path, machine=MACHINE).tolist() == MACHINE.seconds(path).tolist()
    assert machining(path).left_out and not machining(path, horizontal_rapid=50).left_out


def test_empty_toolpath_takes_no_time():
    assert MACHINE.seconds(linearize([])).tolist() == []


SETTINGS = """$10=1
$11=0.020 (junc dev, mm)
$110=3000.000
$111=2400.000 (y max rate, mm/min)
$112=600
$120=300.000
ok
"""


def test_machine_settings_printed_by_grbl_are_read():
    machine = machine_of_grbl(SETTINGS, MACHINES["hobby-router"])
    assert machine.rates == (50.0, 40.0, 10.0) and machine.deviation == 0.02
    assert machine.accelerations == (300.0, 250.0, 100.0) and machine.lookahead == 15


@pytest.mark.parametrize("settings", ["", "hello", "$10=1", "$110=", "$110=0", "$110=fast"])
def test_wrong_settings_of_grbl_are_refused(settings):
    with pytest.raises(ValueError, match=r"\$110|number"):
        machine_of_grbl(settings, MACHINES["hobby-router"])


@pytest.mark.parametrize("wrong", [
    {"rates": (1, 2)}, {"rates": (1, 0, 1)}, {"accelerations": (1, 1, inf)}, {"deviation": -1}, {"factor": 0},
    {"lookahead": 0}, {"lookahead": 10**400}, {"rates": (1e-300, 1, 1)}, {"accelerations": (1, 1, 1e300)},
    {"factor": 1e300}, {"tool_change": 1e308}, {"deviation": 1e308},
])  # fmt: skip
def test_impossible_machines_are_refused(wrong):
    given = {"rates": (1, 1, 1), "accelerations": (1, 1, 1), "deviation": 0.01}
    with pytest.raises(ValueError, match=next(iter(wrong))):
        Machine(**{**given, **wrong})
