# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the number of dexels, trace elements and gaps in a simulated image, and the memory that they need."""
