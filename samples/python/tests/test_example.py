# SPDX-License-Identifier: MIT
"""The example as a whole: it draws pictures, and they are not empty."""
import os
import subprocess
import sys
import unittest
from pathlib import Path

from common import DATA, ROOT, folder


class Example(unittest.TestCase):
    def test_it_draws(self):
        try:
            import matplotlib.image
        except ImportError:
            self.skipTest("SKIPPED, no matplotlib (Debian: python3-matplotlib)")
        with folder() as where:
            kept = os.environ.get("SINEW_PICTURES", where)
            done = subprocess.run([sys.executable, ROOT / "samples" / "python" / "examples" / "bind_and_pose.py", DATA / "biped__caped.gltf", kept],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            for name in ("skeletons", "weights", "pose"):
                picture = matplotlib.image.imread(Path(kept, f"{name}.png"))[:, :, :3]
                self.assertGreater((picture < 0.97).any(2).mean(), 0.05, name)
            self.assertTrue(Path(kept, "biped__caped.bound.glb").is_file())


if __name__ == "__main__":
    unittest.main()
