# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printed table of a report."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import zip_longest
from pathlib import PurePath

from vkworkbench.core import Strategy
from vkworkbench.core.simulators import Costs
from vkworkbench.language import ENGLISH, render
from vkworkbench.report.operation import OperationReport, contradiction
from vkworkbench.report.text_table import how_many, line, printable, widths_of
from vkworkbench.report.total import Total, compare_setups, compare_with_sum, counted_in

_VERDICT = 1000  # maximum length of a simulation's verdict printed below the table, characters


def table_of(operations: Sequence[OperationReport], totals: Sequence[Total], simulator: str) -> str:
    """Return a table of the operations with their costs in one simulator, and the jobs' totals below a line."""
    header: tuple[str, ...] = (
        "operation", "strategy", "confidence", "moves", "cutting", "machining", f"{simulator} time", f"{simulator} memory", "",
    )  # fmt: skip
    rows: list[tuple[str, ...]] = [_row(o, simulator) for o in operations]
    below: list[tuple[str, ...]] = [_total_row(t, operations, simulator) for t in totals]
    names = _short_names([*(o.document for o in operations), *(t.document for t in totals)])
    if len(names) > 1:  # the jobs of several documents may have the same label
        header = ("document", *header)
        rows = [(names[o.document], *row) for o, row in zip(operations, rows)]
        below = [(names[t.document], *row) for t, row in zip(totals, below)]
    widths = widths_of([header, *rows, *below])
    left = {*range(len(widths) - 7), len(widths) - 1}  # left-aligned columns: all except the six with numbers
    rule = "  ".join("-" * width for width in widths[:-1])
    title, *shown = (line(row, widths, left) for row in (header, *rows))
    lines = [title, rule, *shown]
    if below:
        lines += [rule, *(line(row, widths, left) for row in below)]
    if any(not o.counted and o.job is not None for o in operations):
        lines.append("Rows in brackets are not included in the totals: they are switched off, or have a dress-up.")
    for t in totals:
        notes = compare_setups(t), compare_with_sum(t, counted_in(operations, t.document, t.job), simulator)
        lines += [f"{printable(t.label)}: {render(note)}" for note in notes if note]
    lines += [f"{printable(t.label)}: {printable(str(t.verdict), _VERDICT)}" for t in totals if t.verdict]
    return "\n".join(lines)


def _short_names(documents: Iterable[str]) -> dict[str, str]:
    """Return the documents' names for the table. Programs have paths as names, whose common folder is removed."""
    parts = {name: PurePath(name).parts for name in documents}
    shared = next((depth for depth, names in enumerate(zip_longest(*parts.values())) if len(set(names)) > 1), 0)
    return {name: printable(str(PurePath(*of_name[shared:])), 200) for name, of_name in parts.items()}


def _row(o: OperationReport, simulator: str) -> tuple[str, ...]:
    wrong = contradiction(o)
    remarks = o.remarks if wrong is None else (wrong, *o.remarks)
    return (
        printable(o.label) if o.counted or o.job is None else f"({printable(o.label)})",
        o.strategy.value,
        f"{o.confidence:.0%}",
        ENGLISH.count(o.trajectories),
        *(("", "", "", "") if _is_idle(o) else _measures(o, simulator)),
        printable(" ".join(map(render, remarks)), 200),
    )


def _is_idle(o: OperationReport) -> bool:
    """Return whether an operation has no moves (as inactive operations and stops), so that it has no times."""
    return o.strategy is Strategy.EMPTY and not o.trajectories


def _measures(o: OperationReport, simulator: str) -> tuple[str, ...]:
    seconds = o.machining_seconds or 0.0
    return *_machining(o.length, seconds, not o.left_out, _is_measured(o)), *_cost(o, simulator, least=False)


def _total_row(t: Total, operations: Sequence[OperationReport], simulator: str) -> tuple[str, ...]:
    measured = all(map(_is_measured, counted_in(operations, t.document, t.job)))
    return (
        f"{printable(t.label)}: {how_many(t.operations, 'operation')}" + (f" x{t.fixtures}" if t.fixtures > 1 else ""),
        "",
        "",
        ENGLISH.count(t.trajectories),
        *_machining(t.length, t.machining_seconds, t.machining_complete, measured),
        *_cost(t, simulator, least=t.incomplete),
        "",
    )


def _is_measured(o: OperationReport) -> bool:
    """Return whether the cutting length is known. A length of 0 can be known, too."""
    return bool(o.length) or o.machining.cutting_seconds is not None


def _machining(length: float, seconds: float, complete: bool, measured: bool) -> tuple[str, str]:
    """Return the cutting length and the machining time as texts, with a question mark for an unknown value."""
    time = ENGLISH.clock(seconds)
    if complete:
        return ENGLISH.length(length), time
    return ENGLISH.length(length) if length or measured else "?", f">= {time}" if seconds else "?"


def _cost(of: Costs, simulator: str, least: bool) -> tuple[str, str]:
    """Return the time and the memory of a simulation as texts, in the same form as in the marks in the tree."""
    cost = of.cost(simulator)
    if cost is None:
        return "?", "?"
    time, memory = ENGLISH.estimated_time(cost[0], of.factor(simulator)), ENGLISH.memory(cost[1])
    return (f">= {time}", f">= {memory}") if least else (time, memory)
