# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``python3 -m vkworkbench``, which analyses NC programs on all cores or on a Dask cluster."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import closing, contextmanager, suppress
from itertools import islice
from pathlib import Path

from vkworkbench import preferences
from vkworkbench.core import MACHINES
from vkworkbench.language import Message
from vkworkbench.program.analysis import report_of, unread
from vkworkbench.program.apart import analyze_apart, end_workers
from vkworkbench.program.files import find_programs, is_called_a_program
from vkworkbench.program.progress import Progress
from vkworkbench.program.results import Csv, JsonLines, Results
from vkworkbench.program.simulate_command import add_options, check_options, simulate_programs, with_joined_stock
from vkworkbench.report import OperationReport, cells_of, files_left_out, how_many, printable
from vkworkbench.worker import processes

_WRONG, _UNREAD, _STOPPED = 2, 1, 130  # Exit statuses of the command.
_CONNECT = 30  # Time limit for connecting to a Dask scheduler, s.
_MOST_PROCESSES = 256  # Most systems can start as many processes and threads.
_AHEAD = 4  # Number of files that are submitted to the executor at the same time, for each process.
_STANDARD_OUTPUT = "-"
# Names of files that only this process can open, such as the shell's <(...). Names such as <(...) are refused, because
# programs are read in other processes.
_STANDARD_INPUT = re.compile(r"-|/dev/stdin|/(?:dev|proc/self)/fd/\d+")


class _Wrong(Exception):
    """The command cannot be carried out, or not completely."""


def main(arguments: list[str] | None = None) -> int:
    """Run the command, and return its exit status.

    The status is 0 if all programs were read, 1 if some programs could not be read, 2 if nothing could be done or the
    results could not be written, and 130 if the user stopped the command with Ctrl-C.
    """
    asked = _parser().parse_args(with_joined_stock(sys.argv[1:] if arguments is None else arguments))
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # the stream is closed, for example by ">&-", or there is no console
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))
        getattr(sys, name).reconfigure(errors="backslashreplace")
    try:
        return _run(asked)
    except _Wrong as error:
        print(f"vkworkbench: {error}", file=sys.stderr)
        return _WRONG
    except (KeyboardInterrupt, BrokenPipeError):  # the program that reads the output, such as "| head", has ended
        return _STOPPED
    finally:
        _drop_unwritten()


def _drop_unwritten() -> None:
    """Discard output that cannot be written.

    If output cannot be written and is not discarded, Python prints an error when it exits.
    """
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        "vkworkbench",
        description="Recognize the machining strategy of each operation in NC programs (G-code), and estimate the cost of "
        "its simulation, or simulate them.",
        epilog="Exit status: 0: all programs were read. 1: some programs could not be read. 2: nothing could be done, or the "
        "results could not be written. 130: stopped.",
    )
    parser.add_argument("what", nargs="+", metavar="FILE|FOLDER", help="NC programs, and folders with NC programs")
    output = parser.add_mutually_exclusive_group()
    output.add_argument("--csv", metavar="PATH", help="write a CSV file instead of a table; - is the standard output")
    output.add_argument("--json-lines", metavar="PATH", help="write one JSON object per line instead of a table")
    parser.add_argument("--resume", action="store_true", help="continue the results in PATH")
    parser.add_argument("--jobs", type=_positive(int), metavar="N", help="number of processes (default: one per core)")
    parser.add_argument(
        "--timeout",
        type=_positive(float),
        default=600.0,
        metavar="SECONDS",
        help="time limit for each program (default: 600)",
    )
    parser.add_argument(
        "--machine",
        metavar="NAME|FILE",
        help=f"plan machining times for a machine: {', '.join(MACHINES)}, or a file with grbl's settings ($$)",
    )
    parser.add_argument("--scheduler", metavar="ADDRESS", help="use a Dask cluster, e.g. tcp://host:8786")
    add_options(parser)
    return parser


def _positive(kind):
    def number(text: str):
        with suppress(ValueError):
            value = kind(text)
            if 0 < value < float("inf"):
                return value
        wanted = "a whole number" if kind is int else "a number"
        raise argparse.ArgumentTypeError(f"invalid value {text!r}: it takes {wanted} above 0")

    return number


def _run(asked: argparse.Namespace) -> int:
    if any(map(_STANDARD_INPUT.fullmatch, asked.what)):
        raise _Wrong("standard input is not read: give a file")
    try:
        left_out: list[Path] = []
        paths = [Path(os.path.abspath(path)) for path in find_programs(asked.what, left_out)]
    except ValueError as error:
        raise _Wrong(str(error)) from None
    if left_out:
        print(files_left_out(map(str, left_out)), file=sys.stderr)
    if not paths:
        raise _Wrong(f"no NC programs in {', '.join(asked.what)}")
    try:
        chosen = preferences.read().for_machine(asked.machine)
    except ValueError as error:
        raise _Wrong(str(error)) from None
    wrong = check_options(asked, len(paths))
    if wrong:
        raise _Wrong(wrong)
    if asked.simulate:
        with _writing(asked.stl or asked.png or _STANDARD_OUTPUT):
            return _UNREAD if simulate_programs(paths, asked) else 0
    # The executor is created before the file of results is opened. If the executor cannot be created, existing results
    # are not lost.
    with _executor(asked, len(paths)) as (executor, ahead):
        return _work(asked, paths, executor, ahead, chosen)


