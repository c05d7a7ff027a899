# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of commands as numbers."""

from __future__ import annotations

from vkworkbench.core.gcode import codes


def test_only_m6_changes_the_tool():
    assert [codes.code_of(name) for name in ("M6", "m06", "M3", "T6", "S6", "G6")] == [
        *[codes.TOOL_CHANGE] * 2, *[codes.OTHER] * 3, 60
    ]  # fmt: skip
