# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the files of NC programs, and read their texts."""

from __future__ import annotations

import codecs
import gzip
import lzma
import os
import re
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path

from vkworkbench.core.gcode import split_comments, split_words
from vkworkbench.language import Message, Unusable

# Suffixes of NC programs. A file in a folder with another suffix is read only if it looks like a program. A file that
# the user names is always read.
_SUFFIXES = frozenset([
    ".nc", ".ngc", ".gcode", ".gc", ".g", ".tap", ".cnc", ".ncc", ".ncf", ".iso",
    ".eia", ".din", ".min", ".mpf", ".spf", ".prg", ".fnc", ".nc1", ".ptp", ".mcd",
])  # fmt: skip
_HEAD, _FEWEST_WORDS = 100_000, 3  # Number of bytes examined in a file, and minimum number of lines of G-code words.
# Definitions of tools and formats in files of circuit boards: drill files (Excellon) and drawings (Gerber). The lines
# of drill files and drawings look like words of an NC program.
_OF_CIRCUIT_BOARDS = re.compile(r"T\d+(?:[FSBHZ]\d*)*C[\d.]|%(?:FS|MO|AD)")
# Limits of a decompressed text: bytes, lines, and characters of a line. A text beyond these limits is refused, because
# a toolpath has at most 5 million moves, and lines of NC programs are shorter.
MOST_BYTES, MOST_LINES, LONGEST_LINE = 400_000_000, 10_000_000, 500_000
_PART = 10_000_000  # size of one read, bytes
_LINE_END = re.compile("[\n\r]")
_PACKED = {".xz": lzma.open, ".gz": gzip.open}
_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
# Three consecutive letters outside ASCII mean that the text is Cyrillic. In Western languages, three such letters
# rarely follow one another.
_CYRILLIC = re.compile(rb"[\xc0-\xff]{3}")
# Characters that serial transmission adds to a text: NUL from the leader of a punched tape, and DC1 to DC4, which start
# and stop a device.
_OF_THE_LINE = b"\0\x11\x12\x13\x14"
_TEXT_CONTROLS = frozenset(b"\t\n\r\f\x0b")
_ZIP, _FIRST_NAME = b"PK\3\4", 30  # the first bytes of an archive, and the offset of the name of its first file


def find_programs(what: Iterable[str | os.PathLike], left_out: list[Path]) -> Iterator[Path]:
    """Yield the named files, and all NC programs in the named folders.

    A file in a folder is a program if it has the suffix of one, or if it is a text that consists of G-code. The other
    files in folders are added to `left_out`.

    Subfolders and symbolic links to folders are also searched, sorted by name. Each file is yielded once. A folder that
    cannot be read is yielded instead of its files, so that the attempt to read it reports the error.

    A ValueError is raised if a name is the text of a program, or if a name is empty, for example from a cancelled file
    dialog, because an empty name should not mean the current folder.
    """
    what = list(what)
    if "" in what:
        raise ValueError("no file is named")
    if any("\n" in os.fspath(one) and not os.path.exists(one) for one in what):
        raise ValueError(
            "the text of a program is no file: give its path; in Python one with backslashes is written r'C:\\new.nc'"
        )
    seen: set[Path] = set()
    for one in map(Path, what):
        for path in _in_folder(one, left_out) if os.path.isdir(one) else [one]:
            place = Path(os.path.realpath(path.parent), path.name)
            if place not in seen:
                seen.add(place)
                yield path


def _in_folder(folder: Path, left_out: list[Path]) -> Iterator[Path]:
    closed: list[Path] = []
    walked: set[str] = set()
    # `os.walk` calls itself for each subfolder before Python 3.12, so it cannot search a thousand nested folders.
    waiting = [(folder, os.path.realpath(folder))]
    while waiting:
        folder, place = waiting.pop()
        if place in walked:  # the folder is a link to a folder that was searched before
            continue
        walked.add(place)
        try:
            names = sorted(os.listdir(folder))
        except OSError:
            closed.append(folder)
            continue
        folders = []
        for name in names:
            path = Path(folder, name)
            if os.path.isdir(path):
                if not name.startswith("."):
                    folders.append((path, _place_of(path, place)))
            elif _is_endless(path):
                continue
            elif is_called_a_program(name) or _looks_like_a_program(path):
                yield path
            else:
                left_out.append(path)
        waiting += reversed(folders)
    yield from closed


def _place_of(path: Path, parent: str) -> str:
    """Return the real path of a folder in a folder with the real path `parent`."""
    if os.name == "nt" or os.path.islink(path):  # junctions of Windows are links, too
        return os.path.realpath(path)
    return os.path.join(parent, path.name)


