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
    """An operation to simulate."""

    # document, name, label: internal names of the document and of the object, and the object's label.
    document: str
    name: str
    label: str
    # Horizontal and vertical rapid speed of the operation's tool controller, mm/s; 0 if unset.
    rapid_feeds: tuple[float, float]
    imported: bool  # whether the toolpath possibly comes from a G-code file
    # Fingerprint of path, tool and stock. Until the path is read, this is the fingerprint of tool and stock only (the
    # setting).
    fingerprint: str


@dataclass(frozen=True, eq=False)
class SimulatedJob:
    """A job to simulate."""

    operations: tuple[SimulatedOperation, ...]  # the operations, in the order of their job
    cuts: tuple[Cut, ...]  # toolpaths and tools of the operations
    # The toolpaths with the feeds as FreeCAD's import leaves them. The recognition uses the toolpaths as read.
    as_read: tuple[Toolpath, ...]
    listings: tuple[Listing, ...]  # G-code of the operations
    stock: Solid
    model_shapes: tuple  # shapes of the job's model
    remarks: tuple[Message, ...]  # what the simulation leaves out or simplifies in the job, with the reason
    # Solids that no tool may touch, by the labels of their objects.
    clamps: Mapping[str, Solid] = field(default_factory=dict)
    # The remarks on parts of the job that could not be read, which make the verdict on the job uncertain.
    unread: tuple[Message, ...] = ()
    # Internal names of document and object of the operations that are not simulated.
    left_out: tuple[tuple[str, str], ...] = ()
    name: str = ""  # internal name of the job; empty without a job
    # Fingerprint of the job for which the verdict is valid, see `fingerprint_of_job`. The fingerprint is empty if only
    # some operations are simulated, or if the caller has given another stock or other clamps.
    valid_for: str = ""

    @cached_property
    def model(self) -> Solid | None:
        """The model of the job; None if the job has no closed model. The model is computed at the first use."""
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
