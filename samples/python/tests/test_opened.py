# SPDX-License-Identifier: MIT
"""open(): strange files through the package and through the command, and the same bytes; what a caller may get wrong."""
import filecmp
import json
import os
import signal
import subprocess
import sys
import threading
import unittest
from pathlib import Path

import numpy as np

import sinew

from common import COMMAND, DATA, ROOT, command, folder, read_character

sys.path.insert(0, str(ROOT / "tests" / "support"))
import strange_characters  # noqa: E402


def said(*arguments):
    """The command's exit code and the error line without its name."""
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, check=False)
    return done.returncode, done.stderr.strip().split("\n")[-1]


def with_skeleton(file):
    """The file as the command's arguments; open() finds the joints beside an OBJ by itself."""
    file = Path(file)
    return [file, "--skeleton", file.with_suffix(".rig.txt")] if file.suffix == ".obj" else [file]


def moving(name="biped__robot"):
    """A character with a clip."""
    positions, faces, skeleton, rows = read_character(name)
    one = sinew.Character(positions, faces, skeleton, sinew.bind(positions, faces, skeleton), name=name)
    rotations, translations = skeleton.rest()
    frames = 20
    clip = sinew.Clip(np.tile(rotations, (frames, 1, 1)), np.tile(translations, (frames, 1, 1)), fps=24, name="wave")
    angle = np.sin(np.linspace(0, 6, frames))
    for joint, axis in (("upper_arm.L", 2), ("forearm.R", 1), ("thigh.L", 0), ("head", 1)):
        turned = np.zeros((frames, 4), np.float32)
        turned[:, axis], turned[:, 3] = np.sin(angle / 2), np.cos(angle / 2)
        clip.rotations[:, skeleton.index(joint)] = turned
    one.clips = [clip]
    return one


