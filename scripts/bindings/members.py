# SPDX-License-Identifier: MIT
"""What the members of options and results mean, by their types and comments.

    1: ...                    a flag
    Bits of sinew_without. SINEW_WITHOUT_NAME ...  a flag for each bit, which is on where the bit is 0
    sinew_NAME: ...           a word of that enumeration
    [name_count] ...          an array with as many elements; [J x 3], [V]: of the character's joints, of its vertices
    [offsets[line_count] x 2] lines of so many numbers a point, whose offsets are in another member
    a pointer to a struct     its members, as if they were here; where the comment names some, these alone. What is before a colon
                              in it is said of each. `method` has the struct's name, `up` begins with it
"""
import re
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Tuple

from .headers import Function, Headers, Member, Struct, words_of

# Characters in and out, and what a call does with them, are no options.
_NONE = ("struct_size", "reserved", "progress_user")


@dataclass
class Value:
    """`name`: unique; `member`: where it is, deform.cells for a member of what the member deform points to. kind: flag, word, number, percent,
    text, texts, array, numbers (an array inside of the struct), structs, character, models, threads, progress, lines (`counts`: the offsets),
    mapping (`counts`: the names of its numbers). `of`: the enum, the struct, the type of C.
    `bit`: of a flag that is one of sinew_without, else 0. `path`: member and struct of each pointer on the way."""

    name: str
    kind: str
    doc: str
    of: str = ""
    counts: List[str] = field(default_factory=list)
    optional: bool = False
    member: str = ""
    bit: int = 0
    path: List[Tuple[str, str]] = field(default_factory=list)

    @property
    def plain(self) -> str:
        """The name without what only C needs: softness for softness_percent."""
        return self.name[:-len("_percent")] if self.kind == "percent" else self.name


@dataclass
class Job:
    """A call that takes options. `source`: the other character's name in C, or none; `result`: a struct, "character" or ""."""

    name: str
    function: Function
    options: Struct
    source: str
    source_first: bool
    source_optional: bool
    source_file: str  # the member of a file in its place, or ""
    result: str
    doc: str


def values_of(struct: Struct, headers: Headers) -> List[Value]:
    """The members that a caller sees, in their order."""
    enums = {name: words_of(e) for name, e in headers.enums}
    words = {enumerator: f'"{(words_of(e) or [])[v]}"' for _, e in headers.enums if words_of(e) for enumerator, v in e.items()}
    pairs = [(m, _counts(m)) for m in struct.members]
    counted = {counts[0] for m, counts in pairs if len(counts) == 1 or (counts and "[" in counts[0])}
    counted |= {count for m, counts in pairs for c in counts for count in re.findall(r"\w+(?=\[)|(?<=\[)\w+", c)}
    letters = {m.comment[0]: m.name for m in struct.members if re.match(r"[A-Z]\b", m.comment)}
    out: List[Value] = []
    nested: List[Value] = []
    for member, counts in pairs:
        if member.name in _NONE or (member.name in counted and member.type.name == "uint32_t"):
            continue
        if member.name == "without":
            out += _without(member, headers)
            continue
        if member.type.kind == "struct" and member.type.depth == 1 and not counts and not member.name == "models":
            nested += _nested(member, headers)
            continue
        value = _value(member, [letters.get(c, c) for c in counts], enums)
        value.member = member.name
        value.doc = re.sub(r"\bSINEW_\w+", lambda m: words.get(m.group(0), m.group(0)[6:]), value.doc)
        before = out[-1] if out else None
        if before is not None and before.kind == "texts" and value.kind == "array" and before.counts == value.counts:
            out[-1] = Value(value.name, "mapping", before.doc, value.of, [before.name, *value.counts], member=value.name)
        else:
            out.append(value)
    return out + nested


def _without(member: Member, headers: Headers) -> List[Value]:
    """A flag for each bit in the comment."""
    bits = next(e for n, e in headers.enums if n == "sinew_without")
    return [Value(bit[len("SINEW_WITHOUT_"):].lower(), "flag", doc, member="without", bit=bits[bit])
            for bit, doc in re.findall(r"(SINEW_WITHOUT_\w+) (.*?)(?= SINEW_WITHOUT|$)", member.comment)]


def _nested(member: Member, headers: Headers) -> List[Value]:
    """The members of what a member points to."""
    struct = next(s for s in headers.structs if s.name == member.type.name)
    named = {m.name for m in struct.members} & set(re.findall(r"\w+", member.comment))
    said = re.match(r"([^.:]+): ", member.comment)
    out = []
    for value in values_of(struct, headers):
        if value.kind in ("threads", "progress", "models") or (named and value.name not in named):
            continue
        value.path = [(member.name, struct.name), *value.path]
        value.member = f"{member.name}.{value.member}"
        value.counts = value.counts if value.kind == "array" else [f"{member.name}.{c}" for c in value.counts]
        value.doc = f"{said.group(1)[0].lower()}{said.group(1)[1:]}: {value.doc}" if said and value.doc else value.doc
        value.name = {"method": member.name, "up": f"{member.name}_up"}.get(value.name, value.name)
        out.append(value)
    return out


