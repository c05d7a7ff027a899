# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a simulation as it is at a moment: its colours, the chips, what is to be noticed, and the tool."""

from __future__ import annotations

from vkworkbench.core import Strategy
from vkworkbench.core.rendering import CUT, palette, scene
from vkworkbench.core.zbuffer import SeenModel
from vkworkbench.document.simulated_job import SimulatedJob
from vkworkbench.document.simulation import Simulation
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.coloring import COLORINGS, Colors, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, SceneBar
from vkworkbench.gui.simulation.moment import Moment
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.refining import Refined, Told


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
    strategies : tuple of Strategy
        Of the operations.
    seen : SeenModel or None
        What the part is to be, in the image of the simulation.
    """

    def __init__(self, job: SimulatedJob, clock: Clock, bar: SceneBar) -> None:
        self.job, self.clock, self.bar = job, clock, bar
        self.simulation: Simulation | None = None
        self.told: Told | None = None
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self.seen: SeenModel | None = None
        self._colors: Colors = palette(CUT)

    def take(self, done: Refined | Told) -> None:
        """Take a finer simulation, or what it tells."""
        if isinstance(done, Refined):
            self.simulation, self.seen = done.simulation, done.seen
        else:
            self.told = done
            if done.simulation is self.simulation and done.seen is not None:
                self.seen = done.seen

    def forget(self) -> None:
        """Know nothing of the picture any more."""
        self.simulation = self.told = self.seen = None
        self._colors = palette(CUT)

    def color(self) -> None:
        """Colour the surfaces anew."""
        if self.simulation is None:
            return
        volumes = None if self.told is None else self.told.volumes
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, volumes, self.seen,
                  self.bar.tolerance_mm)  # fmt: skip
        coloring = COLORINGS[self.bar.colorings.currentIndex()][1](self.simulation.zbuffer, job)
        self._colors = coloring.colors
        self.bar.legend.show_entries(coloring.legend)

    def draw(self, view: PartView, moment: Moment) -> None:
        """Draw a moment."""
        zbuffer = self.simulation.at(moment.done).zbuffer
        shown, chips = self.bar.chips.currentIndex(), None
        if shown != PART:
            cut = zbuffer.cuts.source(moment.last).cut
            chips = tuple(zbuffer.cuts.first[cut : cut + 2].tolist())
        lit = None if moment.noticed is None else moment.of_command(moment.noticed)
        colors = self._colors(zbuffer) if callable(self._colors) else self._colors
        picture = scene(zbuffer, colors, chips=chips, part=shown != CHIPS, lit=lit, background=view.background)
        view.show_scene(picture, zbuffer.frame)
        number, tip = moment.tool_tip()
        view.show_tool(self.job.cuts[number].tool, tip)
