# SPDX-License-Identifier: MIT
"""bind(): the command's bytes, every option, wrong arguments."""
import signal
import threading
import time
import unittest
from types import SimpleNamespace

import numpy as np

import sinew

from common import CHARACTERS, DATA, command, fnv, folder, read_character, read_rig

TRIANGLE = ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])


class SameAsCommand(unittest.TestCase):
    def compare(self, name, options, **arguments):
        positions, faces, skeleton, _ = read_character(name)
        with folder() as where:
            told = command("bind", DATA / f"{name}.obj", "--skeleton", DATA / f"{name}.rig.txt", "--joints", "all", "--keep-tips", "--no-seams",
                           "-o", f"{where}/out.rig.txt", "--json", *options)
            _, rows = read_rig(f"{where}/out.rig.txt", len(positions))
        skin = sinew.bind(positions, faces, skeleton, **arguments)
        self.assertEqual(fnv(skin), told["hash"])
        np.testing.assert_allclose(skin.dense(len(skeleton)), rows, atol=1e-6)
        return skin

    def test_every_character(self):
        for name in CHARACTERS:
            with self.subTest(name):
                self.compare(name, [])

    def test_options(self):
        self.compare("biped__robed", ["--method", "heat"], method="heat")
        self.compare("biped__robed", ["--influences", "8"], influences=8)
        self.compare("biped__robed", ["--symmetric", "--softness", "2"], symmetric=True, softness=2)
        self.compare("biped__robot", ["--rigid-parts", "always"], rigid_parts="always")
        self.compare("biped__robot", ["--threads", "3"], threads=3)

    def test_answers(self):
        positions, faces, skeleton, _ = read_character("biped__robed")
        asked = sinew.bind(positions, faces, skeleton, questions=3)
        self.assertEqual(len(asked.questions), 3)
        question = asked.questions[0]
        self.assertGreater(len(question.alternatives), 0)
        self.compare("biped__robed", ["--answer", f"{question.vertex}=rigid:head"], answers=[(question.vertex, "rigid", "head")])
        self.compare("biped__robed", ["--answer", f"{question.vertex}=soft"], answers=[(question.vertex, "soft")])


class Style(unittest.TestCase):
    def test_answers_of_a_style_file_are_the_commands(self):
        positions, faces, skeleton, _ = read_character("biped__robed")
        asked = sinew.bind(positions, faces, skeleton, questions=6)
        said = [f"{q.vertex}={'rigid:' + skeleton.names[a.joint] if a.kind == 'rigid' else a.kind}"
                for q in asked.questions for a in q.alternatives[:1]]
        options = ["--skeleton", DATA / "biped__robed.rig.txt", "--joints", "all", "--keep-tips"]
        with folder() as where:
            answers = [word for one in said for word in ("--answer", one)]
            command("bind", DATA / "biped__robed.obj", *options, *answers, "--save-style", f"{where}/a.style", "-o", f"{where}/a.rig.txt")
            other = (positions * [1.05, 1, 0.97]).astype(np.float32)
            with open(f"{where}/b.obj", "w", encoding="utf-8") as obj:
                obj.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in other)
                obj.writelines("f " + " ".join(str(v + 1) for v in f) + "\n" for f in faces)
            told = command("bind", f"{where}/b.obj", *options, "--style", f"{where}/a.style", "-o", f"{where}/b.rig.txt", "--json")
            proposed = sinew.bind(other, faces, skeleton, questions=sinew.binding.MAX_QUESTIONS)
            found = sinew.answers_by_style(f"{where}/a.style", other, skeleton, proposed)
            self.assertGreater(len(found), 0)
            self.assertEqual(fnv(sinew.bind(other, faces, skeleton, answers=found)), told["hash"])
            self.assertNotEqual(fnv(proposed), told["hash"])
            snake = read_character("snake__long")
            asked = sinew.bind(*snake[:3], questions=8)
            self.assertEqual(sinew.answers_by_style(f"{where}/a.style", snake[0], snake[2], asked), [])
            for text in ("", "{}", '{"sinew_style": 2}', '{"sinew_style": 1, "characters": [3]}'):
                with open(f"{where}/bad.style", "w", encoding="utf-8") as bad:
                    bad.write(text)
                with self.assertRaisesRegex(sinew.Error, "bad.style: "):
                    sinew.answers_by_style(f"{where}/bad.style", other, skeleton, proposed)
        with self.assertRaisesRegex(sinew.Error, "none.style: cannot read"):
            sinew.answers_by_style("none.style", other, skeleton, proposed)


