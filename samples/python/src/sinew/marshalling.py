# SPDX-License-Identifier: MIT
"""Keyword arguments as structs of C, structs as results, by the tables of results.py; and the calls of jobs.py."""
from __future__ import annotations

import ctypes
import os
from pathlib import Path
from typing import Any, Callable, Dict, List, Literal, Mapping, Sequence, Tuple, Union, cast

import numpy as np

from . import binding, declarations, results
from .arrays import chosen, mask, real, whole
from .binding import Array
from .binder import answers_of, joint_flags, question_of

Text = Union[None, str, int, "os.PathLike[str]"]  # a name, a number of one, a file
Source = Union[str, "os.PathLike[str]", Any]
ModelFile = Union[None, str, "os.PathLike[str]", bytes]
Correction = Literal["none", "volume", "xpbd", "delta-mush"]


def run(job: str, given: Dict[str, Any]) -> Any:
    """The call of a job. `given`: the arguments of its method, self among them."""
    options_of, result_of, source, source_first, file = results.JOBS[job]
    one, library = given["self"], binding.character_library()
    other, call = given.get(source), getattr(library, f"sinew_character_{job}")
    named = isinstance(other, (str, os.PathLike))
    others: List[Any] = [None if named or other is None else other.pointer] if source else []
    characters = [*others, one.pointer] if source_first else [one.pointer, *others]
    view, skeleton = one._view(), one.skeleton
    options, _kept = filled(options_of, given, one)
    if named:
        setattr(*_home(options, file), os.fsencode(cast(Any, other)))
    models = _Models(**{_model_member(n, given): given[n] for n in ("model", "hands_model", "front_model") if given.get(n) is not None})
    if models.any:
        options.models = ctypes.pointer(models.struct)
    if "threads" in given:
        if not 1 <= given["threads"] <= declarations.MAX_THREADS:
            raise ValueError(f"threads: expected 1 to {declarations.MAX_THREADS}, found {given['threads']}")
        options.thread_count = given["threads"]
    posed = ctypes.c_void_p()
    out = [ctypes.byref(posed)] if job == "pose" else []
    result = None if result_of is None else binding.init(result_of)
    with binding.Progress(given.get("progress")) as report:
        if "progress" in given:
            options.progress = report.callback
        status = call(*characters, ctypes.byref(options), *out, *([] if result is None else [ctypes.byref(result)]))
        line = error_line(one) if status else ""
    report.finish(status, job, line)
    if out:
        return type(one)(posed)
    return None if result is None else result_as(result, {"V": view.vertex_count, "J": one._view().joint_count}, [] if skeleton is None else skeleton.names)


def filled(struct: type, given: Mapping[str, Any], one: Any = None) -> Tuple[Any, List[Any]]:
    """A struct of options, and what it points to. Several members may have one keyword: what is given says which."""
    options, kept = binding.init(struct), []
    for keyword, kind, member, extra in results.OPTIONS[struct]:
        if member == "joint_flags":
            if given.get("deform") is not None or given.get("never") is not None:
                kept.append(joint_flags(one.skeleton, given.get("deform"), given.get("never")))
                options.joint_flags = kept[-1].ctypes.data
            continue
        value = given.get(keyword)
        named, character = isinstance(value, (str, os.PathLike)), hasattr(value, "pointer")
        if value is None or character != (kind == "character") or (named and kind in ("array", "structs")) or (kind == "text" and not named and not isinstance(value, int)):
            continue
        kept += _SETTERS[kind](*_home(options, member), value, extra, keyword, given, one)
    return options, kept


def _home(options: Any, member: str) -> Tuple[Any, str]:
    """The struct that has a member, deform.cells for one of what options.deform points to, and the member's own name."""
    *path, name = member.split(".")
    for one in path:
        if not getattr(options, one):
            setattr(options, one, ctypes.pointer(binding.init(type(getattr(options, one))._type_)))
        options = getattr(options, one).contents
    return options, name


def _set_number(options: Any, member: str, value: Any, *_: Any) -> List[Any]:
    setattr(options, member, value)
    return []


def _word(value: str, words: Sequence[str], keyword: str) -> int:
    if value == "none" and "none" not in words:  # of a correction
        return 0
    signs = {"+": "plus-", "-": "minus-"}
    return chosen(signs[value[0]] + value[1:] if words is declarations.FRONT and value[:1] in signs else value, words, keyword)