def _counts(member: Member) -> List[str]:
    dims = re.match(r"\[((?:[^\[\]]|\[\w+\])*)\]", member.comment)
    return dims.group(1).split(" x ") if dims and member.type.depth else []


def _value(member: Member, counts: List[str], enums: Dict[str, Optional[List[str]]]) -> Value:
    one, text = member.type, member.comment
    doc, optional = _doc(text), "null" in text or "-1 if" in text
    if one.kind == "function":
        return Value(member.name, "progress", doc)
    if one.kind == "opaque":
        return Value(member.name, "character", doc)
    if one.kind == "struct":
        return Value(member.name, "models" if not counts else "structs", doc, one.name, counts)
    if one.depth and one.name == "char":
        return Value(member.name, "text" if one.depth == 1 else "texts", doc, "", counts, optional)
    if one.depth:
        offsets = re.match(r"(\w+)\[(\w+)\]", counts[0])
        if offsets:
            return Value(member.name, "lines", doc, one.name, [*offsets.groups(), *counts[1:]], optional)
        return Value(member.name, "array", doc, one.name, counts, optional and counts[0] in ("J", "V"))
    if one.count:
        return Value(member.name, "numbers", doc, one.name, [str(one.count)])
    enum = next((e for e in re.findall(r"\bsinew_\w+", text) if enums.get(e)), "")
    if enum and one.name == "uint32_t":
        return Value(member.name, "word", doc, enum)
    if member.name == "thread_count":
        return Value(member.name, "threads", doc)
    if re.search(r"(^|[:;] )1: ", text):
        return Value(member.name, "flag", doc, one.name)
    return Value(member.name, "percent" if member.name.endswith("_percent") else "number", doc, one.name, [], optional)


def _doc(text: str) -> str:
    """The comment without what its type says in other languages."""
    text = re.sub(r"^\[(?:[^\[\]]|\[\w+\])*\]\s*", "", text)
    text = re.sub(r"^sinew_\w+[;:,]?\s*", "", text.removesuffix("."))
    text = re.sub(r"(^|[:;] )1: ", r"\1", text)
    text = re.sub(r"sinew_character_(\w+?)(_options\b|\(\))", r"\1()", text)
    text = re.sub(r"\bsinew_character_(?=\w)", "", text)
    text = re.sub(r"[;,]? ?or null$", "", text).strip("; ")
    return re.sub(r"^(A |[A-Z][a-z])", lambda m: m.group(1).lower(), text)


def jobs_of(headers: Headers) -> List[Job]:
    """The calls of sinew/character.h that take a character and options."""
    structs = {s.name: s for s in headers.structs}
    out = []
    for function in headers.functions:
        types = [p.type for p in function.parameters]
        options = next((t.name for t in types if t.kind == "struct" and t.name.endswith("_options")), None)
        characters = [p.name for p in function.parameters if p.type.kind == "opaque" and p.type.depth == 1]
        if not function.character or options is None or not characters:
            continue
        own = "target" if "target" in characters else characters[0]
        source = next((c for c in characters if c != own), "")
        last = types[-1]
        result = last.name if last.kind == "struct" and last.name.endswith("_result") else "character" if last.kind == "opaque" and last.depth == 2 else ""
        doc = re.split(r"\n {2,}|\s*\bReturns SINEW_", function.comment)[0].replace("\n", " ")
        optional = bool(source) and re.search(rf"\n\s+{source}  null: ", function.comment) is not None
        out.append(Job(function.name[len("sinew_character_"):], function, structs[options], source, bool(source) and characters[0] == source, optional,
                       next((v.member for v in values_of(structs[options], headers) if v.name == "file"), ""), result, doc))
    return out


def result_structs(headers: Headers) -> List[Struct]:
    """Structs that calls give back, those in them first."""
    structs = {s.name: s for s in headers.structs}
    out: List[Struct] = []

    def add(struct: Struct) -> None:
        for value in values_of(struct, headers):
            if value.kind == "structs":
                add(structs[value.of])
        if struct not in out:
            out.append(struct)

    for struct in headers.structs:
        if struct.character and re.search(r"_(result|info|lod_level)$", struct.name):
            add(struct)
    return out


def base(name: str) -> str:
    """sinew_character_bind_result: bind_result."""
    return re.sub(r"^sinew_(character_)?", "", name)
