// SPDX-License-Identifier: MIT
// What the page's panels compute, without a page: bends, figures of motions, words about maps, turns of joints.
import assert from "node:assert/strict";
import { bendGrade, worstFirst } from "../src/bends.js";
import { angleOf, frontAt, frontFound, frontOfJoints, placementDoubts, placementText, quarterOf } from "../src/dial.js";
import { treeOrder } from "../src/joint_list.js";
import { pinned, unpinned } from "../src/map_panel.js";
import { clipFigures, clipText } from "../src/methods.js";
import { draggable, dragged, longestSide } from "../src/outline.js";
import { turnsOf } from "../src/pose_panel.js";

assert.deepEqual([100, 93, 107, 92, 108, 85, 115, 84, 116, -20].map(bendGrade), ["good", "good", "good", "fair", "fair", "fair", "fair", "poor", "poor", "poor"]);
const bend = (joint, kept) => ({ joint, kept });
assert.deepEqual(worstFirst([bend(0, 0.99), bend(1, 1.2), bend(2, 0.5), bend(3, 0.8)]).map(({ joint }) => joint), [2, 1, 3, 0]);
assert.equal(worstFirst(Array.from({ length: 9 }, (_, j) => bend(j, 1))).length, 6);

const limb = (leg, before, after) => ({ joint: 0, leg, before, after });
const measure = (deepFrames, contactFrames, error) => ({ deepFrames, contactFrames, depth: 0, error });
const clip = {
  frames: 50,
  limbs: [
    limb(false, measure(20, 10, 0.02), measure(0, 10, 0.001)),
    limb(false, measure(5, 0, 0), measure(1, 0, 0)),
    limb(true, measure(0, 30, 0.004), measure(0, 30, 0.0001)),
    limb(true, measure(0, 10, 0), measure(0, 10, 0.0001)),
  ],
};
assert.deepEqual(clipFigures(clip, "before"), { deep: 0.25, slide: 0.003, touch: 0.02 });
assert.equal(clipText(clip), "Arms inside the body 1 % of frames (copied 25 %); standing feet slide 0.01 % of the height per frame (copied 0.30 %); touching hands are off by 0.1 % of the height (copied 2.0 %)");
assert.equal(clipText({ frames: 9, limbs: [] }), "");
const still = limb(true, measure(0, 5, 0), measure(0, 5, 0));
assert.equal(clipText({ frames: 9, limbs: [still] }), "Standing feet slide 0.00 % of the height per frame");

const pins = pinned(pinned(new Map(), 3, 7), 4, -1);
assert.deepEqual([...pins], [[3, 7], [4, -1]]);
assert.deepEqual([...pinned(pins, 5, 7)], [[4, -1], [5, 7]], "a joint of the motion is given once");
assert.deepEqual([...pinned(pins, 5, -1)], [[3, 7], [4, -1], [5, -1]], "several joints may have none");
assert.deepEqual([...pinned(pins, 3, 8)], [[4, -1], [3, 8]]);
assert.deepEqual([...unpinned(pins, 3)], [[4, -1]]);

const skeleton = [
  { parent: -1, partner: -1, named: -1 },
  { parent: 0, partner: 2, named: -1 },
  { parent: 0, partner: 1, named: -1 },
  { parent: 1, partner: -1, named: 2 },
];
assert.deepEqual(turnsOf(skeleton, [1], [10, 20, 30], false), [[1, [10, 20, 30]]]);
assert.deepEqual(turnsOf(skeleton, [1], [10, 20, 30], true), [[1, [10, 20, 30]], [2, [10, -20, -30]]]);
assert.deepEqual(turnsOf(skeleton, [1, 2], [10, 20, 30], true), [[1, [10, 20, 30]], [2, [10, 20, 30]]], "what is chosen turns as it is told");
assert.deepEqual(turnsOf(skeleton, [3], [10, 20, 30], true, 2), [[3, [10, 20, 30]], [2, [-10, -20, 30]]]);

