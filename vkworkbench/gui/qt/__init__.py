# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt, texts and widgets that all packages of the window use."""
