# SPDX-License-Identifier: MIT
"""samples/python: methods with keyword arguments and dataclasses of results."""
import re
import textwrap
from typing import Dict, List, Tuple

from .headers import GENERATOR, Headers, Struct, camel, filled, short, words_of
from .members import Job, Value, base, jobs_of, result_structs, values_of

# Names that differ from those of C, of one call or of all: methods, keywords, fields of results.
CALLS = {"animate": "retarget"}
NAMES = {"bind.influence_count": "influences", "rig.influence_count": "influences", "transfer.influence_count": "influences", "bind.question_count": "questions",
         "lod.level_count": "levels", "hinted": "hints", "rig.spine_count": "spine", "skeleton_character": "skeleton", "pins_file": "pins",
         "branches_first": "first", "branches_cost": "cost", "animate.range": "natural_range", "animate.deform": "correct", "from": "start", "to": "end", "map": "map_file",
         "sources": "joint_map", "pose.deform": "method", "bake.deform": "method", "transfer.target_up": "up", "picture.pixels": "units", "picture.mask": "mask_file",
         "animate_result.clip_count": "clips", "rig_result.front_confidence": "front_certainty", "rig_result.up_confidence": "up_certainty"}
# Types and defaults that are not those of their kind.
TYPES = {"retarget.correct": ("Correction", '"none"'), "bake.method": ("declarations.PoseDeform", '"volume"'), "rig.front": ("str", '"auto"'),
         "bind.hints": ("Any", "None"), "rig.edits": ("Sequence[Tuple[Any, ...]]", "()"), "rig.skeleton": ("Any", "None"), "map.pins": ("Any", "None")}
# What the hand-written code makes of a struct.
STRUCTS = {"sinew_question": "List[Question]", "sinew_character_left_out": "Dict[str, str]"}
MODELS = {"bind": ["model"], "transfer": ["model"]}
# Methods whose signatures are written by hand; their options are filled as the others' are.
# A file in place of the other character is that argument.
HIDDEN = ("map.file", "animate.file")
BY_HAND = ("set_profile", "simplify", "lod")


def results_text(h: Headers) -> str:
    out = ["# SPDX-License-Identifier: MIT", f'"""What jobs give back, and how keywords and results are members of C\'s structs. {GENERATOR}"""',
           "from __future__ import annotations", "", "from dataclasses import dataclass", "from typing import Any, Dict, List, Optional, Tuple", "",
           "from . import declarations", "from .binding import Array", "from .character import Question"]
    shown = [s for s in result_structs(h) if s.name not in STRUCTS]
    for struct in shown:
        out += _dataclass(struct, h)
    out += ["", "", "# A struct's keywords: name, kind, member, and what the kind needs.", "Rows = List[Tuple[str, str, str, Any]]", "OPTIONS: Dict[Any, Rows] = {"]
    for struct in h.structs:
        if struct.character and struct.name.endswith("_options"):
            out += _table(f"declarations.{struct.name}: [", base(struct.name)[:-len("_options")], struct, h, "],")
    out += ["}", "# The class of a struct, and its fields.", "RESULTS: Dict[Any, Tuple[Any, Rows]] = {"]
    for struct in shown:
        out += _table(f"declarations.{struct.name}: ({_class(struct.name)}, [", base(struct.name), struct, h, "]),")
    out += ["}", "# Options, result, the other character, whether that comes first, and the member of a file in its place.", "JOBS: Dict[str, Tuple[Any, Any, str, bool, str]] = {"]
    for job in jobs_of(h):
        result = f"declarations.{job.result}" if job.result.startswith("sinew_") else "None"
        out.append(f'    "{job.name}": (declarations.{job.options.name}, {result}, "{job.source}", {job.source_first}, "{job.source_file}"),')
    return "\n".join([*out, "}"]) + "\n"


