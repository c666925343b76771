# SPDX-License-Identifier: MIT
"""samples/csharp."""
from .headers import GENERATOR, Headers, Member, Type, camel, filled, short, words_of

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
            out.append(filled(f"    public enum {camel(short(name))} {{ ", items, " }", indent="        "))
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
                out.append(filled(f"            public {line_type}", names, ";", indent="                "))
                names = []
            line_type = kind
            names += [f"{member.name}_{i}" for i in range(member.type.count)] or [_csharp_name(member.name)]
        out.append("        }")
    for one in h.functions:
        where = "CharacterLibrary" if one.character else "Library"
        out += ["", f"        [DllImport({where}, CallingConvention = CallingConvention.Cdecl)]",
                filled(f"        public static extern {_csharp_type(one.result)} {one.name}(", [_csharp_parameter(p) for p in one.parameters], ");",
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
