# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutation testing: change one place in a file, run the tests that reach its line, and check whether a test fails.

    python3 tests/mutate.py [FILES] [--count 20] [--seed 0] [--jobs 2] [--tests TESTS ...]

FILES are files and folders of vkworkbench, by default everything except the window and freecad.py. COUNT mutants are
drawn from each file (all with --count 0). Rows of three or more numbers, such as colours and measured times, are not
mutated. A file is tested by the tests of its package (its "room"): tests/core/ROOM, or tests/document inside this
machine's FreeCAD. --tests selects fewer tests, which is quicker while tests are written. Tests that only start other
programs are left out, because a mutant does not reach the other programs. A mutant is killed if a test fails or needs
far more processor time than without the mutant.

Prints the share of killed mutants by file and by folder, as a table for docs/reliability.md, and writes the surviving
mutants to the error output. The share is a lower bound: tests of other rooms may kill more mutants, and some mutants do
not change the behaviour. The mutants are written to copies of the checkout, never to the checkout itself.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[1]
DRAWN_FROM = "core", "document", "language", "program", "report", "preferences.py", "worker.py"
COPIED = "vkworkbench", "tests", "toolpaths", "examples", "resources", "docs", "benchmarks", "pyproject.toml"
COPIED += "package.xml", "Init.py", "InitGui.py", "README.md"
# Additional tests from other rooms (packages), for the files that belong to no room and for the reports.
OF_OTHER_ROOMS = {
    **{file: ["tests/core/zbuffer"] for file in ("hull", "solids", "stocks", "tool", "view")},
    "report": ["tests/core/program"],
}
# Modules that are tested inside FreeCAD.
IN_FREECAD = "document", "preferences"
# Tests that start another FreeCAD process, which is not affected by a mutant.
ELSEWHERE = "test_vk_release.py", "test_vk_show_example.py"
LEAST_SECONDS = 30
SWAPS = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult,
    ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip
TURNED = {ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE, ast.GtE: ast.Lt}
NAMES = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "any": "all", "all": "any"}


class Mutant(NamedTuple):
    """A change of one place in a file."""

    line: int
    what: str
    text: str  # text of the whole file after the change


def mutants(source: str) -> list[Mutant]:
    """Return all mutants of a file."""
    tree = ast.parse(source)
    lines = source.splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line.encode()))
    data = source.encode()
    found = []
    for node in _mutable(tree):
        for other in _changes(node):
            begin, end = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
            old, new = data[begin:end].decode(), ast.unparse(other)
            if isinstance(other, ast.expr) and not isinstance(other, (ast.Constant, ast.Name, ast.Attribute)):
                new = f"({new})"
            text = (data[:begin] + new.encode() + data[end:]).decode()
            shown = f"{' '.join(old.split())} -> {new}"
            found.append(Mutant(node.lineno, shown, text))
    return [mutant for mutant in found if _compiles(mutant.text)]


def _mutable(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes that determine behaviour, without annotations, docstrings and message texts."""
    todo = list(ast.iter_child_nodes(tree))
    while todo:
        node = todo.pop()
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue  # skip docstrings
        if isinstance(node, (ast.JoinedStr, ast.Raise)):
            continue  # do not mutate the texts of messages
        if isinstance(node, (ast.Tuple, ast.List)) and _is_row(node.elts):
            continue  # skip rows of numbers, such as colours, because a test could only repeat the numbers
        yield node
        for name, value in ast.iter_fields(node):
            if name not in ("annotation", "returns", "decorator_list"):
                todo += [one for one in (value if isinstance(value, list) else [value]) if isinstance(one, ast.AST)]


def _is_row(elements: list[ast.expr]) -> bool:
    """Return whether a sequence contains at least three numbers, and otherwise only names and starred expressions."""
    numbers = sum(map(_is_number, elements))
    return numbers > 2 and numbers + sum(isinstance(one, (ast.Name, ast.Starred)) for one in elements) == len(elements)


def _is_number(node: ast.AST) -> bool:
    sign = isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub)
    value = node.operand if sign else node
    return isinstance(value, ast.Constant) and isinstance(value.value, (int, float))


def _changes(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the changed copies of a node."""
    other = copy.deepcopy(node)
    if isinstance(node, ast.Compare):
        kind = type(node.ops[0])
        # A measured length never equals a threshold exactly, so < and <= are swapped only in comparisons of counts.
        tables = (SWAPS, TURNED) if kind not in TURNED or _counts(node) else (TURNED,)
        for table in tables:
            if kind in table:
                other.ops[0] = table[kind]()
                yield copy.deepcopy(other)
    elif isinstance(node, (ast.BinOp, ast.BoolOp, ast.AugAssign)) and type(node.op) in SWAPS:
        other.op = SWAPS[type(node.op)]()
        yield other
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub, ast.Invert)):
        yield other.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        other.value = not node.value
        yield other
    elif isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        other.value = node.value + 1 if isinstance(node.value, int) else node.value * 2 if node.value else 1.0
        yield other
    elif isinstance(node, ast.Name) and node.id in NAMES:
        other.id = NAMES[node.id]
        yield other
    elif isinstance(node, ast.Attribute) and node.attr in NAMES:
        other.attr = NAMES[node.attr]
        yield other
    elif isinstance(node, ast.Return) and node.value is not None and not isinstance(node.value, ast.Constant):
        other.value = ast.Constant(None)
        yield other


