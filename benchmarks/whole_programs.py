# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure how well programs are divided, and the verdicts on nonsense toolpaths: a part of recognition.py."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from records import JOINED, Record, joined, programs

from toolpaths import nonsense
from vkworkbench.core import Recognition, Strategy
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import recognize

# Minimum share of a section's cutting length that must be in spans with a right strategy, so that the section counts as
# recognised rightly: for a section of a whole program, and for each operation of a joined pair.
NAMED, IN_PLACE = 0.5, 0.9
# Maximum distance of a found border between sections from the true border, as a share of the section's length.
NEAR = 0.02
PAIRS, SEEDS = 200, 20


@dataclass
class Borders:
    """Numbers of true, found, reported and rightly reported borders between sections with different strategies.

    Reported borders inside a section whose label is "mixed" are counted separately, because the labels do not say
    where the borders inside this section are.
    """

    true: int = 0
    found: int = 0
    said: int = 0
    right: int = 0
    mixed: int = 0


def covered(record: Record, found: Recognition, reached: np.ndarray) -> list[float]:
    """Return for each section the share of its cutting length that is in spans with a right strategy.

    `reached` is the cutting length before each move. A span has one strategy, so a section with the label mixed is
    right if its spans have several strategies.
    """
    shares = []
    for s in record.sections:
        length = reached[s.last + 1] - reached[s.first]
        within = [span for span in found.spans if span.first <= s.last and span.last >= s.first]
        several = "mixed" in s.accepted and len({span.strategy for span in within}) > 1
        named = sum(
            max(0.0, reached[min(s.last, span.last) + 1] - reached[max(s.first, span.first)])
            for span in within
            if several or span.strategy.value in s.accepted
        )
        shares.append(named / length if length else 0.0)
    return shares


def compare(record: Record, found: Recognition, reached: np.ndarray, borders: Borders) -> None:
    """Count the true and reported borders between the sections of a program, and add the numbers to `borders`."""
    said = [(reached[a.last + 1], reached[b.first]) for a, b in zip(found.spans, found.spans[1:])]
    true = []
    for s, t in zip(record.sections, record.sections[1:]):
        before = reached[s.last + 1] - NEAR * (reached[s.last + 1] - reached[s.first])
        after = reached[t.first] + NEAR * (reached[t.last + 1] - reached[t.first])
        true.append((before - 1e-6, after + 1e-6, bool(s.accepted & t.accepted)))
    begin, end = reached[record.sections[0].first], reached[record.sections[-1].last + 1]
    mixed = [(reached[s.first], reached[s.last + 1]) for s in record.sections if "mixed" in s.accepted]
    for before, after, one_name in true:
        if not one_name:
            borders.true += 1
            borders.found += any(before <= x <= after for pair in said for x in pair)
    for pair in said:
        if pair[1] > begin and pair[0] < end:
            right = any(before <= x <= after for before, after, _ in true for x in pair)
            if not right and any(first < pair[0] and pair[1] < last for first, last in mixed):
                borders.mixed += 1
            else:
                borders.said += 1
                borders.right += right


def reached(record: Record) -> np.ndarray:
    """Return the cutting length before every trajectory and after the last one, mm."""
    return np.append(0.0, np.cumsum(np.where(record.path.rapid, 0.0, record.path.lengths)))


def report_programs(file: str, learn=lambda group: None) -> None:
    """Print how many labelled sections of whole programs get a right strategy, and how well they are separated.

    `learn` is called with the group of a program before the program is recognised.
    """
    shares, borders, several = [], Borders(), 0
    for record in programs(file):
        if len(record.sections) < 2:
            continue
        several += 1
        learn(record.group)
        found, length = recognize(record.path, program=True), reached(record)
        shares += covered(record, found, length)
        compare(record, found, length, borders)
    print(
        f"\n{several} programs of several sections, without comments and tool changes: "
        f"{np.mean(np.array(shares) >= NAMED):.3f} of {len(shares)} sections under a right name; "
        f"borders between different names found {borders.found}/{borders.true} = {borders.found / max(1, borders.true):.3f}; "
        f"borders said true {borders.right}/{borders.said} = {borders.right / max(1, borders.said):.3f}, "
        f"and {borders.mixed} said within what is labelled as mixed"
    )


def report_joined(records: list[Record], learn=lambda group: None) -> None:
    """Print how many pairs of operations, joined by a rapid, are divided into the two operations.

    For `learn`, see `report_programs`.
    """
    single = [r for r in records if r.sections and len(r.path) < JOINED]
    pairs = [r for r in joined(single, 2 * PAIRS) if not r.sections[0].accepted & r.sections[1].accepted][:PAIRS]
    if pairs:
        good = []
        for r in pairs:
            learn(r.group)
            good.append(min(covered(r, recognize(r.path, program=True), reached(r))) >= IN_PLACE)
        print(
            f"{len(pairs)} pairs of operations with a rapid between: both spans right and in place {np.mean(good):.3f}"
        )


def report_nonsense() -> None:
    """Print how often nonsense toolpaths get the strategy `unknown`, as they should."""
    unknown = [
        recognize(linearize(nonsense.commands(kind, np.random.default_rng([seed, 3])))).strategy is Strategy.UNKNOWN
        for kind in nonsense.KINDS
        for seed in range(SEEDS)
    ]
    print(f"{len(unknown)} paths that machine nothing: unknown {np.mean(unknown):.3f}")
