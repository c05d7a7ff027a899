# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark of the legacy simulator and where its result is kept."""

from __future__ import annotations

import itertools
import json
from dataclasses import fields, replace

import FreeCAD
import numpy as np
import pytest

import vkworkbench
from vkworkbench import freecad
from vkworkbench.core import Speed
from vkworkbench.core.simulators import DEFAULTS
from vkworkbench.document.computer import calibration, measuring
from vkworkbench.report import Cancelled


@pytest.fixture
def measured(tmp_path, monkeypatch):
    """An empty user data folder."""
    monkeypatch.setattr(FreeCAD, "getUserAppDataDir", lambda: f"{tmp_path}/")
    return tmp_path


@pytest.fixture
def folder(measured, monkeypatch):
    """An empty user data folder, and measured times that grow by one percent each, without measuring."""
    slower = itertools.count(100)

    def constants(clock, going_on):
        share = next(slower) / 100
        return replace(DEFAULTS, start=share * DEFAULTS.start, cell=share * DEFAULTS.cell)

    monkeypatch.setattr(calibration, "measure_legacy", constants)
    monkeypatch.setattr(
        calibration, "measure_speed",
        lambda clock=None, going_on=None: Speed(record=next(slower) / 100 * Speed().record, factor=1.5),
    )  # fmt: skip
    return measured


def test_constants_are_defaults_until_measured(folder):
    assert calibration.load("card") is None and calibration.constants("card") == DEFAULTS
    done = calibration.calibrate("card")
    assert calibration.load("card") == done and calibration.constants("card") == done.constants
    assert done.processor and done.freecad.startswith(".".join(FreeCAD.Version()[:2]))


def test_measured_constants_are_of_the_order_of_the_known_ones(measured):
    found = calibration.calibrate().constants
    assert found.legacy_factor == DEFAULTS.legacy_factor
    for name in ("cell", "facet", "profile"):
        assert 0.1 < getattr(found, name) / getattr(DEFAULTS, name) < 20, name


def test_window_starts_with_the_default_speed(folder, monkeypatch):
    monkeypatch.setattr(FreeCAD, "GuiUp", 1)
    assert calibration.measured_speed() == calibration.known_speed() and not list(folder.rglob("calibration.json"))
    assert calibration.measured_speed().factor == Speed().factor


def test_the_folder_of_the_users_data_may_not_be_there_yet(folder, monkeypatch):
    monkeypatch.setattr(FreeCAD, "getUserAppDataDir", lambda: f"{folder}/not/yet/")
    assert calibration.calibrate("card") == calibration.load("card")


def test_constants_are_seconds_per_size_of_meshes_and_profile(monkeypatch):
    """A flat mesh of 100 / 0.12 by 60 / 0.12 cells; a rough one of 50 by 60 cells; a profile of three radii of 2 mm in 0.1 mm."""
    facets = sum(mesh.CountFacets for mesh in measuring._rough().GetResultMesh())
    assert facets > 50 * 60  # as many facets as cells; flat meshes have a few
    times = np.array([834 * 501 * 1e-6, 51 * 61 * 1e-6 + facets * 3e-6, 60 * 5e-6])
    monkeypatch.setattr(measuring, "steady_seconds", lambda pieces, **_: times)
    found = measuring.measure_legacy(None, None)
    assert (found.cell, found.facet, found.profile) == pytest.approx((1e-6, 3e-6, 5e-6))
    assert found.start / DEFAULTS.start == pytest.approx(1e-6 / DEFAULTS.cell)


def test_processor_name_falls_back_to_python(monkeypatch):
    """As on Windows and macOS."""

    def nowhere(_path):
        raise FileNotFoundError

    monkeypatch.setattr(calibration.Path, "read_text", nowhere)
    for name, machine, told in (("Apple M1", "arm64", "Apple M1"), ("", "arm64", "arm64")):
        monkeypatch.setattr(calibration.platform, "processor", lambda name=name: name)
        monkeypatch.setattr(calibration.platform, "machine", lambda machine=machine: machine)
        assert calibration.processor() == told


