# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages and their sentences, with only the standard library, so that all other packages may import this one.

Input: `Message`, a code with arguments, which the other packages create; `Unusable`, an error with a message. Output:
`render`, which returns a message as a sentence in the language, units and number format of a `Reader`. Texts in
documents and files use the default reader, `ENGLISH`.
"""

from vkworkbench.language.marking import QT_TRANSLATE_NOOP
from vkworkbench.language.message import Message
from vkworkbench.language.numbers import ENGLISH, ROUGH, Reader
from vkworkbench.language.sentences import Unusable, render

__all__ = ["ENGLISH", "QT_TRANSLATE_NOOP", "ROUGH", "Message", "Reader", "Unusable", "render"]
