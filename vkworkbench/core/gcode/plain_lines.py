# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read many plain program lines at once, as columns. Most lines of most NC programs are plain lines.

A plain line contains only words of a straight move or an arc (G0 to G3, X, Y, Z, I, J, K, R, F) and a line number, and
each letter at most once. An empty line is also plain. `PlainLines.read` adds the commands that the interpreter would
add, and leaves the machine in the state in which the interpreter would leave it. `PlainLines.read` reads lines only
while `Machine.moves_plainly` is true. The interpreter reads all other lines.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.gcode.blocks import Lines
from vkworkbench.core.gcode.interpreter import Interpreter
from vkworkbench.core.gcode.moves import codes

# Largest number of lines, and of characters, that are read at once; a single line can be longer. Higher limits need
# more memory.
_LINES, _CHARACTERS = 20_000, 2_000_000
# Largest number of digits in the number of a word. A decimal number is computed as the quotient of an integer and a
# power of ten. Integers of up to 15 digits and powers up to 1e15 are exact floats, so only the quotient is rounded.
_MOST_DIGITS = 15
_MOTIONS = (codes.RAPID, codes.FEED, *codes.ARCS)
_LETTERS = "NGXYZIJKRF"
_BITS = {letter: 1 << number for number, letter in enumerate(_LETTERS)}

_END, _SPACE, _DIGIT, _POINT, _SIGN, _LETTER, _OTHER = range(7)  # kinds of characters in a program line
_FOLLOWERS = {
    _END: (_END, _SPACE, _LETTER),
    _SPACE: (_END, _SPACE, _LETTER),
    _DIGIT: (_END, _SPACE, _DIGIT, _POINT, _LETTER),
    _POINT: (_END, _SPACE, _DIGIT, _LETTER),
    _SIGN: (_DIGIT, _POINT),
    _LETTER: (_DIGIT, _POINT, _SIGN),
    _OTHER: (),
}  # for each kind of character, the kinds that can follow it in a plain line


def _kinds() -> np.ndarray:
    kinds = np.full(256, _OTHER, np.uint8)
    for characters, kind in (("\n", _END), (" \t", _SPACE), ("0123456789", _DIGIT), (".", _POINT), ("+-", _SIGN),
                             (_LETTERS, _LETTER)):  # fmt: skip
        kinds[np.frombuffer(characters.encode(), np.uint8)] = kind
    return kinds


def _pairs() -> np.ndarray:
    pairs = np.zeros(8 * 8, bool)
    for kind, followers in _FOLLOWERS.items():
        pairs[[8 * kind + follower for follower in followers]] = True
    return pairs


def _sets() -> tuple[np.ndarray, np.ndarray]:
    """Return, for each set of letters, the number of letters, and whether a plain line can contain exactly this set.

    A line with an arc in X and Z is not plain, because the interpreter must note such an arc as a sign of a lathe.
    """
    sets = np.arange(1 << len(_LETTERS))
    has = {letter: sets & bit > 0 for letter, bit in _BITS.items()}
    turned = has["Z"] & ~has["Y"] & ~has["J"] & (has["K"] | has["R"])
    return np.sum(list(has.values()), axis=0), ~turned


_KINDS, _PAIRS, (_SIZES, _USABLE) = _kinds(), _pairs(), _sets()
_LETTER_BITS = np.zeros(256)
_LETTER_BITS[np.frombuffer(_LETTERS.encode(), np.uint8)] = list(_BITS.values())
_FORM = 16  # base of the numbers in `_texts`; larger than the lengths of `_LETTERS` and `_NAMES`
_LETTER_CODES = np.zeros(256)
_LETTER_CODES[np.frombuffer(_LETTERS.encode(), np.uint8)] = 1 + np.arange(len(_LETTERS))
_POWERS = 10.0 ** np.arange(_MOST_DIGITS + 1)
_AXES = sum(_BITS[letter] for letter in "XYZIJKR")
_FEED_ALONE = 5  # index of a feed rate's command in `_NAMES`; 0 is the empty name of a modal move, 1 to 4 are G0 to G3
_NAMES = ("", *map(codes.name_of, _MOTIONS), codes.name_of(codes.PER_MINUTE))