def test_each_renderer_has_its_own(folder):
    calibration.calibrate("card")
    assert calibration.load("llvmpipe (LLVM 19)") is None
    slow = calibration.constants("llvmpipe (LLVM 19)")
    assert slow.draw > 5 * DEFAULTS.draw and slow.refresh == 0 < DEFAULTS.refresh
    assert (slow.repaint > 0) == (freecad.version() >= (1, 1)) and slow.redraw > DEFAULTS.redraw
    calibration.calibrate("llvmpipe (LLVM 19)")
    assert calibration.load("card").renderer == "card"
    assert calibration.load("llvmpipe (LLVM 19)").constants.refresh == 0


def test_times_of_a_window_scale_with_the_measured_meshes(folder):
    card, known = calibration.calibrate("card").constants, calibration.constants("llvmpipe")
    software = calibration.calibrate("llvmpipe").constants
    assert card.start / DEFAULTS.start == pytest.approx(card.cell / DEFAULTS.cell)
    assert (card.frame, card.draw, card.redraw) == (
        DEFAULTS.frame,
        DEFAULTS.draw,
        DEFAULTS.redraw,
    )  # a graphics card does not depend on the processor
    for name in ("frame", "draw", "redraw"):
        assert getattr(software, name) / getattr(known, name) == pytest.approx(software.cell / known.cell), name


@pytest.mark.parametrize("damage", [
    lambda text: "not JSON", lambda text: "[1, 2]", lambda text: text.replace('"facet"', '"other"'),
    lambda text: text.replace('"cell": ', '"cell": -'),
])  # fmt: skip
def test_a_damaged_file_counts_as_none_and_is_replaced(folder, damage):
    calibration.calibrate()
    (path,) = folder.rglob("calibration.json")
    path.write_text(damage(path.read_text()))
    assert calibration.load() is None and calibration.constants() == DEFAULTS
    calibration.calibrate()
    assert calibration.load() is not None
    assert [one.name for one in path.parent.iterdir()] == ["calibration.json"]


def huge(text, name, number):
    """Return the text with another number behind a name."""
    head, tail = text.split(f'"{name}": ', 1)
    return f'{head}"{name}": {number}{tail[tail.index(",") :]}'


NESTED = 100_000 * "[" + 100_000 * "]"


@pytest.mark.parametrize("damage", [
    *(lambda text, number=number: huge(text, "display", number)
      for number in ("1e999", "1" + 400 * "0", "1" + 9000 * "0", "1e300", "NaN", "-Infinity", "0", "[]", '"one"', "null", NESTED)),
    *(lambda text, number=number: huge(text, "legacy_factor", number) for number in ("0", "0.5", "1e300")),
    lambda text: NESTED, lambda text: f'{{"other": {NESTED}, {text[1:]}', lambda text: "\ufeff{}", lambda text: "",
])  # fmt: skip
def test_numbers_that_cannot_be_count_as_none(folder, damage):
    calibration.calibrate("card")
    (path,) = folder.rglob("calibration.json")
    sound = path.read_text()
    path.write_text(damage(sound), encoding="utf-8")
    assert path.read_text() != sound
    assert calibration.load("card") is None and calibration.constants("card") == DEFAULTS
    calibration.measured_speed()
    calibration.calibrate("card")
    assert calibration.load("card") is not None
    assert [one.name for one in path.parent.iterdir()] == ["calibration.json"]


@pytest.mark.parametrize("number", ["0", "1e999", "1" + 400 * "0", NESTED])
def test_a_speed_that_cannot_be_is_measured_again(folder, number):
    speed = calibration.measured_speed()
    (path,) = folder.rglob("calibration.json")
    path.write_text(huge(path.read_text(), "cell", number))
    assert calibration.measured_speed().cell > 0 and calibration.measured_speed() != speed


