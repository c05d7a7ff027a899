#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure all labelled operations and write the table for the learning of the recognition.

    python3 benchmarks/make_table.py FOLDER [--from https://raw.githubusercontent.com]

The script writes benchmarks/labelled_operations.csv with one row for each operation. docs/learning.md explains the
columns and how to add a program. The operations are

* operations of the programs in real_programs.csv and real_programs_unseen.csv; the script fetches programs that are
  not in FOLDER/texts,
* operations from FreeCAD, in all files FOLDER/freecad-*.jsonl.gz, which make_operations.py writes in each FreeCAD
  version,
* toolpaths made by the modules synthetic, strokes, outlines, few_moves, lathe, fine_rows and nonsense of toolpaths/.

An operation with a tool has one row with the tool and one row without it. If several rows have the same labels,
measures and proposed strategies, the table contains only one of these rows.

Programs that cannot be fetched, and FreeCAD versions without a file in FOLDER, keep their rows of the last table,
unless the measures have changed since then.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from multiprocessing import Pool
from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from fetching import HOST
from real_programs import commands, label_program, programs_of
from records import SEEDS, group_of, lines, rng_of, system_of

from toolpaths import few_moves, fine_rows, lathe, nonsense, outlines, strokes, synthetic
from vkworkbench.core import Toolpath
from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import monotonous_areas, paper_verdict
from vkworkbench.core.recognition import is_turned
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.rules import judge_section
from vkworkbench.core.strategy import Strategy

TABLE = HERE / "labelled_operations.csv"
PROGRAMS = ("real_programs.csv", "real_programs_unseen.csv")
MODULES = {module.__name__: module for module in (synthetic, strokes, outlines, few_moves, lathe)}


class Labelled(NamedTuple):
    """A labelled toolpath.

    Attributes
    ----------
    kind : str
        "program", "freecad", "made" or "nonsense".
    source, place : str
        Origin of the toolpath: the address of a file and the lines in it, or a command and a part of its output.
    group, system : str
        Repository, part or kind of toolpath, and CAM system. Toolpaths of one group or of one system are left out of
        the learning together.
    strategies : str
        The strategies that count as right, the best first, separated by spaces.
    path : Toolpath
    tool : float or None
        Diameter of the tool, mm; None if unknown.
    """

    kind: str
    source: str
    place: str
    group: str
    system: str
    strategies: str
    path: Toolpath
    tool: float | None


MADE = ("made", "nonsense")
KINDS = ("program", "freecad", *MADE)
# Largest absolute or relative difference at which two measures count as equal, because the table has four digits.
ROUNDING = 0.001
COLUMNS = (*Labelled._fields[:6], "tool", "rules", "letter")


def sources(folder: Path, host: str) -> Iterator[Callable[[], Iterable[Labelled]]]:
    """Yield for every source a function that reads or makes its labelled toolpaths."""
    for table in PROGRAMS:
        for rows in programs_of(HERE / table):
            yield partial(of_program, rows, folder, host)
    for file in sorted(folder.glob("freecad-*.jsonl.gz")):
        yield partial(of_freecad, file)
    for name, module in MODULES.items():
        for number in range(len(module.SAMPLES)):
            yield partial(of_sample, name, number)
    for way, shape in itertools.product(fine_rows.WAYS, fine_rows.SHAPES):
        yield partial(of_fine_rows, way, shape)
    for kind in nonsense.KINDS:
        yield partial(of_nonsense, kind)


def source_of(row: dict[str, str]) -> str:
    """Return the address of the program in a row of PROGRAMS."""
    return f"https://github.com/{row['repository']}/blob/{row['commit']}/{row['path']}"


def place_of(row: dict[str, str]) -> str:
    """Return the range of lines in a row of PROGRAMS."""
    return f"L{row['first_line']}-L{row['last_line']}"


def of_program(rows: list[dict[str, str]], folder: Path, host: str) -> Iterator[Labelled]:
    """Yield the labelled operations of a program."""
    _, path, found = label_program(rows, folder, host) or ("", None, [])
    for one in found:
        row = one.row
        yield Labelled(
            "program",
            source_of(row),
            place_of(row),
            row["repository"],
            system_of({"source": row["system"]}),
            row["strategies"],
            linearize(commands(path, one.first, one.end - 1)),
            one.tool,
        )


def of_freecad(file: Path) -> Iterator[Labelled]:
    """Yield the operations that make_operations.py made."""
    for r in lines(str(file)):
        path = linearize([(name, words) for name, words in r["commands"]])
        source = f"{r['source']} benchmarks/make_operations.py"
        yield Labelled(
            "freecad", source, r["id"], group_of(r), system_of(r), " ".join(r["accept"]), path, r["tool_diameter"]
        )


def of_sample(name: str, number: int) -> Iterator[Labelled]:
    """Yield the toolpaths that one function in the SAMPLES of a module of toolpaths/ makes."""
    label, accepted, make = MODULES[name].SAMPLES[number]
    best = "zigzag" if "zigzag" in accepted else "mixed" if "mixed" in accepted else min(accepted)
    strategies = " ".join([best, *sorted(accepted - {best})])
    for seed in range(SEEDS):
        made = make(rng_of(label, seed))
        program, tool = made if isinstance(made, tuple) else (made, None)
        path = linearize(program)
        yield Labelled("made", f"{name}: {label}", f"seed {seed}", label, label, strategies, path, tool)


def of_fine_rows(way: str, shape: str) -> Iterator[Labelled]:
    """Yield toolpaths whose stepover is much smaller than the tool's diameter."""
    label = f"fine rows: {way}, {shape}"
    for seed in range(SEEDS):
        rows = fine_rows.fine_rows(rng_of(label, seed), way, shape)
        source, path = f"{fine_rows.__name__}: {label}", linearize(rows.commands)
        yield Labelled("made", source, f"seed {seed}", label, label, rows.strategy, path, rows.tool)


def of_nonsense(kind: Callable) -> Iterator[Labelled]:
    """Yield nonsense toolpaths of one kind, which machine nothing."""
    name = kind.__name__
    for seed in range(SEEDS):
        path = linearize(nonsense.commands(kind, rng_of(name, seed)))
        yield Labelled("nonsense", f"{nonsense.__name__}: {name}", f"seed {seed}", name, name, "unknown", path, None)


def rows_of(one: Labelled) -> list[dict[str, str]]:
    """Return the rows of an operation with its tool and without it. Drilling is not learned and has no rows."""
    moves, rows = monotonous_areas(one.path), []
    for tool in dict.fromkeys((one.tool or 0.0, 0.0)) if len(moves) else ():
        section, paper = Section(moves, tool), paper_verdict(moves)
        rules = Strategy.UNKNOWN if is_turned(one.path) else judge_section(section).strategy
        rows.append(
            {
                **dict(zip(COLUMNS, one)),
                "tool": f"{tool:.4g}",
                "rules": rules.value,
                "letter": paper.strategy.value if paper else "unknown",
                **{name: f"{value:.4g}" for name, value in measure_section(section).items()},
            }
        )
    return rows


def rows_of_source(source: Callable[[], Iterable[Labelled]]) -> list[dict[str, str]]:
    """Return the rows of all operations of a source."""
    return [row for one in source() for row in rows_of(one)]


def identity(row: dict[str, str]) -> tuple[str, ...]:
    """Return the values of a row that identify its operation and its tool."""
    return row["source"], row["place"], row["tool"]


def values(row: dict[str, str]) -> tuple[str, ...]:
    """Return the labels of a row and all values that are computed from its toolpath."""
    return tuple(value for name, value in row.items() if name not in COLUMNS[:5])


def rows_to_keep(last: list[dict[str, str]], made: list[dict[str, str]]) -> list[dict[str, str]]:
    """Return the last table's rows whose program or FreeCAD version is not available now, with their present labels."""
    labels = {
        (source_of(row), place_of(row)): row["strategies"]
        for table in PROGRAMS
        for rows in programs_of(HERE / table)
        for row in rows
    }
    had, kept = {row["source"] for row in made}, []
    for row in last:
        label = labels.get((row["source"], row["place"])) if row["kind"] == "program" else row["strategies"]
        if row["kind"] in ("program", "freecad") and row["source"] not in had and label:
            kept.append({**row, "strategies": label})
    return kept


def changed(last: list[dict[str, str]], made: list[dict[str, str]]) -> bool:
    """Return whether a measure or proposed strategy of a toolpath from toolpaths/ differs from the last table.

    Operations of programs are not compared, because they also change when the G-code reader is corrected. The last
    digits of a measure differ between versions of numpy.
    """
    before = {identity(row): row for row in last}
    for row in made:
        if row["kind"] in MADE and (old := before.get(identity(row))):
            measures = [name for name in row if name not in COLUMNS]
            now, then = (np.array([float(one.get(name, np.nan)) for name in measures]) for one in (row, old))
            if row["rules"] != old["rules"] or not np.allclose(now, then, rtol=ROUNDING, atol=ROUNDING):
                return True
    return False


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--from", dest="host", default=HOST)
    options = parser.parse_args()
    with open(TABLE, newline="") as file:
        last = list(csv.DictReader(file))
    with Pool() as pool:
        made = [row for rows in pool.imap(rows_of_source, sources(options.folder, options.host)) for row in rows]
    kept = rows_to_keep(last, made)
    if kept and changed(last, made):
        sys.exit(
            f"The measures have changed, and the sources of {len(kept)} rows cannot be had: the table stays as it was."
        )
    found: dict[tuple[str, ...], dict[str, str]] = {}
    for row in (*made, *kept):
        found.setdefault(values(row), row)
    rows = sorted(found.values(), key=lambda row: KINDS.index(row["kind"]))
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(f"{len(kept)} rows of {len({row['source'] for row in kept})} sources that cannot be had are kept")
    print(f"{len(rows)} rows in {TABLE}")


if __name__ == "__main__":
    main()
