# SPDX-License-Identifier: MIT
"""Style files (formats/spec/style.md): an artist's answers about parts of one character, for similar characters."""
from __future__ import annotations

import json
import math
import os
import re
from typing import Any, Dict, List, Sequence, Set, Tuple, Union

import numpy as np

from .arrays import real
from .binder import ANSWERS
from .binding import Array, Error
from .character import Skeleton, Skin

# The numbers of the specification, "How a rule is used".
_FARTHEST, _OTHER_JOINT, _MIRRORED, _OF_BODY, _SAME_PLACE = 0.6, 0.2, 0.05, 0.5, 0.15


def answers_by_style(path: Union[str, "os.PathLike[str]"], positions: Any, skeleton: Skeleton, asked: Skin,
                     never: Sequence[str] = ()) -> List[Tuple[Any, ...]]:
    """Answers for bind(), from a file that `sinew bind --save-style` wrote.

    positions  [n, 3] of the mesh; the file's own characters had the same axis up, and the mirror is across x
    asked      of bind(..., questions=MAX_QUESTIONS): its questions and parts
    never      joints that must not get weight
    Raises Error, which names the file.
    """
    name = os.fspath(path)
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
        if content["sinew_style"] != 1:
            raise Error(f"{name}: version {content['sinew_style']}, this package reads 1")
        rules = _rules(content, _joints(positions, skeleton))
    except OSError as error:
        raise Error(f"{name}: cannot read, {error.strerror}") from None
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
        raise Error(f"{name}: not a style file (expected JSON as sinew bind --save-style writes), {type(error).__name__}: {error}") from None
    if not asked.questions or not rules or asked.vertex_parts is None:
        return []
    looks = _looks(positions, asked.vertex_parts)
    matches = []
    for q, question in enumerate(asked.questions):
        look = {**looks[int(asked.vertex_parts[question.vertex])], "joint": skeleton.names[question.joint]}
        for mirror in (False, True):
            for r, rule in enumerate(rules):
                off = _difference(rule, look, mirror) + (_MIRRORED if mirror else 0)
                if off < _FARTHEST:
                    matches.append((off, q, r, mirror))
    matches.sort(key=lambda m: m[0])  # the best pairs find each other
    answered, used, out = set(), set(), []
    for _, q, r, mirror in matches:
        if q in answered or r in used:
            continue
        rule, question = rules[r], asked.questions[q]
        answer: Tuple[Any, ...] = (question.vertex, rule["answer"])
        if rule["answer"] == "rigid":
            joint = _joint(positions, skeleton, set(never), rule, mirror, question.joint)
            if joint < 0:
                continue
            answer += (joint,)
        answered.add(q)
        used.add(r)
        out.append(answer)
    return out


def _words(name: str) -> List[str]:
    """Words of a joint's name without side and numbers, in lower case."""
    found = re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[^\W\d_a-zA-Z]+", name)
    return [w.lower() for w in found if w.lower() not in ("l", "r", "left", "right")]


def _places(positions: Any, points: Array) -> Array:
    """Positions relative to the center of the mesh's box, in its longest sides."""
    corners = real(positions, (None, 3), "positions")
    low, high = corners.min(0).astype(np.float64), corners.max(0).astype(np.float64)
    return np.asarray((points.astype(np.float64) - 0.5 * (low + high)) / max(float((high - low).max()), 1e-20))


def _joints(positions: Any, skeleton: Skeleton) -> Dict[str, Array]:
    return dict(zip(map(str, skeleton.names), _places(positions, skeleton.positions)))


def _rules(content: Any, joints: Dict[str, Array]) -> List[Dict[str, Any]]:
    """Rules of the sheets of similar characters."""
    out = []
    for sheet in content["characters"]:
        theirs = {one["name"]: np.array(one["place"], np.float64) for one in sheet["joints"]}
        away = [math.dist(place, joints[n]) for n, place in theirs.items() if n in joints]
        enough = 2 * max(len(theirs), len(joints))
        same_names, same_places = 3 * len(away) >= enough, 3 * sum(d < _SAME_PLACE for d in away) >= enough
        for rule in sheet["rules"]:
            if rule["answer"] not in ANSWERS:
                raise ValueError(f"unknown answer {rule['answer']!r}")
            part = {"body": False, **rule["part"], "place": np.array(rule["part"]["place"], np.float64)}
            rule = {"steps_up": -1, **rule, "part": part}
            if rule["answer"] == "rigid":
                rule["joint_place"] = np.array(rule["joint_place"], np.float64)
            if same_places if rule["answer"] == "rigid" else same_names:
                out.append(rule)
    return out


def _looks(positions: Any, vertex_parts: Array) -> List[Dict[str, Any]]:
    parts = np.asarray(vertex_parts, np.int64)
    places = _places(positions, real(positions, (None, 3), "positions"))
    counts = np.bincount(parts)
    middles = np.stack([np.bincount(parts, places[:, i]) for i in range(3)], 1) / np.maximum(counts, 1)[:, None]
    radii = np.bincount(parts, np.linalg.norm(places - middles[parts], axis=1)) / np.maximum(counts, 1)
    return [{"body": p == counts.argmax(), "size": counts[p] / len(parts), "radius": radii[p], "place": middles[p]} for p in range(len(counts))]


def _flipped(place: Array, mirror: bool) -> Array:
    return place * [-1, 1, 1] if mirror else place


def _ratio(a: float, b: float) -> float:
    return abs(math.log((a + 1e-6) / (b + 1e-6)))


def _difference(rule: Dict[str, Any], look: Dict[str, Any], mirror: bool) -> float:
    part = rule["part"]
    if bool(part["body"]) != bool(look["body"]):
        return 2 * _FARTHEST
    other = 1 if rule["answer"] == "rigid" else _OTHER_JOINT
    names = 0 if _words(part["joint"]) == _words(look["joint"]) else other
    looks = max(_ratio(part["size"], look["size"]) / math.log(4), _ratio(part["radius"], look["radius"]) / math.log(2),
                math.dist(part["place"], _flipped(look["place"], mirror)) / 0.25)
    return names + (_OF_BODY if part["body"] else 1) * looks


def _joint(positions: Any, skeleton: Skeleton, never: Set[str], rule: Dict[str, Any], mirror: bool, own: int) -> int:
    """The joint of a rigid rule, -1 if there is none at its position."""
    places = _places(positions, skeleton.positions)
    off = [math.dist(_flipped(p, mirror), rule["joint_place"]) for p in places]

    def there(j: int) -> bool:
        return skeleton.names[j] not in never and off[j] < _SAME_PLACE

    if rule["steps_up"] == 0 and there(own):
        return own
    candidates = [j for j in range(len(skeleton)) if there(j)]
    named = [j for j in candidates if not mirror and skeleton.names[j] == rule["joint"]]
    if named:
        return named[-1]
    alike = [j for j in candidates if _words(str(skeleton.names[j])) == _words(rule["joint"])]
    if alike or rule["steps_up"] < 0:
        return min(alike, key=lambda j: off[j]) if alike else -1
    above = own
    for _ in range(rule["steps_up"]):
        above = int(skeleton.parents[above]) if above >= 0 else -1
    return above if above >= 0 and there(above) else -1