def jobs_text(h: Headers) -> str:
    out = ["# SPDX-License-Identifier: MIT", f'"""The command\'s jobs as methods of a character. {GENERATOR}"""', "from __future__ import annotations", "",
           "from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Tuple, cast", "", "from . import declarations", "from .binder import ProgressFunction",
           "from .marshalling import Correction, ModelFile, Source, Text, run"]
    jobs = [j for j in jobs_of(h) if j.name not in BY_HAND]
    out += [filled("from .results import ", sorted(_class(j.result) for j in jobs if j.result.startswith("sinew_")), ""), "", "if TYPE_CHECKING:",
            "    from .opened import OpenCharacter", "", "", "class Jobs:",
            '    """What the command does with a character, with its defaults. All of them raise ValueError for arguments, Error for what cannot be done and',
            "    Cancelled; a failed call changes nothing. `progress` is called with the share that is done and returns True to stop; `threads` work, and the",
            '    bytes are the same for any number."""']
    for job in jobs:
        out += _method(job, h)
    return "\n".join(out) + "\n"


def _table(first: str, call: str, struct: Struct, h: Headers, last: str) -> List[str]:
    rows = [_row(call, v) for v in values_of(struct, h) if v.kind not in ("models", "threads", "progress") and f"{call}.{v.name}" not in HIDDEN]
    return filled(f"    {first}", rows, last, indent="        ").split("\n")


def _name(call: str, value: Value) -> str:
    return NAMES.get(f"{call}.{value.name}") or (NAMES.get(value.name) if "_" not in call or call == "picture" else None) or value.plain.replace("_q16", "")


def _class(struct: str) -> str:
    return camel(base(struct))


def _row(call: str, v: Value) -> str:
    """What marshalling.py reads."""
    extra = {"word": lambda: f"declarations.{short(v.of).upper()}", "without": lambda: str(v.bit), "array": lambda: repr((v.of[:-2] if v.of.endswith("_t") else
             {"float": "float32", "double": "float64"}[v.of], tuple(v.counts), v.optional, "a bone end" in v.doc)), "structs": lambda: f"(declarations.{v.of}, {tuple(v.counts)!r})",
             "lines": lambda: repr(tuple(v.counts)), "mapping": lambda: repr(tuple(v.counts)), "texts": lambda: repr(tuple(v.counts)), "number": lambda: repr(v.optional)}
    kind = "fraction" if v.name.endswith("_q16") else "without" if v.bit else v.kind
    return f'("{_name(call, v)}", "{kind}", "{v.member}", {extra.get(kind, lambda: "None")()})'


def _type(v: Value, call: str, name: str, h: Headers) -> Tuple[str, str]:
    """Type and default of a keyword."""
    if f"{call}.{name}" in TYPES:
        return TYPES[f"{call}.{name}"]
    if v.kind == "word":
        words = next(words_of(e) or [] for n, e in h.enums if n == v.of)
        return f"declarations.{camel(short(v.of))}", f'"{words[0]}"'
    if v.kind == "structs":
        members = [m for m in values_of(next(s for s in h.structs if s.name == v.of), h) if m.kind in ("word", "text", "number")]
        each = ", ".join({"word": f"declarations.{camel(short(m.of))}", "text": "str"}.get(m.kind, "int") for m in members)
        return f"Sequence[Tuple[{each}]]" if v.of != "sinew_answer" else "Sequence[Tuple[Any, ...]]", "()"
    real = v.of in ("float", "double")
    return {"flag": ("bool", str(bool(v.bit))), "number": ("float" if real else "int", "0"), "percent": ("float", "1"), "text": ("Text", "None"),
            "texts": ("Sequence[str]", "()"), "array": ("Any", "None"), "character": ('Optional["OpenCharacter"]', "None"),
            "mapping": ("Optional[Mapping[str, float]]", "None")}[v.kind]


