# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parse one line of an NC program: control statement, assignments, and words whose values are expressions."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache

from vkworkbench.core.gcode.blocks import split_comments
from vkworkbench.core.gcode.flow.ended import Unreadable
from vkworkbench.core.gcode.flow.expressions import Parser, Postfix

_LONGEST = 1000  # largest number of characters in a line that is parsed; LinuxCNC reads up to 255
_MOST_ARGUMENTS = 30
_BLOCK_DELETE = re.compile(r"(N\d+)?(?:/\d?)+")
_NUMBER = re.compile(r"N\d+(?:\.\d+)?")
_DIGITS = re.compile(r"(\d+)")
_NAME = re.compile(r"<([^<>]*)>")
_KEYWORD = re.compile("ENDSUB|SUB|CALL|RETURN|ELSEIF|ELSE|ENDIF|IF|ENDWHILE|WHILE|DO|ENDREPEAT|REPEAT|BREAK|CONTINUE")
# For each keyword of an O-word with values: the smallest and the largest number of values after the keyword.
_VALUES = {"IF": (1, 1), "ELSEIF": (1, 1), "WHILE": (0, 1), "REPEAT": (1, 1), "CALL": (0, _MOST_ARGUMENTS),
           "RETURN": (0, 1), "ENDSUB": (0, 1)}  # fmt: skip
_LETTERS = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ")


@dataclass(frozen=True)
class Control:
    """A statement that decides which program line follows, such as IF or GOTO.

    Attributes
    ----------
    keyword : str
        Keyword of an O-word; for a statement of a Fanuc control, ``IF-GOTO``, ``IF-THEN``, ``GOTO``, ``DO-N`` or
        ``END-N``.
    label : str or Postfix
        Name or number of an O-word, or an expression for the number; for Fanuc's DO and END, the loop's number.
    values : tuple of Postfix
        The condition of IF and WHILE, the number of runs of REPEAT, the arguments of CALL, or the block number of GOTO.
        In ``IF-GOTO``, the condition precedes the block number.
    then : Words or None
        The words after THEN in ``IF-THEN``; None in other statements.
    """

    keyword: str
    label: str | Postfix = ""
    values: tuple[Postfix, ...] = ()
    then: Words | None = None


@dataclass(frozen=True)
class Words:
    """A program line of words and assignments.

    Attributes
    ----------
    assigned : tuple of (Postfix, Postfix)
        For each assignment, the postfix list that reads the variable, and the postfix list of the new value.
    pieces : tuple of (str, str, Postfix)
        For each word with a computed value: the text before the word, the letter, and the postfix list of the value.
    rest : str
        The text after the last word with a computed value.
    """

    assigned: tuple[tuple[Postfix, Postfix], ...]
    pieces: tuple[tuple[str, str, Postfix], ...]
    rest: str


def bare(line: str) -> str:
    """Return a line in capitals, without comments, spaces and block delete."""
    code = "".join(split_comments(line)[0].split()).upper()
    return _BLOCK_DELETE.sub(r"\1", code, count=1) if "/" in code[:12] and _BLOCK_DELETE.match(code) else code


def label_of(name: str) -> str:
    """Return the label of an O-word without leading zeros, so that O01 and O1 are equal."""
    return name.lstrip("0")


@lru_cache(maxsize=500)
def parse_line(code: str, *, fanuc: bool) -> Control | Words:
    """Parse a line in capitals, without comments and spaces.

    Raises
    ------
    Unreadable
        If the line contains no macro statement, variable or expression, or if one of these contains an error.
    """
    # A quoted text for the operator can contain #, which is then not a variable.
    if len(code) > _LONGEST or '"' in code:
        raise Unreadable
    control = _control(code, fanuc=fanuc)
    if control is not None:
        return control
    if "#" not in code and "[" not in code:
        raise Unreadable
    return _words(Parser(code, fanuc=fanuc))


def _control(code: str, *, fanuc: bool) -> Control | None:
    parser = Parser(code, fanuc=fanuc)
    parser.match(_NUMBER)
    if parser.take("O"):
        return _o_word(parser)
    if parser.take("IF"):
        control = _if(parser)
    elif parser.take("GOTO"):
        control = Control("GOTO", values=(parser.value(),))
    elif parser.take("END"):
        control = Control("END-N", _number(parser))
    elif code.startswith(("WHILE[", "DO"), parser.at):
        condition = (parser.value(),) if parser.take("WHILE") else ()
        if not parser.take("DO"):
            raise Unreadable
        control = Control("DO-N", _number(parser), condition)
    else:
        return None
    return _at_end(parser, control)


def _at_end(parser: Parser, control: Control) -> Control:
    """Return the control statement of a line; raise Unreadable if other text follows the statement."""
    if parser.peek():
        raise Unreadable
    return control


def _number(parser: Parser) -> str:
    digits = parser.match(_DIGITS)
    if digits is None:
        raise Unreadable
    return label_of(digits[0])


def _o_word(parser: Parser) -> Control | None:
    """Return the control statement of an O-word; None for an O-word with the number of a program."""
    name = parser.match(_NAME) or parser.match(_DIGITS)
    if name:
        label: str | Postfix = label_of(name[1])
    elif parser.computed():
        label = parser.value()
    else:
        return None
    keyword = parser.match(_KEYWORD)
    if keyword is None:
        return None
    values: list[Postfix] = []
    while parser.peek() == "[":
        values.append(parser.value())
    least, most = _VALUES.get(keyword[0], (0, 0))
    if not least <= len(values) <= most:
        raise Unreadable
    return _at_end(parser, Control(keyword[0], label, tuple(values)))


def _if(parser: Parser) -> Control:
    """Return Fanuc's IF with GOTO or THEN."""
    if parser.peek() != "[":
        raise Unreadable
    condition = parser.value()
    if parser.take("GOTO"):
        return Control("IF-GOTO", values=(condition, parser.value()))
    if parser.take("THEN"):
        return Control("IF-THEN", values=(condition,), then=_words(parser))
    raise Unreadable


def _words(parser: Parser) -> Words:
    assigned: list[tuple[Postfix, Postfix]] = []
    pieces: list[tuple[str, str, Postfix]] = []
    code, begin = parser.code, parser.at  # `begin` is the index of the first character that `pieces` does not contain
    while parser.peek():
        at, character = parser.at, parser.peek()
        if character == "#":
            parser.at += 1
            variable = parser.variable()
            if parser.take("="):
                assigned.append((variable, parser.expression()))
                pieces.append((code[begin:at], "", ()))
            else:
                pieces.append((code[begin:at], "", variable))
        elif character == "[":
            pieces.append((code[begin:at], "", parser.value()))
        else:
            parser.at += 1
            if character not in _LETTERS or not parser.computed():
                continue
            pieces.append((code[begin:at], character, parser.value()))
        begin = parser.at
    return Words(tuple(assigned), tuple(pieces), code[begin:])
