#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Strange characters, for tests of front-ends against the command: meshes that hang on joints, props, tips, controls, several skins, scaled
armatures, matrices, odd orders and types. Python's standard library alone.

    strange_characters.py FOLDER       writes them as .glb and prints their paths, then those of samples/data
"""
import json
import math
import struct
import sys
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "samples" / "data"


class Glb:
    def __init__(self):
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "skins": [],
                     "accessors": [], "bufferViews": []}
        self.data = b""

    def add(self, kind, component, rows, **more):
        code = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[component]
        self.data += b"\0" * (-len(self.data) % 4)
        content = b"".join(struct.pack(f"<{len(r)}{code}", *r) for r in rows)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)})
        self.data += content
        self.json["accessors"].append({"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "count": len(rows),
                                       "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def mesh(self, name, positions, triangles, joints=None, weights=None, bytes_=False):
        attributes = {"POSITION": self.add("VEC3", 5126, positions, min=[min(p[i] for p in positions) for i in range(3)],
                                           max=[max(p[i] for p in positions) for i in range(3)])}
        for k in range(0, len(joints[0]) if joints else 0, 4):
            attributes[f"JOINTS_{k // 4}"] = self.add("VEC4", 5121 if bytes_ else 5123, [r[k:k + 4] for r in joints])
            rows = [r[k:k + 4] for r in weights]
            if bytes_:
                attributes[f"WEIGHTS_{k // 4}"] = self.add("VEC4", 5121, rows, normalized=True)
            else:
                attributes[f"WEIGHTS_{k // 4}"] = self.add("VEC4", 5126, rows)
        self.json["meshes"].append({"name": name, "primitives": [{"attributes": attributes,
                                                                  "indices": self.add("SCALAR", 5125, [[v] for t in triangles for v in t])}]})
        return len(self.json["meshes"]) - 1

    def node(self, name, parent=None, **more):
        self.json["nodes"].append({"name": name, **more})
        number = len(self.json["nodes"]) - 1
        if parent is None:
            self.json["scenes"][0]["nodes"].append(number)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(number)
        return number

    def save(self, path):
        if not self.json["skins"]:
            del self.json["skins"]
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        Path(path).write_bytes(struct.pack("<5I", 0x46546C67, 2, 28 + len(text) + len(data), len(text), 0x4E4F534A) + text +
                               struct.pack("<2I", len(data), 0x004E4942) + data)


class Body:
    """A sample character: triangles, joints, the artist's rows."""

    def __init__(self, name="biped__robed"):
        self.positions, self.triangles, self.names, self.places, self.parents, self.rows = [], [], [], [], {}, {}
        for line in (DATA / f"{name}.obj").read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[:1] == ["v"]:
                self.positions.append([float(w) for w in words[1:4]])
            elif words[:1] == ["f"]:
                face = [int(w.split("/")[0]) - 1 for w in words[1:]]
                self.triangles += [[face[0], face[i], face[i + 1]] for i in range(1, len(face) - 1)]
        for line in (DATA / f"{name}.rig.txt").read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[0] == "joints":
                self.names.append(words[1])
                self.places.append([float(w) for w in words[2:5]])
            elif words[0] == "hier":
                self.parents[words[2]] = words[1]
            elif words[0] == "skin":
                self.rows[int(words[1])] = sorted(((float(w), n) for n, w in zip(words[2::2], words[3::2])), reverse=True)

    def influences(self, order, count=4, total=1.0):
        numbers = {name: i for i, name in enumerate(order)}
        joints, weights = [], []
        for v in range(len(self.positions)):
            row = [(w, n) for w, n in self.rows.get(v, [(1.0, self.names[0])])[:count] if n in numbers] or [(1.0, order[0])]
            whole = sum(w for w, _ in row)
            shares = [w / whole for w, _ in row]
            if total != 1.0:
                shares = [math.floor(total * s) for s in shares]
                shares[0] += int(total) - sum(shares)
            joints.append([numbers[n] for _, n in row] + [0] * (count - len(row)))
            weights.append(shares + [0] * (count - len(row)))
        return joints, weights

    def add_joints(self, out, above=None, scale=1.0, matrices=False, order=None):
        """Nodes of the joints, axes as the world's; {name: node}."""
        nodes = {}
        places = dict(zip(self.names, self.places))
        for name in order or self.names:  # parents first, in what order else
            parent = self.parents.get(name)
            at = [(a - b) / scale for a, b in zip(places[name], places[parent] if parent else (0, 0, 0))]
            how = {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *at, 1]} if matrices else {"translation": at}
            nodes[name] = out.node(name, nodes.get(parent, above), **how)
        return nodes

    def add_skin(self, out, nodes, names, scale=1.0):
        places = dict(zip(self.names, self.places))
        inverse = [[1 / scale, 0, 0, 0, 0, 1 / scale, 0, 0, 0, 0, 1 / scale, 0, *(-p / scale for p in places[n]), 1] for n in names]
        out.json["skins"].append({"joints": [nodes[n] for n in names], "inverseBindMatrices": out.add("MAT4", 5126, inverse)})
        return len(out.json["skins"]) - 1


