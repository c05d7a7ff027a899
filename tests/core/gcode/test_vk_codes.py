# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of commands are converted to numbers and back."""

from __future__ import annotations

from vkworkbench.core.gcode.moves import codes


def test_only_m6_changes_the_tool():
    assert [codes.code_of(name) for name in ("M6", "m06", "M3", "T6", "S6", "G6")] == [
        *[codes.TOOL_CHANGE] * 2, *[codes.OTHER] * 3, 60
    ]  # fmt: skip


def test_only_g_words_up_to_999_9_have_a_g_code():
    assert [codes.code_of(name) for name in ("G999.9", "G1000", "G", "M1000", "X1", "(G1)", "/G1", "%", " ")] == [
        9999, codes.UNKNOWN, codes.UNKNOWN, codes.OTHER, codes.UNKNOWN, *[codes.COMMENT] * 3, codes.MODAL
    ]  # fmt: skip


def test_command_name_is_computed_from_the_number_of_its_code():
    assert [codes.name_of(codes.code_of(name)) for name in ("g01", "G90.1", "G382")] == ["G1", "G90.1", "G382"]
