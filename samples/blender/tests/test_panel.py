# SPDX-License-Identifier: MIT
"""The tab: the page's five steps and words, one main button a step, ticks; Check the Rig, headless."""
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np

from blender_common import SOURCE, character, clear, run, select, sinew_blender

panel = sinew_blender.panel
PAGE = open(os.path.join(SOURCE, "samples", "web", "src", "index.html"), encoding="utf8").read()


class Drawn:
    """A layout that keeps what is drawn."""

    def __init__(self, into=None):
        object.__setattr__(self, "into", {"operators": [], "labels": [], "ticks": []} if into is None else into)

    def __setattr__(self, name, value):
        pass

    def column(self, **_):
        return Drawn(self.into)

    row = box = column

    def operator(self, name, text=None, **_):
        self.into["operators"].append((name, text))
        return Drawn(self.into)

    def label(self, text="", **_):
        self.into["labels"].append(text)

    def prop_enum(self, _data, _name, value, text="", icon=""):
        self.into["ticks"].append((value, text, icon == "CHECKMARK"))

    def prop(self, *_, **__):
        pass

    prop_search = prop


def drawn(step):
    bpy.context.window_manager.sinew_step = step
    layout = Drawn()

    class Panel:
        pass

    one = Panel()
    one.layout = layout
    panel.SINEW_PT_tab.draw(one, bpy.context)
    return layout.into


class Tab(unittest.TestCase):
    def setUp(self):
        clear()

    def test_the_pages_steps_and_words(self):
        rail = re.search(r'<nav id="rail".*?</nav>', PAGE, re.S).group(0)
        self.assertEqual(tuple(re.findall(r"<b>(\w+)</b>", rail)), panel.STEPS)
        self.assertEqual([word for word, _, _ in drawn("Mesh")["ticks"]], list(panel.STEPS))
        words = {word for step in panel.STEPS for _, word in drawn(step)["operators"] if word}
        for word in ("New Skeleton", "Doubt", "Bends", "Map", "GLB", "FBX"):
            self.assertIn(word, words)
            self.assertRegex(PAGE, re.compile(rf">\s*{word}\b", re.I), word)

    def test_every_button_is_there_in_one_step(self):
        seen = {}
        for step in panel.STEPS:
            for name, _ in drawn(step)["operators"]:
                module, word = name.split(".")
                self.assertIn(word, dir(getattr(bpy.ops, module)), name)
                self.assertEqual(seen.setdefault(name, step), step, name)
        for name, step in (("sinew.rig", "Skeleton"), ("sinew.controls", "Skeleton"), ("sinew.bind", "Weights"), ("sinew.transfer", "Weights"),
                           ("sinew.look", "Weights"), ("sinew.correct", "Weights"), ("sinew.retarget", "Motion"), ("sinew.map_bones", "Motion"),
                           ("sinew.check", "Export")):
            self.assertEqual(seen[name], step)
        self.assertFalse(drawn("Mesh")["operators"])

    def test_ticks_and_sentences_follow_the_work(self):
        done = lambda: [word for word, _, tick in drawn("Mesh")["ticks"] if tick]  # noqa: E731
        self.assertEqual(done(), [])
        self.assertIn("Select the meshes of a character.", drawn("Mesh")["labels"])
        item, armature, _, _ = character()
        select([item], item)
        self.assertEqual(done(), ["Mesh"])
        self.assertIn("No joints yet.", drawn("Skeleton")["labels"])
        select([item, armature], armature)
        self.assertEqual(done(), ["Mesh", "Skeleton"])
        self.assertIn("Not bound yet.", drawn("Weights")["labels"])
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        self.assertEqual(done(), ["Mesh", "Skeleton", "Weights"])
        self.assertIn("Bound, no part in doubt.", drawn("Weights")["labels"])
        self.assertIn(f"{len(item.data.vertices):,} vertices", drawn("Mesh")["labels"][0])
        self.assertEqual(bpy.ops.sinew.controls(), {"FINISHED"})
        self.assertIn("sinew.bake_controls", [name for name, _ in drawn("Skeleton")["operators"]])


class Check(unittest.TestCase):
    def setUp(self):
        clear()

    def test_findings_are_listed_and_shown(self):
        item, armature, _, skeleton = character()
        select([item, armature], armature)
        with self.assertRaisesRegex(RuntimeError, "bind it first"):
            bpy.ops.sinew.check()
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        self.assertEqual(bpy.ops.sinew.check(), {"FINISHED"})
        whole = len(bpy.context.scene.sinew_findings)
        # A speck of another bone's weight far away.
        far = int(np.argmax([v.co.z for v in item.data.vertices]))
        for group in item.vertex_groups:
            group.remove([far])
        foot = next(n for n in skeleton.names if "foot" in n.lower())
        item.vertex_groups[foot].add([far], 1.0, "REPLACE")
        self.assertEqual(bpy.ops.sinew.check(poses=False), {"FINISHED"})
        findings = list(bpy.context.scene.sinew_findings)
        number = next(i for i, f in enumerate(findings) if str(far) in f.vertices.split())
        print(f"{whole} findings, then {len(findings)}: {findings[number].what}")
        self.assertEqual(bpy.ops.sinew.show_finding(finding=number), {"FINISHED"})
        self.assertEqual({v.index for v in item.data.vertices if v.select}, {int(v) for v in findings[number].vertices.split()})
        with self.assertRaisesRegex(RuntimeError, "expected the index of one"):
            bpy.ops.sinew.show_finding(finding=99)


run(__name__)
