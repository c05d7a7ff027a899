# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found about one operation: plain data, and the cells of one line of a table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from vkworkbench.core import Estimate, Machining, Recognition, Span, Strategy
from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.simulators import ZBUFFER, Caution, Costs
from vkworkbench.core.zbuffer import FACT_COLUMNS, CutFacts
from vkworkbench.language import Message, render
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.text_table import printable

# Cautions on what hangs a simulator, or takes longer or more memory than the user allows.
HANGS = frozenset({"legacy-hangs"})
SERIOUS = HANGS | {"long-play", "memory"}


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
        """The remarks in English; None if there are none."""
        return " ".join(map(render, self.remarks)) or None

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


def is_switched_off(found: Any) -> bool:
    """Whether an OperationReport or Record is of an operation without a toolpath because it is switched off."""
    return any(remark.code == "inactive" for remark in found.remarks)


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
    row["cautions"] = " ".join(row["cautions"])
    row["machining_notes"] = " ".join(row["machining_notes"])
    row["spans"] = "; ".join(f"{s['strategy']} {s['first_command']}-{s['last_command']}" for s in row["spans"])
    return {name: as_cell(value) for name, value in row.items()}
