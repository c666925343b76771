# SPDX-License-Identifier: MIT
"""rig(), map(), retarget(), transfer(), Deformer: what the command gives for the same character."""
import unittest
from pathlib import Path

import numpy as np

import sinew

from common import DATA, as_the_command_reads, command, folder, read_character, read_rig


def character(name):
    positions, faces, skeleton, rows = read_character(name)
    return sinew.Character(positions, faces, skeleton, sinew.bind(positions, faces, skeleton), name=name), rows


class RigAndMap(unittest.TestCase):
    def test_rig_is_the_commands(self):
        for name in ("biped__robed", "quadruped__tailed"):
            positions, faces, _, _ = read_character(name)
            with folder() as where:
                command("rig", DATA / f"{name}.obj", "-o", f"{where}/rig.rig.txt")
                expected, _ = read_rig(f"{where}/rig.rig.txt")
            found = sinew.rig(positions, faces)
            self.assertEqual(found.skeleton.names, expected.names)
            np.testing.assert_allclose(found.skeleton.positions, expected.positions, atol=1e-7)
            np.testing.assert_array_equal(found.skeleton.parents, expected.parents)
            self.assertTrue(found.mirrored)
            self.assertEqual(found.skeleton.ends.any(), any(n.endswith("_end") for n in expected.names))
            sinew.bind(positions, faces, found.skeleton)

    def test_full_detail_is_the_commands(self):
        caped = sinew.load(DATA / "biped__caped.gltf")  # it has eyes or holds a staff
        with folder() as where:
            bare = sinew.Character(caped.positions, caped.faces)
            sinew.save(f"{where}/bare.glb", bare)
            # Without weights, as sinew.rig() is: chains of garments are laid where there are some.
            command("rig", f"{where}/bare.glb", "--detail", "full", "--no-bind", "-o", f"{where}/rig.rig.txt")
            expected, _ = read_rig(f"{where}/rig.rig.txt")
        found = sinew.rig(caped.positions, caped.faces, fingers=True, face=True, props=True).skeleton
        self.assertEqual(set(found.names), set(expected.names))
        self.assertGreater(len(found), len(sinew.rig(caped.positions, caped.faces).skeleton))
        for joint, name in enumerate(found.names):
            np.testing.assert_allclose(found.positions[joint], expected.positions[expected.index(name)], atol=1e-5)

    def test_options(self):
        positions, faces, _, _ = read_character("biped__robed")
        found = sinew.rig(positions, faces, spine=4, toes=False, ends=False)
        self.assertFalse(found.skeleton.ends.any())
        self.assertEqual(sum(n.startswith("Spine") for n in found.skeleton.names), 4)
        self.assertGreater(len(sinew.rig(positions, faces, method="shape").skeleton), 5)
        with self.assertRaises(sinew.Cancelled):
            sinew.rig(positions, faces, progress=lambda share: True)
        self.assertGreaterEqual(len(sinew.rig(positions, faces, fingers=True).skeleton), len(sinew.rig(positions, faces).skeleton))

    def test_map_is_the_commands(self):
        positions, faces, skeleton, _ = read_character("biped__robed")
        other = read_character("biped__robot")[2]
        with folder() as where:
            bare = []
            for name in ("biped__robed", "biped__robot"):  # without skin lines: leaves would be ends
                lines = (DATA / f"{name}.rig.txt").read_text().splitlines(True)
                bare.append(Path(where) / f"{name}.rig.txt")
                bare[-1].write_text("".join(line for line in lines if not line.startswith("skin")))
            command("map", bare[0], "--from", bare[1], "-o", f"{where}/out.map")
            lines = [line.split() for line in Path(where, "out.map").read_text().splitlines() if not line.startswith("#")]
        expected = {line[0]: line[1] for line in lines if len(line) > 1 and line[1] != "-"}
        found = sinew.map(skeleton, other)
        self.assertEqual({skeleton.names[t]: other.names[s] for t, s in enumerate(found.sources) if s >= 0}, expected)
        self.assertGreater(len(expected), 10)
        pinned = sinew.map(skeleton, other, pins={"head": None, "hand.L": "hand.R"})
        self.assertEqual(pinned.sources[skeleton.index("head")], -1)
        self.assertEqual(pinned.sources[skeleton.index("hand.L")], other.index("hand.R"))


