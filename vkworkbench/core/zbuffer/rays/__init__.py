# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide rays into pieces, find the trajectory that removes each piece, and store the pieces as records."""
