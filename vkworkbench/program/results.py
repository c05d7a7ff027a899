# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write files of results, with one line of CSV or JSON for each operation.

If writing was interrupted, it can be continued.
"""

from __future__ import annotations

import csv
import errno
import io
import json
import os
import re
import sys
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import BinaryIO

from vkworkbench.report import OperationReport, cells_of

# Position of the byte that Windows locks; it is beyond the end of the file, so that other programs can read the file.
_LOCKED = 2**60
_LONGEST_LINE = 100_000_000  # bytes in a line of results; a longer line is not a result
_NOT_A_RESULT = "it has a line that is not a result of this command"
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")


def _bytes(text: str) -> bytes:
    """Return a text in UTF-8. File names may contain bytes that are not UTF-8."""
    return text.encode("utf-8", "surrogateescape")


def _text(data: bytes) -> str:
    return data.decode("utf-8", "surrogateescape")


def _open_untruncated(path: str, flags: int) -> int:
    """Opener for `open(..., opener=)`: does not truncate the file, because another command may be writing to it."""
    return os.open(path, flags & ~os.O_TRUNC, 0o666)


def _lock(file: io.FileIO | BinaryIO) -> None:
    """Lock a file until it is closed or this process ends. Raise BlockingIOError if another process has locked it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            file.seek(_LOCKED)
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        raise BlockingIOError(errno.EAGAIN, "another command is writing it") from None
    except OSError:  # the file system does not support locks
        pass


class JsonLines:
    """One JSON object per line, in mm, s, rad and bytes, as in `OperationReport.as_dict`."""

    header, start = b"", b'{"'

    @staticmethod
    def name_of(program: str) -> str:
        """Return the name of a program as `document` reads it from a line."""
        return program

    def line(self, row: OperationReport) -> bytes:
        return _bytes(json.dumps(row.as_dict(), ensure_ascii=False) + "\n")

    def document(self, line: bytes) -> tuple[str, bool]:
        """Return the program whose results are in a line, and whether the program was read.

        A line without the form of a result raises ValueError, LookupError or TypeError.
        """
        row = json.loads(_text(line))
        if not isinstance(row["document"], str):
            raise TypeError(line)
        return row["document"], row["counted"]


class Csv:
    """One line for each operation with the cells of `cells_of`, below a header with the names of the columns."""

    def __init__(self, names: Iterable[str]) -> None:
        self._names = list(names)
        self.header = self.start = self._written(self._names)
        self._columns = self._names.index("document"), self._names.index("counted")

    def line(self, row: OperationReport) -> bytes:
        cells = {**cells_of(row), "document": self.name_of(row.document)}
        return self._written(cells[name] for name in self._names)

    @staticmethod
    def name_of(program: str) -> str:
        """Return the name of a program as in a line: with ``%0A`` for a line end, so that two names stay different."""
        return _CONTROL.sub(lambda found: f"%{ord(found[0]):02X}", program)

    def document(self, line: bytes) -> tuple[str, bool]:
        """Return the program whose results are in a line, and whether the program was read.

        A ValueError is raised if the number of cells in the line differs from the number of columns.
        """
        (cells,) = csv.reader([_text(line)])
        if len(cells) != len(self._names):
            raise ValueError(line)
        document, counted = (cells[column] for column in self._columns)
        return document, counted == str(True)

    @staticmethod
    def _written(cells: Iterable) -> bytes:
        text = io.StringIO()
        csv.writer(text).writerow(_CONTROL.sub(" ", cell) if isinstance(cell, str) else cell for cell in cells)
        return _bytes(text.getvalue())


class Results:
    """A file of results, or the standard output (``"-"``), to which rows are added program by program.

    If `resume` is True, an existing file is continued. The last program in the file is analysed again, because its rows
    may be incomplete. A ValueError is raised if a line of the existing file is not a result of this command, and an
    OSError if the file cannot be written, or another command is writing it.
    """

    def __init__(self, path: str, form: JsonLines | Csv, *, resume: bool) -> None:
        self._form = form
        self._done: set[str] = set()  # names of the programs whose rows are in the file already
        self._unread: set[str] = set()  # names of the programs in `_done` that could not be read
        # A named file has no buffer, because closing would write buffered data again that a full disk refused.
        self._file: BinaryIO | io.FileIO
        if path == "-":
            self._file = sys.stdout.buffer
        else:
            self._file = open(path, "wb", buffering=0, opener=_open_untruncated)
            if os.path.isfile(path):  # the path is not a pipe or a device
                self._begin(path, resume=resume)
        if not self._done:
            try:
                self._write(form.header)
            except BaseException:
                self.close()  # an unclosed file would stay locked
                raise

    def _begin(self, path: str, *, resume: bool) -> None:
        """Lock the file, and truncate it after the lines to keep."""
        try:
            _lock(self._file)
            kept = 0
            if resume:
                with open(path, "rb") as file:
                    kept = self._keep(file)
        except BaseException:
            self._file.close()
            raise
        self._file.truncate(kept)
        self._file.seek(kept)

    def has(self, program: Path) -> bool:
        """Return whether the rows of a program are in the file already."""
        return self._form.name_of(str(program)) in self._done

    def has_unread(self, program: Path) -> bool:
        """Return whether the file states that a program could not be read."""
        return self._form.name_of(str(program)) in self._unread

    def add(self, rows: Iterable[OperationReport]) -> None:
        """Write all rows of one program together."""
        self._write(b"".join(map(self._form.line, rows)))

    def close(self) -> None:
        if self._file is not sys.stdout.buffer:
            self._file.close()

    def _write(self, data: bytes) -> None:
        while data:
            data = data[self._file.write(data) :]
        self._file.flush()

    def _check_incomplete(self, line: bytes, *, first: bool) -> None:
        """Raise ValueError unless a line without an end can be the last line of a run that was stopped."""
        start = self._form.start
        if len(line) >= _LONGEST_LINE or (first and not (line.startswith(start) or start.startswith(line))):
            raise ValueError(_NOT_A_RESULT)

    def _keep(self, file: BinaryIO) -> int:
        """Fill `_done` and `_unread` from an existing file, and return the number of bytes to keep."""
        place, begin, last = 0, 0, None
        header = self._form.header
        for line in iter(partial(file.readline, _LONGEST_LINE), b""):
            place += len(line)
            if not line.endswith(b"\n"):
                self._check_incomplete(line, first=place == len(line))
                break
            if header:
                if line != header:
                    raise ValueError("it has other columns")
                header = b""
                begin = place
                continue
            try:
                document, read = self._form.document(line)
            except (ValueError, LookupError, TypeError, RecursionError):
                raise ValueError(_NOT_A_RESULT) from None
            if document != last:
                self._done.add(document)
                if not read:
                    self._unread.add(document)
                begin, last = place - len(line), document
        self._done.discard(last)
        self._unread.discard(last)
        return begin if self._done else 0
