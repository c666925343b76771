# SPDX-License-Identifier: MIT
"""samples/npm: plain objects as options and results of the jobs, and their types."""
import re
import textwrap
from typing import List, Tuple

from .headers import GENERATOR, Headers, Struct, camel, filled, short, words_of
from .members import Value, base, result_structs, values_of

# Calls that the module has: name in C, options, result.
CALLS = {"bind": "BindOptions", "rig": "RigOptions", "animate": "RetargetOptions", "transfer": "TransferOptions", "transform": "TransformOptions",
         "profile": "ProfileOptions", "check": "CheckOptions", "springs": "SpringsOptions",
         "picture": "PictureOptions"}
RESULTS = ("bind_result", "rig_result", "animate_result", "transfer_result", "check_result", "springs_result", "picture_info")
# Names that differ from those of C, of one call or of all.
NAMES = {"influence_count": "influences", "spine_count": "spine", "rig.skeleton": "template", "picture.pixels": "units"}
# What is not offered: files, which are not on a disk here; and what another member says.
HIDDEN = ("bind.style", "bind.hints", "bind.question_count", "bind.answers", "bind_result.questions", "bind_result.vertex_questions", "rig.edits",
          "rig.skeleton_character", "map.file", "animate.file", "animate.map", "transfer.map", "transfer.pairs")
_ARRAYS = {"uint8_t": "Uint8Array", "uint32_t": "Uint32Array", "int32_t": "Int32Array", "float": "Float32Array", "double": "Float64Array"}


def jobs_js_text(h: Headers) -> str:
    out = ["// SPDX-License-Identifier: MIT", f"// Options and results of a character's jobs: name, kind, member, what the kind needs. {GENERATOR}",
           'import { WORDS } from "./layouts.js";', "", "/** @type {Record<string, {struct: string, inner?: Record<string, string>, members: Record<string, any[]>}>} */", "export const OPTIONS = {"]
    for struct in h.structs:
        call = base(struct.name).removesuffix("_options")
        if struct.character and struct.name.endswith("_options") and call in CALLS:
            out += _table(camel(call, False), call, struct, h)
    out += ["};", "", "/** @type {Record<string, {struct: string, inner?: Record<string, string>, members: Record<string, any[]>}>} */", "export const RESULTS = {"]
    for struct in _results(h):
        out += _table(camel(short(struct.name), False), base(struct.name), struct, h)
    return "\n".join([*out, "};"]) + "\n"


def jobs_types_text(h: Headers) -> str:
    out = ["// SPDX-License-Identifier: MIT", f"// Types of options and results of a character's jobs; what is missing is 0, or the first word. {GENERATOR}",
           'import type { Progress } from "./index.js";', 'import type { CharacterFile } from "./character.js";', "",
           "// Tables for marshalling.js: name, kind, member, what the kind needs.",
           *(f"export declare const {table}: Record<string, {{ struct: any; inner?: any; members: Record<string, any[]> }}>;" for table in ("OPTIONS", "RESULTS")), ""]
    for struct in h.structs:
        call = base(struct.name).removesuffix("_options")
        if struct.character and struct.name.endswith("_options") and call in CALLS:
            values = _values(call, struct, h)
            out += _interface(CALLS[call], [(f"{_name(call, v)}?", _type(v, call, h), _said(v, h)) for v in values],
                              any(v.kind == "progress" for v in values_of(struct, h)))
    for struct in _results(h):
        name = base(struct.name)
        out += _interface(camel(name), [(_name(name, v), _type(v, name, h) + (" | null" if v.optional else ""), v.doc) for v in _values(name, struct, h)])
    return "\n".join(out).rstrip() + "\n"


def _results(h: Headers) -> List[Struct]:
    shown = {n for n in RESULTS}
    for struct in reversed(result_structs(h)):
        if base(struct.name) in shown:
            shown |= {base(v.of) for v in _values(base(struct.name), struct, h) if v.kind == "structs"}
    return [s for s in result_structs(h) if base(s.name) in shown]


