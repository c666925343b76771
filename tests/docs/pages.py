# SPDX-License-Identifier: MIT
"""Markdown pages of the repository, their lines and their code: what markdown.py, commands.py and guide.py share."""
import dataclasses
import os
import pathlib
import re

LEFT_OUT = {"build", "dist", "node_modules", "third_party"}
FENCE = re.compile(r"^(\s*)(`{3,})\s*(\S*)\s*(\S*)\s*$")


@dataclasses.dataclass
class Block:
    """Code: the language and the file name of a fence, both "" for indented lines; the line that its first line is."""

    language: str
    file: str
    line: int
    lines: list


@dataclasses.dataclass
class Page:
    name: str  # with slashes, from the root
    text: str
    prose: list = dataclasses.field(default_factory=list)  # (line number, text) of every line outside of code
    blocks: list = dataclasses.field(default_factory=list)

    def __post_init__(self):
        fence, block, before = None, None, ""
        for number, line in enumerate(self.text.splitlines(), 1):
            mark = FENCE.match(line)
            if fence:
                if mark and len(mark.group(2)) >= len(fence) and not mark.group(3):
                    fence = None
                else:
                    block.lines.append(line)
            elif mark:
                fence, block = mark.group(2), Block(mark.group(3), mark.group(4), number + 1, [])
                self.blocks.append(block)
            elif line.startswith("    ") and (not before.strip() or before.startswith("    ")) and not re.match(r"\s*([-*]|\d+\.)\s", line):
                if not before.startswith("    ") or block is None or block.language:
                    block = Block("", "", number, [])
                    self.blocks.append(block)
                block.lines.append(line[4:])
            else:
                self.prose.append((number, line))
            before = line

    def spans(self):
        """(line number, code) of code between backquotes, which may go on in the next line of a paragraph."""
        paragraph = []
        for number, line in [*self.prose, (0, "")]:
            if line.strip() and not line.startswith("#") and not line.lstrip().startswith("|"):
                paragraph.append((number, line))
                continue
            yield from self._spans_of(paragraph)
            paragraph = []
            yield from self._spans_of([(number, line)])

    @staticmethod
    def _spans_of(lines):
        text = "\n".join(line for _, line in lines)
        for found in re.finditer(r"(`+)(.+?)\1(?!`)", text, re.DOTALL):
            yield lines[text.count("\n", 0, found.start())][0], " ".join(found.group(2).replace("\\|", "|").split())


def read_page(root, path):
    return Page(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))


def pages_of(root):
    root, found = pathlib.Path(root), []
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in LEFT_OUT and not name.startswith("."))
        found += [read_page(root, pathlib.Path(folder) / name) for name in sorted(files) if name.endswith(".md")]
    return found
