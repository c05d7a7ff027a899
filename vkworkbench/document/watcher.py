# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks that stay true: a mark says "outdated" when its operation's path, tool or stock changed.

FreeCAD tells of every changed property. Those that matter are noted, and the marks are compared when the recompute,
undo or redo that changed them is over. Nothing is noted while a document is being restored.
"""

from __future__ import annotations

from vkworkbench import freecad
from vkworkbench.document import marks
from vkworkbench.document.fingerprint import read_setting_fingerprint
from vkworkbench.document.mark_properties import may_have_mark
from vkworkbench.document.operations import find, job_of, kind, through_bases

_ON_OPERATION = freecad.names_in_fingerprint("path")
# Changes that reach operations and jobs by way of their tool, stock or group.
_ON_SETTING = freecad.names_in_fingerprint("setting")


class Watcher:
    """An observer of all documents."""

    def __init__(self) -> None:
        self._paths: dict[str, set[str]] = {}
        self._settings: set[str] = set()

    def slotChangedObject(self, obj, name: str) -> None:
        if name in _ON_OPERATION:
            if may_have_mark(obj) and not obj.Document.Restoring:
                self._paths.setdefault(obj.Document.Name, set()).add(obj.Name)
        elif name in _ON_SETTING and not obj.Document.Restoring:
            self._settings.add(obj.Document.Name)

    def slotRecomputedDocument(self, document) -> None:
        self._look(document)

    def slotUndoDocument(self, document) -> None:
        self._look(document)

    def slotRedoDocument(self, document) -> None:
        self._look(document)

    def slotDeletedDocument(self, document) -> None:
        self._paths.pop(document.Name, None)
        self._settings.discard(document.Name)

    def _look(self, document) -> None:
        changed = self._paths.pop(document.Name, set())
        setting_changed = document.Name in self._settings
        self._settings.discard(document.Name)
        if changed or setting_changed:
            check(document, changed, settings=setting_changed)


def check(document, paths: set[str] | None = None, *, settings: bool = True) -> None:
    """Compare marks with their operations and say "outdated" where they differ.

    Parameters
    ----------
    document : Document
    paths : set of str, optional
        Operations whose path may differ; all of them if None.
    settings : bool
        Whether tools, stocks or groups may differ.
    """
    known: dict[tuple, str] = {}

    def setting_of(obj) -> str:
        job, controller = job_of(obj), through_bases(obj, freecad.CONTROLLER)
        key = tuple(getattr(one, "Name", None) for one in (job, controller))
        if key not in known:
            known[key] = read_setting_fingerprint(obj, job)
        return known[key]

    if settings or paths is None:
        objects = [operation.object for operation in find(document)]
    else:
        objects = [obj for obj in map(document.getObject, paths) if obj is not None]
    changed = [
        obj
        for obj in objects
        if marks.refresh(obj, setting_of, path_changed=paths is None or obj.Name in paths, setting_changed=settings)
    ]
    if settings:
        jobs = [obj for obj in document.Objects if kind(obj) == "job"]
    else:
        jobs = {job.Name: job for job in map(job_of, changed) if job is not None}.values()
    for job in jobs:
        marks.refresh_total(job)
