# SPDX-License-Identifier: LGPL-2.1-or-later
"""A folder of FreeCAD documents to one CSV: a line for each operation of each of them.

Run it as a macro: it asks for the folder. The documents are opened without a window and not changed; one that is open
already is analysed as it is and stays open. A file that FreeCAD cannot open is named in the report view and left out.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import FreeCAD

import vkworkbench


def folder_to_csv(folder, table):
    """Analyse the documents below a folder into a table; return how many operations it has."""
    whole = None
    for path in sorted(Path(folder).rglob("*.FCStd")):
        open_before = FreeCAD.listDocuments()
        try:
            document = FreeCAD.openDocument(str(path), True)  # hidden; one that is open already is that document itself
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
