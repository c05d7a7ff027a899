# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert commands into trajectories. Arcs are divided into chords, and canned cycles into straight moves."""
