# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facts of a simulation as plain data, which can be printed as a table and saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from math import isnan
from typing import Any

import numpy as np

from vkworkbench.core.zbuffer import FACT_COLUMNS, PENDING, CutFacts, Verdict
from vkworkbench.given import check_file_name
from vkworkbench.language import ENGLISH, Message, render
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.text_table import how_many, line, printable, widths_of

_MOST_FAULTS = 20  # maximum number of faults printed below the table
_WIDTH = 2000  # maximum length of a sentence printed below the table, characters


@dataclass(frozen=True)
class SimulationFacts:
    """The facts of a simulation: removed volumes, removal rates and faults.

    Commands are indices into ``Path.Commands``, counted from 0, or lines of an NC program, counted from 1.

    Attributes
    ----------
    operations : tuple of (str, CutFacts)
        Label and facts of each operation, in the order of simulation.
    job : CutFacts
        Facts of all operations together.
    names : tuple of (str, str)
        Internal names of each operation's document and object.
    fingerprints : tuple of str
        Fingerprint of each operation's simulated toolpath, tool and stock.
    trajectories : mapping of str to ndarray
        Columns with one value for each trajectory, see `core.zbuffer.trajectory_table`.
    remarks : tuple of Message
        Remarks on the simulation, for example about tools that were simulated only approximately.
    verdict : Verdict
        The faults that the simulation has found, its pixel size, and everything that it could not check.
    left_out : tuple of (str, str)
        Internal names of document and object of each operation that was not simulated.
    valid_for : str
        Fingerprint of the job for which the verdict is valid. The fingerprint is empty if an NC program or only a part
        of the job was simulated, or if the simulation used another stock or other clamps than the job has.
    """

    operations: tuple[tuple[str, CutFacts], ...]
    job: CutFacts
    names: tuple[tuple[str, str], ...]
    fingerprints: tuple[str, ...]
    trajectories: Mapping[str, np.ndarray]
    remarks: tuple[Message, ...] = ()
    verdict: Verdict = PENDING
    left_out: tuple[tuple[str, str], ...] = ()
    valid_for: str = ""

    def __repr__(self) -> str:
        """Return one line for consoles. `print` prints the whole table."""
        return f"<SimulationFacts of {how_many(len(self.operations), 'operation')}>"

    @property
    def sentence(self) -> Message:
        """The verdict as a message."""
        return self.verdict.message([label for label, _ in self.operations])

    def as_dict(self) -> dict[str, Any]:
        """Return the facts as a dictionary of numbers, strings and lists, in mm, s, mm^3 and mm^3/min."""
        return {
            "operations": [{"label": label, **facts.as_dict()} for label, facts in self.operations],
            "job": self.job.as_dict(),
            "pixel": self.verdict.pixel,
            "verdict": render(self.sentence),
            "unchecked": [
                {"label": self.operations[one.cut][0], "command": one.command} for one in self.verdict.unchecked
            ],
            "remarks": [render(remark) for remark in self.remarks],
        }

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write a CSV file with a header, one line for each operation, and one line for the job.

        Each line has the number of faults of each kind and the worst fault. The last column, ``verdict``, is filled
        only in the line of the job.
        """
        check_file_name(path)
        rows = [{"label": as_cell(label), **facts.cells()} for label, facts in self.operations]
        rows.append({"label": "job", **self.job.cells(), "verdict": render(self.sentence)})
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, ["label", *FACT_COLUMNS, "verdict"])
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write a JSON file with all facts, including the place of every fault."""
        check_file_name(path)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.as_dict(), file, indent=1, ensure_ascii=False)

    def trajectories_to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write a CSV file with a header and one line for each trajectory, see `trajectories`.

        The first column is the operation's label. Cells with unknown numbers are empty.
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
            "error, cm3",
            "rate, cm3/min",
            "peak, cm3/min",
            "air",
            "crashes",
            "collisions",
            "fast plunges",
            "gouged",
            "left",
            "stock lacks",
        )
        rows = [header, *(_row(label, facts) for label, facts in (*self.operations, ("job", self.job)))]
        widths = widths_of(rows)
        remarks = [one for one in self.remarks if one not in self.verdict.unread[:1]]  # the verdict contains this one
        return "\n".join(
            [
                *(line(row, widths, left={0}) for row in rows),
                *self._faults(),
                *(printable(render(one), _WIDTH) for one in (self.sentence, *remarks)),
            ]
        )

    def _faults(self) -> list[str]:
        """Return one line of text for each of the first faults, with the operation and the command."""
        faults = self.job.faults
        lines = []
        for source, what in faults[:_MOST_FAULTS]:
            place = "Stock"
            if source is not None:
                place = f"{printable(self.operations[source.cut][0])}, {self._command(source.command)}"
            lines.append(f"{place}: {render(what)}")
        if len(faults) > _MOST_FAULTS:
            lines.append(f"{how_many(len(faults) - _MOST_FAULTS, 'more fault')}; to_json writes all faults.")
        return lines

    def _command(self, number: int) -> str:
        return f"line {number}" if self.verdict.lines else f"command {number + 1}"


def _cells(column: np.ndarray) -> list[Any]:
    """Return the cells of a column. NaN becomes an empty cell, because spreadsheets would read NaN as text."""
    return [None if isinstance(value, float) and isnan(value) else value for value in column.tolist()]


def _row(label: str, facts: CutFacts) -> tuple[str, ...]:
    cut = [one for one in facts.gouges if one.source is not None]
    never = [one for one in facts.gouges if one.source is None]
    gouged, left, lacking = (max((one.depth for one in found), default=0.0) for found in (cut, facts.left, never))
    return (
        printable(label),
        f"{facts.removed_volume / 1e3:.2f}",
        "" if facts.removed_volume_error is None else f"{facts.removed_volume_error / 1e3:.2f}",
        f"{facts.mean_rate / 1e3:.2f}",
        f"{facts.peak_rate / 1e3:.2f}",
        f"{facts.air_length_share:.0%}",
        str(len(facts.crashes) or ""),
        str(len(facts.collisions) or ""),
        str(len(facts.fast_plunges) or ""),
        ENGLISH.length(gouged) if gouged else "",
        ENGLISH.length(left) if left else "",
        ENGLISH.length(lacking) if lacking else "",
    )
