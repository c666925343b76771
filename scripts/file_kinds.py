#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of file extensions (formats/src/files/file_kinds.cpp) for front-ends without C++.

    scripts/file_kinds.py            writes it for JavaScript and Godot
    scripts/file_kinds.py --check    says what differs, and which front-end has a list of extensions of its own; exits 1 then

Python, C# and other users of the library ask sinew_character_extensions().
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HEADER, TABLE = "formats/include/sinew_formats/file_kinds.hpp", "formats/src/files/file_kinds.cpp"
JAVASCRIPT, GODOT = "samples/npm/src/file_kinds.js", "samples/godot/addons/sinew/file_kinds.gd"
GENERATOR = f"Generated from {TABLE} by scripts/file_kinds.py; a test compares."
ROW = re.compile(r'\{"(\.[\w.]+)", "([^"]+)", ([\w| ]+), FileReader::k(\w+)\}')
# What people run and what it calls, without tests; a line with three extensions is a list, in C++ a statement.
FRONT_ENDS = ["samples/cli", "samples/web/wasm", "samples/npm/wasm", "formats/src", "formats/character", "formats/datasets", "samples/web/src", "samples/npm/src", "samples/godot/addons", "samples/blender/sinew_blender", "samples/python/src", "samples/csharp"]
SLASHES = r"//.*|(?s:/\*.*?\*/)"
COMMENT = {".cpp": SLASHES, ".hpp": SLASHES, ".js": SLASHES, ".cs": SLASHES, ".html": r"(?s:<!--.*?-->)", ".py": r'#.*|(?s:""".*?""")', ".gd": r"#.*"}


def kinds(root):
    """(extension, name, uses in words, reader) of every row."""
    header, table = (root / HEADER).read_text(encoding="utf-8"), (root / TABLE).read_text(encoding="utf-8")
    bits = {name: int(value) for name, value in re.findall(r"(k\w+) = (\d+)", header[header.index("enum FileUse"):].split("};")[0])}
    known = dict(bits)
    for name, value in re.findall(r"constexpr uint32_t (k\w+) = ([\w| ]+);", table):
        known[name] = eval(value, {}, known)
    rows = [(extension, name, eval(uses, {}, known), reader) for extension, name, uses, reader in ROW.findall(table)]
    if len(rows) != table.count("FileReader::"):
        raise SystemExit(f"file_kinds: {TABLE} has rows that scripts/file_kinds.py cannot read")
    words = [(bit, name[1].lower() + name[2:]) for name, bit in bits.items()]
    return [(e, n, [word for bit, word in words if uses & bit], r.lower()) for e, n, uses, r in rows]


def javascript_text(rows):
    out = ["// SPDX-License-Identifier: MIT", f"// Files by extension. {GENERATOR}", "", "export const fileKinds = ["]
    for extension, name, uses, reader in rows:
        words = ", ".join(f'"{use}"' for use in uses)
        out.append(f'  {{ extension: "{extension}", name: "{name}", reader: "{reader}", uses: [{words}] }},')
    out += ["];", "", "/**", " * The row of a file's extension, without regard to case.", " * @param {string} file", " */",
            "export const fileKind = (file) => fileKinds.find(({ extension }) => file.toLowerCase().endsWith(extension));", "",
            "/**", " * Extensions of the files that have all these uses: readsMesh, readsSkeleton, readsMotion, readsWhole, ..., offered.",
            " * @param {...string} uses", " */",
            "export const extensionsOf = (...uses) =>",
            "  fileKinds.filter((kind) => uses.every((use) => kind.uses.includes(use))).map(({ extension }) => extension);"]
    return "\n".join(out) + "\n"


def godot_text(rows):
    def with_uses(*wanted):
        return [extension for extension, _, uses, _ in rows if set(wanted) <= set(uses)]
    out = ["# SPDX-License-Identifier: MIT", f"# Files by extension. {GENERATOR}", "extends Reference", ""]
    out.append("const MESHES = [" + ", ".join(f'"{extension[1:]}"' for extension in with_uses("readsMesh", "offered")) + "]")
    out += [f'const {name} = "{",".join("*" + extension for extension in with_uses(*uses))}"'
            for name, *uses in (("SKELETONS", "readsSkeleton", "offered"), ("MOTIONS", "readsMotion", "offered"), ("EXPORTS", "writesSkin", "writesWithMesh"))]
    return "\n".join(out) + "\n"


def statements(text):
    """(line, text in one line) of each statement of C++: what a formatter has broken is one again. Ends inside strings do not count."""
    line, start, part, braces = 1, 1, "", 0
    for token in re.findall(r'"(?:[^"\\\n]|\\.)*"|[;{}]|[^";{}]+|"', text):
        if not part.strip():
            start = line + token[:len(token) - len(token.lstrip())].count("\n")
        line += token.count("\n")
        is_body = token == "{" and braces == 0 and not part.rstrip().endswith(("=", ",", "(", "{"))  # else of a list
        braces += {"{": not is_body, "}": -(braces > 0)}.get(token, 0)
        part += token.replace("\n", " ")
        if is_body or token == ";" or (token == "}" and braces == 0 and part.strip() == "}"):
            yield start, part
            part, braces = "", 0
    yield start, part


def own_lists(root, rows):
    """Lines of front-ends, statements of C++, that name three extensions of the table or more."""
    words = "|".join(sorted((re.escape(extension[1:]) for extension, *_ in rows if extension not in (".x", ".mesh")), key=len, reverse=True))
    quoted = re.compile(rf"(?<![\w.])[*.]*\.?({words})(?![\w.]*\w)", re.IGNORECASE)
    bare = re.compile(rf'(?<![\w.])\.({words})(?!\.?\w)|"({words})"', re.IGNORECASE)  # in C++ glTF and VRM are words of many sentences
    faults = []
    for folder in FRONT_ENDS:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix not in COMMENT or name in (JAVASCRIPT, GODOT, TABLE) or "node_modules" in name or path.name == "Test.cs":
                continue
            text = path.read_text(encoding="utf-8")
            blank = re.sub(COMMENT[path.suffix], lambda m: "\n" * m.group().count("\n"), text)
            is_cpp = path.suffix in (".cpp", ".hpp")
            for number, line in statements(blank) if is_cpp else enumerate(blank.split("\n"), 1):
                strings = " ".join(re.findall(r'"[^"]*"|\'[^\']*\'|`[^`]*`|/[^/ ]+/', line))
                if len({found[found.lastindex].lower() for found in (bare if is_cpp else quoted).finditer(strings)}) >= 3:
                    faults.append(f"{name}:{number}: a list of extensions of its own; {TABLE} is the table, and scripts/file_kinds.py writes it for front-ends")
    return faults


def main():
    rows = kinds(ROOT)
    texts = {ROOT / JAVASCRIPT: javascript_text(rows), ROOT / GODOT: godot_text(rows)}
    different = [path for path, text in texts.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    if "--check" not in sys.argv[1:]:
        for path in different:
            path.write_text(texts[path], encoding="utf-8")
            print(f"wrote {path.relative_to(ROOT)}")
        return 0
    faults = [f"{path.relative_to(ROOT)} is not what scripts/file_kinds.py writes; run it" for path in different] + own_lists(ROOT, rows)
    for fault in faults:
        print(f"file_kinds: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
