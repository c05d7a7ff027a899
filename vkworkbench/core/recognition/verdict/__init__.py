# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategy of one section: the rules, the measures, the trees, and the decision."""