class PlainLines:
    """The plain lines of an NC program.

    Parameters
    ----------
    lines : Lines
        All lines of the NC program.
    """

    def __init__(self, lines: Lines) -> None:
        self._lines = lines
        self._block = _Block.of_lines(lines, 0)

    def read(self, machine: Interpreter, index: int, end: int) -> tuple[int, int]:
        """Read successive plain lines from the line `index` on. If `machine.moves_plainly` is false, read nothing.

        Parameters
        ----------
        machine : Interpreter
        index, end : int
            Index of the first line, and of the line at which reading must stop.

        Returns
        -------
        int
            Index of the line after the last line read; `index` if none was read.
        int
            Number of lines read, without empty lines.
        """
        if not machine.moves_plainly:
            return index, 0
        begin, blocks = index, 0
        while index < end:
            if not self._block.first <= index < self._block.last:
                self._block = _Block.of_lines(self._lines, index)
            block = self._block
            after = min(end, block.next_other(index))
            _add(machine, block, index, after)
            blocks += int(block.not_empty[after - block.first] - block.not_empty[index - block.first])
            index = after
            if index < block.last:
                break
        if index > begin:
            machine.number, machine.deleted, machine.call = index, False, None
        return index, blocks


@dataclass(frozen=True)
class _Block:
    """Lines of an NC program, with the words of the plain lines as columns.

    Attributes
    ----------
    first, last : int
        Index of the first line, and of the line after the last line.
    others : list of int
        Indices of the lines that are not plain, ascending.
    not_empty, commands_before, values_before : (last - first + 1,) int64
        Before each line from `first` on: number of lines that are not empty, number of commands, and number of values.
    rows : (c,) int64
        Index of the line of each command.
    motions : (c,) int64
        The G-code of the motion that each command selects, as ten times its number (10 for G1); -1 if the command
        selects no motion.
    names, letters : list of str
        Name of each command (empty for a move without a G word), and the letters of its values.
    counts : (c,) int64
        Number of values of each command.
    values : (v,) float64
        The values of all commands, in the units of the text.
    of : (v,) uint8
        The letter of each value.
    """

    first: int
    last: int
    others: list[int]
    not_empty: np.ndarray
    commands_before: np.ndarray
    values_before: np.ndarray
    rows: np.ndarray
    motions: np.ndarray
    names: list[str]
    letters: list[str]
    counts: np.ndarray
    values: np.ndarray
    of: np.ndarray

    @staticmethod
    def of_lines(lines: Lines, first: int) -> _Block:
        """Read a block of lines, which begins at the line `first`."""
        last = min(len(lines), first + _LINES)
        while last > first + 1 and lines.size(first, last) > _CHARACTERS:
            last = first + (last - first) // 2
        count = last - first
        plain, letter, line, value = _words(lines.between(first, last), count)
        bits = np.bincount(line, _LETTER_BITS[letter], count).astype(np.int64)
        words = np.bincount(line, minlength=count)
        small = np.minimum(bits, len(_SIZES) - 1)
        plain &= (bits == small) & (_SIZES[small] == words) & _USABLE[small]
        plain[line[(letter == ord("G")) & ~np.isin(value, (0.0, 1.0, 2.0, 3.0))]] = False

        kept = plain[line]
        letter, line, value = letter[kept], line[kept], value[kept]
        motions = np.full(count, -1)
        selects = letter == ord("G")
        motions[line[selects]] = 10 * value[selects].astype(np.int64)
        kept = ~(selects | (letter == ord("N")))
        letter, line, value = letter[kept], line[kept], value[kept]
        is_feed = letter == ord("F")
        if (is_feed[:-1] & (line[1:] == line[:-1])).any():  # as in the interpreter, F is the last parameter
            order = np.argsort(2 * line + is_feed, kind="stable")
            letter, value = letter[order], value[order]
        counts = np.bincount(line, minlength=count)
        rows = np.flatnonzero(plain & ((motions >= 0) | (counts > 0)))
        before = np.cumsum(counts) - counts
        places = np.arange(len(line)) - before[line]
        name = np.where(motions >= 0, 1 + motions // 10, np.where(small & _AXES > 0, 0, _FEED_ALONE))
        forms = np.bincount(line, _LETTER_CODES[letter] * _FORM ** places.astype(float), count).astype(np.int64)
        names, letters = _texts(forms[rows] * _FORM + name[rows])
        return _Block(
            first, last, (first + np.flatnonzero(~plain)).tolist(), _before(plain & (words > 0)),
            _before(plain & ((motions >= 0) | (counts > 0))), _before(counts), first + rows, motions[rows], names, letters,
            counts[rows], value, letter,
        )  # fmt: skip

    def next_other(self, index: int) -> int:
        """Return the index of the first line from `index` on that is not plain, or the end of the block."""
        place = bisect_left(self.others, index)
        return self.others[place] if place < len(self.others) else self.last


def _before(counts: np.ndarray) -> np.ndarray:
    """Return the sum of the counts before each of n lines and after the last line, (n + 1,) int."""
    return np.concatenate([[0], np.cumsum(counts)])


def _texts(forms: np.ndarray) -> tuple[list[str], list[str]]:
    """Return the names and the letters of commands.

    Each element of `forms` encodes a command as a number in base `_FORM`. The last digit is the index of the command's
    name in `_NAMES`, and each other digit is the place of a parameter's letter in `_LETTERS`, counted from 1.
    """
    known, inverse = np.unique(forms, return_inverse=True)
    names, letters = [], []
    for form in known.tolist():
        form, name = divmod(form, _FORM)
        names.append(_NAMES[name])
        text = ""
        while form:
            form, letter = divmod(form, _FORM)
            text += _LETTERS[letter - 1]
        letters.append(text)
    which = inverse.tolist()
    return [names[form] for form in which], [letters[form] for form in which]


def _words(text: str, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return whether each of n lines consists of words with short numbers, (n,) bool, and three columns for all words.

    The three columns contain each word's letter, line and value.
    """
    characters = np.frombuffer(text.encode("ascii", "replace").upper() + b"\n", np.uint8)
    kinds = _KINDS[characters]
    pairs = kinds.copy()
    pairs[1:] += 8 * kinds[:-1]  # the first character is checked as if a line end preceded it
    ends = np.flatnonzero(kinds == _END)
    plain = np.ones(count, bool)
    plain[np.searchsorted(ends, np.flatnonzero(~_PAIRS[pairs]))] = False
    if not plain.all():
        kinds[np.repeat(~plain, np.diff(ends, prepend=-1))] = _OTHER
    letters = np.flatnonzero(kinds == _LETTER)
    is_digit = kinds == _DIGIT
    digits = np.flatnonzero(is_digit)
    number = np.cumsum(is_digit, dtype=np.int64)  # number of digits up to each character
    begin = number[letters]
    stop = np.append(begin, len(digits))[1:]
    points = np.flatnonzero(kinds == _POINT)
    word = np.searchsorted(letters, points) - 1  # Index of the word that contains each point.
    behind = np.zeros(len(letters), np.int64)  # Number of digits after the decimal point of each word.
    behind[word] = stop[word] - number[points]
    short = (stop > begin) & (stop - begin <= _MOST_DIGITS) & (np.bincount(word, minlength=len(letters)) <= 1)
    power = np.repeat(stop, stop - begin) - 1 - np.arange(len(digits))
    value = (characters[digits] - ord("0")) * _POWERS[np.minimum(power, _MOST_DIGITS)]
    whole = np.bincount(np.repeat(np.arange(len(letters)), stop - begin), value, len(letters))
    value = whole / _POWERS[np.minimum(behind, _MOST_DIGITS)]
    line = np.searchsorted(ends, letters)
    plain[line[~short]] = False
    return plain, characters[letters], line, np.where(characters[letters + 1] == ord("-"), -value, value)


def _add(machine: Interpreter, block: _Block, index: int, after: int) -> None:
    """Add the commands of plain lines."""
    modes = machine.modes
    c, d = (int(block.commands_before[line - block.first]) for line in (index, after))
    v, w = (int(block.values_before[line - block.first]) for line in (index, after))
    of, values = block.of[v:w], block.values[v:w]
    is_feed = of == ord("F")
    feeds = values * modes.feed_unit / machine.dialect.feed_time
    values = np.where(is_feed, feeds, modes.unit * values)
    machine.commands.extend(block.names[c:d], block.letters[c:d], block.counts[c:d], values)
    machine.lines.frombytes((block.rows[c:d] + 1).tobytes())
    selected = block.motions[c:d][block.motions[c:d] >= 0]
    if len(selected):
        machine.motion = machine.written = int(selected[-1])
    if is_feed.any():
        modes.feed = float(values[is_feed][-1])
    machine.stopped &= modes.relative or not (of == ord("Z")).any()
    y = values[of == ord("Y")]
    if len(y) and modes.relative:
        machine.clues.y(bool((y != 0).any()))
    elif len(y):
        machine.clues.y(machine.last_y not in (None, y[0]) or bool((y != y[0]).any()))
        machine.last_y = float(y[-1])
