# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy of the verdicts on sources that were left out of the learning: a part of recognition.py."""

from __future__ import annotations

from collections.abc import Callable

import learn_borders
import numpy as np
import records
import whole_programs
from learn_verdicts import Examples, labelled, left_out
from records import Record
from reliability import how_sure, two_class

from vkworkbench.core import Strategy
from vkworkbench.core.recognition import recognize
from vkworkbench.core.recognition.programs import visits
from vkworkbench.core.recognition.verdict import decide
from vkworkbench.core.recognition.verdict.decide import STRATEGIES

Answers = dict[str, list[tuple[Record, str, float, str]]]


def report_sources(files: list[str], programs: str | None) -> None:
    """Print the figures of every kind of toolpath, a tenth of its sources left out at a time.

    Sources are repositories, parts and kinds, and then CAM systems. Where there is a file of whole programs, it is also
    printed how well these and pairs of operations are divided.
    """
    toolpaths = list(labelled(files))
    examples = Examples.measured(toolpaths)
    in_use, borders, forests = decide.LEARNED, visits.FOREST, {}
    single = [record for kind, record in toolpaths if kind in ("real", "freecad")]
    if programs:
        forests, _ = learn_borders.left_out(*learn_borders.retracts(list(records.programs(programs)), single)[:4])
    try:
        learn = _learner(examples, "group", forests)
        _report("a tenth of the repositories, parts and kinds", _answers(toolpaths, learn, "group"))
        if programs:
            whole_programs.report_programs(programs, learn)
            whole_programs.report_joined(single, learn)
        visits.FOREST = borders
        real = [(kind, record) for kind, record in toolpaths if kind == "real"]
        _report("a tenth of the CAM systems", _answers(real, _learner(examples, "system", {}), "system"))
    finally:
        decide.LEARNED, visits.FOREST = in_use, borders
    _report_rules(examples)


def _learner(examples: Examples, by: str, forests: dict) -> Callable[[str], None]:
    """Return what makes the recognition use what was learned without a source."""
    learned, _ = left_out(examples, by)
    of_source, borders = examples.folds(by), visits.FOREST

    def learn(source: str) -> None:
        # A source in which nothing is milled was not learned from.
        decide.LEARNED = learned[of_source.get(source, 0)]
        visits.FOREST = forests.get(source, borders)

    return learn


def _answers(toolpaths: list[tuple[str, Record]], learn: Callable[[str], None], by: str) -> Answers:
    """Return by kind what is said of each record, how surely, and what the paper's rule says to the letter."""
    answers: Answers = {}
    for kind, record in toolpaths:
        learn(getattr(record, by))
        found = recognize(record.path, tool_diameter=record.tool)
        paper = found.paper.strategy if found.paper else Strategy.UNKNOWN
        answers.setdefault(kind, []).append((record, found.strategy.value, found.confidence, paper.value))
    return answers


def _report(title: str, answers: Answers) -> None:
    print(f"\nleft out by source: {title} at a time", flush=True)
    for kind, told in answers.items():
        right = np.array([got in record.accepted for record, got, *_ in told])
        confidence = np.array([sure for _, _, sure, _ in told])
        unknown = np.mean([got == "unknown" for _, got, *_ in told])
        classes = [two_class(record.strategy, record.accepted, got) for record, got, *_ in told]
        papers = [two_class(record.strategy, record.accepted, paper) for record, *_, paper in told]
        print(
            f"  {kind:10s} {len(told):5d}: right {right.mean():.3f}, two-class {_mean(classes):.3f} (the paper's rule to the "
            f"letter {_mean(papers):.3f}), unknown {unknown:.3f}; {how_sure(confidence, right)}",
            flush=True,
        )


def _report_rules(examples: Examples) -> None:
    print("\nthe rules alone, written on a part of these toolpaths")
    names = [s.value for s in STRATEGIES]
    for kind in ("real", "freecad", "synthetic"):
        of = np.flatnonzero(examples.kind == kind)
        right = np.mean([examples.proposed[i].rules in examples.accepted[i] for i in of])
        classes = [
            two_class(names[examples.y[i]], {names[k] for k in examples.accepted[i]}, names[examples.proposed[i].rules])
            for i in of
        ]
        print(f"  {kind:10s} {len(of):5d}: right {right:.3f}, two-class {_mean(classes):.3f}")


def _mean(classes: list[bool | None]) -> float:
    """Return the share of those that are true; None does not count."""
    known = [of_class for of_class in classes if of_class is not None]
    return float(np.mean(known)) if known else 0.0
