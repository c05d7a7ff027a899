# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulating an operation or a job costs in every simulator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vkworkbench.core.simulators.accuracy import Accuracy
from vkworkbench.core.simulators.legacy import LegacyCost
from vkworkbench.core.simulators.opengl import OpenGLCost
from vkworkbench.core.simulators.simulator import Advice, Cost, Simulator
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER
from vkworkbench.core.zbuffer import Resolution


class Costs:
    """What the simulators take for an operation, or for several one after another, by the simulators' names.

    Attributes
    ----------
    costs : mapping of str to Cost
        Computed when they are asked for. Without simulators that this FreeCAD does not have, and without those whose cost is not known.
    advice : mapping of str to Resolution, Accuracy
        The finest setting of a simulator within the budget of the preferences; the same simulators are missing.
    """

    costs: Mapping[str, Cost]
    advice: Mapping[str, Any]

    @property
    def legacy(self) -> LegacyCost | None:
        """What FreeCAD's legacy simulator takes, at the accuracy of the preferences."""
        return self.costs.get(LEGACY.name)

    @property
    def opengl(self) -> OpenGLCost | None:
        """What FreeCAD's OpenGL simulator takes; None also where this FreeCAD has none."""
        return self.costs.get(OPENGL.name)

    @property
    def resolution(self) -> Resolution | None:
        """The finest image of the z-buffer within the budget of the preferences."""
        return self.advice.get(ZBUFFER.name)

    @property
    def accuracy(self) -> Accuracy | None:
        """The finest accuracy of playing in the legacy simulator within that budget."""
        return self.advice.get(LEGACY.name)

    def cost(self, simulator: str) -> tuple[float, float] | None:
        """Return seconds and bytes of simulating it, None where they are not known.

        Parameters
        ----------
        simulator : str
            Name of a simulator: ``"z-buffer"``, ``"legacy"``, which runs in fast-forward, or ``"OpenGL"``, at its
            highest speed.
        """
        cost = self.costs.get(simulator)
        return cost and (cost.seconds, float(cost.memory_bytes))

    def factor(self, simulator: str) -> float:
        """Return the factor of the time of :meth:`cost`: the true time is between it divided and multiplied by this."""
        cost = self.costs.get(simulator)
        return cost.factor if cost else 1.0

    def columns(self) -> dict[str, Any]:
        """Return columns of CSV and JSON: the explanations of the advice, and the costs in FreeCAD's simulators."""
        columns = {advice.column: chosen and chosen.explanation for advice, chosen in self._advised()}
        for simulator in _beside_the_papers():
            columns.update(simulator.figures(self.costs.get(simulator.name)))
        return columns

    def factors(self) -> dict[str, float]:
        """Return the factors of these times, see :meth:`factor`, for CSV and JSON."""
        return {simulator.factor_column: self.factor(simulator.name) for simulator in _beside_the_papers()}

    def advice_messages(self) -> dict[str, Any]:
        """Return the messages of the advice as plain data."""
        return {advice.column: chosen and chosen.why.as_data() for advice, chosen in self._advised()}

    def _advised(self) -> list[tuple[Advice, Any]]:
        return [(s.advice, self.advice.get(s.name)) for s in SIMULATORS if s.advice]


def _beside_the_papers() -> tuple[Simulator, ...]:
    return tuple(simulator for simulator in SIMULATORS if simulator is not ZBUFFER)
