# SPDX-License-Identifier: LGPL-2.1-or-later
"""What callers give, checked where it enters: the errors say what an argument takes, and what it got."""

from __future__ import annotations

from collections.abc import Callable
from operator import index
from os import PathLike
from reprlib import repr as shortened
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")


def positive(number: float) -> bool:
    """Whether a number is finite and more than 0."""
    return 0 < number < np.inf


def not_negative(number: float) -> bool:
    """Whether a number is finite and at least 0."""
    return 0 <= number < np.inf


def number(name: str, given: Any, takes: str, fits: Callable[[float], bool] = lambda _: True) -> float:
    """Return a number that was given; FreeCAD's quantities are numbers, and so are texts of one.

    Parameters
    ----------
    name : str
        What the argument is called.
    given : object
    takes : str
        What it takes, e.g. ``"a positive number of mm"``.
    fits : callable
        Tells whether it takes that number; any by default.

    Raises
    ------
    ValueError
        Where it does not take this number, or text.
    TypeError
        Where it is nothing like a number.
    """
    return _read(name, given, takes, float, fits)


def numbers(name: str, given: Any, takes: str, fits: Callable[[np.ndarray], bool] = lambda _: True) -> np.ndarray:
    """Return an array of float64 that was given, itself if it is one; the arguments and errors are those of `number`."""
    return _read(name, given, takes, lambda given: np.asarray(given, float), fits)


def whole(name: str, given: Any, takes: str, fits: Callable[[int], bool] = lambda _: True) -> int:
    """Return a whole number that was given; the arguments and errors are those of `number`, but 1.0 is none."""
    return _read(name, given, takes, index, fits)


def of_kind(name: str, given: Any, kinds: Any, takes: str) -> None:
    """Check that what was given is of a type, or of one of several.

    Raises
    ------
    TypeError
        Where it is not.
    """
    if not isinstance(given, kinds):
        raise TypeError(f"{name} is {takes}, not {type(given).__name__}")


def check_file_name(path: Any) -> None:
    """Check that `path` names a file: a number would be one that is open; the error is that of `of_kind`."""
    of_kind("path", path, (str, bytes, PathLike), "the name of a file")


def _read(name: str, given: Any, takes: str, read: Callable[[Any], T], fits: Callable[[T], bool]) -> T:
    kind: type[Exception] = ValueError
    try:
        found = read(given)
        if fits(found):
            return found
    except TypeError:
        kind = TypeError
    except (ValueError, OverflowError):
        pass
    raise kind(f"{name} must be {takes}, not {shortened(given)}")