def is_called_a_program(name: str) -> bool:
    """Return whether a file has the suffix of an NC program, possibly followed by the suffix of a compressed file."""
    suffixes = [suffix.lower() for suffix in Path(name).suffixes]
    if suffixes and suffixes[-1] in _PACKED:
        suffixes.pop()
    return bool(suffixes) and suffixes[-1] in _SUFFIXES


def _looks_like_a_program(path: Path) -> bool:
    """Return whether the content of a file looks like an NC program."""
    try:
        with _PACKED.get(path.suffix.lower(), open)(path, "rb") as file:
            lines = text_of(file.read(_HEAD)).upper().splitlines()
    except (OSError, EOFError, lzma.LZMAError, zlib.error, Unusable):
        return False
    if any(map(_OF_CIRCUIT_BOARDS.match, lines)):
        return False
    blocks = [code for line in lines if (code := split_comments(line)[0].strip(" %"))]
    split = [(code, *split_words(code)) for code in blocks]
    # A line counts as G-code if at most a third of its characters are not words. Some other characters are allowed,
    # because checksums and decimal commas are not words.
    read = [{letter for letter, _ in words} for code, words, rest in split if words and 3 * len(rest) <= len(code)]
    letters = set().union(*read)
    return len(read) >= max(_FEWEST_WORDS, len(blocks) / 2) and "G" in letters and not letters.isdisjoint("XYZ")


def _is_endless(path: str | Path) -> bool:
    """Return whether a path is a pipe or a device. Reading a pipe or a device might never end."""
    return os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path)


def read_bytes(path: Path) -> bytes:
    """Return the content of a file, decompressed. Raise `Unusable` if the file is unreadable or too large."""
    if _is_endless(path):
        raise Unusable(Message("no-file"))
    try:
        with _PACKED.get(path.suffix.lower(), open)(path, "rb") as file:
            parts: list[bytes] = []  # file.read(MOST_BYTES) would allocate MOST_BYTES for every file
            while sum(map(len, parts)) <= MOST_BYTES and (part := file.read(_PART)):
                parts.append(part)
    except (OSError, EOFError, lzma.LZMAError, zlib.error) as error:
        raise Unusable(Message("file-unreadable", name=getattr(error, "strerror", None) or str(error))) from None
    data = b"".join(parts)
    if len(data) > MOST_BYTES:
        raise Unusable(Message("file-too-large", size=MOST_BYTES))
    return data


def text_of(data: bytes) -> str:
    """Return the text of a program. The encoding can be UTF-8, UTF-16, or Windows' Cyrillic or Western code page.

    `Unusable` is raised if the data is not text, or has too many or too long lines. Lines shorter than `LONGEST_LINE`
    are always accepted. Lines of at least twice the length `LONGEST_LINE` are always refused.
    """
    text = _decoded(data)
    if text.count("\n") + text.count("\r") - text.count("\r\n") > MOST_LINES:
        raise Unusable(Message("too-many-lines", lines=MOST_LINES))
    for start in range(0, len(text) - LONGEST_LINE + 1, LONGEST_LINE):
        if not _LINE_END.search(text, start, start + LONGEST_LINE):
            raise Unusable(Message("line-too-long", characters=LONGEST_LINE))
    return text


def _decoded(data: bytes) -> str:
    if data.startswith(_ZIP):
        of_freecad = data.startswith(b"Document.xml", _FIRST_NAME)
        raise Unusable(Message("freecad-document") if of_freecad else Message("archive"))
    for mark, encoding in _MARKS:
        if data.startswith(mark):
            return data.decode(encoding, "replace")
    encoding = _unmarked_utf16(data)
    if encoding:
        data = data.decode(encoding, "ignore").encode()
    data = data.translate(None, _OF_THE_LINE).strip(b"\x1a\x7f")  # tapes begin with DEL, and DOS texts end with SUB
    controls = sum(data.count(code) for code in range(32) if code not in _TEXT_CONTROLS)
    if controls > 0.01 * len(data):
        raise Unusable(Message("no-text"))
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("cp1251" if _CYRILLIC.search(data) else "cp1252", "replace")


def _unmarked_utf16(data: bytes) -> str | None:
    """Return the encoding of a UTF-16 text without a byte order mark; None for other texts.

    In UTF-16, every second byte of Latin letters is 0.
    """
    zeros = [data[first::2].count(0) for first in (0, 1)]
    if min(zeros) > 0.01 * max(zeros) or 4 * max(zeros) <= len(data):
        return None
    return "utf-16-be" if zeros[0] > zeros[1] else "utf-16-le"
