// SPDX-License-Identifier: MIT
// The history, project files, archives and whose key it is, without a page.
import assert from "node:assert/strict";
import { History } from "../src/history.js";
import { isOwnKey } from "../src/keys.js";
import { filesOf, projectOf, readProject } from "../src/project.js";
import { crc32, unzip, zip } from "../src/zip.js";

const history = new History("a");
assert.deepEqual([history.undoName, history.redoName, history.undo(), history.redo()], ["", "", null, null]);
history.add("move", "b");
history.add("turn", "c", { goesOn: true, time: 1000 });
history.add("turn", "d", { goesOn: true, time: 1500 });
assert.deepEqual(history.states, ["a", "b", "d"], "a slider that goes on is one step");
history.add("turn", "e", { goesOn: true, time: 9000 });
assert.deepEqual([history.undoName, history.undo(), history.redoName, history.undo(), history.undoName, history.now], ["turn", "d", "turn", "b", "move", "b"]);
history.add("lock", "f");
assert.deepEqual([history.states, history.redoName], [["a", "b", "f"], ""], "what is done anew ends what was taken back");
history.undo();
history.redo();
history.add("lock", "g", { goesOn: true, time: Date.now() });
assert.deepEqual(history.states, ["a", "b", "f", "g"], "nothing goes on after undo");
for (let i = 0; i < 150; ++i) history.add("step", i);
assert.equal(history.states.length, 101);
assert.equal(history.now, 149);

assert.equal(crc32(new TextEncoder().encode("123456789")), 0xcbf43926);
const files = [{ name: "a.txt", bytes: new TextEncoder().encode("hello") }, { name: "ü.bin", bytes: new Uint8Array(70000).fill(7) }];
const archive = new Uint8Array(await zip(files).arrayBuffer());
assert.deepEqual(await unzip("x.zip", archive), files.map(({ name, bytes }) => ({ name, bytes })));
await assert.rejects(() => unzip("x.zip", archive.subarray(0, 60)), /^Error: x\.zip: expected a ZIP archive/);
const bad = archive.slice();
bad[8] = 12; // the method of the first local head is not read, that of the list is
bad[bad.length - 22 - 2 * 46 - 5 - 6 + 10] = 12;
await assert.rejects(() => unzip("x.zip", bad), /packed in a way that is not read/);

const state = {
  recipe: { wishes: null, edits: [] }, up: 2, options: { softness: "0" }, pose: Float32Array.of(0, 1.5, 0), never: new Set(["a"]), always: new Set(), locked: new Set(["b"]),
  answers: [{ question: { part: 3, members: { of: [1] } }, answer: "soft", kind: 2, joint: 0 }], motion: { files: ["builtin:walk", "m.bvh"], method: 0, pins: {} },
};
const project = projectOf({ name: "hero", source: { mesh: "hero.obj", skeleton: "", step: "weights" } }, state, null, ["hero.png"]);
assert.deepEqual(filesOf(project), ["hero.obj", "hero.png", "m.bvh"]);
const read = readProject("hero.sinewproject", JSON.stringify(project));
assert.deepEqual([read.name, read.step, [...read.state.never], [...read.state.locked], [...read.state.pose]], ["hero", "weights", ["a"], ["b"], [0, 1.5, 0]]);
assert.deepEqual(read.state.answers[0].question, { part: 3 });
assert.throws(() => readProject("x", "{"), /^Error: x: its project.json is damaged/);
assert.throws(() => readProject("x", '{"sinewProject": 9}'), /^Error: x: expected a project of version 1, found version 9/);

const element = (tag) => ({ matches: (list) => list.split(", ").some((one) => one === tag || one.startsWith(`${tag}[type=search`)) });
assert.deepEqual(["button", "summary", "div"].map((tag) => isOwnKey(element(tag), " ")), [true, true, false]);
assert.deepEqual(["button", "div"].map((tag) => isOwnKey(element(tag), "f")), [false, false]);
console.log("history: ok");
