# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cache of the fingerprints of paths. This module does not import numpy.

Computing the fingerprint of a long path is slow. A fingerprint is removed from the cache when FreeCAD reports a change
of its path. Therefore the path has not changed if its fingerprint is still in the cache.
"""

from __future__ import annotations

import FreeCAD

from vkworkbench import freecad

_ON_PATH = freecad.names_in_fingerprint("path")


class PathPrints:
    """A cache of fingerprints of paths, which observes all documents after the first fingerprint was requested."""

    def __init__(self) -> None:
        self._watches = False
        # Fingerprints of paths by the names of document and object; a token replaces a fingerprint being computed.
        self._kept: dict[str, dict[str, str | object]] = {}

    def of(self, obj) -> str | None:
        """Return the fingerprint of an object's current path; None if the cache does not contain the fingerprint."""
        kept = self._kept.get(obj.Document.Name, {}).get(obj.Name)
        return kept if isinstance(kept, str) else None

    def begin(self, obj) -> object:
        """Return the token for a fingerprint that the caller is about to compute.

        Several callers may compute the same fingerprint; the first result is stored for all of them.
        """
        if not self._watches:
            FreeCAD.addDocumentObserver(self)
            self._watches = True
        return self._kept.setdefault(obj.Document.Name, {}).setdefault(obj.Name, object())

    def end(self, whose: tuple[str, str], token: object, fingerprint: str) -> None:
        """Store a fingerprint, unless it is empty or the path has changed since `begin`."""
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


#: The fingerprints of all open documents.
PATH_PRINTS = PathPrints()
