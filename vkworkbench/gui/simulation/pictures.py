# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the picture of the part at the shown moment, in a background thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import numpy as np

from vkworkbench.core import Frame, Strategy, Tool
from vkworkbench.core.rendering import CUT, Field, Scene, Section, draw_path, draw_tool, palette, scene
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation
from vkworkbench.gui.qt.background import Background
from vkworkbench.gui.qt.names import QObject, Signal, single_shot
from vkworkbench.gui.simulation.coloring import COLORINGS, Coloring, Entries, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, SceneBar
from vkworkbench.gui.simulation.moment import Clock, Moment
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.simulating import Findings, Simulated, region_of, seen_region

# Colours of the path of the tool.
PATH_DONE, PATH_TO_COME = (20, 90, 200), (200, 60, 160)


class Drawing:
    """The results of a job's simulation from which its pictures are drawn, as chosen in the controls `bar`."""

    def __init__(self, job: SimulatedJob, clock: Clock, bar: SceneBar) -> None:
        self.job, self.clock, self.bar = job, clock, bar
        self.simulated: Simulated | None = None  # the finest simulation until now
        self.findings: Findings | None = None  # the check of the job; None until the check is finished
        # A finer simulation of the part of the stock to which the user has zoomed.
        self.detail: Simulation | None = None
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self._coloring: Callable[[], Coloring] = _uncolored
        # Cache the last field and its colours, because turning the view draws the same moment many times.
        self._field, self._colors = lru_cache(maxsize=1)(_field_of), lru_cache(maxsize=1)(_colors_of)

    @property
    def simulation(self) -> Simulation | None:
        """The finest simulation until now."""
        return self.simulated and self.simulated.simulation

    @property
    def removal(self) -> Simulated | Findings | None:
        """The most exact source of removed volumes and air cuts: the check, or before it the finest simulation."""
        return self.findings or self.simulated

    def take(self, done: Simulated | Findings) -> None:
        """Use the results of a finer simulation or of the check from now on."""
        if isinstance(done, Simulated):
            self.simulated = done
        else:
            self.findings = done

    def clear(self) -> None:
        """Release all results."""
        self.simulated = self.findings = self.detail = None
        self._coloring = _uncolored
        self._field.cache_clear()
        self._colors.cache_clear()

    def color(self) -> None:
        """Apply the chosen colouring to the surfaces."""
        if self.simulation is None:
            return
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, self.removal.volumes,
                  self.simulated.seen, self._awaits_model, self.bar.tolerance_mm)  # fmt: skip
        make = COLORINGS[self.bar.colorings.currentIndex()][1]
        # The colouring is computed once, for the first picture that needs it.
        self._coloring = lru_cache(maxsize=None)(partial(make, self.simulation.zbuffer, job))

    @property
    def _awaits_model(self) -> bool:
        return bool(self.job.model_shapes) and not self.simulated.is_finest

    def picture(self, moment: Moment, frame: Frame, background: tuple[int, int, int]) -> Picture:
        """Return what to draw for a moment, by the user's settings in the controls; the caller draws the picture."""
        shown, chips = self.bar.chips.currentIndex(), None
        if shown != PART:
            cuts = self.clock.cuts
            cut = cuts.source(moment.last).cut
            chips = tuple(cuts.first[cut : cut + 2].tolist())
        lit = None if moment.noticed is None else moment.of_command(moment.noticed)
        at = self.simulation, moment.done
        return Picture(
            partial(self._field, self.finest_for(frame), moment.done, chips, shown != CHIPS, self._section(frame)),
            self._coloring,
            partial(self._colors, *at),
            partial(scene, lit=lit, background=background),
            self._paths(moment) if self.bar.path.isChecked() else (),
            self._tool(moment),
            frame,
        )

    def finest_for(self, frame: Frame) -> Simulation | None:
        """Return the simulation of a part of the stock (detail) if it covers the image; else the finest of the whole.

        The colouring by differences from the model needs the simulation of the whole stock.
        """
        if self.detail is not None and not self.bar.compares:
            seen = seen_region(frame, self.job)
            if seen is not None and region_of(self.detail.zbuffer.frame).contains(seen):
                return self.detail
        return self.simulation

    def _section(self, frame: Frame) -> Section | None:
        """Return the chosen section, which hides the stock between the section and the viewer."""
        axis = self.bar.section.axis
        if axis is None:
            return None
        low, high = self.job.stock.lower[axis], self.job.stock.upper[axis]
        return Section(axis, float(low + self.bar.section.share * (high - low)), bool(frame.direction[axis] <= 0))

    def _tool(self, moment: Moment) -> tuple[Tool, np.ndarray]:
        number, tip = moment.tool_tip()
        return self.job.cuts[number].tool, tip

    def _paths(self, moment: Moment) -> tuple[np.ndarray, np.ndarray]:
        """Return the tool's path in the current operation before the moment (backwards), and after the moment."""
        source = self.clock.cuts.source(moment.last)
        points, at = self.clock.cuts.cuts[source.cut].toolpath.points, source.trajectory + (moment.done > 0)
        return points[at::-1], points[at:]


