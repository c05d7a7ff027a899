# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of simulating an operation or a job in every simulator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vkworkbench.core.simulators.legacy import LegacyCost
from vkworkbench.core.simulators.opengl import OpenGLCost
from vkworkbench.core.simulators.simulator import Advice, Simulator
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER
from vkworkbench.core.zbuffer import Resolution


class Costs:
    """The costs of an operation, or of several operations in sequence, by the simulators' names.

    Attributes
    ----------
    costs : mapping of str to Cost
        Each cost is computed at its first use. The mapping does not contain simulators that this FreeCAD does not have,
        and simulators whose cost is unknown.
    advice : mapping of str to Resolution
        The finest setting of a simulator within the budget of the preferences.
    """

    costs: Mapping[str, Any]
    advice: Mapping[str, Any]

    @property
    def legacy(self) -> LegacyCost | None:
        """The cost in FreeCAD's legacy simulator at the accuracy set in the preferences; None if it is unknown."""
        cost: LegacyCost | None = self.costs.get(LEGACY.name)
        return cost

    @property
    def opengl(self) -> OpenGLCost | None:
        """The cost in FreeCAD's OpenGL simulator; None if it is unknown, or if this FreeCAD has no OpenGL simulator."""
        cost: OpenGLCost | None = self.costs.get(OPENGL.name)
        return cost

    @property
    def resolution(self) -> Resolution | None:
        """The finest image of the z-buffer within the budget of the preferences; None if it is unknown."""
        chosen: Resolution | None = self.advice.get(ZBUFFER.name)
        return chosen

    def cost(self, simulator: str) -> tuple[float, float] | None:
        """Return the time and the memory of a simulation, s and bytes; None if they are unknown.

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
        """Return the factor by which the time from :meth:`cost` may be too high or too low, at least 1."""
        cost = self._of(simulator)
        return 1.0 if cost is None else float(cost.factor)

    def _of(self, simulator: str) -> Any:
        names = [known.name for known in SIMULATORS]
        if simulator not in names:
            raise ValueError(f"there is no simulator {simulator!r}: choose among {', '.join(names)}")
        return self.costs.get(simulator)

    def columns(self) -> dict[str, Any]:
        """Return the columns for CSV and JSON files: explanations of the advice, and costs in FreeCAD's simulators."""
        columns = {advice.column: chosen and chosen.explanation for advice, chosen in self._advised()}
        for simulator in _beside_the_papers():
            columns.update(simulator.figures(self.costs.get(simulator.name)))
        return columns

    def factors(self) -> dict[str, float]:
        """Return the factors of the times in FreeCAD's simulators, see :meth:`factor`, for CSV and JSON."""
        return {s.factor_column: self.factor(s.name) for s in _beside_the_papers() if s.factor_column is not None}

    def advice_messages(self) -> dict[str, Any]:
        """Return the messages of the advice as plain data."""
        return {advice.column: chosen and chosen.why.as_data() for advice, chosen in self._advised()}

    def _advised(self) -> list[tuple[Advice, Any]]:
        return [(s.advice, self.advice.get(s.name)) for s in SIMULATORS if s.advice]


def _beside_the_papers() -> tuple[Simulator, ...]:
    return tuple(simulator for simulator in SIMULATORS if simulator is not ZBUFFER)
