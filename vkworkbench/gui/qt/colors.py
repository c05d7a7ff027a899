# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of what is no strategy; those of the strategies are in their table (core/strategy.py)."""

TEXT = "#ffffff"  # on any strategy
TOTAL = "#62748d"  # of a job's total
WARNING = ("#f9a825", "#1a1a1a")  # of the sign, and what is on it
ERROR = ("#c62828", "#ffffff")  # likewise
BURDEN = {"NEAR": WARNING, "OVER": ERROR}  # of a time near or over the budget, and its text
RAPID = "#8c8c8c"
LINK = "#2f7fd6"  # made lighter or darker for what is behind it
NOTE_SIGN, WARNING_SIGN, ERROR_SIGN = "#62748d", "#c77700", "#d9363e"
