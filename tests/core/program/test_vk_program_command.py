# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line as a user runs it, with real processes, files and signals."""

import csv
import io
import json
import lzma
import os
import resource
import shlex
import signal
import socket
import subprocess
import sys
import threading
import time
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import pytest
from traps import lay_traps

from vkworkbench import worker
from vkworkbench.preferences import Preferences
from vkworkbench.program import apart, command_line, main
from vkworkbench.program.analysis import analyze_file

ROOT = Path(__file__).resolve().parents[3]
ROWS = "".join(f"G1 X{40 * (k % 2)}\nY{k + 1}\n" for k in range(20))
PROGRAM = f"(T1 D=6. CR=0. - flat end mill)\nG21\n(Face)\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F600\n{ROWS}G0 Z5\nM30\n"
NAMES = "abcd"  # Names of the programs, without the suffix .nc. The file b.nc is not text.
LONG = "G0 X0 Y0 Z5\nG1 Z-1 F600\n" + "X1\nX2\n" * 200_000


@pytest.fixture
def folder(tmp_path):
    folder = tmp_path / "programs"
    folder.mkdir()
    for name in NAMES:
        (folder / f"{name}.nc").write_text(PROGRAM)
    (folder / "b.nc").write_bytes(b"\0\1\2")
    return folder


# This code makes the opening of the file endless.nc wait forever, as on a file server that does not answer.
NEVER_OPENS = """
import builtins, time
opened = builtins.open
def wait_or_open(file, *arguments, **named):
    while str(file).endswith("endless.nc"):
        time.sleep(1)
    return opened(file, *arguments, **named)
builtins.open = wait_or_open
"""


@pytest.fixture
def endless(tmp_path, monkeypatch):
    """Return a program that processes started by this test never finish reading."""
    path = tmp_path / "hook" / "endless.nc"
    path.parent.mkdir()
    path.write_text(PROGRAM)
    patched = f"from vkworkbench import worker\nworker._START = {NEVER_OPENS!r} + worker._START\n"
    # Python runs this file when the command or a Dask worker starts.
    path.with_name("sitecustomize.py").write_text(patched)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(path.parent), str(ROOT)]))
    monkeypatch.setattr("vkworkbench.worker._START", NEVER_OPENS + worker._START)
    return path


def command(*arguments):
    return [sys.executable, "-m", "vkworkbench", *map(str, arguments)]


def run(*arguments, **options):
    return subprocess.run(command(*arguments), capture_output=True, text=True, cwd=ROOT, timeout=120, **options)


@pytest.fixture
def inside(capsys, monkeypatch):
    """Run the command and its analyses in this process, for tests that need no separate processes."""
    monkeypatch.setattr(command_line, "analyze_apart", lambda path, chosen, _patience: analyze_file(path, chosen))

    def run_inside(*arguments):
        try:
            returncode = main([str(argument) for argument in arguments])
        except SystemExit as wrong:
            returncode = wrong.code
        written = capsys.readouterr()
        return subprocess.CompletedProcess(arguments, returncode, written.out, written.err)

    return run_inside


def rows_of(path):
    return list(csv.DictReader(open(path, newline="", encoding="utf-8")))


@pytest.mark.long
def test_command_prints_a_table_for_each_program(folder, inside):
    done = run(folder, "--jobs", 2)
    assert done.returncode == 1
    assert done.stdout.count("Face") == 3 and done.stdout.count("zigzag") == 3
    assert f"{folder / 'b.nc'}\nThis is not an NC program, because it is not text.\n" in done.stdout
    assert done.stderr.splitlines()[-1] == "3 operations in 4 files, 1 could not be read."
    (folder / "b.nc").unlink()
    assert inside(folder).returncode == 0


def test_processes_are_limited_to_one_per_file(folder, inside):
    done = inside(folder, "--jobs", 10**20)
    assert done.returncode == 1 and done.stdout.count("Face") == 3


