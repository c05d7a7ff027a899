#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure all labelled operations and write the table for the learning of the recognition.

    python3 benchmarks/make_table.py FOLDER [--from https://raw.githubusercontent.com]

Writes benchmarks/labelled_operations.csv, one row for each operation; docs/learning.md explains its columns and how to
add a program. The operations are

* operations of the programs in real_programs.csv and real_programs_unseen.csv; the command fetches programs that are not in
  FOLDER/texts,
* FreeCAD's operations, from all FOLDER/freecad-*.jsonl.gz, which make_operations.py makes in each FreeCAD,
* toolpaths made by the modules synthetic, strokes, outlines, fine_rows and nonsense of toolpaths/.

An operation with a tool has one row with the tool and one row without. Toolpaths that are the same to a micrometre have
one row.
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

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from fetching import HOST
from real_programs import commands, label_program, programs_of
from records import SEEDS, group_of, key, lines, rng_of, system_of

from toolpaths import fine_rows, nonsense, outlines, strokes, synthetic
from vkworkbench.core import Toolpath
from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import monotonous_areas, paper_verdict
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.rules import judge_section

TABLE = HERE / "labelled_operations.csv"
PROGRAMS = ("real_programs.csv", "real_programs_unseen.csv")
MODULES = {module.__name__: module for module in (synthetic, strokes, outlines)}


class Labelled(NamedTuple):
    """A labelled toolpath.

    Attributes
    ----------
    kind : str
        "program", "freecad", "made" or "nonsense".
    source, place : str
        Where it comes from: a file at an address and its lines, or a command and what of its output.
    group, system : str
        What is left out of the learning together: a repository, part or kind; or a CAM system.
    strategies : str
        The strategies that count as right, the best first, parted by spaces.
    path : Toolpath
    tool : float or None
        Diameter, mm; None if it is not known.
    """

    kind: str
    source: str
    place: str
    group: str
    system: str
    strategies: str
    path: Toolpath
    tool: float | None


COLUMNS = (*Labelled._fields[:6], "tool", "rules", "letter")


def sources(folder: Path, host: str) -> Iterator[Callable[[], Iterable[Labelled]]]:
    """Yield what reads or makes the labelled toolpaths of every source."""
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


def of_program(rows: list[dict[str, str]], folder: Path, host: str) -> Iterator[Labelled]:
    """Yield the operations of a program."""
    _, path, found = label_program(rows, folder, host) or ("", None, [])
    for one in found:
        row = one.row
        yield Labelled(
            "program",
            f"https://github.com/{row['repository']}/blob/{row['commit']}/{row['path']}",
            f"L{row['first_line']}-L{row['last_line']}",
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
    """Yield the toolpaths that one of the SAMPLES of a module makes."""
    label, accepted, make = MODULES[name].SAMPLES[number]
    best = "zigzag" if "zigzag" in accepted else "mixed" if "mixed" in accepted else min(accepted)
    strategies = " ".join([best, *sorted(accepted - {best})])
    for seed in range(SEEDS):
        path = linearize(make(rng_of(label, seed)))
        yield Labelled("made", f"{name}: {label}", f"seed {seed}", label, label, strategies, path, None)


def of_fine_rows(way: str, shape: str) -> Iterator[Labelled]:
    """Yield rows that are much closer than their tool is wide."""
    label = f"fine rows: {way}, {shape}"
    for seed in range(SEEDS):
        rows = fine_rows.fine_rows(rng_of(label, seed), way, shape)
        source, path = f"{fine_rows.__name__}: {label}", linearize(rows.commands)
        yield Labelled("made", source, f"seed {seed}", label, label, rows.strategy, path, rows.tool)


def of_nonsense(kind: Callable) -> Iterator[Labelled]:
    """Yield toolpaths of a kind that machines nothing."""
    name = kind.__name__
    for seed in range(SEEDS):
        path = linearize(nonsense.commands(kind, rng_of(name, seed)))
        yield Labelled("nonsense", f"{nonsense.__name__}: {name}", f"seed {seed}", name, name, "unknown", path, None)


def rows_of(one: Labelled) -> list[tuple[bytes, dict[str, object]]]:
    """Return the rows of an operation, with its tool and without, and what equal toolpaths of one tool have in common.

    Drilling has none: it needs no vote.
    """
    moves, rows = monotonous_areas(one.path), []
    for tool in dict.fromkeys((one.tool or 0.0, 0.0)) if len(moves) else ():
        section, paper = Section(moves, tool), paper_verdict(moves)
        row = {
            **dict(zip(COLUMNS, one)),
            "tool": f"{tool:.4g}",
            "rules": judge_section(section).strategy.value,
            "letter": paper.strategy.value if paper else "unknown",
            **{name: f"{value:.4g}" for name, value in measure_section(section).items()},
        }
        rows.append((key(one.path, tool), row))
    return rows


def rows_of_source(source: Callable[[], Iterable[Labelled]]) -> list[tuple[bytes, dict[str, object]]]:
    """Return the rows of all operations of a source."""
    return [row for one in source() for row in rows_of(one)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--from", dest="host", default=HOST)
    options = parser.parse_args()
    found: dict[bytes, dict[str, object]] = {}
    with Pool() as pool:
        for rows in pool.imap(rows_of_source, sources(options.folder, options.host)):
            for same, row in rows:
                found.setdefault(same, row)
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, list(next(iter(found.values()))), lineterminator="\n")
        writer.writeheader()
        writer.writerows(found.values())
    print(f"{len(found)} rows in {TABLE}")


if __name__ == "__main__":
    main()
