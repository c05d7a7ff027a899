# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the arguments of public functions. The error messages name the accepted values and the given value."""

from __future__ import annotations

from collections.abc import Callable
from operator import index
from os import PathLike
from reprlib import repr as shortened
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")


def positive(number: float) -> bool:
    """Return whether a number is finite and greater than 0."""
    return 0 < number < np.inf


def not_negative(number: float) -> bool:
    """Return whether a number is finite and at least 0."""
    return 0 <= number < np.inf


def number(name: str, given: Any, takes: str, fits: Callable[[float], bool] = lambda _: True) -> float:
    """Return an argument as a float. FreeCAD's quantities and numbers as text are accepted, too.

    `name` is the name of the argument, and `takes` describes the accepted values, such as ``"a positive number of
    mm"``. The function `fits` returns whether a number is accepted. A ValueError is raised if the number or text is not
    accepted, and a TypeError if the type is not accepted.
    """
    return _read(name, given, takes, float, fits)


def numbers(name: str, given: Any, takes: str, fits: Callable[[np.ndarray], bool] = lambda _: True) -> np.ndarray:
    """Return an argument as an array of float64, copied only if necessary. Parameters and errors are as in `number`."""
    return _read(name, given, takes, lambda given: np.asarray(given, float), fits)


def whole(name: str, given: Any, takes: str, fits: Callable[[int], bool] = lambda _: True) -> int:
    """Return an argument as an int. Floats such as 1.0 are not accepted. Parameters and errors are as in `number`."""
    return _read(name, given, takes, index, fits)


def of_kind(name: str, given: Any, kinds: Any, takes: str) -> None:
    """Raise a TypeError if an argument is not an instance of `kinds`; `takes` describes the accepted values."""
    if not isinstance(given, kinds):
        raise TypeError(f"{name} is {takes}, not {type(given).__name__}")


def check_file_name(path: Any) -> None:
    """Check that `path` is the name of a file, not the number of an open file, which `open` would accept.

    A value of another type raises the TypeError of `of_kind`.
    """
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
