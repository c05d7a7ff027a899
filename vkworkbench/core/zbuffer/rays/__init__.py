# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays: the pieces of each, the trajectory that removes each piece, and the records that store them."""
