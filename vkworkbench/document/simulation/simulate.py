# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate operations of a document, without changing the document."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import FreeCAD
import Mesh
import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Cylinder, Solid, Stock, View, ZBuffer, simulate_job
from vkworkbench.core import Mesh as MeshStock
from vkworkbench.core.zbuffer import TOLERANCE, OverBudget, trajectory_table
from vkworkbench.document.simulation.along_axis import AlongAxis, simulate_along_axis, zbuffer_along_axis
from vkworkbench.document.simulation.copy import read_job
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.document.simulation.solid import add_mesh, mesh_of, stock_after
from vkworkbench.given import of_kind
from vkworkbench.language import Message
from vkworkbench.report import SimulatedPart, SimulationFacts, how_many

# Minimum width of the image, as a share of the requested width. If the memory allows only a smaller image, the
# simulation is refused, because the image would show too little.
MIN_SIZE = 1 / 3
# Allowed rounding error of the image's size, as a share: an image that is smaller than the stock by at most this share
# still counts as an image of the whole stock.
_ROUNDING = 1e-9


def simulate(
    what=None,
    *,
    view: View | str | None = None,
    stock: Simulation | Solid | None = None,
    clamps: Iterable | None = None,
    memory_budget: float | None = None,
    going_on: Callable[[float], None] = lambda _: None,
) -> Simulation:
    """Simulate operations in the extended z-buffer, one after the other. The document is not changed.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of these objects, optional
        A document with one job, a job, or some of its operations; the active document if None.
    view : View or str, optional
        The image, or the name of a direction, e.g. ``"Isometric"``. None stands for the direction in the preferences.
        If no View is given and the image would need too much memory, a coarser image is made, and a remark of the job
        reports this.
    stock : Simulation or Solid, optional
        Stock that replaces the job's stock: a solid, or the part that another simulation leaves at its moment. If both
        jobs have the same model at different places, as for the two sides of a part, the part is moved like the model.
    clamps : iterable of DocumentObject, optional
        Objects that no tool may touch, such as clamps and vices. None stands for the clamps of the job, see `set_clamps`.
    memory_budget : float, optional
        Upper bound for the memory, bytes. None stands for the budget in the preferences.
    going_on : callable, optional
        Called many times a second with the completed share, 0 to 1. If `going_on` raises an exception, the simulation
        ends.

    Returns
    -------
    Simulation
        The simulation after its last trajectory.

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
    job = _with_stock(job, stock)
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


def _with_stock(job: SimulatedJob, stock: Simulation | Solid | None) -> SimulatedJob:
    if stock is None:
        return job
    of_kind(
        "stock",
        stock,
        (Simulation, Stock, Cylinder, MeshStock),
        "a simulation, or a solid such as a Stock(lower, upper)",
    )
    job = replace(job, valid_for="")
    if not isinstance(stock, Simulation):
        return replace(job, stock=stock)
    left, remark = stock_after(stock.triangles(), stock.job.model_shapes, job.model_shapes)
    unread = (*([remark] if remark else []), *stock.job.unread)
    return replace(job, stock=left, remarks=(*job.remarks, *unread), unread=(*job.unread, *unread))


def _coarser_image(image: View, stock: Solid) -> Message:
    pixel, limit = image.frame(stock).pixel, Message("limit-memory")
    return Message("image", width=image.width, height=image.height, pixel=pixel, limit=limit, passes=None)


def coarser(view: View, refused: OverBudget) -> View:
    """Return the finest image of a view that fits into the memory budget.

    The given error `refused` is raised if the image's share of the view's width would be less than `MIN_SIZE`.
    """
    if refused.size is None or refused.size[0] < MIN_SIZE * view.width:
        raise refused
    return view.of_size(*refused.size)


def simulate_read(
    job: SimulatedJob, view: View, memory_budget: float, going_on: Callable[[float], None] = lambda _: None
) -> Simulation:
    """Simulate a job that was read; see :func:`simulate`. Any thread may call this function, as it needs no FreeCAD."""
    zbuffer = simulate_job(job.cuts, stock=job.stock, view=view, memory_budget=memory_budget, going_on=going_on)
    return _simulation(job, zbuffer, memory_budget)


def simulate_solid(what, going_on: Callable[[float], None]) -> Simulation:
    """Simulate operations along the tool axis only, to get the part as a solid; see :func:`simulate`."""
    job, budget = read_job(what), preferences.read().memory_budget_bytes
    return _simulation(job, zbuffer_along_axis(job, budget, going_on), budget)


def _simulation(job: SimulatedJob, zbuffer: ZBuffer, memory_budget: float) -> Simulation:
    return Simulation(job, zbuffer, lru_cache(partial(simulate_along_axis, job, memory_budget)))


@dataclass(frozen=True, eq=False)
class Simulation(SimulatedPart):
    """A simulated job at one moment.

    Attributes
    ----------
    job : SimulatedJob
    zbuffer : ZBuffer
        Depth of every pixel and the trajectory that cut it, dexels and traces.
    along_axis : callable
        Returns the simulation along the tool axis, from which `facts` computes its results; computed at the first call.
    """

    job: SimulatedJob
    zbuffer: ZBuffer
    along_axis: Callable[[], AlongAxis]

    def __repr__(self) -> str:
        return f"<Simulation of {how_many(len(self.job.operations), 'operation')}, {self.step} of {self.trajectories} trajectories>"

    def mesh(self) -> Mesh.Mesh:
        """Return the part at this moment as a closed mesh of FreeCAD; see `triangles`."""
        return mesh_of(self.triangles())

    def add_mesh(self) -> FreeCAD.DocumentObject:
        """Add the part at this moment to its document as a mesh, in one undo step, and return the new object."""
        return add_mesh(self.job.operations[0].document, self.mesh())

    def facts(self, *, tolerance: float = TOLERANCE) -> SimulationFacts:
        """Return the removed volumes, air cuts, crashes, fast plunges, gouges and leftover material of the job.

        The results do not depend on the view and the moment. The first call simulates the job along the tool axis, as
        finely as is useful and as the budgets allow, and all facts come from this simulation.

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
        job = self.job
        return SimulationFacts(
            operations, found.job, names, fingerprints, table, job.remarks, found.verdict, job.left_out, job.valid_for
        )

    def source(self, trajectory: int) -> tuple[SimulatedOperation, int]:
        """Return the operation of a trajectory and the index of its command in the operation's Path.

        Raises
        ------
        IndexError
            If no trajectory has this number.
        TypeError
            If `trajectory` is not an integer.
        """
        source = self.zbuffer.cuts.source(trajectory)
        return self.job.operations[source.cut], source.command

    def _of_solid(self) -> ZBuffer:
        """Return a z-buffer along the tool axis that shows the whole stock: this or the one of `along_axis`."""
        frame, stock = self.zbuffer.frame, self.job.stock
        beside = np.abs((stock.lower + stock.upper)[:2] / 2 - frame.centre[:2]) + (stock.upper - stock.lower)[:2] / 2
        shown = (beside <= np.array([frame.width, frame.height]) / 2 * frame.pixel * (1 + _ROUNDING)).all()
        if shown and not frame.direction[:2].any():
            return self.zbuffer
        return self.along_axis().zbuffer.at(self.step)
