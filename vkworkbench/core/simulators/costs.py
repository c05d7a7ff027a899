# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide the cost of simulating an operation or a job in every simulator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vkworkbench.core.simulators.legacy import LegacyCost
from vkworkbench.core.simulators.opengl import OpenGLCost
from vkworkbench.core.simulators.simulator import Simulator
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER
from vkworkbench.core.zbuffer import Resolution


class Costs:
    """The costs of simulating an operation, or several operations in sequence, by the names of the simulators.

    Attributes
    ----------
    costs : mapping of str to Cost
        Cost by name of the simulator; each cost is computed at its first use. The mapping does not contain simulators
        that the running FreeCAD does not have, and simulators whose cost is unknown.
    advice : mapping of str to Resolution
        The z-buffer's finest image within the budget of the preferences, by the z-buffer's name; empty if unknown.
    """

    costs: Mapping[str, Any]
    advice: Mapping[str, Any]

    @property
    def legacy(self) -> LegacyCost | None:
        """The cost in FreeCAD's legacy simulator at the accuracy set in the preferences; None if it is unknown."""
        return self.costs.get(LEGACY.name)

    @property
    def opengl(self) -> OpenGLCost | None:
        """The cost in FreeCAD's OpenGL simulator; None if it is unknown, or if this version has no such simulator."""
        return self.costs.get(OPENGL.name)

    @property
    def resolution(self) -> Resolution | None:
        """The z-buffer's image with the smallest pixels within the budget of the preferences; None if it is unknown."""
        return self.advice.get(ZBUFFER.name)

    def cost(self, simulator: str) -> tuple[float, float] | None:
        """Return the time, s, and the memory, bytes, of a simulation; None if they are unknown.

        Parameters
        ----------
        simulator : str
            Name of a simulator: ``"z-buffer"``, ``"legacy"`` (in fast-forward), or ``"OpenGL"`` (at its highest speed).

        Raises
        ------
        ValueError
            If `simulator` is not the name of a simulator.
        """
        cost = self._of(simulator)
        return None if cost is None else (cost.seconds, float(cost.memory_bytes))

    def factor(self, simulator: str) -> float:
        """Return the factor, at least 1, by which the time from :meth:`cost` can be too high or too low."""
        cost = self._of(simulator)
        return 1.0 if cost is None else float(cost.factor)

    def _of(self, simulator: str) -> Any:
        names = [known.name for known in SIMULATORS]
        if simulator not in names:
            raise ValueError(f"there is no simulator {simulator!r}: choose among {', '.join(names)}")
        return self.costs.get(simulator)

    def columns(self) -> dict[str, Any]:
        """Return columns for CSV and JSON files: the reason for the recommended image, and the costs in FreeCAD."""
        columns: dict[str, Any] = {"resolution": self.resolution and self.resolution.explanation}
        for simulator in _beside_the_papers():
            columns.update(simulator.figures(self.costs.get(simulator.name)))
        return columns

    def factors(self) -> dict[str, float]:
        """Return, for CSV and JSON, the uncertainty factors of times in FreeCAD's simulators; see :meth:`factor`."""
        return {s.factor_column: self.factor(s.name) for s in _beside_the_papers() if s.factor_column is not None}

    def advice_messages(self) -> dict[str, Any]:
        """Return the message that recommends an image, as data for JSON."""
        return {"resolution": self.resolution and self.resolution.why.as_data()}


def _beside_the_papers() -> tuple[Simulator, ...]:
    return tuple(simulator for simulator in SIMULATORS if simulator is not ZBUFFER)
