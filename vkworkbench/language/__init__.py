# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said, and how a person reads it: the lowest floor, the standard library only.

In: `Message`, a code with its arguments, which every room above makes; `Unusable`, the error that carries one.
Out: `render`, the sentence in the words, units and number format of a `Reader`; by default `ENGLISH`, the reader of
all that is written into documents and files.
"""

from vkworkbench.language.marking import QT_TRANSLATE_NOOP
from vkworkbench.language.message import Message
from vkworkbench.language.numbers import ENGLISH, ROUGH, Reader
from vkworkbench.language.sentences import render
from vkworkbench.language.unusable import Unusable

__all__ = ["ENGLISH", "QT_TRANSLATE_NOOP", "ROUGH", "Message", "Reader", "Unusable", "render"]
