# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find where the loops, conditions and subprograms of an NC program begin and end."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, field

from vkworkbench.core.gcode.blocks import Lines
from vkworkbench.core.gcode.flow.lines import bare, label_of

_CONTROLS = re.compile("SUB|IF|ELSE|WHILE|DO|REPEAT|END|BREAK|CONTINUE", re.IGNORECASE)
_O_WORD = re.compile(
    r"(?:N[\d.]+)?O(?:(\d+)|<([^<>]*)>)"
    "(ENDSUB|SUB|ELSEIF|ELSE|ENDIF|IF|ENDWHILE|WHILE|DO|ENDREPEAT|REPEAT|BREAK|CONTINUE)"
)
_DO = re.compile(r"(?:N\d+)?(?:WHILE\[.*\])?DO(\d+)")
_END = re.compile(r"(?:N\d+)?END(\d+)")
_BEGINS = frozenset(["IF", "WHILE", "DO", "REPEAT"])
_ENDS = {"ENDIF": "IF", "ENDWHILE": "WHILE", "ENDREPEAT": "REPEAT"}
_LOOPS = ("WHILE", "DO", "REPEAT")


@dataclass
class Block:
    """A loop, a condition or a subprogram, from its first to its last program line.

    Attributes
    ----------
    kind : str
        The keyword at the beginning, such as WHILE, IF or SUB; ``DO-N`` for a loop of a Fanuc control.
    marks : list of int
        Indices of the first line, of the ELSEIF and ELSE lines, and of the last line.
    closed : bool
        Whether the NC program contains the last line, whose index is then the last element of `marks`.
    """

    kind: str
    marks: list[int] = field(default_factory=list)
    closed: bool = False

    @property
    def first(self) -> int:
        """Index of the first line of the loop, condition or subprogram."""
        return self.marks[0]

    @property
    def last(self) -> int:
        """Index of the last line of the loop, condition or subprogram."""
        return self.marks[-1]


class Structure:
    """The loops, conditions and subprograms (blocks) of an NC program.

    Parameters
    ----------
    lines : Lines
        All lines of the NC program.
    heads : collection of int
        Indices of the lines in which a program begins (with its number). A loop of a Fanuc control must end within its
        program.

    Attributes
    ----------
    blocks : dict of int to Block
        The loop, condition or subprogram to which a control statement belongs, by the index of the statement's line.
    subprograms : dict of str to Block
        Subprograms, by the labels of the O-words that define the subprograms.
    """

    def __init__(self, lines: Lines, heads: Collection[int]) -> None:
        self.blocks: dict[int, Block] = {}
        self.subprograms: dict[str, Block] = {}
        heads = frozenset(heads)
        # The loops, conditions and subprograms whose end is not read yet, by subprogram and label. Different
        # subprograms can use the same label for different loops and conditions.
        self._open: dict[tuple[str, str], list[Block]] = {}
        self._within = ""
        for index, line in enumerate(lines):
            if index in heads:
                self._open.clear()
            elif _CONTROLS.search(line):
                self._line(index, bare(line))

    def _line(self, index: int, code: str) -> None:
        if found := _O_WORD.match(code):
            self._o_word(index, label_of(found[1] or found[2] or ""), found[3])
        elif found := _DO.fullmatch(code):
            self._begin(index, ("DO-N", label_of(found[1])), Block("DO-N"))
        elif found := _END.fullmatch(code):
            self._add(index, ("DO-N", label_of(found[1])), ends=True)

    def _o_word(self, index: int, name: str, keyword: str) -> None:
        key = (self._within, name)
        opened = self._open.get(key)
        if keyword == "SUB":
            self._within = name
            block = Block("SUB")
            self._begin(index, ("SUB", name), block)
            self.subprograms.setdefault(name, block)
        elif keyword == "ENDSUB":
            self._within = ""
            self._add(index, ("SUB", name), ends=True)
        elif keyword == "WHILE" and opened and opened[-1].kind == "DO":
            self._add(index, key, ends=True)
        elif keyword in _BEGINS:
            self._begin(index, key, Block(keyword))
        elif keyword in ("BREAK", "CONTINUE"):
            if opened and opened[-1].kind in _LOOPS:
                self.blocks[index] = opened[-1]
        elif opened and opened[-1].kind == _ENDS.get(keyword, "IF"):
            self._add(index, key, ends=keyword in _ENDS)

    def _begin(self, index: int, key: tuple[str, str], block: Block) -> None:
        self._open.setdefault(key, []).append(block)
        self._add(index, key, ends=False)

    def _add(self, index: int, key: tuple[str, str], *, ends: bool) -> None:
        """Add a line to the innermost loop, condition or subprogram with the given key whose end is not read yet."""
        opened = self._open.get(key)
        if not opened:
            return
        block = opened[-1]
        block.marks.append(index)
        self.blocks[index] = block
        if ends:
            block.closed = True
            opened.pop()