def _counts(node: ast.Compare) -> bool:
    """Return whether a comparison visibly compares whole numbers: an integer constant or a call of len()."""
    return any(
        (isinstance(side, ast.Constant) and isinstance(side.value, int))
        or (isinstance(side, ast.Call) and isinstance(side.func, ast.Name) and side.func.id == "len")
        for side in (node.left, *node.comparators)
    )


def _compiles(text: str) -> bool:
    try:
        compile(text, "mutant", "exec")
    except SyntaxError:
        return False
    return True


def tests_of(file: Path) -> list[str]:
    """Return the tests of a file's room as arguments for pytest."""
    parts = file.relative_to(ROOT / "vkworkbench").with_suffix("").parts
    in_freecad = parts[0] in IN_FREECAD
    rooms = [folder for folder in parts[:-1] if folder != "core"]
    if rooms and not in_freecad:
        return [f"tests/core/{rooms[0]}", *OF_OTHER_ROOMS.get(rooms[0], [])]
    own = sorted((ROOT / "tests" / ("document" if in_freecad else "core")).glob("test_vk_*.py"))
    here = [str(path.relative_to(ROOT)) for path in own if path.name not in ELSEWHERE]
    return here if in_freecad else here + OF_OTHER_ROOMS.get(file.stem, [])


class Checkout:
    """A copy of the checkout in which tests are run."""

    def __init__(self, folder: Path) -> None:
        self.root = folder / "checkout"
        self.home = folder / "home"
        self.written = 0
        for name in COPIED:
            kind = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
            self.root.mkdir(parents=True, exist_ok=True)
            kind(ROOT / name, self.root / name)
        subprocess.run([str(self.root / "tests/make_home.sh"), str(self.home)], check=True)

    def run(self, tests: list[str], *, limit: float | None = None, **asked: Any) -> bool:
        """Return whether the tests pass. tests/mutate_plugin.py reads the requests `asked`."""
        told = self.home / "asked.json"  # a file, because the requests are too long for a command line
        told.write_text(json.dumps({"only": [], "reached": "", "tries": [], **asked}))
        environment = {
            **os.environ, "HOME": str(self.home), "PYTHONPATH": "tests", "MUTATE": str(told),
            "HYPOTHESIS_STORAGE_DIRECTORY": str(self.home / "hypothesis"),
        }  # fmt: skip
        arguments = ["-q", "-p", "mutate_plugin", *([] if asked.get("reached") else ["-x"]), *tests]
        command = ["/usr/bin/python3", "-m", "pytest", *arguments]
        if "document" in tests[0]:
            command = ["freecadcmd", "tests/in_freecad.py"]
            environment["PYTEST_ADDOPTS"] = " ".join(f"'{argument}'" for argument in arguments)
        try:
            ended = subprocess.run(
                command, cwd=self.root, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=limit
            )
        except subprocess.TimeoutExpired:
            return False
        if ended.returncode and limit is None:
            sys.exit(f"the tests fail without a mutant: {ended.stdout.decode()[-2000:]}")
        return ended.returncode == 0

    def reach(self, tests: tuple[str, ...]) -> dict[str, Any]:
        """Return the lines of each file that each test reaches, and the duration of each test, s."""
        found = self.home / "reached.json"
        self.run(list(tests), reached=str(found))
        return json.loads(found.read_text())

    def graft(self, file: Path, tries: list[tuple[Mutant, dict[str, float]]], jobs: int) -> list[bool | None]:
        """Return for each mutant whether it survives its tests, all in one process.

        The value None means that the tests of the mutant need a new process.
        """
        if not tries:
            return []
        only = sorted({test for _, tests in tries for test in tests})
        found = self.home / "lives.json"
        told = [{"text": mutant.text, "tests": tests} for mutant, tests in tries]
        files = sorted({test.partition("::")[0] for test in only})
        own = str(self.root / file.relative_to(ROOT))
        self.run(files, only=only, tries=told, file=own, jobs=jobs, out=str(found))
        return [{0: True, 1: False}.get(status) for status in json.loads(found.read_text())]

    def lives(self, mutant: Mutant, file: Path, tests: list[str], limit: float) -> bool:
        """Return whether the tests pass while a mutant replaces its file."""
        own = self.root / file.relative_to(ROOT)
        original = own.read_text(encoding="utf-8")
        self._write(own, mutant.text)
        try:
            return self.run(sorted({test.partition("::")[0] for test in tests}), only=tests, limit=limit)
        finally:
            self._write(own, original)

    def _write(self, file: Path, text: str) -> None:
        """Write a source file with a new time stamp, so that Python does not reuse compiled code of the former text."""
        file.write_text(text, encoding="utf-8")
        self.written += 1
        os.utime(file, (self.written, self.written))


