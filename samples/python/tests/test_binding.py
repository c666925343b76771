# SPDX-License-Identifier: MIT
"""Structs against the C compiler; what is said when library or models are missing."""
import ctypes
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import sinew
from sinew import binding

from common import DATA, ROOT, folder


class Structs(unittest.TestCase):
    def test_sizes_and_offsets_are_those_of_c(self):
        compiler = shutil.which(os.environ.get("CC", "cc"))
        if compiler is None:
            self.skipTest("SKIPPED, no C compiler")
        structs = {n: c for n, c in vars(binding).items() if n.startswith("sinew_") and isinstance(c, type)}
        self.assertGreater(len(structs), 20)
        lines, expected = [], []
        for name, struct in structs.items():
            lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for field, _ in struct._fields_:
                lines.append(f'printf("{name}.{field} %zu %zu\\n", offsetof({name}, {field}), sizeof((({name}*)0)->{field}));')
                one = getattr(struct, field)
                expected.append(f"{name}.{field} {one.offset} {one.size}")
        with folder() as where:
            source = Path(where) / "sizes.c"
            source.write_text("#include <stddef.h>\n#include <stdio.h>\n#include \"sinew/sinew.h\"\nint main(void) {\n" +
                              "\n".join(lines) + "\nreturn 0;\n}\n")
            subprocess.run([compiler, "-I", ROOT / "engine" / "include", source, "-o", Path(where) / "sizes"], check=True)
            found = subprocess.run([Path(where) / "sizes"], capture_output=True, text=True, check=True).stdout.split("\n")
        self.assertEqual(found[:-1], expected)

    def test_constants_are_those_of_c(self):
        text = "".join(p.read_text() for p in (ROOT / "engine" / "include" / "sinew").glob("*.h"))
        for name in ("MAX_INFLUENCES", "MAX_RIG_JOINTS", "MAX_QUESTIONS", "MAX_ALTERNATIVES", "MAX_THREADS", "WORKSPACE_ALIGNMENT",
                     "JOINT_NAME_BYTES", "JOINT_NEVER", "JOINT_DEFORMS"):
            self.assertIn(f"#define SINEW_{name} {getattr(binding, name)}u", text)
        for i, name in enumerate(sinew.CLASSES):
            if name:
                self.assertIn(f"SINEW_CLASS_{name.upper()} = {i}", text)


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
