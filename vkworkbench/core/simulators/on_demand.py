# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide a mapping whose values are computed at their first use."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Iterator
from typing import Any, Mapping


class OnDemand(Mapping[str, Any]):
    """Mapping from names to values, each of which is computed once, at its first use.

    `makers` contains the function that computes each value; the function raises KeyError if the value does not exist.
    If the computation of a value fails, the mapping does not contain the value, and the error is written to the log.
    Iterating over the mapping, copying it or pickling it computes all values. Converting the mapping to `bool` computes
    no value.
    """

    def __init__(self, makers: dict[str, Callable[[], Any]]) -> None:
        self._names = tuple(makers)
        self._makers = dict(makers)  # a function is deleted after its call, to free the objects that it uses
        self._made: dict[str, Any] = {}
        self._lock = threading.RLock()

    def __getitem__(self, name: str) -> Any:
        with self._lock:
            if name in self._makers:
                try:
                    self._made[name] = self._makers[name]()
                except KeyError:
                    pass
                except Exception:
                    logging.getLogger(__name__).exception("%s could not be computed", name)
                del self._makers[name]
            return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return (name for name in self._names if name in self)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __bool__(self) -> bool:
        return bool(self._names)

    def __repr__(self) -> str:
        return repr(dict(self))

    def __reduce__(self) -> tuple[type, tuple[dict[str, Any]]]:
        return dict, (dict(self),)

    def computed(self) -> tuple[str, ...]:
        """Return the names of the values that have been computed."""
        return tuple(self._made)
