#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Types of one name in one namespace, in two files: undefined behavior as soon as one program has both. Linkers do not tell.

  type_names.py SOURCE_DIR     prints each such pair; exits with 1 when there is one
"""
import pathlib
import re
import sys

# Libraries that one program may link all of, and that program.
FOLDERS = ["engine/include", "engine/src", "formats", "character", "trainer", "quant", "samples/cli"]
NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/'
    r'|R"([^()\s\\]{0,16})\(.*?\)\1"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'"
    r"|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.DOTALL | re.MULTILINE)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|\[\[|\]\]|[{}();=<>,:&*]")
TYPE = {"struct", "class", "union", "enum"}


def name_of_head(head):
    """The name of the type that these tokens define before its brace, or None: a function, an initializer, a specialization."""
    depth = 0  # of template<...>
    for i, token in enumerate(head):
        if token == "<":
            depth += 1
        elif token == ">":
            depth -= 1
        elif token in TYPE and depth == 0:
            rest = head[i + 1:]
            break
    else:
        return None
    while rest and rest[0] in TYPE | {"alignas", "[["}:
        if rest[0] in TYPE:
            rest = rest[1:]
        else:
            rest = rest[rest.index("]]" if rest[0] == "[[" else ")") + 1:]
    if not rest or not re.match(r"[A-Za-z_]", rest[0]):
        return None
    name, after = rest[0], [t for t in rest[1:] if t != "final"]
    while len(after) >= 2 and after[0] == "::":  # struct Outer::Inner
        name, after = name + "::" + after[1], after[2:]
    return name if not after or after[0] == ":" else None


def definitions(text):
    """(qualified name, line) of the types that stand in a namespace with external linkage."""
    text = NOISE.sub(lambda m: "\n" * m.group().count("\n") if m.group().lstrip()[:1] in "/#" else ' "" ' + "\n" * m.group().count("\n"), text)
    scopes, head, line, end = [], [], 1, 0  # a scope: names of a namespace, "" = extern "C", or None for all else
    for token in TOKEN.finditer(text):
        word = token.group()
        line += text.count("\n", end, token.start())
        end = token.start()
        if word == "{":
            scope = None
            if None not in scopes:
                if "namespace" in head and "=" not in head:
                    names = "".join(head[head.index("namespace") + 1:]).replace("inline", "")
                    scope = names or "(unnamed)"
                elif head == ["extern"]:
                    scope = ""
                else:
                    name = name_of_head(head)
                    if name and "(unnamed)" not in scopes:
                        yield "::".join([s for s in scopes if s] + [name]), line
            scopes.append(scope)
            head = []
        elif word == "}":
            if scopes:
                scopes.pop()
            head = []
        elif word == ";":
            head = []
        else:
            head.append(word)


def main():
    source = pathlib.Path(sys.argv[1])
    seen, faults = {}, []
    for folder in FOLDERS:
        for path in sorted(p for p in (source / folder).rglob("*") if p.suffix in (".hpp", ".cpp", ".h")):
            where = str(path.relative_to(source))
            for name, line in definitions(path.read_text(encoding="utf-8")):
                first = seen.setdefault(name, (where, line))
                if first[0] != where:
                    faults.append(f"{where}:{line}: {name} is a type of {first[0]}:{first[1]} already; a namespace a room keeps them apart")
    print(f"type_names: {len(seen)} in {' '.join(FOLDERS)}, {len(faults)} defined in two files")
    for fault in faults:
        print(fault)
    if len(seen) < 300:
        print(f"type_names: only {len(seen)} types were found: this test no longer reads the sources")
        return 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
