# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watch documents, and make a mark in the tree outdated when the path, tool or stock of its operation changes.

FreeCAD reports every changed property. The watcher collects relevant changes, and compares the marks with their
operations when the recompute, undo or redo is over. Changes while a document is being opened are ignored. Marks of
objects that are copied or moved into a document are compared, too, because these objects can belong to another job now.
"""

from __future__ import annotations

from collections.abc import Iterator

import FreeCAD

from vkworkbench import freecad
from vkworkbench.document.computer import idle
from vkworkbench.document.job.fingerprint import Settings, finding_path_fingerprint
from vkworkbench.document.job.operations import find, has_toolpath, job_of, kind
from vkworkbench.document.job.previous import previous_job
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.properties import is_mark, may_have_mark

_ON_OPERATION = freecad.names_in_fingerprint("path")
# Properties of tools, stocks and groups. A change concerns all operations and jobs that use the tool, stock or group.
_ON_SETTING = freecad.names_in_fingerprint("setting")


class Watcher:
    """An observer of all documents that keeps the state of their marks up to date."""

    def __init__(self) -> None:
        self._paths: dict[str, set[str]] = {}
        self._settings: set[str] = set()
        self._new: dict[str, set[str]] = {}

    def slotCreatedObject(self, obj) -> None:
        # Skip a document that is being opened (restoring, but not importing): its objects are not copies.
        if has_toolpath(obj) and obj.Document.Restoring == obj.Document.Importing:
            name = obj.Document.Name
            self._new.setdefault(name, set()).add(obj.Name)
            idle.later(f"copies in {name}", lambda: self._look_at_new(name))

    def slotChangedObject(self, obj, name: str) -> None:
        # An undo, or an aborted undo step, can restore a mark that belongs to an earlier path and setting.
        brought_back = obj.Document.Transacting and is_mark(obj, name)
        if name in _ON_OPERATION or brought_back:
            if may_have_mark(obj) and not obj.Document.Restoring:
                self._paths.setdefault(obj.Document.Name, set()).add(obj.Name)
                if brought_back:
                    self._settings.add(obj.Document.Name)
        elif name in _ON_SETTING and not obj.Document.Restoring:
            self._settings.add(obj.Document.Name)

    def slotRecomputedDocument(self, document) -> None:
        self._look(document)

    slotUndoDocument = slotRedoDocument = slotCommitTransaction = slotAbortTransaction = slotRecomputedDocument

    def slotStartSaveDocument(self, document, path: str) -> None:
        self._look(document)

    def slotDeletedDocument(self, document) -> None:
        self._paths.pop(document.Name, None)
        self._settings.discard(document.Name)
        self._new.pop(document.Name, None)

    def _look(self, document) -> None:
        name = document.Name
        changed, new = self._paths.pop(name, set()), self._copies(document)
        setting_changed = name in self._settings or bool(new)
        self._settings.discard(name)
        if changed or setting_changed:
            idle.work(comparing(document, changed | new, settings=setting_changed))

    def _copies(self, document) -> set[str]:
        """Return the names of marked objects that were copied into a document."""
        new = map(document.getObject, self._new.pop(document.Name, ()))
        return {obj.Name for obj in new if obj is not None and may_have_mark(obj)}

    def _look_at_new(self, name: str) -> None:
        if name in FreeCAD.listDocuments():
            self._look(FreeCAD.getDocument(name))


def check(document) -> None:
    """Compare all marks in a document's tree with their operations at once; see `comparing`."""
    for _ in comparing(document):
        pass


def comparing(
    document, paths: set[str] | None = None, *, settings: bool = True, opened: bool = False
) -> Iterator[None]:
    """Compare marks with their operations in steps of milliseconds, and make marks outdated or valid again.

    `paths` contains the names of the operations whose path has possibly changed since the mark; None stands for all
    operations. `settings` is True if tools, stocks or groups have possibly changed since the marks. If the document was
    just opened (`opened`), the stock that FreeCAD adds to each opened job without a stock does not make a mark
    outdated.
    """
    settings_of = Settings(opened=opened).of
    if settings or paths is None:
        objects = [operation.object for operation in find(document)]
        jobs = {obj.Name: obj for obj in document.Objects if kind(obj) == "job"}
    else:
        objects = [obj for obj in map(document.getObject, paths) if obj is not None]
        jobs = {obj.Name: obj for obj in objects if kind(obj) == "job"}
    for obj in objects:
        if obj.Name in jobs or not may_have_mark(obj):
            continue
        path_changed = paths is None or obj.Name in paths
        if path_changed:
            yield from finding_path_fingerprint(obj)
        if marks.refresh(obj, settings_of, path_changed=path_changed, setting_changed=settings):
            job = job_of(obj)
            if job is not None:
                jobs[job.Name] = job
        yield
    for obj in document.Objects if jobs else ():
        if kind(obj) == "job" and getattr(previous_job(obj), "Name", None) in jobs:
            jobs.setdefault(obj.Name, obj)
    for job in jobs.values():
        marks.refresh_total(job)
        yield
