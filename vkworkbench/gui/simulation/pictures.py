# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a moment: how it is drawn, and drawing it in a background thread."""

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
from vkworkbench.gui.qt.background import Background
from vkworkbench.gui.qt.names import QObject, Signal
from vkworkbench.gui.simulation.coloring import COLORINGS, Coloring, Entries, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, SceneBar
from vkworkbench.gui.simulation.moment import Clock, Moment
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.refining import Facts, Findings, Refined


class Drawing:
    """The results that a job's picture shows.

    Parameters
    ----------
    job : SimulatedJob
    clock : Clock
    bar : SceneBar
        The controls in which the user chooses what is shown.

    Attributes
    ----------
    simulation : Simulation or None
        The finest simulation until now.
    findings : Findings or None
        The findings of the latest simulation.
    facts : Facts or None
        Facts on the trajectories, from images of the whole stock.
    strategies : tuple of Strategy
        Strategies of the operations.
    seen : SeenModel or None
        The model in the image of the simulation.
    """

    def __init__(self, job: SimulatedJob, clock: Clock, bar: SceneBar) -> None:
        self.job, self.clock, self.bar = job, clock, bar
        self.simulation: Simulation | None = None
        self.findings: Findings | None = None
        self.facts: Facts | None = None
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self.seen: SeenModel | None = None
        self._coloring: Callable[[], Coloring] = _uncolored

    def take(self, done: Refined | Findings) -> None:
        """Use a finer simulation or its findings."""
        if isinstance(done, Refined):
            self.simulation, self.seen = done.simulation, done.seen
            return
        # Facts from a coarse picture of another view do not replace facts from a fine one.
        if done.facts is not None and (self.facts is None or done.facts.is_as_fine(self.facts.pixel)):
            self.facts = done.facts
        if done.simulation is self.simulation:
            self.findings = done
            if done.seen is not None:
                self.seen = done.seen

    def clear(self) -> None:
        """Drop all results."""
        self.simulation = self.findings = self.facts = self.seen = None
        self._coloring = _uncolored

    def color(self) -> None:
        """Update the colours of the surfaces."""
        if self.simulation is None:
            return
        volumes = None if self.facts is None else self.facts.volumes
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, volumes, self.seen,
                  self._awaits_model, self.bar.tolerance_mm)  # fmt: skip
        make = COLORINGS[self.bar.colorings.currentIndex()][1]
        # Computed once, for the first picture that needs it.
        self._coloring = lru_cache(maxsize=None)(partial(make, self.simulation.zbuffer, job))

    @property
    def _awaits_model(self) -> bool:
        findings = self.findings
        return bool(self.job.model_shapes) and not (
            findings and findings.simulation is self.simulation and findings.judged
        )

    def picture(self, moment: Moment, background: tuple[int, int, int]) -> Picture:
        """Return the picture of a moment for the present choices, not drawn yet."""
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
    """A picture to draw.

    Attributes
    ----------
    zbuffer : ZBuffer
        The simulation at the moment.
    coloring : callable
        Returns the colouring.
    scene : callable
        Returns the coloured scene.
    """

    zbuffer: ZBuffer
    coloring: Callable[[], Coloring]
    scene: Callable[[ZBuffer, np.ndarray], Scene]

    def draw(self) -> Drawn:
        """Draw the picture, in any thread. A fine picture takes about 0.1 s."""
        coloring = self.coloring()
        colors = coloring.colors(self.zbuffer) if callable(coloring.colors) else coloring.colors
        return Drawn(self.scene(self.zbuffer, colors), self.zbuffer.frame, coloring.legend)


@dataclass(frozen=True, eq=False)
class Drawn:
    """A drawn picture.

    Attributes
    ----------
    scene : Scene
    frame : Frame
        The frame of the image.
    legend : callable
        Returns the legend of the colours.
    """

    scene: Scene
    frame: Frame
    legend: Callable[[], Entries]


def _uncolored() -> Coloring:
    return Coloring(palette(CUT), tuple)


_LOOK = 3  # ms between two checks whether a picture was drawn


class Pictures(QObject):
    """Shows the picture of the moment, and updates it after each change.

    Parameters
    ----------
    drawing : Drawing
    moment : Moment
    view : PartView

    Attributes
    ----------
    begun : Signal
        Drawing of a picture has begun.
    failed : Signal of Exception
    """

    begun, failed = Signal(), Signal(object)

    def __init__(self, drawing: Drawing, moment: Moment, view: PartView, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._drawing, self._moment, self._view = drawing, moment, view
        self._background = Background(self, _LOOK)
        self._changed = False  # since drawing of the last picture began
        self._legend: Callable[[], Entries] | None = None  # the shown legend

    @property
    def is_current(self) -> bool:
        """Whether the shown picture is up to date."""
        return not (self._changed or self._background.works)

    def draw(self) -> None:
        """Redraw at the next `begin`, or after the picture that is being drawn."""
        self._changed = True

    def begin(self) -> None:
        """Begin to draw a picture, if something has changed and no picture is being drawn."""
        if not self._changed or self._background.works:
            return
        self._changed = False
        if self._drawing.simulation is None:
            return
        picture = self._drawing.picture(self._moment, self._view.background)
        show = partial(self._show, self._moment.tool_tip())
        self._background.start("", lambda _: [picture.draw()], show, self._ended)
        self.begun.emit()

    def show_now(self) -> None:
        """Draw and show the picture in the window's thread."""
        self._background.give_up()
        self._changed = False
        picture = self._drawing.picture(self._moment, self._view.background)
        self._show(self._moment.tool_tip(), picture.draw())
        self.begun.emit()

    def end(self) -> None:
        """Stop drawing."""
        self._background.give_up()

    def _show(self, tool: tuple[int, np.ndarray], drawn: Drawn) -> None:
        self._view.show_scene(drawn.scene, drawn.frame)
        number, tip = tool
        self._view.show_tool(self._drawing.job.cuts[number].tool, tip)
        if drawn.legend is not self._legend:
            self._legend = drawn.legend
            self._drawing.bar.legend.show_entries(drawn.legend())

    def _ended(self, error: Exception | None) -> None:
        if error is not None:
            self.failed.emit(error)
        self.begin()