class Faces(unittest.TestCase):
    def setUp(self):
        self.positions, self.ragged, self.skeleton, _ = read_character("biped__robed")
        self.triangles = np.array([[f[0], f[i], f[i + 1]] for f in self.ragged for i in range(1, len(f) - 1)])
        self.expected = sinew.bind(self.positions, self.ragged, self.skeleton)

    def same(self, faces, positions=None):
        skin = sinew.bind(self.positions if positions is None else positions, faces, self.skeleton)
        np.testing.assert_array_equal(skin.joints, self.expected.joints)
        np.testing.assert_array_equal(skin.weights, self.expected.weights)

    def test_forms(self):
        self.same(self.triangles)
        self.same(self.triangles.astype(np.uint32))
        self.same(self.triangles.tolist())
        self.same(np.array([np.array(f) for f in self.ragged] + [None], object)[:-1])
        half = len(self.triangles) // 2
        self.same([self.triangles[:half], self.triangles[half:]])
        self.same(self.triangles, np.asfortranarray(self.positions))

    def test_quads(self):
        x, y = np.meshgrid(np.arange(8.0), np.arange(5.0))
        positions = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], 1)
        quads = np.array([[r * 8 + c, r * 8 + c + 1, r * 8 + c + 9, r * 8 + c + 8] for r in range(4) for c in range(7)])
        skeleton = sinew.Skeleton([[0, 2, 0], [4, 2, 0]], [-1, 0])
        triangles = quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
        one, two = (sinew.bind(positions, f, skeleton, method="heat") for f in (quads, triangles))
        np.testing.assert_array_equal(one.joints, two.joints)
        mixed = [SimpleNamespace(type="line", data=np.array([[0, 1]])), SimpleNamespace(type="quad", data=quads[:10]),
                 SimpleNamespace(type="triangle", data=triangles[20:])]
        three = sinew.bind(positions, mixed, skeleton, method="heat")
        np.testing.assert_array_equal(one.joints, three.joints)

    def test_meshio(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("SKIPPED, no meshio (Debian: python3-meshio)")
        mesh = meshio.Mesh(self.positions, [("triangle", self.triangles)])
        self.same(mesh.cells, mesh.points)
        self.same(mesh.cells_dict, mesh.points)


class Options(unittest.TestCase):
    def setUp(self):
        self.positions, self.faces, self.skeleton, self.rows = read_character("biped__robed")

    def test_joints(self):
        skin = sinew.bind(self.positions, self.faces, self.skeleton, never=["head", 3])
        self.assertFalse(np.isin(skin.joints[skin.weights > 0], [3, self.skeleton.index("head")]).any())
        skin = sinew.bind(self.positions, self.faces, self.skeleton, deform=["hips", "head"])
        self.assertEqual(set(skin.joints[skin.weights > 0]), {0, self.skeleton.index("head")})

    def test_locked_rows_stay(self):
        before = sinew.bind(self.positions, self.faces, self.skeleton, method="heat", weight_format="unorm8")
        some = np.zeros(len(self.positions), bool)
        some[::3] = True
        after = sinew.bind(self.positions, self.faces, self.skeleton, locked=some, given=before, weight_format="unorm8")
        np.testing.assert_array_equal(after.joints[some], before.joints[some])
        np.testing.assert_array_equal(after.weights[some], before.weights[some])
        self.assertTrue((after.weights[~some] != before.weights[~some]).any())

    def test_hints_bring_the_rest_nearer(self):
        plain = sinew.bind(self.positions, self.faces, self.skeleton, method="heat")
        hints = np.arange(0, len(self.positions), 20)
        hinted = sinew.bind(self.positions, self.faces, self.skeleton, method="heat", hints=hints, given=self.rows)
        far = [np.abs(s.dense(len(self.skeleton)) - self.rows).sum(1).mean() for s in (plain, hinted)]
        self.assertLess(far[1], far[0])

    def test_formats(self):
        for name, dtype, total in (("unorm16", np.uint16, 65535), ("unorm8", np.uint8, 255), ("float", np.float32, 1)):
            skin = sinew.bind(self.positions, self.faces, self.skeleton, weight_format=name)
            self.assertEqual(skin.weights.dtype, dtype)
            np.testing.assert_allclose(skin.weights.astype(np.float64).sum(1), total, rtol=1e-6)

    def test_progress_stops_and_raises(self):
        seen = []
        sinew.bind(self.positions, self.faces, self.skeleton, progress=lambda share: seen.append(share))
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1)
        with self.assertRaises(sinew.Cancelled):
            sinew.bind(self.positions, self.faces, self.skeleton, progress=lambda share: share > 0.3)

        def interrupt(_):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            sinew.bind(self.positions, self.faces, self.skeleton, progress=interrupt)

    def test_masks_of_uint8_are_masks(self):
        before = sinew.bind(self.positions, self.faces, self.skeleton, method="heat")
        for some in (np.arange(len(self.positions)) % 3 == 0, np.ones(len(self.positions), bool)):
            one, two, three = (sinew.bind(self.positions, self.faces, self.skeleton, locked=mask, given=before)
                               for mask in (some, some.astype(np.uint8), 255 * some.astype(np.uint8)))
            for other in (two, three):
                np.testing.assert_array_equal(one.joints, other.joints)
                np.testing.assert_array_equal(one.weights, other.weights)
        with self.assertRaisesRegex(ValueError, "locked: a mask of uint8, expected shape"):
            sinew.bind(self.positions, self.faces, self.skeleton, locked=np.array([0, 3], np.uint8), given=before)

    def test_ctrl_c_is_a_keyboard_interrupt(self):
        """Wherever it arrives: 40 times, later and later, at loops that go on after errors of the library."""
        for i in range(40):
            once = threading.Timer(0.0007 * i, signal.raise_signal, (signal.SIGINT,))
            self.addCleanup(once.cancel)  # a failure here is none of the next test's
            end = time.monotonic() + 5
            with self.assertRaises(KeyboardInterrupt, msg=f"time {i}"):
                once.start()
                while time.monotonic() < end:
                    try:
                        sinew.bind(self.positions, self.faces, self.skeleton, method="heat", threads=1 + i % 2,
                                   progress=(lambda share: None) if i % 3 else None)
                    except sinew.Error as error:
                        raise AssertionError(f"swallowed: {type(error).__name__}: {error}") from None
            once.join()
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_calls_run_beside_each_other(self):
        expected, found = sinew.bind(self.positions, self.faces, self.skeleton), [None] * 4

        def work(i):
            found[i] = sinew.bind(self.positions, self.faces, self.skeleton, threads=2)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for one in threads:
            one.start()
        for one in threads:
            one.join()
        for skin in found:
            np.testing.assert_array_equal(skin.weights, expected.weights)


