# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands become trajectories: codes, words, arcs, canned cycles."""
