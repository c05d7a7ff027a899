# SPDX-License-Identifier: LGPL-2.1-or-later
"""Count instructions and memory, because a test that asserts seconds fails on a busy computer."""

from __future__ import annotations

import sys
import tracemalloc


def steps(function):
    """Return the number of Python instructions that a call executes."""
    count = 0

    def trace(frame, event, _argument):
        nonlocal count
        frame.f_trace_opcodes, frame.f_trace_lines = True, False
        count += event == "opcode"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        function()
    finally:
        sys.settrace(before)
    return count


def memory(function):
    """Return a call's result, the memory still allocated after the call, and the peak memory of the call, bytes."""
    tracemalloc.start()
    try:
        result = function()
        return result, *tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
