# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of what is no strategy; those of the strategies are in their table (core/strategy.py)."""

TEXT = "#ffffff"  # on any strategy
TOTAL = "#62748d"  # of a job's total
RAPID = "#8c8c8c"
