# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that is simulated: what its operations are, with what they cut, and what the part is to be."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core import Cut, Solid, Strategy, Toolpath, trajectory_seconds
from vkworkbench.document.job.listing import Listing
from vkworkbench.document.job.recognition import recognize_operation
from vkworkbench.document.job.solids import model_solid
from vkworkbench.language import Message


@dataclass(frozen=True)
class SimulatedOperation:
    """An operation that is simulated.

    Attributes
    ----------
    document, name, label : str
        Internal names of the document and of the object, and the object's label.
    rapid_feeds : tuple of float
        Horizontal and vertical rapid speed of its tool controller, mm/s; 0 where unset.
    imported : bool
        Whether the toolpath may come from a file.
    fingerprint : str
        Of path, tool and stock, as an analysis has it; of the setting alone until the path was read.
    """

    document: str
    name: str
    label: str
    rapid_feeds: tuple[float, float]
    imported: bool
    fingerprint: str


@dataclass(frozen=True, eq=False)
class SimulatedJob:
    """What is to be simulated.

    Attributes
    ----------
    operations : tuple of SimulatedOperation
        In the order of their job.
    cuts : tuple of Cut
        Their toolpaths and tools.
    as_read : tuple of Toolpath
        The toolpaths with the feeds that FreeCAD took for mm/s: their strategies are told from these.
    listings : tuple of Listing
        Their G-code.
    stock : Solid
    model_shapes : tuple of Shape
        Of what the part is to be.
    remarks : tuple of Message
        What is left out or not simulated exactly, and why.
    """

    operations: tuple[SimulatedOperation, ...]
    cuts: tuple[Cut, ...]
    as_read: tuple[Toolpath, ...]
    listings: tuple[Listing, ...]
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

    def strategies(self) -> Iterator[Strategy]:
        """Tell the strategy of each operation, as its mark does."""
        for operation, cut, toolpath in zip(self.operations, self.cuts, self.as_read):
            found, _ = recognize_operation(toolpath, cut.tool.diameter, operation.imported)
            yield found.strategy