def _set_texts(options: Any, member: str, value: Sequence[str], count: Tuple[str], *_: Any) -> List[Any]:
    setattr(options, member, (ctypes.c_char_p * len(value))(*[text.encode() for text in value]))
    setattr(options, count[0], len(value))
    return []


def _set_mapping(options: Any, member: str, value: Mapping[str, float], extra: Tuple[str, str], *_: Any) -> List[Any]:
    _set_texts(options, extra[0], list(value), (extra[1],))
    return _set_data(options, member, np.array(list(value.values()), np.float64))


def _set_lines(options: Any, member: str, value: Sequence[Any], extra: Tuple[str, str, str], keyword: str, *_: Any) -> List[Any]:
    lines = [real(line, (None, int(extra[2])), keyword) for line in value]
    setattr(options, extra[1], len(lines))
    offsets = np.cumsum([0, *(len(line) for line in lines)]).astype(np.uint32)
    return _set_data(options, extra[0], offsets) + (_set_data(options, member, np.concatenate(lines)) if lines else [])


def _set_array(options: Any, member: str, value: Any, extra: Tuple[str, Tuple[str, ...], bool, bool], keyword: str, given: Any, one: Any) -> List[Any]:
    view = one._view()
    shape = [view.vertex_count if d == "V" else view.joint_count if d == "J" else int(d) for d in extra[1]]
    if extra[0] == "uint8":
        array = mask(value, shape[0], keyword)
    elif extra[0].startswith("int"):
        array = whole(value, tuple(shape), keyword, extra[0], -1, 1 << 31)
    else:
        if shape[-1] == 12:  # rows of 3 x 4, with or without the last one of 4 x 4
            value, shape[-1:] = np.asarray(value)[:, :3], [3, 4]
        real(value, tuple(shape), keyword)
        array = np.ascontiguousarray(value, extra[0])
    return _set_data(options, member, array)


def _set_structs(options: Any, member: str, value: Any, extra: Tuple[Any, Tuple[str]], keyword: str, given: Any, one: Any) -> List[Any]:
    struct = extra[0]
    if struct is declarations.sinew_answer:
        rows = answers_of(value, one._view().vertex_count, one.skeleton)
    else:
        if isinstance(value, Mapping):
            value = _pins(value, one.skeleton, given["source"])
        rows = (struct * len(value))()
        for row, items in zip(rows, value):
            if struct is declarations.sinew_skeleton_edit:
                _set_edit(row, *items)
                continue
            for (name, _), item in zip(struct._fields_, items):
                setattr(row, name, int(item))
    setattr(options, member, rows)
    setattr(options, extra[1][0], len(rows))
    return []


def _set_edit(row: Any, kind: str, joint: str, *what: Any) -> None:
    """`what`: the position, and the parent or the new name before it."""
    row.kind, row.joint = chosen(kind, declarations.EDIT_KIND, "edits"), joint.encode()
    for item in what:
        if isinstance(item, str):
            row.other = item.encode()
        else:
            row.position[:] = real(item, (3,), "edits").tolist()


def _set_data(options: Any, member: str, array: Any) -> List[Any]:
    setattr(options, member, array.ctypes.data)
    return [array]


def _pins(pins: Mapping[Any, Any], target: Any, source: Any) -> List[Tuple[int, int]]:
    """Pairs of numbers of joints that are named or numbered; None: none."""
    of = getattr(source, "skeleton", None)
    if target is None:
        raise ValueError("pins: this character has no joints")
    if of is None and any(isinstance(joint, str) for joint in pins.values()):
        raise ValueError("pins: joints of a file's skeleton are given by number; open() the file to give names")
    return [(target.index(to, "pins"), -1 if joint is None else int(joint) if of is None else of.index(joint, "pins")) for to, joint in pins.items()]


