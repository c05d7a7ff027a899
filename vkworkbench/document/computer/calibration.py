# SPDX-License-Identifier: LGPL-2.1-or-later
"""The speed of this computer in every simulator: measured once and kept in FreeCAD's user data folder."""

from __future__ import annotations

import json
import os
import platform
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass, fields, replace
from datetime import date
from pathlib import Path

import FreeCAD
import numpy as np

from vkworkbench import freecad
from vkworkbench.core import processor_clock
from vkworkbench.core.simulators import DEFAULTS, Constants
from vkworkbench.core.zbuffer import WORK_UNITS, Speed, measure_speed
from vkworkbench.document.computer.measuring import as_slow_here, measure_legacy
from vkworkbench.worker import processes

# Names of OpenGL renderers that draw on the processor and do not wait for the screen, and the times of a frame and of a
# draw call measured with them, s.
_SOFTWARE = ("llvmpipe", "softpipe", "swr", "swiftshader", "gdi generic", "microsoft basic render")
_SOFTWARE_OPENGL = {"frame": 42e-3, "draw": 15e-6}
# Seconds that such a renderer needs to show one command during playback ("redraw"), and one more percent during
# fast-forward ("repaint"). Qt 6, which FreeCAD 1.1 uses, also paints the window on the processor.
_SOFTWARE_PANEL = {"redraw": 40e-3}
_SOFTWARE_PANEL_QT6 = {"redraw": 56e-3, "repaint": 30e-3}
# Factor by which a mesh takes longer if the same processor draws pictures between the meshes.
_SOFTWARE_MESH = 1.5
# Fields of a Speed that are measured.
_MEASURED = [field.name for field in fields(Speed) if field.name != "processes"]
# Errors that a damaged file raises: other data than a calibration, numbers that are too large, lists nested too deep.
_UNREADABLE = (TypeError, LookupError, ValueError, AttributeError, ArithmeticError, RecursionError)
# Upper limit for a constant, and the constants for which 0 is valid.
_LARGEST = 1e15
_MAY_BE_ZERO = frozenset(["repaint", "facet", "refresh"])


@dataclass(frozen=True)
class Calibration:
    """Constants measured on one computer with one FreeCAD version.

    Attributes
    ----------
    constants : Constants
        Costs of the unit work.
    date : str
        Day of the measurement, ISO 8601.
    freecad, processor, renderer : str
        FreeCAD, processor and renderer of the measurement. The calibration is valid only for this combination.
    """

    constants: Constants
    date: str
    freecad: str
    processor: str
    renderer: str


