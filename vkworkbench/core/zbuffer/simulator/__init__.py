# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate toolpaths: cut an image region by region, and restore the part at any moment."""
