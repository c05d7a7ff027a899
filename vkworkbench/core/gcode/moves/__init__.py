# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert commands into trajectories: codes, words, arcs, canned cycles."""