def test_no_temporary_file_stays_after_a_failed_write(folder):
    path = calibration._path()
    path.mkdir(parents=True)
    with pytest.raises(OSError):
        calibration.calibrate("card")
    assert list(path.parent.iterdir()) == [path]


def test_entries_of_older_versions_are_ignored(folder):
    done = calibration.calibrate("card")
    (path,) = folder.rglob("calibration.json")
    records = json.loads(path.read_text())
    records[calibration._key("card")]["constants"]["ring"] = -59e-9
    records[calibration._key("card")]["runs"] = {"play": [[1, 2, 3]]}
    path.write_text(json.dumps(records))
    assert calibration.load("card") == done


def test_calibration_file_is_plain_json(folder):
    calibration.calibrate("card")
    (path,) = folder.rglob("calibration.json")
    speed, record = json.loads(path.read_text()).values()
    assert set(speed) == {field.name for field in fields(Speed)} - {"processes"}  # not a measured number
    assert set(record["constants"]) == {field.name for field in fields(DEFAULTS)}
    assert record["renderer"] == "card" and len(record["date"]) == 10


@pytest.mark.parametrize("damage", [str.upper, lambda text: text.replace('"pixel": ', '"pixel": -')])
def test_the_z_buffers_speed_is_measured_once(folder, damage):
    speed = calibration.measured_speed()
    assert calibration.measured_speed() == speed and speed.factor < Speed().factor
    (path,) = folder.rglob("calibration.json")
    path.write_text(damage(path.read_text()))
    again = calibration.measured_speed()
    assert again != speed and calibration.measured_speed() == again
    calibration.calibrate("card")
    assert calibration.measured_speed() not in (speed, again)


def test_a_speed_in_other_units_is_measured_again(folder, monkeypatch):
    speed = calibration.measured_speed()
    monkeypatch.setattr(calibration, "WORK_UNITS", "of another version")
    assert calibration.measured_speed() != speed


class Clock:
    """A clock that gives each piece of work the next of some times."""

    def __init__(self, times):
        self.times, self.now, self.running = times, 0.0, False

    def __call__(self):
        self.now += next(self.times) if self.running else 0.0
        self.running = not self.running
        return self.now


def test_calibrations_on_a_busy_computer_agree(measured, monkeypatch):
    """Each piece takes 10 ms, often longer because of other programs."""
    monkeypatch.setattr(calibration, "measure_speed", lambda clock, going_on: Speed())
    rng = np.random.default_rng(1)

    def busy():
        while True:
            yield 0.01 * (1 + rng.choice([0.0, 0.01, rng.uniform(0.1, 3.0)]))

    found = [calibration.calibrate(clock=Clock(times)) for times in [busy()] * 5 + [iter(lambda: 0.01, None)]]
    for name in ("cell", "facet", "profile"):
        values = [getattr(one.constants, name) for one in found]
        assert max(values) < 1.05 * min(values), name


@pytest.mark.parametrize("after", [0, 3, 25])
def test_a_calibration_that_is_given_up_changes_nothing(measured, after):
    calls = []

    def going_on():
        calls.append(None)
        if len(calls) > after:
            raise Cancelled("given up")

    with pytest.raises(Cancelled):
        calibration.calibrate("card", going_on=going_on)
    assert calibration.load("card") is None and not list(measured.iterdir())


def test_an_analysis_is_cancelled_while_the_computer_is_measured(measured, small, zigzag_commands):
    small.add("Rows", zigzag_commands)
    asked = []
    with pytest.raises(Cancelled):
        vkworkbench.analyze(
            small.document,
            cancelled=lambda: asked.append(None) or len(asked) > 5,
            progress=lambda *_: pytest.fail("it went on"),
        )
    assert len(asked) == 6
    assert not list(measured.rglob("calibration.json"))  # FreeCAD 1.1 makes folders there
