# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calibration, the file that stores it, and the constants of FreeCAD's simulators computed from it."""

from __future__ import annotations

import itertools
import json
from dataclasses import fields, replace

import FreeCAD
import pytest

import vkworkbench
from vkworkbench import freecad
from vkworkbench.core import Speed
from vkworkbench.core.simulators import DEFAULTS
from vkworkbench.document.computer import calibration
from vkworkbench.report import Cancelled


@pytest.fixture
def measured(tmp_path, monkeypatch):
    """An empty user data folder."""
    monkeypatch.setattr(FreeCAD, "getUserAppDataDir", lambda: f"{tmp_path}/")
    return tmp_path


@pytest.fixture
def folder(measured, monkeypatch):
    """An empty user data folder; instead of measuring, each calibration returns a time that is 1 % longer."""
    slower = itertools.count(100)
    monkeypatch.setattr(
        calibration, "measure_speed",
        lambda going_on: Speed(record=next(slower) / 100 * Speed().record, factor=1.5),
    )  # fmt: skip
    return measured


def test_speed_is_the_default_until_the_computer_is_measured(folder):
    assert calibration.load() is None and calibration.constants(Speed()) == DEFAULTS
    done = calibration.calibrate()
    assert calibration.load() == done and len(done.date) == 10


def test_window_starts_with_the_default_speed(folder, monkeypatch):
    monkeypatch.setattr(FreeCAD, "GuiUp", 1)
    assert calibration.measured_speed() == calibration.known_speed() and not list(folder.rglob("calibration.json"))
    assert calibration.measured_speed().factor == Speed().factor


def test_missing_user_data_folder_is_created(folder, monkeypatch):
    monkeypatch.setattr(FreeCAD, "getUserAppDataDir", lambda: f"{folder}/not/yet/")
    assert calibration.calibrate() == calibration.load()


def test_processor_name_comes_from_python_on_other_systems(monkeypatch):
    """Windows and macOS do not have the file from which the name of the processor is read."""

    def nowhere(_path):
        raise FileNotFoundError

    monkeypatch.setattr(calibration.Path, "read_text", nowhere)
    for name, machine, told in (("Apple M1", "arm64", "Apple M1"), ("", "arm64", "arm64")):
        monkeypatch.setattr(calibration.platform, "processor", lambda name=name: name)
        monkeypatch.setattr(calibration.platform, "machine", lambda machine=machine: machine)
        assert calibration.processor() == told


def slower(times):
    """Return the speed of a computer that needs `times` times the default times."""
    return Speed(*(times * Speed().constants))


def test_software_rendering_is_slower_than_a_card():
    card, software = (calibration.constants(Speed(), renderer) for renderer in ("card", "llvmpipe (LLVM 19)"))
    assert card == DEFAULTS and software.draw > 5 * DEFAULTS.draw and software.refresh == 0 < DEFAULTS.refresh
    assert (software.repaint > 0) == (freecad.version() >= (1, 1)) and software.redraw > DEFAULTS.redraw
    assert software.cell > DEFAULTS.cell and software.facet > DEFAULTS.facet
    assert software.opengl_factor < card.opengl_factor


def test_constants_of_the_processor_scale_with_its_speed():
    """The timer's ticks and the pictures of a graphics card do not depend on the processor."""
    for renderer in ("card", "llvmpipe"):
        usual, slow = (calibration.constants(slower(times), renderer) for times in (1, 3))
        changed = {name for name in vars(DEFAULTS) if getattr(slow, name) != getattr(usual, name)}
        of_card = {"start", "cell", "facet", "profile"}
        own = of_card | ({"frame", "draw", "redraw"} if renderer == "llvmpipe" else set())
        assert changed - {"repaint"} == own
        for name in changed:
            assert getattr(slow, name) == pytest.approx(3 * getattr(usual, name)), name


def test_one_wrong_measured_constant_is_ignored():
    assert calibration.constants(replace(Speed(), block=9 * Speed().block)) == DEFAULTS


NESTED = 100_000 * "[" + 100_000 * "]"
IMPOSSIBLE = ("1e999", "1" + 9000 * "0", "1e300", "NaN", "-1", "0", "[]", '"one"', "null", NESTED)


def with_number(name, number):
    """Return a function that replaces the number of the entry `name` in a JSON text."""

    def damage(text):
        head, tail = text.split(f'"{name}": ', 1)
        return f'{head}"{name}": {number}{tail[tail.index(",") :]}'

    return damage


@pytest.mark.parametrize("damage", [
    *(with_number("cell", number) for number in IMPOSSIBLE), with_number("factor", "0.5"),
    lambda text: text.replace('"cell"', '"other"'), lambda text: text.replace('"date"', '"day"'),
    lambda text: "not JSON", lambda text: "[1, 2]", lambda text: NESTED, lambda text: "\ufeff{}", lambda text: "",
    lambda text: f'{{"other": {NESTED}, {text[1:]}', str.upper,
])  # fmt: skip
def test_damaged_calibration_file_is_replaced(folder, damage):
    speed = calibration.measured_speed()
    (path,) = folder.rglob("calibration.json")
    sound = path.read_text()
    path.write_text(damage(sound), encoding="utf-8")
    assert path.read_text() != sound
    assert calibration.load() is None and calibration.known_speed().factor == Speed().factor
    again = calibration.measured_speed()
    assert again != speed and calibration.measured_speed() == again
    assert [one.name for one in path.parent.iterdir()] == ["calibration.json"]


def test_no_temporary_file_stays_after_a_failed_write(folder):
    path = calibration._path()
    path.mkdir(parents=True)
    with pytest.raises(OSError):
        calibration.calibrate()
    # The measured speed is used although the file cannot be written.
    assert calibration.measured_speed().factor < Speed().factor
    assert list(path.parent.iterdir()) == [path]


def test_calibration_keeps_other_records_of_the_file(folder):
    """The file has a record for each processor, and records of earlier versions."""
    path = calibration._path()
    path.parent.mkdir(parents=True)
    path.write_text('{"other": 1}')
    calibration.calibrate()
    other, own = json.loads(path.read_text()).values()
    assert other == 1 and set(own) == {field.name for field in fields(Speed)} - {"processes"} | {"date"}


def test_speed_of_the_computer_is_measured_once(folder, monkeypatch):
    speed = calibration.measured_speed()
    assert calibration.measured_speed() == speed and speed.factor < Speed().factor
    calibration.calibrate()
    assert calibration.measured_speed() != speed
    monkeypatch.setattr(calibration, "WORK_UNITS", "of another version")
    assert calibration.load() is None


@pytest.mark.parametrize("after", [0, 3])
def test_cancelled_calibration_writes_no_file(measured, after):
    calls = []

    def going_on():
        calls.append(None)
        if len(calls) > after:
            raise Cancelled("given up")

    with pytest.raises(Cancelled):
        calibration.calibrate(going_on)
    assert calibration.load() is None and not list(measured.iterdir())


def test_analysis_can_be_cancelled_during_calibration(measured, small, zigzag_commands):
    small.add("Rows", zigzag_commands)
    asked = []
    with pytest.raises(Cancelled):
        vkworkbench.analyze(
            small.document,
            cancelled=lambda: asked.append(None) or len(asked) > 5,
            progress=lambda *_: pytest.fail("it went on"),
        )
    assert len(asked) == 6
    # Search all folders, because FreeCAD 1.1 has a folder for each version in the user data folder.
    assert not list(measured.rglob("calibration.json"))
