# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an analysis found: plain data, printed as a table, saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import zip_longest
from pathlib import PurePath
from typing import Any

from vkworkbench.core import Estimate, Machining, Recognition, Span, Strategy
from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.simulators import SIMULATORS, ZBUFFER, Caution, Costs, together
from vkworkbench.core.zbuffer import FACT_COLUMNS, CutFacts
from vkworkbench.language import ENGLISH, Message, render
from vkworkbench.simulation_facts import SimulationFacts
from vkworkbench.spreadsheet import as_cell
from vkworkbench.text_table import line, printable, widths_of

# Cautions on what hangs a simulator, or takes longer or more memory than the user allows.
HANGS = frozenset({"legacy-hangs"})
SERIOUS = HANGS | {"long-play", "memory"}
_NO_UTF8 = "surrogateescape"  # the name of a file may hold bytes that are none


class Cancelled(Exception):
    """The analysis was cancelled; nothing has been changed."""


@dataclass(frozen=True)
class OperationReport(Costs):
    """What was found about one operation.

    Attributes
    ----------
    document, name, label : str
        Internal names of the document and of the object, and the object's label.
    job : str or None
        Internal name of the job it belongs to.
    counted : bool
        Whether it counts in its job's total: not where a dress-up stands for it, nor where it is inactive.
    recognition : Recognition
        Strategy, confidence, reason and spans with their evidence.
    trajectories : int
        Number of straight moves, arcs divided into chords.
    machining : Machining
        Own lengths and machining time (FreeCAD's are wrong for arcs).
    costs, advice : mapping
        As of `Costs`; empty where `remarks` says why.
    cautions : tuple of Caution
        What will go wrong or take long in FreeCAD's simulators, the worst first.
    remarks : tuple of Message
        What is wrong with it or unknown about it.
    fingerprint : str
        Of the path, tool and stock that were analysed; empty for a program.
    document_id : str
        Tells the document from another one of the same name; empty for a program.
    called : str or None
        FreeCAD's name of its kind or its pattern where its toolpath surely does something else, e.g. ``"Offset"`` of a zigzag.
    simulated : CutFacts or None
        What a simulation told of it; None where none was asked: see `Report.with_facts`.
    """

    document: str
    name: str
    label: str
    job: str | None
    counted: bool
    recognition: Recognition
    trajectories: int
    machining: Machining
    costs: Mapping[str, Any]
    advice: Mapping[str, Any]
    cautions: tuple[Caution, ...]
    remarks: tuple[Message, ...]
    fingerprint: str
    document_id: str = ""
    called: str | None = None
    simulated: CutFacts | None = None

    def __repr__(self) -> str:
        """Return a line: all that is known of it fills pages of a console."""
        return f"<OperationReport of {printable(self.label)}: {self.strategy}>"

    @property
    def strategy(self) -> Strategy:
        """The strategy that was recognised."""
        return self.recognition.strategy

    @property
    def confidence(self) -> float:
        """How sure that is, 0 to 1."""
        return self.recognition.confidence

    @property
    def reason(self) -> str:
        """Why, in one English sentence."""
        return self.recognition.reason

    @property
    def spans(self) -> tuple[Span, ...]:
        """The sections of one strategy each."""
        return self.recognition.spans

    @property
    def estimate(self) -> Estimate | None:
        """Dexels, traces, memory and time of simulating it in the extended z-buffer."""
        cost: Estimate | None = self.costs.get(ZBUFFER.name)
        return cost

    @property
    def length(self) -> float:
        """Cutting length, mm, arcs by their exact length."""
        return self.machining.cutting_length

    @property
    def machining_seconds(self) -> float | None:
        """Time of the moves whose speed is known, s; None where none is."""
        return self.machining.seconds

    @property
    def left_out(self) -> tuple[Message, ...]:
        """What that time leaves out; empty where it is complete."""
        return self.machining.left_out

    @property
    def stepover(self) -> float | None:
        """Distance between neighbouring passes, mm."""
        return self.recognition.stepover

    @property
    def error(self) -> str | None:
        """What is wrong or unknown in English, sentences with semicolons between them; None where nothing is."""
        return "; ".join(map(render, self.remarks)) or None

    @property
    def messages(self) -> tuple[Message, ...]:
        """All that is told of it: the reason, remarks, cautions, and what the machining time leaves out."""
        return (self.recognition.why, *self.remarks, *(c.what for c in self.cautions), *self.machining.left_out)

    def as_dict(self) -> dict[str, Any]:
        """Return the report as numbers, strings and lists, in mm, s, rad and bytes."""
        found = self.recognition
        return {
            "document": self.document,
            "name": self.name,
            "label": self.label,
            "job": self.job,
            "counted": self.counted,
            "strategy": self.strategy.value,
            "called": self.called,
            "confidence": round(self.confidence, 4),
            "reason": self.reason,
            "level": found.level,
            "phi_low": found.phi_range[0],
            "phi_high": found.phi_range[1],
            "reversals": found.reversals,
            "sense": found.sense,
            "stepover": found.stepover,
            "passes": found.passes,
            "depths": found.depths,
            "entry": found.entry,
            "finishing": found.finishing,
            "direction": found.direction,
            **_paper(found.paper),
            "trajectories": self.trajectories,
            "length": self.length,
            "rapid_length": self.machining.rapid_length,
            "shortest_move": self.machining.shortest,
            "median_move": self.machining.median,
            "depth": self.machining.depth,
            "machining_seconds": self.machining.seconds,
            "machining_complete": self.machining.complete,
            "machining_notes": list(self.machining.notes),
            **ZBUFFER.figures(self.estimate),
            **self.columns(),
            **self.factors(),
            "simulated": self.simulated and self.simulated.as_dict(),
            "error": self.error,
            "cautions": [caution.message for caution in self.cautions],
            "messages": {
                "reason": found.why.as_data(),
                "remarks": [remark.as_data() for remark in self.remarks],
                "cautions": [caution.what.as_data() for caution in self.cautions],
                "machining_notes": [note.as_data() for note in self.machining.left_out],
                **self.advice_messages(),
            },
            "spans": [
                {"strategy": s.strategy.value, "first_command": s.first_command, "last_command": s.last_command,
                 "share": round(s.share, 4)}
                for s in found.spans
            ],
        }  # fmt: skip


