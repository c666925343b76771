// SPDX-License-Identifier: MIT
// Which dropped files belong together.
import assert from "node:assert/strict";
import { pairFiles, stem } from "../src/files.js";

const character = (name, mesh, skeleton) => ({ name, mesh, skeleton });
const check = (names, waiting, want, moving = []) => {
  const got = pairFiles(names, waiting, moving);
  assert.deepEqual({ characters: got.characters, model: got.model, style: got.style, motions: got.motions, waiting: got.waiting }, { characters: [], model: "", style: "", motions: [], waiting: {}, ...want });
  return got.problems;
};

assert.equal(stem("a.b.rig.txt"), "a.b");
assert.deepEqual(check(["a.obj", "a.rig.txt"], {}, { characters: [character("a", "a.obj", "a.rig.txt")] }), []);
assert.deepEqual(check(["A.OBJ", "a.Rig.TXT"], {}, { characters: [character("A", "A.OBJ", "a.Rig.TXT")] }), []);
assert.deepEqual(check(["hero.obj", "skeleton.txt"], {}, { characters: [character("hero", "hero.obj", "skeleton.txt")] }), []);
assert.deepEqual(check(["hero.usdz"], {}, {}), ["hero.usdz: this is USD, which sinew writes but does not read: export glTF or FBX"]);
assert.deepEqual(check(["hero.glb"], {}, { characters: [character("hero", "hero.glb", "")] }), []);
assert.deepEqual(check(["hero.glb", "other.rig.txt"], {}, { characters: [character("hero", "hero.glb", "other.rig.txt")] }), []);
assert.deepEqual(check(["prop.glb", "hero.obj", "other.rig.txt"], {}, { characters: [character("prop", "prop.glb", ""), character("hero", "hero.obj", "other.rig.txt")] }), []);
assert.deepEqual(check(["hero.gltf", "hero.bin", "skin.png"], {}, { characters: [character("hero", "hero.gltf", "")] }), []);
assert.deepEqual(
  check(["b.rig.txt", "a.obj", "c.vrm", "b.obj", "a.rig.txt"], {}, {
    characters: [character("a", "a.obj", "a.rig.txt"), character("c", "c.vrm", ""), character("b", "b.obj", "b.rig.txt")],
  }),
  [],
);
// A mesh alone is a character; its skeleton may come later.
assert.deepEqual(check(["a.obj"], {}, { characters: [character("a", "a.obj", "")], waiting: { mesh: "a.obj" } }), []);
assert.deepEqual(check(["a.obj", "b.obj", "b.rig.txt"], {}, { characters: [character("a", "a.obj", ""), character("b", "b.obj", "b.rig.txt")], waiting: { mesh: "a.obj" } }), []);
assert.deepEqual(check(["b.rig.txt"], { mesh: "a.obj" }, { characters: [character("a", "a.obj", "b.rig.txt")] }), []);
assert.match(check(["a.rig.txt"], {}, { waiting: { rig: "a.rig.txt" } })[0], /^a\.rig\.txt is a skeleton without a mesh/);
assert.deepEqual(check(["a.obj"], { rig: "a.rig.txt" }, { characters: [character("a", "a.obj", "a.rig.txt")] }), []);
// Two meshes and one foreign rig: no guess.
assert.match(
  check(["a.obj", "b.obj", "c.rig.txt"], {}, { characters: [character("a", "a.obj", ""), character("b", "b.obj", "")], waiting: { rig: "c.rig.txt" } })[0],
  /^c\.rig\.txt is a skeleton without a mesh/,
);
// What is left over does not stop the rest.
assert.match(check(["a.glb", "x.docx"], {}, { characters: [character("a", "a.glb", "")] })[0], /^x\.docx: expected/);
assert.match(check(["hero.bin"], {}, {})[0], /contains no mesh/);
assert.deepEqual(check(["mine.sinew"], {}, { model: "mine.sinew" }), []);
assert.deepEqual(check(["studio.style", "hero.glb"], {}, { style: "studio.style", characters: [character("hero", "hero.glb", "")] }), []);
assert.deepEqual(check(["walk.BVH"], {}, { motions: ["walk.BVH"] }), []);
assert.deepEqual(check(["hero.glb", "walk.bvh"], {}, { motions: ["walk.bvh"], characters: [character("hero", "hero.glb", "")] }), []);
assert.deepEqual(check(["walk.bvh", "run.vrma"], {}, { motions: ["walk.bvh", "run.vrma"] }), []);
// What a file that may hold a mesh is for here shows in it, not in its name.
assert.deepEqual(check(["hero.fbx", "walk.fbx"], {}, { motions: ["walk.fbx"], characters: [character("hero", "hero.fbx", "")] }, ["walk.fbx"]), []);
// A picture alone is a drawing of a character; beside a mesh it is its part.
assert.deepEqual(check(["cat.png"], {}, { characters: [character("cat", "cat.png", "")] }), []);
assert.deepEqual(check(["hero.fbx", "skin.png"], {}, { characters: [character("hero", "hero.fbx", "")] }), []);
console.log("files_test: ok");
