# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute where a ray enters and leaves the volume that a tool sweeps along a move."""
