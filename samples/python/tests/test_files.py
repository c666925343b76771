# SPDX-License-Identifier: MIT
"""load() and save()."""
import json
import os
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

import sinew

from common import DATA, ROOT, command, folder, read_character

sys.path.insert(0, str(ROOT / "tests" / "support"))
from strange_characters import Glb, box  # noqa: E402

VALIDATE = """const v = require('gltf-validator'), fs = require('fs');
v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(r => {
  console.log(JSON.stringify(r.issues.messages.filter(m => m.severity == 0))); process.exit(r.issues.numErrors ? 1 : 0); });"""


def bound(name):
    positions, faces, skeleton, _ = read_character(name)
    return sinew.Character(positions, faces, skeleton, sinew.bind(positions, faces, skeleton), name=name)


def json_of(path):
    """The JSON of a .glb."""
    data = Path(path).read_bytes()
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


def validate(path):
    """The Khronos validator's errors; None without it."""
    modules = ROOT / "tests" / "support" / "node" / "node_modules"
    if shutil.which("node") is None or not (modules / "gltf-validator").is_dir():
        return None
    return subprocess.run(["node", "-e", VALIDATE, path], env={**os.environ, "NODE_PATH": str(modules)}, capture_output=True, text=True,
                          check=False)


class Files(unittest.TestCase):
    def check_valid(self, path):
        command("inspect", path)
        done = validate(path)
        if done is None:
            print("SKIPPED the Khronos validator: scripts/setup.sh installs it for node")
        else:
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_what_is_saved_is_loaded(self):
        one = bound("biped__robed")
        rotations, translations = one.skeleton.rest()
        one.clips = [sinew.Clip(np.tile(rotations, (5, 1, 1)), np.tile(translations, (5, 1, 1)), 24, "still")]
        angle = np.linspace(0, 1, 5)
        one.clips[0].rotations[:, 3] = np.stack([0 * angle, np.sin(angle), 0 * angle, np.cos(angle)], 1)
        with folder() as where:
            sinew.save(f"{where}/one.glb", one)
            self.check_valid(f"{where}/one.glb")
            two = sinew.load(f"{where}/one.glb")
            # A file of arrays has vertices in the order in which its faces use them.
            order = np.array([np.abs(one.positions - p).sum(1).argmin() for p in two.positions])
            self.assertEqual(len(set(order.tolist())), len(one.positions))
            np.testing.assert_array_equal(two.positions, one.positions.astype(np.float32)[order])
            np.testing.assert_array_equal(two.skin.weights, one.skin.weights[order])
            np.testing.assert_array_equal(two.skin.joints, one.skin.joints[order])
            np.testing.assert_allclose(two.skeleton.positions, one.skeleton.positions, atol=1e-6)
            self.assertEqual(two.skeleton.names, one.skeleton.names)
            np.testing.assert_array_equal(two.skeleton.parents, one.skeleton.parents)
            np.testing.assert_allclose(np.abs((two.clips[0].rotations * one.clips[0].rotations).sum(2)), 1, atol=1e-6)
            self.assertAlmostEqual(two.clips[0].fps, 24, places=3)
            # Again through its own document: nothing is doubled.
            sinew.save(f"{where}/two.glb", two)
            self.check_valid(f"{where}/two.glb")
            three = sinew.load(f"{where}/two.glb")
            np.testing.assert_array_equal(three.skin.weights, two.skin.weights)
            self.assertEqual(len(three.clips), 1)
            self.assertEqual(len(json_of(f"{where}/two.glb")["meshes"]), 1)

    def test_the_commands_files_give_its_rows(self):
        with folder() as where:
            command("bind", DATA / "biped__robed.obj", "--skeleton", DATA / "biped__robed.rig.txt", "--joints", "all", "--keep-tips",
                    "-o", f"{where}/command.glb")
            one = sinew.load(f"{where}/command.glb")
            skin = sinew.bind(one.positions, one.faces, one.skeleton)
            np.testing.assert_array_equal(skin.joints, one.skin.joints)
            np.testing.assert_array_equal(skin.weights, one.skin.weights)

    def test_a_loaded_file_keeps_what_it_has(self):
        one = sinew.load(DATA / "biped__caped.gltf")
        self.assertGreater(len(one.skeleton), 5)
        materials = json.loads((DATA / "biped__caped.gltf").read_text()).get("materials", [])
        one.skin = sinew.bind(one.positions, one.faces, one.skeleton, method="heat")
        with folder() as where:
            sinew.save(f"{where}/one.glb", one)
            self.check_valid(f"{where}/one.glb")
            two = sinew.load(f"{where}/one.glb")
            np.testing.assert_array_equal(two.skin.weights, one.skin.weights)
            self.assertEqual(json_of(f"{where}/one.glb").get("materials", []), materials)
            self.assertEqual(len(two.clips), len(one.clips))

    def test_a_bare_file_gets_a_skeleton(self):
        positions, faces, _, _ = read_character("biped__robed")
        with folder() as where:
            sinew.save(f"{where}/bare.glb", sinew.Character(positions, faces))
            self.check_valid(f"{where}/bare.glb")
            one = sinew.load(f"{where}/bare.glb")
            self.assertIsNone(one.skeleton)
            one.skeleton = sinew.rig(one.positions, one.faces).skeleton
            one.skin = sinew.bind(one.positions, one.faces, one.skeleton)
            sinew.save(f"{where}/rigged.glb", one)
            self.check_valid(f"{where}/rigged.glb")
            self.assertEqual(len(sinew.load(f"{where}/rigged.glb").skeleton), len(one.skeleton))

    def test_polygons_are_written_as_fans(self):
        positions = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0], [1.5, 2, 0]]
        with folder() as where:
            sinew.save(f"{where}/one.glb", sinew.Character(positions, [[0, 1, 2, 3], [1, 4, 5], [2, 1, 4, 5, 6]]))
            self.assertEqual(sinew.load(f"{where}/one.glb").faces.tolist(), [[0, 1, 2], [0, 2, 3], [1, 4, 5], [2, 1, 4], [2, 4, 5], [2, 5, 6]])

    def test_two_nodes_of_one_mesh_get_weights_each(self):
        with folder() as where:
            out = Glb()
            mesh = out.mesh("box", *box(0, 0, 0, 0.5))
            out.node("one", mesh=mesh)
            out.node("two", mesh=mesh, translation=[0, 0, 2])
            out.save(f"{where}/two.glb")
            two = sinew.load(f"{where}/two.glb")
            self.assertEqual(len(two.positions), 16)
            two.skeleton = sinew.Skeleton([[0, 0, 0], [0, 0, 2]], [-1, 0])
            two.skin = sinew.bind(two.positions, two.faces, two.skeleton, method="heat")
            sinew.save(f"{where}/three.glb", two)
            self.check_valid(f"{where}/three.glb")
            three = sinew.load(f"{where}/three.glb")
            np.testing.assert_array_equal(three.skin.weights, two.skin.weights)
            np.testing.assert_allclose(three.positions, two.positions, atol=1e-6)

    def test_meshes_that_hang_on_joints_keep_their_places(self):
        """They collapsed onto one point while the package had a reader of its own."""
        import strange_characters
        with folder() as where:
            files = {f.name: f for f in strange_characters.write_all(where)}
            plain, props = sinew.load(files["plain.glb"]), sinew.load(files["props.glb"])
            self.assertEqual(len(props.positions), len(plain.positions) + 16)
            for name in ("hand.R", "head"):
                near = np.linalg.norm(props.positions - props.skeleton.positions[props.skeleton.index(name)], axis=1) < 0.5
                self.assertGreaterEqual(near.sum(), 8)
            parts = sinew.load(files["robot_of_parts.glb"])
            self.assertGreater(np.ptp(parts.positions, axis=0).max(), 1)

    def test_errors_name_the_file_and_leave_what_was_there(self):
        with folder() as where:
            bad = Path(where, "bad.glb")
            for content in (b"", b"glTF", b"{}", b"glTF\x02\0\0\0\xff\xff\xff\0", b'{"nodes": [{"mesh": 3}]}'):
                bad.write_bytes(content)
                with self.assertRaisesRegex(sinew.Error, "bad.glb: "):
                    sinew.load(bad)
            with self.assertRaisesRegex(sinew.Error, "none.glb: "):
                sinew.load(Path(where, "none.glb"))
            one = bound("snake__long")
            one.skin.joints[0, 0] = 60000
            with self.assertRaisesRegex(ValueError, "character.skin: names joint 60000"):
                sinew.save(bad, one)
            self.assertEqual(bad.read_bytes(), b'{"nodes": [{"mesh": 3}]}')
            self.assertEqual(os.listdir(where), ["bad.glb"])
            os.mkdir(Path(where, "folder.glb"))
            with self.assertRaisesRegex(sinew.Error, "folder.glb"):
                sinew.save(Path(where, "folder.glb"), bound("snake__long"))
            self.assertEqual(sorted(os.listdir(where)), ["bad.glb", "folder.glb"])
            with self.assertRaisesRegex(sinew.Error, "one.xyz"):
                sinew.save(Path(where, "one.xyz"), bound("snake__long"))
            with self.assertRaisesRegex(sinew.Error, "one.glb"):
                sinew.save(Path(where, "none", "one.glb"), bound("snake__long"))

    def test_every_length_of_a_file_is_refused_or_read(self):
        with folder() as where:
            path = Path(where, "one.glb")
            sinew.save(path, bound("snake__long"))
            data = path.read_bytes()
            for size in list(range(0, 200, 7)) + list(range(200, len(data), len(data) // 40)):
                path.write_bytes(data[:size])
                with self.assertRaises(sinew.Error):
                    sinew.load(path)


if __name__ == "__main__":
    unittest.main()