def _paper(verdict: PaperVerdict | None) -> dict[str, Any]:
    """Return what the paper's rule says to the letter, with V_k, in rad and mm; empty cells where it says nothing."""
    return {
        "paper_strategy": verdict and verdict.strategy.value,
        "paper_level": verdict and verdict.level,
        "paper_phi_low": verdict and verdict.phi_range[0],
        "paper_phi_high": verdict and verdict.phi_range[1],
        "v_x": verdict and verdict.v[0],
        "v_y": verdict and verdict.v[1],
        "theta_low": verdict and verdict.theta_range[0],
        "theta_high": verdict and verdict.theta_range[1],
        "v_sense": verdict and verdict.sense,
    }


@dataclass(frozen=True)
class Total(Costs):
    """What the operations of one job that are posted take together.

    Attributes
    ----------
    document, job, label : str
        Internal names of the document and the job, and the job's label.
    operations, trajectories : int
    length : float
        Cutting length for one fixture, mm.
    fixtures : int
        How often they are posted, once for each work offset (G54 to G59) of the job.
    machining_seconds : float
        Time of the moves whose speed is known, for all fixtures.
    machining_complete : bool
        Whether that is the time of all moves; else it is the least that they take.
    incomplete : bool
        Whether some operation's cost is unknown, so that the sums are lower bounds.
    costs, advice : mapping
        As of `Costs`, for the operations one after another; empty where no operation's cost is known.
    simulated : CutFacts or None
        What a simulation of all of them told; None where none was asked.
    """

    document: str
    job: str
    label: str
    operations: int
    trajectories: int
    length: float
    fixtures: int
    machining_seconds: float
    machining_complete: bool
    incomplete: bool
    costs: Mapping[str, Any]
    advice: Mapping[str, Any]
    simulated: CutFacts | None = None

    def __repr__(self) -> str:
        return f"<Total of {printable(self.label)}: {how_many(self.operations, 'operation')}>"

    @property
    def seconds(self) -> float:
        """Of the extended z-buffer, s; 0 where no operation's cost is known."""
        cost = self.cost(ZBUFFER.name)
        return cost[0] if cost else 0

    @property
    def memory_bytes(self) -> float:
        """Of the extended z-buffer, likewise."""
        cost = self.cost(ZBUFFER.name)
        return cost[1] if cost else 0

    def as_dict(self) -> dict[str, Any]:
        """Return the total as numbers and strings, in mm, s and bytes."""
        return {
            "document": self.document,
            "job": self.job,
            "label": self.label,
            "operations": self.operations,
            "trajectories": self.trajectories,
            "length": self.length,
            "fixtures": self.fixtures,
            "machining_seconds": self.machining_seconds,
            "machining_complete": self.machining_complete,
            "seconds": self.seconds,
            "memory_bytes": self.memory_bytes,
            "incomplete": self.incomplete,
            **self.columns(),
            "simulated": self.simulated and self.simulated.as_dict(),
            "messages": self.advice_messages(),
        }


