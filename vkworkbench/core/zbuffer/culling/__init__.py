# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the trajectories that can cut each pixel."""
