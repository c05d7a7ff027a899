# SPDX-License-Identifier: LGPL-2.1-or-later
"""Perform the macro statements of a program, one program line after the other."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import cached_property

from vkworkbench.core.gcode.blocks import Lines
from vkworkbench.core.gcode.flow.ended import Ended, Unknown, Unreadable
from vkworkbench.core.gcode.flow.expressions import Postfix, evaluate
from vkworkbench.core.gcode.flow.lines import Control, Words, bare, parse_line
from vkworkbench.core.gcode.flow.step import Call, Step
from vkworkbench.core.gcode.flow.structure import Block, Structure
from vkworkbench.core.gcode.flow.subprograms import Subprograms
from vkworkbench.core.gcode.flow.variables import ALARM, Frame, Value, Variables
from vkworkbench.language import Message

# Largest number of program lines read in loops, after jumps back and in calls; a line is counted each time that it is
# read.
MOST_LINES = 1_000_000
MOST_IDLE_LINES = 100_000  # Largest number of successive lines in loops and calls that add no command.
MOST_STEPS = 20_000_000  # Largest number of calculation steps, which limits the time for all calculations.
DEEPEST = 10  # Largest depth of nested calls of subprograms.
# Largest number of commands of an NC program with loops, jumps or calls; a toolpath has at most this many moves.
MOST_COMMANDS = 5_000_000

_UNREAD = re.compile(r"#(?:(\d+)|<([^<>]+)>)=")  # An assignment to a variable, in a line that cannot be parsed.
# The beginning of a control statement (jump, loop, condition or call). The rest of the statement possibly contains an
# error.
_JUMP = re.compile(
    r"(?:N\d+)?(?:(?:IF|WHILE)\[|GOTO[\d#\[]|O(?:\d+|<[^<>]*>)(?:(?:END)?(?:SUB|IF|WHILE|REPEAT)|CALL|ELSE|DO|RETURN|BREAK|CONTINUE))"
)
# `_HARMLESS` are letters of words that do not change the tool's path. `_DATA` matches codes whose words are data: the
# time of a dwell, and offsets.
_HARMLESS = frozenset("DEFHST")
_NUMBER_ALONE = re.compile(r"(?:N[\d.]+)?")
_DATA = re.compile(r"G0*(?:4|10)(?!\d)")
# Names of the methods of Flow that perform control statements. Names are used because a table of bound methods would be
# a reference cycle, which would keep the whole text in memory.
_METHODS = {
    "IF": "_if", "ELSEIF": "_skip", "ELSE": "_skip", "ENDIF": "_go_on",
    "WHILE": "_while", "ENDWHILE": "_repeat_loop", "DO": "_go_on",
    "REPEAT": "_repeat", "ENDREPEAT": "_end_repeat", "BREAK": "_skip", "CONTINUE": "_continue",
    "SUB": "_skip", "ENDSUB": "_return", "RETURN": "_return", "CALL": "_call",
    "GOTO": "_go_to", "IF-GOTO": "_if_go_to", "IF-THEN": "_if_then",
    "DO-N": "_while", "END-N": "_repeat_loop",
}  # fmt: skip


class Flow:
    """The variables, loops and jumps of an NC program.

    Parameters
    ----------
    lines : Lines
        All lines of the NC program.
    subprograms : Subprograms
    place : callable
        Returns the known coordinates of the tool, by axis, in the program's unit.

    Attributes
    ----------
    remarks : list of Message
        Remarks on the current line. The caller of `step` reports the remarks and removes them from the list.
    followed : bool
        Whether a condition, loop, jump or call was followed.
    depth : int
        Number of nested calls at the current line.
    passed : set of int
        Indices of the lines that define subprograms.
    """

    def __init__(self, lines: Lines, subprograms: Subprograms, place: Callable[[], dict[str, float]]) -> None:
        self._lines, self._place = lines, place
        self._subprograms = subprograms
        self.remarks: list[Message] = []
        self.followed = False
        self.depth = 0
        self.passed: set[int] = set()
        self._read = 0
        self._idle = 0
        self._commands = 0
        # Value of `Variables.changes` at the last jump back from a line, by the index of the line. An unchanged value
        # at the next jump back from the line indicates an endless loop.
        self._jumps: dict[int, int] = {}
        self._steps = 0

    @cached_property
    def _variables(self) -> Variables:
        return Variables(fanuc=self._subprograms.fanuc, report=self.remarks.append, place=self._place)

    @cached_property
    def _structure(self) -> Structure:
        return Structure(self._lines, self._subprograms.heads)

    def step(self, index: int, code: str) -> Step | None:
        """Perform the macro statement of a line.

        Parameters
        ----------
        index : int
            Index of the line.
        code : str
            The line in capitals, without comments and block delete.

        Returns
        -------
        Step or None
            Effect of the macro statement on the lines that follow; None if the line contains no statement that can be
            parsed.

        Raises
        ------
        Ended
            If the lines that follow cannot be determined.
        """
        code = "".join(code.split())
        try:
            line = parse_line(code, fanuc=self._subprograms.fanuc)
        except Unreadable:
            if _JUMP.match(code):
                raise Ended(Message("jump-unread")) from None
            self._forget(code)
            return None
        if isinstance(line, Words):
            return Step(self._filled(line))
        self.followed = True
        step: Step = getattr(self, _METHODS[line.keyword])(index, line)
        if step.to is not None and step.to <= index:
            self._jump_back(index)
        return step

    def _jump_back(self, index: int) -> None:
        """Raise Ended if a loop is endless: no variable has changed since the last jump back from this line."""
        changes = self._variables.changes
        if self._jumps.get(index) == changes:
            raise Ended(Message("endless"))
        self._jumps[index] = changes

    def count_line(self, commands: int) -> None:
        """Count a program line that is read in a loop, after a jump back or in a call; raise Ended at a limit.

        Parameters
        ----------
        commands : int
            Number of commands of the program lines read so far.
        """
        self._read += 1
        self._idle = self._idle + 1 if commands == self._commands else 0
        self._commands = commands
        if self._read > MOST_LINES:
            raise Ended(Message("too-many-lines-run", count=MOST_LINES))
        if self._idle > MOST_IDLE_LINES:
            raise Ended(Message("too-many-lines-idle", count=MOST_IDLE_LINES))
        if commands > MOST_COMMANDS:
            raise Ended(Message("too-many-moves-run", count=MOST_COMMANDS))

    def begin_call(self, call: Call) -> None:
        """Begin a call of a subprogram; raise Ended if the number of runs or the depth of nested calls is too large."""
        if self.depth == DEEPEST:
            raise Ended(Message("too-many-calls", count=DEEPEST))
        if call.times > MOST_LINES - self._read:
            raise Ended(Message("too-many-lines-run", count=MOST_LINES))
        self.depth += 1

    def end_call(self) -> None:
        """End a call of a subprogram, after the subprogram's last run."""
        self.depth -= 1

    def enter(self, frame: Frame | None) -> None:
        """Begin a run of a subprogram with its own variables `frame`, or if None, with the variables of its caller."""
        self._variables.changes += 1
        if frame is not None:
            self._variables.frames.append(Frame(dict(frame.numbers)))

    def leave(self, frame: Frame | None) -> None:
        """End a run of a subprogram."""
        if frame is not None:
            self._variables.frames.pop()

    def _forget(self, code: str) -> None:
        """Store that the variables to which a line assigns values are unknown, because the line cannot be parsed."""
        for number, name in _UNREAD.findall(code):
            unknown = Message("value-unread", name=f"#{number}" if number else f"#<{name.lower()}>")
            if name:
                self._variables.set_name(name, unknown)
            elif len(number) < 6:  # a longer number is not the number of a variable
                self._variables.set_number(float(number), unknown)

    def _value(self, code: Postfix) -> float | None:
        self._steps += len(code)
        if self._steps > MOST_STEPS:
            raise Ended(Message("too-many-steps", count=MOST_STEPS))
        return evaluate(code, self._variables)

    def _value_or_reason(self, code: Postfix) -> Value:
        """Return the value of an expression, or the reason why the value is unknown."""
        try:
            return self._value(code)
        except Unknown as unknown:
            return unknown.why

    def _number(self, code: Postfix) -> int:
        """Return the value of an expression as the nearest whole number; 0 for an empty variable."""
        return round(self._value(code) or 0.0)

    def _filled(self, line: Words) -> str:
        """Return the words of a line with numbers in place of expressions, and perform its assignments.

        The expressions use the values that variables have before the line. A word whose value is an empty variable is
        left out.
        """
        parts: list[str] = []
        for before, letter, value in line.pieces:
            parts.append(before)
            if not value:
                continue
            try:
                number = self._value(value)
            except Unknown:
                text = "".join(before for before, _, _ in line.pieces) + line.rest
                if _DATA.search(text):
                    self.remarks.append(Message("line-with-variables"))
                    return ""
                if letter not in _HARMLESS:
                    raise
                self.remarks.append(Message("word-not-read", letter=letter))
                continue
            if number is not None:
                parts.append(f"{letter}{number!r} ".upper())
        self._set(self._new_values(line))
        code = "".join(parts) + line.rest
        return "" if _NUMBER_ALONE.fullmatch(code) else code

    def _new_values(self, line: Words) -> list[tuple[str | float | None, Value]]:
        """Return the variables that a line assigns, by their numbers or names, and their new values.

        All values are calculated before the first value is assigned.
        """
        new: list[tuple[str | float | None, Value]] = []
        for variable, right_side in line.assigned:
            *number, (_, name) = variable
            target = name or self._value(tuple(number))
            new.append((target, self._value_or_reason(right_side)))
        return new

    def _set(self, new: Iterable[tuple[str | float | None, Value]]) -> None:
        for target, value in new:
            if isinstance(target, str):
                self._variables.set_name(target, value)
            else:
                self._variables.set_number(target, value)

    def _block(self, index: int) -> Block:
        """Return the loop, condition or subprogram that begins, continues or ends in a line."""
        block = self._structure.blocks.get(index)
        if block is None or not block.closed:
            raise Ended(Message("unclosed"))
        return block

    def _if(self, index: int, control: Control) -> Step:
        """Continue at the first branch of a condition (IF, ELSEIF, ELSE) that applies."""
        for mark in self._block(index).marks:
            if mark != index:
                self.count_line(self._commands)
                control = self._control(mark)
            if control.keyword in ("ELSE", "ENDIF") or self._value(control.values[0]):
                return Step(to=mark + 1)
        raise Ended(Message("unclosed"))

    def _control(self, index: int) -> Control:
        """Return the control statement of the line with the given index."""
        try:
            line = parse_line(bare(self._lines[index]), fanuc=self._subprograms.fanuc)
        except Unreadable:
            line = None
        if not isinstance(line, Control):
            raise Ended(Message("unclosed"))
        return line

    def _skip(self, index: int, _control: Control) -> Step:
        """Continue after the end of an IF, of a loop (at BREAK), or of the definition of a subprogram."""
        block = self._block(index)
        if block.kind == "SUB":
            self.passed.add(index)
        return Step(to=block.last + 1)

    def _while(self, index: int, control: Control) -> Step:
        block = self._block(index)
        holds = not control.values or self._value(control.values[0])
        if block.kind == "DO":
            return Step(to=block.first + 1 if holds else None)
        return Step(to=None if holds else block.last + 1)

    def _repeat_loop(self, index: int, _control: Control) -> Step:
        return Step(to=self._block(index).first)

    def _go_on(self, _index: int, _control: Control) -> Step:
        return Step()

    def _repeat(self, index: int, control: Control) -> Step:
        block, times = self._block(index), self._number(control.values[0])
        if times <= 0:
            return Step(to=block.last + 1)
        self._variables.frames[-1].left[block.first] = times - 1
        self._variables.changes += 1
        return Step()

    def _end_repeat(self, index: int, _control: Control) -> Step:
        block, left = self._block(index), self._variables.frames[-1].left
        times = left.get(block.first, 0)
        left[block.first] = times - 1
        self._variables.changes += 1
        return Step(to=block.first + 1 if times > 0 else None)

    def _continue(self, index: int, _control: Control) -> Step:
        block = self._block(index)
        return Step(to=block.first if block.kind == "WHILE" else block.last)

    def _return(self, _index: int, control: Control) -> Step:
        value = self._value_or_reason(control.values[0]) if control.values else 0.0
        self._variables.set_name("_VALUE", value)
        self._variables.set_name("_VALUE_RETURNED", float(bool(control.values)))
        return Step(returns=True)

    def _call(self, _index: int, control: Control) -> Step:
        label = control.label
        name = label if isinstance(label, str) else str(self._number(label))
        block = self._structure.subprograms.get(name)
        if block is None:
            self.remarks.append(Message("subprogram-not-read"))
            self._variables.set_name("_VALUE", Message("value-of-machine", name="#<_value>"))
            return Step()
        if not block.closed:
            raise Ended(Message("unclosed"))
        numbers = {number: self._value_or_reason(value) for number, value in enumerate(control.values, 1)}
        return Step(call=Call(block.first + 1, block.last + 1, 1, Frame(numbers)))

    def _go_to(self, index: int, control: Control) -> Step:
        number = self._number(control.values[-1])
        block = self._subprograms.block(number, index)
        if block is None:
            raise Ended(Message("no-block", number=number))
        return Step(to=block)

    def _if_go_to(self, index: int, control: Control) -> Step:
        return self._go_to(index, control) if self._value(control.values[0]) else Step()

    def _if_then(self, _index: int, control: Control) -> Step:
        """Perform an assignment on a condition (IF-THEN).

        If the condition depends on the machine, the values of the assigned variables are unknown after this line, and
        reading continues. A conditional assignment to #3000, which raises an alarm, is ignored, because the lines that
        follow only run if the control raises no alarm.
        """
        then = control.then
        if then is None:
            return Step()
        try:
            return Step(self._filled(then)) if self._value(control.values[0]) else Step()
        except Unknown as unknown:
            if any(before for before, _, _ in then.pieces) or then.rest:
                raise
            self._set([(target, unknown.why) for target, _ in self._new_values(then) if target != ALARM])
            return Step()
