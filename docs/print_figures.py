# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the output of commands into the documents, where a pair of comments names the command.

    python3 docs/print_figures.py [DOCUMENT ...] [--only TEXT] [--list]

By default, DOCUMENTS are docs/*.md and README.md. A pair of comments is

    <!-- printed by: python3 benchmarks/literal.py -->
    <!-- end -->

and the script writes the command and its output between the two comments. A shell runs the command at the top of the
checkout (`| tail -n 5` takes a part). Output that begins with | becomes a table of the document, other output a block
of text. --only runs only the commands that contain TEXT, and --list prints the commands without running them. If a
command fails, its place in the document stays unchanged, and the exit status is 1. A command with `$FILES`, the names
of toolpaths that are not in the repository, fails if the variable is not set.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PLACE = re.compile(r"^<!-- printed by: (?P<command>[^\n]+?) -->\n(?P<text>.*?)^<!-- end -->$", re.MULTILINE | re.DOTALL)


def documents() -> list[Path]:
    """Return all documents in which commands can write their output."""
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def printed(command: str) -> str | None:
    """Return the output of a command in the form of a document; None if it fails."""
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", command],
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
    )
    text = "\n".join(line.rstrip() for line in done.stdout.splitlines()).strip("\n")
    if done.returncode or not text:
        print(f"{command}: {done.stderr.strip() or 'printed nothing'}", file=sys.stderr)
        return None
    if text.startswith("|"):
        return f"\nPrinted by `{command}`:\n\n{text}\n\n"
    return f"\n```text\n$ {command}\n{text}\n```\n\n"


def main() -> int:
    """Run the chosen commands, and write their output into the documents."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("documents", nargs="*", type=Path, default=documents())
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    chosen = parser.parse_args()
    failed = 0
    for document in chosen.documents:
        for place in PLACE.finditer(document.read_text(encoding="utf-8")):
            command = place["command"]
            if chosen.only not in command:
                continue
            print(f"{document.name}: {command}", flush=True)
            text = None if chosen.list else printed(command)
            failed += text is None and not chosen.list
            if text is not None:
                new = f"<!-- printed by: {command} -->\n{text}<!-- end -->"
                # Read the document again, because a command can take long, and the document can be edited meanwhile.
                document.write_text(document.read_text(encoding="utf-8").replace(place[0], new), encoding="utf-8")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
