# SPDX-License-Identifier: LGPL-2.1-or-later
"""List the simulators. To add a simulator, write a module that predicts its cost, and add an entry here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from vkworkbench.core.simulators import legacy, legacy_cautions, opengl, zbuffer
from vkworkbench.core.simulators.on_demand import OnDemand
from vkworkbench.core.simulators.simulator import Conditions, Cost, Simulator, Task
from vkworkbench.language import QT_TRANSLATE_NOOP, Message

# : The paper's extended z-buffer. The names of the z-buffer's columns in CSV and JSON have no prefix.
ZBUFFER = Simulator(
    name=zbuffer.NAME,
    since=(),
    predict=zbuffer.predict,
    together=zbuffer.together,
    cautions=None,
    kept=zbuffer.ZBufferCost,
    less_memory=Message("smaller-image"),
    most_bytes=zbuffer.most_bytes,
    columns={
        "dexels": lambda cost: cost.dexels,
        "traces": lambda cost: cost.traces,
        "traces_error": lambda cost: cost.traces_error,
        "memory_bytes": lambda cost: cost.memory_bytes,
        "seconds": lambda cost: cost.seconds,
        "factor": lambda cost: cost.factor,
    },
    factor_column=None,
    time_tooltip=QT_TRANSLATE_NOOP(
        "Vk_Results",
        "Time that Simulate Toolpaths takes. An operation is simulated alone, "
        "on the whole stock. In a job, each operation cuts the stock that is left.",
    ),
    memory_tooltip=QT_TRANSLATE_NOOP(
        "Vk_Results",
        "Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.",
    ),
)

#: FreeCAD's older simulator.
LEGACY = Simulator(
    name=legacy.NAME,
    since=(0,),
    predict=lambda task, given: legacy.legacy_cost(task, accuracy=given.legacy_accuracy, constants=given.constants),
    together=legacy.legacy_together,
    cautions=legacy_cautions.cautions,
    kept=legacy.LegacyCost,
    less_memory=Message("coarser-accuracy"),
    columns={
        "legacy_seconds": lambda cost: cost.seconds,
        "legacy_play_seconds": lambda cost: cost.play_seconds,
        "legacy_memory_bytes": lambda cost: cost.memory_bytes,
    },
    factor_column="legacy_factor",
    time_tooltip=QT_TRANSLATE_NOOP(
        "Vk_Results", "Time in FreeCAD's legacy simulator in fast-forward, at the accuracy set in the preferences."
    ),
    memory_tooltip=QT_TRANSLATE_NOOP(
        "Vk_Results", "Memory of FreeCAD's legacy simulator, at the accuracy set in the preferences."
    ),
    preferences=("legacy_accuracy",),
)

#: FreeCAD's newer simulator, which draws the cuts of all earlier operations with every operation.
OPENGL = Simulator(
    name=opengl.NAME,
    since=opengl.SINCE,
    predict=lambda task, given: opengl.opengl_cost(
        task, speeds=opengl.opengl_speeds(given.version), quality=given.opengl_quality, constants=given.constants
    ),
    together=opengl.opengl_together,
    cautions=opengl.cautions,
    kept=opengl.OpenGLCost,
    less_memory=Message("fewer-operations"),
    columns={
        "opengl_seconds": lambda cost: cost.seconds,
        "opengl_frame_seconds": lambda cost: cost.frame_seconds,
        "opengl_memory_bytes": lambda cost: cost.memory_bytes,
    },
    factor_column="opengl_factor",
    time_tooltip=QT_TRANSLATE_NOOP("Vk_Results", "Time in FreeCAD's OpenGL simulator at its highest speed."),
    memory_tooltip=QT_TRANSLATE_NOOP("Vk_Results", "Memory of FreeCAD's OpenGL simulator."),
    preferences=("opengl_quality",),
)

SIMULATORS = (ZBUFFER, LEGACY, OPENGL)


def available(version: tuple[int, ...]) -> tuple[Simulator, ...]:
    """Return the simulators that can be used with a version of FreeCAD.

    Parameters
    ----------
    version : tuple of int
        Version of FreeCAD, with at least the major and the minor number; empty without FreeCAD.
    """
    return tuple(simulator for simulator in SIMULATORS if tuple(version) >= simulator.since)


def predict(task: Task, conditions: Conditions) -> tuple[OnDemand, OnDemand]:
    """Predict the cost of an operation with known tool and stock in every simulator that `conditions.version` has.

    Returns
    -------
    costs, advice : OnDemand
        The costs by the names of the simulators, and the z-buffer's finest image within the budget by the z-buffer's
        name. Each value is computed at its first use.
    """
    task = task.without_words()
    stepover = task.recognition and task.recognition.stepover
    budget = {"memory_bytes": conditions.memory_budget, "seconds": conditions.time_budget}
    simulators = available(conditions.version)
    costs = OnDemand({s.name: partial(s.predict, task, conditions) for s in simulators})

    return costs, OnDemand(
        {ZBUFFER.name: lambda: zbuffer.finest_image([costs[ZBUFFER.name]], stepover=stepover, **budget)}
    )


def together(
    each: Sequence[Mapping[str, Cost]], *, labels: Sequence[str], stepover: float | None, **budget: float
) -> tuple[OnDemand, OnDemand]:
    """Return the costs of several operations that are simulated one after the other.

    Parameters
    ----------
    each : sequence of mappings of str to Cost
        The costs of each operation by the names of the simulators.
    labels : sequence of str
        Label of each operation.
    stepover : float or None
        Smallest stepover of the operations, mm; None if unknown.
    **budget : float
        The budgets `memory_bytes` and `seconds`, within which the finest image is chosen.

    Returns
    -------
    costs, advice : OnDemand
        Mappings as from :func:`predict`, but without the simulators whose cost is unknown.
    """

    def known(name: str) -> tuple[list[str], list[Any]]:
        found = [(label, own[name]) for label, own in zip(labels, each) if name in own]
        if not found:
            raise KeyError(name)
        return [label for label, _ in found], [cost for _, cost in found]

    def total(simulator: Simulator) -> Cost:
        return simulator.together(known(simulator.name)[1])

    def finest_image() -> Any:
        named, alone = known(ZBUFFER.name)
        return zbuffer.finest_image(alone, labels=named, stepover=stepover, **budget)

    return OnDemand({s.name: partial(total, s) for s in SIMULATORS}), OnDemand({ZBUFFER.name: finest_image})