class Wrong(unittest.TestCase):
    def says(self, text, *arguments, **options):
        skeleton = options.pop("skeleton", sinew.Skeleton([[0, 0, 0], [1, 1, 0]], [-1, 0]))
        with self.assertRaisesRegex((ValueError, sinew.Error), text):
            sinew.bind(*arguments, skeleton, **options)

    def test_arguments_are_named(self):
        positions, faces = TRIANGLE
        self.says(r"positions: expected shape \(n, 3\), found \(3, 2\)", np.zeros((3, 2)), faces)
        self.says(r"positions: element \(1, 0\) is NaN", [[0, 0, 0], [np.nan, 0, 0], [0, 1, 0]], faces)
        self.says("positions: expected numbers", [["a", "b", "c"]], faces)
        self.says("faces: expected 0 to 2, found 3", positions, [[0, 1, 3]])
        self.says("faces: expected 0 to 2, found -1", positions, [[0, 1, -1]])
        self.says("faces: expected integers, found float64", positions, [[0.0, 1.0, 2.0]])
        self.says("faces: expected at least 3 corners", positions, [[0, 1]])
        self.says("cells of type tetra are no surface", positions, {"tetra": [[0, 1, 2, 2]]})
        self.says("method: expected one of model, heat", positions, faces, method="magic")
        self.says("influences: expected 1 to 12", positions, faces, influences=13)
        self.says("never: the skeleton has no joint 'tail'", positions, faces, never=["tail"])
        self.says(r"locked: a mask of bool, expected shape \(3,\)", positions, faces, locked=[True])
        self.says("given: expected a Skin", positions, faces, locked=[0])
        self.says(r"given: expected shape \(3, 2\)", positions, faces, locked=[0], given=np.zeros((3, 5)))
        self.says(r"answers\[0\]", positions, faces, answers=[(0, "rigid")])
        self.says("threads: expected 1 to 64", positions, faces, threads=0)
        self.says("bind: every joint", positions, faces, never=[0, 1])

    def test_skeleton(self):
        with self.assertRaisesRegex(ValueError, r"skeleton.parents: expected shape \(2,\)"):
            sinew.Skeleton([[0, 0, 0], [1, 1, 0]], [-1])
        with self.assertRaisesRegex(ValueError, "skeleton.parents: expected -1 to 1, found 2"):
            sinew.Skeleton([[0, 0, 0], [1, 1, 0]], [-1, 2])
        with self.assertRaisesRegex(ValueError, "skeleton.names: expected 2 names"):
            sinew.Skeleton([[0, 0, 0], [1, 1, 0]], [-1, 0], ["one"])
        self.says("cycle", *TRIANGLE, skeleton=sinew.Skeleton([[0, 0, 0], [1, 1, 0]], [1, 0]))


if __name__ == "__main__":
    unittest.main()
