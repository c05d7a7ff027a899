# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns of one section: its pieces, how they lie to each other, and what they measure."""
