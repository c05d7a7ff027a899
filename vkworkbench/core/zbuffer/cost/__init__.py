# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of a simulation, estimated without running it."""
