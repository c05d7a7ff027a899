# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate toolpaths exactly with the extended z-buffer with traces (Blasquez and Poiraudeau 2000)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import closing

from vkworkbench import worker
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer.memory.memory import BUDGET, check_memory, helpers_within, peak_that_was
from vkworkbench.core.zbuffer.rays.records import Writer
from vkworkbench.core.zbuffer.rays.surface import Surface
from vkworkbench.core.zbuffer.simulator.cut_image import CutImage
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.simulator.sharing import cut_bands
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.given import number, of_kind, whole


def simulate(
    toolpath: Toolpath,
    *,
    tool: Tool,
    stock: Solid,
    view: View,
    memory_budget: float = BUDGET,
    going_on: Callable[[float], None] = lambda _: None,
    processes: int | None = None,
) -> ZBuffer:
    """Simulate one toolpath; see :func:`simulate_job`."""
    cuts = [Cut(toolpath, tool)]
    return simulate_job(
        cuts, stock=stock, view=view, memory_budget=memory_budget, going_on=going_on, processes=processes
    )


def simulate_job(
    cuts: Iterable[Cut] | Cuts,
    *,
    stock: Solid,
    view: View,
    memory_budget: float = BUDGET,
    going_on: Callable[[float], None] = lambda _: None,
    processes: int | None = None,
) -> ZBuffer:
    """Simulate toolpaths one after the other on one stock, including rapids.

    An element of a trace is one segment that a trajectory removes from the ray of one pixel. A segment that is at most
    1e-4 mm long is a rounding error and is joined to a neighbouring segment. A trajectory is the straight sweep of the
    tool between two points of the toolpath. Trajectories are numbered consecutively over all operations; see `Cuts`.

    Parameters
    ----------
    cuts : iterable of Cut, or Cuts
        The operations in machining order.
    memory_budget : float
        Largest peak memory of all processes together, bytes.
    going_on : callable, optional
        Called many times a second with the completed share of the simulation, 0 to 1. An exception raised by `going_on`
        ends the simulation.
    processes : int, optional
        Largest number of processes, including this process. The default is one process for each processor core. Other
        processes start if the simulation takes longer than half a second and the memory budget allows more processes.
        The result does not depend on the number of processes.

    Returns
    -------
    ZBuffer
        The simulation after the last trajectory.

    Raises
    ------
    OverBudget
        If the simulation would need more memory than `memory_budget`. If the budget is too small, nothing is simulated.
    ValueError, TypeError
        If an argument has a wrong value or a wrong type.
    """
    memory_budget = number("memory_budget", memory_budget, "a number of bytes, at least 0", lambda size: size >= 0)
    of_kind("going_on", going_on, Callable, "a function")
    if processes is not None:
        processes = whole("processes", processes, "a whole number of at least 1", lambda n: n >= 1)
    numbered = cuts if isinstance(cuts, Cuts) else Cuts(cuts)
    frame = fitted(view, stock)
    image = CutImage(numbered, stock, frame)
    check_memory(image.removal, len(numbered), memory_budget)

    def helpers() -> int:
        wanted = (worker.processes() if processes is None else processes) - 1
        return min(wanted, helpers_within(memory_budget, image.removal, len(numbered))) if wanted else 0

    writer = Writer(len(numbered), frame.width * frame.height)
    candidates = 0
    with closing(cut_bands(image, helpers, going_on)) as found:
        for band, tested in found:
            writer.append(band)
            candidates += tested
    records = writer.records()
    peak = peak_that_was(records, image.removal)
    return ZBuffer(frame, numbered, len(numbered), records, Surface(records), candidates, peak)
