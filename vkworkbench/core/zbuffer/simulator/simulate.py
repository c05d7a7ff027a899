# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer with traces (Blasquez and Poiraudeau 2000): exact simulation of toolpaths."""

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
    """Cut the stock by one toolpath; see :func:`simulate_job`, of which this is a job of one operation."""
    cuts = [Cut(toolpath, tool)]
    return simulate_job(
        cuts, stock=stock, view=view, memory_budget=memory_budget, going_on=going_on, processes=processes
    )


def simulate_job(
    cuts: Iterable[Cut],
    *,
    stock: Solid,
    view: View,
    memory_budget: float = BUDGET,
    going_on: Callable[[float], None] = lambda _: None,
    processes: int | None = None,
) -> ZBuffer:
    """Cut the stock by toolpaths one after the other, by all trajectories, rapids included, and count exactly.

    An element of a trace is one piece a trajectory removes from one pixel's ray. Pieces up to 1e-4 mm are
    rounding noise and go to their neighbour. A trajectory is the straight sweep of the tool between two
    points of the toolpath. The trajectories of all cuts are numbered through; see `Cuts`.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in their order.
    stock : Solid
    view : View
    memory_budget : float
        Bytes that all processes together may take for it at their peak.
    going_on : callable, optional
        Called many times a second with the share of the image that is done, 0 to 1; what it raises ends the simulation.
    processes : int, optional
        How many may cut, this one included: where it takes longer than half a second, and memory allows. One for each
        core by default. The records do not depend on it.

    Returns
    -------
    ZBuffer
        At its last moment.

    Raises
    ------
    OverBudget
        Before anything is simulated, if it would take more memory than that.
    ValueError, TypeError
        Where an argument is something else.
    """
    memory_budget = number("memory_budget", memory_budget, "a number of bytes, at least 0", lambda size: size >= 0)
    of_kind("going_on", going_on, Callable, "a function")
    if processes is not None:
        processes = whole("processes", processes, "a whole number of at least 1", lambda n: n >= 1)
    numbered = Cuts(cuts)
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
