# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is coloured beside the strategies, whose colours are in their table (core/strategy.py)."""

TEXT = "#ffffff"  # on any strategy
TOTAL = "#62748d"  # of a job
RAPID = "#8c8c8c"
