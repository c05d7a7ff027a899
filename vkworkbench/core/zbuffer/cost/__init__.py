# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the time and memory of a simulation without running it."""
