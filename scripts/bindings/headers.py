# SPDX-License-Identifier: MIT
"""The C headers as data, by libclang."""
import os
import re
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Optional, Tuple

ROOT = Path(__file__).resolve().parents[2]
ENGINE, CHARACTER = ROOT / "engine" / "include" / "sinew", ROOT / "character" / "include" / "sinew"
GENERATOR = "Generated from the C headers by scripts/declarations.py; a test compares."
# What the headers include, so that no C library is needed and every target has its own sizes.
STUBS = {
    "stdint.h": "".join(f"typedef __{u}INT{n}_TYPE__ {u.lower()}int{n}_t;\n" for u in ("", "U") for n in (8, 16, 32, 64)) +
                "typedef __UINTPTR_TYPE__ uintptr_t;\n",
    "stddef.h": "typedef __SIZE_TYPE__ size_t;\n#define NULL ((void*)0)\n",
    "string.h": "#include <stddef.h>\nvoid* memset(void*, int, size_t);\nvoid* memcpy(void*, const void*, size_t);\n",
}


@dataclass
class Type:
    """kind: void, number, struct, function (a callback), opaque; `depth` stars before it; `count` of an array in a struct, 0: none."""

    kind: str
    name: str = ""
    depth: int = 0
    count: int = 0
    const: bool = False


@dataclass
class Member:
    name: str
    type: Type
    offset: int = 0
    size: int = 0
    comment: str = ""  # above it, or behind it on its line


@dataclass
class Struct:
    name: str
    members: List[Member]
    size: int
    character: bool


@dataclass
class Function:
    name: str
    result: Type
    parameters: List[Member]
    character: bool
    comment: str = ""  # before it


@dataclass
class Headers:
    structs: List[Struct] = field(default_factory=list)
    functions: List[Function] = field(default_factory=list)
    callbacks: List[Tuple[str, Type, List[Type]]] = field(default_factory=list)
    enums: List[Tuple[str, Dict[str, int]]] = field(default_factory=list)
    constants: Dict[str, int] = field(default_factory=dict)
    published: Dict[str, int] = field(default_factory=dict)


NUMBERS = {"int8_t", "uint8_t", "int16_t", "uint16_t", "int32_t", "uint32_t", "int64_t", "uint64_t", "size_t", "float", "double", "int",
           "char", "uintptr_t"}


def library():
    """clang.cindex with a libclang that loads, or None."""
    try:
        from clang import cindex
        cindex.Index.create()
        return cindex
    except Exception:  # no module, no library, or one of another version
        return None


