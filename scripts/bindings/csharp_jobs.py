# SPDX-License-Identifier: MIT
"""samples/csharp: settings and results as classes, and the calls of Character that take them."""
import re
import textwrap
from html import escape
from typing import List

from .headers import GENERATOR, Headers, Struct, camel, filled, short
from .members import Job, Value, base, jobs_of, result_structs, values_of

SETTINGS = {"bind": "CharacterBindSettings", "rig": "CharacterRigSettings", "map": "CharacterMapSettings", "transfer": "CharacterTransferSettings"}
RESULTS = {"bind_result": "CharacterBindResult", "rig_result": "CharacterRigResult", "map_result": "CharacterMap", "transfer_result": "CharacterTransferResult",
           "doubt": "LimbDoubt", "left_out": "LeftOutJoint"}
NAMES = {"influence_count": "Influences", "branches_first": "First", "branches_cost": "Cost"}
MODELS = {"bind": "Model, null, null, null, null", "transfer": "Model, null, null, null, null", "animate": "null, Model, HandsModel, null, FrontModel",
          "rig": "null, Method == CharacterRigMethod.Slots ? null : Model, HandsModel, Method == CharacterRigMethod.Slots ? Model : null, FrontModel"}
# What C# does not offer, and calls whose arguments are written by hand.
HIDDEN = ("bind.question_count", "bind.answers", "bind_result.questions", "bind_result.vertex_questions", "rig.edits", "map.file", "animate.file")
BY_HAND = ("simplify", "lod")
_NUMBERS = {"float": "float", "double": "double", "uint64_t": "ulong", "size_t": "long", "uint8_t": "byte"}
_READERS = {"byte": "Bytes", "float": "Floats", "double": "Doubles", "int": "Ints"}


def csharp_jobs_text(h: Headers) -> str:
    out = ["// SPDX-License-Identifier: MIT", f"// Settings and results of a character's jobs, and the jobs. {GENERATOR}", "using System;", "using System.Collections.Generic;",
           "using System.Linq;", "", "namespace Sinew", "{"]
    jobs = [j for j in jobs_of(h) if j.name not in BY_HAND]
    for struct in h.structs:
        if struct.character and struct.name.endswith("_options") and _call(struct) not in BY_HAND:
            out += _settings(struct, h) + [""]
    for struct in result_structs(h):
        if base(struct.name) not in ("lod_level", "question"):
            out += _result(struct, h) + [""]
    out += ["    public sealed partial class Character", "    {"]
    for job in jobs:
        out += _method(job, h) + [""]
    return "\n".join([*out[:-1], "    }", "}"]) + "\n"


def _call(struct: Struct) -> str:
    return base(struct.name).removesuffix("_options")


def _values(call: str, struct: Struct, h: Headers) -> List[Value]:
    return [v for v in values_of(struct, h) if f"{call}.{v.name}" not in HIDDEN]


def _name(v: Value) -> str:
    return NAMES.get(v.name) or camel(v.name.replace("_q16", ""))


def _class(struct: str) -> str:
    return RESULTS.get(base(struct)) or camel(base(struct))


def _settings_class(call: str) -> str:
    return SETTINGS.get(call) or camel(call) + "Settings"


def _number(of: str) -> str:
    return _NUMBERS.get(of, "int")


def _type(v: Value) -> str:
    return {"flag": "bool", "word": camel(short(v.of)), "percent": "int", "text": "string", "texts": "string[]", "array": f"{_number(v.of)}[]",
            "numbers": f"{_number(v.of)}[]", "mapping": "Dictionary<string, double>", "lines": "float[][]", "character": "Character"}.get(v.kind) or (
        ("double" if v.name.endswith("_q16") else _number(v.of) + "?" * v.optional) if v.kind == "number" else f"{_class(v.of)}[]")


def _fields(values: List[Value], settings: bool) -> List[str]:
    out = []
    for v in values:
        if v.kind in ("threads", "progress", "models"):
            continue
        doc = v.doc.replace("null = ", "null: ") + ("; or null" if settings and v.kind in ("array", "character") else "")
        if doc:
            out += textwrap.wrap(f"/// <summary>{escape(doc[0].upper() + doc[1:], quote=False)}</summary>", 140, initial_indent="        ", subsequent_indent="        /// ", break_on_hyphens=False)
        kind = f"Native.{v.of}[]" if settings and v.kind == "structs" else _type(v)
        out.append(f"        public {kind} {_name(v)}{' = true' * bool(v.bit)};")
    return out


