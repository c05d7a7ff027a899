# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulator: images cut region by region, and the part at any moment."""
