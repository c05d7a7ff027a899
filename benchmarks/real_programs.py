#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fetch other people's labelled programs, and write files for benchmarks/recognition.py.

    python3 benchmarks/real_programs.py FOLDER [--table benchmarks/real_programs_unseen.csv] [--from
    https://raw.githubusercontent.com]

real_programs.csv names programs in public repositories, the lines of each operation, and the strategies that count as
right. People labelled the operations from titles and plots, before they saw the recognised strategies. The rules were
written with the programs of real_programs.csv, but without the programs of real_programs_unseen.csv. The model is
learned from the programs of both tables (make_table.py). The programs belong to their owners and stay in FOLDER,
together with operations.jsonl.gz and programs.jsonl.gz. The file told.jsonl.gz contains the operations whose tool is
stated in the program, with the tool's diameter. The script leaves out programs that cannot be fetched or whose text has
changed, and prints their names.
"""

from __future__ import annotations

import argparse
import gzip
import itertools
import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fetching import HOST, fetch, rows_of

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent)]

from vkworkbench.core import Toolpath
from vkworkbench.core.gcode import Section, read_program, split_sections
from vkworkbench.language import Unusable


def commands(path: Toolpath, first: int, last: int) -> list[tuple[str, dict[str, float]]]:
    """Return the straight trajectories from `first` to `last` as commands, after a rapid to the start of `first`."""
    to = [dict(zip("XYZ", map(float, point))) for point in path.points[first : last + 2].round(6)]
    moves = zip(path.rapid[first : last + 1], to[1:], path.feed[first : last + 1])
    return [("G0", to[0]), *(("G0" if rapid else "G1", {**at, "F": float(feed)}) for rapid, at, feed in moves)]


def told_diameter(titled: Sequence[Section], path: Toolpath, first: int, end: int) -> float | None:
    """Return the diameter, mm, that the program states for the tool in the middle of an operation's cuts."""
    cuts = first + np.flatnonzero(~path.rapid[first:end])
    middle = path.command[cuts[len(cuts) // 2]] if len(cuts) else -1
    return next((s.tool.diameter for s in titled if s.tool and s.first <= middle <= s.last), None)


@dataclass(frozen=True)
class Labelled:
    """One labelled operation of a program.

    Attributes
    ----------
    row : dict of str
        The operation's row in the table.
    first, end : int
        The operation consists of the program's trajectories from `first` to `end` - 1.
    tool : float or None
        Diameter of the tool that the program states, mm; None if unknown.
    """

    row: dict[str, str]
    first: int
    end: int
    tool: float | None


def programs_of(table: Path) -> Iterator[list[dict[str, str]]]:
    """Yield the rows of every program of a table."""
    for _, rows in itertools.groupby(rows_of(table), key=lambda row: (row["repository"], row["path"], row["commit"])):
        yield list(rows)


def label_program(
    rows: list[dict[str, str]], folder: Path, host: str = HOST
) -> tuple[str, Toolpath, list[Labelled]] | None:
    """Return the name, the toolpath and the labelled operations of a program that is in FOLDER or at HOST.

    Return None and print an error if the program is not available. Also print an error for lines without moves.
    """
    name = f"{rows[0]['repository'].replace('/', '_')}__{rows[0]['commit'][:7]}/{rows[0]['path']}"
    try:
        program = read_program(fetch(rows[0], folder, host).read_text("utf-8", "replace"))
    except (OSError, Unusable) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return None
    path, titled, found = program.toolpath(), split_sections(program), []
    for row in rows:
        first, end = np.searchsorted(path.command, (int(row["first_line"]), int(row["last_line"]) + 1)).tolist()
        if first == end:
            print(f"{name}: nothing moves in lines {row['first_line']} to {row['last_line']}", file=sys.stderr)
        else:
            found.append(Labelled(row, first, end, told_diameter(titled, path, first, end)))
    return name, path, found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--table", type=Path, default=HERE / "real_programs.csv")
    parser.add_argument("--from", dest="host", default=HOST)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    count = 0
    into = [options.folder / f"{name}.jsonl.gz" for name in ("operations", "programs", "told")]
    with ExitStack() as files:
        operations, programs, told = (files.enter_context(gzip.open(file, "wt")) for file in into)
        for rows in programs_of(options.table):
            if not (labelled := label_program(rows, options.folder, options.host)):
                continue
            (name, path, found), sections = labelled, []
            for one in found:
                accept = one.row["strategies"].split()
                record = {
                    "id": f"{name}:{one.row['first_line']}", "group": one.row["repository"], "source": one.row["system"],
                    "label": accept[0], "strategy": accept[0], "accept": accept, "tool_diameter": None,
                    "commands": commands(path, one.first, one.end - 1),
                }  # fmt: skip
                operations.write(json.dumps(record) + "\n")
                if one.tool:
                    told.write(json.dumps({**record, "tool_diameter": one.tool}) + "\n")
                sections.append([one.first + 1, one.end, accept[0], accept])
            count += len(sections)
            whole = {
                "id": name, "group": found[0].row["repository"] if found else name,
                "commands": commands(path, 0, len(path) - 1), "sections": sections,
            }  # fmt: skip
            programs.write(json.dumps(whole) + "\n")
    rows = rows_of(options.table)
    named = len({(row["repository"], row["path"], row["commit"]) for row in rows})
    print(
        f"{len(rows)} sections of {named} programs in {len({row['repository'] for row in rows})} repositories are named"
    )
    print(f"{count} of {len(rows)} labelled operations are in {into[0]}")


if __name__ == "__main__":
    main()
