# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find where the operations of a whole program begin and end, and the strategy of each operation."""
