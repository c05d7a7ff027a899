# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file when its window starts, inside a function and without __file__. Therefore this file only
# imports and calls `install`.
from vkworkbench.gui.workbench import install

install()
