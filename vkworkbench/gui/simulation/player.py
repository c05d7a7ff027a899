# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that is simulated: the part, the time line, and what made each surface."""

from __future__ import annotations

import traceback

import FreeCAD
import FreeCADGui as Gui
import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.rendering import CUT, direction_of, palette, scene
from vkworkbench.core.zbuffer import SeenModel
from vkworkbench.document.simulated_faults import keep_faults
from vkworkbench.document.simulated_job import SimulatedJob
from vkworkbench.document.simulation import Simulation
from vkworkbench.gui import docks, pills
from vkworkbench.gui.background import Background
from vkworkbench.gui.plain_text import as_plain
from vkworkbench.gui.qt import QLabel, QSizePolicy, QTimer, QVBoxLayout, QWidget, Signal
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.coloring import COLORINGS, Colors, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, TOLERANCE, PlayBar, SceneBar
from vkworkbench.gui.simulation.faults import Fault, differences, faults
from vkworkbench.gui.simulation.moment import Moment
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.refining import Refined, Refining, Told
from vkworkbench.gui.simulation.time_line import Block, TimeLine, Warned
from vkworkbench.gui.text import translate
from vkworkbench.language import Message, Unusable

_TICK = 20  # ms between two looks at the work, and two pictures of a play
_SERIOUS, _FAST = "#d32f2f", "#e08000"  # crashes and gouges, fast plunges


