#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Declarations for other languages, and the table of struct sizes that libraries answer with, from the C headers by libclang.

    scripts/declarations.py            writes them
    scripts/declarations.py --check    says what differs and exits 1; exits 77 without libclang
    scripts/declarations.py --packages the Debian package that it needs

Words of enumerations are theirs in lower case without the common prefix: SINEW_DEFORM_DELTA_MUSH is "delta-mush" in every language.
"""
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Optional, Tuple

ROOT = Path(__file__).resolve().parents[1]
ENGINE, CHARACTER = ROOT / "engine" / "include" / "sinew", ROOT / "formats" / "character" / "include" / "sinew"
PYTHON, CSHARP = ROOT / "samples" / "python" / "src" / "sinew" / "declarations.py", ROOT / "samples" / "csharp" / "Native.cs"
JAVASCRIPT = ROOT / "samples" / "npm" / "src" / "layouts.js"
TABLES = {False: ROOT / "engine" / "src" / "api" / "struct_sizes.cpp", True: ROOT / "formats" / "character" / "capi" / "struct_sizes.cpp"}
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
        unit = cindex.Index.create().parse(str(main), ["-std=c99", "-target", target, "-nostdinc", f"-I{stubs}", f"-I{ENGINE.parent}",
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
        members = [Member(c.spelling, _type(c.type), cursor.type.get_offset(c.spelling) // 8, c.type.get_size())
                   for c in cursor.get_children() if c.kind == kinds.FIELD_DECL]
        found.structs.append(Struct(name, members, cursor.type.get_size(), character))
    elif cursor.kind == kinds.TYPEDEF_DECL:
        pointee = cursor.underlying_typedef_type.get_pointee()
        if pointee.kind.name in ("FUNCTIONPROTO", "UNEXPOSED") and pointee.get_canonical().kind.name == "FUNCTIONPROTO":
            _callback(name, pointee.get_canonical(), [c for c in cursor.get_children() if c.kind == kinds.PARM_DECL], found)
    elif cursor.kind == kinds.FUNCTION_DECL and cursor.storage_class.name != "STATIC":
        parameters = [Member(p.spelling, _type(p.type)) for p in cursor.get_arguments()]
        found.functions.append(Function(name, _type(cursor.result_type), parameters, character))


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


def short(name: str) -> str:
    return name[6:] if name.startswith("sinew_") else name


# ---- Python -------------------------------------------------------------------------------------------------------

_CTYPES = {"int": "c_int", "char": "c_char", "uintptr_t": "c_size_t", "size_t": "c_size_t", "float": "c_float", "double": "c_double"}


def _ctype(one: Type) -> str:
    base = {"number": lambda: _CTYPES.get(one.name, "c_" + one.name[:-2]), "struct": lambda: one.name, "function": lambda: one.name,
            "void": lambda: "None", "opaque": lambda: "c_void_p"}[one.kind]()
    text = base
    if one.depth and one.kind == "number" and one.name == "char":
        text = "c_void_p" if not one.const and one.depth == 1 else "c_char_p" if one.depth == 1 else "POINTER(c_char_p)"
    elif one.depth == 1:
        text = f"POINTER({base})" if one.kind == "struct" or one.name == "size_t" else "c_void_p"
    elif one.depth == 2:
        text = f"POINTER(POINTER({base}))" if one.kind == "struct" else "POINTER(c_void_p)"
    return f"{text} * {one.count}" if one.count else text


def _filled(first: str, items: List[str], last: str, width: int = 140, indent: str = "    ") -> str:
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


def python_text(h: Headers) -> str:
    out = ["# SPDX-License-Identifier: MIT", f'"""The C interface by ctypes: constants, words of enumerations, structs, functions. {GENERATOR}"""',
           "import sys", "from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int, c_int8, c_int16, c_int32, c_int64,",
           "                    c_size_t, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p)", "from typing import Any, Dict, List, Tuple", "",
           "from typing import Literal", "", "# Constants, without SINEW_."]
    out += [f"{name} = {value}" for name, value in h.constants.items()]
    out += ["", "# Words of enumerations, by number."]
    for name, enumerators in h.enums:
        words = words_of(enumerators)
        if words is None:
            out.append(_filled(f"{short(name).upper()}: Dict[str, int] = {{", [f'"{k[6:]}": {v}' for k, v in enumerators.items()], "}"))
            continue
        real = [f'"{w}"' for w in words if w]
        out.append(_filled(f"{camel(short(name))} = Literal[", real, "]"))
        out.append(_filled(f"{short(name).upper()}: Tuple[str, ...] = (", [f'"{w}"' for w in words], ",)" if len(words) == 1 else ")"))
    out += ["", "# Callbacks."]
    for name, result, kinds in h.callbacks:
        out.append(f"{name} = CFUNCTYPE({', '.join([_ctype(result)] + [_ctype(k) for k in kinds])})")
    for struct in h.structs:
        fields = [f'("{m.name}", {_ctype(m.type)})' for m in struct.members]
        out += ["", "", f"class {struct.name}(Structure):", _filled("    _fields_ = [", fields, "]", indent="        ")]
    for character, title in ((False, "STRUCTS"), (True, "CHARACTER_STRUCTS")):
        names = [s.name for s in h.structs if s.character == character]
        out += ["", "" if character else "\n", _filled(f"{title}: Tuple[Any, ...] = (", names, ",)" if len(names) == 1 else ")")]
    for character, title in ((False, "FUNCTIONS"), (True, "CHARACTER_FUNCTIONS")):
        out += ["", "", f"# Result and arguments{' of sinew/character.h' if character else ''}.", f"{title}: Dict[str, Tuple[Any, List[Any]]] = {{"]
        for one in h.functions:
            if one.character == character:
                result = _ctype(one.result)
                out.append(_filled(f'    "{one.name}": ({result}, [', [_ctype(p.type) for p in one.parameters], "]),", indent="        "))
        out.append("}")
    text = "\n".join(out) + "\n"
    known = {f"c_{n}" for n in ("char", "char_p", "double", "float", "int", "int8", "int16", "int32", "int64", "size_t", "uint8", "uint16",
                                "uint32", "uint64", "void_p")} | {"CFUNCTYPE", "POINTER", "Structure"}
    used = set(re.findall(r"\w+", text.split("c_void_p)\n", 1)[1])) & known
    names = sorted(used, key=lambda n: (n[0].islower(), n))
    head = _filled("from ctypes import (", names, ")", indent=" " * 20)
    return re.sub(r"import sys\nfrom ctypes import \([^)]*\)\n(from typing[^\n]*)\n\nfrom typing import Literal\n",
                  lambda m: head + "\nfrom typing import Any, Dict, List, Literal, Tuple\n", text, 1)


# ---- C# -----------------------------------------------------------------------------------------------------------

_CSHARP = {"int8_t": "sbyte", "uint8_t": "byte", "int16_t": "short", "uint16_t": "ushort", "int32_t": "int", "uint32_t": "uint",
           "int64_t": "long", "uint64_t": "ulong", "size_t": "UIntPtr", "uintptr_t": "UIntPtr", "float": "float", "double": "double",
           "int": "int", "char": "byte"}
_CSHARP_WORDS = {"params", "out", "ref", "object", "string", "in", "is", "as", "base", "event", "fixed", "lock", "checked"}


def _csharp_name(name: str) -> str:
    return "@" + name if name in _CSHARP_WORDS else name


def _csharp_type(one: Type) -> str:
    if one.depth or one.kind in ("function", "opaque"):
        return "IntPtr"
    return {"void": "void", "struct": one.name}.get(one.kind) or _CSHARP[one.name]


def _csharp_parameter(one: Member) -> str:
    if one.type.kind == "number" and one.type.name == "size_t" and one.type.depth == 1:
        return f"out UIntPtr {_csharp_name(one.name)}"
    if one.type.depth == 2 and one.type.kind in ("opaque", "void") and not one.name.endswith("s"):  # several are an array of the caller's
        return f"out IntPtr {_csharp_name(one.name)}"
    return f"{_csharp_type(one.type)} {_csharp_name(one.name)}"


def csharp_text(h: Headers) -> str:
    out = ["// SPDX-License-Identifier: MIT", f"// The C interface by P/Invoke, as it is. {GENERATOR}",
           "// Every pointer is an IntPtr; structs have no managed members, so that a pinned box of one is what C reads. Arrays in structs have",
           "// their elements as members, name_0 and so on.", "#pragma warning disable 1591", "using System;",
           "using System.Runtime.InteropServices;", "", "namespace Sinew", "{"]
    for name, enumerators in h.enums:
        words = words_of(enumerators)
        if words is not None:
            items = [f"{_cased(w)} = {i}" for i, w in enumerate(words) if w]
            out.append(_filled(f"    public enum {camel(short(name))} {{ ", items, " }", indent="        "))
    out += ["", "    /// <summary>The C interface as it is. Structs have the names and the layout of C.</summary>", "    public static class Native", "    {",
            '        public const string Library = "sinew", CharacterLibrary = "sinew_character";']
    for name, value in h.constants.items():
        kind = "uint" if value >= 0 else "int"
        out.append(f"        public const {kind} {name} = {value};")
    for name, enumerators in h.enums:
        if words_of(enumerators) is None and min(enumerators.values()) <= 0:
            out += [f"        public const int {k[6:]} = {v};" for k, v in enumerators.items()]
    for name, result, kinds in h.callbacks:
        parameters = ", ".join(f"{_csharp_type(k)} {chr(97 + i)}" for i, k in enumerate(kinds))
        out += ["", "        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]", f"        public delegate {_csharp_type(result)} {name}({parameters});"]
    for struct in h.structs:
        out += ["", "        [StructLayout(LayoutKind.Sequential)]", f"        public struct {struct.name}", "        {"]
        line_type, names = "", []
        for member in struct.members + [Member("", Type("void"))]:
            kind = _csharp_type(member.type)
            if kind != line_type and names:
                out.append(_filled(f"            public {line_type}", names, ";", indent="                "))
                names = []
            line_type = kind
            names += [f"{member.name}_{i}" for i in range(member.type.count)] or [_csharp_name(member.name)]
        out.append("        }")
    for one in h.functions:
        where = "CharacterLibrary" if one.character else "Library"
        out += ["", f"        [DllImport({where}, CallingConvention = CallingConvention.Cdecl)]",
                _filled(f"        public static extern {_csharp_type(one.result)} {one.name}(", [_csharp_parameter(p) for p in one.parameters], ");",
                        indent="            ")]
    for character, name in ((False, "Structs"), (True, "CharacterStructs")):
        out += ["", f"        internal static readonly StructSize[] {name} =", "        {"]
        for struct in h.structs:
            if struct.character == character:
                grows = str(struct.members[0].name == "struct_size").lower()
                out.append(f'            new StructSize("{struct.name}", Marshal.SizeOf(typeof({struct.name})), {grows}),')
        out.append("        };")
    out += ["    }", "", "    /// <summary>What is compared with the library when it is loaded.</summary>", "    struct StructSize", "    {",
            "        public readonly string Name;", "        public readonly int Bytes;", "        public readonly bool Grows;", "",
            "        public StructSize(string name, int bytes, bool grows)", "        {", "            Name = name;",
            "            Bytes = bytes;", "            Grows = grows;", "        }", "    }", "}"]
    return "\n".join(out) + "\n"


def _cased(word: str) -> str:
    name = camel(word)
    return name if not name[0].isdigit() else "_" + name


# ---- JavaScript ---------------------------------------------------------------------------------------------------

_JS = {"int8_t": "i8", "uint8_t": "u8", "int16_t": "i16", "uint16_t": "u16", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64",
       "uint64_t": "u64", "size_t": "u32", "uintptr_t": "u32", "float": "f32", "double": "f64", "int": "i32", "char": "u8"}


def _js_members(struct: Struct, structs: Dict[str, Struct], at: int = 0, prefix: str = "") -> List[str]:
    out = []
    for m in struct.members:
        offset = at + m.offset
        if m.type.kind == "struct" and not m.type.depth:
            inner = structs[m.type.name]
            for i in range(max(m.type.count, 1)):
                name = f"{prefix}{m.name}_{i}_" if m.type.count else prefix
                out += _js_members(inner, structs, offset + i * inner.size, name)
            continue
        kind = "u32" if m.type.depth or m.type.kind == "function" else _JS[m.type.name]
        out.append(f"{prefix}{m.name}@{offset}:{kind}" + (f"x{m.type.count}" if m.type.count else ""))
    return out


def javascript_text(h: Headers) -> str:
    structs = {s.name: s for s in h.structs}
    out = ["// SPDX-License-Identifier: MIT", f"// The engine's structs on wasm32, constants and words of enumerations. {GENERATOR}",
           "// A member is name@offset:type, or name@offset:typexCOUNT for an array in a struct; a struct in a struct has its members here,",
           "// those of an array of them as name_0_member. Addresses are u32.",
           "/** @type {(size: number, text: string) => any} */", "const layout = (size, text) => ({", "  size,", '  members: text.split(" ").map((word) => {',
           "    const [, name, offset, type, count] = /^(\\w+)@(\\d+):([uif]\\d+)(?:x(\\d+))?$/.exec(word) ?? [];",
           "    return { name, offset: Number(offset), type, count: Number(count ?? 0) };", "  }),", "});", "",
           "export const LAYOUTS = {"]
    for s in h.structs:
        lines = _filled("", _js_members(s, structs), "", width=128, indent="").replace(",", "").strip().split("\n")
        text = " \" +\n    \"".join(line.strip() for line in lines)
        gap = "\n    " if len(lines) > 1 or len(text) > 100 else " "
        out.append(f'  {camel(short(s.name), False)}: layout({s.size},{gap}"{text}"),')
    out += ["};", "", "export const MODEL_BYTES = LAYOUTS.model.size, QUESTION_BYTES = LAYOUTS.question.size;", "", "// Constants, without SINEW_."]
    out += [f"export const {name} = {value};" for name, value in h.constants.items()]
    out += ["", "// Words of enumerations, by number.", "export const WORDS = {"]
    for name, enumerators in h.enums:
        words = words_of(enumerators)
        if words is not None:
            out.append(_filled(f"  {camel(short(name), False)}: [", [f'"{w}"' for w in words], "],", indent="    ", width=130))
    out.append("};")
    return "\n".join(out) + "\n"


# ---- C ------------------------------------------------------------------------------------------------------------

def table_text(h: Headers, character: bool) -> str:
    headers = sorted(p.name for p in (CHARACTER if character else ENGINE).glob("*.h") if p.name not in ("sinew.h", "abi.h"))
    out = ["// SPDX-License-Identifier: MIT", f"// {GENERATOR}"] + ([] if character else ['#include "sinew/abi.h"'])
    out += [f'#include "sinew/{name}"' for name in headers]
    out += ["", "namespace {", "", "struct StructSize {", "  const char* name;", "  size_t size_bytes;", "};", "", "constexpr StructSize kStructSizes[] = {"]
    out += [f'    {{"{s.name}", sizeof({s.name})}},' for s in h.structs if s.character == character]
    out += ["};", "", "bool equal(const char* a, const char* b) {  // the engine needs no C library", "  while (*a != '\\0' && *a == *b) ++a, ++b;",
            "  return *a == *b;", "}"]
    out += ["", "}  // namespace", "", f"size_t sinew_{'character_' if character else ''}struct_size(const char* name) {{",
            "  if (name == nullptr) return 0;", "  for (const StructSize& one : kStructSizes)",
            "    if (equal(one.name, name)) return one.size_bytes;", "  return 0;", "}"]
    return "\n".join(out) + "\n"


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
    texts = {PYTHON: python_text(native), CSHARP: csharp_text(native), JAVASCRIPT: javascript_text(wasm)}
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
