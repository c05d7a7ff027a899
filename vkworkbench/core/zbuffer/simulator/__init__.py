# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate toolpaths by cutting an image region by region, and restore the part after any number of trajectories."""
