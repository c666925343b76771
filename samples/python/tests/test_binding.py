# SPDX-License-Identifier: MIT
"""Declarations against headers, C compiler and library; types of the signatures; what is said when library or models are missing."""
import ctypes
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

import sinew
from sinew import declarations

from common import DATA, ROOT, folder


class Declarations(unittest.TestCase):
    def test_they_are_what_the_headers_say(self):
        done = subprocess.run([ROOT / "scripts" / "declarations.py", "--check"], capture_output=True, text=True, check=False)
        if done.returncode == 77:
            self.skipTest(done.stderr.strip())
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_sizes_and_offsets_are_those_of_c(self):
        compiler = shutil.which(os.environ.get("CC", "cc"))
        if compiler is None:
            self.skipTest("SKIPPED, no C compiler")
        structs = {s.__name__: s for s in declarations.STRUCTS + declarations.CHARACTER_STRUCTS}
        self.assertGreater(len(structs), 40)
        lines, expected = [], []
        for name, struct in structs.items():
            lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for field, _ in struct._fields_:
                lines.append(f'printf("{name}.{field} %zu %zu\\n", offsetof({name}, {field}), sizeof((({name}*)0)->{field}));')
                one = getattr(struct, field)
                expected.append(f"{name}.{field} {one.offset} {one.size}")
        folders = [ROOT / "engine" / "include", ROOT / "character" / "include"]
        headers = [h for f in folders for h in sorted((f / "sinew").glob("*.h"))]
        with folder() as where:
            source = Path(where) / "sizes.c"
            source.write_text("#include <stddef.h>\n#include <stdio.h>\n" + "".join(f'#include "{h}"\n' for h in headers) +
                              "int main(void) {\n" + "\n".join(lines) + "\nreturn 0;\n}\n")
            subprocess.run([compiler, *(f"-I{f}" for f in folders), source, "-o", Path(where) / "sizes"], check=True)
            found = subprocess.run([Path(where) / "sizes"], capture_output=True, text=True, check=True).stdout.split("\n")
        self.assertEqual(found[:-1], expected)

    def test_words(self):
        self.assertEqual(sinew.ANSWERS[0], "proposed")
        self.assertIn("delta-mush", declarations.DEFORM_METHOD)
        self.assertIn("contacts", declarations.ANIMATE_METHOD)
        self.assertEqual(sinew.CLASSES.index("prop"), 26)

    def test_a_library_with_other_structs_is_refused(self):
        code = """if True:
            import ctypes
            from sinew import binding, declarations
            class sinew_mesh(ctypes.Structure):
                _fields_ = [("positions", ctypes.c_void_p)]
            declarations.STRUCTS = (sinew_mesh,)
            binding.library()"""
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
        self.assertRegex(done.stderr.strip().split("\n")[-1], "sinew_mesh has [0-9]+ bytes, this package was made for 8; install library and package of one build")


class Types(unittest.TestCase):
    def test_words_are_checked_by_mypy(self):
        if shutil.which("mypy") is None:
            self.skipTest("SKIPPED, no mypy (Debian: mypy)")
        code = """import numpy as np
import sinew
skeleton = sinew.Skeleton(np.zeros((2, 3)), np.array([-1, 0]))
skin = sinew.bind([[0, 0, 0]], None, skeleton, method="heat", rigid_parts="never", up="z")
sinew.Deformer([[0, 0, 0]], None, skeleton, skin, method="delta-mush")
hero = sinew.open("hero.glb")
hero.bind(joints="own")
hero.retarget(sinew.open("walk.bvh"), method="contacts", motion_up="z")
"""
        wrong = [('method="heat"', 'method="heat "'), ('rigid_parts="never"', 'rigid_parts="no"'), ('up="z")', 'up="x")'),
                 ('"delta-mush"', '"delta mush"'), ('joints="own"', 'joints="mine"'), ('"contacts"', '"feet"')]
        lines = code.splitlines()
        for right, one in wrong:
            lines.append(next(line for line in code.splitlines() if right in line).replace(right, one, 1))
        package = Path(sinew.__file__).resolve().parent
        with folder() as where:
            Path(where, "user.py").write_text("\n".join(lines) + "\n")
            done = subprocess.run(["mypy", "--python-version", "3.8", "--follow-imports", "silent", "--no-error-summary", "--cache-dir", f"{where}/cache",
                                   "user.py"], cwd=where, env={**os.environ, "MYPYPATH": str(package.parent)}, capture_output=True, text=True, check=False)
        found = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error: " in line}
        self.assertEqual(found, set(range(len(code.splitlines()) + 1, len(lines) + 1)), done.stdout)


    def test_package_and_readme_are_strict(self):
        if shutil.which("mypy") is None:
            self.skipTest("SKIPPED, no mypy (Debian: mypy)")
        package = Path(sinew.__file__).resolve().parent
        example = (ROOT / "samples" / "python" / "README.md").read_text(encoding="utf-8").split("```python\n")[1].split("```")[0]
        with folder() as where:
            Path(where, "example.py").write_text(example, encoding="utf-8")
            done = subprocess.run(["mypy", "--strict", "--no-error-summary", "--cache-dir", f"{where}/cache", str(package), "example.py"],
                                  cwd=where, env={**os.environ, "MYPYPATH": str(package.parent)}, capture_output=True, text=True, check=False)
        self.assertEqual(done.stdout + done.stderr, "")

    def test_reprs_say_what_a_thing_is(self):
        skeleton = sinew.Skeleton([[0, 0, 0], [0, 1, 0]], [-1, 0], ["root", "tip"])
        self.assertEqual(repr(skeleton), "<sinew.Skeleton: 2 joints, 'root' to 'tip'>")
        self.assertEqual(repr(sinew.Skin([[0, 1]], [[255, 0]])), "<sinew.Skin: 1 vertices, 2 influences, float32>")
        character = sinew.Character(np.zeros((3, 3)), [[0, 1, 2]], skeleton, name="hero")
        self.assertEqual(repr(character), "<sinew.Character 'hero': 3 vertices, 2 joints, no weights, 0 clips>")


class Missing(unittest.TestCase):
    def says(self, code, **environment):
        done = subprocess.run([sys.executable, "-c", code], env={**os.environ, **environment}, capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        return done.stderr.strip().split("\n")[-1]

    def test_library(self):
        load = "import sinew; sinew.Model(b'')"
        self.assertIn("SINEW_LIBRARY=/no/library: no such file", self.says(load, SINEW_LIBRARY="/no/library"))
        self.assertIn("cannot load the engine's library", self.says(load, SINEW_LIBRARY=str(DATA / "biped__robed.obj")))

    def test_model(self):
        with self.assertRaisesRegex(sinew.Error, "none.sinew: cannot read the model"):
            sinew.Model("none.sinew")
        with self.assertRaisesRegex(sinew.Error, "not a sinew model"):
            sinew.Model(str(DATA / "biped__robed.obj"))
        with self.assertRaisesRegex(sinew.Error, "another task"):
            sinew.rig([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], model=sinew.Model(DATA / "sinew_default.sinew"))


if __name__ == "__main__":
    unittest.main()
