// SPDX-License-Identifier: MIT
// The page's own arithmetic: what a ray passes through, where a dragged joint goes, names, parents, colours, and work that
// is wanted faster than it is done.
import assert from "node:assert/strict";
import { Latest } from "../src/latest.js";
import { crossings, draggedTo, insides, middleNear } from "../src/limbs.js";
import { sentenceOf } from "../src/sentences.js";
import { earsThatMoveHeads, missingTail } from "../src/suspects.js";
import { answersFor, childPlace, freeName, movedJoints, possibleParents, sureColour, sureText } from "../src/skeleton.js";

// Boxes from `low` to `high`, two triangles a side, corners counter-clockwise from outside.
function boxes(...list) {
  const positions = [];
  const triangles = [];
  for (const [low, high] of list) {
    const first = positions.length / 3;
    for (let i = 0; i < 8; ++i) positions.push(...[0, 1, 2].map((axis) => ((i >> axis) & 1 ? high : low)[axis]));
    for (const [a, b, c, d] of [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]) {
      triangles.push(...[a, b, c, a, c, d].map((i) => first + i));
    }
  }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}
const inwards = ({ positions, triangles }) => ({ positions, triangles: triangles.map((_, i) => triangles[i - (i % 3) + [0, 2, 1][i % 3]]) });
const near = (got, want) => {
  assert.equal(got.length, want.length, `${JSON.stringify(got)} for ${JSON.stringify(want)}`);
  got.forEach((x, i) => assert.ok(Math.abs(x - want[i]) < 1e-5, `${JSON.stringify(got)} for ${JSON.stringify(want)}`));
};
const into = (surface, origin) => insides(crossings(surface, origin, [0, 0, -1]));

// Two limbs behind each other.
const limbs = boxes([[-1, -1, -1], [1, 1, 1]], [[-1, -1, -6], [1, 1, -4]]);
assert.equal(crossings(limbs, [0.3, 0.2, 10], [0, 0, -1]).length, 4);
near(into(limbs, [0.3, 0.2, 10]).flat(), [9, 11, 14, 16]);
near(into(limbs, [5, 0, 10]).flat(), []);
assert.equal(middleNear([[9, 11], [14, 16]], 10.7), 10);
assert.equal(middleNear([[9, 11], [14, 16]], 13), 15);
assert.equal(middleNear([[9, 11], [14, 16]], -4), 10);
assert.equal(middleNear([], 3), null);
// On the edge of two triangles, along a side, with all faces inwards, with parts that overlap, with a sheet that has no inside.
near(into(limbs, [0, 0, 10]).flat(), [9, 11, 14, 16]);
near(into(limbs, [1, 0.5, 10]).flat(), [9, 11, 14, 16]);
near(into(inwards(limbs), [0.3, 0.2, 10]).flat(), [9, 11, 14, 16]);
near(into(boxes([[-1, -1, -1], [1, 1, 1]], [[-1, -1, -3], [1, 1, 0]]), [0.3, 0.2, 10]).flat(), [9, 13]);
// An edge in front, a face behind: met twice, left once.
const wedge = { positions: Float32Array.from([0, -1, 1, 0, 1, 1, -1, 0, -1, 1, 0, -1]), triangles: Uint32Array.from([0, 1, 2, 1, 0, 3, 0, 2, 3, 1, 3, 2]) };
near(into(wedge, [0, 0.1, 10]).flat(), [9, 10.8]);
const sheet = { positions: Float32Array.from([-9, -9, 5, 9, -9, 5, 0, 9, 5]), triangles: Uint32Array.from([0, 1, 2]) };
near(into(sheet, [0, 0, 10]).flat(), []);

