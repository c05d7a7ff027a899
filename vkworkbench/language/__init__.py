# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages and their sentences: the lowest floor, which uses the standard library only.

In: `Message`, a code with its arguments, which all floors above create; `Unusable`, the error that carries a message.
Out: `render`, the sentence of a message in the language, units and number format of a `Reader`. Documents and files
use the default, `ENGLISH`.
"""

from vkworkbench.language.marking import QT_TRANSLATE_NOOP
from vkworkbench.language.message import Message
from vkworkbench.language.numbers import ENGLISH, ROUGH, Reader
from vkworkbench.language.sentences import Unusable, render

__all__ = ["ENGLISH", "QT_TRANSLATE_NOOP", "ROUGH", "Message", "Reader", "Unusable", "render"]