def test_processes_are_limited_for_very_many_files():
    """A system can start a few thousand processes. The command for 10,000 files must not ask for as many."""
    asked = command_line._parser().parse_args(["folder", "--jobs", "10000"])
    with command_line._executor(asked, 10_000) as (executor, ahead):
        assert executor._max_workers == 256 and ahead == 4 * 256


def test_file_name_cannot_control_the_terminal(tmp_path, inside):
    (tmp_path / "a\x1b[2J\nb.nc").write_text(PROGRAM)
    done = inside(tmp_path)
    assert done.stdout.splitlines()[0] == f"{tmp_path}/a [2J b.nc" and "\x1b" not in done.stdout


def test_program_of_rapids_counts_as_read(tmp_path, inside):
    (tmp_path / "rapids.nc").write_text("G0 X0 Y0 Z5\nG0 X50\n")
    done = inside(tmp_path)
    assert done.returncode == 0 and done.stderr.splitlines()[-1] == "1 operation in 1 file."
    assert "empty" in done.stdout


@pytest.mark.long
def test_results_are_written_as_csv_and_json_lines(folder, tmp_path, inside):
    assert inside(folder, "--csv", tmp_path / "out.csv").returncode == 1
    rows = rows_of(tmp_path / "out.csv")
    assert sorted(Path(row["document"]).name for row in rows) == [f"{name}.nc" for name in NAMES]
    assert {row["strategy"] for row in rows} == {"zigzag", "unknown"}
    lines = [json.loads(line) for line in run(folder, "--json-lines", "-", "--jobs", 1).stdout.splitlines()]
    assert sorted(line["document"] for line in lines) == sorted(row["document"] for row in rows)
    assert inside("--json-lines", tmp_path / "out.jsonl", folder / "a.nc").stdout == ""
    (line,) = map(json.loads, (tmp_path / "out.jsonl").read_text().splitlines())
    assert (line["label"], line["strategy"]) == ("Face", "zigzag")
    expected = next(one for one in lines if one["document"] == line["document"])
    assert line == expected


@pytest.mark.long
@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_resume_option_continues_where_the_last_run_stopped(folder, tmp_path, kind, inside):
    out = tmp_path / "out"
    arguments = folder, kind, out, "--jobs", 1
    assert inside(*arguments).returncode == 1
    whole = out.read_bytes()
    lines = whole.splitlines(keepends=True)
    for cut in (0, len(lines[0]) + 3, len(b"".join(lines[:3])), len(b"".join(lines[:4])) - 20, len(whole)):
        out.write_bytes(whole[:cut])
        done = inside(*arguments, "--resume")
        assert sorted(out.read_bytes().splitlines()) == sorted(whole.splitlines()), cut
        again = int(done.stderr.splitlines()[-1].split(" in ")[1].split()[0])
        complete = whole[:cut].count(b"\n") - (kind == "--csv")
        # The last program in the file is analysed again, because further rows of this program may be missing.
        assert again == len(NAMES) - max(complete - 1, 0)


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_existing_results_are_replaced_unless_resumed(folder, tmp_path, kind, inside):
    out = tmp_path / "out"
    inside(folder / "a.nc", folder / "c.nc", kind, out)
    assert b"a.nc" in out.read_bytes() and b"c.nc" in out.read_bytes()
    inside(folder / "c.nc", kind, out)
    assert b"c.nc" in out.read_bytes() and b"a.nc" not in out.read_bytes()