class SameBytesAsTheCommand(unittest.TestCase):
    def setUp(self):
        holder = folder()
        self.addCleanup(holder.cleanup)
        self.where = holder.name

    def at(self, name):
        return Path(self.where, name)

    def test_bind_of_strange_files(self):
        files = strange_characters.write_all(self.where)
        bound = 0
        for file in files:
            with self.subTest(file.name):
                ours, theirs = self.at("ours.glb"), self.at("theirs.glb")
                code, line = said("bind", *with_skeleton(file), "-o", theirs)
                try:
                    with sinew.open(file) as one:
                        told = one.bind()
                        one.save(ours)
                except sinew.Error as error:
                    self.assertEqual(code, 1, error)
                    # The same fault in both; what to do about it is an option there, a call here.
                    self.assertIn(str(error).split(": ", 1)[1].split(";")[0], line)
                    continue
                self.assertEqual(code, 0, line)
                self.assertTrue(filecmp.cmp(ours, theirs, False), "other bytes than the command's")
                self.assertEqual(told.hash, command("bind", *with_skeleton(file), "-o", theirs, "--json")["hash"])
                bound += 1
        print(f"{bound} of {len(files)} files bound with the command's bytes")
        self.assertGreaterEqual(bound, 20)

    def test_memory_is_as_the_disk(self):
        content = (DATA / "biped__robed.obj").read_bytes()
        with sinew.open(content, name="biped__robed.obj", beside={"biped__robed.rig.txt": (DATA / "biped__robed.rig.txt").read_bytes()}) as one:
            one.bind()
            files = one.write("out.glb")
        command("bind", *with_skeleton(DATA / "biped__robed.obj"), "-o", self.at("theirs.glb"))
        self.assertEqual(list(files), ["out.glb"])
        self.assertEqual(files["out.glb"], self.at("theirs.glb").read_bytes())

    def test_options(self):
        for options, arguments in ((["--symmetric", "--softness", "2"], {"symmetric": True, "softness": 2}),
                                   (["--method", "heat", "--influences", "8"], {"method": "heat", "influences": 8}),
                                   (["--joints", "all", "--keep-tips", "--threads", "3"], {"joints": "all", "keep_tips": True, "threads": 3})):
            with self.subTest(str(options)):
                command("bind", *with_skeleton(DATA / "biped__robed.obj"), "-o", self.at("theirs.glb"), *options)
                with sinew.open(DATA / "biped__robed.obj") as one:
                    one.bind(**arguments)
                    one.save(self.at("ours.glb"))
                self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))

    def test_rig(self):
        for name, options, arguments in (("biped__robed", [], {}), ("biped__robed", ["--detail", "full"], {"detail": "full"}),
                                         ("quadruped__tailed", ["--no-bind"], {"bind": False})):
            with self.subTest(name):
                bare = self.at(f"{name}.obj")
                bare.write_bytes((DATA / f"{name}.obj").read_bytes())
                command("rig", bare, "-o", self.at("theirs.glb"), *options)
                with sinew.open(bare) as one:
                    told = one.rig(**arguments)
                    one.save(self.at("ours.glb"))
                    self.assertEqual(len(told.confidence), len(one.skeleton))
                self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))

    def test_retarget_map_and_pose(self):
        sinew.save(self.at("source.glb"), moving())
        command("bind", *with_skeleton(DATA / "biped__robed.obj"), "-o", self.at("target.glb"))
        command("animate", self.at("target.glb"), "--motion", self.at("source.glb"), "-o", self.at("theirs.glb"))
        command("map", self.at("target.glb"), "--from", self.at("source.glb"), "-o", self.at("theirs.map"))
        with sinew.open(self.at("target.glb")) as one, sinew.open(self.at("source.glb")) as source:
            self.assertEqual(one.map(source).text, self.at("theirs.map").read_text())
            self.assertEqual(one.map(self.at("source.glb")).text, self.at("theirs.map").read_text())
            told = one.retarget(source)
            one.save(self.at("ours.glb"))
            self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))
            self.assertEqual(len(told.clips), 1)
            clip = one.clips()[told.clips[0]]
            self.assertEqual(clip.rotations.shape, (20, len(one.skeleton), 4))
            self.assertAlmostEqual(clip.fps, 24, places=3)
            angles = np.zeros((len(one.skeleton), 3))
            angles[one.skeleton.index("forearm.L"), 1] = 60
            posed = one.pose(angles=angles, method="volume")
            self.assertGreater(np.abs(posed.positions - one.positions).max(), 0.05)

    def test_transfer_simplify_bake(self):
        target = self.at("target.obj")
        target.write_bytes((DATA / "biped__robed.obj").read_bytes())
        command("transfer", DATA / "biped__robed.obj", target, "-o", self.at("theirs.glb"))
        with sinew.open(DATA / "biped__robed.obj") as source, sinew.open(target) as one:
            told = one.transfer(source)
            one.save(self.at("ours.glb"))
            self.assertGreater(told.carried, 0.1)
        self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))
        command("bind", *with_skeleton(DATA / "biped__robed.obj"), "-o", self.at("bound.glb"))
        command("simplify", self.at("bound.glb"), "--level", "12", "-o", self.at("theirs.glb"))
        with sinew.open(self.at("bound.glb")) as one:
            into = one.simplify(joint_count=12)
            self.assertEqual(len(set(into.tolist())), len(one.skeleton))
            one.save(self.at("ours.glb"))
        self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))
        command("bake", self.at("bound.glb"), "-o", self.at("theirs.glb"), "--poses", "60", "--shapes", "2")
        with sinew.open(self.at("bound.glb")) as one:
            baked = one.bake(poses=60, shapes=2)
            one.save(self.at("ours.glb"))
        self.assertLess(baked.held_out_baked_error, baked.held_out_linear_error)
        self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))


    def test_place_lod_check_controls(self):
        robed = DATA / "biped__robed.obj"
        command("bind", *with_skeleton(robed), "--turn", "y", "--height", "2", "--floor", "-o", self.at("theirs.glb"), "--controls", self.at("theirs.json"))
        with sinew.open(robed) as one:
            one.transform(turns=["y"], height=2, floor=True)
            one.bind()
            one.set_profile(None, controls=True)
            one.save(self.at("ours.glb"))
            self.assertEqual(one.controls(), json.loads(self.at("theirs.json").read_text()))
            self.assertEqual({limb["name"] for limb in one.controls()["limbs"]}, {"leg.left", "leg.right", "arm.left", "arm.right"})
            told = one.check(poses=False, score=True)
            self.assertTrue(0 < told.score <= 100 and told.line.startswith("checked: "))
            self.assertIsNone(one.check(poses=False).score)
            strict = one.check(poses=False, bounds={"speck": -1, "far-weight": -1})
            self.assertGreaterEqual(len(strict.findings), len(told.findings))
        self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at("theirs.glb"), False))
        command("lod", self.at("theirs.glb"), "--levels", "2", "-o", self.at("far.glb"))
        with sinew.open(self.at("theirs.glb")) as one:
            levels = one.lod(levels=2)
            for number, (level, figures) in enumerate(levels, 1):
                level.save(self.at("ours.glb"))
                self.assertTrue(filecmp.cmp(self.at("ours.glb"), self.at(f"far.lod{number}.glb"), False))
                self.assertGreaterEqual(figures.posed_error, figures.rest_error)
                level.close()
            self.assertLess(levels[1][1].triangle_count, levels[0][1].triangle_count)
            with self.assertRaisesRegex(sinew.Error, "expected x, y, z"):
                one.transform(turns=["up"])


