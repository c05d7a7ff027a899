# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facts, crashes, gouges and leftover material, read from a simulated job."""