@pytest.mark.parametrize(("kind", "content"), [
    ("--csv", b"notes of the user, without a line end"), ("--csv", b"\xff\xfe\0"), ("--json-lines", b"notes"),
    ("--json-lines", b"[" * 100_000 + b"\n"), ("--json-lines", b'{"document": ["x"], "counted": 1}\n'),
    ("--json-lines", b'{"document": ' + b"9" * 10_000 + b', "counted": 1}\n'),
])  # fmt: skip
def test_resume_option_keeps_a_file_without_results(folder, tmp_path, kind, content, inside):
    out = tmp_path / "out"
    out.write_bytes(content)
    done = inside(folder, kind, out, "--resume")
    assert done.returncode == 2
    assert done.stderr == f"vkworkbench: cannot continue {out}: it has a line that is not a result of this command\n"
    assert out.read_bytes() == content


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_resume_option_finds_names_with_control_characters(tmp_path, kind, inside):
    for name in ("a\nb.nc", "c.nc"):
        (tmp_path / name).write_text(PROGRAM)
    assert inside(tmp_path / "a\nb.nc", tmp_path / "c.nc", kind, tmp_path / "out").returncode == 0
    (tmp_path / "a b.nc").write_text(PROGRAM)
    done = inside(tmp_path, kind, tmp_path / "out", "--resume")
    assert done.stderr.splitlines()[-1] == "2 operations in 2 files, 1 file done before."
    lines = [line for line in (tmp_path / "out").read_text().splitlines() if "zigzag" in line]
    assert len(lines) == len({line.split('"name"')[0].split(",")[0] for line in lines}) == 3


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_file_names_with_umlauts_are_written_as_read(folder, tmp_path, kind, inside):
    named = tmp_path / "Größe 型腔.nc"
    named.write_bytes((folder / "a.nc").read_bytes())
    inside(named, kind, tmp_path / "out")
    assert "Größe 型腔.nc" in (tmp_path / "out").read_text(encoding="utf-8")


def test_options_jobs_and_timeout_are_parsed():
    chosen = command_line._parser().parse_args(["a.nc", "--jobs", "3", "--timeout", "2.5"])
    assert (chosen.jobs, chosen.timeout) == (3, 2.5)
    assert command_line._parser().parse_args(["a.nc"]).timeout == 600.0


