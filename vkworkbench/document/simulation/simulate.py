# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate operations of a document. Writes nothing in the document."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Solid, View, ZBuffer, simulate_job
from vkworkbench.core.rendering import CUT, colors_of, palette, png, shade
from vkworkbench.core.zbuffer import TOLERANCE, OverBudget, trajectory_table
from vkworkbench.document.simulation.along_axis import OnceAlongAxis
from vkworkbench.document.simulation.copy import read_job
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.given import check_file_name, of_kind
from vkworkbench.language import Message
from vkworkbench.report import SimulationFacts, how_many

# Minimum size of an image, as a share of the requested size. A smaller image shows too little.
MIN_SIZE = 1 / 3


def simulate(
    what=None,
    *,
    view: View | str | None = None,
    clamps: Iterable | None = None,
    memory_budget: float | None = None,
    going_on: Callable[[float], None] = lambda _: None,
) -> Simulation:
    """Simulate operations in the extended z-buffer, one after the other. Writes nothing in a document.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of these objects, optional
        A document with one job, a job, or some of its operations; the active document if None.
    view : View or str, optional
        The image, or the name of a direction, e.g. ``"Isometric"``. None stands for the direction in the preferences. Without a
        View, the image is made coarser if it would need too much memory, and a remark of the job says so.
    clamps : iterable of DocumentObject, optional
        Objects that no tool may touch, such as clamps and vices. None stands for the clamps of the job, see `set_clamps`.
    memory_budget : float, optional
        Largest memory, bytes. None stands for the budget in the preferences.
    going_on : callable, optional
        Called many times a second with the completed share, 0 to 1. An exception from it ends the simulation.

    Returns
    -------
    Simulation
        The simulation at its last moment.

    Raises
    ------
    Unusable
        If there is nothing to simulate, no stock, or a clamp without a solid. The message says what to do.
    OverBudget
        If the simulation would need more memory. Nothing was simulated; the message names an image that fits.
    ValueError
        If `what` is None and no document is open, if the direction is unknown, or if the budget is not a number of bytes.
    ReferenceError
        If an object was deleted, or a document closed.
    TypeError
        If an argument has another type.
    """
    job, chosen = read_job(what, clamps), preferences.read()
    budget = chosen.memory_budget_bytes if memory_budget is None else memory_budget
    of_kind("view", view, (View, str, type(None)), "a View or the name of a direction")
    if isinstance(view, View):
        return simulate_read(job, view, budget, going_on)
    wanted = chosen.view
    if view is not None:
        if view not in preferences.DIRECTIONS:
            raise ValueError(f"there is no direction {view!r}: choose among {', '.join(preferences.DIRECTIONS)}")
        wanted = replace(wanted, direction=preferences.DIRECTIONS[view])
    image, remarks = wanted, job.remarks
    while True:
        try:
            return simulate_read(replace(job, remarks=remarks), image, budget, going_on)
        except OverBudget as refused:
            image = coarser(wanted, refused)
            remarks = (*job.remarks, _coarser_image(image, job.stock))


def _coarser_image(image: View, stock: Solid) -> Message:
    pixel, limit = image.frame(stock).pixel, Message("limit-memory")
    return Message("image", width=image.width, height=image.height, pixel=pixel, limit=limit, passes=None)


def coarser(view: View, refused: OverBudget) -> View:
    """Return the finest image of a view that fits in memory.

    Raises
    ------
    OverBudget
        The given error, if the image would be smaller than `MIN_SIZE`.
    """
    if refused.size is None or refused.size[0] < MIN_SIZE * view.width:
        raise refused
    return view.of_size(*refused.size)


def simulate_read(
    job: SimulatedJob, view: View, memory_budget: float, going_on: Callable[[float], None] = lambda _: None
) -> Simulation:
    """Simulate a job that was read; see :func:`simulate`. Runs in any thread, because it uses nothing of FreeCAD."""
    zbuffer = simulate_job(job.cuts, stock=job.stock, view=view, memory_budget=memory_budget, going_on=going_on)
    return Simulation(job, zbuffer, OnceAlongAxis(job, memory_budget))


@dataclass(frozen=True, eq=False)
class Simulation:
    """A simulated job at one moment.

    Attributes
    ----------
    job : SimulatedJob
    zbuffer : ZBuffer
        Depth and owner of every pixel, dexels and traces.
    along_axis : OnceAlongAxis
        The simulation along the tool axis, from which the facts come.
    """

    job: SimulatedJob
    zbuffer: ZBuffer
    along_axis: OnceAlongAxis

    def __repr__(self) -> str:
        return f"<Simulation of {how_many(len(self.job.operations), 'operation')}, {self.step} of {self.trajectories} trajectories>"

    @property
    def step(self) -> int:
        """Number of trajectories that have been simulated at this moment."""
        return self.zbuffer.step

    @property
    def trajectories(self) -> int:
        """Number of all trajectories."""
        return self.zbuffer.trajectories

    def at(self, step: int) -> Simulation:
        """Return the simulation at another moment, after `step` trajectories.

        Raises
        ------
        ValueError
            If `step` is negative or larger than the number of trajectories.
        TypeError
            If `step` is not an integer.
        """
        return replace(self, zbuffer=self.zbuffer.at(step))

    def image(self) -> np.ndarray:
        """Return the shaded image of the part, (height, width, 3) uint8, row 0 at the top."""
        frame, picture = self.zbuffer.frame, self.zbuffer.picture
        size = frame.height, frame.width
        return shade(picture.depth.reshape(size), frame.pixel, colors_of(picture.owner.reshape(size), palette(CUT)))

    def save_png(self, path: str | os.PathLike[str]) -> None:
        """Write the picture to a PNG file.

        Raises
        ------
        ValueError
            If the file's name does not end with ``.png``.
        TypeError
            If `path` is not a file name.
        OSError
            If the file cannot be written.
        """
        check_file_name(path)
        if Path(path).suffix.lower() != ".png":
            raise ValueError(f"the picture is a PNG file, so its name must end with .png, unlike {str(path)!r}")
        Path(path).write_bytes(png(self.image()))

    def facts(self, *, tolerance: float = TOLERANCE) -> SimulationFacts:
        """Return what each operation and the job remove, and where they cut air, crash, plunge too fast, gouge or leave material.

        The facts do not depend on the view and the moment. They come from a simulation along the tool axis, which the first
        call makes, as fine as is useful and as the budgets allow.

        Parameters
        ----------
        tolerance : float
            Allowed deviation from the job's model, mm.

        Raises
        ------
        ValueError
            If the tolerance is negative or not a number.
        TypeError
            If the tolerance has no numeric type.
        """
        labels = [operation.label for operation in self.job.operations]
        names = tuple((operation.document, operation.name) for operation in self.job.operations)
        axis = self.along_axis()
        found = axis.facts(tolerance)
        fingerprints = tuple(operation.fingerprint for operation in self.job.operations)
        operations, table = tuple(zip(labels, found.cuts)), trajectory_table(axis.zbuffer, axis.measured)
        return SimulationFacts(operations, found.job, names, fingerprints, table, self.job.remarks, found.verdict)

    def source(self, trajectory: int) -> tuple[SimulatedOperation, int]:
        """Return the operation of a trajectory and the index of its command in the operation's Path.

        Raises
        ------
        IndexError
            If there is no trajectory of this number.
        TypeError
            If `trajectory` is not an integer.
        """
        source = self.zbuffer.cuts.source(trajectory)
        return self.job.operations[source.cut], source.command
