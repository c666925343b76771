# SPDX-License-Identifier: MIT
"""open_picture(): drawings through the package and through the command, and the same bytes; outlines; what a caller may get wrong."""
import unittest
from pathlib import Path

import numpy as np

import sinew

from common import DATA, command, folder

CHILD, CAT = DATA / "drawing__child.png", DATA / "drawing__cat.png"


class Pictures(unittest.TestCase):
    def setUp(self):
        holder = folder()
        self.addCleanup(holder.cleanup)
        self.where = Path(holder.name)

    def assertCommand(self, one, *arguments):
        command(*arguments, "-o", self.where / "theirs.glb")
        self.assertEqual(one.write("theirs.glb")["theirs.glb"], (self.where / "theirs.glb").read_bytes())

    def test_the_commands_bytes(self):
        with sinew.open(CHILD) as child:
            self.assertEqual((child.picture.body_class, child.picture.certainty), ("found", 0))
            done = child.retarget()
            self.assertTrue(done.rigged)
            self.assertEqual((child.picture.body_class, child.picture.view), ("biped", "front"))
            self.assertCommand(child, "animate", CHILD)
        with sinew.open_picture(CAT.read_bytes(), name="drawing__cat.png", flat=True, units="pixels", body_class="quadruped") as cat:
            cat.rig()
            self.assertCommand(cat, "rig", CAT, "--flat", "--units", "pixels", "--class", "quadruped")

    def test_outlines(self):
        with sinew.open(CHILD) as child:
            found = child.picture
        self.assertEqual((found.width, found.figure, found.figure_count), (360, 1, 1))
        lines = [np.maximum(line, [180, 0]) for line in found.outline]
        with sinew.open_picture(CHILD, outline=found.outline, units="pixels") as whole, sinew.open_picture(CHILD, outline=lines, units="pixels") as half:
            self.assertAlmostEqual(np.ptp(half.positions[:, 0]) / np.ptp(whole.positions[:, 0]), 0.5, delta=0.03)

    def test_mistakes(self):
        with self.assertRaisesRegex(sinew.Error, "no figure 2"):
            sinew.open_picture(CHILD, figure=2)
        with self.assertRaisesRegex(ValueError, "body_class"):
            sinew.open_picture(CHILD, body_class="bear")
        with self.assertRaisesRegex(sinew.Error, "three positions"):
            sinew.open_picture(CHILD, outline=[[[0, 0], [9, 9]]])
        with sinew.open(DATA / "snake__long.obj") as snake:
            with self.assertRaisesRegex(sinew.Error, "not of a picture"):
                snake.picture
            with self.assertRaises(sinew.Error):
                snake.retarget()


if __name__ == "__main__":
    unittest.main()
