# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt, texts and widgets that every room of the window uses."""
