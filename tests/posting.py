# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program of a job, written by FreeCAD's LinuxCNC post-processor, in 0.20 and 1.x."""

from __future__ import annotations

from vkworkbench import freecad


def posted(job) -> list[str]:
    """Return the lines of the posted program, without the line that contains the time."""
    if freecad.version() < (1, 0):
        from PathScripts.PathPostProcessor import PostProcessor

        processor = PostProcessor.load("linuxcnc")
        text = processor.export(_with_tools(job.Operations.Group), "-", "--no-show-editor")
    else:
        from Path.Post.Processor import PostProcessorFactory

        text = "".join(code for _, code in PostProcessorFactory.get_post_processor(job, "linuxcnc").export())
    return [line for line in text.splitlines() if "Output Time" not in line]


def _with_tools(operations) -> list:
    """Return the operations, with each tool controller before its first operation, like FreeCAD 0.20's command."""
    found, last = [], None
    for operation in operations:
        base = operation
        while not hasattr(base, "ToolController"):
            base = base.Base
        if base.ToolController is not last:
            last = base.ToolController
            found.append(last)
        found.append(operation)
    return found