class Retarget(unittest.TestCase):
    def setUp(self):
        self.source, _ = character("biped__robot")
        self.target, _ = character("biped__robed")
        rotations, translations = self.source.skeleton.rest()
        frames = 20
        self.clip = sinew.Clip(np.tile(rotations, (frames, 1, 1)), np.tile(translations, (frames, 1, 1)), fps=24, name="wave")
        angle = np.sin(np.linspace(0, 6, frames))
        for name, axis in (("upper_arm.L", 2), ("forearm.R", 1), ("thigh.L", 0), ("head", 1)):
            turned = np.zeros((frames, 4), np.float32)
            turned[:, axis], turned[:, 3] = np.sin(angle / 2), np.cos(angle / 2)
            self.clip.rotations[:, self.source.skeleton.index(name)] = turned
        self.clip.translations[:, 0, 2] += np.linspace(0, 1, frames)

    def test_copy_is_the_commands(self):
        with folder() as where:
            self.source.clips = [self.clip]
            sinew.save(f"{where}/source.glb", self.source)
            sinew.save(f"{where}/target.glb", self.target)
            command("animate", f"{where}/target.glb", "--motion", f"{where}/source.glb", "--method", "copy", "-o", f"{where}/out.glb")
            expected = sinew.load(f"{where}/out.glb")
        found = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, method="copy")
        self.assertEqual(expected.skeleton.names, self.target.skeleton.names)
        np.testing.assert_allclose(np.abs((found.rotations * expected.clips[0].rotations).sum(2)), 1, atol=1e-4)
        np.testing.assert_allclose(found.translations, expected.clips[0].translations, atol=1e-4)
        arm = self.target.skeleton.index("upper_arm.L")
        self.assertGreater(np.ptp(found.rotations[:, arm], axis=0).max(), 0.3)

    def test_contacts_and_in_place(self):
        found = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, target_body=self.target)
        self.assertEqual(found.rotations.shape, (20, len(self.target.skeleton), 4))
        still = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, in_place=True)
        self.assertLess(np.ptp(still.translations[:, 0, 2]), 1e-4)
        spread = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, arm_spread=20)
        arms = [self.target.skeleton.index(f"upper_arm.{side}") for side in "LR"]
        copied = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton)
        changed = np.abs(spread.rotations - copied.rotations).max(axis=(0, 2))
        self.assertGreater(changed[arms].min(), 0.05)
        self.assertLess(np.delete(changed, arms).max(), 1e-5)
        with self.assertRaises(sinew.Cancelled):
            sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, progress=lambda share: share > 0.5)
        with self.assertRaisesRegex(ValueError, "target_body"):
            sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, method="contacts")
        with self.assertRaisesRegex(ValueError, "clip.rotations: expected [0-9]+ joints as the source has"):
            sinew.retarget(self.clip, read_character("snake__long")[2], self.target.skeleton)

    def test_stream(self):
        copied = sinew.retarget(self.clip, self.source.skeleton, self.target.skeleton, method="copy")
        skeletons = (self.source.skeleton, self.target.skeleton)
        stream = sinew.RetargetStream(*skeletons, fps=24, contacts=False, keep_range=False)
        for f in range(3):
            rotations, translations = stream.frame(self.clip.rotations[f], self.clip.translations[f])
            np.testing.assert_array_equal(rotations, copied.rotations[f])
            np.testing.assert_array_equal(translations, copied.translations[f])
        held = sinew.RetargetStream(*skeletons, target_body=self.target)
        first = [held.frame(self.clip.rotations[f], self.clip.translations[f]) for f in range(3)]
        held.restart()
        for f, (rotations, translations) in enumerate(first):
            again = held.frame(self.clip.rotations[f], self.clip.translations[f])
            np.testing.assert_array_equal(again[0], rotations)
            np.testing.assert_array_equal(again[1], translations)
        with self.assertRaisesRegex(ValueError, r"rotations: expected \[[0-9]+, 4\]"):
            held.frame(self.clip.rotations, self.clip.translations)
        moved = sinew.RetargetStream(*skeletons, target_body=self.target, source_body=self.target)  # the joints' numbers are alike
        self.assertEqual(moved.frame(self.clip.rotations[0], self.clip.translations[0])[0].shape, (len(self.target.skeleton), 4))
        with self.assertRaisesRegex(ValueError, "source_body: needs a target_body"):
            sinew.RetargetStream(*skeletons, source_body=self.target)
        with self.assertRaises(sinew.Error):
            sinew.RetargetStream(*skeletons, fps=0.1)


    def test_places_move_a_stream(self):
        keypoints = np.array([[0, .95, 0], [.1, .9, 0], [-.1, .9, 0], [0, 1.05, 0], [.1, .5, 0], [-.1, .5, 0], [0, 1.2, 0], [.1, .1, 0], [-.1, .1, 0], [0, 1.3, 0], [.1, .02, .1],
                           [-.1, .02, .1], [0, 1.5, 0], [.06, 1.4, 0], [-.06, 1.4, 0], [0, 1.6, 0], [.2, 1.4, 0], [-.2, 1.4, 0], [.5, 1.4, 0], [-.5, 1.4, 0], [.75, 1.4, 0],
                           [-.75, 1.4, 0]])
        raised = keypoints.copy()
        raised[[18, 20]] = [[.2, 1.7, 0], [.2, 1.95, 0]]
        with sinew.open_keypoints("humanml3d22", [keypoints, keypoints]) as person:
            still, lifted = person.keypoints_frame(keypoints), person.keypoints_frame(raised)
            np.testing.assert_allclose(np.linalg.norm(lifted[0], axis=1), 1, atol=1e-6)
            arm = person.skeleton.names.index("leftUpperArm")
            self.assertGreater(np.abs(lifted[0] - still[0])[arm].max(), 0.5)
            self.assertLess(np.abs(np.delete(lifted[0] - still[0], arm, 0)).max(), 1e-3)
            stream = sinew.RetargetStream(person.skeleton, self.target.skeleton, contacts=False)
            moved = [stream.frame(*frame)[0] for frame in (still, lifted)]
            self.assertGreater(np.abs(moved[1] - moved[0]).max(), 0.3)
            with self.assertRaisesRegex(sinew.Error, "expected 22 keypoints as humanml3d22 has, found 3"):
                person.keypoints_frame(keypoints[:3])
        with self.assertRaisesRegex(sinew.Error, "unknown layout 'h36m'"):
            sinew.open_keypoints("h36m", [keypoints])

    def test_springs_follow_a_stream(self):
        with sinew.open(DATA / "biped__robed.obj") as person:
            skeleton = person.skeleton
            parents = np.asarray(skeleton.parents)
            translations = skeleton.positions - np.where(parents[:, None] < 0, 0, skeleton.positions[parents])
            still = np.tile([0, 0, 0, 1], (len(skeleton), 1)).astype(np.float32)
            np.testing.assert_array_equal(person.springs_frame(0, still, translations), still)
            for _ in range(30):
                translations[parents < 0, 0] += 0.05
                swung = person.springs_frame(1 / 30, still, translations)
            tail = [name.startswith("tail") for name in skeleton.names]
            self.assertGreater(np.abs(swung - still)[tail].max(), 0.02)
            np.testing.assert_array_equal(swung[np.logical_not(tail)], still[np.logical_not(tail)])
            person.springs_restart()
            np.testing.assert_array_equal(person.springs_frame(1, still, translations), still)
            with self.assertRaises(ValueError):
                person.springs_frame(0, still[:2], translations)

    def test_chains_are_made(self):
        with sinew.open(DATA / "biped__caped.gltf") as bare:
            bare.rig(detail="hands")
            before = len(bare.skeleton)
            found = bare.springs(make=True)
            self.assertGreater(found.joint_count, 10)
            self.assertGreater(len(bare.skeleton), before + 10)