def _values(call: str, struct: Struct, h: Headers) -> List[Value]:
    return [v for v in values_of(struct, h) if v.kind not in ("models", "threads", "progress") and f"{call}.{v.name}" not in HIDDEN]


def _name(call: str, v: Value) -> str:
    return NAMES.get(f"{call}.{v.name}") or NAMES.get(v.name) or camel(v.plain.replace("_q16", ""), False)


def _table(first: str, call: str, struct: Struct, h: Headers) -> List[str]:
    rows = []
    for v in _values(call, struct, h):
        kind, extra = "fraction" if v.name.endswith("_q16") else v.kind, ""
        if v.kind == "word":
            extra = f", WORDS.{camel(short(v.of), False)}"
        elif f"{call}.{v.name}" == "picture.pixels":
            kind, extra = "word", ', ["figure", "pixels"]'
        elif v.bit:
            kind, extra = "without", f", {v.bit}"
        elif f"{call}.{v.name}" == "rig.skeleton":
            kind = "template"
        elif v.kind in ("array", "structs"):
            of = _ARRAYS[v.of] if v.kind == "array" else f'"{camel(short(v.of), False)}"'
            extra = f", {of}, [" + ", ".join(f'"{c}"' for c in v.counts) + "]"
        elif v.kind in ("texts", "mapping", "lines"):
            extra = "".join(f', "{c}"' for c in v.counts[:2])
        elif v.optional and v.kind == "number":
            kind = "numberOrNull"
        rows.append(f'{_name(call, v)}: ["{kind}", "{v.member}"{extra}]')
    inner = {at: f'{at}: "{camel(short(of), False)}"' for v in _values(call, struct, h) for at, of in v.path}
    head = f'  {first}: {{ struct: "{camel(short(struct.name), False)}", ' + f"inner: {{ {', '.join(inner.values())} }}, " * bool(inner)
    return filled(head + "members: {", rows, " } },", indent="    ", width=130).split("\n")


def _type(v: Value, call: str, h: Headers) -> str:
    if v.kind == "word":
        return " | ".join(f'"{w}"' for n, e in h.enums if n == v.of for w in words_of(e) or [] if w)
    if f"{call}.{v.name}" == "picture.pixels":
        return '"figure" | "pixels"'
    result = "_" in call
    return {"flag": "boolean", "number": "number", "percent": "number", "text": "string" if result or v.name not in ("clip", "actor") else "string | number",
            "texts": "string[]", "array": _ARRAYS.get(v.of, "") if result else "ArrayLike<number>", "structs": f"{camel(base(v.of))}[]" if result else _rows(v, h), "character": "CharacterFile",
            "mapping": "Record<string, number>", "lines": "Float32Array[]" if result else "[number, number][][]",
            "numbers": "[" + ", ".join(["number"] * int(v.counts[0])) + "]" if v.kind == "numbers" else ""}[v.kind]


def _rows(v: Value, h: Headers) -> str:
    members = next((s.members for s in h.structs if s.name == v.of), [])
    return "{ " + "; ".join(f"{m.name}: number" for m in members) + " }[]"


def _said(v: Value, h: Headers) -> str:
    doc = v.doc
    if v.kind == "percent":
        doc = re.sub(r"\d+", lambda m: f"{int(m.group(0)) / 100:g}", doc)
    if v.kind == "word":
        first = next((words_of(e) or [""])[0] for n, e in h.enums if n == v.of)
        doc = re.sub(r"(^|; )0 = ", rf"\g<1>{first}: ", doc)
    return ("false: " if doc and v.bit else "") + doc


def _interface(name: str, fields: List[Tuple[str, str, str]], progress: bool = False) -> List[str]:
    out = [f"export interface {name} {{"]
    for field, kind, doc in fields:
        if doc:
            out += textwrap.wrap(f"/** {doc.replace('*/', '* /')} */", 136, initial_indent="  ", subsequent_indent="   * ", break_on_hyphens=False)
        out.append(f"  {field}: {kind};")
    return out + (["  onProgress?: Progress;"] if progress else []) + ["}"]
