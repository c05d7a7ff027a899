# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the accuracy on sources that were left out of the learning: a part of recognition.py. Needs scikit-learn."""

from __future__ import annotations

import learn_borders
import records
import whole_programs
from learn_model import Examples, judge, leave_out

from vkworkbench.core.recognition.programs import visits
from vkworkbench.core.recognition.verdict import decide


def report_sources(files: list[str], programs: str | None) -> None:
    """Print the accuracy on the labelled operations, and how well whole programs and pairs of operations are divided.

    The strategies of operations and the borders between operations in each tenth of the repositories and parts are
    judged by models learned without this tenth.
    """
    e = Examples.read()
    judge(e)
    if not programs:
        return
    single = list(records.operations(files))
    borders = learn_borders.left_out(*learn_borders.retracts(list(records.programs(programs)), single)[:4])[0]
    found = leave_out(e, "group")
    fold = dict(zip(e.group.tolist(), found.fold.tolist()))
    in_use = decide.shipped_model, visits.shipped_trees

    def learn(group: str) -> None:
        # The table has no rows for a group without milling, so the model of any fold was learned without this group.
        decide.shipped_model = lambda: found.models[fold.get(group, 0)]
        visits.shipped_trees = lambda: borders.get(group) or in_use[1]()

    try:
        whole_programs.report_programs(programs, learn)
        whole_programs.report_joined(single, learn)
    finally:
        decide.shipped_model, visits.shipped_trees = in_use