class TransferAndPoses(unittest.TestCase):
    def test_transfer_is_the_commands(self):
        source, rows = character("biped__robed")
        source.skin = as_the_command_reads(rows)
        positions = source.positions * [1.1, 0.95, 1.0]
        with folder() as where:
            lines = [f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in positions.astype(np.float32)]
            lines += ["f " + " ".join(str(v + 1) for v in f) + "\n" for f in source.faces]
            Path(where, "target.obj").write_text("".join(lines))
            bare = [line for line in (DATA / "biped__robed.rig.txt").read_text().splitlines(True) if not line.startswith("skin")]
            Path(where, "target.rig.txt").write_text("".join(bare))
            command("transfer", DATA / "biped__robed.obj", f"{where}/target.obj", "-o", f"{where}/out.rig.txt")
            _, expected = read_rig(f"{where}/out.rig.txt", len(positions))
        found = sinew.transfer(source, positions, source.faces)
        np.testing.assert_allclose(found.skin.dense(len(source.skeleton)), expected, atol=1e-6)
        self.assertGreater(found.carried, 0.1)
        self.assertEqual(sum(p.vertex_count for p in found.parts), len(positions))
        with self.assertRaisesRegex(ValueError, "source: has no skin"):
            sinew.transfer(sinew.Character(positions, source.faces), positions, source.faces)

    def test_deformer(self):
        one, _ = character("biped__robed")
        rotations, _ = one.skeleton.rest()
        bent = rotations.astype(np.float32)
        bent[one.skeleton.index("forearm.L")] = [0, np.sin(0.6), 0, np.cos(0.6)]
        matrices = one.skeleton.matrices(bent)
        dense = one.skin.dense(len(one.skeleton))
        blended = np.einsum("nj,jab->nab", dense, matrices)
        expected = np.einsum("nab,nb->na", blended[:, :, :3], one.positions) + blended[:, :, 3]
        linear = sinew.Deformer(one.positions, one.faces, one.skeleton, one.skin, method="linear").pose(matrices)
        np.testing.assert_allclose(linear, expected, atol=1e-5)
        for method in ("volume", "xpbd", "delta-mush", "dual-quaternion"):
            deformer = sinew.Deformer(one.positions, one.faces, one.skeleton, one.skin, method=method)
            np.testing.assert_allclose(deformer.pose(one.skeleton.matrices()), one.positions, atol=1e-4)
            out = np.empty((len(one.positions), 3), np.float32)
            self.assertIs(deformer.pose(matrices, out), out)
            self.assertGreater(np.abs(out - one.positions).max(), 0.05)
        with self.assertRaisesRegex(ValueError, "matrices: expected shape"):
            deformer.pose(matrices[:3])

    def test_poses_are_not_written_where_nothing_may_be(self):
        one, _ = character("snake__long")
        matrices = one.skeleton.matrices()
        for method in ("volume", "linear"):
            deformer = sinew.Deformer(one.positions, one.faces, one.skeleton, one.skin, method=method)
            with folder() as where:
                np.save(f"{where}/rest.npy", one.positions.astype(np.float32))
                on_disk = np.load(f"{where}/rest.npy", mmap_mode="r")
                frozen = np.zeros(on_disk.shape, np.float32)
                frozen.flags.writeable = False
                for out in (frozen, on_disk, frozen[:, ::-1], frozen.tolist()):
                    with self.assertRaisesRegex(ValueError, "out: expected"):
                        deformer.pose(matrices, out)
                self.assertFalse(frozen.any())
                del on_disk

    def test_body_contact(self):
        one, _ = character("biped__robed")
        rotations, _ = one.skeleton.rest()
        lowered = rotations.astype(np.float32)
        lowered[one.skeleton.index("upper_arm.L")] = [0, 0, -np.sin(0.57), np.cos(0.57)]
        matrices = one.skeleton.matrices(lowered)
        poses = [sinew.Deformer(one.positions, one.faces, one.skeleton, one.skin, body_contact=contact).pose(matrices)
                 for contact in (False, True)]
        self.assertGreater(np.abs(poses[0] - poses[1]).max(), 1e-3)


if __name__ == "__main__":
    unittest.main()