def test_existing_results_are_kept_if_dask_is_missing(folder, tmp_path, inside, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    results = tmp_path / "results.csv"
    results.write_text("a,b\n1,2\n")
    done = inside(folder, "--csv", results, "--scheduler", "tcp://127.0.0.1:1")
    assert done.returncode == 2 and "--scheduler needs Dask" in done.stderr
    assert results.read_text() == "a,b\n1,2\n"


def test_wrong_arguments_get_a_helpful_error(folder, tmp_path, inside):
    other = tmp_path / "other.csv"
    other.write_text("a,b\n1,2\n")
    empty = tmp_path / "empty"
    empty.mkdir()
    pipe, long, slow = tmp_path / "pipe", tmp_path / "long", tmp_path / "slow"
    os.mkfifo(pipe)
    long.write_text("$110=3000\n" * 11_000)
    slow.write_text("$110=1e-300\n")
    for arguments, words in (
        ((empty,), f"no NC programs in {empty}"),
        (("",), "no file is named"),
        (("-",), "standard input is not read: give a file"),
        ((folder, "/dev/stdin"), "standard input is not read: give a file"),
        (("/dev/fd/63",), "standard input is not read: give a file"),
        (("/proc/self/fd/0",), "standard input is not read: give a file"),
        ((folder, "--resume"), "--resume needs a file of results"),
        ((folder, "--csv", other, "--resume"), f"cannot continue {other}: it has other columns"),
        ((folder, "--csv", tmp_path / "no" / "x.csv"), "cannot write"),
        ((folder, "--csv", folder / "a.nc"), f"{folder / 'a.nc'} has the suffix of an NC program"),
        ((folder, "--json-lines", folder / "a.nc"), "give the file of results another name"),
        ((folder, "--csv", folder / "a.nc.gz"), f"{folder / 'a.nc.gz'} has the suffix of an NC program"),
        ((folder, "--jobs", "0"), "invalid value '0': it takes a whole number above 0"),
        ((folder, "--machine", "/dev/zero"), "no machine '/dev/zero'"),
        ((folder, "--machine", pipe), f"no machine '{pipe}'"),
        ((folder, "--machine", long), f"no machine '{long}'"),
        ((folder, "--machine", slow), "rates must be three numbers from 1e-06 to 1e+09"),
        ((folder, "--timeout", "soon"), "invalid value 'soon': it takes a number above 0"),
        ((), "required: FILE|FOLDER"),
    ):
        done = inside(*arguments)
        assert (done.returncode, done.stdout) == (2, "") and words in done.stderr and "Traceback" not in done.stderr
    assert other.read_text() == "a,b\n1,2\n"
    assert (folder / "a.nc").read_text() == PROGRAM


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_results_do_not_overwrite_a_program(tmp_path, kind, inside):
    program, link, other_name = tmp_path / "prog.txt", tmp_path / "link", tmp_path / "." / "sub" / ".." / "prog.txt"
    program.write_text(PROGRAM)
    link.symlink_to(program)
    (tmp_path / "sub").mkdir()
    for results in (program, link, other_name):
        for resumed in ((), ("--resume",)):
            done = inside(program, kind, results, *resumed)
            assert done.returncode == 2 and f"{results} is one of the programs" in done.stderr
            assert program.read_text() == PROGRAM


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_existing_results_are_kept_if_there_are_no_programs(folder, tmp_path, kind, inside):
    (tmp_path / "empty").mkdir()
    out = tmp_path / "out"
    inside(folder, kind, out)
    before = out.read_bytes()
    assert inside(tmp_path / "empty", kind, out).returncode == 2
    assert out.read_bytes() == before


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_file_unreadable_in_an_earlier_run_is_still_reported(folder, tmp_path, kind, inside):
    arguments = folder / "b.nc", folder / "a.nc", kind, tmp_path / "out", "--jobs", 1
    assert inside(*arguments).returncode == 1
    done = inside(*arguments, "--resume")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == "1 operation in 1 file, 1 file done before, 1 of them could not be read."
    assert inside(folder / "a.nc", folder / "c.nc", *arguments[2:], "--resume").returncode == 0


class AtOnce(Executor):
    """An executor whose futures are already done when `submit` returns."""

    def submit(self, function, /, *arguments):
        future = Future()
        future.set_result(())
        return future


def test_finished_programs_are_reported_in_order():
    paths = [Path(f"{k}.nc") for k in range(50)]
    assert [path for path, _ in command_line._analyzed(paths, AtOnce(), len(paths), 1.0, Preferences())] == paths


def apart_in_a_thread(*asked):
    """Return the table rows of programs that one thread analyses, like the command's threads."""
    with ThreadPoolExecutor(1) as executor:
        try:
            return [
                row
                for path, patience in asked
                for row in executor.submit(apart.analyze_apart, path, Preferences(), patience).result()
            ]
        finally:
            apart.end_workers()


@pytest.mark.long
def test_program_after_a_stopped_analysis_is_read(folder, endless):
    """The first program exceeds its time limit. The time limit of the next program is longer than threads can wait."""
    late, other = apart_in_a_thread((endless, 0.5), (folder / "a.nc", 1e10))
    assert late.error == "The analysis was stopped after 0.5 s." and not late.counted
    assert str(other.strategy) == "zigzag"


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit the memory of a process")
def test_decompression_bomb_affects_only_its_own_result(folder, tmp_path, monkeypatch):
    """The bomb is small until it is decompressed. The programs before and after the bomb are read."""
    monkeypatch.setattr(apart, "_MOST_MEMORY", 5e7)
    bomb = tmp_path / "bomb.nc.xz"
    bomb.write_bytes(lzma.compress(b"G1 X1\nX2\n" * 400_000, preset=0))
    assert bomb.stat().st_size < 10_000
    before, found, after = apart_in_a_thread((folder / "a.nc", 3600), (bomb, 3600), (folder / "a.nc", 3600))
    assert not found.counted and found.error == (
        "The memory is not sufficient for this program. Divide it into smaller programs."
    )
    assert before == after and str(after.strategy) == "zigzag"


def test_failing_analysis_affects_only_its_program(folder, inside, monkeypatch):
    def fails(path, chosen, _patience):
        if path.name == "a.nc":
            raise MemoryError("none left")
        return analyze_file(path, chosen)

    monkeypatch.setattr(command_line, "analyze_apart", fails)
    done = inside(folder)
    assert (
        "The analysis failed. Please report the error together with the file: MemoryError: none left\n" in done.stdout
    )
    assert done.stderr.splitlines()[-1] == "2 operations in 4 files, 2 could not be read."


def test_program_table_is_printed_before_next_program_is_read(tmp_path, monkeypatch):
    for name in "ab":
        (tmp_path / f"{name}.nc").write_text(PROGRAM)
    written, seen = io.BytesIO(), []

    def read(path, chosen, _patience):
        deadline = time.monotonic() + 60
        while path.name == "b.nc" and not written.getvalue() and time.monotonic() < deadline:
            time.sleep(0.01)
        seen.append(written.getvalue())
        return analyze_file(path, chosen)

    monkeypatch.setattr(command_line, "analyze_apart", read)
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written))  # The output is buffered, as for a pipe.
    assert main([str(tmp_path), "--jobs", "1"]) == 0
    assert b"zigzag" in seen[1]


