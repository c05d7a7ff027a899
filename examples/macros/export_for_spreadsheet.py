# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export some columns for a spreadsheet, in minutes and metres, with the decimal point or comma of your country."""

from __future__ import annotations

import csv
from math import degrees
from pathlib import Path

import FreeCAD

import vkworkbench
from vkworkbench.report import as_cell

COLUMNS = {
    "Job": lambda o: o.job,
    "Operation": lambda o: o.label,
    "Strategy": lambda o: str(o.strategy),
    "Confidence": lambda o: o.confidence,
    "Cutting length (m)": lambda o: o.length / 1000,
    "Machining time (min)": lambda o: None if o.machining_seconds is None else o.machining_seconds / 60,
    "Stepover (mm)": lambda o: o.stepover,
    "Direction (degrees)": lambda o: None if o.recognition.direction is None else degrees(o.recognition.direction),
}


def export(document, path, decimal_point="."):
    """Write one line for each operation; return the number of lines. Decimal commas need semicolons as separators."""
    operations = vkworkbench.analyze(document).operations
    with open(path, "w", newline="", encoding="utf-8-sig") as file:  # with the byte order mark, Excel reads UTF-8
        writer = csv.writer(file, delimiter=";" if decimal_point == "," else ",")
        writer.writerow(COLUMNS)
        for operation in operations:
            writer.writerow([written(value(operation), decimal_point) for value in COLUMNS.values()])
    return len(operations)


def written(value, decimal_point):
    """Return the text of a cell; a text never becomes a formula."""
    if isinstance(value, float):
        return f"{value:.3f}".replace(".", decimal_point)
    return "" if value is None else as_cell(str(value))


if __name__ == "__main__":
    from PySide import QtCore

    document = FreeCAD.ActiveDocument
    if document is None:
        FreeCAD.Console.PrintError("Open a document with a job first\n")
    else:
        beside = Path(document.FileName) if document.FileName else Path.home() / document.Name
        table = beside.with_suffix(".csv")
        count = export(document, str(table), str(QtCore.QLocale().decimalPoint()))
        FreeCAD.Console.PrintMessage(f"{count} operations in {table}\n")
