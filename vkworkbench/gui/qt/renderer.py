# SPDX-License-Identifier: LGPL-2.1-or-later
"""The name of the OpenGL renderer of this computer: a graphics card or software rendering."""

from __future__ import annotations

from vkworkbench import preferences
from vkworkbench.gui.qt.names import QOffscreenSurface, QOpenGLContext

_GL_RENDERER = 0x1F01


def opengl_renderer() -> str:
    """Return the name of the OpenGL renderer, e.g. ``"llvmpipe (LLVM 15.0.6, 256 bits)"``; empty without OpenGL."""
    surface = QOffscreenSurface()
    surface.create()
    context = QOpenGLContext()
    if not context.create() or not context.makeCurrent(surface):
        return ""
    name = context.functions().glGetString(_GL_RENDERER)
    context.doneCurrent()
    return name or ""


def note_renderer(*, again: bool = False) -> str:
    """Store the name of the OpenGL renderer in the preferences, where analyses read it, and return the name.

    If the preferences already contain a name, OpenGL is only asked if `again` is True.
    """
    known = preferences.read().renderer
    if known and not again:
        return known
    name = opengl_renderer()
    preferences.write(renderer=name)
    return name
