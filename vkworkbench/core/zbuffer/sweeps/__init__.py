# SPDX-License-Identifier: LGPL-2.1-or-later
"""The volume that a tool sweeps: where a ray enters and leaves it."""