// A drag keeps the distance, or finds the middle of what the pointer is on: of the limb that the joint is in.
const eye = { origin: [0.3, 0.2, 10], direction: [0, 0, -1], forward: [0, 0, -1] };
near(draggedTo({ ...eye, from: [0, 0, 0.7] }), [0.3, 0.2, 0.7]);
near(draggedTo({ ...eye, from: [0, 0, 0.7], surface: limbs }), [0.3, 0.2, 0]);
near(draggedTo({ ...eye, from: [0, 0, -4.2], surface: limbs }), [0.3, 0.2, -5]);
near(draggedTo({ ...eye, origin: [7, 0, 10], from: [0, 0, 0.7], surface: limbs }), [7, 0, 0.7]);
// A ray that leans keeps the distance that the eye sees, not the ray's length.
const leaning = [0.6, 0, -0.8];
near(draggedTo({ ...eye, origin: [0, 0, 10], direction: leaning, from: [0, 0, 2] }), [6, 0, 2]);
// A joint for both sides stays on the plane: from the side the pointer has it, from the front the middle of the trunk.
const plane = { axis: 0, at: 0.25 };
const side = { origin: [10, 0.5, 0.4], direction: [-1, 0, 0], forward: [-1, 0, 0] };
near(draggedTo({ ...side, from: [0.25, 0, 0], plane }), [0.25, 0.5, 0.4]);
near(draggedTo({ ...side, from: [0.25, 0, 0], plane, surface: limbs }), [0.25, 0.5, 0.4]);
const askew = { origin: [9.25, 0.5, 4.4], direction: [-0.9, 0, -0.44], forward: [-1, 0, 0] };
near(draggedTo({ ...askew, from: [0.25, 0, 0], plane, surface: limbs }), [0.25, 0.5, 0]);
near(draggedTo({ ...askew, origin: [9.25, 0.5, 4.9], from: [0.25, 0, 0], plane, surface: limbs }), [0.25, 0.5, 0.5]);
near(draggedTo({ ...eye, from: [0.25, 0, 0.7], plane }), [0.25, 0.2, 0.7]);
near(draggedTo({ ...eye, from: [0.25, 0, 0.7], plane, surface: limbs }), [0.25, 0.2, 0]);
const slanted = { origin: [3, 0.2, 4], direction: leaning.map((x) => (x > 0 ? -x : x)), forward: [0, 0, -1] };
near(draggedTo({ ...slanted, from: [0.25, 0, 0.3], plane, surface: limbs }), [0.25, 0.2, 0]);

// Names, parents and places of what is added.
const joint = (name, parent, more = {}) => ({ name, parent, side: 0, end: false, partner: -1, position: [0, 0, 0], ...more });
const body = [
  joint("Hips", -1, { partner: 0, position: [0, 1, 0] }),
  joint("LeftArm", 0, { partner: 3, side: 1, position: [1, 2, 0] }),
  joint("LeftArm_end", 1, { end: true, partner: 4, side: 1 }),
  joint("RightArm", 0, { partner: 1, side: -1, position: [-1, 2, 0] }),
  joint("RightArm_end", 3, { end: true, partner: 2, side: -1 }),
];
const mirror = { mirrored: true, axis: 0, plane: 0 };
assert.equal(freeName(body, mirror, 0, true), "Joint");
assert.equal(freeName(body, mirror, 1, true), "LeftJoint");
assert.equal(freeName(body, mirror, 3, true), "RightJoint");
assert.equal(freeName(body, mirror, 3, false), "Joint");
assert.equal(freeName([...body, joint("RightJoint", 0), joint("Joint", 0)], mirror, 1, true), "LeftJoint2");
assert.equal(freeName([...body.slice(0, 3), { ...body[3], side: 0, name: "arm two" }], mirror, 3, true), "RightJoint");
assert.deepEqual(possibleParents(body, 1), [0, 3]);
assert.deepEqual(possibleParents(body, 0), []);
near(childPlace(body, 1, 5, 0), [1.5, 2.5, 0]);
near(childPlace(body, 0, 5, 0), [0, 1.5, 0]);
near(childPlace(body, 0, 5, 1), [0, 1, 0.5]);

// What is shown of a drag until the module has answered.
const places = (joints) => Object.fromEntries(joints.map(({ name, position }) => [name, position]));
const arms = places(movedJoints(body, 3, [-2, 2.5, 1], { ...mirror, plane: 0.5 }, true));
assert.deepEqual(arms, { Hips: [0, 1, 0], LeftArm: [3, 2.5, 1], LeftArm_end: [2, 0.5, 1], RightArm: [-2, 2.5, 1], RightArm_end: [-1, 0.5, 1] });
assert.deepEqual(places(movedJoints(body, 3, [-2, 2.5, 1], mirror, false)).LeftArm, [1, 2, 0]);
assert.deepEqual(places(movedJoints(body, 0, [3, 4, 5], { ...mirror, plane: 0.5 }, true)).Hips, [0.5, 4, 5]);
const hips = places(movedJoints(body, 0, [3, 4, 5], mirror, false));
assert.deepEqual([hips.Hips, hips.LeftArm], [[3, 4, 5], [1, 2, 0]]);
assert.deepEqual(body[3].position, [-1, 2, 0]);

