# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's method: toolpaths from commands, their signatures and strategies, and the cost of simulating them.

The core needs only numpy. The public names in this module are stable. Other packages import the public names of a
folder from the folder's ``__init__``, never from the files in the folder.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vkworkbench.core.gcode import linearize
    from vkworkbench.core.machine import MACHINES, Machine, machine_of_grbl
    from vkworkbench.core.machining_time import Machining, machining, seconds_of_dwells, trajectory_seconds
    from vkworkbench.core.paper import Complexity, Signature, complexity, signature
    from vkworkbench.core.recognition import Recognition, Span, recognize
    from vkworkbench.core.solids import Stock, stock_around
    from vkworkbench.core.stocks import Cylinder, Mesh, Solid
    from vkworkbench.core.strategy import Family, Strategy
    from vkworkbench.core.tool import Tool
    from vkworkbench.core.toolpath import COORDINATE_LIMIT, Problem, Toolpath, exact_lengths
    from vkworkbench.core.view import Frame, View
    from vkworkbench.core.zbuffer import (
        Cut,
        Estimate,
        Resolution,
        Speed,
        ZBuffer,
        best_resolution,
        cauchy_crofton,
        estimate,
        measure_speed,
        simulate,
        simulate_job,
    )

__all__ = [
    "COORDINATE_LIMIT", "MACHINES", "Complexity", "Cut", "Cylinder", "Estimate", "Family", "Frame", "Machine", "Machining", "Mesh", "Problem",
    "Recognition", "Resolution", "Signature", "Solid", "Span", "Speed", "Stock", "Strategy", "Tool", "Toolpath",
    "View", "ZBuffer", "best_resolution", "cauchy_crofton", "complexity", "estimate", "exact_lengths", "linearize", "machine_of_grbl", "machining",
    "measure_speed", "recognize", "seconds_of_dwells", "signature", "simulate", "simulate_job", "stock_around", "trajectory_seconds",
]  # fmt: skip

_NAMES = {
    "gcode": "linearize",
    "machine": "MACHINES Machine machine_of_grbl",
    "machining_time": "Machining machining seconds_of_dwells trajectory_seconds",
    "paper": "Complexity Signature complexity signature",
    "recognition": "Recognition Span recognize",
    "solids": "Stock stock_around",
    "stocks": "Cylinder Mesh Solid",
    "strategy": "Family Strategy",
    "tool": "Tool",
    "toolpath": "COORDINATE_LIMIT Problem Toolpath exact_lengths",
    "view": "Frame View",
    "zbuffer": "Cut Estimate Resolution Speed ZBuffer best_resolution cauchy_crofton estimate measure_speed simulate simulate_job",
}
_HOMES = {name: home for home, names in _NAMES.items() for name in names.split()}


def __dir__() -> list[str]:
    """Return the names of the package, including names whose modules are not loaded yet."""
    return sorted({*globals(), *__all__})


if not TYPE_CHECKING:  # this function is hidden from mypy, which reads the imports above instead

    def __getattr__(name: str) -> object:
        """Load the module of a public name when the name is first used, because loading all modules is slow."""
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        globals()[name] = value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
        return value