def _settings(struct: Struct, h: Headers) -> List[str]:
    call = _call(struct)
    values, name = _values(call, struct, h), _settings_class(call)
    kinds = {v.kind for v in values}
    shared = {"threads", "progress"} <= kinds
    out = [f"    /// <summary>{struct.name} of C; what is not set is its default.</summary>", f"    public sealed class {name}" + (" : JobSettings" if shared else ""), "    {"]
    out += _fields(values, True)
    if not shared:
        out += ["        public int Threads = 1;"] * ("threads" in kinds) + ["        public Func<float, bool> Progress;"] * ("progress" in kinds)
    if "models" in kinds:
        models = "Model" if "HandsModel" not in MODELS[call] else "Model, HandsModel, FrontModel"
        out += ["        /// <summary>Bytes of .sinew files in place of the bundled models; or null.</summary>", f"        public byte[] {models};"]
    before: List[str] = []
    items = {("", struct.name): [f"struct_size = Character.Size<Native.{struct.name}>()"]}  # of it, and of what it points to
    for v in values:
        if v.kind == "array":
            size = " * ".join({"J": "sizes.joint_count", "V": "sizes.vertex_count"}.get(c, c) for c in v.counts)
            before.append(f'            Character.Length({_name(v)}, {size}, "{name}.{_name(v)}: expected [{" x ".join(v.counts)}] numbers");')
        at = v.path[0] if v.path else ("", struct.name)
        assigned = _assigned(v, call, before)
        row = items.setdefault(at, [f"struct_size = Character.Size<Native.{at[1]}>()"])
        if v.bit and row[-1].startswith("without = "):
            row[-1] += assigned[0].replace("without =", " |")
        else:
            row += assigned
    own = items.pop(("", struct.name))
    for (member, inner), row in items.items():
        before += filled(f"            var {member} = new Native.{inner} {{", row, " };", indent=" " * 16).split("\n")
        own.append(f"{member} = pins.Of({member})")
    out += ["", "        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)", "        {", *before]
    return out + filled(f"            return pins.Of(new Native.{struct.name} {{", own, " });", indent=" " * 16).split("\n") + ["        }", "    }"]


def _assigned(v: Value, call: str, before: List[str]) -> List[str]:
    member, name = v.member.split(".")[-1], _name(v)
    if v.kind == "models":
        return [f"models = Character.Models(pins, {MODELS[call]})"]
    if v.kind == "threads":
        return ["thread_count = (uint)Threads"]
    if v.kind == "progress":
        return ["progress = watch.Callback"]
    if v.kind == "texts" or v.kind == "structs":
        return [f"{v.counts[0]} = Character.Count({name})", f"{member} = pins.Of({'(object)' if v.kind == 'structs' else ''}{name})"]
    if v.kind == "mapping":
        before.append(f"            string[] rules = {name} == null ? null : {name}.Keys.ToArray();")
        return [f"{v.counts[1]} = Character.Count(rules)", f"{v.counts[0]} = pins.Of(rules)", f"{member} = pins.Of({name} == null ? null : {name}.Values.ToArray())"]
    if v.kind == "lines":
        before.append(f"            var ends = new List<uint> {{ 0 }};")
        before.append(f"            foreach (float[] line in {name} ?? new float[0][]) ends.Add(ends[ends.Count - 1] + (uint)line.Length / {v.counts[2]});")
        return [f"{v.counts[1]} = Character.Count({name})", f"{v.counts[0]} = {name} == null ? IntPtr.Zero : pins.Of(ends.ToArray())",
                f"{member} = {name} == null ? IntPtr.Zero : pins.Of({name}.SelectMany(line => line).ToArray())"]
    if v.bit:
        return [f"without = ({name} ? 0 : Native.WITHOUT_{v.name.upper()})"]
    value = {"flag": f"{name} ? 1u : 0", "text": f"pins.Of({name})", "array": f"pins.Of({name})", "character": f"{name} == null ? IntPtr.Zero : {name}.Handle"}.get(v.kind)
    return [f"{member} = {value or (name if v.kind == 'number' and v.of in ('double', 'float', 'uint64_t') else f'(uint){name}')}"]


