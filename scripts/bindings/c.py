# SPDX-License-Identifier: MIT
"""The table of struct sizes that libraries answer with."""
from .headers import CHARACTER, ENGINE, GENERATOR, Headers


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
