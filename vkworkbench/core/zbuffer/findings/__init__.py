# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find crashes, collisions, gouges and leftover material in a simulated job, and compute removed volumes."""
