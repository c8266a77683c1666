"""The code blocks of a Markdown page, with what stands before them.

A line `FILE`: just before a block (in backquotes, with the colon) names the file that the block is. With `FILE`, after
`LINE`: or `FILE`, at the end: it is to be put into that file. A comment <!-- not run: reason --> before a block says that
the tests leave it alone, <!-- exits with N --> that its last command ends so.
"""

import dataclasses
import re

FENCE = re.compile(r"^```(\w*)\s*$")
FILE = re.compile(r"^`([^`]+)`(?:, (at the end|after `([^`]+)`))?:$")
NOT_RUN = re.compile(r"^<!-- not run: .+ -->$")
STATUS = re.compile(r"^<!-- exits with (\d+) -->$")


@dataclasses.dataclass
class Block:
    language: str
    text: str
    line: int  # of its first line in the page
    file: str = ""  # what the block is, or is put into
    after: str = ""  # the line of `file` that it is put after
    at_end: bool = False  # it is put at the end of `file`
    is_run: bool = True
    status: int = 0  # with which its last command ends


def blocks(text):
    """All code blocks of a page, in order."""
    found, before = [], []
    lines = iter(enumerate(text.splitlines(), start=1))
    for number, line in lines:
        fence = FENCE.match(line)
        if not fence:
            before += [line] if line.strip() else []
            continue
        content = []
        for _, inner in lines:
            if inner.strip() == "```":
                break
            content.append(inner)
        block = Block(fence[1], "\n".join(content) + "\n", number + 1)
        for marker in before[-2:]:
            describe(block, marker)
        found.append(block)
        before = []
    return found


def describe(block, marker):
    """Reads one of the lines before a block."""
    if named := FILE.match(marker):
        block.file, block.after, block.at_end = named[1], named[3] or "", named[2] == "at the end"
    if NOT_RUN.match(marker):
        block.is_run = False
    if status := STATUS.match(marker):
        block.status = int(status[1])


def commands(block):
    """The command lines of a block, continued lines joined, comments left out."""
    joined = block.text.replace("\\\n", " ")
    return [line.strip() for line in joined.splitlines() if line.strip() and not line.strip().startswith("#")]
