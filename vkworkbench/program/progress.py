# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many of many files are done, and how long the rest takes."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import TextIO

from vkworkbench.language import ENGLISH

_PAUSE = 0.2, 30.0  # s between two reports, to a terminal and to a file
_SMALL = 2000  # bytes that are added to a file's size for the work that every file takes


class Progress:
    """Reports progress to a stream; the remaining time is estimated from the sizes of the files.

    Parameters
    ----------
    paths : iterable of Path
        What there is to do.
    stream : TextIO
        On a terminal one line changes; anything else gets a new line now and then.
    """

    def __init__(self, paths: Iterable[Path], stream: TextIO) -> None:
        self._sizes = {path: _size(path) for path in paths}
        self._total = sum(self._sizes.values())
        self._stream = stream
        self._terminal = stream.isatty()
        self._done = self._files = 0
        self._begin = self._said = time.monotonic()

    @property
    def files(self) -> int:
        """How many files are done."""
        return self._files

    def add(self, path: Path) -> None:
        """Note that a file is done."""
        self._files += 1
        self._done += self._sizes[path]
        now = time.monotonic()
        if now - self._said >= _PAUSE[not self._terminal]:
            self._said = now
            left = (now - self._begin) * (self._total - self._done) / self._done
            text = f"{self._files} of {len(self._sizes)} files, {ENGLISH.time(left)} left"
            self._stream.write(f"\r\x1b[K{text}" if self._terminal else f"{text}\n")
            self._stream.flush()

    def clear(self) -> None:
        """Make room for other output in the terminal."""
        if self._terminal:
            self._stream.write("\r\x1b[K")
            self._stream.flush()


def _size(path: Path) -> int:
    with suppress(OSError):
        return os.path.getsize(path) + _SMALL
    return _SMALL
