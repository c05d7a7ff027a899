# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the strategy of one section by rules, measures, learned trees and a decision."""