@dataclass(frozen=True)
class Report:
    """All operations analysed, in the order of their jobs.

    Attributes
    ----------
    operations : tuple of OperationReport
    jobs : dict
        Label of each job by (document name, job name).
    budget : dict
        Of memory and time, as `best_resolution` takes it.
    fixtures : dict
        How often each job's operations are posted, where that is known, likewise.
    simulated : dict
        What a simulation told of each job as a whole, where there was one, likewise.
    simulator : str
        Whose time and memory the table shows, as of :meth:`Costs.cost`: where there are marks, that of the marks.
    """

    operations: tuple[OperationReport, ...]
    jobs: dict[tuple[str, str], str]
    budget: dict[str, float]
    fixtures: dict[tuple[str, str], int] = field(default_factory=dict)
    simulated: dict[tuple[str, str], CutFacts] = field(default_factory=dict)
    simulator: str = ZBUFFER.name

    def with_facts(self, facts: SimulationFacts) -> Report:
        """Return the report with what a simulation told of its operations, and of the job if all of it was simulated.

        Of what has another toolpath, tool or stock now than it had in the simulation nothing is told.

        Parameters
        ----------
        facts : SimulationFacts
            ``vkworkbench.simulate(job).facts()``.

        Raises
        ------
        TypeError
            If `facts` is something else, as the simulation itself is.
        """
        if not isinstance(facts, SimulationFacts):
            raise TypeError(f"with_facts takes what a simulation's facts() returns, not {type(facts).__name__}")
        told = {
            (*names, fingerprint): of_one
            for names, fingerprint, (_, of_one) in zip(facts.names, facts.fingerprints, facts.operations)
        }
        operations = tuple(
            replace(o, simulated=told.get((o.document, o.name, o.fingerprint), o.simulated)) for o in self.operations
        )
        jobs = {}
        for key in self.jobs:
            cutting = {
                (o.document, o.name, o.fingerprint)
                for o in self.operations
                if o.counted and (o.document, o.job) == key and o.trajectories
            }
            if cutting == set(told):
                jobs[key] = facts.job
        return replace(self, operations=operations, simulated={**self.simulated, **jobs})

    @property
    def totals(self) -> tuple[Total, ...]:
        """One total for each job, nothing counted twice."""
        return tuple(self._total(*key, label) for key, label in self.jobs.items())

    def _counted(self, document: str, job: str) -> list[OperationReport]:
        return [o for o in self.operations if o.counted and (o.document, o.job) == (document, job)]

    def _total(self, document: str, job: str, label: str) -> Total:
        counted = self._counted(document, job)
        total = total_of(document, job, label, counted, self.budget, self.fixtures.get((document, job), 1))
        return replace(total, simulated=self.simulated.get((document, job)))

    def __repr__(self) -> str:
        """Return what stands in a console where somebody asks for the report itself: printed it is the table."""
        return f"<Report of {how_many(len(self.operations), 'operation')}>"

    def __str__(self) -> str:
        if not self.operations:
            return "No operations found."
        of = self.simulator
        header = (
            "operation",
            "strategy",
            "sure",
            "moves",
            "cutting",
            "machining",
            f"{of} time",
            f"{of} memory",
            "",
        )
        rows = [header, *(_row(o, of) for o in self.operations)]
        totals: list[tuple[str, ...]] = [
            (f"{printable(t.label)}: {how_many(t.operations, 'operation')}", "", "", ENGLISH.count(t.trajectories),
             *_machining(t.length, t.machining_seconds, t.machining_complete,
                         all(map(_is_measured, self._counted(t.document, t.job)))),
             *_cost(t, of, t.incomplete), "")
            for t in self.totals
        ]  # fmt: skip
        names = _told_apart([*(o.document for o in self.operations), *(t.document for t in self.totals)])
        if len(names) > 1:  # each has a "Job"
            rows = [("document", *header), *((names[o.document], *row) for o, row in zip(self.operations, rows[1:]))]
            totals = [(names[t.document], *row) for t, row in zip(self.totals, totals)]
        widths = widths_of([*rows, *totals])
        left = {*range(len(widths) - 7), len(widths) - 1}  # the six between them are numbers
        rule = "  ".join("-" * width for width in widths[:-1])
        title, *shown = (line(row, widths, left) for row in rows)
        lines = [title, rule, *shown]
        if totals:
            lines += [rule, *(line(row, widths, left) for row in totals)]
        return "\n".join(lines)

    def to_csv(self, path: str) -> None:
        """Write one line for each operation, with a header, in mm, s, rad and bytes; see `cells_of`."""
        rows = [cells_of(operation) for operation in self.operations]
        names = list(rows[0]) if rows else ["document", "name", "label", "strategy"]
        with open(path, "w", newline="", encoding="utf-8", errors=_NO_UTF8) as file:
            writer = csv.DictWriter(file, names, quoting=csv.QUOTE_NONNUMERIC)
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str) -> None:
        """Write the operations and the totals of their jobs, in mm, s, rad and bytes."""
        data = {
            "operations": [o.as_dict() for o in self.operations],
            "totals": [t.as_dict() for t in self.totals],
        }
        with open(path, "w", encoding="utf-8", errors=_NO_UTF8) as file:
            json.dump(data, file, indent=1, ensure_ascii=False)


