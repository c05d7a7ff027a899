# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player of a simulated job: the image of the part, the time line, and the controls."""

from __future__ import annotations

from functools import partial

import FreeCADGui as Gui
import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Frame, Strategy
from vkworkbench.core.rendering import CUT_OPEN, Scene, direction_of
from vkworkbench.core.zbuffer import Source
from vkworkbench.document.computer.calibration import known_speed
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation
from vkworkbench.gui.qt.background import Background
from vkworkbench.gui.qt.names import QEvent, QTimer, QVBoxLayout, QWidget, Signal, single_shot
from vkworkbench.gui.qt.plain_text import shortened
from vkworkbench.gui.qt.sentences import sentence, strategy_name, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.controls import GAP, PlayBar, SceneBar
from vkworkbench.gui.simulation.faults import Fault, Judgement, KnownFaults, judge
from vkworkbench.gui.simulation.measuring import Measuring
from vkworkbench.gui.simulation.moment import Clock, Moment
from vkworkbench.gui.simulation.part_view import PartView, Surface
from vkworkbench.gui.simulation.pictures import Drawing, Pictures
from vkworkbench.gui.simulation.simulating import Findings, Simulated, Simulating, detail_view, simulate_detail
from vkworkbench.gui.simulation.time_line import Block, TimeLine
from vkworkbench.gui.simulation.widgets import StateLine

_PART = 120  # minimum height of the part's image, px; optional rows are hidden if the image would be lower
_CLOSER = 400  # ms without a change of the view after which the visible part of the stock is simulated more finely
_TICK = 20  # ms between two updates


