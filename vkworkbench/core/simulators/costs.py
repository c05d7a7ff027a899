# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulating an operation or a job costs in every simulator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vkworkbench.core.simulators.legacy import LegacyCost
from vkworkbench.core.simulators.opengl import OpenGLCost
from vkworkbench.core.simulators.simulator import Advice, Simulator
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER
from vkworkbench.core.zbuffer import Resolution


class Costs:
    """What the simulators take for an operation, or for several one after another, by the simulators' names.

    Attributes
    ----------
    costs : mapping of str to Cost
        Computed when they are asked for. Without simulators that this FreeCAD does not have, and without those whose cost is not known.
    advice : mapping of str to Resolution
        The finest setting of a simulator within the budget of the preferences; the same simulators are missing.
    """

    costs: Mapping[str, Any]
    advice: Mapping[str, Any]

    @property
    def legacy(self) -> LegacyCost | None:
        """What FreeCAD's legacy simulator takes, at the accuracy of the preferences."""
        cost: LegacyCost | None = self.costs.get(LEGACY.name)
        return cost

    @property
    def opengl(self) -> OpenGLCost | None:
        """What FreeCAD's OpenGL simulator takes; None also where this FreeCAD has none."""
        cost: OpenGLCost | None = self.costs.get(OPENGL.name)
        return cost

    @property
    def resolution(self) -> Resolution | None:
        """The finest image of the z-buffer within the budget of the preferences."""
        chosen: Resolution | None = self.advice.get(ZBUFFER.name)
        return chosen

    def cost(self, simulator: str) -> tuple[float, float] | None:
        """Return seconds and bytes of simulating it, None where they are not known.

        Parameters
        ----------
        simulator : str
            Name of a simulator: ``"z-buffer"``, ``"legacy"``, which runs in fast-forward, or ``"OpenGL"``, at its
            highest speed.

        Raises
        ------
        ValueError
            If there is no simulator of that name.
        """
        cost = self._of(simulator)
        return None if cost is None else (cost.seconds, float(cost.memory_bytes))

    def factor(self, simulator: str) -> float:
        """Return the factor of the time of :meth:`cost`: the true time is between it divided and multiplied by this."""
        cost = self._of(simulator)
        return 1.0 if cost is None else float(cost.factor)

    def _of(self, simulator: str) -> Any:
        names = [known.name for known in SIMULATORS]
        if simulator not in names:
            raise ValueError(f"there is no simulator {simulator!r}: choose among {', '.join(names)}")
        return self.costs.get(simulator)

    def columns(self) -> dict[str, Any]:
        """Return columns of CSV and JSON: the explanations of the advice, and the costs in FreeCAD's simulators."""
        columns = {advice.column: chosen and chosen.explanation for advice, chosen in self._advised()}
        for simulator in _beside_the_papers():
            columns.update(simulator.figures(self.costs.get(simulator.name)))
        return columns

    def factors(self) -> dict[str, float]:
        """Return the factors of these times, see :meth:`factor`, for CSV and JSON."""
        return {s.factor_column: self.factor(s.name) for s in _beside_the_papers() if s.factor_column is not None}

    def advice_messages(self) -> dict[str, Any]:
        """Return the messages of the advice as plain data."""
        return {advice.column: chosen and chosen.why.as_data() for advice, chosen in self._advised()}

    def _advised(self) -> list[tuple[Advice, Any]]:
        return [(s.advice, self.advice.get(s.name)) for s in SIMULATORS if s.advice]


def _beside_the_papers() -> tuple[Simulator, ...]:
    return tuple(simulator for simulator in SIMULATORS if simulator is not ZBUFFER)
