# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a document as one undo step."""

from __future__ import annotations

from contextlib import contextmanager

import FreeCAD


@contextmanager
def transaction(document, name: str):
    """Make changes as one undo step, or as part of an open step. If a change fails, the new step is undone."""
    if document.HasPendingTransaction or FreeCAD.getActiveTransaction():
        yield
        return
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        FreeCAD.closeActiveTransaction(True)
        raise
    # document.commitTransaction() would leave the step open if nothing changed or the document keeps no undo steps. The user's
    # next changes, in any document, would then join the step.
    FreeCAD.closeActiveTransaction()
