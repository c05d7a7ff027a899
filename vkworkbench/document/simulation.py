# SPDX-License-Identifier: LGPL-2.1-or-later
"""From operations of a document to a simulation of them; reads documents, and writes nothing in them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import FreeCAD
import numpy as np

from vkworkbench import freecad, preferences
from vkworkbench.core import Cut, Solid, View, ZBuffer, linearize, simulate_job, trajectory_seconds
from vkworkbench.core.gcode import looks_like_minutes
from vkworkbench.core.rendering import CUT, colors_of, palette, png, shade
from vkworkbench.core.zbuffer import facts
from vkworkbench.document.operations import Operation, find
from vkworkbench.document.setting import placed, rapid_feeds, read_stock, read_tool, tool_remark, vertical_feed
from vkworkbench.document.solids import model_shapes, model_solid, stock_solid
from vkworkbench.language import Message, Unusable
from vkworkbench.simulation_facts import SimulationFacts


def simulate(
    what=None,
    *,
    view: View | str | None = None,
    memory_budget: float | None = None,
    going_on: Callable[[float], None] | None = None,
) -> Simulation:
    """Simulate operations in the extended z-buffer, one after the other. Writes nothing in a document.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of them, optional
        A document with one job, a job, or some of its operations; the active document if None.
    view : View or str, optional
        The image, or the name of a direction, e.g. ``"Isometric"``; that of the preferences if None.
    memory_budget : float, optional
        Bytes that it may take; those of the preferences if None.
    going_on : callable, optional
        Called many times a second with the share that is done, 0 to 1; what it raises ends the simulation.

    Returns
    -------
    Simulation
        At its last moment.

    Raises
    ------
    Unusable
        Where there is nothing to simulate, or no stock; its message tells what to do.
    OverBudget
        If it would take more memory; nothing was simulated.
    ValueError
        If `what` is None and no document is open, or there is no such direction.
    TypeError
        If `what` is something else.
    """
    return read_job(what).simulate(view, memory_budget=memory_budget, going_on=going_on)


@dataclass(frozen=True)
class SimulatedOperation:
    """An operation that is simulated.

    Attributes
    ----------
    document, name, label : str
        Internal names of the document and of the object, and the object's label.
    rapid_feeds : tuple of float
        Horizontal and vertical rapid speed of its tool controller, mm/s; 0 where unset.
    """

    document: str
    name: str
    label: str
    rapid_feeds: tuple[float, float]


@dataclass(frozen=True, eq=False)
class SimulatedJob:
    """What is to be simulated: copies of what a document says, which another thread may read.

    Attributes
    ----------
    operations : tuple of SimulatedOperation
        In the order of their job.
    cuts : tuple of Cut
        Their toolpaths and tools.
    stock : Solid
    model_shapes : tuple of Shape
        Of what the part is to be.
    remarks : tuple of Message
        What is left out or not simulated exactly, and why.
    """

    operations: tuple[SimulatedOperation, ...]
    cuts: tuple[Cut, ...]
    stock: Solid
    model_shapes: tuple
    remarks: tuple[Message, ...]

    @cached_property
    def model(self) -> Solid | None:
        """What the part is to be; None where the job has no closed model. Made when it is first asked for."""
        return model_solid(self.model_shapes)

    @cached_property
    def seconds(self) -> np.ndarray:
        """Time of every trajectory, numbered through, (n,) float64 s; not a number where its speed is unknown."""
        return np.concatenate([
            trajectory_seconds(cut.toolpath, horizontal_rapid=operation.rapid_feeds[0],
                               vertical_rapid=operation.rapid_feeds[1])
            for operation, cut in zip(self.operations, self.cuts)
        ])  # fmt: skip

    def simulate(
        self,
        view: View | str | None = None,
        *,
        memory_budget: float | None = None,
        going_on: Callable[[float], None] | None = None,
    ) -> Simulation:
        """Simulate it; see :func:`simulate`."""
        chosen = preferences.read()
        if isinstance(view, str):
            if view not in preferences.DIRECTIONS:
                raise ValueError(f"there is no direction {view!r}: choose among {', '.join(preferences.DIRECTIONS)}")
            view = replace(chosen.view, direction=preferences.DIRECTIONS[view])
        zbuffer = simulate_job(
            self.cuts,
            stock=self.stock,
            view=view or chosen.view,
            memory_budget=chosen.memory_budget_bytes if memory_budget is None else memory_budget,
            going_on=going_on,
        )
        return Simulation(self, zbuffer)


@dataclass(frozen=True, eq=False)
class Simulation:
    """A job that was simulated, at one moment.

    Attributes
    ----------
    job : SimulatedJob
    zbuffer : ZBuffer
        Tells depth and owner of every pixel, dexels and traces.
    """

    job: SimulatedJob
    zbuffer: ZBuffer

    @property
    def step(self) -> int:
        """The moment: that many trajectories have been simulated."""
        return self.zbuffer.step

    @property
    def trajectories(self) -> int:
        """How many trajectories there are."""
        return self.zbuffer.trajectories

    def at(self, step: int) -> Simulation:
        """Return it at another moment, after so many trajectories.

        Raises
        ------
        ValueError
            Where there is no such moment.
        """
        return replace(self, zbuffer=self.zbuffer.at(step))

    def image(self) -> np.ndarray:
        """Return the shaded part as it is seen, (height, width, 3) uint8, row 0 at the top."""
        frame, picture = self.zbuffer.frame, self.zbuffer.picture
        size = frame.height, frame.width
        return shade(picture.depth.reshape(size), frame.pixel, colors_of(picture.owner.reshape(size), palette(CUT)))

    def save_png(self, path: str | os.PathLike[str]) -> None:
        """Write the picture to a PNG file.

        Raises
        ------
        OSError
            If the file cannot be written.
        """
        Path(path).write_bytes(png(self.image()))

    def facts(self, *, tolerance: float = 0.1) -> SimulationFacts:
        """Tell what each operation and the job remove, where they cut air, crash, plunge too fast, gouge or leave material.

        Passes closer than a pixel are not told apart; what has walls is best seen from above.

        Parameters
        ----------
        tolerance : float
            Deviations from the job's model up to this, mm, are none.
        """
        labels = [operation.label for operation in self.job.operations]
        found = facts(self.at(self.trajectories).zbuffer, model=self.job.model, tolerance=tolerance)
        return SimulationFacts(tuple(zip(labels, found.cuts)), found.job)

    def source(self, trajectory: int) -> tuple[SimulatedOperation, int]:
        """Return the operation of a trajectory and the index of its command in the operation's Path."""
        source = self.zbuffer.cuts.source(trajectory)
        return self.job.operations[source.cut], source.command


