# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation of a job: the part, the time line, and what made each surface."""

from __future__ import annotations

import time

import FreeCAD
import FreeCADGui as Gui
import numpy as np

from vkworkbench import freecad, preferences
from vkworkbench.core import Strategy
from vkworkbench.core.rendering import direction_of, scene
from vkworkbench.core.zbuffer import Crash
from vkworkbench.document.simulation import SimulatedJob, Simulation
from vkworkbench.gui.plain_text import as_plain, lines
from vkworkbench.gui.qt import (
    QComboBox,
    QEvent,
    QHBoxLayout,
    QLabel,
    QMdiArea,
    QMenu,
    QPushButton,
    QSizePolicy,
    QStyle,
    Qt,
    QTimer,
    QToolButton,
    QVBoxLayout,
    QWidget,
    Signal,
)  # fmt: skip
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.simulation import exports
from vkworkbench.gui.simulation.clock import Clock
from vkworkbench.gui.simulation.coloring import COLORINGS, Job
from vkworkbench.gui.simulation.part_view import PartView
from vkworkbench.gui.simulation.time_line import Block, TimeLine, Warned
from vkworkbench.gui.simulation.worker import Refined, Worker
from vkworkbench.gui.text import QT_TRANSLATE_NOOP, translate

_TICK = 40  # ms between two looks at the work, and two pictures of a play
# How many times as fast as the machine a play is; the whole job in half a minute for None.
_SPEEDS = (1, 10, 100, 1000, None)
_WHOLE = 30.0  # s
_VIEWS = (
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Isometric"), "Isometric"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Top"), "Top"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Front"), "Front"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Right"), "Right"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Rear"), "Rear"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Left"), "Left"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Bottom"), "Bottom"),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "As the 3D view"), None),
)
_PART, _CHIPS, _BOTH = range(3)


