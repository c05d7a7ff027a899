# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job to simulate: its operations with toolpaths and tools, its stock and its model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Cut, Solid, Strategy, Toolpath, seconds_of_dwells, trajectory_seconds
from vkworkbench.document.job.listing import Listing
from vkworkbench.document.job.recognition import recognize_operation
from vkworkbench.document.job.solids import model_solid
from vkworkbench.language import Message


@dataclass(frozen=True)
class SimulatedOperation:
    """An operation to simulate.

    Attributes
    ----------
    document, name, label : str
        Internal names of the document and of the object, and the object's label.
    rapid_feeds : tuple of float
        Horizontal and vertical rapid speed of the operation's tool controller, mm/s; 0 if unset.
    imported : bool
        Whether the toolpath possibly comes from a G-code file.
    fingerprint : str
        Fingerprint of path, tool and stock. Until the path is read, this is the fingerprint of tool and stock only (the
        setting).
    """

    document: str
    name: str
    label: str
    rapid_feeds: tuple[float, float]
    imported: bool
    fingerprint: str


@dataclass(frozen=True, eq=False)
class SimulatedJob:
    """A job to simulate.

    Attributes
    ----------
    operations : tuple of SimulatedOperation
        The operations, in the order of their job.
    cuts : tuple of Cut
        Toolpaths and tools of the operations.
    as_read : tuple of Toolpath
        The toolpaths with the feeds as FreeCAD's import leaves them. The recognition uses these toolpaths.
    listings : tuple of Listing
        G-code of the operations.
    stock : Solid
    model_shapes : tuple of Shape
        Shapes of the job's model.
    remarks : tuple of Message
        What the simulation leaves out or simplifies in the job, with the reason.
    clamps : mapping of str to Solid
        Solids that no tool may touch, by the labels of their objects.
    unread : tuple of Message
        The remarks on parts of the job that could not be read, which make the verdict on the job uncertain.
    left_out : tuple of (str, str)
        Internal names of document and object of the operations that are not simulated.
    name : str
        Internal name of the job; empty without a job.
    valid_for : str
        Fingerprint of the job for which the verdict is valid, see `fingerprint_of_job`. The fingerprint is empty if
        only some operations are simulated, or if the caller has given another stock or other clamps.
    """

    operations: tuple[SimulatedOperation, ...]
    cuts: tuple[Cut, ...]
    as_read: tuple[Toolpath, ...]
    listings: tuple[Listing, ...]
    stock: Solid
    model_shapes: tuple
    remarks: tuple[Message, ...]
    clamps: Mapping[str, Solid] = field(default_factory=dict)
    unread: tuple[Message, ...] = ()
    left_out: tuple[tuple[str, str], ...] = ()
    name: str = ""
    valid_for: str = ""

    @cached_property
    def model(self) -> Solid | None:
        """The model of the job; None if the job has no closed model. Computed at the first use."""
        return model_solid(self.model_shapes)

    @cached_property
    def seconds(self) -> np.ndarray:
        """Time of each trajectory of all operations, dwells included, (n,) float64 s; NaN if the speed is unknown."""
        machine = preferences.read().planned_machine
        return np.concatenate([
            trajectory_seconds(cut.toolpath, horizontal_rapid=operation.rapid_feeds[0],
                               vertical_rapid=operation.rapid_feeds[1], machine=machine)
            + seconds_of_dwells(cut.toolpath, machine=machine)
            for operation, cut in zip(self.operations, self.cuts)
        ])  # fmt: skip

    def strategies(self) -> Iterator[Strategy]:
        """Yield the strategy of each operation, as the operation's mark in the tree shows it."""
        for operation, cut, toolpath in zip(self.operations, self.cuts, self.as_read):
            found, _ = recognize_operation(toolpath, cut.tool.diameter, operation.imported)
            yield found.strategy
