# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make several changes of a document as one undo step."""

from __future__ import annotations

from contextlib import contextmanager

import FreeCAD


@contextmanager
def transaction(document, name: str):
    """Make the changes in the context as one undo step, or as part of an open step. On an error, undo the new step."""
    if document.HasPendingTransaction or FreeCAD.getActiveTransaction():
        yield
        return
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        FreeCAD.closeActiveTransaction(True)
        raise
    # document.commitTransaction() would leave the step open if nothing changed, or if the document stores no undo
    # steps. The user's next changes, in any document, would then become a part of the step.
    FreeCAD.closeActiveTransaction()
