#!/usr/bin/env python3
"""Run the examples of README.md and docs/*.md with the program.

CROQUIS names the program, the argument the root of the source tree. Each page has an empty folder of its own, with a link
to data/, in which its blocks are taken in order: `technique`, `component` and `glsl` blocks that name a file are written
there, and a technique is described by the program; each line of an `sh` block is run and must succeed, and where a `text`
block follows at once, the last one must print just that. tutorial_test.py runs the tutorial.
"""

import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

from markdown import blocks, commands

LANGUAGES_OF_FILES = {"technique", "component", "glsl"}
PROGRAM_NAMES = {"croquis", "build/release/croquis"}
LEFT_TO_OTHERS = {"tutorial-component.md"}
MOST_SECONDS = 120


class Page:
    """One page, run in a folder of its own."""

    def __init__(self, path, program, folder):
        self.path, self.program, self.folder = path, program, folder
        self.complaints, self.runs = [], 0

    def run(self):
        page = blocks(self.path.read_text(encoding="utf-8"))
        for block, following in zip(page, [*page[1:], None]):
            if block.language in LANGUAGES_OF_FILES:
                self.take_file(block)
            elif block.language == "sh" and block.is_run:
                expected = following.text if following and following.language == "text" else None
                self.run_block(block, expected)

    def complain(self, block, message):
        self.complaints.append(f"{self.path.name}:{block.line}: {message}")

    def take_file(self, block):
        name = block.file or (f"example_{block.line}.technique" if block.language == "technique" else "")
        if not name:
            return self.complain(block, "names no file")
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(block.text, encoding="utf-8")
        if block.language == "technique" and block.is_run:
            data = ["--data", name.split("/")[0]] if "/" in name else []
            self.run_command(block, ["describe", name, *data], 0)

    def run_block(self, block, expected):
        lines = commands(block)
        for line in lines:
            words = shlex.split(line)
            if words[0] not in PROGRAM_NAMES:
                self.complain(block, f"a line that no test runs: {line}")
                continue
            is_last = line is lines[-1]
            output = self.run_command(block, words[1:], block.status if is_last else 0)
            if is_last and expected is not None and output != expected:
                self.complain(block, f"{line}\n  expected: {expected}  found:    {output}")

    def run_command(self, block, words, status):
        self.runs += 1
        done = subprocess.run([self.program, *words], cwd=self.folder, timeout=MOST_SECONDS, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != status:
            self.complain(block, f"croquis {shlex.join(words)}: exit status {done.returncode}: {done.stdout.strip()}")
        return done.stdout


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    program = str(pathlib.Path(os.environ["CROQUIS"]).resolve())
    complaints, runs = [], 0
    for path in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
        if path.name in LEFT_TO_OTHERS:
            continue
        with tempfile.TemporaryDirectory(prefix="croquis-docs-") as folder:
            (pathlib.Path(folder) / "data").symlink_to(root / "data")
            page = Page(path, program, pathlib.Path(folder))
            page.run()
        complaints += page.complaints
        runs += page.runs
    for complaint in complaints:
        print(complaint)
    print(f"{runs} examples run, {len(complaints)} wrong")
    return 1 if complaints or runs == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