@pytest.mark.long
def test_program_that_never_opens_does_not_affect_other_programs(folder, tmp_path, endless):
    done = run(folder, endless, "--csv", tmp_path / "out.csv", "--timeout", "20", "--jobs", 2)
    errors = {Path(row["document"]).name: row["error"] for row in rows_of(tmp_path / "out.csv")}
    assert errors.pop("endless.nc") == "The analysis was stopped after 20 s."
    assert errors.pop("b.nc") and len(errors) == 3 and not any(errors.values())
    assert done.stderr.splitlines()[-1] == "3 operations in 5 files, 2 could not be read."


def test_process_that_dies_affects_only_its_program(tmp_path):
    path = tmp_path / "long.nc"
    path.write_text(LONG)
    found = []

    def work():
        found.append(apart.analyze_apart(path, Preferences(), 60.0))
        found.append(apart.analyze_apart(path.with_name("short.nc"), Preferences(), 60.0))

    path.with_name("short.nc").write_text(PROGRAM)
    thread = threading.Thread(target=work)
    thread.start()
    while not list(apart._workers):
        time.sleep(0.01)
    time.sleep(0.1)
    for one in list(apart._workers):
        os.kill(one._process.pid, signal.SIGKILL)
    thread.join(60)
    apart.end_workers()
    (died,), (alive,) = found
    assert died.error.startswith("The process that read the file ended") and not died.counted
    assert str(alive.strategy) == "zigzag"


