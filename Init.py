# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file at every start, with and without a window. This file contains no code, because macros import
# vkworkbench.