_SETTERS: Dict[str, Callable[..., List[Any]]] = {
    "number": _set_number, "texts": _set_texts, "mapping": _set_mapping, "lines": _set_lines, "array": _set_array, "structs": _set_structs,
    "word": lambda o, member, value, words, keyword, *_: _set_number(o, member, _word(value, words, keyword)),
    "flag": lambda o, member, value, *_: _set_number(o, member, int(bool(value))),
    "without": lambda o, member, value, bit, *_: _set_number(o, member, getattr(o, member) | (0 if value else bit)),
    "percent": lambda o, member, value, *_: _set_number(o, member, round(100 * value)),
    "text": lambda o, member, value, *_: _set_number(o, member, os.fsencode(str(value) if isinstance(value, int) else value) or None),
    "character": lambda o, member, value, *_: _set_number(o, member, value.pointer)}


def result_as(struct: Any, sizes: Mapping[str, int], joints: Sequence[str] = ()) -> Any:
    """A struct that C filled as the class of results.py. `sizes`: the character's vertices and joints."""
    kind, rows = results.RESULTS[type(struct)]
    fields = {name: _value_of(struct, how, member, extra, sizes, joints) for name, how, member, extra in rows}
    if "first_clip" in fields:
        fields["clips"] = range(fields["first_clip"], fields.pop("first_clip") + fields["clips"])
    return kind(**fields)


def _value_of(struct: Any, kind: str, member: str, extra: Any, sizes: Mapping[str, int], joints: Sequence[str]) -> Any:
    value = getattr(struct, member)
    if kind == "flag":
        return bool(value)
    if kind == "word":
        return extra[value]
    if kind == "fraction":
        return value / 65536
    if kind == "number":
        return None if extra and value < 0 else value
    if kind == "text":
        return (value or b"").decode(errors="replace")
    if kind == "numbers":
        return tuple(value)
    size = {d: sizes[d] if d in sizes else getattr(struct, d) for d in (extra[1] if kind in ("structs", "array") else extra[:2]) if not d.isdigit()}
    if kind == "lines":
        offsets = array_at(value and getattr(struct, extra[0]), np.uint32, (size[extra[1]] + 1,))
        points = array_at(value, np.float32, (int(offsets[-1]), int(extra[2])))
        return [points[a:b] for a, b in zip(offsets[:-1], offsets[1:])]
    count = tuple(size[d] if d in size else int(d) for d in extra[1])
    if kind == "array":
        return None if extra[2] and not value else array_at(value, np.dtype(extra[0]), count).astype(bool if extra[3] else extra[0])
    listed = value[:int(np.prod(count))] if value else []
    if extra[0] is declarations.sinew_question:
        return [question_of(one) for one in listed]
    if extra[0] is declarations.sinew_character_left_out:
        return {joints[one.joint]: one.why.decode() for one in listed}
    return [result_as(one, sizes, joints) for one in listed]


def array_at(address: Any, dtype: Any, shape: Tuple[int, ...]) -> Array:
    """A copy of an array of the library; without one zeros, of signed integers -1."""
    size = int(np.prod(shape)) * np.dtype(dtype).itemsize
    if not size or not address:
        return np.full(shape, -1 if np.dtype(dtype).kind == "i" else 0, dtype)
    return np.frombuffer(ctypes.string_at(address, size), dtype).reshape(shape).copy()


def error_line(character: Any) -> str:
    pointer = None if character is None else character.pointer
    return str(binding.character_library().sinew_character_error(pointer).decode(errors="replace"))


def _model_member(name: str, given: Mapping[str, Any]) -> str:
    if name != "model":
        return name[:-len("_model")]
    return "bind" if "hands_model" not in given else "slots" if given.get("method") == "slots" else "rig"


class _Models:
    """Models in place of the bundled ones."""

    def __init__(self, **files: ModelFile) -> None:
        self.struct = binding.init(declarations.sinew_character_models)
        self._kept = []
        for name, file in files.items():
            try:
                content = file if isinstance(file, bytes) else Path(file).read_bytes()  # type: ignore[arg-type]
            except OSError as error:
                raise binding.Error(f"{os.fspath(file)!s}: cannot read the model, {error.strerror}") from None  # type: ignore[arg-type]
            aligned = np.zeros(-(-max(len(content), 1) // 8), np.uint64)
            aligned.view(np.uint8)[:len(content)] = np.frombuffer(content, np.uint8)
            self._kept.append(aligned)
            setattr(self.struct, name, aligned.ctypes.data)
            setattr(self.struct, name + "_size", len(content))
        self.any = bool(self._kept)
