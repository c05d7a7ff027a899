# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognize the dialect of a text, and refuse texts that are not G-code for a mill."""

from __future__ import annotations

import re
from itertools import chain

from vkworkbench.core.gcode.dialects.dialect import RAW_PATH, RS274, SIEMENS, Dialect
from vkworkbench.core.toolpath import Problem
from vkworkbench.language import Message, Unusable

_HEIDENHAIN = re.compile(
    r"^(?:\d+\s*)?(?:(?:BEGIN|END) PGM\b|BLK FORM\b|TOOL (?:CALL|DEF)\b|CYCL DEF\b|(?:L|CC|LN)\s+I?[XYZ][-+]?\d|C\s+I?X.*\bDR[-+])"
)
_SIEMENS = re.compile(
    r"=\s*(?:AC|IC|DC|ACP|ACN)\b|(?<![\w<])(?:MCALL|EXTCALL|WORKPIECE|SUPA|STOPRE)\b|\bT\s*=\s*\"|^\$PATH"
    r"|^(?:DEF\s+(?:REAL|INT|BOOL|STRING)|PROC|A?TRANS|A?ROT|A?MIRROR)\b"
)
# Siemens' words with an equals sign, for corners, angles, polar coordinates, turns of a helix and R parameters. Only R
# parameters are recognised at the beginning of a line, where other words can be variables of an Okuma control.
_SIEMENS_WORD = re.compile(
    r"^[A-Z]\s*[-+]?[\d.].*[\d.\s](?:AR|AP|RP|RND|RNDM|CHF|CHR|TURN)\s*="
    r"|(?<![A-Z#<])[A-Z]\s*=\s*-?\s*R\d|^R\d+\s*="
)
_SIEMENS_CYCLE = re.compile(r"^(?:/\d?\s*)?(?:N\s*\d+\s*)?(?:CYCLE\d+|POCKET\d|SLOT\d|HOLES\d|LONGHOLE)\s*\(")
_LINE_NUMBER = re.compile(r"^N\s*\d+\s*")
# Macro lines for Fanuc controls and LinuxCNC, whose variable names can look like words of a Siemens or Heidenhain
# control.
_VARIABLES = re.compile(r"#|IF|GOTO")
# Lines that occur only in programs for Siemens controls, and that can be read as plain G-code.
_OF_SIEMENS = re.compile(
    r"^%_N_|\bG(?:5\d\d|45[01]|60[123]|64[1-5]|7[01]0)\b|\bMSG\s*\(|(?<![A-Z])(?:CR|[XYZIJK])\s*=\s*-?[.\d]",
    re.MULTILINE | re.IGNORECASE,
)
_INCHES_OF_SIEMENS = re.compile(r"\bG70(?!\d)", re.IGNORECASE)
# A move with a feed rate in the text of a FreeCAD path that was not converted by a post processor. The words are in the
# order of the alphabet and have six decimals; feed rates are in mm/s.
_FEEDS = re.compile(r"^[ \t]*(?:N\d+[ \t]*)?G0*[1-3]\b[^(;\n]*F[^(;\n]*", re.MULTILINE | re.IGNORECASE)
_FEED_OF_PATH = re.compile(
    r"\s*(?:N\d+\s*)?G0*[123]\s*F\d+\.\d{6}(?:\s*[I-KX-Z]-?\d+\.\d{6})+\s*", re.ASCII | re.IGNORECASE
)


def dialect_of(text: str) -> Dialect:
    """Return the dialect of the text of an NC program."""
    feeds = _FEEDS.finditer(text)
    first = next(feeds, None)
    if first is not None and all(_FEED_OF_PATH.fullmatch(feed[0]) for feed in chain([first], feeds)):
        return RAW_PATH
    if _INCHES_OF_SIEMENS.search(text) is not None and _OF_SIEMENS.search(text) is not None:
        return SIEMENS
    return RS274


def at_line(problem: Problem) -> Message:
    """Return the message for a problem in an NC program, with the problem's first line and its number of occurrences.

    The problem's `command` must be a line of the text.
    """
    return Message("at-line", what=problem.what, line=problem.command, count=problem.count)


def refuse(text: str, code: str, line: int) -> None:
    """Raise Unusable if a line is in the language of a Heidenhain or Siemens control.

    Parameters
    ----------
    text, code : str
        The line with and without its comments. `text` is needed because parentheses may also contain the arguments of a
        Siemens cycle.
    line : int
        Line of the text, counted from 1.
    """
    code = _LINE_NUMBER.sub("", code)
    if _VARIABLES.match(code):
        return
    siemens = _SIEMENS.search(code) or _SIEMENS_WORD.search(code) or _SIEMENS_CYCLE.search(text)
    for control, found in (("Heidenhain", _HEIDENHAIN.search(text)), ("Siemens", siemens)):
        if found:
            raise Unusable(Message("other-control", name=control, line=line))


def check(blocks: int, strange: list[int], moves: bool, problems: tuple[Problem, ...]) -> None:
    """Raise Unusable if a text is not an NC program, or contains no moves.

    Parameters
    ----------
    blocks : int
        Number of lines read that contain more than comments.
    strange : list of int
        Numbers of the lines with text that cannot be read as words, except for variables and jumps. If more than half
        of the lines cannot be read as words, the text is not an NC program.
    moves : bool
        Whether any line moves the tool.
    problems : tuple of Problem
        The parts of the program that were not read.
    """
    if 2 * len(strange) > blocks:
        raise Unusable(Message("no-words", part=len(strange), lines=blocks, line=strange[0]))
    if not moves:
        if problems:
            raise Unusable(Message("no-moves-read", problems=[at_line(problem) for problem in problems]))
        raise Unusable(Message("moves-nothing"))
