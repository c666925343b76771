# SPDX-License-Identifier: MIT
"""samples/npm."""
from typing import Dict, List

from .headers import GENERATOR, Headers, Struct, camel, filled, short, words_of

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
        lines = filled("", _js_members(s, structs), "", width=128, indent="").replace(",", "").strip().split("\n")
        text = " \" +\n    \"".join(line.strip() for line in lines)
        gap = "\n    " if len(lines) > 1 or len(text) > 100 else " "
        out.append(f'  {camel(short(s.name), False)}: layout({s.size},{gap}"{text}"),')
    out += ["};", "", "export const MODEL_BYTES = LAYOUTS.model.size, QUESTION_BYTES = LAYOUTS.question.size;", "", "// Constants, without SINEW_."]
    out += [f"export const {name} = {value};" for name, value in h.constants.items()]
    out += ["", "// Words of enumerations, by number.", "export const WORDS = {"]
    for name, enumerators in h.enums:
        words = words_of(enumerators)
        if words is not None:
            out.append(filled(f"  {camel(short(name), False)}: [", [f'"{w}"' for w in words], "],", indent="    ", width=130))
    out.append("};")
    return "\n".join(out) + "\n"
