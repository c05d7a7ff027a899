# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the comments of an NC program say: titles, tools and operations."""