@pytest.mark.long
def test_ctrl_c_ends_the_command_and_all_its_processes(folder, tmp_path, endless):
    out = tmp_path / "out.csv"
    # The tests possibly run as a background job of a shell, which ignores SIGINT.
    heard = ["env", "--default-signal=INT"]
    started = [*heard, *command(folder, endless, "--csv", out, "--jobs", 2)]
    process = subprocess.Popen(started, cwd=ROOT, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while (not out.exists() or out.read_bytes().count(b"\n") < 1 + len(NAMES)) and time.monotonic() < deadline:
        time.sleep(0.05)
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    children += [
        c for task in Path(f"/proc/{process.pid}/task").iterdir() for c in (task / "children").read_text().split()
    ]
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130
    assert said.splitlines()[-1] == "Stopped after 4 of 5 files; continue with --resume." and "Traceback" not in said
    assert children and not any(Path(f"/proc/{child}/cmdline").exists() for child in children)
    assert len(rows_of(out)) == len(NAMES)


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
@pytest.mark.parametrize("resumed", [(), ("--resume",)])
def test_second_command_on_a_results_file_is_refused(folder, tmp_path, kind, resumed, inside):
    out = tmp_path / "out"
    assert inside(folder / "a.nc", folder / "c.nc", kind, out).returncode == 0
    code = (
        "import os, sys; from vkworkbench.program.results import _lock, _open_untruncated; "
        "file = os.fdopen(_open_untruncated(sys.argv[1], os.O_WRONLY), 'wb'); _lock(file); "
        "print(flush=True); sys.stdin.read()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, out], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as first:
        first.stdout.readline()
        written = out.read_bytes()
        done = inside(folder, kind, out, *resumed)
        assert (done.returncode, done.stderr) == (
            2,
            f"vkworkbench: cannot write {out}: another command is writing it\n",
        )
        assert out.read_bytes() == written
        first.kill()  # a killed command leaves no lock
    assert inside(folder, kind, out, *resumed).returncode == 1
    assert len({line[:9] for line in out.read_bytes().splitlines()}) <= 2 and out.read_bytes().count(b"\n") >= len(
        NAMES
    )


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_results_may_be_written_to_a_pipe_or_device(folder, tmp_path, kind, inside):
    assert inside(folder / "a.nc", kind, os.devnull).returncode == 0
    os.mkfifo(tmp_path / "pipe")
    with ThreadPoolExecutor(1) as executor:
        read = executor.submit((tmp_path / "pipe").read_bytes)
        assert inside(folder / "a.nc", kind, tmp_path / "pipe").returncode == 0
        assert b"zigzag" in read.result(timeout=60)


def test_stop_message_says_how_to_resume(folder, tmp_path, inside, monkeypatch):
    def stopped(path, _chosen, _patience):
        raise KeyboardInterrupt

    monkeypatch.setattr(command_line, "analyze_apart", stopped)
    for asked, goes_on in (
        ((), ""),
        (("--csv", "-"), ""),
        (("--csv", tmp_path / "out.csv"), "; continue with --resume"),
    ):
        done = inside(folder, *asked)
        assert done.returncode == 130 and done.stderr.splitlines()[-1] == f"Stopped after 0 of 4 files{goes_on}."


@pytest.mark.parametrize(("name", "option"), [("find_programs", ()), ("simulate_programs", ("--simulate",))])
def test_ctrl_c_ends_search_and_simulation_quietly(folder, name, option, inside, monkeypatch):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(command_line, name, stop)
    done = inside(folder, *option)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")


@pytest.mark.long
def test_closed_output_pipe_is_not_an_error(folder):
    asked = command(folder, "--jobs", 1)
    process = subprocess.Popen(asked, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.close()
    assert "Traceback" not in process.stderr.read()
    assert process.wait(60) == 130


@pytest.mark.long
@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_standard_output_does_not_stop_the_command(folder, tmp_path, closed):
    asked = shlex.join([*command(folder / "a.nc"), "--csv", str(tmp_path / "a.csv")])
    done = subprocess.run(["sh", "-c", f"{asked} {closed}"], capture_output=True, text=True, cwd=ROOT, timeout=120)
    assert done.returncode == 0 and "Traceback" not in done.stderr
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 2


FULL = "vkworkbench: cannot write the standard output: No space left on device\n"


@pytest.mark.parametrize("kind", [(), ("--csv", "-"), ("--json-lines", "-")])
def test_full_output_is_reported_in_one_line(folder, kind, inside, monkeypatch):
    with open("/dev/full", "w", encoding="utf-8") as full:  # Closing the file writes the rest of its buffer.
        monkeypatch.setattr(sys, "stdout", full)
        done = inside(folder / "a.nc", *kind)
    assert (done.returncode, done.stderr) == (2, FULL)


@pytest.mark.long
def test_full_standard_output_ends_the_command(folder):
    with open("/dev/full", "wb") as full:
        done = subprocess.run(command(folder / "a.nc"), cwd=ROOT, stdout=full, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (2, FULL)


@contextmanager
def room_for(size):
    """Limit the size of files that this process, and the processes that it starts, may write, bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("kind", ["--csv", "--json-lines"])
def test_full_disk_gives_one_line_and_can_be_resumed(folder, tmp_path, kind, inside):
    whole, out = tmp_path / "whole", tmp_path / "out"
    inside(folder, kind, whole)
    size = len(whole.read_bytes())
    for most in (size - 20, 10):  # The disk is full in the last line or in the first line of the file.
        with room_for(most):
            done = inside(folder, kind, out)
        then = "" if kind == "--csv" and most == 10 else "; continue with --resume"
        assert done.returncode == 2 and done.stderr == f"vkworkbench: cannot write {out}: File too large{then}\n"
        assert len(out.read_bytes()) == most
        assert inside(folder, kind, out, "--resume").returncode == 1
        assert sorted(out.read_bytes().splitlines()) == sorted(whole.read_bytes().splitlines())
        out.unlink()


@pytest.mark.long
def test_full_disk_ends_the_command_with_one_line(folder, tmp_path):
    out = tmp_path / "out"
    # Without the variable PYTHONDONTWRITEBYTECODE, Python would leave a truncated bytecode file.
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    with room_for(10):
        done = run(folder, "--json-lines", out, "--jobs", 1, env=environment)
    told = f"vkworkbench: cannot write {out}: File too large; continue with --resume\n"
    assert (done.returncode, done.stderr, len(out.read_bytes())) == (2, told, 10)


@pytest.mark.long
def test_file_names_outside_utf8_are_accepted(tmp_path, inside):
    (tmp_path / "a.nc").write_text(PROGRAM)
    os.rename(tmp_path / "a.nc", os.fsencode(tmp_path) + b"/fr\xe4sen.nc")
    assert run(tmp_path, "--jobs", 1).returncode == 0
    for one in (inside, run):  # In the second run, the program is already done.
        assert one(tmp_path, "--json-lines", tmp_path / "out.jsonl", "--resume").returncode == 0
        data = (tmp_path / "out.jsonl").read_bytes()
        assert data.count(b"\n") == 1 and b"/fr\xe4sen.nc" in data


@pytest.fixture
def scheduler(tmp_path):
    """Start a Dask scheduler and two workers as real processes. Yield the scheduler's address and a client."""
    pytest.importorskip("distributed", reason="python3-distributed is not installed: --scheduler is not tested")
    with socket.create_server(("127.0.0.1", 0)) as server:
        try:
            socket.create_connection(server.getsockname(), timeout=10).close()
        except OSError as error:  # With a changed root folder (chroot) and no network, the run fails here.
            pytest.skip(f"no connection to 127.0.0.1 ({error}): --scheduler is not tested")
    file = tmp_path / "scheduler.json"
    # As on a cluster, the workers import the installed add-on and do not find it by their working folder.
    paths = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")]))
    options = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": paths}, "stderr": subprocess.DEVNULL}
    local = ("--host", "127.0.0.1", "--no-dashboard")
    processes = [
        subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_scheduler", *local, "--port", "0",
                          "--scheduler-file", file], **options),
    ]  # fmt: skip
    processes += [
        subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_worker", *local, "--scheduler-file", file,
                          "--nthreads", "1"], **options)
        for _ in range(2)
    ]  # fmt: skip
    try:
        from distributed import Client

        with Client(scheduler_file=str(file), timeout=60) as client:
            client.wait_for_workers(2, timeout=60)
            yield client.scheduler.address, client
    finally:
        # A Dask worker would need 5 s to end normally. The child processes of a killed worker notice the worker's end
        # and exit, too.
        for process in processes:
            process.kill()
        for process in processes:
            process.wait()


