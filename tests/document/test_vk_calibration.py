# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark of the legacy simulator and where its result is kept."""

from __future__ import annotations

import json
import time
from dataclasses import fields

import FreeCAD
import pytest

from vkworkbench.core.simulators import DEFAULTS
from vkworkbench.document import calibration


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty user data folder."""
    monkeypatch.setattr(FreeCAD, "getUserAppDataDir", lambda: f"{tmp_path}/")
    return tmp_path


def test_defaults_until_it_was_measured_and_the_measured_ones_after(folder):
    assert calibration.load("card") is None and calibration.constants("card") == DEFAULTS
    begin = time.process_time()
    done = calibration.calibrate("card")
    assert time.process_time() - begin < 0.5
    assert calibration.load("card") == done and calibration.constants("card") == done.constants
    assert done.processor and done.freecad.startswith(".".join(FreeCAD.Version()[:2]))
    assert done.constants.legacy_factor < DEFAULTS.legacy_factor


def test_measured_constants_are_of_the_order_of_the_known_ones(folder):
    measured = calibration.calibrate().constants
    for name in ("line", "cap", "cell", "facet", "profile"):
        assert 0.1 < getattr(measured, name) / getattr(DEFAULTS, name) < 20, name


def test_each_renderer_has_its_own(folder):
    calibration.calibrate("card")
    assert calibration.load("llvmpipe (LLVM 19)") is None
    slow = calibration.constants("llvmpipe (LLVM 19)")
    assert slow.draw > 10 * DEFAULTS.draw and slow.frame > DEFAULTS.frame
    calibration.calibrate("llvmpipe (LLVM 19)")
    assert calibration.load("card").renderer == "card"
    assert calibration.load("llvmpipe (LLVM 19)").constants.draw == slow.draw


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


def test_what_is_kept_is_plain_json(folder):
    calibration.calibrate("card")
    (path,) = folder.rglob("calibration.json")
    (record,) = json.loads(path.read_text()).values()
    assert set(record["constants"]) == {field.name for field in fields(DEFAULTS)}
    assert record["renderer"] == "card" and len(record["date"]) == 10
