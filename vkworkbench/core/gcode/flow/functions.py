# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the operators and functions of expressions, for LinuxCNC and for Fanuc controls.

Angles are in degrees. The functions raise ArithmeticError or ValueError if a control would raise an alarm.
"""

from __future__ import annotations

import math
from typing import Any, Callable  # not from collections.abc, whose Callable has no [] in Python 3.8

Unary = Callable[[float], float]
Binary = Callable[[Any, Any], float]

_EQUAL = 1e-4  # In LinuxCNC, EQ is true if two numbers differ by less than this limit.
_WHOLE_BITS = 1 << 53  # Whole numbers above this limit are not exact in a float.

LOGICAL = frozenset(["AND", "OR", "XOR"])
COMPARISONS = frozenset(["EQ", "NE", "GT", "GE", "LT", "LE"])
ON_VACANT = frozenset(["EQ", "NE"])  # on a Fanuc control, EQ and NE distinguish an empty variable from 0


def _round(value: float) -> float:
    return float(math.trunc(value + math.copysign(0.5, value)))


def _modulo(left: float, right: float) -> float:
    rest = math.fmod(left, right)
    return rest + abs(right) if rest < 0 else rest


def _power(left: float, right: float) -> float:
    if left < 0 and right % 1:
        raise ValueError("a root of a negative number")
    return float(left**right)


def _divide(left: float, right: float) -> float:
    return left / right


def arc_tangent(left: float, right: float) -> float:
    """Return the angle of the direction with x = `right` and y = `left`, degrees."""
    return math.degrees(math.atan2(left, right))


def _bits(operator: Callable[[int, int], int]) -> Binary:
    def combine(left: float, right: float) -> float:
        if max(abs(left), abs(right)) > _WHOLE_BITS:
            raise ValueError("a number with more bits than a control has")
        return float(operator(round(left), round(right)))

    return combine


UNARY: dict[str, Unary] = {
    "ABS": abs,
    "ACOS": lambda value: math.degrees(math.acos(value)),
    "ASIN": lambda value: math.degrees(math.asin(value)),
    "COS": lambda value: math.cos(math.radians(value)),
    "EXP": math.exp,
    "FIX": lambda value: float(math.floor(value)),
    "FUP": lambda value: float(math.ceil(value)),
    "LN": math.log,
    "ROUND": _round,
    "SIN": lambda value: math.sin(math.radians(value)),
    "SQRT": math.sqrt,
    "TAN": lambda value: math.tan(math.radians(value)),
}
UNARY_OF_FANUC: dict[str, Unary] = {
    **UNARY,
    "FIX": lambda value: float(math.trunc(value)),
    "FUP": lambda value: math.copysign(math.ceil(abs(value)), value),
    "RND": _round,
    "SQR": math.sqrt,
}
BINARY: dict[str, Binary] = {
    "**": _power,
    "*": lambda left, right: left * right,
    "/": _divide,
    "MOD": _modulo,
    "+": lambda left, right: left + right,
    "-": lambda left, right: left - right,
    "EQ": lambda left, right: float(abs(left - right) < _EQUAL),
    "NE": lambda left, right: float(abs(left - right) >= _EQUAL),
    "GT": lambda left, right: float(left > right),
    "GE": lambda left, right: float(left >= right),
    "LT": lambda left, right: float(left < right),
    "LE": lambda left, right: float(left <= right),
    "AND": lambda left, right: float(left != 0 and right != 0),
    "OR": lambda left, right: float(left != 0 or right != 0),
    "XOR": lambda left, right: float((left != 0) != (right != 0)),
}
BINARY_OF_FANUC: dict[str, Binary] = {
    **BINARY,
    "EQ": lambda left, right: float(left == right),
    "NE": lambda left, right: float(left != right),
    "AND": _bits(lambda left, right: left & right),
    "OR": _bits(lambda left, right: left | right),
    "XOR": _bits(lambda left, right: left ^ right),
}
_RANKS = (("**",), ("*", "/", "MOD"), ("+", "-"), tuple(COMPARISONS), tuple(LOGICAL))
RANK = {name: -rank for rank, names in enumerate(_RANKS) for name in names}
# Fanuc's precedence of operators in a bracket without a comparison: AND has the precedence of *, OR and XOR of +.
RANK_OF_FANUC = {**RANK, "AND": RANK["*"], "OR": RANK["+"], "XOR": RANK["+"]}