class SimulationTab(QWidget):
    """Simulates a job and shows any moment of it.

    Parameters
    ----------
    job : SimulatedJob
    strategies : tuple of Strategy
        Of its operations.

    Attributes
    ----------
    seconds, done : float, int
        The moment: the machine's time, s, and how many trajectories have been cut by then.
    volumes : (n,) float64
        What each trajectory removes, mm^3; zeros until it is known.
    crashes : list of Crash
    outdated : Signal
        The toolpaths have changed, and the user wants them simulated again.
    """

    outdated = Signal()

    def __init__(self, job: SimulatedJob, strategies: tuple[Strategy, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.job, self.strategies, self.clock = job, strategies, Clock(job)
        self.simulation: Simulation | None = None
        self.crashes: list[Crash] = []
        self.seconds, self.done = self.clock.total, len(self.clock.ends) - 1  # the finished part
        self.volumes = np.zeros(len(self.clock.ends) - 1)
        self._worker: Worker | None = None
        self._played: float | None = None  # when the last picture of a play was due
        self._stale = False
        self._cost = ""
        self._commands: tuple[str, list] = ("", [])
        self._first = self.clock.cuts.first
        self.view = PartView(job.stock, preferences.DIRECTIONS["Isometric"])
        self.time_line = TimeLine()
        self._make_controls()
        self._show_blocks()
        self.time_line.show_moment(self.seconds)
        self._show_playing()
        self.view.view_rested.connect(self.simulate)
        self.view.asked.connect(self.ask)
        self.time_line.moved.connect(self.go_to)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(_TICK)
        FreeCAD.addDocumentObserver(self)

    # What is on it

    def _make_controls(self) -> None:
        self.views = self._menu(
            translate("Vk_Simulate", "View"), translate("Vk_Simulate", "From where the part is seen.")
        )
        for text, name in _VIEWS:
            self.views.menu().addAction(user().translate("Vk_Simulate", text)).triggered.connect(
                lambda *_, n=name: self.look(n)
            )
        self.colorings = _combo(translate("Vk_Simulate", "By what the surfaces are colored."))
        for text, _ in COLORINGS:
            self.colorings.addItem(user().translate("Vk_Simulate", text))
        self.chips = _combo(
            translate("Vk_Simulate", "What the operation of this moment removes, alone or on the part.")
        )
        self.chips.addItem(translate("Vk_Simulate", "Part"))
        self.chips.addItem(translate("Vk_Simulate", "Chips"))
        self.chips.addItem(translate("Vk_Simulate", "Part and chips"))
        self.colorings.currentIndexChanged.connect(self._color)
        self.chips.currentIndexChanged.connect(self.draw)
        self.warnings = self._menu("", translate("Vk_Simulate", "Rapid moves that cut material. Choose one to see it."))
        self.warnings.hide()
        self.legend = QLabel()
        self.legend.setTextFormat(Qt.RichText)
        save = self._menu(translate("Vk_Simulate", "Save"), translate("Vk_Simulate", "Save what is shown."))
        for text, work in (
            (translate("Vk_Simulate", "Picture…"), exports.save_picture),
            (translate("Vk_Simulate", "Pictures of the whole job…"), exports.save_frames),
            (translate("Vk_Simulate", "Removal rates…"), exports.save_rates),
        ):
            save.menu().addAction(text).triggered.connect(lambda *_, work=work: work(self))
        self.play_button = QToolButton()
        self.play_button.setToolTip(translate("Vk_Simulate", "Play or pause (Space)."))
        self.play_button.clicked.connect(self.play)
        self.speeds = _combo(translate("Vk_Simulate", "How many times as fast as the machine."))
        for speed in _SPEEDS:
            text = translate("Vk_Simulate", "Job in {}").format(user().time(_WHOLE)) if speed is None else f"×{speed}"
            self.speeds.addItem(text if speed != 1 else translate("Vk_Simulate", "Real time"))
        self.speeds.setCurrentIndex(len(_SPEEDS) - 1)
        steps = (
            (QStyle.SP_MediaSkipBackward, -3, translate("Vk_Simulate", "To the beginning of the operation.")),
            (QStyle.SP_MediaSeekBackward, -2, translate("Vk_Simulate", "Back by one command of the program.")),
            (QStyle.SP_ArrowLeft, -1, translate("Vk_Simulate", "Back by one trajectory.")),
            (QStyle.SP_ArrowRight, 1, translate("Vk_Simulate", "On by one trajectory.")),
            (QStyle.SP_MediaSeekForward, 2, translate("Vk_Simulate", "On by one command of the program.")),
            (QStyle.SP_MediaSkipForward, 3, translate("Vk_Simulate", "To the end of the operation.")),
        )
        self.steps = {}
        for icon, by, tooltip in steps:
            self.steps[by] = button = QToolButton()
            button.setIcon(self.style().standardIcon(icon))
            button.setToolTip(tooltip)
            button.setAutoRepeat(abs(by) < 3)
            button.clicked.connect(lambda *_, by=by: self.step(by))
        self.moment, self.state = as_plain(QLabel()), as_plain(QLabel())
        self.moment.setTextInteractionFlags(Qt.TextSelectableByMouse)
        self.moment.setSizePolicy(QSizePolicy.Ignored, QSizePolicy.Preferred)
        self.again = QPushButton(translate("Vk_Simulate", "The toolpaths have changed. Simulate again"))
        self.again.clicked.connect(lambda *_: self.outdated.emit())
        self.again.hide()
        top = _row(self.views, self.colorings, self.legend, None, self.again, self.warnings, self.chips, save)
        back, on = ([button for by, button in self.steps.items() if by * sign > 0] for sign in (-1, 1))
        below = _row(*back, self.play_button, *on, self.speeds, self.moment)
        below.setStretch(below.count() - 1, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.addLayout(top)
        layout.addWidget(self.view, 1)
        layout.addLayout(below)
        layout.addWidget(self.time_line)
        layout.addWidget(self.state)

    def _menu(self, text: str, tooltip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tooltip)
        button.setPopupMode(QToolButton.InstantPopup)
        button.setMenu(QMenu(button))
        return button

    def _show_blocks(self) -> None:
        begins = self.clock.ends[self._first]
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

    def simulate(self) -> None:
        """Simulate what is looked at, coarsely first."""
        if self._worker is not None:
            self._worker.give_up()
        self._worker = Worker(self.job, self.view.view, preferences.read().memory_budget_bytes)

    def _tick(self) -> None:
        if self._worker is not None:
            done = self._worker.take()
            if done is not None:
                self._take(done)
            elif self._worker.error is not None:
                self.state.setText(said(self._worker.error))
                self._worker = None
            elif self._worker.busy:
                self._say_progress()
        if self._played is not None:
            now = time.perf_counter()
            speed = _SPEEDS[self.speeds.currentIndex()] or self.clock.total / _WHOLE
            self._show_moment(min(self.seconds + speed * (now - self._played), self.clock.total))
            self._played = now if self.seconds < self.clock.total else None
            self._show_playing()
        if self._stale:
            self._draw()

    def _say_progress(self) -> None:
        left, memory = self._worker.left()
        working = translate("Vk_Simulate", "Simulating… {}").format(user().share(self._worker.share))
        if left is not None:
            text = translate("Vk_Simulate", "finest picture in about {}, {}")
            working += ", " + text.format(user().time(left), user().memory(memory))
        self.state.setText(f"{self._cost}   {working}")

    def _take(self, done: Refined) -> None:
        self.simulation = done.simulation
        zbuffer = done.simulation.zbuffer
        self.volumes, self.crashes = done.volumes, done.crashes
        cutting = ~zbuffer.cuts.rapid
        warned = tuple(Warned(self._end_of(crash), self._crash_text(crash)) for crash in done.crashes)
        self.time_line.show_facts(self.clock.ends, done.volumes, cutting, warned)
        self._show_warnings()
        self._cost = translate("Vk_Simulate", "{} × {} pixels of {}, {} traces, {}, simulated in {}").format(
            user().count(zbuffer.frame.width), user().count(zbuffer.frame.height),
            user().measure(zbuffer.frame.pixel, 2), user().count(zbuffer.traces), user().memory(zbuffer.memory_bytes), user().time(done.seconds),
        )  # fmt: skip
        self.state.setText("   ".join([self._cost, *map(said, self.job.remarks)]))
        self._color()

    def _show_warnings(self) -> None:
        menu = self.warnings.menu()
        menu.clear()
        for crash in self.crashes:
            menu.addAction(self._crash_text(crash).replace("&", "&&")).triggered.connect(
                lambda *_, crash=crash: self.go_to(self._end_of(crash), crash.trajectory)
            )
        count = len(self.crashes)
        self.warnings.setText(translate("Vk_Simulate", "⚠ Rapid moves that cut: {}").format(user().count(count)))
        self.warnings.setVisible(count > 0)

    def _end_of(self, crash: Crash) -> float:
        return float(self.clock.ends[crash.trajectory + 1])

    def _crash_text(self, crash: Crash) -> str:
        operation, command = self.job.operations[crash.source.cut], crash.source.command
        text = translate("Vk_Simulate", "{}, command {} ({}): a rapid move removes {} mm³")
        return text.format(operation.label, command + 1, self.code(operation, command), user().number(crash.volume, 2))

    # The moment

    def go_to(self, seconds: float, trajectory: int | None = None) -> None:
        """Show a moment of the machine's time; where several have the same, right after this trajectory."""
        self._played = None
        self._show_playing()
        self._show_moment(seconds, trajectory)

    def show_now(self, seconds: float) -> None:
        """Show a moment at once, without waiting for the next tick."""
        self._show_moment(seconds)
        self._draw()

    def play(self) -> None:
        """Play from here, or from the beginning where it is over; pause a play."""
        if self._played is not None:
            self._played = None
        else:
            if self.seconds >= self.clock.total:
                self.seconds = 0.0
            self._played = time.perf_counter()
        self._show_playing()

    def step(self, by: int) -> None:
        """Step by a trajectory (1), a command (2) or an operation (3), back where negative."""
        done = self.done
        starts = self.starts[abs(by)]
        if by > 0:
            at = np.searchsorted(starts, done, side="right")
            target = int(starts[min(at, len(starts) - 1)])
        else:
            target = int(starts[max(np.searchsorted(starts, done, side="left") - 1, 0)])
        self.go_to(float(self.clock.ends[target]), target - 1)

    @property
    def starts(self) -> dict[int, np.ndarray]:
        """Moments, in trajectories, to which steps go: of trajectories, commands and operations."""
        count = self._first[-1]
        commands = [first + np.flatnonzero(np.diff(cut.toolpath.command, prepend=-1))
                    for first, cut in zip(self._first, self.job.cuts)]  # fmt: skip
        return {1: np.arange(count + 1), 2: np.append(np.concatenate(commands), count), 3: self._first}

    def _show_moment(self, seconds: float, trajectory: int | None = None) -> None:
        self.seconds = seconds
        self.done = self.clock.step(seconds) if trajectory is None else trajectory + 1
        self.time_line.show_moment(seconds)
        self._stale = True

    def _show_playing(self) -> None:
        icon = QStyle.SP_MediaPlay if self._played is None else QStyle.SP_MediaPause
        self.play_button.setIcon(self.style().standardIcon(icon))

    def _color(self, *_) -> None:
        """Colour the surfaces anew: their colours are the same at every moment."""
        if self.simulation is None:
            return
        job = Job(tuple(o.label for o in self.job.operations), self.strategies, self.clock, self.volumes)
        coloring = COLORINGS[self.colorings.currentIndex()][1](self.simulation.zbuffer, job)
        self._palette = coloring.palette
        self.legend.setText(_legend(coloring.legend))
        self.draw()

    def draw(self, *_) -> None:
        """Show the moment anew."""
        self._stale = True

    def _draw(self) -> None:
        self._stale = False
        if self.simulation is None:
            return
        zbuffer = self.simulation.at(self.done).zbuffer
        last = max(self.done - 1, 0)
        number = int(np.searchsorted(self._first, last, side="right")) - 1
        chips = None
        if self.chips.currentIndex() != _PART:
            chips = (int(self._first[number]), int(self._first[number + 1]))
        shown = scene(
            zbuffer, self._palette, chips=chips, part=self.chips.currentIndex() != _CHIPS,
            lit=self._lit(number, last), background=self.view.background,
        )  # fmt: skip
        self.view.show_scene(shown, zbuffer.frame)
        cut, tip = self.clock.tool_tip(self.seconds) if self._played is not None else (number, self._tip(number, last))
        self.view.show_tool(self.job.cuts[cut].tool, tip)
        self._show_source(number, last)

    def _lit(self, number: int, last: int) -> tuple[int, int] | None:
        """The trajectories of the command at this moment; nothing is lit in a play and at the end."""
        if self._played is not None or self.done in (0, len(self.clock.ends) - 1):
            return None
        command = self.job.cuts[number].toolpath.command
        own = last - self._first[number]
        same = np.flatnonzero(command == command[own])
        return int(self._first[number] + same[0]), int(self._first[number] + same[-1]) + 1

    def _tip(self, number: int, last: int) -> np.ndarray:
        points = self.job.cuts[number].toolpath.points
        return points[last - self._first[number] + (1 if self.done else 0)]

    def _show_source(self, number: int, last: int) -> None:
        operation = self.job.operations[number]
        command = int(self.job.cuts[number].toolpath.command[last - self._first[number]])
        text = translate("Vk_Simulate", "{} of {}   {}, command {}: {}").format(
            _clock(self.seconds), _clock(self.clock.total), operation.label, command + 1, self.code(operation, command)
        )
        self.moment.setText(text)
        self.moment.setToolTip(text)

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
            self.moment.setText(translate("Vk_Simulate", "This surface is the raw stock's."))
            return
        self.go_to(float(self.clock.ends[trajectory + 1]), trajectory)
        operation, _ = self.simulation.source(trajectory)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(operation.document, operation.name)
        # FreeCAD 1.1 brings the 3D view to the front for a selection.
        QTimer.singleShot(0, self.come_to_front)

    def come_to_front(self) -> None:
        """Show the tab before the other ones of FreeCAD's window."""
        # Not by the sub-window's mdiArea(): PySide6 then deletes FreeCAD's area together with the sub-window.
        area = Gui.getMainWindow().findChild(QMdiArea)
        area.setActiveSubWindow(self.window_of())

    def event(self, event) -> bool:
        if event.type() == QEvent.ShortcutOverride and event.key() in _KEYS:
            event.accept()  # before FreeCAD takes the key for a command of its own
            return True
        return super().event(event)

    def keyPressEvent(self, event) -> None:
        if event.key() in _KEYS:
            _KEYS[event.key()](self)
        else:
            super().keyPressEvent(event)

    def window_of(self) -> QWidget:
        """Return the tab in FreeCAD's window."""
        return self.parentWidget() or self

    def closeEvent(self, event) -> None:
        self.end()
        super().closeEvent(event)

    def end(self) -> None:
        """Stop all work: the tab is closed."""
        if self._timer.isActive():
            self._timer.stop()
            FreeCAD.removeDocumentObserver(self)
        if self._worker is not None:
            self._worker.give_up()

    # What happens to the document

    def slotChangedObject(self, obj, name: str) -> None:
        if name in freecad.PATH.names and self._is_ours(obj):
            self.again.show()

    def slotDeletedObject(self, obj) -> None:
        if self._is_ours(obj):
            self.again.show()

    def slotDeletedDocument(self, document) -> None:
        if document.Name == self.job.operations[0].document:
            self.end()
            QTimer.singleShot(0, self.window_of().close)

    def _is_ours(self, obj) -> bool:
        return any((o.document, o.name) == (obj.Document.Name, obj.Name) for o in self.job.operations)


def _combo(tooltip: str) -> QComboBox:
    box = QComboBox()
    box.setToolTip(tooltip)
    box.setFocusPolicy(Qt.StrongFocus)
    return box


def _row(*widgets: QWidget | None) -> QHBoxLayout:
    row = QHBoxLayout()
    for widget in widgets:
        if widget is None:
            row.addStretch(1)
        else:
            row.addWidget(widget)
    return row


def _legend(entries: tuple[tuple[str, str], ...]) -> str:
    scale = sum(not name for _, name in entries) > 1
    shown = entries if scale else entries[:8]
    parts = [f"<span style='color:{color}'>■</span>{lines(' ' + name) if name else ''}" for color, name in shown]
    return ("" if scale else "&nbsp; ").join(parts)


def _clock(seconds: float) -> str:
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"


_KEYS = {
    int(Qt.Key_Escape): lambda tab: tab.window_of().close(),
    int(Qt.Key_Space): SimulationTab.play,
    int(Qt.Key_Comma): lambda tab: tab.step(-1),
    int(Qt.Key_Period): lambda tab: tab.step(1),
}
