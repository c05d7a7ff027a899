# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks of operations: their properties, their text, and when they are outdated."""
