# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state of the machine while a program is read: modes, origins, maps, the place of the tool, the current line."""