class Player(QWidget):
    """Simulates a job and shows any moment of it.

    Parameters
    ----------
    job : SimulatedJob

    Attributes
    ----------
    moment : Moment
        What is shown.
    simulation : Simulation or None
        The finest one until now.
    volumes : (n,) float64
        What each trajectory removes, mm^3; zeros until it is known.
    faults : list of Fault
        What is wrong, as far as it is known.
    asked : Signal
        The user asked the part; the operation that made the place is selected.
    """

    asked = Signal()

    def __init__(self, job: SimulatedJob, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.job, self.clock = job, Clock(job)
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self.simulation: Simulation | None = None
        self.faults: list[Fault] = []
        self.volumes = np.zeros(len(self.clock.cuts))
        self.moment = Moment(self.clock, self)
        self.view = PartView(job.stock, preferences.DIRECTIONS["Isometric"])
        self.time_line = TimeLine()
        self.scene_bar, self.play_bar = SceneBar(), PlayBar()
        self.state = as_plain(QLabel())
        self.state.setSizePolicy(QSizePolicy.Ignored, QSizePolicy.Preferred)
        self._refining: Refining | None = None
        self._work, self._recognizing = Background(self), Background(self)
        self._told: Told | None = None
        self._seen: SeenModel | None = None  # in the image of the simulation
        self._colors: Colors = palette(CUT)
        self._stale = False
        self._cost = ""
        self._commands: tuple[str, list] = ("", [])
        self._lay_out()
        self._connect()
        self._show_blocks()
        self._show_moment()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(_TICK)

    def _lay_out(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.scene_bar)
        layout.addWidget(self.view, 1)
        for widget in (self.play_bar, self.time_line, self.state):
            layout.addWidget(widget)

    def _connect(self) -> None:
        self.view.view_rested.connect(self.simulate)
        self.view.asked.connect(self.ask)
        self.view.restyled.connect(self.draw)
        self.moment.changed.connect(self._show_moment)
        self.time_line.moved.connect(self.moment.go_to)
        self.time_line.clicked.connect(self.moment.choose)
        self.play_bar.stepped.connect(self.moment.step)
        self.play_bar.play_clicked.connect(self.moment.play)
        self.scene_bar.looked.connect(self.look)
        self.scene_bar.recolored.connect(self._recolor)
        self.scene_bar.pointed.connect(self.point)
        self.scene_bar.chosen.connect(self.draw)
        self.scene_bar.saved.connect(lambda save: save(self))

    def _show_blocks(self) -> None:
        begins = self.clock.ends[self.clock.cuts.first]
        blocks = []
        for number, (operation, strategy) in enumerate(zip(self.job.operations, self.strategies)):
            begin, end = float(begins[number]), float(begins[number + 1])
            tooltip = f"{operation.label}\n{strategy_name(strategy)}, {self._duration(end - begin)}"
            blocks.append(Block(operation.label, tooltip, strategy.color, begin, end))
        self.time_line.show_job(tuple(blocks), self.clock.total)

    def _duration(self, seconds: float) -> str:
        text = user().time(seconds)
        return text if self.clock.complete else translate("Vk_Simulate", "about {}").format(text)

    # Simulating

    @property
    def is_busy(self) -> bool:
        """Whether a finer picture, or the strategies, are still to come."""
        return self._work.works or self._recognizing.works

    def simulate(self) -> None:
        """Simulate what is looked at, coarsely first."""
        chosen = preferences.read()
        self._refining = Refining(
            self.job, self.view.view, chosen.memory_budget_bytes, chosen.time_budget,
            glance=self.simulation is None, compare=self.scene_bar.compares,
        )  # fmt: skip
        self._work.start("", self._refining, self._take, self._ended)

    def end(self) -> None:
        """Stop all work."""
        self._timer.stop()
        self._work.give_up()
        self._recognizing.give_up()

    def _tick(self) -> None:
        if self._work.works:
            self._say_progress()
        self.moment.go_on(self.play_bar.speed(self.clock.total))
        if self._stale:
            self._draw()

    def _say_progress(self) -> None:
        left, memory = self._refining.left()
        working = translate("Vk_Simulate", "Simulating… {}").format(user().share(self._refining.share))
        if left is not None:
            text = translate("Vk_Simulate", "finest picture in about {}, {}")
            working += ", " + text.format(user().time(left), user().memory(memory))
        self._say(working)

    def _say(self, *texts: str) -> None:
        text = "   ".join(filter(None, (self._cost, *texts)))
        self.state.setText(text)
        self.state.setToolTip(text)

    def _ended(self, error: Exception | None) -> None:
        self._say(*map(said, self.job.remarks), *([_told(error)] if error else []))

    def _take(self, done: Refined | Told) -> None:
        if isinstance(done, Refined):
            self._show_refined(done)
        else:
            self._show_told(done)
        self._color()

    def _show_refined(self, done: Refined) -> None:
        if self.simulation is None:  # the part comes before the strategies
            found: list[Strategy] = []
            self._recognizing.start(
                "", lambda _: self.job.strategies(), found.append, lambda error: self._recognized(found, error)
            )
        self.simulation, self._seen = done.simulation, done.seen
        zbuffer = done.simulation.zbuffer
        self._cost = translate("Vk_Simulate", "{} × {} pixels of {}, {} traces, {}, simulated in {}").format(
            user().count(zbuffer.frame.width), user().count(zbuffer.frame.height),
            user().measure(zbuffer.frame.pixel, 2), user().count(zbuffer.traces), user().memory(zbuffer.memory_bytes), user().time(done.seconds),
        )  # fmt: skip

    def _show_told(self, told: Told) -> None:
        self._told, self.volumes = told, told.volumes
        if told.simulation is self.simulation and told.seen is not None:
            self._seen = told.seen
        self._list_faults()
        self._keep_faults()

    def _recognized(self, found: list[Strategy], error: Exception | None) -> None:
        if error is None:
            self.strategies = tuple(found)
            self._show_blocks()
            self._color()
        else:
            self._say(_told(error))

    def _list_faults(self) -> None:
        """List what is wrong, and the worst differences to the model; both depend on the tolerance."""
        told, tolerance = self._told, self.scene_bar.tolerance_mm
        if told is None:
            return
        self.faults = faults(told, tolerance)
        entries = [(self._text(fault), fault) for fault in self.faults]
        self.scene_bar.list_warnings(entries)
        compared = differences(told, tolerance) if self.scene_bar.compares else []
        self.scene_bar.list_worst([(self._text(fault), fault) for fault in compared])
        warned = tuple(
            Warned(float(self.clock.ends[fault.trajectory + 1]), text, _SERIOUS if fault.serious else _FAST)
            for text, fault in entries
        )
        self.time_line.show_facts(self.clock.ends, told.volumes, told.air, warned)

    def _keep_faults(self) -> None:
        """Let marks and results tell what is wrong with the operations."""
        serious = [fault for fault in faults(self._told, TOLERANCE) if fault.serious]
        keep_faults({
            operation: [(fault.command, fault.what) for fault in serious if fault.cut == number]
            for number, operation in enumerate(self.job.operations)
        })  # fmt: skip
        pills.show()
        results = docks.find(docks.RESULTS)
        if results is not None:
            results.refresh()

    def _text(self, fault: Fault) -> str:
        """Where and what a fault is."""
        if fault.cut is None:
            return translate("Vk_Simulate", "raw stock: {}").format(said(fault.what))
        operation = self.job.operations[fault.cut]
        text = translate("Vk_Simulate", "{}, command {} ({}): {}")
        return text.format(operation.label, fault.command + 1, self.code(operation, fault.command), said(fault.what))

    # Showing

    def show_now(self, seconds: float) -> None:
        """Show a moment at once, without waiting for the next tick."""
        self.moment.go_to(seconds)
        self._draw()

    def draw(self) -> None:
        """Show the moment anew."""
        self._stale = True

    def _show_moment(self) -> None:
        self.view.show_place(None)
        self.time_line.show_moment(self.moment.seconds)
        self.play_bar.show_playing(self.moment.plays)
        self.draw()

    def _recolor(self) -> None:
        """Take another colouring or tolerance; the model is seen first, where that was not necessary until now."""
        if self.scene_bar.compares and self._seen is None and self.job.model_shapes:
            self.simulate()
        self._list_faults()
        self._color()

    def _color(self) -> None:
        """Colour the surfaces anew."""
        if self.simulation is None:
            return
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, self.volumes,
                  self._seen, self.scene_bar.tolerance_mm)  # fmt: skip
        coloring = COLORINGS[self.scene_bar.colorings.currentIndex()][1](self.simulation.zbuffer, job)
        self._colors = coloring.colors
        self.scene_bar.show_legend(coloring.legend)
        self.draw()

    def _draw(self) -> None:
        self._stale = False
        if self.simulation is None:
            return
        zbuffer, moment = self.simulation.at(self.moment.done).zbuffer, self.moment
        source = zbuffer.cuts.source(moment.last)
        shown_chips, chips = self.scene_bar.chips.currentIndex(), None
        if shown_chips != PART:
            chips = tuple(zbuffer.cuts.first[source.cut : source.cut + 2].tolist())
        lit = None if moment.noticed is None else moment.of_command(moment.noticed)
        colors = self._colors(zbuffer) if callable(self._colors) else self._colors
        shown = scene(zbuffer, colors, chips=chips, part=shown_chips != CHIPS, lit=lit, background=self.view.background)
        self.view.show_scene(shown, zbuffer.frame)
        cut, tip = moment.tool_tip()
        self.view.show_tool(self.job.cuts[cut].tool, tip)
        operation = self.job.operations[source.cut]
        text = translate("Vk_Simulate", "{} of {}   {}, command {}: {}").format(
            _clock(moment.seconds), _clock(self.clock.total), operation.label, source.command + 1,
            self.code(operation, source.command),
        )  # fmt: skip
        if self._told is not None and lit is not None:
            text += "   " + self._removed(*lit)
        self.play_bar.text.setText(text)
        self.play_bar.text.setToolTip(text)

    def _removed(self, first: int, end: int) -> str:
        volume = float(self.volumes[first:end].sum())
        if volume:
            return translate("Vk_Simulate", "removes {} mm³").format(user().number(volume, 2))
        return translate("Vk_Simulate", "removes nothing")

    def code(self, operation, command: int) -> str:
        """Return the G-code of a command as its operation has it now."""
        try:
            if self._commands[0] != operation.name:  # FreeCAD makes the whole list each time
                obj = FreeCAD.getDocument(operation.document).getObject(operation.name)
                self._commands = operation.name, obj.Path.Commands
            return self._commands[1][command].toGCode()
        except (NameError, AttributeError, IndexError):  # gone, or changed meanwhile
            return ""

    # What the user asks

    def look(self, name: str | None) -> None:
        """Look from one of FreeCAD's standard directions, or as the 3D view does."""
        if name is not None:
            self.view.look(preferences.DIRECTIONS[name])
            return
        view = Gui.getDocument(self.job.operations[0].document).ActiveView
        if hasattr(view, "getCameraOrientation"):
            self.view.look(direction_of(view.getCameraOrientation().Q))

    def point(self, fault: Fault) -> None:
        """Show a fault: the moment at which it was made, or the finished part, with a ring around the place."""
        if fault.of_finished_part or fault.trajectory is None:
            self.moment.go_to(self.clock.total)
        else:
            self.moment.after(fault.trajectory)
        self.view.show_place(fault.place)

    def ask(self, trajectory: int) -> None:
        """Go to when a surface was made, and select the operation that made it."""
        if trajectory < 0:
            self.play_bar.text.setText(translate("Vk_Simulate", "This surface is the raw stock's."))
            return
        self.moment.after(trajectory)
        operation, _ = self.simulation.source(trajectory)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(operation.document, operation.name)
        self.asked.emit()


def _told(error: Exception) -> str:
    """What is told of an error that ended the work."""
    if isinstance(error, Unusable):
        return said(error.what)
    FreeCAD.Console.PrintLog("".join(traceback.format_exception(type(error), error, error.__traceback__)))
    return said(Message("not-analysed", error=f"{type(error).__name__}: {error}"))


def _clock(seconds: float) -> str:
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
