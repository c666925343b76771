#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No namespace has two types of one name: the linker would take the inline functions of either for both.
    type_names_test.py SOURCE_DIR"""
import collections
import pathlib
import re
import sys

PATTERN = re.compile(r'namespace\s*([\w:]*)\s*\{|\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:alignas\(\w+\)\s+)?(\w+)(?:\s+final)?'
                     r'\s*(?::[^;{:][^;{]*)?\{|[{}]')


def types_of(text):
    """(namespace, name) of every type that `text` defines outside of unnamed namespaces."""
    text = re.sub(r'R"(\w*)\((?:.|\n)*?\)\1"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', ' ', text)
    open_braces = []
    for match in PATTERN.finditer(text):
        token = match.group(0)
        if token == '}':
            if open_braces:
                open_braces.pop()
        elif token.startswith('namespace'):
            open_braces.append(match.group(1) or '(unnamed)')
        else:
            if match.group(2) and None not in open_braces and '(unnamed)' not in open_braces:
                yield '::'.join(open_braces), match.group(2)
            open_braces.append(None)


def main():
    root = pathlib.Path(sys.argv[1])
    found = collections.defaultdict(set)
    for folder in ('engine', 'formats', 'trainer', 'quant', 'samples/cli', 'samples/web/wasm'):
        for path in sorted((root / folder).rglob('*.?pp')):
            for name in types_of(path.read_text(encoding='utf-8')):
                found[name].add(str(path.relative_to(root)))
    twice = {name: paths for name, paths in found.items() if len(paths) > 1}
    for (namespace, name), paths in sorted(twice.items()):
        print(f'{namespace}::{name} is defined in {" and in ".join(sorted(paths))}')
    print(f'{len(found)} types, {len(twice)} defined twice')
    return 1 if twice or len(found) < 300 else 0


if __name__ == '__main__':
    sys.exit(main())