def total_of(
    document: str, job: str, label: str, counted: Sequence[Any], budget: dict[str, float] | None, fixtures: int = 1
) -> Total:
    """Return what operations take together, one after another: the one computation of every total that is shown.

    Parameters
    ----------
    document, job, label : str
        As of :class:`Total`.
    counted : sequence of OperationReport or Record
        The operations that are posted, in their order.
    budget : dict or None
        As of :class:`Report`; without one nothing is advised.
    fixtures : int
        How often the operations are posted.
    """
    known = [o for o in counted if o.costs]
    costs: Mapping[str, Any]
    advice: Mapping[str, Any]
    if budget is None:
        each = {s: [o.costs[s.name] for o in known if s.name in o.costs] for s in SIMULATORS}
        costs, advice = {s.name: s.together(alone) for s, alone in each.items() if len(alone) == len(known) > 0}, {}
    else:
        stepover = min((o.stepover for o in known if o.stepover), default=None)
        labels = [o.label for o in known]
        costs, advice = together([o.costs for o in known], labels=labels, stepover=stepover, **budget)
    return Total(
        document, job, label,
        operations=len(counted),
        trajectories=sum(o.trajectories for o in counted),
        length=sum(o.length for o in counted),
        fixtures=fixtures,
        machining_seconds=fixtures * sum(o.machining_seconds or 0.0 for o in counted),
        machining_complete=not any(o.left_out for o in counted),
        incomplete=any(map(has_unknown_cost, counted)),
        costs=costs,
        advice=advice,
    )  # fmt: skip


def has_unknown_cost(operation: Any) -> bool:
    """Whether an OperationReport or Record is of what cuts, and its cost is not known: its job takes more than is told."""
    return operation.trajectories > 0 and operation.strategy is not Strategy.EMPTY and not operation.costs


def contradiction(found: Any) -> Message | None:
    """Return what an OperationReport or Record says of its name, where its toolpath surely does something else; else None."""
    return Message("called", name=found.called, strategy=found.strategy) if found.called else None


