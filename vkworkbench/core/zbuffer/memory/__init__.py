# SPDX-License-Identifier: LGPL-2.1-or-later
"""The number of records that an image will hold, and the memory for them."""
