# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of files that the user saves."""

from __future__ import annotations

from pathlib import Path

from vkworkbench.gui.qt.names import QFileDialog, QWidget


def ask_path(parent: QWidget, title: str, document, suffix: str) -> str:
    """Ask for the path of a file to save, by default with the document's name; empty after a cancelled dialog."""
    proposed = str(folder_of(document) / (document.Name + suffix))
    path, _ = QFileDialog.getSaveFileName(parent, title, proposed, f"{suffix[1:].upper()} (*{suffix})")
    return with_suffix(path, suffix)


def folder_of(document) -> Path:
    """Return the folder of a document, or the home folder if the document was never saved."""
    return Path(document.FileName).parent if document.FileName else Path.home()


def with_suffix(path: str, suffix: str) -> str:
    """Return the path that the user chose, with this suffix if the path has none; empty after a cancelled dialog.

    A file name can contain dots: the ``.2`` in "Bracket V1.2" is not a suffix.
    """
    return path if not path or Path(path).suffix[1:].isalpha() else path + suffix
