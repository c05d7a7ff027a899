# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fingerprints of the paths as they are now, kept until FreeCAD tells that one changed. Loads no numpy.

To take that of a long path takes its time; and whether a path changed since it was read is known by whether its
fingerprint is still kept.
"""

from __future__ import annotations

import FreeCAD

from vkworkbench import freecad

_ON_PATH = freecad.names_in_fingerprint("path")


class PathPrints:
    """An observer of all documents, from the first fingerprint on."""

    def __init__(self) -> None:
        self._watches = False
        # By the names of documents and objects: a fingerprint, or the token of one that is being found.
        self._kept: dict[str, dict[str, str | object]] = {}

    def of(self, obj) -> str | None:
        """Return the fingerprint of an object's path as it is now; None where it is not known."""
        kept = self._kept.get(obj.Document.Name, {}).get(obj.Name)
        return kept if isinstance(kept, str) else None

    def begin(self, obj) -> object:
        """Return the token of a fingerprint that is to be found of an object's path as it is now.

        Several may look for the same one: the first that has it finds it for all.
        """
        if not self._watches:
            FreeCAD.addDocumentObserver(self)
            self._watches = True
        return self._kept.setdefault(obj.Document.Name, {}).setdefault(obj.Name, object())

    def end(self, whose: tuple[str, str], token: object, fingerprint: str) -> None:
        """Keep a fingerprint, unless none was found or the path has changed since `begin`."""
        document, name = whose
        if fingerprint and self._kept.get(document, {}).get(name) is token:
            self._kept[document][name] = fingerprint

    def slotChangedObject(self, obj, name: str) -> None:
        if name in _ON_PATH:
            self._kept.get(obj.Document.Name, {}).pop(obj.Name, None)

    def slotCreatedObject(self, obj) -> None:
        self._kept.get(obj.Document.Name, {}).pop(obj.Name, None)

    def slotDeletedDocument(self, document) -> None:
        self._kept.pop(document.Name, None)


#: Those of all open documents.
PATH_PRINTS = PathPrints()
