#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Declarations for other languages, words of options, and the table of struct sizes that libraries answer with, from the C headers by libclang.

    scripts/declarations.py            writes them
    scripts/declarations.py --check    says what differs and exits 1; exits 77 without libclang
    scripts/declarations.py --packages the Debian package that it needs

Words of enumerations are theirs in lower case without the common prefix: SINEW_DEFORM_DELTA_MUSH is "delta-mush" in every language.
"""
import subprocess
import sys
from pathlib import Path

from bindings.c import table_text, words_text
from bindings.csharp import csharp_text
from bindings.csharp_jobs import csharp_jobs_text
from bindings.headers import ROOT, headers_of, library
from bindings.javascript import javascript_text
from bindings.javascript_jobs import jobs_js_text, jobs_types_text
from bindings.python import python_text
from bindings.python_jobs import jobs_text, results_text

PYTHON, CSHARP, NPM = ROOT / "samples/python/src/sinew", ROOT / "samples/csharp", ROOT / "samples/npm/src"
TABLES = {False: ROOT / "engine/src/api/struct_sizes.cpp", True: ROOT / "character/src/capi/struct_sizes.cpp"}


def main() -> int:
    if "--packages" in sys.argv[1:]:
        print("python3-clang")
        return 0
    cindex = library()
    if cindex is None and sys.executable != "/usr/bin/python3" and Path("/usr/bin/python3").exists():
        return subprocess.run(["/usr/bin/python3", __file__, *sys.argv[1:]], check=False).returncode  # Debian's packages are Debian's python's
    if cindex is None:
        print("declarations: SKIPPED, no libclang for python3 (Debian: apt-get install python3-clang)", file=sys.stderr)
        return 77
    native, wasm = headers_of(cindex, "x86_64-unknown-linux-gnu"), headers_of(cindex, "wasm32-unknown-unknown")
    texts = {PYTHON / "declarations.py": python_text(native), PYTHON / "jobs.py": jobs_text(native), PYTHON / "results.py": results_text(native),
             CSHARP / "Native.cs": csharp_text(native), CSHARP / "CharacterJobs.cs": csharp_jobs_text(native),
             NPM / "layouts.js": javascript_text(wasm), NPM / "jobs.js": jobs_js_text(wasm), NPM / "jobs.d.ts": jobs_types_text(wasm),
             ROOT / "samples/cli/enum_words.hpp": words_text(native)}
    for character, path in TABLES.items():
        if path.parent.is_dir() and any(s.character == character for s in native.structs):
            texts[path] = table_text(native, character)
    different = [p for p, text in texts.items() if not p.is_file() or p.read_text(encoding="utf-8") != text]
    for path in different:
        if "--check" in sys.argv[1:]:
            print(f"declarations: {path.relative_to(ROOT)} is not what scripts/declarations.py writes; run it", file=sys.stderr)
        else:
            path.write_text(texts[path], encoding="utf-8")
            print(f"wrote {path.relative_to(ROOT)}")
    return 1 if different and "--check" in sys.argv[1:] else 0


if __name__ == "__main__":
    sys.exit(main())
