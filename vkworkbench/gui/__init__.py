# SPDX-License-Identifier: LGPL-2.1-or-later
"""The graphical user interface of the add-on: the only package that uses Qt."""