def _method(job: Job, h: Headers) -> List[str]:
    call = CALLS.get(job.name, job.name)
    keywords: Dict[str, Tuple[str, str]] = {}
    docs: Dict[str, str] = {}
    values = [v for v in values_of(job.options, h) if f"{job.name}.{v.name}" not in HIDDEN]
    for v in values:
        name = _name(job.name, v)
        if v.name == "joint_flags":
            keywords.update(deform=("Any", "None"), never=("Any", "None"))
            docs["deform, never"] = "joints, by name or number, that alone get weight, or none"
        elif v.kind not in ("models", "threads", "progress"):
            keywords.setdefault(name, _type(v, call, name, h))
            docs[name] = "; or ".join(d for d in (docs.get(name), _said(v, h)) if d)
    kinds = {v.kind for v in values}
    if "models" in kinds:
        models = MODELS.get(job.name, ["model", "hands_model", "front_model"])
        keywords.update({m: ("ModelFile", "None") for m in models})
        docs[", ".join(models)] = "files or bytes in place of the bundled ones"
    keywords.update({n: t for n, t in (("threads", ("int", "1")), ("progress", ("ProgressFunction", "None"))) if n in kinds})
    first = [f"{job.source}: " + ("Source" if job.source_file else '"OpenCharacter"') + " = None" * job.source_optional] * bool(job.source)
    result = {"": "None", "character": '"OpenCharacter"'}.get(job.result) or _class(job.result)
    call_text = f'run("{job.name}", locals())'
    if result != "None":
        call_text = f"return cast({result}, {call_text})"
    head = f"    def {call}("
    signature = filled(head, ["self", *first, "*", *(f"{n}: {t} = {d}" for n, (t, d) in keywords.items())], f") -> {result}:", indent=" " * len(head))
    return ["", *signature.split("\n"), *_docstring(job.doc, docs, "        "), f'        {call_text}']


def _said(v: Value, h: Headers) -> str:
    doc = v.doc
    if v.kind == "percent":
        doc = re.sub(r"\d+", lambda m: f"{int(m.group(0)) / 100:g}", doc)
    if v.kind == "word":
        words = next(words_of(e) or [] for n, e in h.enums if n == v.of)
        doc = re.sub(r"^0 = ", f'"{words[0]}": ', doc.replace("; 0 = ", f'; "{words[0]}": '))
    if v.kind == "array":
        mask = v.of == "uint8_t"
        doc = ("mask [n] of bool or uint8, or indices: " if mask else f"[{', '.join(v.counts).lower()}] ") + doc.replace("not 0: ", "")
    return ("False: " if doc and v.bit else "") + doc


def _dataclass(struct: Struct, h: Headers) -> List[str]:
    fields, docs = [], {}
    for v in values_of(struct, h):
        name = _name(base(struct.name), v)
        kind = {"flag": "bool", "word": f"declarations.{camel(short(v.of))}", "number": "float" if v.of in ("float", "double") or v.name.endswith("_q16") else "int",
                "text": "str", "texts": "List[str]", "array": "Array", "lines": "List[Array]", "structs": STRUCTS.get(v.of) or f"List[{_class(v.of)}]",
                "numbers": f"Tuple[{'float' if v.of == 'float' else 'int'}, ...]"}[v.kind]
        if name == "first_clip":
            continue
        if name == "clips":  # from first_clip on
            kind = "range"
        fields.append(f"    {name}: " + (f"Optional[{kind}]" if v.optional and v.kind in ("array", "number") else kind))
        docs[name] = v.doc
    return ["", "", "@dataclass", f"class {_class(struct.name)}:", *_docstring(f"{struct.name} of C.", docs, "    "), "", *fields]


def _docstring(first: str, docs: Dict[str, str], indent: str) -> List[str]:
    text = [f'"""{first}']
    shown = {n: d for n, d in docs.items() if d}
    if shown:
        text.append("")
    for name, doc in shown.items():
        text.append(f"{name}  {doc}")
    lines = []
    for i, line in enumerate(text):
        line = re.sub(r"sinew_character_(\w+)\(\)", r"\1()", line).replace("animate()", "retarget()").replace("SINEW_ERROR_INPUT", "an Error")
        line = re.sub(r"\bnull\b", "None", line.replace("SINEW_", ""))
        lines += textwrap.wrap(line, 138 - len(indent), initial_indent=indent, subsequent_indent=indent + ("    " if i else ""), break_on_hyphens=False) or [""]
    return [*lines, indent + '"""'] if len(lines) > 1 else [lines[0] + '"""']
