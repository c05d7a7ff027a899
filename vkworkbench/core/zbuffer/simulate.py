# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer with traces (Blasquez and Poiraudeau 2000): exact simulation of toolpaths."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from vkworkbench.core.solids import Tool, View
from vkworkbench.core.stocks import Solid
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.chains import among, cut_rays
from vkworkbench.core.zbuffer.culling import TILE, Tiles, culled
from vkworkbench.core.zbuffer.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.dexels import THINNEST, UNCUT, Pieces
from vkworkbench.core.zbuffer.memory import BUDGET, check_memory
from vkworkbench.core.zbuffer.moments import ZBuffer
from vkworkbench.core.zbuffer.records import INDEX, Records, Writer
from vkworkbench.core.zbuffer.removal import Removal
from vkworkbench.core.zbuffer.surface import Surface
from vkworkbench.core.zbuffer.tilted import Tilted
from vkworkbench.core.zbuffer.trajectories import Trajectories
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
        blocks = culled(removal, bounds, bottom, min(bottom + TILE, frame.height))
        if going_on is not None:
            going_on(bottom / frame.height)
            blocks = _told(blocks, going_on, bottom / frame.height)
        band, tested = _cut_band(removal, blocks, len(numbered), bottom)
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


def _cut_band(
    trajectories: Trajectories, blocks: Iterable[tuple[Tiles, int]], uncut: int, bottom: int
) -> tuple[Records, int]:
    """The pieces of the rays of a band of the image, and how many pairs were tested for them."""
    frame = trajectories.frame
    top = min(bottom + TILE, frame.height)
    row, column = np.divmod(np.arange(bottom * frame.width, top * frame.width), frame.width)
    x, y = frame.pixel_centres(column, row)
    near, far, gaps = trajectories.stock.spans(frame, x, y)
    inside = far - near > THINNEST
    size = inside.astype(np.int64)
    parts, candidates, pending = [], 0, np.zeros(len(x), bool)
    pending[gaps.ray] = True
    for pixels, tested in blocks:
        candidates += tested
        ray = (pixels.row - bottom) * frame.width + pixels.column
        pair = np.repeat(np.arange(len(ray)), np.diff(pixels.first))
        at = ray.take(pair)
        px, py = x.take(at), y.take(at)
        hits = np.flatnonzero(inside.take(at) & trajectories.passing(px, py, pixels.item))
        enter, leave = trajectories.intervals(px[hits], py[hits], pixels.item[hits])
        owner = trajectories.index[pixels.item[hits]]
        met = inside[ray]
        if not met.all():
            ray, pair = ray[met], (np.cumsum(met) - 1).take(pair)
        pieces = cut_rays(near[ray], far[ray], pair[hits], owner, enter, leave, among(gaps, ray))
        parts.append(_counted(ray, pieces, uncut))
        pending[ray] = False
    ray = np.flatnonzero(pending & inside)
    if len(ray):
        nobody, nowhere = np.empty(0, np.int64), np.empty(0)
        pieces = cut_rays(near[ray], far[ray], nobody, nobody, nowhere, nowhere, among(gaps, ray))
        parts.append(_counted(ray, pieces, uncut))
    for ray, count, _, _ in parts:
        size[ray] = count
    index = np.append(0, np.cumsum(size))
    ends, owners = np.empty(index[-1], np.float32), np.full(index[-1], uncut, np.int32)
    ends[index[:-1][inside]] = far[inside]  # what nothing cuts; the others' pieces are put over it
    for ray, count, end, owner in parts:
        at = np.repeat(index[ray] - (np.cumsum(count) - count), count) + np.arange(len(end))
        ends[at], owners[at] = end, owner
    entry = np.where(inside, near, 0).astype(np.float32)
    return Records(uncut, index.astype(INDEX), entry, ends, owners), candidates


def _counted(ray: np.ndarray, pieces: Pieces, uncut: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Rays with the number of their pieces; ends and owners of these."""
    count = np.bincount(pieces.ray, minlength=len(ray))
    owner = np.where(pieces.owner == UNCUT, uncut, pieces.owner).astype(np.int32)
    return ray, count, pieces.far.astype(np.float32), owner
