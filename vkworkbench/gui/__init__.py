# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window: the only package that uses Qt."""
