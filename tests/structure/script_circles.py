#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Scripts of the page and of the npm package that import each other in a circle.

  script_circles.py SOURCE_DIR     prints each circle with its imports; exits with 1 when there is one
"""
import pathlib
import re
import sys

FOLDERS = ["samples/web/src", "samples/npm/src"]
# Static ones: what import() loads is there later.
IMPORT = re.compile(r'^[ \t]*(?:import|export)\b[^;"\']*(?:\bfrom\s*)?["\']\./([\w.]+)["\']', re.MULTILINE)


def imports(folder):
    scripts = sorted(folder.glob("*.js"))
    return {path.name: {found for found in IMPORT.findall(path.read_text(encoding="utf-8")) if (folder / found).is_file()} for path in scripts}


def circles(graph):
    """Groups of scripts that reach each other."""
    reach = {name: set(ends) for name, ends in graph.items()}
    for middle in graph:
        for name in graph:
            if middle in reach[name]:
                reach[name] |= reach[middle]
    groups = {frozenset(other for other in reach[name] if name in reach[other]) for name in graph if name in reach[name]}
    return sorted(sorted(group) for group in groups)


def main():
    source, faults = pathlib.Path(sys.argv[1]), 0
    for folder in FOLDERS:
        graph = imports(source / folder)
        found = circles(graph)
        faults += len(found)
        print(f"script_circles: {folder}: {len(graph)} scripts, {sum(map(len, graph.values()))} imports between them, {len(found)} circles")
        for group in found:
            for name in group:
                print(f"  {name} imports {', '.join(sorted(graph[name] & set(group)))}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
