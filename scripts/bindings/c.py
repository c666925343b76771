# SPDX-License-Identifier: MIT
"""The table of struct sizes that libraries answer with, and the words of enumerations for the command."""
from .headers import CHARACTER, ENGINE, GENERATOR, Headers, camel, filled, short, words_of

# Enumerations that the command has as options.
COMMAND_WORDS = ("animate_method", "branches_cost", "branches_first", "category", "character_detail", "character_rig_method", "map_method",
                 "rigid_parts", "tet_weights", "transfer_method")


def words_text(h: Headers) -> str:
    out = ["// SPDX-License-Identifier: MIT", f"// Words of enumerations of C by number, for options. {GENERATOR}", "#ifndef SINEW_CLI_ENUM_WORDS_HPP",
           "#define SINEW_CLI_ENUM_WORDS_HPP", "", "#include <string>", "#include <vector>", "", "namespace sinew::cli {", "", "using Words = std::vector<std::string>;", ""]
    for name, enumerators in h.enums:
        if short(name) in COMMAND_WORDS:
            items = ", ".join(f'"{w}"' for w in words_of(enumerators) or [])
            out.append(f"inline const Words k{camel(short(name))} = {{{items}}};")
    return "\n".join(out + ["", "}  // namespace sinew::cli", "#endif"]) + "\n"


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
