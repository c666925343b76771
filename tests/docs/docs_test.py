#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""markdown.py, commands.py, words.py and guide.py find what they are for: on small trees that break each rule once."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import commands
import guide
import markdown
import pages
import words

FENCE = "```"
KNOWN = {
    "sinew": {(): ({"--help", "--version"}, ["rig", "bind"]), ("rig",): ({"--help", "-o", "--output", "--front"}, []), ("bind",): ({"--help", "--skeleton"}, [])},
    "sinew-lab": {(): ({"--help"}, ["eval", "train"]), ("eval",): ({"--help"}, ["weights", "rig"]), ("eval", "weights"): ({"--method"}, []), ("eval", "rig"): ({"--predictions"}, []), ("train",): ({"--val"}, [])},
}


class Docs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name) / "source"
        self.write("README.md", "# Top\n\n## Two words\n")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self, name, text, check):
        self.write(name, text)
        return check(self.root, pages.pages_of(self.root))[0]

    def test_links(self):
        for text in ("[a](../README.md) [b](../README.md#two-words) [c](#own) [d](https://example.com/x) `docs/a.md`\n\n# Own\n", f"{FENCE}\n[a](nowhere.md)\n{FENCE}\n", "`[a](nowhere.md)`\n"):
            self.assertEqual(self.faults("docs/a.md", text, markdown.check_links), [], text)
        for text in ("[a](nowhere.md)", "[a](../README.md#three-words)", "[a](#own)", "![a](none.png)", "`docs/none.md`"):
            self.assertRegex(self.faults("docs/a.md", "# A\n\n" + text + "\n", markdown.check_links)[0], r"^docs/a\.md:3: ", text)

    def test_lengths(self):
        self.assertEqual(self.faults("README.md", "a\n" * 70, markdown.check_lengths), [])
        self.assertEqual(len(self.faults("README.md", "a\n" * 71, markdown.check_lengths)), 1)
        self.write("README.md", "a\n")
        self.assertEqual(self.faults("engine/src/heat/README.md", "a\n" * 150, markdown.check_lengths), [])
        self.assertEqual(len(self.faults("engine/src/heat/README.md", "a\n" * 151, markdown.check_lengths)), 1)
        self.write("engine/src/heat/README.md", "a\n")
        self.assertEqual(len(self.faults("docs/guide.md", "a\n" * 81, markdown.check_lengths)), 1)
        self.write("docs/guide.md", "a\n")
        long = "word " * 40
        self.assertEqual(self.faults("docs/b.md", f"| {long}|\n\n{FENCE}\n{long}\n{FENCE}\n\n    {long}\n", markdown.check_lengths), [])
        self.assertEqual(len(self.faults("docs/b.md", long + "\n", markdown.check_lengths)), 1)

    def test_commands(self):
        for text in (
            f"{FENCE}sh\nsinew rig a.obj --front +z -o a.glb   # --no-comment\nsinew-lab eval DIR --method heat | sort --reverse\n{FENCE}\n",
            "    build/release/sinew bind a.obj --skeleton b.txt\n",
            "`sinew COMMAND --help-me`, `sinew rig\n--front +z`, `sinew-lab eval rig DIR --predictions P`, `sinew --version`, `sinew::bind()`\n",
            f"{FENCE}c\nsinew frobs --none;\n{FENCE}\n",
            "| `--front +z\\|-z` | sinew is a word |\n",
        ):
            self.assertEqual(self.found(text), [], text)
        for text, fault in (
            (f"{FENCE}sh\n\nsinew rig a.obj \\\n  --none\n{FENCE}\n", "3: sinew rig has no option --none"),
            ("    sinew frob a.obj\n", "1: sinew frob: no such command"),
            ("`sinew bind a.obj --front +z`\n", "1: sinew bind has no option --front"),
            ("`sinew-lab eval DIR --predictions P`\n", "1: sinew-lab eval weights has no option --predictions"),
            ("text\n`sinew\nrig --none`\n", "2: sinew rig has no option --none"),
            ("or `--none` alone\n", "1: no program has an option --none"),
        ):
            self.assertEqual(self.found(text), ["docs/c.md:" + fault], text)

    def found(self, text):
        return self.faults("docs/c.md", text, lambda root, all_pages: commands.check_commands(root, all_pages, KNOWN))

    def test_words(self):
        good = "/* The position of a joint; a warning is given.\n * Rotations are local. */\nint turned;  // one line each\n"
        self.assertEqual(self.faults("formats/include/b.hpp", good, lambda root, _: words.check_headers(root)), [])
        for text, fault in (
            ("/* The user is told. */", "1: 'told'"),
            ("/* A joint that\n * hangs on another. */", "2: 'hangs on'"),
            ("int a;\n// The rest is looked\n// at later.", "2: 'looked at'"),
            ("// This is now a warning.", "1: 'is now'"),
        ):
            self.assertIn("engine/include/sinew/a.h:" + fault, self.faults("engine/include/sinew/a.h", text + "\n", lambda root, _: words.check_headers(root))[0], text)
        for text, count in (('fail("a frame rate", "none");', 0), ('throw Error("which way is " "up");', 1), ('f("a way", "/*");  // told\n', 0), ('f("100 frames "\n  "a second");', 1)):
            self.assertEqual(len(self.faults("samples/cli/c.cpp", text + "\n", lambda root, _: words.check_messages(root))), count, text)
        for text, count in (("Weights are now exact, as before.", 2), ("It is now exact.", 1), ("It no longer fails.", 1), ("A tool is used to draw.", 0), ("`is now`", 0)):
            self.assertEqual(len(self.faults("docs/d.md", text + "\n", lambda root, _: words.check_pages(root))), count, text)
        for text, count in (("colors, neighbors and 3 meters", 0), ("a neighbour", 1), ("kNeighbours", 1), ("quantising", 1), ("a promise, an analysis, a likeness", 0), ("learnt_poses", 0)):
            self.assertEqual(len(self.faults("engine/src/e.cpp", text + "\n", lambda root, _: words.check_spelling(root))), count, text)
        screens = {("sinew",): "a\n" * 40, ("sinew", "rig"): "a\n" * 41, ("sinew", "bind"): "a" * 101 + "\n"}
        found = words.check_help(list(screens), screens.get)[0]
        self.assertEqual([fault[:fault.index(":")] for fault in found], ["sinew rig --help", "sinew bind --help"])

    def guide_ends(self, text):
        """The status of a guide, and what it said."""
        self.write("docs/guide.md", text)
        build = self.root.parent / "build"
        build.mkdir(exist_ok=True)
        program = build / "sinew"
        program.write_text('#!/bin/sh\n[ "$1" = --fail ] && exit 3\n[ "$2" = -o ] && echo written >"$3"\nexit 0\n')
        program.chmod(0o755)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = guide.run_guide(self.root, build, "docs/guide.md", self.root.parent / "work")
        return status, said.getvalue()

    def test_guides(self):
        self.assertEqual(self.guide_ends(f"{FENCE}sh\nsinew rig -o a.glb\nbuild/release/sinew x\ntest -s README.md\n{FENCE}\n\n    false\n\n{FENCE}c a.c\nint a;\n{FENCE}\n\n{FENCE}sh\ngrep -q 'int a' a.c\n{FENCE}\n")[0], 0)
        self.assertEqual(self.guide_ends(f"{FENCE}sh\ntrue\n{FENCE}\n\n{FENCE}sh\nsinew --fail\n{FENCE}\n")[0], 1)
        self.assertEqual(self.guide_ends(f"{FENCE}sh\nfalse | true\n{FENCE}\n")[0], 1)
        status, said = self.guide_ends(f"{FENCE}sh\nsinew rig --png none.png -o a.glb\n{FENCE}\n")
        self.assertEqual(status, 1)
        self.assertIn("none.png was not written", said)
        self.assertEqual(self.guide_ends("    sinew rig -o a.glb\n")[0], 1)


if __name__ == "__main__":
    unittest.main()
