# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the text of an NC program into commands, in mm and mm/s.

The dialect is RS274/NGC (Kramer, Proctor and Messina, NISTIR 6556, 2000) with additions from Fanuc, Haas, Mach3, grbl
and LinuxCNC. The codes of Heidenhain's DIN/ISO that move the tool are also read. This module splits each program line
into words, and `Interpreter` converts the words into commands.
"""

from __future__ import annotations

import re

import numpy as np

from vkworkbench.core.gcode import dialects
from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, Lines, split_comments, split_words, whole
from vkworkbench.core.gcode.comments.tool_table import tool_told
from vkworkbench.core.gcode.flow import PROGRAM_NUMBER, Call, Ended, Flow, Step, Subprograms, arguments
from vkworkbench.core.gcode.interpreter import Interpreter
from vkworkbench.core.gcode.moves.program import Program
from vkworkbench.core.gcode.moves.units import INCH
from vkworkbench.core.gcode.plain_lines import PlainLines
from vkworkbench.core.toolpath import Problem
from vkworkbench.language import Message

_OKUMA_LETTERS = re.compile(r"(?<![A-Z])([HD])[ABC](?![A-Z\d=])")
_COOLANT = frozenset([("M", 7.0), ("M", 8.0), ("M", 9.0)])
_DWELL = ("G", 4.0)
_MODES = frozenset([*(("G", float(code)) for code in (20, 21, 40, 90, 91, 92)), ("M", 3.0), ("M", 4.0), ("M", 5.0)])
# The first line and the last line of a Heidenhain program.
_HEIDENHAIN_NAME = re.compile(r"(?:N\s*\d+\s*)?%\s*\S+\s+G(7[01])$")
_PERCENT = re.compile(r"(?:N\s*\d+\s*)?%")  # a block number can precede the percent sign
_CHECKSUM = re.compile(r"^(N[^#=\[]*?)\s*\*\s*\d{1,3}$|\s*\*$")
_BLOCK_DELETE = re.compile(r"^(N\s*\d+\s*)?(?:/\d?\s*)+")
# Program lines that do not move the tool: grbl's queries and unlock command, and Fanuc's and Haas' print commands.
_SAYS = re.compile(r"\?|\$[$#GINXC]?|(?:N\s*\d+\s*)?MSG|(?:N\s*\d+\s*)?(?:POPEN|PCLOS|[BD]PRNT\s*\[.*)")
_RETURN = re.compile(r"M\s*(?:99|17)(?!\d)")  # M17 is Siemens' return from a subprogram
_CALL_IN_COMMENT = re.compile(r"(?:RPT\s*N|P?CALL|GOTO\s*N)\s*\d", re.IGNORECASE)  # Fagor's repeats and calls
# Heidenhain's call of a label: L1,3 repeats the lines from label 1 to the call three times, L1 and L1,0 run a subprogram.
_LABEL_CALL = re.compile(r"(?:N\s*\d+\s*)?L\s*(\d+)(?:\s*,\s*(\d+))?")
_CORNER = re.compile(r"\s*(?:N\s*\d+\s*)?G\s*2([45])\s*R\s*\+?\s*([\d.]+)")  # Heidenhain's G24 (chamfer), G25
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")  # A decimal comma, as in X10,5.
# Siemens' radius of an arc, CR=10, and Siemens' spelling of a word with an equals sign, X=10.
_EQUALS = re.compile(r"(?<![A-Z])(?:CR|([A-Z]))\s*=\s*(?=[-+]?\.?\d)")
# Text that is not a word of G-code. The reader ignores text that is not a word in a line that begins with a motion
# (`_MOVE`).
_FOREIGN = re.compile(r"[^\s\d.+\-A-Z\[\]#=<>]{1,20}|[A-Z]{3,20}", re.ASCII)
_MOVE = re.compile(r"(?:N\s*\d+\s*)?G\s*0*[0-3](?![\d.])")
# Statements for jumps, loops and calls, in lines that cannot be parsed.
_FLOW = re.compile(r"\b(IF|THEN|ELSE|WHILE|GOTO|DO\s*\d|END\s*\d|ENDIF|ENDWHILE|REPEAT)|^O\s*[\d<].*\b(SUB|CALL|DO)\b")
_MACRO_CALL = ("G", 65.0)
_TOOL_DIAMETER = re.compile(r"#\s*<\s*_?TOOL_?DIA(?:METER)?\s*>\s*=\s*(\d+\.?\d*|\.\d+)$")
# A word whose value is a variable or an expression: X#1, Z#<depth>, Y[1 + 2].
_MACRO_WORD = re.compile(r"[A-Z]\s*[-+]?\s*(?:#+(?:\d+|<[^>]*>)|\[[^\[\]]*(?:\[[^\[\]]*\][^\[\]]*)*\])")


def read_program(text: str) -> Program:
    """Read the text of an NC program.

    Lines with a block delete (``/``) are read like other lines, and reported. Lines after M2 or M30 are read as part of
    the program, up to the number of another program. If a program calls its own blocks by M97 or M98 Q, or has loops,
    conditions or calls of macros, M2 and M30 end the program. A subprogram in the same text is read at each call, as if
    all words of the subprogram were in the line of the call. Variables and expressions are replaced by numbers. Loops,
    conditions and jumps are followed (`flow`).

    Three parts of a program are not read, but reported as problems with their lines: subprograms outside of this text,
    subprograms that are called in other ways, and the rest of a program from a line that cannot be followed.

    Parameters
    ----------
    text : str
        Text of the program. Lines can end with LF, CR or both.

    Raises
    ------
    Unusable
        If the text is not an NC program, contains no moves, or is written in the language of another control.
    """
    lines = Lines(text)
    reader = _Reader(lines, dialects.dialect_of(lines.text))
    reader.read()
    return reader.program()


class _Reader:
    """Reader of an NC program, with the commands, comments and problems of the lines read so far.

    Attributes
    ----------
    number : int
        Number of the current line, counted from 1. The number never decreases: in a subprogram, `number` is the line of
        the call. In lines that are read again, `number` is the last line before the jump.
    """

    def __init__(self, lines: Lines, dialect: dialects.Dialect) -> None:
        self.lines = lines
        self.subprograms = subprograms = Subprograms(lines)
        self.machine = Interpreter(dialect, lambda: subprograms.fanuc)
        self.flow = Flow(lines, subprograms, self.machine.coordinates)
        self.plain = PlainLines(lines)
        if dialect is dialects.RAW_PATH:
            self.machine.problem(Message("feeds-per-second"), 1)
        self.comments: list[tuple[int, int, str]] = []
        self.in_calls: set[int] = set()
        self.in_called = False  # Whether the current line belongs to a subprogram that is read only at its calls.
        self.passed: list[int] = []  # Indices of lines with the number of a subprogram that is read only at its calls.
        self.ran: set[int] = set()  # Indices of the lines that were read in calls.
        self.calls: list[int] = []  # Indices of the current subprograms' first lines, outermost call first.
        self.jump: int | None = None  # Index of the line to which the current line jumps; None without a jump.
        self.again = False  # Whether a jump back or a call led to a line that is not after line `number` in the text.
        self.deleted = False  # Whether the current line has a block delete.
        self.number = 0
        self.blocks = 0
        self.corner = -1  # Index of the line after the last line that was read with the corner of a Heidenhain program.
        self.strange: list[int] = []

    def read(self) -> None:
        """Read all lines, or the lines up to the end of the program."""
        try:
            last = self._run(0, len(self.lines))
        except Ended as ended:
            self._remark()
            self._problem(Message("read-up-to", why=ended.why))
        else:
            self._after_end(last + 1)

    def _run(self, index: int, end: int) -> int:
        """Read the lines from `index` to `end` - 1, and follow jumps.

        Returns
        -------
        int
            Index of the last line read, or `end` if no line ends the program or subprogram.
        """
        while index < end:
            self.again = self.number > index
            if not (self.again or self.calls or self.in_called):
                index, blocks = self.plain.read(self.machine, index, end)
                self.blocks += blocks
                if index == end:
                    break
            if self.again or self.calls:
                self.flow.count_line(len(self.machine.commands))
                self.ran.add(index)
            else:
                self.number = index + 1
            if self.line(index):
                return index
            index += 1
            if self.jump is not None:
                index, self.jump = self.jump, None
        return end

    def line(self, index: int) -> bool:
        """Read one line; return whether the line ends the program, or the current subprogram."""
        line = self.lines[index]
        code, comments = self._split(line)
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
        if code[0] in "$?NPBDM" and _SAYS.fullmatch(code):
            return False
        if self.machine.ended and code[0] in "O:":
            return True
        if (self.in_called or code[0] in "O:") and self._skips(index, code):
            return False
        if self.deleted:
            self._problem(Message("block-delete"))
        return self._block(index, code, comments)

    def _split(self, line: str) -> tuple[str, list[str]]:
        """Return the code of a line in capitals, without a checksum, and the comments of the line."""
        code, comments = split_comments(line)
        code = code.strip().upper()
        if comments and _CALL_IN_COMMENT.match(comments[0]):
            self._problem(Message("subprogram-not-read"))
        if "*" in code:  # an asterisk ends the words of a line; a checksum can follow
            code = _CHECKSUM.sub(r"\1", code)
        # After grbl's homing cycle $H, the position is unknown, as after G28.
        return ("G28" if code == "$H" else code), comments

    def _percent(self, code: str) -> bool | None:
        """Return whether a line with a percent sign ends the program; None if the sign has no meaning in the line."""
        if name := _HEIDENHAIN_NAME.match(code):
            return self.machine.heidenhain(self.number, 10 * int(name[1]))
        if percent := _PERCENT.match(code):
            if self.machine.dialect is dialects.HEIDENHAIN:  # %NAME calls another program
                self._problem(Message("subprogram-not-read"))
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
        if self.machine.dialect is dialects.HEIDENHAIN:
            code = self._without_labels(index, code)
        words, rest = split_words(code)
        if rest:
            # A variable for the tool's diameter is read as a comment on the tool.
            if diameter := _TOOL_DIAMETER.search(code):
                comments = [f"tool diameter = {diameter[1]}", *comments]
            step = self.flow.step(index, code)
            self._remark()
            if step is not None:
                code = step.code
                if not code:
                    self._keep(comments)
                    return self._follow(step)
            found = self._rest(self.lines[index], code)
            if found is None:
                self._keep(comments)
                return False
            words = found
        letters = {letter for letter, _ in words}
        if "L" in letters and letters <= {"N", "L", "P"}:  # a subprogram call: L10 P3 (Siemens) or L0103 (Fadal)
            self._problem(Message("subprogram-not-read"))
        if letters.isdisjoint("XYZ") or not letters.isdisjoint("TMO"):
            self._keep(comments if not letters.isdisjoint("TO") else _no_explanations(words, comments))
        if "P" in letters and _MACRO_CALL in words and self._call_macro(words):
            return self._ended
        ended = self.machine.block(self.number, words, letters, deleted=self.deleted)
        # M99 with a P word also returns to the caller.
        if self.calls and self.machine.dialect.calls and not self.deleted:
            ended |= _RETURN.search(code) is not None
        if self.machine.call is not None:
            self._call(self.machine.call, dict(words), index)
        return ended or (self.machine.ended and self._ended)

    @property
    def _ended(self) -> bool:
        """Whether M2 or M30 ended the program, so that the lines after M2 or M30 are subprograms or error messages."""
        return self.machine.ended and (self.machine.calls_blocks or self.flow.followed)

    def _follow(self, step: Step) -> bool:
        """Follow a jump or a call; return whether the program or the current subprogram ends."""
        self.jump = step.to
        if step.call is not None:
            self._run_call(step.call)
        return step.returns or self._ended

    def _call(self, m_code: float, words: dict[str, float], caller: int) -> None:
        """Run a subprogram in the same text; report a problem if the subprogram is not found or calls itself."""
        found = self.subprograms.find(m_code, words, caller)
        if found is None or found[0] in self.calls:
            self._problem(Message("subprogram-not-read"))
            return
        first, times = found
        self._run_call(Call(first, self.subprograms.end(first), times))

    def _without_labels(self, index: int, code: str) -> str:
        """Return a line of a Heidenhain program with the corner in the next line as a corner word (,R or ,C).

        If the line calls a label, run the lines after the label, and return an empty text. The line of the corner itself
        is also returned as an empty text.
        """
        if found := _LABEL_CALL.fullmatch(code):
            call = self.subprograms.label(int(found[1]), index, int(found[2] or 0))
            if call is None or call.first in self.calls:
                self._problem(Message("subprogram-not-read"))
            else:
                self.machine.calls_blocks = True
                self._run_call(call)
            return ""
        if _CORNER.match(code):
            if index != self.corner:
                self._problem(Message("word-not-read", letter="R"))
            return ""
        after = index + 1
        while after < len(self.lines) and not split_comments(self.lines[after])[0].strip():
            after += 1
        corner = _CORNER.match(self.lines[after].upper()) if after < len(self.lines) else None
        self.corner = after
        return f"{code} ,{'R' if corner[1] == '5' else 'C'}{corner[2]}" if corner else code

    def _call_macro(self, words: list[tuple[str, float]]) -> bool:
        """Run a macro with the arguments in a line with G65; return whether the macro is in the same text."""
        values = dict(words)
        first = self.subprograms.program(values["P"])
        if first is None:
            return False
        before = words[: words.index(_MACRO_CALL)]
        self.machine.block(self.number, before, {letter for letter, _ in before}, deleted=self.deleted)
        times = whole(values.get("L", 1.0), LARGEST_NUMBER)
        self._run_call(Call(first, self.subprograms.end(first), times, arguments(words)))
        return True

    def _run_call(self, call: Call) -> None:
        """Run a subprogram as many times as its call says."""
        self.flow.begin_call(call)
        self.calls.append(call.first)
        for _ in range(call.times):
            self.flow.enter(call.frame)
            self.machine.enter_call()
            self._run(call.first, call.end)
            self.machine.leave_call()
            self.flow.leave(call.frame)
        self.calls.pop()
        self.flow.end_call()
        self.jump = None

    def _keep(self, comments: list[str]) -> None:
        if self.again and not self.calls:  # comments in a loop are stored only at the first run
            return
        kept = [(len(self.machine.commands), self.number, text) for text in comments if text]
        if self.calls:
            self.in_calls.update(range(len(self.comments), len(self.comments) + len(kept)))
        self.comments += kept

    def _problem(self, what: Message, line: int | None = None) -> None:
        self.machine.problem(what, self.number if line is None else line)

    def _remark(self) -> None:
        """Report the remarks of `Flow` on the current line."""
        for what in self.flow.remarks:
            self._problem(what)
        self.flow.remarks.clear()

    def _rest(self, line: str, code: str) -> list[tuple[str, float]] | None:
        """Return the words of a line that also contains other text; None if the line cannot be read."""
        words, rest = split_words(code)
        if not rest:
            return words
        if code[0] == "<":  # XML or HTML, in which an equals sign does not assign a variable
            self._no_words()
            return None
        line = _BLOCK_DELETE.sub(r"\1", line.partition(";")[0].strip().upper())
        machine, modes = self.machine, self.machine.modes
        if cycle := dialects.drilling(line):
            machine.drill(self.number, cycle)
            return None
        relative = ("G", 91.0) in words or (modes.relative and ("G", 90.0) not in words)
        shift = {axis: value / modes.unit for axis, value in machine.origins.shift.items()}
        spelled = dialects.spelled(line, machine.coordinates(), shift, relative=relative)
        if spelled is not None:
            line, code = spelled, split_comments(spelled)[0].strip()
        dialects.refuse(line, code, self.number)
        if _FLOW.search(code):
            self._problem(Message("jumps-not-followed"))
            return None
        code = self._common_spelling(code)
        words, rest = split_words(code)
        if "#" in rest or "[" in rest or "=" in rest:
            words, rest = split_words(_MACRO_WORD.sub(" ", code))
            self._problem(Message("line-with-variables") if rest else Message("variables-not-read"))
            return None if rest else words
        # An N without a number, or a program number such as :1000.
        if rest in ("", "N") or (rest != ":" and PROGRAM_NUMBER.fullmatch(rest)):
            return words
        if rest == ":":  # some programs have a colon before a comment without parentheses
            return None
        letters = [letter for letter, _ in words if letter not in "GM"]  # a letter twice shows a damaged line
        if _FOREIGN.fullmatch(rest) and _MOVE.match(code) and len(set(letters)) == len(letters):
            self._problem(Message("foreign-text"))
            return words
        self._no_words()
        return None

    def _common_spelling(self, code: str) -> str:
        """Return the code in the common spelling of words.

        Decimal commas are replaced by points, ``HA`` by ``H0``, ``X=`` by ``X``, and ``CR=`` by ``R``.
        """
        _, rest = split_words(code)
        if "," in rest and _DECIMAL_COMMA.search(code):
            self._problem(Message("decimal-commas"))
            code = _DECIMAL_COMMA.sub(".", code)
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

    def _after_end(self, first: int) -> None:
        """Report the first line with a move, at or after the index `first`, that was not read in a call."""
        # Lines of a called subprogram are not reported, because a subprogram can skip some of its lines.
        ran = {self.subprograms.head(index) for index in self.ran} if self.flow.followed else set()
        for index in range(first, len(self.lines)):
            if index in self.ran or self.subprograms.head(index) in ran:
                continue
            self.number, line = index + 1, self.lines[index]
            words, _ = split_words(split_comments(line)[0].upper())
            if any(letter in "XYZ" for letter, _ in words):
                self._problem(Message("after-end"))
                return

    def program(self) -> Program:
        # If the program's conditions were followed, an uncalled subprogram is not an error: a condition can skip its
        # call.
        passed = self.passed if not self.flow.followed else [] if self.machine.moves else sorted(self.flow.passed)
        for index in passed:
            if index not in self.ran:
                self._problem(Message("subprogram-not-read"), index + 1)
        machine = self.machine
        problems = tuple(Problem.at(sorted(lines), what) for what, lines in machine.problems.items() if lines)
        dialects.check(self.blocks, self.strange, machine.moves, problems)
        return Program(
            machine.with_tool_changes(), np.array(machine.lines, np.int64), tuple(self.comments),
            frozenset(self.in_calls), machine.inverse_time,
            machine.first_unit == INCH, machine.first_unit is not None, machine.clues.other_machine(),
            tuple(machine.clues.rotary), problems, tuple(machine.dwells),
        )  # fmt: skip


def _no_explanations(words: list[tuple[str, float]], comments: list[str]) -> list[str]:
    """Return the comments of a line, without comments that only explain the line's codes.

    In a line with a coolant code, every comment explains the code. In a line with a dwell, a mode (`_MODES`), or only a
    feed rate or a spindle speed, every comment that does not describe a tool explains the line.
    """
    codes = {word for word in words if word[0] in "GM"}
    if not _COOLANT.isdisjoint(codes):
        return []
    says_modes = bool(codes) or any(letter in "SF" for letter, _ in words)
    if _DWELL in codes or (says_modes and codes <= _MODES):  # pcb2gcode describes the next tool in the line of a dwell
        return [comment for comment in comments if tool_told(comment, inches=False) is not None]
    return comments
