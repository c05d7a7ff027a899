# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of one operation as plain data, and as cells for one row of a table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from vkworkbench.core import Estimate, Machine, Machining, Recognition, Span, Strategy
from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.simulators import ZBUFFER, Caution, Costs
from vkworkbench.core.zbuffer import FACT_COLUMNS, CutFacts
from vkworkbench.language import Message, render
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.text_table import printable

# Codes of the cautions that a simulation would hang, or would exceed the user's limits of time or memory.
HANGS = frozenset({"legacy-hangs"})
SERIOUS = HANGS | {"long-play", "memory"}


class Setup(NamedTuple):
    """The tool of an operation, and the time to set it up.

    Attributes
    ----------
    tool : str
        Name of the tool; empty if the tool is unknown, and for a job.
    planned : bool
        Whether the machining time is planned for a machine. If False, the machining time is computed with constant
        feeds, and without times for setups.
    change : float
        Time to change to this tool, s; for a job, the time of all setups.
    spindle : float
        Time until the spindle runs at its speed, s.
    """

    tool: str = ""
    planned: bool = False
    change: float = 0.0
    spindle: float = 0.0


def setup_of(tool: str, machine: Machine | None) -> Setup:
    """Return the times to set up a tool on a machine. Without a machine, the setup takes no time."""
    if machine is None:
        return Setup(tool)
    return Setup(tool, True, machine.factor * machine.tool_change, machine.factor * machine.spindle_start)


@dataclass(frozen=True)
class OperationReport(Costs):
    """The results of one operation.

    Attributes
    ----------
    document, name, label : str
        Internal names of the document and of the object, and the object's label.
    job : str or None
        Internal name of the operation's job.
    counted : bool
        Whether the operation is included in its job's total. Inactive operations are not included. The base operation
        of a dress-up is not included, because the dress-up is included.
    recognition : Recognition
        The strategy with its confidence, reason, spans and evidence.
    trajectories : int
        Number of straight moves. Each chord of an arc counts as one move.
    machining : Machining
        Lengths and machining time. FreeCAD's own values are not used, because they are wrong for arcs.
    costs, advice : mapping
        Costs and recommended settings of the simulators, as in `Costs`. If `costs` and `advice` are empty, `remarks`
        contains the reason.
    cautions : tuple of Caution
        Problems and long times in FreeCAD's simulators, the worst first.
    remarks : tuple of Message
        Problems of the operation, and remarks on missing information.
    fingerprint : str
        Fingerprint of the analysed path, tool and stock; empty for an NC program.
    document_id : str
        Identifier of the document, unique even if another document has the same name; empty for an NC program.
    called : str or None
        FreeCAD's name for the operation's type or pattern, if the toolpath contradicts this name, such as ``"Offset"``
        for a zigzag; None otherwise.
    simulated : CutFacts or None
        Facts of a simulation, see `Report.with_facts`; None without a simulation.
    extent : tuple of (3,) tuples of float, or None
        Lowest and highest coordinates of the tool's tip, mm; None if the toolpath has no position.
    setup : Setup
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
    extent: tuple[tuple[float, float, float], tuple[float, float, float]] | None = None
    setup: Setup = field(default_factory=Setup)

    def __repr__(self) -> str:
        """Return one line for the console, because all attributes would fill many pages."""
        return f"<OperationReport of {printable(self.label)}: {self.strategy}>"

    @property
    def strategy(self) -> Strategy:
        """The recognised strategy."""
        return self.recognition.strategy

    @property
    def confidence(self) -> float:
        """Confidence of the strategy, 0 to 1."""
        return self.recognition.confidence

    @property
    def reason(self) -> str:
        """The reason for the strategy in English."""
        return self.recognition.reason

    @property
    def spans(self) -> tuple[Span, ...]:
        """The spans of the operation, stretches with one strategy each."""
        return self.recognition.spans

    @property
    def estimate(self) -> Estimate | None:
        """Dexels, traces, memory and time of a simulation in the extended z-buffer."""
        return self.costs.get(ZBUFFER.name)

    @property
    def length(self) -> float:
        """Cutting length, mm, with the exact length of arcs."""
        return self.machining.cutting_length

    @property
    def machining_seconds(self) -> float | None:
        """Time of the moves with a known speed, s; None if no speed is known."""
        return self.machining.seconds

    @property
    def left_out(self) -> tuple[Message, ...]:
        """Messages on the moves that `machining_seconds` does not include; empty if it includes all moves."""
        return self.machining.left_out

    @property
    def stepover(self) -> float | None:
        """Distance between neighbouring passes, mm."""
        return self.recognition.stepover

    @property
    def error(self) -> str | None:
        """The remarks in English; None if there are none."""
        return " ".join(map(render, self.remarks)) or None

    @property
    def messages(self) -> tuple[Message, ...]:
        """The reason, the remarks, the cautions, and the notes on the machining time."""
        return (self.recognition.why, *self.remarks, *(c.what for c in self.cautions), *self.machining.left_out)

    def as_dict(self) -> dict[str, Any]:
        """Return the results as a dictionary of numbers, strings and lists, in mm, s, rad and bytes."""
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
    """Return the verdict of the paper's own rule, and V_k (the sum of the moves), in rad and mm.

    Without a verdict, all values are None.
    """
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


def without_results(why: Message, **whose: Any) -> OperationReport:
    """Return the row of an operation that has no results: no strategy, length, time or cost.

    Parameters
    ----------
    why : Message
        The reason, which becomes the row's remark.
    **whose
        The fields of `OperationReport` that identify the operation, and the fingerprint.
    """
    return OperationReport(
        recognition=Recognition(Strategy.UNKNOWN, 0.0, why), trajectories=0,
        machining=Machining(0.0, 0.0, None, None, None, 0.0, (why,)), costs={}, advice={}, cautions=(), remarks=(why,), **whose,
    )  # fmt: skip


def is_switched_off(found: Any) -> bool:
    """Return whether the operation of an OperationReport or Record is inactive, so that it has no toolpath."""
    return any(remark.code == "inactive" for remark in found.remarks)


def contradiction(found: Any) -> Message | None:
    """Return a message if the toolpath of an OperationReport or Record contradicts the operation's name, else None."""
    return Message("called", name=found.called, strategy=found.strategy) if found.called else None


def cells_of(operation: OperationReport) -> dict[str, Any]:
    """Return the results of an operation as the cells of one row of a table.

    The columns ``simulated_...`` contain the facts of a simulation, with commands counted from 0. Without a simulation,
    the columns ``simulated_...`` are empty. The column ``codes`` contains the code of each message, followed by the
    codes of the messages in its arguments. The column ``spans`` contains the first and the last command of each
    strategy, as in `Span`. For operations in FreeCAD, the commands are indices into ``Path.Commands``, counted from 0.
    For NC programs, ``spans`` contains program lines, counted from 1. Sentences count commands and lines from 1. An
    apostrophe is put before texts that a spreadsheet would calculate as formulas.
    """
    row = operation.as_dict()
    del row["messages"]
    del row["simulated"]
    facts = operation.simulated.cells() if operation.simulated else dict.fromkeys(FACT_COLUMNS)
    row.update({f"simulated_{name}": value for name, value in facts.items()})
    row["codes"] = "; ".join(" ".join(message.codes) for message in operation.messages)
    row["cautions"] = " ".join(row["cautions"])
    row["machining_notes"] = " ".join(row["machining_notes"])
    row["spans"] = "; ".join(f"{s['strategy']} {s['first_command']}-{s['last_command']}" for s in row["spans"])
    return {name: as_cell(value) for name, value in row.items()}
