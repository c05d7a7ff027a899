# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the space that a job needs with the travel of the machine."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from vkworkbench.core import Toolpath
from vkworkbench.language import Message
from vkworkbench.report.operation import OperationReport

# If the needed travel exceeds the machine's travel by at most this share, no remark is made, because the excess may be
# rounding.
_ROUNDING = 1e-9


def extent_of(toolpath: Toolpath) -> tuple[tuple[float, float, float], tuple[float, float, float]] | None:
    """Return the lowest and highest coordinates of the tool's tip, mm; None if the toolpath has no position."""
    if not len(toolpath.points):
        return None
    return tuple(toolpath.points.min(axis=0).tolist()), tuple(toolpath.points.max(axis=0).tolist())


def with_travel(
    rows: Sequence[OperationReport], job: Iterable[OperationReport], travel: tuple[float, float, float]
) -> list[OperationReport]:
    """Return the rows of a report with remarks on axes along which a job needs more travel than the machine has.

    The job's first row in the report gets the remarks.

    Parameters
    ----------
    rows : sequence of OperationReport
        All rows of the report.
    job : iterable of OperationReport
        All rows of one job. `rows` may contain only some rows of the job.
    travel : tuple of float
        Travel of the machine along X, Y and Z, mm; 0 if unknown.
    """
    job = list(job)
    extents = [row.extent for row in job if row.extent]
    remarks = []
    for axis, name in enumerate("XYZ"):
        needed = max((high[axis] for _, high in extents), default=0.0) - min(
            (low[axis] for low, _ in extents), default=0.0
        )
        if 0 < travel[axis] * (1 + _ROUNDING) < needed:
            remarks.append(Message("beyond-travel", axis=name, needed=needed, travel=travel[axis]))
    rows = list(rows)
    names = [(row.document, row.name) for row in rows]
    own = [names.index((row.document, row.name)) for row in job if (row.document, row.name) in names]
    if remarks and own:
        rows[own[0]] = replace(rows[own[0]], remarks=(*rows[own[0]].remarks, *remarks))
    return rows
