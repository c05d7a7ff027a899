# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of files that the user saves."""

from __future__ import annotations

from pathlib import Path


def proposed(document, name: str) -> str:
    """Return the default path of a file: in the document's folder, or in the home folder if it was never saved."""
    return str((Path(document.FileName).parent if document.FileName else Path.home()) / name)


def with_suffix(path: str, suffix: str) -> str:
    """Return the path that the user chose, with this suffix if the path has none; empty after a cancelled dialog.

    A file name can contain dots: the ``.2`` in "Bracket V1.2" is not a suffix.
    """
    return path if not path or Path(path).suffix[1:].isalpha() else path + suffix
