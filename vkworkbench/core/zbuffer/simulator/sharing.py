# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut the regions of an image in this process and, if cutting takes long, in other processes.

The regions can be cut in any order. Several threads are hardly faster than one, because numpy holds the global
interpreter lock (GIL) for arrays that fit into the processor's cache (`benchmarks/sharing.py`). Therefore the image is
sent to other processes, which cut regions and return the regions' records (segments of rays).
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Generator
from contextlib import suppress

from vkworkbench.core.zbuffer.culling.tiles import TILE, Region
from vkworkbench.core.zbuffer.rays.records import Records, side_by_side
from vkworkbench.core.zbuffer.simulator.cut_image import CutImage
from vkworkbench.worker import Worker, WorkerDied

# _ALONE: time after which this process starts other processes, s. _START: time that other processes need to start, s.
_ALONE, _START = 0.5, 0.35
# Number of regions of the image for each process. With fewer regions, the other processes wait longer for the slowest
# process at the end. With more regions, each region is smaller and takes more time per pixel.
_REGIONS = 12
_WAIT = 0.05  # time between two calls of `going_on` while waiting for other processes, s


def cut_bands(
    image: CutImage, helpers: Callable[[], int], going_on: Callable[[float], None]
) -> Generator[tuple[Records, int], None, None]:
    """Cut all bands (strips of `TILE` rows of pixels) of an image, the lowest band first.

    Parameters
    ----------
    helpers : callable
        Returns the number of other processes to start; called once, and only if cutting takes longer than `_ALONE`.
    going_on : callable
        Called many times a second with the completed share of the image, 0 to 1. An exception raised by `going_on`
        stops the cutting.

    Yields
    ------
    Records, int
        Records (segments of rays) of each band, and how many times a trajectory was tested against a tile or a pixel of
        the band.
    """
    begin = time.monotonic()
    shared = _Shared(image.bands)
    crew: _Crew | None = None

    def report() -> None:
        nonlocal crew
        going_on(shared.share)
        if crew is None and shared.left and time.monotonic() - begin > _ALONE:
            crew = _Crew(image, helpers(), shared)

    try:
        for band in image.bands:
            while not shared.has(band):
                report()
                region = shared.take()
                if region is None:
                    shared.wait(band, _WAIT)
                    continue
                shared.give(region, image(region, report))
            yield shared.fetch(band)
    finally:
        if crew is not None:
            crew.end()


def shared_seconds(seconds: float, processes: int) -> float:
    """Return the time after which several processes finish work that takes `seconds` in one process, s."""
    alone = min(seconds, _ALONE + _START)
    return alone + (seconds - alone) / processes


class _Shared:
    """Regions that are not yet cut (pending), and the results of finished regions, shared by several threads."""

    def __init__(self, bands: list[Region]) -> None:
        self._todo = deque(bands)
        self._found: dict[Region, tuple[Records, int]] = {}
        self._regions = {band: [band] for band in bands}
        self._changed = threading.Condition()
        self._all = len(bands) * bands[0].right
        self._done = 0

    @property
    def share(self) -> float:
        """Completed share of the image, 0 to 1."""
        return self._done / self._all

    @property
    def left(self) -> int:
        """Number of regions that wait to be cut."""
        return len(self._todo)

    def divide(self, processes: int) -> None:
        """Divide the pending bands (strips of pixel rows) into regions, if possible `_REGIONS` for each process."""
        with self._changed:
            bands = list(self._todo)
            self._todo.clear()
            tiles = sum(-(-band.right // TILE) for band in bands)
            run = TILE * max(1, tiles // (_REGIONS * processes))
            for band in bands:
                lefts = range(0, band.right, run)
                self._regions[band] = [band._replace(left=left, right=min(left + run, band.right)) for left in lefts]
                self._todo.extend(self._regions[band])

    def take(self) -> Region | None:
        """Return the next region that waits to be cut, or None if no region waits."""
        with self._changed:
            return self._todo.popleft() if self._todo else None

    def give(self, region: Region, found: tuple[Records, int]) -> None:
        """Store the result of a region."""
        with self._changed:
            self._found[region] = found
            self._done += region.right - region.left
            self._changed.notify()

    def give_back(self, region: Region) -> None:
        """Mark a region as pending again, because cutting this region failed."""
        with self._changed:
            self._todo.appendleft(region)
            self._changed.notify()

    def has(self, band: Region) -> bool:
        """Return whether all regions of a band are finished."""
        return all(region in self._found for region in self._regions[band])

    def wait(self, band: Region, seconds: float) -> None:
        """Wait at most `seconds` until a band (strip of pixel rows) is finished or a region is pending."""
        with self._changed:
            self._changed.wait_for(lambda: self.has(band) or self._todo, seconds)

    def fetch(self, band: Region) -> tuple[Records, int]:
        """Return the result of a finished band, and delete the stored result."""
        found = [self._found.pop(region) for region in self._regions[band]]
        return side_by_side([records for records, _ in found], band.top - band.bottom), sum(n for _, n in found)


class _Crew:
    """Other processes that cut regions, each with a thread that waits for its results."""

    def __init__(self, image: CutImage, size: int, shared: _Shared) -> None:
        self._workers: list[Worker] = []
        self._threads: list[threading.Thread] = []
        size = min(size, shared.left)
        if size < 1:
            return
        shared.divide(1 + size)
        for _ in range(size):
            try:
                worker = Worker(image)
            except WorkerDied:
                break
            self._workers.append(worker)
            self._threads.append(threading.Thread(target=_have_cut, args=(worker, shared), daemon=True))
            self._threads[-1].start()

    def end(self) -> None:
        for worker in self._workers:
            worker.kill()
        for thread in self._threads:
            thread.join()


def _have_cut(worker: Worker, shared: _Shared) -> None:
    """Let a worker cut regions until no region is pending.

    If the worker fails, the region that the worker was cutting is pending again.
    """
    try:
        with suppress(WorkerDied):
            worker.get_ready()
            while (region := shared.take()) is not None:
                try:
                    shared.give(region, worker(region))
                except BaseException:
                    shared.give_back(region)
                    raise
    finally:
        worker.end()
