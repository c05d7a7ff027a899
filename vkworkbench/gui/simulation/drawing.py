# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a simulation at a moment: its colours, the chips, and what is to be noticed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from vkworkbench.core import Frame, Strategy, ZBuffer
from vkworkbench.core.rendering import CUT, Scene, palette, scene
from vkworkbench.core.zbuffer import SeenModel
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.coloring import COLORINGS, Coloring, Entries, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, SceneBar
from vkworkbench.gui.simulation.moment import Moment
from vkworkbench.gui.simulation.refining import Facts, Refined, Told


class Drawing:
    """What is known of a job's picture.

    Parameters
    ----------
    job : SimulatedJob
    clock : Clock
    bar : SceneBar
        Where the user chooses what is seen, and reads what the colours mean.

    Attributes
    ----------
    simulation : Simulation or None
        The finest one until now.
    told : Told or None
        What the latest one told.
    facts : Facts or None
        What is known of the trajectories, of images of the whole stock.
    strategies : tuple of Strategy
        Of the operations.
    seen : SeenModel or None
        What the part is to be, in the image of the simulation.
    """

    def __init__(self, job: SimulatedJob, clock: Clock, bar: SceneBar) -> None:
        self.job, self.clock, self.bar = job, clock, bar
        self.simulation: Simulation | None = None
        self.told: Told | None = None
        self.facts: Facts | None = None
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self.seen: SeenModel | None = None
        self._coloring: Callable[[], Coloring] = _uncolored

    def take(self, done: Refined | Told) -> None:
        """Take a finer simulation, or what it tells."""
        if isinstance(done, Refined):
            self.simulation, self.seen = done.simulation, done.seen
            return
        # A coarse picture, of another view, does not take the place of a fine one.
        if done.facts is not None and (self.facts is None or done.facts.is_as_fine(self.facts.pixel)):
            self.facts = done.facts
        if done.simulation is self.simulation:
            self.told = done
            if done.seen is not None:
                self.seen = done.seen

    def forget(self) -> None:
        """Know nothing of the picture any more."""
        self.simulation = self.told = self.facts = self.seen = None
        self._coloring = _uncolored

    def color(self) -> None:
        """Colour the surfaces anew."""
        if self.simulation is None:
            return
        volumes = None if self.facts is None else self.facts.volumes
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, volumes, self.seen,
                  self._awaits_model, self.bar.tolerance_mm)  # fmt: skip
        make = COLORINGS[self.bar.colorings.currentIndex()][1]
        # Once, with the first picture that needs it.
        self._coloring = lru_cache(maxsize=None)(partial(make, self.simulation.zbuffer, job))

    @property
    def _awaits_model(self) -> bool:
        told = self.told
        return bool(self.job.model_shapes) and not (told and told.simulation is self.simulation and told.judged)

    def picture(self, moment: Moment, background: tuple[int, int, int]) -> Picture:
        """Return how a moment is to be drawn, as all is chosen now."""
        at = self.simulation.at(moment.done).zbuffer
        shown, chips = self.bar.chips.currentIndex(), None
        if shown != PART:
            cut = at.cuts.source(moment.last).cut
            chips = tuple(at.cuts.first[cut : cut + 2].tolist())
        lit = None if moment.noticed is None else moment.of_command(moment.noticed)
        return Picture(
            at, self._coloring, partial(scene, chips=chips, part=shown != CHIPS, lit=lit, background=background)
        )


@dataclass(frozen=True, eq=False)
class Picture:
    """A moment that is to be drawn.

    Attributes
    ----------
    zbuffer : ZBuffer
        At the moment.
    coloring : callable
        Returns how it is coloured.
    scene : callable
        Returns its scene in colours.
    """

    zbuffer: ZBuffer
    coloring: Callable[[], Coloring]
    scene: Callable[[ZBuffer, np.ndarray], Scene]

    def draw(self) -> Drawn:
        """Draw it, in whatever thread: a fine picture takes a tenth of a second."""
        coloring = self.coloring()
        colors = coloring.colors(self.zbuffer) if callable(coloring.colors) else coloring.colors
        return Drawn(self.scene(self.zbuffer, colors), self.zbuffer.frame, coloring.legend)


@dataclass(frozen=True, eq=False)
class Drawn:
    """A moment that was drawn.

    Attributes
    ----------
    scene : Scene
    frame : Frame
        What it is seen with.
    legend : callable
        Returns what its colours mean.
    """

    scene: Scene
    frame: Frame
    legend: Callable[[], Entries]


def _uncolored() -> Coloring:
    return Coloring(palette(CUT), tuple)