def cells_of(operation: OperationReport) -> dict[str, Any]:
    """Return an operation's report as the cells of one line of a table.

    What a simulation told has the columns ``simulated_...``, empty where there was none, with commands counted from 0;
    ``codes`` has the codes of its messages, each followed by those of the messages in it. ``spans`` has the first and last
    command of each strategy as `Span` has them: indices into ``Path.Commands``, counted from 0, or lines of a program,
    counted from 1. Sentences count both from 1.
    A text cell that a spreadsheet would take for a formula gets an apostrophe in front.
    """
    row = operation.as_dict()
    del row["messages"]
    del row["simulated"]
    told = operation.simulated.cells() if operation.simulated else dict.fromkeys(FACT_COLUMNS)
    row.update({f"simulated_{name}": value for name, value in told.items()})
    row["codes"] = "; ".join(" ".join(message.codes) for message in operation.messages)
    row["cautions"] = "; ".join(row["cautions"])
    row["machining_notes"] = "; ".join(row["machining_notes"])
    row["spans"] = "; ".join(f"{s['strategy']} {s['first_command']}-{s['last_command']}" for s in row["spans"])
    return {name: as_cell(value) for name, value in row.items()}


def _told_apart(documents: Iterable[str]) -> dict[str, str]:
    """Return what documents are called in a table: programs, whose names are paths, without the folder of them all."""
    parts = {name: PurePath(name).parts for name in documents}
    shared = next((depth for depth, names in enumerate(zip_longest(*parts.values())) if len(set(names)) > 1), 0)
    return {name: printable(str(PurePath(*of_name[shared:])), 200) for name, of_name in parts.items()}


def _row(o: OperationReport, simulator: str) -> tuple[str, ...]:
    wrong = contradiction(o)
    told = o.remarks if wrong is None else (wrong, *o.remarks)
    return (
        printable(o.label) if o.counted or o.job is None else f"({printable(o.label)})",
        o.strategy.value,
        f"{o.confidence:.0%}",
        ENGLISH.count(o.trajectories),
        *_machining(o.length, o.machining_seconds or 0.0, not o.left_out, _is_measured(o)),
        *_cost(o, simulator, least=False),
        printable("; ".join(map(render, told)), 200),
    )


def without_results(why: Message, **whose: Any) -> OperationReport:
    """Return the row of something of which nothing is known, and why: no strategy, length, time or cost.

    Parameters
    ----------
    why : Message
    whose
        The fields of `OperationReport` that say whose row it is, and the fingerprint.
    """
    return OperationReport(
        recognition=Recognition(Strategy.UNKNOWN, 0.0, why), trajectories=0,
        machining=Machining(0.0, 0.0, None, None, None, 0.0, (why,)), costs={}, advice={}, cautions=(), remarks=(why,), **whose,
    )  # fmt: skip


def how_many(number: int, thing: str) -> str:
    """Return how many things there are in English, e.g. ``"1 operation"``, ``"2 operations"``."""
    return f"{number} {thing}" + ("" if number == 1 else "s")


def _is_measured(o: OperationReport) -> bool:
    """Whether its cutting length is known: where nothing cuts it is 0, and so is the cutting time."""
    return bool(o.length) or o.machining.cutting_seconds is not None


def _machining(length: float, seconds: float, complete: bool, measured: bool) -> tuple[str, str]:
    """Return the cutting length and the machining time; a question mark for what is 0 because it is not known."""
    time = ENGLISH.time(seconds)
    if complete:
        return ENGLISH.length(length), time
    return ENGLISH.length(length) if length or measured else "?", f">= {time}" if seconds else "?"


def _cost(of: Costs, simulator: str, least: bool) -> tuple[str, str]:
    """Return the time and the memory of a simulation, as marks say them."""
    cost = of.cost(simulator)
    if cost is None:
        return "?", "?"
    time, memory = ENGLISH.estimated_time(cost[0], of.factor(simulator)), ENGLISH.memory(cost[1])
    return (f">= {time}", f">= {memory}") if least else (time, memory)
