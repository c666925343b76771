#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""rooms.py, type_names.py, script_circles.py and scripts/file_kinds.py find what they are for: on small trees that break each rule once."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import file_kinds
import rooms
import script_circles
import type_names

README = "A room includes only rooms that stand before it in this list: core, mesh and\nskeleton (neither knows the other), solve, mapping (core alone), bind. More.\n"


class Structure(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("engine/README.md", README)
        self.write("character/README.md", "A room includes only rooms that stand before it in this list: rig, bind.\n")
        for room in ("core", "mesh", "skeleton", "solve", "mapping", "bind", "api"):
            self.write(f"engine/src/{room}/{room}.hpp", "")
        for name in ("src/rig/rig.hpp", "src/bind/bind.hpp", "include/sinew_character/bind/seams.hpp"):
            self.write("character/" + name, "")
        for house, (folders, _) in rooms.HOUSES.items():
            if house != "engine":
                self.write(f"{folders[0]}/sinew_{house}/{house}.hpp", "")
                self.write(f"{folders[1]}/{house}_part.hpp", "")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self, name, text, check=rooms.check_rooms):
        self.write(name, text)
        return check(self.root)[0]

    def test_rooms(self):
        self.assertEqual(self.faults("engine/src/bind/a.cpp", '#include <vector>\n#include "core/core.hpp"\n#include "mesh/mesh.hpp"\n'), [])
        self.assertEqual(self.faults("engine/src/api/a.cpp", '#include "bind/bind.hpp"\n'), [])
        self.assertRegex(self.faults("engine/src/mesh/a.cpp", '\n#include "bind/bind.hpp"\n')[0], r"^engine/src/mesh/a.cpp:2: mesh includes bind/bind.hpp")
        self.assertEqual(len(self.faults("engine/src/mesh/a.cpp", '#include "skeleton/skeleton.hpp"\n')), 1)
        self.assertEqual(len(self.faults("engine/src/mesh/a.cpp", '#include "api/api.hpp"\n')), 1)
        self.assertEqual(len(self.faults("engine/src/mesh/a.cpp", "")), 0)
        self.assertEqual(len(self.faults("engine/src/mapping/a.cpp", '#include "mesh/mesh.hpp"\n')), 1)
        self.assertEqual(len(self.faults("engine/src/mapping/a.cpp", '#include "core/core.hpp"\n')), 0)
        self.assertEqual(len(self.faults("character/src/bind/a.cpp", '#include "rig/rig.hpp"\n')), 0)
        self.assertRegex(self.faults("character/src/rig/a.cpp", '#include "sinew_character/bind/seams.hpp"\n')[0], "and bind does not stand before it in character/README.md")
        self.assertEqual(len(self.faults("character/include/sinew_character/rig/a.hpp", '#include "bind/bind.hpp"\n')), 2)

    def test_list(self):
        self.assertRegex(self.faults("engine/src/attic/a.cpp", "")[0], "lacks engine/src/attic")
        self.assertRegex(self.faults("engine/README.md", README.replace("solve", "solve, attic, cellar"))[0], "cellar")
        for readme in ("No list.", README.replace("(core alone)", "(nobody)"), README.replace("(core alone)", "(bind alone)")):
            with self.assertRaises(SystemExit):
                self.faults("engine/README.md", readme)

    def test_namespaces(self):
        self.write("engine/README.md", README + "Rooms with a namespace of their own: mapping,\nsolve (solving).\n")
        for name, space in (("mapping/a.cpp", "sinew::mapping"), ("solve/a.hpp", "sinew::solving"), ("mesh/a.cpp", "sinew"), ("mesh/b.cpp", "sinew::mesh"), ("api/a.cpp", "sinew::mapping")):
            self.assertEqual(self.faults("engine/src/" + name, f"namespace {space} {{\nnamespace {{\n", rooms.check_namespaces), [])
        for name, space in (("mapping/a.cpp", "sinew"), ("solve/a.hpp", "sinew::solve"), ("mesh/a.cpp", "sinew::solving")):
            self.assertRegex(self.faults("engine/src/" + name, f"namespace {space} {{\n", rooms.check_namespaces)[0], f"opens {space};")
            self.write("engine/src/" + name, "")

    def test_houses(self):
        def houses(name, include):
            return self.faults(name, f"#include {include}\n", rooms.check_houses)
        for include in ('"sinew_formats/formats.hpp"', '"formats_part.hpp"', "<sinew_character/character.hpp>"):
            self.assertEqual(houses("trainer/data_sets/src/a.cpp", include), [])
        for name, include in (("formats/src/a.cpp", '"sinew_character/character.hpp"'), ("formats/src/a.cpp", "<sinew_data_sets/new.hpp>"),
                              ("formats/src/a.cpp", '"character_part.hpp"'), ("character/src/a.cpp", '"sinew_data_sets/data_sets.hpp"'),
                              ("engine/src/core/a.hpp", '"sinew_formats/formats.hpp"'), ("trainer/src/a.cpp", '"sinew_quant/quant.hpp"'),
                              ("quant/src/a.cpp", '"sinew_trainer/trainer.hpp"')):
            self.assertEqual(len(houses(name, include)), 1, f"{name}: {include}")
            (self.root / name).unlink()

    def test_script_circles(self):
        for name, text in (("a", 'import { b } from "./b.js";\nimport "three";'), ("b", 'export {\n  c,\n} from "./c.js";'), ("c", 'const later = () => import("./a.js");'), ("d", 'import "./a.js";')):
            self.write(f"src/{name}.js", text)
        folder = self.root / "src"
        self.assertEqual(script_circles.imports(folder), {"a.js": {"b.js"}, "b.js": {"c.js"}, "c.js": set(), "d.js": {"a.js"}})
        self.assertEqual(script_circles.circles(script_circles.imports(folder)), [])
        self.write("src/c.js", 'import * as a from "./a.js";')
        self.assertEqual(script_circles.circles(script_circles.imports(folder)), [["a.js", "b.js", "c.js"]])

    def test_file_kinds(self):
        self.write(file_kinds.HEADER, "enum FileUse : uint32_t {\n  kReadsMesh = 1,\n  kReadsMotion = 2,\n  kOffered = 4  // said\n};\n")
        self.write(file_kinds.TABLE, "constexpr uint32_t kWhole = kReadsMesh | kReadsMotion;\n"
                   '{".glb", "GLB", kWhole | kOffered, FileReader::kGltf},\n{".fbx", "FBX", kWhole, FileReader::kScene},\n{".bvh", "BVH", kReadsMotion, FileReader::kBvh},')
        rows = file_kinds.kinds(self.root)
        self.assertEqual(rows[0], (".glb", "GLB", ["readsMesh", "readsMotion", "offered"], "gltf"))
        self.assertEqual(rows[2], (".bvh", "BVH", ["readsMotion"], "bvh"))
        for name, text, found in (("web/src/a.js", 'const all = [".glb", ".fbx", ".bvh"];', 1), ("web/src/a.js", "const any = /\\.(glb|fbx|bvh)$/i;", 1),
                                  ("web/src/a.js", "// .glb, .fbx, .bvh", 0), ("web/src/a.js", 'const two = ".glb .fbx";', 0),
                                  ("godot/addons/a.gd", 'return ["glb", "fbx", "bvh"]', 1), ("blender/sinew_blender/a.py", 'GLOB = "*.glb;*.fbx;*.bvh"', 1),
                                  ("python/src/a.py", '"""Opens .glb,\n.fbx, .bvh."""', 0), ("web/src/a.html", '<input accept=".glb,.fbx,.bvh" />', 1),
                                  ("cli/a.cpp", 'check(path, {".glb",\n  ".fbx", ".bvh"});', 1), ("cli/a.cpp", 'add("-o", "A .glb; or "\n  ".fbx or .bvh");', 1),
                                  ("cli/a.cpp", 'if (is(path, ".glb") ||\n  is(path, ".fbx") || is(path, ".bvh")) return;', 1), ("cli/a.cpp", '// .glb .fbx .bvh\n', 0),
                                  ("cli/a.cpp", 'void f() {\n  if (is(path, ".glb")) g(".fbx");\n  h(".bvh");\n}', 0), ("cli/a.cpp", 'footer("sinew a.glb b.fbx c.bvh");', 0)):
            path = "samples/" + name
            self.write(path, text)
            self.assertEqual(len(file_kinds.own_lists(self.root, rows)), found, text)
            self.write(path, "")
        self.write(file_kinds.TABLE, '{".glb", kBroken, FileReader::kGltf},')
        with self.assertRaises(SystemExit):
            file_kinds.kinds(self.root)

    def test_type_names(self):
        def names(text):
            return [name for name, _ in type_names.definitions(text)]
        self.assertEqual(names("namespace sinew {\nstruct Limb {\n  struct Inner {};\n};\nclass Other final : public Limb { };\n}"), ["sinew::Limb", "sinew::Other"])
        self.assertEqual(names("namespace a::b { template <class T, typename U = int> struct alignas(16) X { }; enum class E : int { kA }; }"), ["a::b::X", "a::b::E"])
        self.assertEqual(names("namespace a { namespace { struct Hidden {}; } struct [[nodiscard]] Seen { }; }"), ["a::Seen"])
        self.assertEqual(names('extern "C" {\ntypedef struct thing { int a; } thing;\n}'), ["thing"])
        self.assertEqual(names("struct A;\nstruct A f() { struct Local { }; }\nstruct S s = { 1 };\ntemplate <> struct X<int> { };\nstruct A::Part { };"), ["A::Part"])
        self.assertEqual(names('// struct A {\n/* struct B { */ const char* t = "struct C {"; const char c = \'{\'; auto r = R"x(struct D {)x"; int n = 1\'000;\n#define E struct E {\nstruct F { };'), ["F"])
        self.assertEqual(list(type_names.definitions('"\\""\n/*\n*/\nstruct F {'))[0][1], 4)

    def test_two_types(self):
        many = "".join(f"struct T{i} {{}};" for i in range(300))
        self.write("engine/src/core/core.hpp", "namespace sinew { " + many + " struct Limb { int a; }; }")
        self.assertEqual(self.two_types()[0], 0)
        self.write("trainer/src/a.cpp", "\nnamespace sinew { struct Limb { double a; }; }")
        status, said = self.two_types()
        self.assertEqual(status, 1)
        self.assertIn("trainer/src/a.cpp:2: sinew::Limb is a type of engine/src/core/core.hpp:1 already", said)

    def two_types(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            sys.argv = ["type_names.py", str(self.root)]
            status = type_names.main()
        return status, said.getvalue()


if __name__ == "__main__":
    unittest.main()