def read_job(what=None) -> SimulatedJob:
    """Read what is to be simulated; see :func:`simulate`."""
    if what is None:
        what = FreeCAD.ActiveDocument
        if what is None:
            raise ValueError("no document is open: open one with a job or a toolpath")
    operations = _chosen(find(what))
    tolerance = preferences.read().tolerance
    simulated, cuts, remarks = [], [], []
    for operation in operations:
        obj = operation.object
        try:
            toolpath = placed(linearize(obj.Path.Commands, tolerance=tolerance), obj.Placement)
            if freecad.is_imported(obj) and looks_like_minutes(toolpath):
                toolpath = replace(toolpath, feed=toolpath.feed / 60)
            if len(toolpath):
                cuts.append(Cut(toolpath, read_tool(obj), vertical_feed(obj)))
                simulated.append(SimulatedOperation(obj.Document.Name, obj.Name, obj.Label, rapid_feeds(obj)))
                told = tool_remark(obj)
                remarks += [Message("of", label=obj.Label, sentence=told)] if told else []
        except Unusable as error:
            remarks.append(Message("of", label=obj.Label, sentence=error.what))
    if not cuts:
        raise Unusable(remarks[0] if remarks else Message("nothing-to-simulate"))
    stock, told = stock_solid(operations[0].job, read_stock(operations[0].job))
    remarks += [told] if told else []
    return SimulatedJob(tuple(simulated), tuple(cuts), stock, model_shapes(operations[0].job), tuple(remarks))


def _chosen(found: list[Operation]) -> list[Operation]:
    """Return the operations that are posted, in the order of their one job."""
    operations = [o for o in found if o.counted] or [o for o in found if o.active]
    jobs = {(o.job.Document.Name, o.job.Name): o.job for o in operations if o.job is not None}
    if len(jobs) > 1:
        raise Unusable(Message("several-jobs", labels=[job.Label for job in jobs.values()]))
    order = [o.object for job in jobs.values() for o in find(job)]
    return sorted(operations, key=lambda o: order.index(o.object) if o.object in order else len(order))
