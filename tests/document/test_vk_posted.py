# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program posted by FreeCAD is recognised with the names and strategies of the document's operations."""

from __future__ import annotations

from posting import posted

import vkworkbench


def told(report):
    return [(row.label, str(row.strategy)) for row in report.operations if row.counted and row.trajectories]


def test_posted_program_has_the_operations_of_its_document(example, tmp_path):
    program = tmp_path / "example.ngc"
    program.write_text("\n".join(posted(example.getObject("Job"))))
    assert told(vkworkbench.analyze(program)) == told(vkworkbench.analyze(example))
