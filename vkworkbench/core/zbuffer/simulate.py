# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer with traces (Blasquez and Poiraudeau 2000): exact simulation of toolpaths."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from vkworkbench.core.solids import Tool, View
from vkworkbench.core.stocks import Solid
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.bands import cut_band
from vkworkbench.core.zbuffer.culling import TILE, Tiles, culled
from vkworkbench.core.zbuffer.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.memory import BUDGET, check_memory
from vkworkbench.core.zbuffer.moments import ZBuffer
from vkworkbench.core.zbuffer.records import Writer
from vkworkbench.core.zbuffer.removal import Removal
from vkworkbench.core.zbuffer.surface import Surface
from vkworkbench.core.zbuffer.tilted import Tilted
from vkworkbench.core.zbuffer.upright import Upright


def simulate(
    toolpath: Toolpath,
    *,
    tool: Tool,
    stock: Solid,
    view: View,
    memory_budget: float = BUDGET,
    going_on: Callable[[float], None] | None = None,
) -> ZBuffer:
    """Cut the stock by one toolpath; see :func:`simulate_job`, of which this is a job of one operation."""
    cuts = [Cut(toolpath, tool)]
    return simulate_job(cuts, stock=stock, view=view, memory_budget=memory_budget, going_on=going_on)


def simulate_job(
    cuts: Iterable[Cut],
    *,
    stock: Solid,
    view: View,
    memory_budget: float = BUDGET,
    going_on: Callable[[float], None] | None = None,
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
        Bytes that the process may take for it at its peak.
    going_on : callable, optional
        Called many times a second with the share of the image that is done, 0 to 1; what it raises ends the simulation.

    Returns
    -------
    ZBuffer
        At its last moment.

    Raises
    ------
    OverBudget
        Before anything is simulated, if it would take more memory than that.
    """
    numbered = Cuts(cuts)
    frame = view.frame(stock)
    removal = Removal(numbered, stock, frame)
    check_memory(removal, len(numbered), memory_budget)
    bounds = Upright(removal) if removal.sine == 0 else Tilted(removal)
    writer = Writer(len(numbered), frame.width * frame.height)
    candidates = 0
    for bottom in range(0, frame.height, TILE):
        blocks = culled(removal, bounds, bottom)
        if going_on is not None:
            going_on(bottom / frame.height)
            blocks = _told(blocks, going_on, bottom / frame.height)
        band, tested = cut_band(removal, bounds, blocks, len(numbered), bottom)
        writer.append(band)
        candidates += tested
    records = writer.records()
    return ZBuffer(frame, numbered, len(numbered), records, Surface(records), candidates)


def _told(
    blocks: Iterator[tuple[Tiles, int]], going_on: Callable[[float], None], done: float
) -> Iterator[tuple[Tiles, int]]:
    for block in blocks:
        going_on(done)
        yield block
