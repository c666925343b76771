#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does what a page says: writes the files whose code it shows, then runs its blocks marked `sh` from top to bottom.

  guide.py SOURCE_DIR BUILD_DIR PAGE WORK_DIR     exits with the status of the first command that fails

It runs in WORK_DIR, where the repository's own files are links, so that a page sees what a reader in a fresh clone sees, with build/release built and on
the PATH. What a command is told to write must be there in the end.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import pages

OUTPUT = re.compile(r"(?:^|\s)(?:-o|--output|--png|--sheet|--report|--loop|--sarif|--pictures|--mask-out) ([^\s\"']+)")


def lay_out(source, build, work):
    shutil.rmtree(work, ignore_errors=True)
    (work / "build").mkdir(parents=True)
    (work / "build/release").symlink_to(build)
    for entry in source.iterdir():
        if entry.name != "build" and not entry.name.startswith("."):
            (work / entry.name).symlink_to(entry)


def script_of(page):
    lines = ["set -euo pipefail"]
    for block in page.blocks:
        if block.language == "sh" and not block.file:
            lines += [f"echo '== {page.name}:{block.line}'", "set -x", *block.lines, "{ set +x; } 2>/dev/null"]
    return "\n".join(lines) + "\n"


def outputs_of(page):
    found = []
    for block in page.blocks:
        if block.language == "sh":
            for line in block.lines:
                if re.match(r"sinew(-lab)? ", line):
                    found += OUTPUT.findall(line.split(" #")[0])
    return found


def is_empty(path):
    return not (any(path.iterdir()) if path.is_dir() else path.is_file() and path.stat().st_size > 0)


def run_guide(source, build, name, work):
    page = pages.read_page(source, source / name)
    if not any(block.language == "sh" for block in page.blocks):
        print(f"guide: {name} has no block marked sh")
        return 1
    lay_out(source, build, work)
    for block in page.blocks:
        if block.file:
            (work / block.file).write_text("\n".join(block.lines) + "\n", encoding="utf-8")
    environment = dict(os.environ, PATH=f"{build}:{os.environ['PATH']}")
    status = subprocess.run(["bash", "-c", script_of(page)], cwd=work, env=environment, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL).returncode
    if status:
        print(f"guide: {name}: a command ended with {status}")
        return 1
    missing = [output for output in outputs_of(page) if is_empty(work / output)]
    for output in missing:
        print(f"guide: {name}: {output} was not written")
    return 1 if missing else 0


def main():
    source, build, name, work = sys.argv[1:]
    return run_guide(pathlib.Path(source).resolve(), pathlib.Path(build).resolve(), name, pathlib.Path(work).resolve())


if __name__ == "__main__":
    sys.exit(main())
