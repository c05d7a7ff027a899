# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calibrate the simulators: measure the speed of this computer once, and store it in FreeCAD's user data folder."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from datetime import date
from pathlib import Path

import FreeCAD
import numpy as np

from vkworkbench import freecad
from vkworkbench.core.simulators import DEFAULTS, Constants
from vkworkbench.core.zbuffer import WORK_UNITS, Speed, measure_speed
from vkworkbench.worker import processes

# Names of OpenGL renderers that draw on the processor and do not wait for the screen; and the times, measured with
# these renderers, for a frame and for a draw call, s.
_SOFTWARE = ("llvmpipe", "softpipe", "swr", "swiftshader", "gdi generic", "microsoft basic render")
_SOFTWARE_OPENGL = {"frame": 42e-3, "draw": 15e-6}
# Times that these renderers need to show one command during playback ("redraw"), and one more percent during
# fast-forward ("repaint"), s. Qt 6, which FreeCAD 1.1 uses, also paints the window on the processor.
_SOFTWARE_PANEL = {"redraw": 40e-3}
_SOFTWARE_PANEL_QT6 = {"redraw": 56e-3, "repaint": 30e-3}
# Factor by which computing a mesh takes longer if the same processor draws pictures between the meshes.
_SOFTWARE_MESH = 1.5
# Names of the fields of `Speed` that are measured.
_MEASURED = [field.name for field in fields(Speed) if field.name != "processes"]
# Errors while reading a damaged file: with other data than a calibration, with numbers that are too large, or with
# lists that are nested too deep.
_UNREADABLE = (TypeError, LookupError, ValueError, AttributeError, ArithmeticError, RecursionError)
_LARGEST = 1e15  # upper bound for a measured number; a larger number comes from a damaged file


@dataclass(frozen=True)
class Calibration:
    """The measured speed of this computer, and the day of the measurement (ISO 8601)."""

    speed: Speed
    date: str


def processor() -> str:
    """Return the name of this computer's processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def constants(speed: Speed, renderer: str = "") -> Constants:
    """Return the constants of FreeCAD's simulators, scaled by the speed of this computer in the extended z-buffer.

    The times of the timer and of pictures on a graphics card do not depend on the processor, and are not scaled.
    `renderer` is the name that OpenGL reports for its renderer; it is empty without a window.
    """
    slowness = float(np.median(speed.constants / Speed().constants))
    own = {name: slowness * getattr(DEFAULTS, name) for name in ("start", "cell", "facet", "profile")}
    if not any(name in renderer.lower() for name in _SOFTWARE):
        return replace(DEFAULTS, **own)
    panel = _SOFTWARE_PANEL_QT6 if freecad.version() >= freecad.QT6_SINCE else _SOFTWARE_PANEL
    own.update({name: slowness * seconds for name, seconds in {**_SOFTWARE_OPENGL, **panel}.items()})
    own.update(cell=own["cell"] * _SOFTWARE_MESH, facet=own["facet"] * _SOFTWARE_MESH)
    return replace(DEFAULTS, opengl_factor=DEFAULTS.legacy_factor, refresh=0.0, **own)


def measured_speed(going_on: Callable[[], object] = lambda: None) -> Speed:
    """Return the speed of this computer in the extended z-buffer; measure the speed if it was never measured.

    With a window, the default speed is returned before the first measurement, which starts when the user pauses. During
    a measurement, `going_on` is called every tenth of a second. If `going_on` raises an exception, the measurement
    ends.
    """
    if FreeCAD.GuiUp or load() is not None:
        return known_speed()
    measured = _measure(going_on)
    with suppress(OSError):
        _save(measured)
    return _on_all_cores(measured.speed)


def known_speed() -> Speed:
    """Return the speed of this computer in the extended z-buffer, or the default speed before the first measurement."""
    known = load()
    return _on_all_cores(known.speed if known else Speed())


def calibrate(going_on: Callable[[], object] = lambda: None) -> Calibration:
    """Measure the extended z-buffer on this computer until the times are steady, and save the result.

    `going_on` is called every tenth of a second. If `going_on` raises an exception, the measurement ends, and the
    earlier calibration stays. An OSError is raised if the user data folder cannot be written.
    """
    measured = _measure(going_on)
    _save(measured)
    return measured


def load() -> Calibration | None:
    """Return the calibration of this computer; None without a readable calibration."""
    record = _records().get(_key())
    try:
        values = {name: float(record[name]) for name in _MEASURED}
        day = str(record["date"])
    except _UNREADABLE:
        return None
    sound = all(0 < value <= _LARGEST for value in values.values()) and values["factor"] >= 1
    return Calibration(Speed(**values), day) if sound else None


def _measure(going_on: Callable[[], object]) -> Calibration:
    return Calibration(measure_speed(going_on=going_on), date.today().isoformat())


def _on_all_cores(speed: Speed) -> Speed:
    """Return the speed with all processes that this computer can run at once, from the speed of one process."""
    return replace(speed, processes=processes())


def _save(measured: Calibration) -> None:
    """Add a calibration to the file, and keep the file's other records."""
    record = {name: getattr(measured.speed, name) for name in _MEASURED}
    path = _path()
    path.parent.mkdir(parents=True, exist_ok=True)
    # Replace the file in one step, so that another FreeCAD reads either the old file or the new one.
    fresh = path.with_suffix(f".{os.getpid()}")
    try:
        fresh.write_text(json.dumps({**_records(), _key(): {**record, "date": measured.date}}, indent=1))
        fresh.replace(path)
    finally:
        with suppress(OSError):  # after a successful `replace`, the temporary file does not exist
            fresh.unlink()


def _path() -> Path:
    return Path(FreeCAD.getUserAppDataDir()) / "ToolpathAnalysis" / "calibration.json"


def _records() -> dict:
    try:
        records = json.loads(_path().read_text())
        json.dumps(records)  # fails if lists are nested too deep, because `_save` could not write them again
    except (OSError, *_UNREADABLE):
        return {}
    return records if isinstance(records, dict) else {}


def _key() -> str:
    """Return the key of the calibration, which depends on the units, numpy and the processor but not on FreeCAD."""
    return f"z-buffer; {WORK_UNITS}; {np.__version__}; {processor()}"
