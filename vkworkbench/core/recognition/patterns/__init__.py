# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the patterns of one section: the pieces of the section, and the relations between the pieces."""
