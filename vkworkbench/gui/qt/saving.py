# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where what the user saves of a document goes: beside it, unless he chooses otherwise."""

from __future__ import annotations

from pathlib import Path


def proposed(document, name: str) -> str:
    """Return the path that a dialog proposes for a file: beside the document, at home if that has no file yet."""
    return str((Path(document.FileName).parent if document.FileName else Path.home()) / name)


def with_suffix(path: str, suffix: str) -> str:
    """Return the path that the user chose, with this suffix if he left it out; a cancelled dialog's is empty.

    A name may have dots of its own: the ``.2`` of "Bracket V1.2" is no suffix.
    """
    return path if not path or Path(path).suffix[1:].isalpha() else path + suffix
