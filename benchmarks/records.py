# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labelled toolpaths: single operations from files, synthetic operations, whole programs, and pairs of operations.

Each line of a file is a JSON record. The record of an operation has id, label, strategy, accept (the strategies that
count as right), tool_diameter (mm or null), commands ([name, parameters], mm and mm/s), and perhaps params (properties
of FreeCAD's operation, such as StepOver in percent of the tool's diameter), stock (lower and upper corner, mm) and
source (the CAM system). The record of a program has id, commands, group (the records that are left out together when a
model is judged) and sections, each [first command, last command, label, accept].
"""

from __future__ import annotations

import gzip
import hashlib
import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from toolpaths import strokes, synthetic
from vkworkbench.core import Stock, Toolpath
from vkworkbench.core.gcode import linearize

JOINED = 20_000  # maximum number of trajectories of an operation that is joined to another
SEEDS = 20  # number of synthetic toolpaths of each kind


@dataclass(frozen=True)
class Section:
    """One operation of a program: its first and last trajectory, its label, and the strategies that count as right."""

    first: int
    last: int
    label: str
    accepted: frozenset[str]


@dataclass(frozen=True)
class Record:
    """A labelled toolpath. `group` is the toolpath's repository or part, and `system` is its CAM system.

    Each kind of synthetic toolpath has a group and a system of its own.
    """

    id: str
    group: str
    label: str
    strategy: str
    accepted: frozenset[str]
    tool: float | None
    stepover: float | None
    path: Toolpath
    sections: tuple[Section, ...]
    system: str = ""


def lines(file: str) -> Iterator[dict]:
    with gzip.open(file, "rt") if file.endswith(".gz") else open(file) as opened:
        yield from map(json.loads, opened)


def with_stock(file: str, most: int) -> Iterator[tuple[dict, Stock]]:
    """Yield up to `most` records with stock and tool, evenly distributed over the file, together with their stocks."""
    records = [r for r in lines(file) if r.get("stock") and r.get("tool_diameter")]
    for r in records[:: max(1, math.ceil(len(records) / most))]:
        yield r, Stock(r["stock"][:3], r["stock"][3:])


def group_of(r: dict) -> str:
    """Return the group of a record from its id: a repository (OWNER_NAME__file) or a part (version:part:operation)."""
    if "group" in r:
        return r["group"]
    name = r.get("id", "")
    return name.split("__")[0] if "__" in name else name.split(":")[1] if name.count(":") > 1 else r["label"]


def system_of(r: dict) -> str:
    """Return the CAM system's name without version and language: the first word of the record's source."""
    return re.split(r"[\s/(-]", r.get("source", "").lower())[0]


def stepover_of(r: dict) -> float | None:
    """Return the stepover that was set in FreeCAD, mm."""
    percent = r.get("params", {}).get("StepOver")
    return percent / 100 * r["tool_diameter"] if percent and r["tool_diameter"] else None


def key(path: Toolpath, tool: float | None) -> bytes:
    """Return a key that is equal for equal toolpaths with the same tool."""
    return hashlib.sha1(np.round(path.points, 3).tobytes() + path.rapid.tobytes() + str(tool).encode()).digest()


def operations(files: list[str]) -> Iterator[Record]:
    """Yield the operations in files; of toolpaths that differ by less than a micrometre, only the first operation."""
    seen: set[bytes] = set()
    for file in files:
        for r in lines(file):
            path = linearize([(name, words) for name, words in r["commands"]])
            if (digest := key(path, r["tool_diameter"])) in seen:
                continue
            seen.add(digest)
            cutting = np.flatnonzero(~path.rapid)
            accepted = frozenset(r["accept"])
            sections = ()
            if len(cutting):
                sections = (Section(int(cutting[0]), int(cutting[-1]), r["label"], accepted),)
            yield Record(
                r.get("id", ""),
                group_of(r),
                r["label"],
                r["strategy"],
                accepted,
                r["tool_diameter"],
                stepover_of(r),
                path,
                sections,
                system_of(r),
            )


def made() -> Iterator[Record]:
    """Yield the toolpaths of toolpaths/synthetic.py and toolpaths/strokes.py."""
    for label, accepted, make in (*synthetic.SAMPLES, *strokes.SAMPLES):
        strategy = "zigzag" if "zigzag" in accepted else "mixed" if "mixed" in accepted else min(accepted)
        for seed in range(SEEDS):
            path = linearize(make(rng_of(label, seed)))
            yield Record(label, label, label, strategy, frozenset(accepted), None, None, path, (), label)


def rng_of(kind: str, seed: int) -> np.random.Generator:
    """Return the random generator of a synthetic toolpath, the same in every run."""
    return np.random.default_rng([seed, sum(map(ord, kind))])


def programs(file: str) -> Iterator[Record]:
    """Yield whole programs without their comments and tool changes."""
    for r in lines(file):
        path = linearize([(name, words) for name, words in r["commands"]])
        path = replace(path, comments=(), tool_changes=np.empty(0, np.int64))
        found = []
        for first, last, label, accepted in r["sections"]:
            a, b = np.searchsorted(path.command, (first, last + 1))
            cutting = np.flatnonzero(~path.rapid[a:b]) + a
            if len(cutting):
                found.append(Section(int(cutting[0]), int(cutting[-1]), label, frozenset(accepted)))
        yield Record(r["id"], group_of(r), "", "", frozenset(), None, None, path, tuple(found))


def joined(records: list[Record], count: int) -> Iterator[Record]:
    """Yield random pairs of operations of one group, joined by rapids. The random seed is fixed."""
    rng = np.random.default_rng(1)
    by_group: dict[str, list[Record]] = {}
    for r in records:
        if r.sections:
            by_group.setdefault(r.group, []).append(r)
    able = [r for of_group in by_group.values() if len(of_group) > 1 for r in of_group]
    for _ in range(count):
        one = able[rng.integers(len(able))]
        other = [r for r in by_group[one.group] if r is not one]
        two = other[rng.integers(len(other))]
        path = after(one.path, two.path)
        moved = len(path) - len(two.path)
        s, t = one.sections[0], two.sections[0]
        second = replace(t, first=t.first + moved, last=t.last + moved)
        yield Record(f"{one.id} + {two.id}", one.group, "", "", frozenset(), None, None, path, (s, second))


def after(first: Toolpath, second: Toolpath) -> Toolpath:
    """Return one toolpath after the other, joined by rapids up, sideways and down."""
    top = max(first.points[:, 2].max(), second.points[:, 2].max())
    a, b = first.points[-1], second.points[0]
    link = np.array([(*a[:2], top), (*b[:2], top), b])
    link = link[np.abs(np.diff(np.vstack([a, link]), axis=0)).max(axis=1) > 0]

    def both(name, value):
        fill = np.full(len(link), value, getattr(first, name).dtype)
        return np.concatenate([getattr(first, name), fill, getattr(second, name)])

    return replace(
        first,
        points=np.concatenate([first.points, link, second.points[1:]]),
        rapid=both("rapid", True),
        command=np.arange(len(first) + len(link) + len(second)),
        feed=both("feed", 0.0),
        sweep=both("sweep", 0.0),
        plane=both("plane", 17),
        cycle=both("cycle", False),
        commands=len(first) + len(link) + len(second),
        comments=(),
        tool_changes=np.empty(0, np.int64),
    )
