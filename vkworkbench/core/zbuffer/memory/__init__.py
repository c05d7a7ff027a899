# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the number of records in the image of a simulation, and the memory that these records need."""