def sample(file: Path, count: int, seed: int) -> list[Mutant]:
    """Return randomly drawn mutants of a file, identical for equal seeds."""
    every = mutants(file.read_text(encoding="utf-8"))
    chosen = random.Random(f"{seed} {file.name}")
    return every if not count or len(every) <= count else chosen.sample(every, count)


def judge(file: Path, drawn: list[Mutant], known: dict[str, Any], checkout: Checkout, jobs: int) -> list[Mutant]:
    """Return the surviving mutants. `known` is the result of `Checkout.reach`."""
    name = str(checkout.root / file.relative_to(ROOT))
    quickest = sorted(known["seconds"], key=known["seconds"].get)
    reached = known["reached"].get(name, {})
    tries, anew, alive = [], [], []
    for mutant in drawn:
        tests = [test for test in quickest if mutant.line in reached.get(test, ())]
        # A line that no test reaches runs during an import or in another process, so any test may depend on it.
        (tries if tests else anew).append((mutant, tests or quickest))
    told = [(mutant, {test: known["seconds"][test] for test in tests}) for mutant, tests in tries]
    for (mutant, tests), lives in zip(tries, checkout.graft(file, told, jobs)):
        if lives is None:  # the mutant changes only code that runs during the import
            anew.append((mutant, tests))
        elif lives:
            alive.append(mutant)
    # A mutant that affects an import or another process takes effect only if the tests are started again.
    for mutant, tests in anew:
        if checkout.lives(mutant, file, tests, LEAST_SECONDS + 10 * sum(map(known["seconds"].get, tests))):
            alive.append(mutant)
    return sorted(alive, key=lambda mutant: mutant.line)


def by_folder(rates: dict[Path, tuple[int, int]]) -> Iterator[str]:
    """Yield the lines of the table in docs/reliability.md. `rates` are the killed and drawn mutants of each file."""
    yield "| folder | files | noticed | drawn | rate | below nine in ten |\n|---|---:|---:|---:|---:|---|"
    folders = {
        folder: [file for file in rates if file.parent == folder] for folder in sorted({f.parent for f in rates})
    }
    for folder, files in folders.items():
        below = [file for file in files if rates[file][0] < 0.9 * rates[file][1]]
        alike = groupby(sorted(below, key=rates.get), key=rates.get)
        told = "; ".join(f"{', '.join(f'`{file.name}`' for file in own)} {rate[0]} of {rate[1]}" for rate, own in alike)
        yield f"| `{folder / '*.py'}` | {_told(rates, files)} | {told or 'none'} |"
    yield f"| all | {_told(rates, list(rates))} | |"


def _told(rates: dict[Path, tuple[int, int]], files: list[Path]) -> str:
    killed, total = (sum(numbers) for numbers in zip(*(rates[file] for file in files)))
    return f"{len(files)} | {killed} | {total} | {killed / total:.2f}"


def main() -> int:
    """Print the surviving mutants and the shares of killed mutants."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tests", nargs="+")
    chosen = parser.parse_args()
    roots = [file.resolve() for file in chosen.files] or [ROOT / "vkworkbench" / one for one in DRAWN_FROM]
    files = [file for root in roots for file in (sorted(root.rglob("*.py")) if root.is_dir() else [root])]
    rates = {}
    print("| file | noticed | drawn |\n|---|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        checkout = Checkout(Path(folder))
        known = cache(checkout.reach)
        for file in files:
            drawn = sample(file, chosen.count, chosen.seed)
            if not drawn:
                continue
            alive = judge(file, drawn, known(tuple(chosen.tests or tests_of(file))), checkout, chosen.jobs)
            name = file.relative_to(ROOT)
            for mutant in alive:
                print(f"    {name}:{mutant.line}: {mutant.what}", file=sys.stderr)
            name = name.relative_to("vkworkbench")
            print(f"| `{name}` | {len(drawn) - len(alive)} | {len(drawn)} |", flush=True)
            rates[name] = len(drawn) - len(alive), len(drawn)
    if rates:
        print("", *by_folder(rates), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
