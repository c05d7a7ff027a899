# SPDX-License-Identifier: LGPL-2.1-or-later
"""How good verdicts are on sources that had no part in what was learned: a part of recognition.py."""

from __future__ import annotations

import learn_borders
import numpy as np
import records
import whole_programs
from learn_verdicts import Examples, labelled, left_out
from records import Record
from reliability import calibration_error, two_class

from vkworkbench.core.recognition import decide, recognize, visits

SURE = 0.9


def report_sources(files: list[str], programs: str | None) -> None:
    """Print the figures of every kind of toolpath, a tenth of the repositories, parts and kinds left out at a time.

    Where there is a file of whole programs, also how well these and pairs of operations are divided.
    """
    toolpaths = list(labelled(files))
    examples = Examples.measured(toolpaths)
    learned, _ = left_out(examples)
    of_group, in_use = examples.folds(), decide.LEARNED
    borders, forests = visits.FOREST, {}
    if programs:
        single = [record for kind, record in toolpaths if kind in ("real", "freecad")]
        forests, _ = learn_borders.left_out(*learn_borders.retracts(list(records.programs(programs)), single)[:4])

    def learn(group: str) -> None:
        # A group in which nothing is milled was not learned from.
        decide.LEARNED = learned[of_group.get(group, 0)]
        visits.FOREST = forests.get(group, borders)

    answers: dict[str, list[tuple[Record, str, float]]] = {}
    try:
        for kind, record in toolpaths:
            learn(record.group)
            found = recognize(record.path, tool_diameter=record.tool)
            answers.setdefault(kind, []).append((record, found.strategy.value, found.confidence))
        if programs:
            whole_programs.report_programs(programs, learn)
            whole_programs.report_joined(files, learn)
    finally:
        decide.LEARNED, visits.FOREST = in_use, borders
    print("\nleft out by source")
    for kind, told in answers.items():
        right = np.array([got in record.accepted for record, got, _ in told])
        confidence = np.array([sure for *_, sure in told])
        unknown = np.mean([got == "unknown" for _, got, _ in told])
        sure = confidence >= SURE
        classes = [two_class(record.strategy, record.accepted, got) for record, got, _ in told]
        classes = [of_class for of_class in classes if of_class is not None]
        print(
            f"  {kind:10s} {len(told):5d}: right {right.mean():.3f}, two-class {np.mean(classes) if classes else 0:.3f}, unknown "
            f"{unknown:.3f}; calibration error {calibration_error(confidence, right):.3f}; where it says {SURE} and more, "
            f"{right[sure].mean() if sure.any() else 0:.3f} of {sure.sum()} are right"
        )
