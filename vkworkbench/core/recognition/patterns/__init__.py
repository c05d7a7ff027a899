# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the patterns of one operation: loops, zigzags, rows and strokes, and the relations between them."""