// A square's corners are points, and so are places between them; what lies between two points goes along.
const square = [[0, 0], [100, 0], [100, 100], [0, 100]];
assert.equal(longestSide([square]), 100);
const [side] = draggable([square]);
const isPoint = ([x, y]) => side.points.some((at) => side.line[at][0] === x && side.line[at][1] === y);
assert.ok(square.every(isPoint));
assert.ok(side.points.length > 40 && draggable([square], 2)[0].points.length < side.points.length);
const corner = side.points.findIndex((at) => side.line[at][0] === 100 && side.line[at][1] === 0);
const away = dragged(side, corner, [120, -20]);
assert.deepEqual(away[side.points[corner]], [120, -20]);
const gone = away.flatMap((place, i) => (place === side.line[i] ? [] : [i]));
assert.deepEqual([gone[0], gone.at(-1)], [side.points[corner - 1] + 1, side.points[corner + 1] - 1]);
assert.ok(gone.every((i) => away[i][0] - side.line[i][0] > 0 && away[i][0] - side.line[i][0] <= 20));
const free = side.line.findIndex((_, i) => !side.points.includes(i));
assert.deepEqual(draggable([square], 1, side.line[free])[0].points, [...side.points, free].sort((one, other) => one - other), "what was moved last stays a point");
assert.equal(draggable([square], 1, [50, 50])[0].points.length, side.points.length, "nothing is near");
assert.equal(dragged(side, 0, [-5, -5]).filter((place, i) => place !== side.line[i]).length, gone.length, "the first point has a last one beside it");

// The dial: quarters from the viewer to the picture's right, with y up and with z up.
const ofQuarters = (fronts, up) => fronts.map((front) => quarterOf(angleOf(front, up)));
assert.deepEqual(ofQuarters([[0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0], [0.3, 0, 0.9], [-0.9, 0.1, 0.1]], 0), [0, 1, 2, 3, 0, 3]);
assert.deepEqual(ofQuarters([[0, -1, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0]], 1), [0, 1, 2, 3]);
assert.deepEqual([0, 1].map((up) => [0, 1, 2, 3].map((quarter) => frontAt(quarter, up))), [[1, 3, 2, 4], [6, 3, 5, 4]]);
const sides = (left, right) => [{ side: 1, position: left }, { side: -1, position: right }, { side: 0, position: [9, 9, 9] }, { side: 1, position: left }];
assert.deepEqual(frontOfJoints(sides([2, 1, 0], [-2, 1, 0]), 0).map(Math.round), [-0, 0, 1]);
assert.deepEqual(frontOfJoints(sides([0, 2, 1], [0, -2, 1]), 1).map(Math.round), [1, -0, 0]);
assert.equal(frontOfJoints(sides([2, 1, 0], [2, 0, 0]), 0), null);
const placed = { predicted: true, joints: [], upAxis: 0, up: 2, upSure: 0.6, front: [0, 0, 1], frontSure: 0.55 };
assert.deepEqual([placementDoubts(placed), placementDoubts({ ...placed, upSure: 1, frontSure: 0 }), placementDoubts({ ...placed, predicted: false })], [["up", "front"], [], []]);
assert.equal(placementText(placed, 0), "Up is Y (60 % sure). The front is +Z (55 % sure). Left and right may be exchanged: turn the arrow to the front. If it does not stand, tip it over.");
assert.equal(placementText({ ...placed, upSure: 1, frontSure: 0 }, 0), "Up is Y (sure). The front is +Z (a guess).");
assert.equal(placementText({ ...placed, predicted: false, joints: sides([0, 0, -1], [0, 0, 1]) }, 0), "Up is Y. The front is +X, by its bones.");
assert.equal(frontFound({ ...placed, front: null }, 0), null);

assert.deepEqual(treeOrder(skeleton), [0, 1, 3, 2]);
console.log("panels: ok");
