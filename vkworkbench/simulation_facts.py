# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation told of its operations: plain data, printed as a table, saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
from dataclasses import dataclass
from typing import Any

from vkworkbench.core.zbuffer import CutFacts
from vkworkbench.language import ENGLISH
from vkworkbench.report import plain_text

_NUMBERS = (
    "removed_volume", "cutting_length", "cutting_seconds", "air_length", "air_seconds", "air_length_share",
    "air_time_share", "mean_rate", "peak_rate", "depth_of_cut", "width_of_cut", "tool_diameter",
)  # fmt: skip


@dataclass(frozen=True)
class SimulationFacts:
    """What a simulation told.

    Attributes
    ----------
    operations : tuple of (str, CutFacts)
        Each operation's label and facts, in their order.
    job : CutFacts
        All together.
    """

    operations: tuple[tuple[str, CutFacts], ...]
    job: CutFacts

    def as_dict(self) -> dict[str, Any]:
        """Return it as numbers, strings and lists, in mm, s, mm^3 and mm^3/min."""
        return {
            "operations": [{"label": label, **_as_dict(facts)} for label, facts in self.operations],
            "job": _as_dict(self.job),
        }

    def to_csv(self, path: str) -> None:
        """Write one line for each operation, with a header; of what is wrong the number of places and the worst."""
        rows = [{"label": plain_text(label), **_cells(facts)} for label, facts in self.operations]
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, ["label", *_cells(self.job)])
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str) -> None:
        """Write all of it, with every place where something is wrong."""
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.as_dict(), file, indent=1, ensure_ascii=False)

    def __str__(self) -> str:
        header = (
            "operation",
            "removed, cm3",
            "rate, cm3/min",
            "peak",
            "air",
            "crashes",
            "fast plunges",
            "gouged",
            "left",
        )
        rows = [_row(label, facts) for label, facts in (*self.operations, ("job", self.job))]
        widths = [max(len(row[i]) for row in (header, *rows)) for i in range(len(header))]
        lines = [
            "  ".join(cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
            for row in (header, *rows)
        ]
        return "\n".join(line.rstrip() for line in lines)


def _as_dict(facts: CutFacts) -> dict[str, Any]:
    numbers = {name: getattr(facts, name) for name in _NUMBERS}
    crashes = [
        {"command": c.source.command, "place": list(c.place), "depth": c.depth, "volume": c.volume}
        for c in facts.crashes
    ]
    plunges = [
        {"command": p.source.command, "place": list(p.place), "feed": p.feed, "allowed": p.allowed}
        for p in facts.fast_plunges
    ]
    gouges, left = (
        [
            {"command": d.source and d.source.command, "place": list(d.place), "depth": d.depth, "area": d.area}
            for d in found
        ]
        for found in (facts.gouges, facts.left)
    )
    return {**numbers, "crashes": crashes, "fast_plunges": plunges, "gouges": gouges, "left": left}


def _cells(facts: CutFacts) -> dict[str, Any]:
    return {
        **{name: getattr(facts, name) for name in _NUMBERS},
        "crashes": len(facts.crashes),
        "first_crash_command": facts.crashes[0].source.command if facts.crashes else None,
        "fast_plunges": len(facts.fast_plunges),
        "deepest_gouge": max((gouge.depth for gouge in facts.gouges), default=0.0),
        "most_left": max((left.depth for left in facts.left), default=0.0),
    }


def _row(label: str, facts: CutFacts) -> tuple[str, ...]:
    gouged, left = (max((one.depth for one in found), default=0.0) for found in (facts.gouges, facts.left))
    return (
        label[:60],
        f"{facts.removed_volume / 1e3:.2f}",
        f"{facts.mean_rate / 1e3:.2f}",
        f"{facts.peak_rate / 1e3:.2f}",
        f"{facts.air_length_share:.0%}",
        str(len(facts.crashes) or ""),
        str(len(facts.fast_plunges) or ""),
        ENGLISH.length(gouged) if gouged else "",
        ENGLISH.length(left) if left else "",
    )