class Player(QWidget):
    """Simulates a job and shows any moment of it; at the beginning, the scene `first` from reading the job."""

    # The user clicked on the part or chose a fault, and the operation that cut there is selected in the tree.
    asked = Signal()

    def __init__(
        self, job: SimulatedJob, first: tuple[Scene, Frame] | None = None, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.job, self.clock = job, Clock(job)
        self.faults: list[Fault] = []  # the faults at the tolerance that the user has chosen
        self.moment = Moment(self.clock, self)
        self.view = PartView(job.stock, preferences.DIRECTIONS["Isometric"])
        if first is not None:
            self.view.show_scene(*first)
        self.time_line = TimeLine()
        self.scene_bar, self.play_bar, self.state = SceneBar(), PlayBar(), StateLine()
        self.drawing = Drawing(job, self.clock, self.scene_bar)
        self.known = KnownFaults(job, self.clock)
        self.measuring = Measuring(float(job.stock.upper[2]))
        self._asked: Surface | None = None
        self._compared = False  # whether the largest differences from the model are listed
        self._worst: Fault | None = None  # the difference from the model that the text and the ring show
        self._simulating: Simulating | None = None
        self._begin = single_shot(self.simulate, self)
        self._work, self._recognizing, self._judging = Background(self), Background(self), Background(self)
        self._detailing, self._look_closer = Background(self), single_shot(self._simulate_detail, self, _CLOSER)
        self.pictures = Pictures(self.drawing, self.moment, self.view, self)
        self._lay_out()
        self._connect()
        self._show_blocks()
        self._show_moment()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(_TICK)

    @property
    def simulation(self) -> Simulation | None:
        """The finest simulation until now."""
        return self.drawing.simulation

    @property
    def volumes(self) -> np.ndarray:
        """Removed volume of each trajectory, (n,) float64 mm^3; zeros until the volumes are known."""
        removal = self.drawing.removal
        return np.zeros(len(self.clock.cuts)) if removal is None else removal.volumes

    def _lay_out(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GAP)
        layout.addWidget(self.scene_bar)
        layout.addWidget(self.view, 1)
        for widget in (self.play_bar, self.time_line, self.state):
            layout.addWidget(widget)

    def event(self, event) -> bool:
        if event.type() in (QEvent.Resize, QEvent.LayoutRequest):
            self._make_room()
        return super().event(event)

    def _make_room(self) -> None:
        """Show as many optional rows of controls as fit, most important first. FreeCAD's tabs ignore minimum heights."""
        always = (self.scene_bar.controls, self.play_bar.controls, self.time_line)
        left = self.height() - _PART - sum(widget.sizeHint().height() + GAP for widget in always)
        bar = self.scene_bar
        unwanted = {bar.differences: not bar.compares, bar.section: bar.section.axis is None}
        for widget in (self.play_bar.text, bar.section, bar.differences, bar.legend, self.state):
            needed = widget.sizeHint().height() + GAP
            wanted = not unwanted.get(widget, False)
            widget.setVisible(wanted and needed <= left)
            left -= needed if wanted and needed <= left else 0

    def _connect(self) -> None:
        self.view.changed.connect(self.pictures.draw)
        self.view.changed.connect(self._look_closer.start)
        self.view.resized.connect(self._sized)
        self.view.asked.connect(self.ask)
        self.view.restyled.connect(self.pictures.draw)
        self.pictures.begun.connect(self._show_text)
        self.pictures.failed.connect(self.state.show_error)
        self.moment.changed.connect(self._show_moment)
        self.time_line.moved.connect(self.moment.go_to)
        self.time_line.clicked.connect(self.moment.choose)
        self.play_bar.stepped.connect(self.moment.step)
        self.play_bar.play_clicked.connect(self.moment.play)
        self.scene_bar.looked.connect(self.look)
        self.scene_bar.recolored.connect(self._recolor)
        self.scene_bar.hinted.connect(lambda fault: self.view.show_place(fault.place))
        self.scene_bar.pointed.connect(self.point)
        self.scene_bar.chosen.connect(self.pictures.draw)
        self.scene_bar.saved.connect(lambda save: save(self))
        self.scene_bar.section.changed.connect(self._move_section)
        self.scene_bar.measure.toggled.connect(lambda *_: self._measure())

    def _show_blocks(self) -> None:
        begins = self.clock.ends[self.clock.cuts.first]
        blocks = []
        for number, (operation, strategy) in enumerate(zip(self.job.operations, self.drawing.strategies)):
            begin, end = float(begins[number]), float(begins[number + 1])
            tooltip = f"{operation.label}\n{strategy_name(strategy)}, {self._about(user().clock(end - begin))}"
            blocks.append(Block(operation.label, tooltip, strategy.color, begin, end))
        self.time_line.show_job(tuple(blocks), self.clock.total)

    def _about(self, time: str) -> str:
        """Return a machining time as text, with "about" if the speeds of some moves are unknown."""
        return time if self.clock.complete else translate("Vk_Simulate", "about {}").format(time)

    # Simulating

    @property
    def is_busy(self) -> bool:
        """Whether simulations, strategies or faults are still being computed."""
        return self.refines or self._recognizing.works or self._judging.works

    @property
    def refines(self) -> bool:
        """Whether a finer simulation is being computed, or will start soon."""
        return self._work.works or self._begin.isActive()

    def _sized(self) -> None:
        """Simulate when the image of the part has its first size.

        If the image changes its size later, no new simulation is needed.
        """
        if self._simulating is None:
            self._begin.start()

    def simulate(self) -> None:
        """Simulate the job: first coarsely, then with as many rays as the image has pixels."""
        chosen, view = preferences.read(), self.view.view
        rays, memory = view.width * view.height, chosen.memory_budget_bytes
        self._simulating = Simulating(self.job, rays, memory, chosen.time_budget, known_speed())
        self._work.start("", self._simulating, self._take, self._ended)

    def end(self) -> None:
        """Stop all work and release large data. Qt and Python can keep a closed tab in memory until FreeCAD ends."""
        self._timer.stop()
        self._work.give_up()
        self._recognizing.give_up()
        self._judging.give_up()
        self._detailing.give_up()
        self._look_closer.stop()
        self.pictures.end()
        self._begin.stop()
        self._simulating = None
        self.drawing.clear()

    def _simulate_detail(self) -> None:
        """Simulate the visible part of the stock more finely, if the user has zoomed in."""
        self._detailing.give_up()
        done = self.drawing.simulated
        if self.refines or done is None:
            return
        shown = self.drawing.finest_for(self.view.frame).zbuffer
        view = detail_view(self.view.frame, self.job, shown.frame.pixel)
        if view is not None:
            memory = preferences.read().memory_budget_bytes - done.simulation.zbuffer.peak.bytes()
            work = partial(simulate_detail, self.job, view, memory)
            self._detailing.start("", work, self._take_detail, self._show_error)

    def _take_detail(self, done: Simulation) -> None:
        self.drawing.detail = done
        self.pictures.draw()

    def _tick(self) -> None:
        if self._work.works:
            self.state.show_progress(self._simulating)
        self.moment.go_on(self.play_bar.speed(self.clock.total))
        self.pictures.begin()

    def _ended(self, error: Exception | None) -> None:
        for action in self.scene_bar.results:
            action.setEnabled(self.drawing.findings is not None)
        self.state.show_end(self.job.remarks, error)

    def _take(self, done: Simulated | Findings) -> None:
        if self.simulation is None:  # recognise the strategies only once, after the first simulation
            self._recognize()
        self.drawing.take(done)
        if isinstance(done, Simulated):
            self.state.show_simulated(done)
            self._show_removal()
        else:
            self.state.show_verdict(done.facts.verdict.message([operation.label for operation in self.job.operations]))
            self._judge()
        self._color()

    def _recognize(self) -> None:
        found: list[Strategy] = []
        self._recognizing.start(
            "", lambda _: self.job.strategies(), found.append, lambda error: self._recognized(found, error)
        )

    def _recognized(self, found: list[Strategy], error: Exception | None) -> None:
        if error is None:
            self.drawing.strategies = tuple(found)
            self._show_blocks()
            self._color()
        else:
            self.state.show_error(error)

    def _judge(self) -> None:
        """List the faults and, if requested, the largest differences from the model, at the chosen tolerance."""
        findings = self.drawing.findings
        if findings is not None:
            work = partial(judge, findings, self.scene_bar.tolerance_mm, self.scene_bar.compares)
            self._judging.start("", lambda _: [work()], self._list, self._show_error)

    def _list(self, judged: Judgement) -> None:
        self.faults = judged.faults
        self.scene_bar.list_warnings(self.faults, self.known.text)
        if judged.differences is not None:
            self.scene_bar.list_worst(judged.differences, self.known.text_with_place)
            if not self._compared and self.moment.seconds >= self.clock.total:
                self._show_worst(judged.differences)
        self._compared = judged.differences is not None
        self._show_removal()
        self.known.keep(judged.proved, self.drawing.findings.facts.verdict)

    def _show_worst(self, differences: list[Fault]) -> None:
        """Show the largest difference from the model: a ring at its place, and its text."""
        if differences:
            self._worst = max(differences, key=lambda fault: fault.what.arguments["depth"])
            self.view.show_place(self._worst.place)
            self._show_text()

    def _show_removal(self) -> None:
        removal = self.drawing.removal
        self.time_line.show_facts(self.clock.ends, removal.volumes, removal.air, self.known.marks(self.faults))

    def _show_error(self, error: Exception | None) -> None:
        if error is not None:
            self.state.show_error(error)

    # Showing

    def _show_moment(self) -> None:
        self._asked = self._worst = None
        self.view.show_place(None)
        self.time_line.show_moment(self.moment.seconds)
        self.play_bar.show_playing(self.moment.plays)
        self.pictures.draw()

    def _recolor(self) -> None:
        """Apply the chosen colouring and tolerance."""
        if self._worst is not None:
            self._worst = None
            self.view.show_place(None)
        self._make_room()
        self._judge()
        self._color()

    def _color(self) -> None:
        self.drawing.color()
        self.pictures.draw()

    def _show_text(self) -> None:
        measures = self.scene_bar.measure.isChecked()
        text = self.measuring.text() if measures else self._moment_text()
        self.play_bar.text.show_text(text if self._worst is None else self.known.text_with_place(self._worst))

    def _moment_text(self) -> str:
        """Return the shown time, the command at this time and the volume that it removes, as text."""
        moment, source = self.moment, self.clock.cuts.source(self.moment.last)
        text = translate("Vk_Simulate", "{} of {}   {}, command {}: {}").format(
            self._about(user().clock(moment.seconds)), user().clock(self.clock.total),
            shortened(self.job.operations[source.cut].label),
            source.command + 1, self.job.listings[source.cut][source.command],
        )  # fmt: skip
        if self.drawing.removal is None or moment.noticed is None:
            return text
        text += f"   {self._effect(source, *moment.of_command(moment.noticed))}"
        if self._asked is None:
            return text
        # The text begins with the depth, because the end of the text is cut off if the line is narrow.
        return f"{self.measuring.depth(self._asked.place)}   {text}"

    def _effect(self, source: Source, first: int, end: int) -> str:
        """Return the fault of a command, or the volume that it removes, as text.

        The volume that a rapid move removes is a part of its fault, and is computed more exactly than other volumes.
        """
        for fault in self.faults:
            if fault.trajectory is not None and (fault.cut, fault.command) == (source.cut, source.command):
                return sentence(fault.what)
        volume = float(self.volumes[first:end].sum())
        removed = translate("Vk_Simulate", "Removed: {}").format(user().volume(volume, 2))
        return removed if volume else translate("Vk_Simulate", "Nothing removed")

    # The following methods respond to requests of the user.

    def look(self, name: str | None) -> None:
        """Show the part from a standard direction of FreeCAD; if `name` is None, as in the 3D view."""
        if name is not None:
            self.view.look(preferences.DIRECTIONS[name])
            return
        view = Gui.getDocument(self.job.operations[0].document).ActiveView
        if hasattr(view, "getCameraOrientation"):
            self.view.look(direction_of(view.getCameraOrientation().Q))

    def point(self, fault: Fault) -> None:
        """Show the part just after a fault has happened, with a ring around the fault.

        Show the finished part if the fault is leftover material or missing stock.
        """
        if fault.of_finished_part or fault.trajectory is None:
            self.moment.go_to(self.clock.total)
        else:
            self.moment.after(fault.trajectory)
        self.view.show_place(fault.place)
        if fault.cut is not None:
            self._select(fault.cut)

    def ask(self, surface: Surface) -> None:
        """Respond to a click on a surface.

        If the user is measuring, measure the point of the surface. If the user is not measuring, go to the moment at
        which the surface was made, and select the operation that made it.
        """
        if self.simulation is None:  # the image is still the preview from reading the job
            return
        if self.scene_bar.measure.isChecked():
            self._measure(surface.place)
        elif surface.owner < 0:
            depth = self.measuring.depth(surface.place)
            section = translate("Vk_Simulate", "This is the section.")
            text = section if surface.owner == CUT_OPEN else translate("Vk_Simulate", "This is uncut stock.")
            self.play_bar.text.show_text(f"{text}   {depth}")
        else:
            self.moment.after(surface.owner)
            self._asked = surface
            self._select(self.clock.cuts.source(surface.owner).cut)

    def _measure(self, point: np.ndarray | None = None) -> None:
        """Measure a point; without a point, remove the measured points."""
        self.measuring.points = () if point is None else self.measuring.points
        if point is not None:
            self.measuring.add(point)
        self.view.show_measured(self.measuring.points)
        self._show_text()

    def end_measuring(self) -> bool:
        """End the measuring mode, and return whether it was active."""
        measures = self.scene_bar.measure.isChecked()
        self.scene_bar.measure.setChecked(False)
        return measures

    def _move_section(self) -> None:
        """Show the section at the position of its slider."""
        section, stock = self.scene_bar.section, self.job.stock
        if section.axis is not None:
            low, high = stock.lower[section.axis], stock.upper[section.axis]
            section.show_place(float(low + section.share * (high - low)))
        self._make_room()
        self.pictures.draw()

    def _select(self, cut: int) -> None:
        """Select an operation in the tree."""
        operation = self.job.operations[cut]
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(operation.document, operation.name)
        self.asked.emit()
