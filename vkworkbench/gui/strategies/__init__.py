# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies drawn in the 3D view."""