@pytest.mark.long
def test_results_on_a_dask_cluster_equal_local_results(folder, tmp_path, inside, endless, scheduler):
    """A worker is killed while it analyses an endless program, and the other worker analyses this program."""
    address, client = scheduler
    here, there = tmp_path / "here.csv", tmp_path / "there.csv"
    inside(folder, "--csv", here)
    asked = command(folder, endless, "--csv", there, "--timeout", "20", "--scheduler", address)
    with subprocess.Popen(asked, cwd=ROOT, stderr=subprocess.PIPE, text=True) as process:
        deadline = time.monotonic() + 100
        while (not there.exists() or there.read_bytes().count(b"\n") < 1 + len(NAMES)) and time.monotonic() < deadline:
            time.sleep(0.05)
        started = client.run(lambda: len(__import__("vkworkbench.program.apart", fromlist=["apart"])._workers))
        assert len(started) == 2 and all(started.values())  # each of the two workers had programs to analyse
        (busy,) = (worker for worker, tasks in client.processing().items() if tasks)
        os.kill(client.run(os.getpid)[busy], signal.SIGKILL)
        _, said = process.communicate(timeout=120)
    # After the last line of the command, Dask may print messages and tracebacks about closed connections.
    ours, last_line, _ = said.partition("3 operations in 5 files, 2 could not be read.\n")
    assert process.returncode == 1 and last_line and "Traceback" not in ours
    late, found = [], []
    for line in there.read_bytes().splitlines():
        (late if b"endless.nc" in line else found).append(line)
    assert sorted(found) == sorted(here.read_bytes().splitlines())
    assert len(late) == 1 and b"stopped after 20 s" in late[0]


