# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which trajectories can cut which pixels."""
