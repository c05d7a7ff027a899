# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work and memory that are counted: a test that asserts on seconds fails on a busy computer."""

from __future__ import annotations

import sys
import tracemalloc


def steps(function):
    """Number of Python's instructions that a call takes."""
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
    """What a call returns, the memory that it leaves taken, and its peak, bytes."""
    tracemalloc.start()
    try:
        result = function()
        return result, *tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