class Calls(unittest.TestCase):
    def test_classes_are_the_librarys(self):
        """By names as the command has them; the package once laid a body of its own over the joints and read no names."""
        tail = sinew.Skeleton([[0, 1, 0], [0.2, 1, 0], [0.4, 1, 0]], [-1, 0, 1], ["LeftUpLeg", "LeftLeg", "LeftFoot"])
        self.assertEqual([sinew.CLASSES[c] for c in sinew.joint_classes(tail)], ["thigh", "calf", "foot"])
        with sinew.open(DATA / "biped__robed.obj") as one:
            classes = [sinew.CLASSES[c] for c in one.joint_classes()]
            names = one.skeleton.names
        self.assertEqual(classes[names.index("forearm.L")], "forearm")
        self.assertEqual(classes[names.index("thigh.R")], "thigh")

    def test_arrays_in_and_out(self):
        one = moving()
        with sinew.create(one) as held:
            two = held.character()
        np.testing.assert_array_equal(two.positions, one.positions.astype(np.float32))
        np.testing.assert_array_equal(two.skin.joints, one.skin.joints)
        np.testing.assert_array_equal(two.skin.weights, one.skin.weights)
        self.assertEqual(two.skeleton.names, one.skeleton.names)
        np.testing.assert_allclose(np.abs((two.clips[0].rotations * one.clips[0].rotations).sum(2)), 1, atol=1e-6)
        np.testing.assert_allclose(two.clips[0].translations, one.clips[0].translations, atol=1e-6)
        # Axes that are turned at rest are those of the world in the file.
        one.skeleton.rotations = np.tile(np.array([0.5, 0.5, 0.5, 0.5], np.float32), (len(one.skeleton), 1))
        rotations, translations = one.skeleton.rest()
        one.clips = [sinew.Clip(rotations[None], translations[None], 24, "still")]
        with sinew.create(one) as held:
            still = held.clips()[0]
        np.testing.assert_allclose(np.abs(still.rotations[0, :, 3]), 1, atol=1e-6)

    def test_errors_are_one_line(self):
        with folder() as where:
            bad = Path(where, "bad.glb")
            bad.write_bytes(b"glTF")
            for call in (lambda: sinew.open(bad), lambda: sinew.open(Path(where, "none.fbx")), lambda: sinew.open(Path(where, "one.xyz")),
                         lambda: sinew.open(b"", name="empty.glb")):
                with self.assertRaisesRegex(sinew.Error, r"^[^\n]*(bad.glb|none.fbx|one.xyz|empty.glb)[^\n]*$"):
                    call()
            with self.assertRaisesRegex(ValueError, "name: bytes need a file name"):
                sinew.open(b"")
            bare = Path(where, "bare.obj")
            bare.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            with sinew.open(bare) as one:
                with self.assertRaises(sinew.Error):
                    one.bind()
                with self.assertRaisesRegex(sinew.Error, "cannot|none"):
                    one.save(Path(where, "none", "out.glb"))
                self.assertEqual(sorted(os.listdir(where)), ["bad.glb", "bare.obj"])
            with self.assertRaisesRegex(ValueError, "closed"):
                one.bind()
            self.assertEqual(repr(one), "<sinew.OpenCharacter, closed>")
        with sinew.open(DATA / "biped__robed.obj") as one:
            self.assertRegex(repr(one), "<sinew.OpenCharacter 'biped__robed': [0-9]+ vertices, [0-9]+ joints, weights, 0 clips>")
            with self.assertRaisesRegex(ValueError, "method: expected one of model, heat"):
                one.bind(method="magic")
            with self.assertRaisesRegex(ValueError, "no joint 'tail'"):
                one.bind(never=["tail"])
            with self.assertRaises(sinew.Cancelled):
                one.bind(progress=lambda share: share > 0.3)
            with self.assertRaisesRegex(sinew.Error, "none.sinew: cannot read the model"):
                one.bind(model="none.sinew")
            self.assertIsNotNone(one.skeleton)

    def test_ctrl_c(self):
        with sinew.open(DATA / "biped__robed.obj") as one:
            once = threading.Timer(0.01, signal.raise_signal, (signal.SIGINT,))
            self.addCleanup(once.cancel)  # a failure here is none of the next test's
            with self.assertRaises(KeyboardInterrupt):
                once.start()
                for _ in range(1000):
                    one.bind()
            once.join()

    def test_lists(self):
        self.assertIn(".bvh", sinew.extensions("read-motion"))
        self.assertIn(".glb", sinew.extensions("read-mesh", "write-character"))
        self.assertTrue(sinew.templates())


if __name__ == "__main__":
    unittest.main()
