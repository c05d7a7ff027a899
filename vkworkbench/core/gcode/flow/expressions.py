# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the expressions of a program line into postfix lists, and calculate the values of these lists.

The grammar is RS274/NGC's (Kramer, Proctor and Messina, NISTIR 6556, 2000), with the functions of Fanuc controls.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, Tuple

from vkworkbench.core.gcode.flow import functions
from vkworkbench.core.gcode.flow.ended import Ended, Unreadable
from vkworkbench.core.gcode.flow.variables import Variables
from vkworkbench.language import Message

# An expression as a postfix list, which is calculated in order with a stack. Each item has a kind (_NUMBER to
# _EXISTS_NUMBERED), and the number, name or function that the item uses.
Postfix = Tuple[Tuple[int, Any], ...]
_NUMBER, _NEGATE, _UNARY, _BINARY, _ON_VACANT, _NUMBERED, _NAMED, _EXISTS, _EXISTS_NUMBERED = range(9)

_DIGITS = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:E[-+]?\d+)?")
_INDEX = re.compile(r"\d+\.?\d*")  # without an exponent, because E5 in the line X#1 E5 is another word
_NAME = re.compile(r"<([^<>]+)>")
_FUNCTION = re.compile(r"([A-Z]+)\[")
_OPERATOR = re.compile(r"\*\*|[-+*/]|MOD|AND|XOR|OR|EQ|NE|GT|GE|LT|LE")
_DEEPEST = 40  # Largest depth of nested brackets, and of nested variables such as ###1.
_LARGEST = 1e300  # A result with a larger absolute value is an error in the program.


class Parser:
    """Reader of the values in a program line, from left to right.

    Parameters
    ----------
    code : str
        The line in capitals, without comments and spaces.
    fanuc : bool
        Whether the program is written for a Fanuc control.

    Attributes
    ----------
    at : int
        Index of the next character in `code`.
    """

    def __init__(self, code: str, *, fanuc: bool) -> None:
        self.code = code
        self.at = 0
        self._fanuc = fanuc
        self._depth = 0

    def peek(self) -> str:
        """Return the next character; an empty text at the end of the line."""
        return self.code[self.at : self.at + 1]

    def take(self, text: str) -> bool:
        """Skip a text if the rest of the line begins with the text; return whether the text was skipped."""
        follows = self.code.startswith(text, self.at)
        self.at += len(text) if follows else 0
        return follows

    def match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """Skip the text that matches a pattern at the current character; return the match, or None."""
        found = pattern.match(self.code, self.at)
        if found:
            self.at = found.end()
        return found

    def computed(self) -> bool:
        """Return whether the rest of the line begins with a variable, a bracket or a function."""
        at = self.at
        while self.code[at : at + 1] in ("+", "-"):
            at += 1
        if self.code[at : at + 1] in ("#", "["):
            return True
        function = _FUNCTION.match(self.code, at)
        return function is not None and self._knows(function[1])

    def value(self) -> Postfix:
        """Read a number, variable, bracket or function.

        Raises
        ------
        Unreadable
            If the rest of the line does not begin with a value.
        """
        self._depth += 1
        if self._depth > _DEEPEST:
            raise Unreadable
        negative = False
        while (sign := self.peek()) in ("+", "-") and sign:
            negative ^= sign == "-"
            self.at += 1
        if self.take("["):
            code = self._bracket()
        elif self.take("#"):
            code = self.variable()
        elif function := self.match(_FUNCTION):
            code = self._function(function[1])
        else:
            code = ((_NUMBER, self._number()),)
        self._depth -= 1
        return (*code, (_NEGATE, None)) if negative else code

    def variable(self) -> Postfix:
        """Read the number or name of a variable after its ``#``; return the postfix list of the variable's value."""
        name = self.match(_NAME)
        if name:
            return ((_NAMED, name[1]),)
        index = self.match(_INDEX)
        if index:
            return ((_NUMBER, _finite(index[0])), (_NUMBERED, None))
        return (*self.value(), (_NUMBERED, None))

    def expression(self) -> Postfix:
        """Read an expression: values with operators between the values."""
        operands, operators = [self.value()], []
        while operator := self.match(_OPERATOR):
            operators.append(operator[0])
            operands.append(self.value())
        return self._in_order(operands, operators)

    def _number(self) -> float:
        digits = self.match(_DIGITS)
        if digits is None:
            raise Unreadable
        return _finite(digits[0])

    def _bracket(self) -> Postfix:
        """Read an expression and its closing bracket, after the opening bracket."""
        code = self.expression()
        if not self.take("]"):
            raise Unreadable
        return code

    def _in_order(self, operands: list[Postfix], operators: list[str]) -> Postfix:
        """Return the postfix list of an expression; operators of equal precedence are calculated from left to right."""
        of_fanuc = self._fanuc and functions.COMPARISONS.isdisjoint(operators)
        rank = functions.RANK_OF_FANUC if of_fanuc else functions.RANK
        code = list(operands[0])
        waiting: list[str] = []
        for operator, operand in zip(operators, operands[1:]):
            while waiting and rank[waiting[-1]] >= rank[operator]:
                code.append(self._binary(waiting.pop()))
            waiting.append(operator)
            code += operand
        code += [self._binary(operator) for operator in reversed(waiting)]
        return tuple(code)

    def _binary(self, name: str) -> tuple[int, Any]:
        table = functions.BINARY_OF_FANUC if self._fanuc else functions.BINARY
        return (_ON_VACANT if self._fanuc and name in functions.ON_VACANT else _BINARY), table[name]

    def _knows(self, name: str) -> bool:
        return name in self._unary or name in ("ATAN", "EXISTS", "POW")

    @property
    def _unary(self) -> dict[str, functions.Unary]:
        return functions.UNARY_OF_FANUC if self._fanuc else functions.UNARY

    def _function(self, name: str) -> Postfix:
        """Read the arguments of a function, after its opening bracket."""
        if name == "EXISTS":
            return self._exists()
        if name in ("ATAN", "POW"):
            return self._of_two(name)
        function = self._unary.get(name)
        if function is None:
            raise Unreadable
        return (*self._bracket(), (_UNARY, function))

    def _exists(self) -> Postfix:
        """Read the variable in the brackets of EXISTS. The value of the variable is not read."""
        if not self.take("#"):
            raise Unreadable
        *code, (kind, name) = self.variable()
        if not self.take("]"):
            raise Unreadable
        return (*code, (_EXISTS if kind == _NAMED else _EXISTS_NUMBERED, name))

    def _of_two(self, name: str) -> Postfix:
        """Read ATAN[y]/[x], Fanuc's ATAN[y] and ATAN[y, x], or POW[x, y]."""
        function = functions.arc_tangent if name == "ATAN" else functions.BINARY["**"]
        first = self.expression()
        if self.take(",") or (name == "ATAN" and self.take("]/[")):
            second = self._bracket()
        elif name == "ATAN" and self._fanuc and self.take("]"):
            second = ((_NUMBER, 1.0),)
        else:
            raise Unreadable
        return (*first, *second, (_BINARY, function))


