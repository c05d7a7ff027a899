# SPDX-License-Identifier: LGPL-2.1-or-later
"""The marks in the Description column of FreeCAD's tree view."""