def _result(struct: Struct, h: Headers) -> List[str]:
    call, name = base(struct.name), _class(struct.name)
    values = _values(call, struct, h)
    out = [f"    /// <summary>{struct.name} of C.</summary>", f"    public sealed class {name}", "    {", *_fields(values, False), ""]
    if struct.members[0].name == "struct_size":
        out += ["        internal static IntPtr Room(Pins pins)", "        {",
                f"            return pins.Of(new Native.{struct.name} {{ struct_size = Character.Size<Native.{struct.name}>() }});", "        }", ""]
    out += [f"        internal static {name} Of(IntPtr at, Native.sinew_character_arrays sizes)", "        {", f"            var r = Character.Read<Native.{struct.name}>(at);"]
    return out + filled(f"            return new {name} {{", [f"{_name(v)} = {_read(v)}" for v in values], " };", indent=" " * 16).split("\n") + ["        }", "    }"]


def _read(v: Value) -> str:
    at = f"r.{v.name}"
    count = " * ".join({"J": "sizes.joint_count", "V": "sizes.vertex_count"}.get(c, c if c.isdigit() else f"r.{c}") for c in v.counts)
    if v.kind == "number":
        if v.name.endswith("_q16"):
            return f"{at} / 65536.0"
        if v.optional:
            return f"{at} < 0 ? ({_type(v)})null : {at}"
        return at if v.of in ("float", "double", "int32_t") else f"({_type(v)}){at}"
    if v.kind == "numbers":
        return f"new[] {{ {', '.join(('' if v.of == 'float' else '(int)') + f'{at}_{i}' for i in range(int(v.counts[0])))} }}"
    return {"flag": lambda: f"{at} != 0", "word": lambda: f"({_type(v)}){at}", "text": lambda: f"Character.Text({at})",
            "array": lambda: f"Character.{_READERS[_number(v.of)]}({at}, {count})", "structs": lambda: f"Character.Structs<Native.{v.of}, {_class(v.of)}>({at}, {count}, sizes, {_class(v.of)}.Of)",
            "lines": lambda: f"Character.Lines({at}, r.{v.counts[0]}, r.{v.counts[1]})"}[v.kind]()


def _method(job: Job, h: Headers) -> List[str]:
    settings, name = _settings_class(_call(job.options)), camel(job.name)
    kinds = {v.kind for v in values_of(job.options, h)}
    result = {"": "void", "character": "Character"}.get(job.result) or _class(job.result)
    doc = re.sub(r"sinew_(?:character_)?(\w+)\(\)", lambda m: camel(m.group(1)) + "()", job.doc).replace("SINEW_ERROR_INPUT", "an error")
    source = f"Character {job.source}, " if job.source else ""
    default = " = null" if result != "void" and job.name != "pose" else ""
    handle = f"{job.source} == null ? IntPtr.Zero : {job.source}.Handle" if job.source_optional else f"{job.source}.Handle"
    characters = ([handle, "Handle"] if job.source_first else ["Handle", handle]) if job.source else ["Handle"]
    last = {"void": [], "Character": ["out posed"]}.get(result, ["result"])
    call = ", ".join([*characters, "settings.Options(pins, watch, Arrays())", *last])
    out = textwrap.wrap(f"/// <summary>{escape(doc, quote=False)}</summary>", 140, initial_indent="        ", subsequent_indent="        /// ", break_on_hyphens=False)
    out += [f"        public {result} {name}({source}{settings} settings{default})", "        {"]
    out += [f"            settings = settings ?? new {settings}();"] * bool(default)
    out += ["            IntPtr posed;"] * (result == "Character")
    out += ["            using (var pins = new Pins())", "            {", f"                var watch = new Watch({'settings.Progress' if 'progress' in kinds else 'null'});"]
    out += [f"                IntPtr result = {result}.Room(pins);"] * ("result" in last)
    out += [f"                Check(Native.{job.function.name}({call}), handle_, \"{job.name}\", watch);", "                GC.KeepAlive(settings);"]
    out += [f"                GC.KeepAlive({job.source});"] * bool(job.source)
    out += {"void": [], "Character": ["                return new Character(posed);"]}.get(result, [f"                return {result}.Of(result, Arrays());"])
    return out + ["            }", "        }"]
