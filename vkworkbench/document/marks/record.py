# SPDX-License-Identifier: LGPL-2.1-or-later
"""The data of a mark in the tree: all results of an operation that tooltips, changed preferences and totals need."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, ClassVar

from vkworkbench import freecad
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import SIMULATORS, Caution, Cost, Costs, cost_as_data, cost_from_data
from vkworkbench.language import Message, render
from vkworkbench.report import HANGS, SERIOUS, JobVerdict, OperationReport, Setup, Total, has_unknown_cost

_FORMAT = 2  # format of the JSON text; format 1 was never released
_LARGEST = 1e15  # upper bound for numbers in any unit; a larger number comes from a damaged file


@dataclass(frozen=True)
class Record(Costs):
    """The results of a marked operation, or the total of a job."""

    strategy: Strategy | None  # strategy of the operation; None for a job
    confidence: float = 0.0
    # reason, remarks: the reason for the strategy; problems of the operation and its unknown quantities.
    reason: tuple[Message, ...] = ()
    remarks: tuple[Message, ...] = ()
    cautions: tuple[Caution, ...] = ()  # problems in FreeCAD's simulators
    # operations, fixtures, trajectories: number of operations, number of work offsets for which they are posted, and
    # number of straight moves.
    operations: int = 1
    fixtures: int = 1
    trajectories: int = 0
    length: float = 0.0  # cutting length, mm
    machining_seconds: float | None = None  # time of the moves whose speed is known, s
    left_out: tuple[Message, ...] = ()  # what the machining time does not include
    setup: Setup = field(default_factory=Setup)  # the tool, and the time of its setup
    stepover: float | None = None  # stepover, mm
    # FreeCAD's name for the operation's kind or pattern, if the toolpath contradicts this name.
    called: str | None = None
    # Whether the cost of an operation is unknown, so that the costs of the job are lower bounds.
    incomplete: bool = False
    costs: Mapping[str, Cost] = field(default_factory=dict)  # costs of the simulation, by the name of the simulator
    fingerprint: str = ""  # fingerprint of path, tool and stock; for a job, the fingerprints of its operations
    verdict: JobVerdict | None = None  # the verdict of a simulation on a job
    outdated: bool = False
    # Whether the operation lost its toolpath because it was switched off. The other data of the record becomes valid
    # again when the operation has its toolpath again.
    off: bool = False
    text: str = ""  # text of the mark in the description
    label: str = ""  # current label of the operation; not stored
    advice: ClassVar[dict] = {}  # a mark in the tree stores no recommended settings of simulators

    @property
    def shown(self) -> Record:
        """The results to show: for a switched-off operation, only that it is switched off; otherwise this record."""
        if not self.off:
            return self
        why = {"confidence": 1.0, "reason": (Message("no-moves"),), "remarks": (Message("inactive"),)}
        return Record(Strategy.EMPTY, **why, text=self.text, label=self.label)

    @property
    def english_reason(self) -> str:
        return " ".join(map(render, self.reason))

    @property
    def english_remarks(self) -> str:
        """Remarks, serious cautions and the simulation's verdict in English."""
        verdict = [str(self.verdict)] if self.verdict else []
        return " ".join(
            [*map(render, self.remarks), *(c.message for c in self.cautions if c.code in SERIOUS), *verdict]
        )


def of_operation(report: OperationReport, simulator: str) -> Record:
    """Return the record of an operation's report, with the costs of FreeCAD's simulators and of `simulator`.

    The cost of any other simulator is included only if it was computed already.
    """
    names = {simulator, *freecad.own_simulators(), *_computed(report.costs)}
    costs = {name: report.costs[name] for name in sorted(names) if name in report.costs}
    return Record(
        strategy=report.strategy,
        confidence=report.confidence,
        reason=(report.recognition.why,),
        remarks=report.remarks,
        cautions=report.cautions,
        trajectories=report.trajectories,
        length=report.length,
        machining_seconds=report.machining_seconds,
        left_out=report.left_out,
        setup=report.setup,
        stepover=report.stepover,
        called=report.called,
        costs=costs,
        fingerprint=report.fingerprint,
    )


def _computed(costs: Mapping[str, Cost]) -> Iterable[str]:
    return costs.computed() if hasattr(costs, "computed") else costs


def of_total(total: Total, parts: list[Record], fingerprint: str) -> Record:
    """Return the record of a job's total. `parts` are the records of the job's operations."""
    unknown = [part.label for part in parts if has_unknown_cost(part)]
    return Record(
        strategy=None,
        remarks=(Message("cost-unknown", labels=unknown),) if unknown else (),
        cautions=tuple(caution for part in parts for caution in part.cautions if caution.code in HANGS),
        operations=total.operations,
        fixtures=total.fixtures,
        trajectories=total.trajectories,
        length=total.length,
        machining_seconds=total.machining_seconds if any(p.machining_seconds is not None for p in parts) else None,
        left_out=tuple(dict.fromkeys(message for part in parts for message in part.left_out)),
        setup=total.setup,
        incomplete=total.incomplete,
        costs=dict(total.costs),
        fingerprint=fingerprint,
    )


