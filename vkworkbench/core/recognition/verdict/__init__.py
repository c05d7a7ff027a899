# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the strategy of one operation by rules, dimensionless measures and learned decision trees."""
