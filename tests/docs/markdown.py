#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Links of the Markdown pages lead somewhere, and the pages are short enough to be read.

  markdown.py SOURCE_DIR     prints each broken link, and each page or line that is too long; exits with 1 when there is one
"""
import pathlib
import posixpath
import re
import sys

sys.dont_write_bytecode = True
import pages

LINK = re.compile(r"\]\(([^)\s]+)\)")
COLUMNS = 140  # of prose; tables and code cannot be broken
# The first that fits.
MOST_LINES = [("README.md", 70), ("docs/*.md", 80), ("*/README.md", 150)]


def anchors_of(page):
    """As GitHub makes them of headings."""
    found, seen = set(), {}
    for _, line in page.prose:
        heading = re.match(r"#{1,6}\s+(.*?)\s*$", line)
        if not heading:
            continue
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1))
        slug = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(f"{slug}-{count}" if count else slug)
    return found


def check_links(root, all_pages):
    faults, count = [], 0
    anchors = {page.name: anchors_of(page) for page in all_pages}
    for page in all_pages:
        folder = posixpath.dirname(page.name)
        for number, line in page.prose:
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                if re.match(r"[a-z]+:", target):
                    continue
                count += 1
                path, _, anchor = target.partition("#")
                name = posixpath.normpath(posixpath.join(folder, path)) if path else page.name
                if not (root / name).exists():
                    faults.append(f"{page.name}:{number}: the link {target} leads to {name}, which does not exist")
                elif anchor and anchor not in anchors.get(name, ()):
                    faults.append(f"{page.name}:{number}: the link {target} leads to a heading that {name} does not have")
        for number, code in page.spans():
            if not re.fullmatch(r"[\w./-]+/[\w.-]+\.md", code):
                continue
            count += 1
            if not any((root / base / code).exists() for base in ("", folder)):
                faults.append(f"{page.name}:{number}: {code} does not exist")
    return faults, f"{count} links"


def check_lengths(root, all_pages):
    faults = []
    for page in all_pages:
        lines = page.text.count("\n")
        for pattern, most in MOST_LINES:
            if page.name == pattern or ("*" in pattern and pathlib.PurePosixPath(page.name).match(pattern)):
                if lines > most:
                    faults.append(f"{page.name}: {lines} lines, expected {most} at most; figures go to tests/bench and trainer/configs")
                break
        for number, line in page.prose:
            if len(line) > COLUMNS and not line.lstrip().startswith("|") and " " in line.strip():
                faults.append(f"{page.name}:{number}: {len(line)} columns, expected {COLUMNS} at most")
    return faults, f"{len(all_pages)} pages"


def main():
    root = pathlib.Path(sys.argv[1])
    all_pages, faults = pages.pages_of(root), []
    for check in (check_links, check_lengths):
        found, counted = check(root, all_pages)
        faults += found
        print(f"markdown: {counted}, {len(found)} faults")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
