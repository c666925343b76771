# SPDX-License-Identifier: MIT
"""samples/python."""
import re
from typing import List

from .headers import GENERATOR, Headers, Type, camel, filled, short, words_of

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
            out.append(filled(f"{short(name).upper()}: Dict[str, int] = {{", [f'"{k[6:]}": {v}' for k, v in enumerators.items()], "}"))
            continue
        real = [f'"{w}"' for w in words if w]
        out.append(filled(f"{camel(short(name))} = Literal[", real, "]"))
        out.append(filled(f"{short(name).upper()}: Tuple[str, ...] = (", [f'"{w}"' for w in words], ",)" if len(words) == 1 else ")"))
    out += ["", "# Callbacks."]
    for name, result, kinds in h.callbacks:
        out.append(f"{name} = CFUNCTYPE({', '.join([_ctype(result)] + [_ctype(k) for k in kinds])})")
    for struct in h.structs:
        fields = [f'("{m.name}", {_ctype(m.type)})' for m in struct.members]
        out += ["", "", f"class {struct.name}(Structure):", filled("    _fields_ = [", fields, "]", indent="        ")]
    for character, title in ((False, "STRUCTS"), (True, "CHARACTER_STRUCTS")):
        names = [s.name for s in h.structs if s.character == character]
        out += ["", "" if character else "\n", filled(f"{title}: Tuple[Any, ...] = (", names, ",)" if len(names) == 1 else ")")]
    for character, title in ((False, "FUNCTIONS"), (True, "CHARACTER_FUNCTIONS")):
        out += ["", "", f"# Result and arguments{' of sinew/character.h' if character else ''}.", f"{title}: Dict[str, Tuple[Any, List[Any]]] = {{"]
        for one in h.functions:
            if one.character == character:
                result = _ctype(one.result)
                out.append(filled(f'    "{one.name}": ({result}, [', [_ctype(p.type) for p in one.parameters], "]),", indent="        "))
        out.append("}")
    text = "\n".join(out) + "\n"
    known = {f"c_{n}" for n in ("char", "char_p", "double", "float", "int", "int8", "int16", "int32", "int64", "size_t", "uint8", "uint16",
                                "uint32", "uint64", "void_p")} | {"CFUNCTYPE", "POINTER", "Structure"}
    used = set(re.findall(r"\w+", text.split("c_void_p)\n", 1)[1])) & known
    names = sorted(used, key=lambda n: (n[0].islower(), n))
    head = filled("from ctypes import (", names, ")", indent=" " * 20)
    return re.sub(r"import sys\nfrom ctypes import \([^)]*\)\n(from typing[^\n]*)\n\nfrom typing import Literal\n",
                  lambda m: head + "\nfrom typing import Any, Dict, List, Literal, Tuple\n", text, 1)
