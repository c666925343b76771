# SPDX-License-Identifier: MIT
"""Bind in Blender, headless."""
import os
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np

from blender_common import (add_armature, add_mesh, character, clear, common, run, scene, select, sinew_blender, state, weights,
                            z_up)

sinew = sinew_blender.sinew


def dense(item, names):
    rows = weights(item)
    return np.stack([rows.get(n, np.zeros(len(item.data.vertices), np.float32)) for n in names], 1)


def l1(item, armature, rows, skeleton):
    return float(np.abs(dense(item, skeleton.names) - rows).sum(1).mean())


def expected_of(joined, skeleton):
    """The library's weights with its defaults, in steps of 1/255."""
    with sinew.create(sinew.Character(joined.positions, joined.faces, skeleton)) as one:
        one.bind(up="z")
        return one.skin.rounded(4, 255)


class Bind(unittest.TestCase):
    def setUp(self):
        clear()

    def refused(self, text, item, **options):
        before = state(item)
        with self.assertRaisesRegex(RuntimeError, text) as caught:
            bpy.ops.sinew.bind(**options)
        self.assertEqual(len(str(caught.exception).strip().splitlines()), 1)
        self.assertEqual(state(item), before)

    def check_against_command(self, item, armature, where, **options):
        """The operator's weights and the command's for the same arrays, with the defaults of both."""
        self.assertEqual(bpy.ops.sinew.bind(precision="16", **options), {"FINISHED"})
        skeleton, joined = scene.skeleton_of(armature), scene.join([item])
        with sinew.create(sinew.Character(joined.positions, [list(p.vertices) for p in item.data.polygons], skeleton)) as bare:
            bare.save(f"{where}/mesh.obj")
        told = common.command("bind", f"{where}/mesh.obj", "--skeleton", f"{where}/mesh.rig.txt", "--up", "z", "-o", f"{where}/out.glb",
                              "--json", *(("--joints", "all", "--keep-tips") if options else ()))
        found = np.rint(dense(item, skeleton.names) * 65535)
        order = np.lexsort((np.broadcast_to(np.arange(found.shape[1]), found.shape), -found), axis=1)[:, :4]
        kept = np.take_along_axis(found, order, 1).astype(np.uint16)
        self.assertEqual(common.fnv(sinew.Skin(np.where(kept > 0, order, 0), kept)), told["hash"])

    def test_same_bytes_as_the_command(self):
        sys.path.insert(0, os.path.join(os.environ["SINEW_SOURCE_DIR"], "tests", "support"))
        import strange_characters
        bound = 0
        with common.folder() as where:
            for file in strange_characters.write_all(where):
                clear()
                try:
                    one = sinew.open(file)
                except sinew.Error as error:
                    print(f"{file.name}: {error}")
                    continue
                faces = one.faces if isinstance(one.faces, list) else [one.faces]
                if not len(one.positions) or one.skeleton is None:
                    continue
                with self.subTest(file.name):
                    item = add_mesh(file.stem, z_up(one.positions), [[int(v) for v in f] for block in faces for f in block])
                    armature = add_armature(one.skeleton)
                    select([item, armature], armature)
                    self.check_against_command(item, armature, where)
                    bound += 1
            print(f"{bound} strange characters bound with the command's bytes")
            self.assertGreaterEqual(bound, 20)
            clear()
            item, armature, _, _ = character()
            self.check_against_command(item, armature, where, joints="all")

    def test_eight_bits_are_the_engines_and_every_vertex_has_weight(self):
        item, armature, rows, skeleton = character()
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        joined, bones = scene.join([item]), scene.skeleton_of(armature)
        expected = expected_of(joined, bones)
        np.testing.assert_array_equal(np.rint(255 * dense(item, bones.names)), np.rint(255 * expected.dense(len(bones))))
        self.assertTrue((np.rint(255 * dense(item, bones.names)).sum(1) == 255).all())
        ours = l1(item, armature, rows, skeleton)
        self.assertEqual([m.type for m in item.modifiers], ["ARMATURE"])
        self.assertEqual(item.modifiers[0].object, armature)
        self.assertEqual(item.parent, armature)
        # Blender's automatic weights on the same character.
        clear()
        item, armature, rows, skeleton = character()
        try:
            bpy.ops.object.parent_set(type="ARMATURE_AUTO")
        except RuntimeError as error:
            print("Blender's automatic weights:", error)
        empty = int((dense(item, skeleton.names).sum(1) < 1e-6).sum())
        theirs = l1(item, armature, rows, skeleton)
        print(f"L1 against the artist: sinew {ours:.3f}, Blender's automatic weights {theirs:.3f}, which leave {empty} vertices empty; sinew none")
        self.assertLess(ours, theirs)

    def test_several_meshes_at_once(self):
        item, armature, _, _ = character()
        skeleton = scene.skeleton_of(armature)
        points = scene.rest_positions(item)
        faces = [list(p.vertices) for p in item.data.polygons]
        part = np.arange(len(points))  # connected pieces
        for _ in range(100):
            before = part.copy()
            for f in faces:
                part[f] = part[f].min()
            if (part == before).all():
                break
        largest = np.bincount(part).argmax()
        objects = []
        for name, inside in (("body", part == largest), ("clothes", part != largest)):
            number = np.cumsum(inside) - 1
            objects.append(add_mesh(name, points[inside], [[int(number[v]) for v in f] for f in faces if inside[f[0]]]))
        bpy.data.objects.remove(item)
        select([*objects, armature], armature)
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        joined = scene.join(objects)
        expected = expected_of(joined, skeleton).dense(len(skeleton))
        found = np.concatenate([dense(o, skeleton.names) for o in objects])
        np.testing.assert_allclose(found, expected, atol=1e-6)
        first = joined.parts[1].first
        faces = [f for f in (b[(b >= first).all(1)] - first for b in joined.faces) if len(f)]
        alone = expected_of(scene.JoinedMesh(joined.positions[first:], faces), skeleton)
        self.assertGreater(np.abs(alone.dense(len(skeleton)) - expected[first:]).max(), 0.02)

    def test_deform_off_gets_nothing(self):
        item, armature, _, _ = character()
        armature.data.bones["head"].use_deform = False
        bpy.ops.sinew.bind()
        self.assertNotIn("head", item.vertex_groups)
        for bone in armature.data.bones:
            bone.use_deform = False
        self.refused("every bone has Deform off", item)

    def test_selected_vertices_only(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind(method="heat")
        before = dense(item, scene.skeleton_of(armature).names)
        select([item, armature], item)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="DESELECT")
        bpy.ops.object.mode_set(mode="OBJECT")
        for v in range(0, len(before), 2):
            item.data.vertices[v].select = True
        bpy.ops.object.mode_set(mode="EDIT")
        chosen = scene.selected_vertices(item)
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        self.assertEqual(item.mode, "EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
        after = dense(item, scene.skeleton_of(armature).names)
        np.testing.assert_array_equal(after[~chosen], before[~chosen])
        self.assertTrue((after[chosen] != before[chosen]).any())

    def test_locked_groups_keep_their_sums(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        names = scene.skeleton_of(armature).names
        before = dense(item, names)
        hips, chest = names.index("hips"), names.index("chest")
        for name in ("hips", "chest"):
            item.vertex_groups[name].lock_weight = True
        self.assertEqual(bpy.ops.sinew.bind(method="heat"), {"FINISHED"})
        after = dense(item, names)
        np.testing.assert_array_equal(after[:, [hips, chest]], before[:, [hips, chest]])
        np.testing.assert_allclose(after.sum(1), 1, atol=1e-5)
        self.assertTrue((after != before).any())

    def test_selected_bones_only(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        names = scene.skeleton_of(armature).names
        before = dense(item, names)
        inside = [n for n in names if n.endswith(".L")]
        for bone in armature.data.bones:
            bone.select = bone.name in inside
        self.assertEqual(bpy.ops.sinew.bind(method="heat", only_selected_bones=True), {"FINISHED"})
        after = dense(item, names)
        others = [i for i, n in enumerate(names) if n not in inside]
        np.testing.assert_array_equal(after[:, others], before[:, others])
        np.testing.assert_allclose(after.sum(1), 1, atol=1e-5)
        for bone in armature.data.bones:
            bone.select = False
        self.refused("no bone is selected", item, only_selected_bones=True)

    def test_painted_vertices_are_hints(self):
        item, armature, rows, skeleton = character()
        bpy.ops.sinew.bind()
        plain = l1(item, armature, rows, skeleton)
        item.vertex_groups.clear()
        painted = np.arange(0, len(rows), 50)  # 2 %
        for v in painted:
            for joint in np.flatnonzero(rows[v]):
                name = skeleton.names[joint]
                group = item.vertex_groups.get(name) or item.vertex_groups.new(name=name)
                group.add([int(v)], float(rows[v, joint]), "REPLACE")
        before = dense(item, skeleton.names)[painted]
        self.assertEqual(bpy.ops.sinew.bind(existing="hints"), {"FINISHED"})
        np.testing.assert_array_equal(dense(item, skeleton.names)[painted], before)
        hinted = l1(item, armature, rows, skeleton)
        print(f"2 % painted: L1 from {plain:.3f} to {hinted:.3f}")
        self.assertLess(hinted, plain)

    def test_mirror_modifier(self):
        item, armature, _, _ = character("biped__robot")
        points = scene.rest_positions(item)
        faces = [list(p.vertices) for p in item.data.polygons]
        half = points[:, 0] >= -1e-4
        number = np.cumsum(half) - 1
        left = add_mesh("half", points[half], [[int(number[v]) for v in f] for f in faces if half[f].all()])
        left.modifiers.new("Mirror", "MIRROR").use_axis[0] = True
        bpy.data.objects.remove(item)
        select([left, armature], armature)
        joined = scene.join([left])
        self.assertEqual(len(joined.positions), 2 * joined.own)
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        self.assertEqual([m.type for m in left.modifiers], ["MIRROR", "ARMATURE"])
        names = scene.skeleton_of(armature).names
        bones = scene.skeleton_of(armature)
        expected = expected_of(joined, bones)
        np.testing.assert_allclose(dense(left, names), expected.dense(len(names))[:joined.own], atol=1e-6)

    def test_shape_keys_scaled_and_mirrored_objects(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        names = scene.skeleton_of(armature).names
        expected = dense(item, names)
        for kind in ("keys", "scaled", "mirrored"):
            clear()
            item, armature, _, _ = character()
            if kind == "keys":
                item.shape_key_add(name="Basis")
                key = item.shape_key_add(name="Big")
                for point in key.data:
                    point.co *= 3
                key.value = 1
                item.active_shape_key_index = 1
            else:
                scale = (2, 2, 2) if kind == "scaled" else (-1, 1, 1)
                for v in item.data.vertices:
                    v.co = [c / s for c, s in zip(v.co, scale)]
                item.scale = scale
                bpy.context.view_layer.update()
                select([item, armature], armature)
            world = np.array(item.matrix_world)
            self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
            np.testing.assert_allclose(np.array(item.matrix_world), world, atol=1e-6)
            np.testing.assert_allclose(dense(item, names), expected, atol=0.02, err_msg=kind)

    def test_symmetric_rigid_and_soft(self):
        item, armature, _, _ = character("biped__robot")
        self.assertEqual(bpy.ops.sinew.bind(symmetric=True), {"FINISHED"})
        names = scene.skeleton_of(armature).names
        for options in (dict(rigid_parts="always"), dict(softness=3.0), dict(influences=1)):
            self.assertEqual(bpy.ops.sinew.bind(**options), {"FINISHED"})
            if options.get("influences"):
                self.assertEqual(int((dense(item, names) > 0).sum(1).max()), 1)

    def test_questions_and_answers(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind(questions=3)
        listed = bpy.context.scene.sinew_questions
        self.assertEqual(len(listed), 3)
        asked, before = listed[0].vertex, dense(item, scene.skeleton_of(armature).names)
        self.assertEqual(bpy.ops.sinew.show(question=0), {"FINISHED"})
        chosen = np.array([v.select for v in item.data.vertices])
        self.assertTrue(chosen[asked] and 0 < chosen.sum() < len(chosen))
        crossing = [e for e in item.data.edges if chosen[e.vertices[0]] != chosen[e.vertices[1]]]
        self.assertEqual(crossing, [])
        with self.assertRaisesRegex(RuntimeError, "found 3 questions"):
            bpy.ops.sinew.show(question=3)
        choice = listed[0].alternatives.split("\n")[0]
        self.assertEqual(bpy.ops.sinew.answer(question=0, answer=choice), {"FINISHED"})
        after = dense(item, scene.skeleton_of(armature).names)
        self.assertTrue((after[asked] != before[asked]).any() or (after != before).any())
        self.assertNotIn(asked, [q.vertex for q in bpy.context.scene.sinew_questions])
        self.assertEqual(bpy.ops.sinew.forget(), {"FINISHED"})
        bpy.ops.sinew.bind()
        np.testing.assert_array_equal(dense(item, scene.skeleton_of(armature).names), before)

    def test_a_style_file_answers(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        names = scene.skeleton_of(armature).names
        before = dense(item, names)
        with common.folder() as where:
            options = [common.DATA / "biped__robed.obj", "--skeleton", common.DATA / "biped__robed.rig.txt"]
            with sinew.open(common.DATA / "biped__robed.obj") as one:
                first = one.bind(joints="names", questions=3).questions[0].vertex
            common.command("bind", *options, "--answer", f"{first}=rigid:head", "--save-style", f"{where}/a.style", "-o", f"{where}/a.rig.txt")
            self.assertEqual(bpy.ops.sinew.bind(style=f"{where}/a.style"), {"FINISHED"})
            after = dense(item, names)
            self.assertEqual(after[first, names.index("head")], 1)
            self.assertTrue((after != before).any())
            self.refused("none.style: no such file", item, style=f"{where}/none.style")

    def test_nothing_else_is_touched(self):
        item, armature, _, _ = character()
        other = item.vertex_groups.new(name="cloth pins")
        other.add([1, 5, 9], 0.25, "REPLACE")
        item.modifiers.new("Subdivision", "SUBSURF")
        holder = bpy.data.objects.new("holder", None)
        bpy.context.scene.collection.objects.link(holder)
        item.parent = holder
        select([item, armature], armature)
        self.assertEqual(bpy.ops.sinew.bind(), {"FINISHED"})
        self.assertEqual(item.parent, holder)
        self.assertEqual([m.type for m in item.modifiers], ["SUBSURF", "ARMATURE"])
        pins = weights(item)["cloth pins"]
        self.assertEqual(np.flatnonzero(pins).tolist(), [1, 5, 9])
        bpy.ops.sinew.bind()
        self.assertEqual([m.type for m in item.modifiers], ["SUBSURF", "ARMATURE"])

    def test_errors_are_one_line_and_change_nothing(self):
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        select([item], item)
        item.modifiers.clear()
        item.parent = None
        self.refused("select the armature as well", item)
        select([item, armature], armature)
        item.data.vertices[7].co = (float("nan"), 0, 0)
        self.refused("positions: element", item)
        empty = add_mesh("empty", [], [])
        select([empty, armature], armature)
        self.refused("empty has no vertices", empty)
        library = sinew.binding._library
        path = os.environ.get("SINEW_LIBRARY")
        try:
            sinew.binding._library, os.environ["SINEW_LIBRARY"] = None, "/no/library.so"
            item.data.vertices[7].co = (0, 0, 0)
            select([item, armature], armature)
            self.refused("/no/library.so: no such file", item)
        finally:
            sinew.binding._library = library
            os.environ.pop("SINEW_LIBRARY") if path is None else None

    def test_a_hundred_thousand_vertices_are_written_fast(self):
        count = 100000
        points = np.random.default_rng(1).random((count, 3))
        item = add_mesh("cloud", points, [])
        joints = np.random.default_rng(2).integers(0, 60, (count, 4)).astype(np.uint16)
        joints += np.arange(4, dtype=np.uint16)[None] * 60
        steps = np.full((count, 4), [150, 60, 30, 15])
        begin = time.process_time()
        sinew_blender.groups.write(item, [f"bone_{i}" for i in range(240)], joints, steps / 255, np.ones(count, bool))
        print(f"groups of {count} vertices: {time.process_time() - begin:.2f} s of the processor")
        self.assertEqual(len(item.vertex_groups), 240)
        self.assertAlmostEqual(item.vertex_groups[int(joints[7, 1])].weight(7), 60 / 255, places=6)


run(__name__)