def _field_of(
    simulation: Simulation, step: int, chips: tuple[int, int] | None, part: bool, section: Section | None
) -> Field:
    return Field(simulation.at(step).zbuffer, chips, part, section)


def _colors_of(simulation: Simulation, step: int, coloring: Coloring) -> np.ndarray:
    return coloring.colors(simulation.at(step).zbuffer) if callable(coloring.colors) else coloring.colors


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture that is not yet drawn."""

    # field, coloring: return the field (surfaces of the part) at the moment, and the colouring.
    field: Callable[[], Field]
    coloring: Callable[[], Coloring]
    colors: Callable[[Coloring], np.ndarray]  # returns the colours that a colouring gives to the surfaces at the moment
    scene: Callable[..., Scene]  # returns the coloured scene of a field in a frame
    # Paths to draw: the finished path, and the path to come; empty if no path is to be drawn.
    paths: tuple[np.ndarray, ...]
    tool: tuple[Tool, np.ndarray]  # the tool, and the position of its tip, mm
    frame: Frame  # the frame of the image

    def draw(self, smoothness: int = 1) -> Drawn:
        """Draw the picture, in any thread. Each pixel is the mean of `smoothness` x `smoothness` smaller pixels."""
        coloring, size = self.coloring(), self.frame
        frame = replace(size, pixel=size.pixel / smoothness, width=size.width * smoothness,
                        height=size.height * smoothness)  # fmt: skip
        drawn = self.scene(self.field(), frame, self.colors(coloring))
        draw_tool(drawn, *self.tool, frame)
        drawn = drawn.averaged(smoothness) if smoothness > 1 else drawn
        for path, color in zip(self.paths, (PATH_DONE, PATH_TO_COME)):
            draw_path(drawn.pixels, path, self.frame, color)
        return Drawn(drawn, self.frame, coloring.legend)


@dataclass(frozen=True, eq=False)
class Drawn:
    """A drawn picture."""

    scene: Scene
    frame: Frame  # the frame of the image
    legend: Callable[[], Entries]  # returns the legend of the colours


def _uncolored() -> Coloring:
    return Coloring(palette(CUT), tuple)


SMOOTH = 2  # each pixel of a smooth picture is the mean of SMOOTH x SMOOTH smaller pixels
_REST = 150  # ms without a change after which the picture is drawn smoothly
_LOOK = 3  # ms between two checks whether the background thread has drawn a picture


class Pictures(QObject):
    """Shows the picture of the shown moment, draws it again after each change, and smoothly after a pause."""

    begun, failed = Signal(), Signal(object)  # drawing of a picture has begun, or has failed with an exception

    def __init__(self, drawing: Drawing, moment: Moment, view: PartView, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._drawing, self._moment, self._view = drawing, moment, view
        self._background = Background(self, _LOOK)
        self._smoothing = Background(self, _LOOK)
        self._rest = single_shot(self._smooth, self, _REST)
        self._changed = False  # whether moment, view or settings have changed since the last picture was begun
        self._legend: Callable[[], Entries] | None = None  # returns the entries of the legend that is shown

    @property
    def is_current(self) -> bool:
        """Whether the shown picture is up to date and smooth."""
        return not (self._changed or self._background.works or self._rest.isActive() or self._smoothing.works)

    def draw(self) -> None:
        """Request a new picture. The next call of `begin` begins the picture if no other picture is being drawn."""
        self._changed = True
        self._rest.stop()
        self._smoothing.give_up()

    def begin(self) -> None:
        """Begin to draw a picture if one was requested and no other picture is being drawn."""
        if not self._changed or self._background.works:
            return
        self._changed = False
        if self._drawing.simulation is None:
            return
        picture = self._drawing.picture(self._moment, self._view.frame, self._view.background)
        self._background.start("", lambda _: [picture.draw()], self._show, self._ended)
        self.begun.emit()

    def show_now(self) -> None:
        """Draw and show the smooth picture in Qt's main thread."""
        self.end()
        self._changed = False
        picture = self._drawing.picture(self._moment, self._view.frame, self._view.background)
        self._show(picture.draw(SMOOTH))
        self.begun.emit()

    def end(self) -> None:
        """Stop drawing."""
        self._background.give_up()
        self._rest.stop()
        self._smoothing.give_up()

    def _show(self, drawn: Drawn) -> None:
        self._view.show_scene(drawn.scene, drawn.frame)
        if drawn.legend is not self._legend:
            self._legend = drawn.legend
            self._drawing.bar.legend.show_entries(drawn.legend())

    def _ended(self, error: Exception | None) -> None:
        self._report(error)
        if error is None and not self._changed:
            self._rest.start()
        self.begin()

    def _smooth(self) -> None:
        """Draw the shown picture again, smoothly."""
        picture = self._drawing.picture(self._moment, self._view.frame, self._view.background)
        self._smoothing.start("", lambda _: [picture.draw(SMOOTH)], self._show, self._report)

    def _report(self, error: Exception | None) -> None:
        if error is not None:
            self.failed.emit(error)
