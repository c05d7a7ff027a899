# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report the progress of analysing many NC programs, with the remaining time."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import TextIO

from vkworkbench.language import ENGLISH

_PAUSE = 0.2, 30.0  # Shortest time between two reports of the progress: to a terminal, and to another stream, s.
_SMALL = 2000  # Work of opening a file, as the number of bytes whose analysis takes the same time.


class Progress:
    """Report the progress to a stream. The remaining time is estimated from the sizes of the files.

    A terminal shows one line that changes. A stream that is not a terminal gets a new line for each report.
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
        """Number of finished files."""
        return self._files

    def add(self, path: Path) -> None:
        """Count a file as finished."""
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
        """Clear the line in the terminal, to make room for other output."""
        if self._terminal:
            self._stream.write("\r\x1b[K")
            self._stream.flush()


def _size(path: Path) -> int:
    with suppress(OSError):
        return os.path.getsize(path) + _SMALL
    return _SMALL
