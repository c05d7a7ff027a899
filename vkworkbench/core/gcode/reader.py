# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the text of an NC program into commands, in mm and mm/s.

The dialect is RS274/NGC (Kramer, Proctor and Messina, NISTIR 6556, 2000) with additions from Fanuc, Haas, Mach3, grbl
and LinuxCNC. Heidenhain's DIN/ISO is read as far as it moves the tool. This module splits each line into words; the
interpreter converts the words into commands.
"""

from __future__ import annotations

import re

import numpy as np

from vkworkbench.core.gcode import dialects
from vkworkbench.core.gcode.blocks import split_comments, split_words
from vkworkbench.core.gcode.comments.tool_table import tool_told
from vkworkbench.core.gcode.interpreter import Interpreter
from vkworkbench.core.gcode.moves.program import Program
from vkworkbench.core.gcode.moves.units import INCH
from vkworkbench.core.gcode.subprograms import PROGRAM_NUMBER, Subprograms
from vkworkbench.core.gcode.variables import FLOW, Variables
from vkworkbench.core.toolpath import Problem
from vkworkbench.language import Message

_OKUMA_LETTERS = re.compile(r"(?<![A-Z])([HD])[ABC](?![A-Z\d=])")
_COOLANT = frozenset([("M", 7.0), ("M", 8.0), ("M", 9.0)])
_DWELL = ("G", 4.0)
_MODES = frozenset([*(("G", float(code)) for code in (20, 21, 40, 90, 91, 92)), ("M", 3.0), ("M", 4.0), ("M", 5.0)])
_HEIDENHAIN_NAME = re.compile(r"(?:N\s*\d+\s*)?%\s*\S+\s+G(7[01])$")  # first and last line of a program
_PERCENT = re.compile(r"(?:N\s*\d+\s*)?%")  # a block number may precede the sign
_CHECKSUM = re.compile(r"^(N[^#=\[]*?)\s*\*\s*\d{1,3}$|\s*\*$")
_BLOCK_DELETE = re.compile(r"^(N\s*\d+\s*)?(?:/\d?\s*)+")
# Lines that do not move the tool: queries and unlock commands for grbl, and print commands for Fanuc and Haas.
_SAYS = re.compile(r"\?|\$[$#GINXC]?|(?:N\s*\d+\s*)?(?:POPEN|PCLOS|[BD]PRNT\s*\[.*)")
_RETURN = re.compile(r"M\s*99(?!\d)")
# Fanuc's words for rounding (,R) or chamfering (,C) the corner after a move, and for the angle of a move (,A).
_CORNER = re.compile(r",\s*([RCA])\s*[-+]?(?:\d+\.?\d*|\.\d+)")
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")  # X10,5
# Siemens' radius of an arc, CR=10, and Siemens' spelling of a word with an equals sign, X=10.
_EQUALS = re.compile(r"(?<![A-Z])(?:CR|([A-Z]))\s*=\s*(?=[-+]?\.?\d)")
# One foreign word in a line, and a line that begins with a motion.
_FOREIGN = re.compile(r"[^\sA-Z\[\]#=<>]{1,20}|[A-Z]{3,20}", re.ASCII)
_MOVE = re.compile(r"(?:N\s*\d+\s*)?G\s*0*[0-3](?![\d.])")
_SUB = re.compile(r"^\s*(?:N\s*\d+\s*)?O\s*(?:\d+|<[^>]*>|\[[^]]*\])\s*(SUB|ENDSUB)\b")
# A word whose number is a variable or an expression: X#1, Z#<depth>, Y[1 + 2].
_MACRO_WORD = re.compile(r"[A-Z]\s*[-+]?\s*(?:#+(?:\d+|<[^>]*>)|\[[^\[\]]*(?:\[[^\[\]]*\][^\[\]]*)*\])")
# Largest depth of calls within calls; largest number of lines read in calls, counted once for each call.
_DEEPEST, _MOST_CALLED = 10, 1_000_000


def read_program(text: str) -> Program:
    """Read the text of an NC program.

    Lines with a block delete (``/``) are read like other lines, and reported. Lines after M2 or M30 are read as part of
    the program, up to the number of another program. If the program calls its own blocks (M97, or M98 with Q), the
    lines after the end are subprograms, and are read only at their calls. A subprogram in the same text, called with
    M98 or M97, is read at each call, as if all its words were in the line of the call. A variable is replaced by the
    number that the program assigns to it.

    Not read, but reported as a problem with the line: other variables, all variables in programs with jumps,
    expressions, subprograms outside of this text, and subprograms that are called in other ways.

    Parameters
    ----------
    text : str
        Text of the program, with any kind of line ends.

    Raises
    ------
    Unusable
        If the text is not an NC program, contains no moves, or is written in the language of another control.
    """
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    reader = _Reader(lines, dialects.dialect_of(text))
    for index in range(len(lines)):
        reader.number = index + 1
        if reader.line(index):
            reader.after_end(index + 1)
            break
    return reader.program()


class _Reader:
    """The lines read so far: their commands, comments and problems.

    Attributes
    ----------
    number : int
        The current line, counted from 1. In a subprogram, the line of the call, so that the lines of the commands never
        decrease.
    """

    def __init__(self, lines: list[str], dialect: dialects.Dialect) -> None:
        self.lines = lines
        self.subprograms = Subprograms(lines)
        self.variables = Variables(lines)
        self.machine = Interpreter(dialect)
        if dialect.raw_path:
            self.machine.problem(Message("feeds-per-second"), 1)
        self.comments: list[tuple[int, int, str]] = []
        self.in_calls: set[int] = set()
        self.in_subprogram = 0
        self.in_called = False  # whether this line belongs to a subprogram that is read only at its calls
        self.passed: list[int] = []  # indices of lines with the number of a subprogram that is read only at its calls
        self.ran: set[int] = set()  # indices of the lines that were read in calls
        self.calls: list[int] = []  # first lines of the current subprograms, from the outermost call to the innermost
        self.lent = 0  # number of lines read in calls; a line is counted at each call
        self.deleted = False  # whether this line has a block delete
        self.number = 0
        self.blocks = 0
        self.strange: list[int] = []

    def line(self, index: int) -> bool:
        """Read one line; return whether the line ends the program, or the current subprogram."""
        line = self.lines[index]
        code, comments = split_comments(line)
        code = code.strip().upper()
        if "*" in code:  # the end of a block, and its checksum
            code = _CHECKSUM.sub(r"\1", code)
        if "%" in code:
            ends = self._percent(code)
            if ends is not None:
                return ends
        self.deleted = "/" in code and _BLOCK_DELETE.match(code) is not None
        if self.deleted:
            code = _BLOCK_DELETE.sub(r"\1", code)
        if code[:4] == "M117":  # the rest of the line is a message to the operator
            code, comments = "", [line.strip()[4:].strip()]
        if not code:
            self._keep(comments)
            return False
        if code[0] in "$?NPBD" and _SAYS.fullmatch(code):
            return False
        if self.machine.ended and (code[0] in "O:" or self.machine.calls_blocks):
            return True
        if (self.in_called or code[0] in "O:") and self._skips(index, code):
            return False
        if self.deleted:
            self._problem(Message("block-delete"))
        return self._block(index, code, comments)

    def _percent(self, code: str) -> bool | None:
        """Return whether a line with a percent sign ends the program; None if the sign has no meaning."""
        if name := _HEIDENHAIN_NAME.match(code):
            return self.machine.heidenhain(self.number, 10 * int(name[1]))
        if percent := _PERCENT.match(code):
            return self.machine.motion >= 0 and percent.end() == len(code)
        return None

    def _skips(self, index: int, code: str) -> bool:
        """Return whether a line belongs to a subprogram that is read only at its calls."""
        if code[0] in "O:":
            program = PROGRAM_NUMBER.match(code)
            called = program is not None and int(program[1]) in self.subprograms.called
            self.in_called = called and not self.calls
            if self.in_called:
                self.passed.append(index)
        if not self.in_called:
            return False
        self.in_called = self.deleted or not _RETURN.search(code)
        return True

    def _block(self, index: int, code: str, comments: list[str]) -> bool:
        """Pass the words of a line to the interpreter, and run the subprogram that the line calls.

        Returns
        -------
        bool
            Whether the line ends the program, or the current subprogram.
        """
        self.blocks += 1
        plain, rest = split_words(code)
        words = self._strange(self.lines[index], code, rest) if rest or self.in_subprogram else plain
        if words is None:
            self._keep(comments)
            return False
        letters = {letter for letter, _ in words}
        if "L" in letters and letters <= {"N", "L", "P"}:  # a subprogram call: L10 P3 (Siemens) or L0103 (Fadal)
            self._problem(Message("subprogram-not-read"))
        if letters.isdisjoint("XYZ") or not letters.isdisjoint("TMO"):
            self._keep(comments if not letters.isdisjoint("TO") else _no_explanations(words, comments))
        ended = self.machine.block(self.number, words, letters, deleted=self.deleted)
        if self.calls and not self.deleted:  # M99 with a P word also returns to the caller
            ended |= _RETURN.search(code) is not None
        if self.machine.call is not None:
            self._call(self.machine.call, dict(words), index)
        return ended

    def _call(self, m_code: float, words: dict[str, float], caller: int) -> None:
        """Run a subprogram in the same text; report a problem if it is not found or calls itself.

        Also report a call that is nested deeper than `_DEEPEST`, or exceeds the `_MOST_CALLED` lines.
        """
        found = self.subprograms.find(m_code, words, caller)
        if found is None or found[0] in self.calls or len(self.calls) == _DEEPEST:
            self._problem(Message("subprogram-not-read"))
            return
        first, times = found
        self.calls.append(first)
        self.machine.enter_call()
        if not all(self._run(first) for _ in range(times)):
            self._problem(Message("subprogram-not-read"))
        self.machine.leave_call()
        self.calls.pop()

    def _run(self, first: int) -> bool:
        """Run the subprogram that begins at a line; return whether its end was reached within `_MOST_CALLED` lines."""
        for index in range(first, self.subprograms.end(first)):
            if self.lent == _MOST_CALLED:
                return False
            self.lent += 1
            self.ran.add(index)
            if self.line(index):
                break
        return True

    def _keep(self, comments: list[str]) -> None:
        kept = [(len(self.machine.commands), self.number, text) for text in comments if text]
        if self.calls:
            self.in_calls.update(range(len(self.comments), len(self.comments) + len(kept)))
        self.comments += kept

    def _problem(self, what: Message, line: int | None = None) -> None:
        self.machine.problem(what, self.number if line is None else line)

    def _strange(self, line: str, code: str, rest: str) -> list[tuple[str, float]] | None:
        """Return the words of a line that also contains other text; None if the line cannot be read."""
        if self._of_subprogram(code):
            return None
        if "#" in rest:
            code = self.variables.put_in(code)
            if not code:
                return None
        if code[0] == "<":  # XML or HTML: an equals sign does not assign a variable
            self._no_words()
            return None
        dialects.refuse(line.strip().upper(), code, self.number)
        if FLOW.search(code):
            self._problem(Message("jumps-not-followed"))
            return None
        code = self._common_spelling(code)
        words, rest = split_words(code)
        if "#" in rest or "[" in rest or "=" in rest:
            words, rest = split_words(_MACRO_WORD.sub(" ", code))
            self._problem(Message("line-with-variables") if rest else Message("variables-not-read"))
            return None if rest else words
        if rest in ("", "N") or (rest != ":" and PROGRAM_NUMBER.fullmatch(rest)):  # N without a number; :1000
            return words
        if rest == ":":  # some programs have a colon before a comment without parentheses
            return None
        if _FOREIGN.fullmatch(rest) and _MOVE.match(code):
            self._problem(Message("foreign-text"))
            return words
        self._no_words()
        return None

    def _of_subprogram(self, code: str) -> bool:
        """Return whether a line belongs to a LinuxCNC subprogram, from O word with SUB to O word with ENDSUB.

        Subprograms of this kind are not read.
        """
        subprogram = _SUB.match(code)
        if subprogram:
            self._problem(Message("subprogram-not-read"))
            self.in_subprogram = max(self.in_subprogram + (1 if subprogram[1] == "SUB" else -1), 0)
        return subprogram is not None or self.in_subprogram > 0

    def _common_spelling(self, code: str) -> str:
        """Return the code in the common spelling of words.

        ``,R`` is left out and reported, decimal commas become points, ``HA`` and ``X=`` are respelled.
        """
        _, rest = split_words(code)
        if "," in rest and _DECIMAL_COMMA.search(code):
            self._problem(Message("decimal-commas"))
            code = _DECIMAL_COMMA.sub(".", code)
            _, rest = split_words(code)
        if "," in rest:
            for letter in _CORNER.findall(code):
                self._problem(Message("word-not-read", letter=f",{letter}"))
            code = _CORNER.sub(" ", code)
            _, rest = split_words(code)
        if "H" in rest or "D" in rest:
            code = _OKUMA_LETTERS.sub(r"\g<1>0", code)
            _, rest = split_words(code)
        if "=" in rest:
            code = _EQUALS.sub(lambda word: word[1] or "R", code)
        return code

    def _no_words(self) -> None:
        self.strange.append(self.number)
        self._problem(Message("words-not-read"))

    def after_end(self, first: int) -> None:
        """Report the first move at or after this line (an index) that was not read in a call."""
        for index in range(first, len(self.lines)):
            if index in self.ran:
                continue
            self.number, line = index + 1, self.lines[index]
            words, _ = split_words(split_comments(line)[0].upper())
            if any(letter in "XYZ" for letter, _ in words):
                self._problem(Message("after-end"))
                return

    def program(self) -> Program:
        for index in self.passed:
            if index not in self.ran:
                self._problem(Message("subprogram-not-read"), index + 1)
        machine = self.machine
        problems = tuple(Problem.at(sorted(lines), what) for what, lines in machine.problems.items())
        dialects.check(self.blocks, self.strange, machine.moves, problems)
        return Program(
            machine.with_tool_changes(), np.array(machine.lines, np.int64), tuple(self.comments),
            frozenset(self.in_calls), machine.inverse_time,
            machine.first_unit == INCH, machine.first_unit is not None, machine.clues.other_machine(),
            tuple(machine.clues.rotary), problems,
        )  # fmt: skip


def _no_explanations(words: list[tuple[str, float]], comments: list[str]) -> list[str]:
    """Return the comments of a line, without comments that explain the line's codes.

    All comments beside a coolant code are explanations. Beside a dwell, a mode (`_MODES`), or only a feed rate or
    speed, all comments are explanations except for descriptions of tools.
    """
    codes = {word for word in words if word[0] in "GM"}
    if not _COOLANT.isdisjoint(codes):
        return []
    says_modes = bool(codes) or any(letter in "SF" for letter, _ in words)
    if _DWELL in codes or (says_modes and codes <= _MODES):  # pcb2gcode describes the next tool beside a dwell
        return [comment for comment in comments if tool_told(comment, inches=False) is not None]
    return comments