def box(x, y, z, size):
    corners = [[x + size * a, y + size * b, z + size * c] for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return corners, [[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)]


def skinned(body=None, names=None, bytes_=False, count=4, **joints):
    """The body with one skin; (file, nodes)."""
    body, out = body or Body(), Glb()
    nodes = body.add_joints(out, **joints)
    names = names or body.names
    mesh = out.mesh("body", body.positions, body.triangles, *body.influences(names, count, 255.0 if bytes_ else 1.0), bytes_)
    out.node("body", mesh=mesh, skin=body.add_skin(out, nodes, names))
    return out, nodes


def write_all(folder):
    folder, body = Path(folder), Body()
    files = []

    def keep(name, out):
        files.append(folder / f"{name}.glb")
        out.save(files[-1])

    keep("plain", skinned()[0])
    keep("bytes", skinned(bytes_=True)[0])
    keep("eight_influences", skinned(count=8)[0])
    keep("matrices", skinned(matrices=True)[0])
    keep("reversed_joint_list", skinned(names=body.names[::-1])[0])

    out, nodes = skinned()  # a sword that hangs on the hand, a hat on the head
    out.node("sword", nodes["hand.R"], mesh=out.mesh("sword", *box(0, 0.2, 0, 0.1)))
    out.node("hat", nodes["head"], mesh=out.mesh("hat", *box(0, 0.1, 0, 0.15)), translation=[0, 0.1, 0], scale=[1, 0.5, 1])
    keep("props", out)

    out = Glb()  # every mesh hangs on a joint, none has a skin
    nodes = body.add_joints(out)
    for name in body.names:
        out.node("part_" + name, nodes[name], mesh=out.mesh("part_" + name, *box(0, 0.05, 0, 0.05)))
    keep("robot_of_parts", out)

    out, nodes = skinned()  # a skeleton with ends, tips, controls and a root on the floor
    for name in body.names:
        if not any(p == name for p in body.parents.values()):
            out.node(name + "_end", nodes[name], translation=[0, 0.05, 0])
    extra = [out.node(n, translation=[0.3 * i, 0, 0.4]) for i, n in enumerate(("CTRL_hand.L", "ik_foot.R", "pole_knee.L"))]
    skin = out.json["skins"][0]
    skin["joints"] += extra
    places = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -0.3 * i, 0, -0.4, 1] for i in range(3)]
    old = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *(-v for v in p), 1] for p in body.places]
    skin["inverseBindMatrices"] = out.add("MAT4", 5126, old + places)
    keep("controls_and_ends", out)

    tips = Body()  # leaf joints named tip that own weight
    leaves = [n for n in tips.names if n not in tips.parents.values()]
    renamed = {n: f"{n}_tip" for n in leaves}
    tips.names = [renamed.get(n, n) for n in tips.names]
    tips.parents = {renamed.get(a, a): renamed.get(b, b) for a, b in tips.parents.items()}
    tips.rows = {v: [(w, renamed.get(n, n)) for w, n in row] for v, row in tips.rows.items()}
    keep("tips", skinned(tips)[0])

    out = Glb()  # two skins with other joint lists: the upper and the lower half
    nodes = body.add_joints(out)
    upper = body.names
    lower = body.names[::-1]
    for name, names, above in (("upper", upper, True), ("lower", lower, False)):
        some = [t for t in body.triangles if (sum(body.positions[v][1] for v in t) / 3 > 1.0) == above]
        used = sorted({v for t in some for v in t})
        at = {v: i for i, v in enumerate(used)}
        joints, weights = body.influences(names)
        mesh = out.mesh(name, [body.positions[v] for v in used], [[at[v] for v in t] for t in some], [joints[v] for v in used],
                        [weights[v] for v in used])
        out.node(name, mesh=mesh, skin=body.add_skin(out, nodes, names))
    keep("two_skins", out)

    out = Glb()  # centimeters in an armature of 0.01
    armature = out.node("Armature", scale=[0.01, 0.01, 0.01])
    nodes = body.add_joints(out, armature, 0.01)
    mesh = out.mesh("body", body.positions, body.triangles, *body.influences(body.names))
    skin = body.add_skin(out, nodes, body.names, 0.01)
    out.node("body", mesh=mesh, skin=skin)
    out.node("belt", nodes["hips"], mesh=out.mesh("belt", *box(0, 0, 0, 12.0)))
    keep("centimeters", out)

    foreign = Body()  # names of another alphabet, with spaces
    renamed = {n: f"骨 {i} ü" for i, n in enumerate(foreign.names)}
    foreign.names = list(renamed.values())
    foreign.parents = {renamed[a]: renamed[b] for a, b in foreign.parents.items()}
    foreign.rows = {v: [(w, renamed[n]) for w, n in row] for v, row in foreign.rows.items()}
    keep("names", skinned(foreign)[0])

    mirrored = Body()  # modeled to the right, shown by a node of scale -1
    out = Glb()
    armature = out.node("Mirrored", scale=[-1, 1, 1])
    nodes = mirrored.add_joints(out, armature)
    out.node("body", armature, mesh=out.mesh("body", mirrored.positions, mirrored.triangles, *mirrored.influences(mirrored.names)),
             skin=mirrored.add_skin(out, nodes, mirrored.names))
    keep("mirrored_node", out)

    inside = Body()  # faces look inwards
    inside.triangles = [t[::-1] for t in inside.triangles]
    keep("inside_out", skinned(inside)[0])

    for name in ("quadruped__tailed", "snake__long"):
        keep(name, skinned(Body(name))[0])
    files += [DATA / f"{n}.obj" for n in ("biped__robed", "biped__robot", "bird__winged", "many-legged__plated")] + [DATA / "biped__caped.gltf"]
    return files


if __name__ == "__main__":
    Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    print("\n".join(str(f) for f in write_all(sys.argv[1])))
