# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export results: to a file with all numbers, or as text for the clipboard."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from vkworkbench.gui.qt.names import QWidget
from vkworkbench.gui.qt.plain_text import warn
from vkworkbench.gui.qt.saving import ask_path
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.columns import Column
from vkworkbench.gui.results.rows import Row
from vkworkbench.report import Report, as_cell


def save(report: Report, document, ending: str, parent: QWidget) -> None:
    """Ask for a file name and save a report as ``"csv"`` or ``"json"``."""
    title = {"csv": translate("Vk_Results", "Export CSV"), "json": translate("Vk_Results", "Export JSON")}[ending]
    path = ask_path(parent, title, document, f".{ending}")
    if not path:
        return
    try:
        report.to_csv(path) if ending == "csv" else report.to_json(path)
    except OSError as error:
        warn(title, str(error), parent)


def as_text(columns: Sequence[Column], rows: Iterable[Row]) -> str:
    """Return table rows as tab-separated text, below a line of column titles.

    Numbers and units are written as in the results panel.
    """
    lines = [[column.name for column in columns]]
    lines += [[" ".join(as_cell(column.text(row)).split()) for column in columns] for row in rows]
    return "\n".join("\t".join(line) for line in lines) + "\n"
