# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own simulators: noticing that one is started, and the warning before it."""
