# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the state of the machine while a program is read: modes, origins, maps, tool position, current program line."""
