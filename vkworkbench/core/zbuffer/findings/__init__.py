# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the facts, crashes, collisions, gouges and leftover material in a simulated job."""
