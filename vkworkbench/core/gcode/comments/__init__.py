# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read titles, tools and operations from the comments of an NC program."""