def headers_of(cindex, target: str) -> Headers:
    """What the headers declare, with the sizes of a target."""
    found = Headers()
    files = [(h, False) for h in sorted(ENGINE.glob("*.h"))] + [(h, True) for h in sorted(CHARACTER.glob("*.h"))]
    with tempfile.TemporaryDirectory() as stubs:
        for name, text in STUBS.items():
            Path(stubs, name).write_text(text, encoding="utf-8")
        main = Path(stubs, "all.c")
        main.write_text("".join(f'#include "{h}"\n' for h, _ in files), encoding="utf-8")
        unit = cindex.Index.create().parse(str(main), ["-std=c99", "-fparse-all-comments", "-target", target, "-nostdinc", f"-I{stubs}", f"-I{ENGINE.parent}",
                                                       f"-I{CHARACTER.parent}"], options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        errors = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
        if errors:
            sys.exit(f"declarations: {errors[0]}")
        known = {str(h): c for h, c in files}
        opened = set()
        for cursor in unit.cursor.get_children():
            where = str(cursor.location.file)
            if where in known:
                _declaration(cindex.CursorKind, cursor, known[where], found, opened)
    for enumerator, value in found.published.items():
        call = enumerator.split("_")[1].lower()
        of = [e for n, e in found.enums if n in (f"sinew_{call}_method", f"sinew_{call}")]
        if len(of) != 1:
            sys.exit(f"declarations: {enumerator}: no enum of methods is known for it")
        of[0][enumerator] = value
    return found


def _declaration(kinds, cursor, character: bool, found: Headers, seen: set) -> None:
    name = cursor.spelling
    if cursor.kind == kinds.MACRO_DEFINITION:
        text = "".join(t.spelling for t in cursor.get_tokens())[len(name):]
        value = re.fullmatch(r"\(*(?:\(sinew_status\))?(-?(?:0x[0-9a-fA-F]+|\d+))u?\)*", text)
        if value and name.startswith("SINEW_"):
            found.constants[name[6:]] = int(value.group(1), 0)
    elif cursor.kind == kinds.ENUM_DECL:
        enumerators = {c.spelling: c.enum_value for c in cursor.get_children()}
        if not name or "(" in name:  # published.h: methods beside those of a call's own enum
            found.published.update(enumerators)
            return
        found.enums.append((name, enumerators))
        if words_of(enumerators) is None and min(enumerators.values()) > 0:  # flags, which callers combine
            found.constants.update({c[6:]: v for c, v in enumerators.items()})
    elif cursor.kind == kinds.STRUCT_DECL and cursor.is_definition() and name not in seen:
        seen.add(name)
        comments = _comments_of(cursor)
        members = [Member(c.spelling, _type(c.type), cursor.type.get_offset(c.spelling) // 8, c.type.get_size(), comments.get(c.spelling, ""))
                   for c in cursor.get_children() if c.kind == kinds.FIELD_DECL]
        found.structs.append(Struct(name, members, cursor.type.get_size(), character))
    elif cursor.kind == kinds.TYPEDEF_DECL:
        pointee = cursor.underlying_typedef_type.get_pointee()
        if pointee.kind.name in ("FUNCTIONPROTO", "UNEXPOSED") and pointee.get_canonical().kind.name == "FUNCTIONPROTO":
            _callback(name, pointee.get_canonical(), [c for c in cursor.get_children() if c.kind == kinds.PARM_DECL], found)
    elif cursor.kind == kinds.FUNCTION_DECL and cursor.storage_class.name != "STATIC":
        parameters = [Member(p.spelling, _type(p.type)) for p in cursor.get_arguments()]
        found.functions.append(Function(name, _type(cursor.result_type), parameters, character, _plain(cursor.raw_comment or "")))


def _comments_of(struct) -> Dict[str, str]:
    """The comment above each member, or behind it on its line; several that are declared together have one."""
    comments: Dict[str, str] = {}
    names: List[str] = []
    above, ended, line = "", False, 0
    for token in struct.get_tokens():
        if token.kind.name == "COMMENT":
            text = re.sub(r"\s+", " ", _plain(token.spelling))
            if token.location.line == line:
                comments.update({name: text for name in names})
            else:
                above = text
        elif token.spelling == ";":
            comments.update({name: above for name in names if above})
            above, ended = "", True
        elif token.kind.name == "IDENTIFIER":
            names, ended = (names if not ended else []) + [token.spelling], False
        line = token.extent.end.line
    return comments


def _plain(comment: str) -> str:
    """A comment without its stars."""
    lines = [re.sub(r"^\s*\*?\s?", "", line).rstrip() for line in comment.removeprefix("/*").removesuffix("*/").split("\n")]
    return "\n".join(lines).strip()


def _callback(name: str, proto, named, found: Headers) -> None:
    kinds = []
    for i, one in enumerate(proto.argument_types()):
        pointee = one.get_pointee()
        if pointee.kind.name == "FUNCTIONPROTO":  # a callback that a callback gets
            inner = f"{name}_{named[i].spelling if i < len(named) else 'body'}"
            _callback(inner, pointee, [], found)
            kinds.append(Type("function", inner))
        else:
            kinds.append(_type(one))
    found.callbacks.append((name, _type(proto.get_result()), kinds))


def _type(one) -> Type:
    count = 0
    if one.kind.name in ("CONSTANTARRAY",):
        count, one = one.element_count, one.element_type
    if one.kind.name in ("INCOMPLETEARRAY",):
        return Type("number", "float", 1)
    depth, const = 0, False
    while True:
        spelled = one.spelling.replace("const ", "").replace("struct ", "").strip()
        if one.kind.name in ("TYPEDEF", "ELABORATED") and one.get_canonical().kind.name == "POINTER" and depth == 0:
            return Type("function", spelled, 0, count)
        if one.get_canonical().kind.name != "POINTER":
            break
        one = one.get_pointee() if one.kind.name == "POINTER" else one.get_canonical().get_pointee()
        const = one.is_const_qualified()
        depth += 1
    if one.get_canonical().kind.name == "CONSTANTARRAY":  # a pointer to an array: of its elements
        one = one.element_type
        spelled = one.spelling
    canonical = one.get_canonical()
    if canonical.kind.name == "VOID":
        return Type("void", "", depth, count, const)
    if canonical.kind.name == "ENUM":
        return Type("number", "int", depth, count, const)
    if canonical.kind.name == "RECORD":
        complete = canonical.get_declaration().is_definition() or canonical.get_size() > 0
        return Type("struct" if complete else "opaque", canonical.get_declaration().spelling, depth, count, const)
    spelled = {"unsigned int": "uint32_t", "unsigned char": "uint8_t", "unsigned short": "uint16_t", "short": "int16_t"}.get(spelled, spelled)
    if spelled not in NUMBERS:
        sys.exit(f"declarations: {spelled}: no such type is known; add it to scripts/declarations.py")
    return Type("number", spelled, depth, count, const)


def words_of(enumerators: Dict[str, int]) -> Optional[List[str]]:
    """Words by number, "" for a number that no one has; None for flags and codes, whose numbers are no list."""
    values = list(enumerators.values())
    if min(values) < 0 or sorted(values)[:2] == [1, 2] or max(values) > 2 * len(values):
        return None
    prefix = os.path.commonprefix(list(enumerators)) if len(enumerators) > 1 else next(iter(enumerators))
    prefix = prefix[:prefix.rindex("_") + 1]
    words = [""] * (max(values) + 1)
    for name, value in enumerators.items():
        words[value] = name[len(prefix):].lower().replace("_", "-")
    return words


def camel(name: str, first_upper: bool = True) -> str:
    parts = name.replace("-", "_").split("_")
    return "".join(p[:1].upper() + p[1:] if i or first_upper else p for i, p in enumerate(parts))


def filled(first: str, items: List[str], last: str, width: int = 140, indent: str = "    ") -> str:
    """Items on as few lines as they fit."""
    lines, line = [], first
    for i, item in enumerate(items):
        word = item + ("," if i + 1 < len(items) else last)
        if len(line) + len(word) + 1 > width:
            lines.append(line)
            line = indent + word
        else:
            line += (" " if line[-1:] not in "([{ " else "") + word
    return "\n".join(lines + [line if items else first + last])


def short(name: str) -> str:
    return name[6:] if name.startswith("sinew_") else name
