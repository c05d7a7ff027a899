# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation told of its operations: plain data, printed as a table, saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from math import isnan
from typing import Any

import numpy as np

from vkworkbench.core.zbuffer import FACT_COLUMNS, CutFacts
from vkworkbench.given import check_file_name
from vkworkbench.language import ENGLISH, Message, render
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.text_table import how_many, line, printable, widths_of


@dataclass(frozen=True)
class SimulationFacts:
    """What a simulation told. Commands are counted from 0, as in ``Path.Commands``.

    Attributes
    ----------
    operations : tuple of (str, CutFacts)
        Each operation's label and facts, in their order.
    job : CutFacts
        All together.
    names : tuple of (str, str)
        Internal names of each operation's document and object.
    fingerprints : tuple of str
        Of each operation's toolpath, tool and stock, as they were simulated.
    trajectories : mapping of str to ndarray
        What each trajectory does, by columns; see `core.zbuffer.trajectory_table`.
    remarks : tuple of Message
        What is to be known of the simulation itself, e.g. what was not simulated exactly.
    """

    operations: tuple[tuple[str, CutFacts], ...]
    job: CutFacts
    names: tuple[tuple[str, str], ...]
    fingerprints: tuple[str, ...]
    trajectories: Mapping[str, np.ndarray]
    remarks: tuple[Message, ...] = ()

    def __repr__(self) -> str:
        """Return what stands in a console where somebody asks for them themselves: printed they are the table."""
        return f"<SimulationFacts of {how_many(len(self.operations), 'operation')}>"

    def as_dict(self) -> dict[str, Any]:
        """Return it as numbers, strings and lists, in mm, s, mm^3 and mm^3/min."""
        return {
            "operations": [{"label": label, **facts.as_dict()} for label, facts in self.operations],
            "job": self.job.as_dict(),
            "remarks": [render(remark) for remark in self.remarks],
        }

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write one line for each operation, with a header; of what is wrong the number of places and the worst."""
        check_file_name(path)
        rows = [{"label": as_cell(label), **facts.cells()} for label, facts in self.operations]
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, ["label", *FACT_COLUMNS])
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write all of it, with every place where something is wrong."""
        check_file_name(path)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.as_dict(), file, indent=1, ensure_ascii=False)

    def trajectories_to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write one line for each trajectory, with a header: its operation, command, and what it removes.

        A rate that nobody knows is an empty cell.
        """
        check_file_name(path)
        table = dict(self.trajectories)
        labels = [as_cell(label) for label, _ in self.operations]
        table = {"label": np.array(labels, object)[table.pop("cut")], **table}
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(table)
            writer.writerows(zip(*map(_cells, table.values())))

    def __str__(self) -> str:
        header = (
            "operation",
            "removed, cm3",
            "rate, cm3/min",
            "peak, cm3/min",
            "air",
            "crashes",
            "fast plunges",
            "gouged",
            "left",
        )
        rows = [header, *(_row(label, facts) for label, facts in (*self.operations, ("job", self.job)))]
        widths = widths_of(rows)
        return "\n".join(
            [*(line(row, widths, left={0}) for row in rows), *(printable(render(one), 200) for one in self.remarks)]
        )


def _cells(column: np.ndarray) -> list[Any]:
    """Return the cells of a column: empty ones for what is not a number, which a spreadsheet would take for a word."""
    return [None if isinstance(value, float) and isnan(value) else value for value in column.tolist()]


def _row(label: str, facts: CutFacts) -> tuple[str, ...]:
    gouged, left = (max((one.depth for one in found), default=0.0) for found in (facts.gouges, facts.left))
    return (
        printable(label),
        f"{facts.removed_volume / 1e3:.2f}",
        f"{facts.mean_rate / 1e3:.2f}",
        f"{facts.peak_rate / 1e3:.2f}",
        f"{facts.air_length_share:.0%}",
        str(len(facts.crashes) or ""),
        str(len(facts.fast_plunges) or ""),
        ENGLISH.length(gouged) if gouged else "",
        ENGLISH.length(left) if left else "",
    )
