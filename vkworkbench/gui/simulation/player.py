# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that is simulated: the part, the time line, and what made each surface."""

from __future__ import annotations

import traceback

import FreeCAD
import FreeCADGui as Gui
import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.rendering import direction_of, scene
from vkworkbench.core.zbuffer import Crash
from vkworkbench.document.simulated_job import SimulatedJob
from vkworkbench.document.simulation import Simulation
from vkworkbench.gui.background import Background
from vkworkbench.gui.plain_text import as_plain
from vkworkbench.gui.qt import QLabel, QTimer, QVBoxLayout, QWidget, Signal
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.coloring import COLORINGS, Coloring, Job
from vkworkbench.gui.simulation.controls import CHIPS, PART, PlayBar, SceneBar
from vkworkbench.gui.simulation.moment import Moment
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.refining import Refined, Refining
from vkworkbench.gui.simulation.time_line import Block, TimeLine, Warned
from vkworkbench.gui.text import translate
from vkworkbench.language import Message, Unusable

_TICK = 40  # ms between two looks at the work, and two pictures of a play


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
    crashes : list of Crash
    asked : Signal
        The user asked the part; the operation that made the place is selected.
    """

    asked = Signal()

    def __init__(self, job: SimulatedJob, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.job, self.clock = job, Clock(job)
        self.strategies = (Strategy.UNKNOWN,) * len(job.operations)
        self.simulation: Simulation | None = None
        self.crashes: list[Crash] = []
        self.volumes = np.zeros(len(self.clock.cuts))
        self.moment = Moment(self.clock, self)
        self.view = PartView(job.stock, preferences.DIRECTIONS["Isometric"])
        self.time_line = TimeLine()
        self.scene_bar, self.play_bar = SceneBar(), PlayBar()
        self.state = as_plain(QLabel())
        self._refining: Refining | None = None
        self._work, self._recognizing = Background(self), Background(self)
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
        self.moment.changed.connect(self._show_moment)
        self.time_line.moved.connect(self.moment.go_to)
        self.play_bar.stepped.connect(self.moment.step)
        self.play_bar.play_clicked.connect(self.moment.play)
        self.scene_bar.looked.connect(self.look)
        self.scene_bar.recolored.connect(self._color)
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
        self._refining = Refining(self.job, self.view.view, preferences.read().memory_budget_bytes)
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
        self.state.setText("   ".join(filter(None, (self._cost, *texts))))

    def _ended(self, error: Exception | None) -> None:
        self._say(*map(said, self.job.remarks), *([_told(error)] if error else []))

    def _take(self, done: Refined) -> None:
        first = self.simulation is None
        self.simulation = done.simulation
        zbuffer = done.simulation.zbuffer
        self.volumes, self.crashes = done.volumes, done.crashes
        warned = tuple(Warned(self._end_of(crash), self._crash_text(crash)) for crash in done.crashes)
        self.time_line.show_facts(self.clock.ends, done.volumes, done.air, warned)
        self._show_warnings()
        self._cost = translate("Vk_Simulate", "{} × {} pixels of {}, {} traces, {}, simulated in {}").format(
            user().count(zbuffer.frame.width), user().count(zbuffer.frame.height),
            user().measure(zbuffer.frame.pixel, 2), user().count(zbuffer.traces), user().memory(zbuffer.memory_bytes), user().time(done.seconds),
        )  # fmt: skip
        self._color()
        if first:  # the part comes before the strategies
            found: list[Strategy] = []
            self._recognizing.start(
                "", lambda _: self.job.strategies(), found.append, lambda error: self._recognized(found, error)
            )

    def _recognized(self, found: list[Strategy], error: Exception | None) -> None:
        if error is None:
            self.strategies = tuple(found)
            self._show_blocks()
            self._color()
        else:
            self._say(_told(error))

    def _show_warnings(self) -> None:
        button = self.scene_bar.warnings
        menu = button.menu()
        menu.clear()
        for crash in self.crashes:
            menu.addAction(self._crash_text(crash).replace("&", "&&")).triggered.connect(
                lambda *_, crash=crash: self.moment.after(crash.trajectory)
            )
        count = len(self.crashes)
        button.setText(translate("Vk_Simulate", "⚠ Rapid moves that cut: {}").format(user().count(count)))
        button.setVisible(count > 0)

    def _end_of(self, crash: Crash) -> float:
        return float(self.clock.ends[crash.trajectory + 1])

    def _crash_text(self, crash: Crash) -> str:
        operation, command = self.job.operations[crash.source.cut], crash.source.command
        text = translate("Vk_Simulate", "{}, command {} ({}): a rapid move removes {} mm³")
        return text.format(operation.label, command + 1, self.code(operation, command), user().number(crash.volume, 2))

    # Showing

    def show_now(self, seconds: float) -> None:
        """Show a moment at once, without waiting for the next tick."""
        self.moment.go_to(seconds)
        self._draw()

    def draw(self) -> None:
        """Show the moment anew."""
        self._stale = True

    def _show_moment(self) -> None:
        self.time_line.show_moment(self.moment.seconds)
        self.play_bar.show_playing(self.moment.plays)
        self.draw()

    def _color(self) -> None:
        """Colour the surfaces anew: their colours are the same at every moment."""
        if self.simulation is None:
            return
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, self.volumes)
        coloring: Coloring = COLORINGS[self.scene_bar.colorings.currentIndex()][1](self.simulation.zbuffer, job)
        self._palette = coloring.palette
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
        shown = scene(
            zbuffer, self._palette, chips=chips, part=shown_chips != CHIPS, lit=lit, background=self.view.background
        )
        self.view.show_scene(shown, zbuffer.frame)
        cut, tip = moment.tool_tip()
        self.view.show_tool(self.job.cuts[cut].tool, tip)
        operation = self.job.operations[source.cut]
        text = translate("Vk_Simulate", "{} of {}   {}, command {}: {}").format(
            _clock(moment.seconds), _clock(self.clock.total), operation.label, source.command + 1,
            self.code(operation, source.command),
        )  # fmt: skip
        self.play_bar.text.setText(text)
        self.play_bar.text.setToolTip(text)

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