def processor() -> str:
    """Return the name of this computer's processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def constants(renderer: str = "") -> Constants:
    """Return the measured constants of this computer, or the defaults before the first measurement.

    Parameters
    ----------
    renderer : str
        OpenGL's name of its renderer; empty without a window.
    """
    known = load(renderer)
    return known.constants if known else _for_renderer(DEFAULTS, renderer)


def measured_speed(going_on: Callable[[], object] = lambda: None) -> Speed:
    """Return the speed of this computer in the extended z-buffer; measure it if it was never measured.

    With a window, an unmeasured computer gets the default speed: the window measures it when the user pauses.

    Parameters
    ----------
    going_on : callable
        Called every tenth of a second during a measurement. An exception from it ends the measurement.
    """
    known = _speed()
    if known is None and FreeCAD.GuiUp:
        return known_speed()
    if known is None:
        known = measure_speed(going_on=going_on)
        with suppress(OSError):
            _write(_kept(known))
    return _on_all_cores(known)


def known_speed() -> Speed:
    """Return the speed of this computer in the extended z-buffer, or the default speed before the first measurement."""
    return _on_all_cores(_speed() or Speed())


def _on_all_cores(speed: Speed) -> Speed:
    """Return the speed with as many processes as can work at once, from the speed of one process."""
    return replace(speed, processes=processes())


def _kept(speed: Speed) -> dict[str, dict[str, float]]:
    return {_speed_key(): {name: getattr(speed, name) for name in _MEASURED}}


def _speed() -> Speed | None:
    record = _records().get(_speed_key())
    try:
        values = {name: float(record[name]) for name in _MEASURED}
    except _UNREADABLE:
        return None
    return Speed(**values) if all(0 < value <= _LARGEST for value in values.values()) else None


def load(renderer: str = "") -> Calibration | None:
    """Return the calibration of this FreeCAD, processor and renderer; None without a readable calibration."""
    record = _records().get(_key(renderer))
    try:
        values = {field.name: float(record["constants"][field.name]) for field in fields(Constants)}
        if not all(_least(name) <= value <= _LARGEST for name, value in values.items()):
            return None
        words = (str(record[name]) for name in ("date", "freecad", "processor", "renderer"))
        return Calibration(Constants(**values), *words)
    except _UNREADABLE:
        return None


def _least(name: str) -> float:
    """Return the smallest possible value of a constant: 1 for a factor, 0 for `_MAY_BE_ZERO`, otherwise more than 0."""
    if name.endswith("factor"):
        return 1.0
    return 0.0 if name in _MAY_BE_ZERO else sys.float_info.min


def calibrate(
    renderer: str = "",
    *,
    clock: Callable[[], float] = processor_clock,
    going_on: Callable[[], object] = lambda: None,
) -> Calibration:
    """Measure the extended z-buffer and the legacy simulator on this computer until the times are steady; save them.

    The constants of the timer and the display cannot be measured this way; they are scaled by the time of a mesh.

    Parameters
    ----------
    renderer : str
        OpenGL's name of its renderer; empty without a window.
    clock : callable
        Returns the time, s.
    going_on : callable
        Called every tenth of a second. An exception from it ends the measurement; the earlier calibration then stays.

    Returns
    -------
    Calibration

    Raises
    ------
    OSError
        If the user data folder cannot be written.
    """
    speed = measure_speed(clock, going_on)
    measured = _for_renderer(measure_legacy(clock, going_on), renderer)
    _write(_kept(speed))
    version = ".".join(map(str, freecad.version()))
    calibration = Calibration(measured, date.today().isoformat(), version, processor(), renderer)
    _write({_key(renderer): asdict(calibration)})
    return calibration


def _write(new: dict) -> None:
    """Add records to the calibration file, and keep its other records."""
    path = _path()
    path.parent.mkdir(parents=True, exist_ok=True)
    # Replace the file in one step, so that another FreeCAD reads either the old file or the new one.
    fresh = path.with_suffix(f".{os.getpid()}")
    try:
        fresh.write_text(json.dumps({**_records(), **new}, indent=1))
        fresh.replace(path)
    finally:
        with suppress(OSError):  # after `replace` the file does not exist under this name
            fresh.unlink()


def _path() -> Path:
    return Path(FreeCAD.getUserAppDataDir()) / "ToolpathAnalysis" / "calibration.json"


def _records() -> dict:
    try:
        records = json.loads(_path().read_text())
        json.dumps(records)  # records nested too deep cannot be written again and are ignored
    except (OSError, *_UNREADABLE):
        return {}
    return records if isinstance(records, dict) else {}


def _key(renderer: str) -> str:
    return "; ".join((".".join(map(str, freecad.version())), processor(), renderer))


def _speed_key() -> str:
    """Return the key of the z-buffer's speed, which depends on its units, numpy and the processor but not on FreeCAD."""
    return f"z-buffer; {WORK_UNITS}; {np.__version__}; {processor()}"


def _for_renderer(base: Constants, renderer: str) -> Constants:
    if any(name in renderer.lower() for name in _SOFTWARE):
        panel = _SOFTWARE_PANEL_QT6 if freecad.version() >= freecad.QT6_SINCE else _SOFTWARE_PANEL
        pictures = {name: as_slow_here(seconds, base.cell) for name, seconds in {**_SOFTWARE_OPENGL, **panel}.items()}
        mesh = {"cell": base.cell * _SOFTWARE_MESH, "facet": base.facet * _SOFTWARE_MESH}
        return replace(base, opengl_factor=DEFAULTS.legacy_factor, refresh=0.0, **mesh, **pictures)
    return base