@pytest.mark.parametrize(
    ("start", "names"),
    [
        ([str(ROOT / "vkworkbench")], ()),
        (["-m", "vkworkbench"], ("argparse", "csv", "distributed", "json", "numpy", "pickle", "subprocess")),
    ],
)
def test_command_runs_no_files_of_the_current_folder(tmp_path, start, names):
    """With -m, Python itself imports the package and some of its own modules from the current folder."""
    ran = lay_traps(tmp_path / "traps", names)
    (tmp_path / "traps" / "a.nc").write_text(PROGRAM)
    # With -m, PYTHONPATH ends with an empty entry, which stands for the current folder.
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}" if "-m" in start else ""}
    done = subprocess.run(
        [sys.executable, *start, "."], cwd=tmp_path / "traps", env=environment, capture_output=True, text=True
    )
    assert (done.returncode, done.stderr.splitlines()[-1], ran()) == (0, "1 operation in 1 file.", [])
    assert "zigzag" in done.stdout


@pytest.mark.long
def test_unreachable_scheduler_is_reported(folder):
    pytest.importorskip("distributed", reason="python3-distributed is not installed: --scheduler is not tested")
    done = run(folder, "--scheduler", "nonsense://nowhere")
    assert (
        done.returncode == 2
        and "no Dask scheduler at nonsense://nowhere" in done.stderr
        and "Traceback" not in done.stderr
    )


@pytest.mark.long
def test_dask_is_imported_only_for_a_cluster(folder):
    code = (
        "import sys; from vkworkbench.program import analysis, command_line, main; "
        "command_line.analyze_apart = lambda path, chosen, _: analysis.analyze_file(path, chosen); "
        "main(sys.argv[1:]); print('distributed' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code, str(folder / "a.nc")], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.splitlines()[-1] == "False"


def test_machining_times_are_computed_for_the_named_machine(folder, tmp_path, capsys):
    results = tmp_path / "results.csv"
    assert main([str(folder / "a.nc"), "--machine", "hobby-router", "--csv", str(results)]) == 0
    (row,) = csv.DictReader(results.open())
    assert row["machining_complete"] == "True" and row["machining_notes"] == ""
    assert main([str(folder / "a.nc"), "--machine", "lathe"]) == 2
    assert main([str(folder / "a.nc"), "--machine", "hobby-router", "--simulate"]) == 2
    told = capsys.readouterr().err
    assert "no machine 'lathe': name hobby-router" in told and "leave out --machine" in told
