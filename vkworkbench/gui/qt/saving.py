# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of files that the user saves."""

from __future__ import annotations

from pathlib import Path


def proposed(document, name: str) -> str:
    """Return the default path of a file: in the folder of the document, or at home if the document was never saved."""
    return str((Path(document.FileName).parent if document.FileName else Path.home()) / name)


def with_suffix(path: str, suffix: str) -> str:
    """Return a chosen path, with this suffix if it has none. An empty path of a cancelled dialog stays empty.

    A name can contain dots: the ``.2`` of "Bracket V1.2" is not a suffix.
    """
    return path if not path or Path(path).suffix[1:].isalpha() else path + suffix
