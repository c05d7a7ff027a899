# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulations of the operations of a document. Writes nothing."""
