# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learns from the simulations that the user runs how long FreeCAD's simulators take on this computer.

It watches the simulators' own widgets and windows and slows nothing down: during a run it only notes times, and it
computes afterwards.
"""

from __future__ import annotations

import time
from contextlib import suppress

import numpy as np

from vkworkbench import freecad
from vkworkbench.core import linearize
from vkworkbench.core.simulators import (
    SLIDER,
    Seen,
    Task,
    legacy_costs,
    legacy_together,
    opengl_cost,
    opengl_speeds,
    opengl_together,
)
from vkworkbench.document.computer import calibration
from vkworkbench.document.job.setting import read_stock, read_tool
from vkworkbench.gui.qt.names import (
    QEvent,
    QObject,
    QProgressBar,
    QSlider,
    QToolButton,
    single_shot,
)  # fmt: skip
from vkworkbench.gui.qt.renderer import note_renderer
from vkworkbench.gui.simulators.panels import chosen_in, panels, simulator_of

# Nothing is learned from longer operations and plays: the seconds of computing would be felt.
_MOST_COMMANDS = 50_000
_MOST_FRAMES = 2000
# The last frames of a play. Their time has to be more than twice that of the finished picture.
_LAST_FRAMES = 5
# Frames played as a share of those of a whole play; outside, the play was paused, or began before it was watched.
_FEWEST, _MOST = 0.9, 1.2


def watch_legacy(panel) -> None:
    """Learn from a panel of the legacy simulator, as long as it is open."""
    LegacyRuns(panel)


def watch_opengl(window) -> None:
    """Learn from the OpenGL simulator's window."""
    if window.findChild(OpenGLRun) is None:
        OpenGLRun(window)


class LegacyRuns(QObject):
    """The runs of one legacy simulator's panel, each from the press of a button until all buttons are enabled again.

    The panel is its parent and not kept beside, see `widgets`.
    """

    def __init__(self, panel) -> None:
        super().__init__(panel)
        self._begin = None
        # FreeCAD has yet to make and to show the last mesh. Timers of the panel's own: it may be closed meanwhile.
        self._shown = single_shot(self._ended, self)
        self._enabled = single_shot(lambda: self._shown.start(0), self)
        fast_forward = panel.findChild(QToolButton, "toolButtonFF")
        fast_forward.pressed.connect(lambda: self._pressed("fast-forward"))
        panel.findChild(QToolButton, "toolButtonPlay").pressed.connect(lambda: self._pressed("play"))
        fast_forward.installEventFilter(self)

    def _pressed(self, kind: str) -> None:
        whole = self._done() in (0, 100)  # not the rest of one that was paused
        self._begin = (_now(), kind, self._sliders()) if whole else None

    def eventFilter(self, button, event) -> bool:
        if event.type() == QEvent.EnabledChange and button.isEnabled() and self._begin and self._done() == 100:
            self._enabled.start()
        return False

    def _ended(self) -> None:
        (begin, kind, sliders), self._begin = self._begin, None
        seen = Seen(*(_now() - begin).tolist())
        if sliders != self._sliders():
            return
        position, speed = sliders
        renderer = note_renderer()
        with suppress(OSError, ValueError):  # the file cannot be written, or an arc has too many chords
            costs = [
                legacy_costs(Task(linearize(path.Commands), tool, stock), accuracies=(SLIDER[position - 1],),
                             speed=speed, constants=calibration.constants(renderer))[0]
                for path, tool, stock in _simulated(self.parent())
            ]  # fmt: skip
            if costs:
                calibration.learn(kind, legacy_together(costs), seen, renderer=renderer)

    def _done(self) -> int:
        """Percent of the run."""
        return self.parent().findChild(QProgressBar, "progressBar").value()

    def _sliders(self) -> tuple[int, int]:
        return tuple(self.parent().findChild(QSlider, name).value() for name in ("sliderAccuracy", "sliderSpeed"))


class OpenGLRun(QObject):
    """One window of the OpenGL simulator: when it draws, from the last click (that on "play") until it is closed."""

    def __init__(self, window) -> None:
        super().__init__(window)
        self._simulated = [], 10
        for panel in panels():
            if simulator_of(panel) == "OpenGL":
                quality = panel.findChild(QSlider, "sliderAccuracy").value()
                self._simulated = _simulated(panel), quality
        self._times: list[np.ndarray] = []
        window.installEventFilter(self)

    def eventFilter(self, window, event) -> bool:
        if event.type() == QEvent.UpdateRequest:
            self._times.append(_now())
        elif event.type() == QEvent.MouseButtonPress:
            self._times.clear()
        elif event.type() == QEvent.Close:
            self._closed()
        return False

    def _closed(self) -> None:
        (simulated, quality), times, self._times = self._simulated, self._times, []
        frames, worked = np.diff(np.reshape(times, (-1, 2)), axis=0).T
        played = _played(frames) if simulated else 0
        if not played:
            return
        renderer = note_renderer()
        speeds = opengl_speeds(freecad.version())
        with suppress(OSError, ValueError):  # the file cannot be written, or an arc has too many chords
            cost = opengl_together([
                opengl_cost(Task(linearize(path.Commands), tool, stock), speeds=speeds, quality=quality,
                            constants=calibration.constants(renderer))
                for path, tool, stock in simulated
            ])  # fmt: skip
            whole = [speed for speed in speeds if _FEWEST < played * speed / cost.steps < _MOST]
            if whole:
                last = float(np.median(frames[played - _LAST_FRAMES : played]))
                seen = Seen(float(frames[:played].sum()), float(worked[:played].sum()), last, whole[0])
                calibration.learn("draw", cost, seen, renderer=renderer)


def _now() -> np.ndarray:
    """The time, and what this process used of the processors until now, s."""
    return np.array([time.perf_counter(), time.process_time()])


def _played(frames: np.ndarray) -> int:
    """Return the number of frames until all was drawn, 0 if that did not happen.

    A frame takes longer the more it draws, and after the last motion all frames take the same time: the end is where
    two such lines fit best. They are fitted with medians, because other programs make frames slow for a while.
    """
    if not 2 * _LAST_FRAMES <= len(frames) <= _MOST_FRAMES:
        return 0
    count = np.arange(1, len(frames) + 1)

    def misfit(end: int) -> float:
        finished = np.median(frames[end:])
        growth = np.median((frames[:end] - finished) / count[:end])
        return abs(frames - finished - np.where(count <= end, growth * count, 0)).sum()

    end = min(range(_LAST_FRAMES, len(frames) - _LAST_FRAMES + 1), key=misfit)
    return end if np.median(frames[end - _LAST_FRAMES : end]) > 2 * np.median(frames[end:]) else 0


def _simulated(panel) -> list:
    """Path, tool and stock of the operations that are ticked in a simulator's panel; none where that is not known."""
    job, ticked = chosen_in(panel)
    if sum(obj.Path.Size for obj in ticked) > _MOST_COMMANDS:
        return []
    try:
        stock = read_stock(job)
        return [(obj.Path, read_tool(obj), stock) for obj in ticked]
    except ValueError:  # the simulator says what is wrong
        return []