def _work(
    asked: argparse.Namespace, paths: list[Path], executor: Executor, ahead: int, chosen: preferences.Preferences
) -> int:
    """Analyse the programs, write the results, and return the exit status."""
    results = _results(asked, paths)
    place = asked.csv or asked.json_lines or _STANDARD_OUTPUT
    advice = "" if place == _STANDARD_OUTPUT else "; continue with --resume"
    todo = [path for path in paths if results is None or not results.has(path)]
    progress = Progress(todo, sys.stderr)
    operations, unread_files, stopped = 0, 0, False
    try:
        with closing(_analyzed(todo, executor, ahead, asked.timeout, chosen)) as analyzed:
            for path, rows in analyzed:
                progress.add(path)
                with _writing(place, advice):
                    if results is None:
                        progress.clear()
                        _show(path, rows)
                    else:
                        results.add(rows)
                operations += sum(row.counted for row in rows)
                unread_files += not rows[0].counted  # a file that cannot be read has one row, which is not counted
    except KeyboardInterrupt:
        stopped = True
    finally:
        progress.clear()
        if results is not None:
            with _writing(place, advice):
                results.close()
    if stopped:
        print(f"Stopped after {progress.files} of {len(todo)} files{advice}.", file=sys.stderr)
        return _STOPPED
    before = f", {how_many(len(paths) - len(todo), 'file')} done before" if len(todo) < len(paths) else ""
    unread_before = sum(map(results.has_unread, paths)) if results is not None else 0
    if unread_before:
        before += f", {unread_before} of them could not be read"
    not_read = f", {unread_files} could not be read" if unread_files else ""
    print(f"{how_many(operations, 'operation')} in {how_many(len(todo), 'file')}{not_read}{before}.", file=sys.stderr)
    return _UNREAD if unread_files or unread_before else 0


def _results(asked: argparse.Namespace, programs: list[Path]) -> Results | None:
    """Return the file of results that receives the rows, or None if a table is printed."""
    path = asked.csv or asked.json_lines
    if asked.resume and path in (None, _STANDARD_OUTPUT):
        raise _Wrong("--resume needs a file of results: --csv PATH or --json-lines PATH")
    if path is None:
        return None
    if is_called_a_program(path):  # "--csv bracket.nc old-programs/" would overwrite a program
        raise _Wrong(f"{path} has the suffix of an NC program: give the file of results another name")
    if any(_is_same_file(path, program) for program in programs):
        raise _Wrong(f"{path} is one of the programs: give the file of results another name")
    any_row = unread(Path(), Message("moves-nothing"))
    form = Csv(cells_of(any_row)) if asked.csv else JsonLines()
    try:
        with _writing(path):
            return Results(path, form, resume=asked.resume)
    except ValueError as error:
        raise _Wrong(f"cannot continue {path}: {error}") from None


@contextmanager
def _writing(path: str, advice: str = "") -> Iterator[None]:
    """Convert errors of writing to `path` into `_Wrong`, with advice on how to continue."""
    try:
        yield
    except BrokenPipeError:
        raise
    except OSError as error:
        name = "the standard output" if path == _STANDARD_OUTPUT else path
        raise _Wrong(f"cannot write {name}: {error.strerror}{advice}") from None


def _is_same_file(one: str, other: Path) -> bool:
    with suppress(OSError):
        return os.path.samefile(one, other)
    return False


@contextmanager
def _executor(asked: argparse.Namespace, files: int) -> Iterator[tuple[Executor, int]]:
    """Yield an executor, and the number of files that may be submitted to it at the same time."""
    if asked.scheduler:
        with _cluster(asked.scheduler) as both:
            yield both
        return
    jobs = min(asked.jobs or processes(), files, _MOST_PROCESSES)
    executor = ThreadPoolExecutor(jobs)  # each thread starts a process, and waits for the results of this process
    try:
        yield executor, _AHEAD * jobs
    finally:
        executor.shutdown(wait=False)
        end_workers()


@contextmanager
def _cluster(address: str) -> Iterator[tuple[Executor, int]]:
    try:
        from distributed import Client
    except ImportError:
        raise _Wrong("--scheduler needs Dask: install python3-distributed (Debian) or distributed (PyPI)") from None
    try:
        client = Client(address, timeout=_CONNECT)
    except (OSError, ValueError) as error:
        raise _Wrong(f"no Dask scheduler at {address}: {error}") from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise _Wrong(f"the Dask scheduler at {address} has no workers")
        executor = client.get_executor(pure=False)
        try:
            yield executor, _AHEAD * threads
        finally:
            executor.shutdown(wait=False)


def _analyzed(
    paths: Iterable[Path], executor: Executor, ahead: int, patience: float, chosen: preferences.Preferences
) -> Iterator[tuple[Path, tuple[OperationReport, ...]]]:
    """Yield each program with its rows as soon as it is analysed.

    If the caller closes the iterator, the programs that still wait are not analysed.
    """
    rest = iter(paths)
    pending: dict[Future, Path] = {}
    try:
        while True:
            for path in islice(rest, ahead - len(pending)):
                pending[executor.submit(analyze_apart, path, chosen, patience)] = path
            if not pending:
                return
            ready = wait(pending, return_when=FIRST_COMPLETED).done
            # `pending` keeps the order of submission, `ready` is an unordered set.
            for future in [future for future in pending if future in ready]:
                path = pending.pop(future)
                yield path, _rows(path, future)
    finally:
        for future in pending:
            future.cancel()


def _rows(path: Path, future: Future) -> tuple[OperationReport, ...]:
    """Return the rows of a program, or one row if the analysis failed, as when a computer has left the cluster."""
    try:
        return future.result()
    except ModuleNotFoundError as error:
        raise _Wrong(f"the workers of the cluster cannot load this add-on: {error}") from None
    except Exception as error:
        return (unread(path, Message("not-analysed", error=f"{type(error).__name__}: {error}")),)


def _show(path: Path, rows: tuple[OperationReport, ...]) -> None:
    shown = report_of(rows, preferences.read()) if rows[0].counted else rows[0].error
    print(f"{printable(str(path), sys.maxsize)}\n{shown}\n", flush=True)
