# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert costs to plain data, which FreeCAD documents store, and back."""

from __future__ import annotations

from dataclasses import fields
from math import isfinite
from typing import Any

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.simulator import Cost
from vkworkbench.core.simulators.table import SIMULATORS


def as_data(name: str, cost: Cost) -> dict[str, Any]:
    """Return, for JSON, the fields of a cost that FreeCAD documents store.

    From these fields, `Simulator.together` can compute the cost of several operations in sequence.
    """
    return {field.name: _plain(getattr(cost, field.name)) for field in fields(_kind(name))}


def from_data(name: str, data: Any) -> Cost:
    """Convert data from `as_data` back to a cost. Constants that this version of the add-on does not have are ignored.

    A LookupError, TypeError or ValueError is raised if `data` does not describe a cost, for example because another
    version of the add-on has written it.
    """
    kind = _kind(name)
    return kind(**{field.name: _value(field.name, data[field.name]) for field in fields(kind)})


def _kind(name: str) -> type:
    return {simulator.name: simulator.kept for simulator in SIMULATORS}[name]


def _plain(value: Any) -> Any:
    if isinstance(value, Constants):
        own = {field.name: getattr(value, field.name) for field in fields(value)}
        return {name: number for name, number in own.items() if number != getattr(DEFAULTS, name)}
    if isinstance(value, dict):
        return {str(key): float(number) for key, number in value.items()}
    return value if isinstance(value, int) else float(value)


def _value(name: str, data: Any) -> Any:
    if name == "constants":
        known = {field.name for field in fields(Constants)}
        return Constants(**{key: _number(number) for key, number in data.items() if key in known})
    if isinstance(data, dict):
        if not data:
            raise ValueError(f"no {name}")
        return {int(key): _number(number) for key, number in data.items()}
    return _number(data)


def _number(data: Any) -> float | int:
    if isinstance(data, bool) or not isinstance(data, (int, float)) or not (0 <= data < 1e300 and isfinite(data)):
        raise ValueError(f"no measure: {data!r:.40}")
    return data
