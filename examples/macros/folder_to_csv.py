# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write one CSV file for a folder of FreeCAD documents, with a line for each operation.

The macro asks for the folder. The macro opens documents without a window and does not change them. A document that is
already open stays open. The report view shows the names of files that FreeCAD cannot open.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import FreeCAD

import vkworkbench


def folder_to_csv(folder, table):
    """Analyse all documents below a folder and write a table; return the number of operations in the table."""
    whole = None
    for path in sorted(Path(folder).rglob("*.FCStd")):
        open_before = FreeCAD.listDocuments()
        try:
            document = FreeCAD.openDocument(str(path), True)  # hidden; returns the same document if it is already open
        except (OSError, RuntimeError) as error:
            FreeCAD.Console.PrintError(f"{path}: {error}\n")
            continue
        report = vkworkbench.analyze(document)
        if document.Name not in open_before:
            FreeCAD.closeDocument(document.Name)
        FreeCAD.Console.PrintMessage(f"{path}: {len(report.operations)} operations\n")
        rows = tuple(replace(operation, document=str(path)) for operation in report.operations)
        whole = replace(report, operations=rows if whole is None else whole.operations + rows)
    if whole is None:
        raise ValueError(f"there is no FreeCAD document in {folder}")
    whole.to_csv(table)
    return len(whole.operations)


if __name__ == "__main__":
    from PySide import QtGui

    chosen = QtGui.QFileDialog.getExistingDirectory(None, "Folder of FreeCAD documents")
    if chosen:
        written = Path(chosen, "operations.csv")
        count = folder_to_csv(chosen, str(written))
        FreeCAD.Console.PrintMessage(f"{count} operations in {written}\n")