// Answers find their joints again.
const answers = [{ kind: 1, joint: 3, answer: "rigid:RightArm" }, { kind: 2, joint: 0, answer: "soft" }];
assert.deepEqual(answersFor(answers, body, [body[0], body[3]], 1), [{ kind: 1, joint: 1, answer: "rigid:RightArm" }, answers[1]]);
assert.deepEqual(answersFor(answers, body, body.slice(0, 3), 1), [answers[1]]);
const renamed = body.map((one, j) => (j === 3 ? { ...one, name: "arm.R" } : one));
assert.deepEqual(answersFor(answers, body, renamed, 1)[0], { kind: 1, joint: 3, answer: "rigid:arm.R" });

// Colours from sure to unsure.
const ofSpread = (spread) => sureColour(1 / (1 + spread / 0.05) ** 2);
assert.deepEqual(sureColour(1), [235, 240, 246]);
assert.deepEqual(sureColour(0), [225, 30, 45]);
near(ofSpread(0.03), [235, 240, 246]);
near(ofSpread(0.065), [247.5, 172, 71]);
near(ofSpread(0.1), [225, 30, 45]);

// The newest wish wins, nothing queues, and an error ends only what was wanted so far.
const done = [];
let finish;
const latest = new Latest((what) => new Promise((resolve, reject) => (finish = () => (done.push(what), what < 0 ? reject(new Error("no")) : resolve()))));
const first = latest.want(1);
latest.want(2);
latest.want(3);
assert.ok(latest.busy);
finish();
await new Promise((resolve) => setTimeout(resolve));
finish();
await first;
assert.deepEqual(done, [1, 3]);
assert.ok(!latest.busy);
const failing = latest.want(-1);
finish();
await assert.rejects(failing, /no/);
const again = latest.want(4);
finish();
await again;
assert.deepEqual(done, [1, 3, -1, 4]);
// How sure a joint's position is, as a person says it.
const confidenceOf = (spread) => 1 / (1 + spread / 0.05) ** 2;
assert.equal(sureText(confidenceOf(0.12), 1), "Unsure: may be off by 12 cm.");
assert.equal(sureText(confidenceOf(0.06), 1.8), "Fairly sure: may be off by 11 cm.");
assert.equal(sureText(confidenceOf(0.02), 0.3), "Sure: within 6 mm.");
assert.equal(sureText(confidenceOf(0.02), 0.3, true), "Unsure: may be off by 6 mm.");
assert.equal(sureText(confidenceOf(0.2), 12), "Unsure: may be off by 2.4 m.");
// Ears that move the head, and a body on four legs without a tail, are to be looked at.
const animal = [["Hips", [0, 1, 0]], ["Neck", [0, 1.1, 1]], ["Head", [0, 1.3, 1.2]], ["LeftEar", [0.1, 1.4, 1.2]], ["LeftUpLeg", [0.1, 0.9, 0]], ["LeftEar_end", [0.1, 1.6, 1.2]]].map(([name, position], j) => ({ name, position, parent: [-1, 0, 1, 2, 0, 3][j] }));
const skull = [0, 1.2, 1.2, 0, 1.3, 1.2, 0.1, 1.5, 1.2];
assert.deepEqual(earsThatMoveHeads(animal, [2, 2, 3], skull), []);
assert.deepEqual(earsThatMoveHeads(animal, [3, 3, 3], skull).map(({ name }) => name), ["LeftEar moves the head"]);
assert.deepEqual(missingTail(animal, 1).map(({ name }) => name), ["no tail was found"]);
assert.deepEqual(missingTail([...animal, { name: "Tail", position: [0, 1, -0.2], parent: 0 }], 1), []);
assert.deepEqual(missingTail(animal.map((joint) => (joint.name === "Neck" ? { ...joint, position: [0, 2, 0.1] } : joint)), 1), [], "a person");
// What the command's users read is said without its options.
assert.equal(sentenceOf("warning: which way is front is a coin toss for this mesh, so left and right may be exchanged; say it with --front, as in --front +z"), "Which way is front is a coin toss for this mesh, so left and right may be exchanged.");
assert.equal(sentenceOf("warning: the skeleton can be used with a probability of 1 %; look at the joints before using them, or try --method shape"), "The skeleton can be used with a probability of 1 %; look at the joints before using them.");
assert.equal(sentenceOf("2 attached meshes kept as they are; --bind-props binds them"), "2 attached meshes kept as they are.");
assert.equal(sentenceOf("strange.fbx: 3 points were left out"), "strange.fbx: 3 points were left out.");
assert.equal(sentenceOf("picture 'skin.png' was not found"), "Picture 'skin.png' was not found.");
console.log("skeleton_test: ok");
