# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole programs: where operations begin and end, and the strategy of each."""
