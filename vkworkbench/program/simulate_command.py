# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option ``--simulate`` of the command ``python3 -m vkworkbench``."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from vkworkbench.core import Stock
from vkworkbench.language import Unusable
from vkworkbench.program.simulation import simulate
from vkworkbench.report import printable

_LONGEST = 1000  # maximum length of a path in the output, characters


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the simulation to a parser."""
    group = parser.add_argument_group("simulation")
    group.add_argument(
        "--simulate", action="store_true", help="simulate the programs: collisions, crashes, removal rates"
    )
    group.add_argument(
        "--stock",
        type=_stock,
        metavar="X0,Y0,Z0,X1,Y1,Z1",
        help="lowest and highest corner of the stock, mm (default: a box around the cuts)",
    )
    group.add_argument("--png", metavar="FILE", help="write a picture of the part")
    group.add_argument("--stl", metavar="FILE", help="write the part as an STL file")


def with_joined_stock(arguments: Iterable[str]) -> list[str]:
    """Return the arguments with ``--stock`` joined to its value, because the value may begin with a minus sign."""
    joined: list[str] = []
    for argument in arguments:
        if joined and joined[-1] == "--stock":
            joined[-1] = f"--stock={argument}"
        else:
            joined.append(argument)
    return joined


def _stock(text: str) -> Stock:
    with suppress(ValueError):
        corners = [float(number) for number in text.split(",")]
        if len(corners) == 6:
            return Stock(corners[:3], corners[3:])
    raise argparse.ArgumentTypeError(
        f"invalid value {text!r}: it takes six numbers of mm, the lowest and the highest corner of a box"
    )


def check_options(asked: argparse.Namespace, programs: int) -> str | None:
    """Return the error in the options of the simulation as text; None if the options are valid."""
    if not asked.simulate:
        options = [name for name in ("stock", "png", "stl") if getattr(asked, name) is not None]
        return f"--{options[0]} needs --simulate" if options else None
    if asked.csv or asked.json_lines:
        return "--simulate prints its facts: leave out --csv and --json-lines"
    if asked.machine is not None:
        return "--simulate plans no times: leave out --machine"
    for name in ("png", "stl"):
        path = getattr(asked, name)
        if path is not None and programs > 1:
            return f"--{name} takes one program, not {programs}"
        if path is not None and Path(path).suffix.lower() != f".{name}":
            return f"the name of the file of --{name} must end with .{name}, unlike {path}"
        if path is not None and not Path(path).parent.is_dir():
            return f"cannot write {path}: there is no folder {Path(path).parent}"
    return None


def simulate_programs(paths: Iterable[Path], asked: argparse.Namespace) -> int:
    """Simulate programs, print the facts of each, and return the number of programs that could not be simulated.

    An OSError is raised if the picture or the solid cannot be written.
    """
    failed = 0
    for path in paths:
        print(printable(str(path), _LONGEST))
        try:
            done = simulate(path, stock=asked.stock)
            print(f"{done.facts()}\n", flush=True)
        except Unusable as error:
            print(f"{error}\n", flush=True)
            failed += 1
            continue
        if asked.png is not None:
            done.save_png(asked.png)
        if asked.stl is not None:
            done.save_stl(asked.stl)
    return failed