def as_json(record: Record, shown: Iterable[str] = (), own: Iterable[str] = ()) -> str:
    """Return a record as JSON, with the names of its visible properties and the user's own texts in brackets."""
    return json.dumps({
        "format": _FORMAT,
        "text": record.text,
        "shown": list(shown),
        "own": list(own),
        "outdated": record.outdated,
        "off": record.off,
        "strategy": record.strategy and record.strategy.value,
        "confidence": round(record.confidence, 4),
        "reason": [message.as_data() for message in record.reason],
        "remarks": [message.as_data() for message in record.remarks],
        "cautions": [{"code": c.code, "what": c.what.as_data(), "command": c.command} for c in record.cautions],
        "operations": record.operations,
        "fixtures": record.fixtures,
        "trajectories": record.trajectories,
        "length": record.length,
        "machining": record.machining_seconds,
        "left_out": [message.as_data() for message in record.left_out],
        "setup": list(record.setup),
        "stepover": record.stepover,
        "called": record.called,
        "incomplete": record.incomplete,
        "costs": {name: cost_as_data(name, cost) for name, cost in record.costs.items()},
        "fingerprint": record.fingerprint,
        "verdict": record.verdict and _verdict_as_data(record.verdict),
    })  # fmt: skip


@lru_cache(1024)
def from_json(text: str) -> Record | None:
    """Return the record of a text from `as_json`; None for any other text, or for a newer format."""
    try:
        data = json.loads(text)
        # Refuse texts with an unpaired surrogate, because FreeCAD crashes if a property contains such a text.
        json.dumps(data, ensure_ascii=False).encode()
        return Record(
            strategy=None if data["strategy"] is None else Strategy(data["strategy"]),
            confidence=_share(data["confidence"]),
            reason=_messages(data["reason"]),
            remarks=_messages(data["remarks"]),
            cautions=tuple(_caution(one) for one in data["cautions"]),
            operations=int(_number(data["operations"])),
            fixtures=int(_number(data.get("fixtures", 1))),
            trajectories=int(_number(data["trajectories"])),
            length=_number(data["length"]),
            machining_seconds=_or_none(data["machining"]),
            left_out=_messages(data["left_out"]),
            setup=_setup(*data.get("setup", ())),
            stepover=_or_none(data["stepover"]),
            called=data["called"] and str(data["called"]),
            incomplete=bool(data["incomplete"]),
            costs=_costs(data["costs"]),
            fingerprint=str(data["fingerprint"]),
            verdict=_verdict(data.get("verdict")),
            outdated=bool(data["outdated"]),
            off=bool(data["off"]),
            text=str(data["text"]),
        )
    except (AttributeError, LookupError, TypeError, ValueError, ArithmeticError, RecursionError):
        return None


def _verdict_as_data(verdict: JobVerdict) -> dict[str, Any]:
    return {"what": verdict.what.as_data(), "valid_for": verdict.valid_for, "outdated": verdict.outdated}


def _verdict(data: Any) -> JobVerdict | None:
    if data is None:
        return None
    (what,) = _messages([data["what"]])
    return JobVerdict(what, str(data["valid_for"]), bool(data["outdated"]))


def _costs(data: dict) -> dict[str, Cost]:
    known = {simulator.name for simulator in SIMULATORS}
    return {name: cost_from_data(name, one) for name, one in data.items() if name in known}


def _setup(tool: Any = "", planned: Any = False, change: Any = 0.0, spindle: Any = 0.0) -> Setup:
    return Setup(str(tool), bool(planned), _number(change), _number(spindle))


def _messages(data: Any) -> tuple[Message, ...]:
    """Return the messages in the data; raise an error if this version cannot render a message."""
    messages = tuple(map(Message.from_data, data))
    for message in messages:
        render(message)
    return messages


def _caution(data: Any) -> Caution:
    (what,) = _messages([data["what"]])
    return Caution(str(data["code"]), what, None if data["command"] is None else int(data["command"]))


def _or_none(data: Any) -> float | None:
    return None if data is None else _number(data)


def _number(data: Any) -> float:
    if isinstance(data, bool) or not isinstance(data, (int, float)) or not 0 <= data <= _LARGEST:
        raise ValueError(f"not a measure: {data!r:.40}")
    return data


def _share(data: Any) -> float:
    if _number(data) > 1:
        raise ValueError(f"not a share: {data!r:.40}")
    return data
