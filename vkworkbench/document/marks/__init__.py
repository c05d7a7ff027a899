# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks of operations in the tree: their properties, their text, and when they are outdated."""
