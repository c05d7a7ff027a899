# SPDX-License-Identifier: LGPL-2.1-or-later
"""The image cut part by part, by this process and, where that takes long, by others beside it.

The parts do not depend on each other. Threads gain little: numpy keeps Python's lock on arrays that fit the processor's
cache (`benchmarks/sharing.py`). So the others are processes, which are told what is cut and send the records back.
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

# So long one process cuts alone, and so long the others then take to begin, s.
_ALONE, _START = 0.5, 0.35
# Into so many regions for each process the rest is divided: small ones end together, large ones are quicker.
_REGIONS = 12
_TOLD = 0.05  # s between two calls while others are waited for


def cut_bands(
    image: CutImage, helpers: Callable[[], int], going_on: Callable[[float], None]
) -> Generator[tuple[Records, int], None, None]:
    """Cut all bands of an image, the lowest first.

    Parameters
    ----------
    image : CutImage
    helpers : callable
        Asked once, where it takes long, how many processes may help.
    going_on : callable
        Called many times a second with the share that is done; what it raises ends it.

    Yields
    ------
    Records, int
        What `image` gives of each band.
    """
    begin = time.monotonic()
    shared = _Shared(image.bands)
    crew: _Crew | None = None

    def told() -> None:
        nonlocal crew
        going_on(shared.share)
        if crew is None and shared.left and time.monotonic() - begin > _ALONE:
            crew = _Crew(image, helpers(), shared)

    try:
        for band in image.bands:
            while not shared.has(band):
                told()
                region = shared.take()
                if region is None:
                    shared.wait(band, _TOLD)
                    continue
                shared.give(region, image(region, told))
            yield shared.fetch(band)
    finally:
        if crew is not None:
            crew.end()


def shared_seconds(seconds: float, processes: int) -> float:
    """Return how long several processes take for what takes one so long, s."""
    alone = min(seconds, _ALONE + _START)
    return alone + (seconds - alone) / processes


def unshared_seconds(seconds: float, processes: int) -> float:
    """Return how long one process takes for what takes several so long, s: the inverse of :func:`shared_seconds`."""
    alone = min(seconds, _ALONE + _START)
    return alone + (seconds - alone) * processes


class _Shared:
    """What is to be done and what is found, for several threads."""

    def __init__(self, bands: list[Region]) -> None:
        self._todo = deque(bands)
        self._found: dict[Region, tuple[Records, int]] = {}
        self._regions = {band: [band] for band in bands}
        self._changed = threading.Condition()
        self._all = len(bands) * bands[0].right
        self._done = 0

    @property
    def share(self) -> float:
        """How much of the image is found."""
        return self._done / self._all

    @property
    def left(self) -> int:
        """How many regions nobody works on yet."""
        return len(self._todo)

    def divide(self, processes: int) -> None:
        """Divide the bands that nobody works on yet for so many processes."""
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
        """Return the next region; None where there is none."""
        with self._changed:
            return self._todo.popleft() if self._todo else None

    def give(self, region: Region, found: tuple[Records, int]) -> None:
        """Add what a region became."""
        with self._changed:
            self._found[region] = found
            self._done += region.right - region.left
            self._changed.notify()

    def give_back(self, region: Region) -> None:
        """Leave a region to others."""
        with self._changed:
            self._todo.appendleft(region)
            self._changed.notify()

    def has(self, band: Region) -> bool:
        """Whether all of a band is found."""
        return all(region in self._found for region in self._regions[band])

    def wait(self, band: Region, seconds: float) -> None:
        """Wait until a band is found, or there is something to do, but not longer than that."""
        with self._changed:
            self._changed.wait_for(lambda: self.has(band) or self._todo, seconds)

    def fetch(self, band: Region) -> tuple[Records, int]:
        """Return a band that is found, and forget it."""
        found = [self._found.pop(region) for region in self._regions[band]]
        return side_by_side([records for records, _ in found], band.top - band.bottom), sum(n for _, n in found)


class _Crew:
    """Processes that help, each with a thread that waits for it. Without them there is more for this process to do."""

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
    """Have regions cut until there are none. One that is taken and not found would be waited for without end."""
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
