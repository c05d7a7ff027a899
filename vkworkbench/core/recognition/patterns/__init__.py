# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns of one section: its pieces, and the relations between the pieces."""
