# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide rays into segments, find the trajectory that removes each segment, and store the segments as records."""
