# SPDX-License-Identifier: LGPL-2.1-or-later
"""The marker function by which Qt's lupdate finds the texts to translate."""

from __future__ import annotations


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:  # noqa: N802, the name that lupdate looks for
    """Mark a text for translation, and return it unchanged."""
    return text