def _finite(digits: str) -> float:
    """Return the number that a text of digits contains."""
    number = float(digits)
    if number >= _LARGEST:
        raise Unreadable
    return number


def evaluate(code: Postfix, variables: Variables) -> float | None:
    """Return the value of an expression; None for an empty variable of a Fanuc control.

    Raises
    ------
    Unknown
        If the value comes from the machine.
    Ended
        If the control raises an alarm, for example for a division by zero.
    """
    stack: list[Any] = []
    for kind, what in code:
        if kind == _NUMBER:
            stack.append(what)
        elif kind == _NUMBERED:
            stack[-1] = variables.numbered(stack[-1])
        elif kind == _NAMED:
            stack.append(variables.named(what))
        elif kind == _NEGATE:
            stack[-1] = None if stack[-1] is None else -stack[-1]  # if #1 is empty, the word X-#1 is left out
        elif kind == _UNARY:
            stack[-1] = _result(what, stack[-1] or 0.0)
        elif kind == _BINARY:
            right = stack.pop() or 0.0
            stack[-1] = _result(what, stack[-1] or 0.0, right)
        elif kind == _ON_VACANT:
            right = stack.pop()
            stack[-1] = float(what(stack[-1], right))
        elif kind == _EXISTS:
            stack.append(float(variables.exists(what)))
        else:
            stack[-1] = 1.0  # EXISTS is true for every variable with a number
    return stack[0]


def _result(function: Callable[..., float], *values: float) -> float:
    try:
        result = function(*values)
    except (ArithmeticError, ValueError):
        raise Ended(Message("no-result")) from None
    if not -_LARGEST < result < _LARGEST:  # a NaN also raises Ended, because comparisons with NaN are false
        raise Ended(Message("no-result"))
    return result
