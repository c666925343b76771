// SPDX-License-Identifier: MIT
// Motions to try a character with, as BVH of a human body of 1.7 units: they show hips, knees, shoulders and elbows.

// name, parent, offset from the parent; a T-pose that looks along +z.
/** @type {[string, number, number[]][]} */
const body = [
  ["Hips", -1, [0, 0.96, 0]],
  ["Spine", 0, [0, 0.12, 0]],
  ["Spine1", 1, [0, 0.14, 0]],
  ["Neck", 2, [0, 0.24, 0]],
  ["Head", 3, [0, 0.1, 0]],
  ["LeftShoulder", 2, [0.05, 0.18, 0]],
  ["LeftArm", 5, [0.13, 0, 0]],
  ["LeftForeArm", 6, [0.27, 0, 0]],
  ["LeftHand", 7, [0.25, 0, 0]],
  ["RightShoulder", 2, [-0.05, 0.18, 0]],
  ["RightArm", 9, [-0.13, 0, 0]],
  ["RightForeArm", 10, [-0.27, 0, 0]],
  ["RightHand", 11, [-0.25, 0, 0]],
  ["LeftUpLeg", 0, [0.09, -0.04, 0]],
  ["LeftLeg", 13, [0, -0.43, 0]],
  ["LeftFoot", 14, [0, -0.43, 0]],
  ["LeftToeBase", 15, [0, -0.06, 0.14]],
  ["RightUpLeg", 0, [-0.09, -0.04, 0]],
  ["RightLeg", 17, [0, -0.43, 0]],
  ["RightFoot", 18, [0, -0.43, 0]],
  ["RightToeBase", 19, [0, -0.06, 0.14]],
];
/** @type {Record<string, number[]>} */
const ends = { Head: [0, 0.2, 0], LeftHand: [0.15, 0, 0], RightHand: [-0.15, 0, 0], LeftToeBase: [0, 0, 0.07], RightToeBase: [0, 0, 0.07] };
const framesPerSecond = 30;
/** @type {(t: number) => number} */
const wave = (t) => Math.sin(2 * Math.PI * t);
/** @type {(t: number) => number} */
const ease = (t) => t * t * (3 - 2 * t);
/** @type {(t: number) => number} */
const thereAndBack = (t) => ease(t < 0.5 ? Math.min(1, 2.6 * t) : Math.min(1, 2.6 * (1 - t)));

// Degrees [x, z, y] of joints at time t of 0 to 1, and how far the hips are from their place. Arms hang by 68 degrees.
/** @param {number} t */
function walk(t) {
  const leg = (/** @type {number} */ phase) => ({ thigh: -26 * wave(t + phase), knee: 8 + 48 * Math.max(0, wave(t + phase + 0.22)) });
  const [left, right] = [leg(0), leg(0.5)];
  return {
    hips: [0, 0.012 * Math.cos(4 * Math.PI * t) - 0.03, 0],
    Hips: [3, 0, 5 * wave(t)], Spine: [0, 0, -5 * wave(t)], Spine1: [0, 0, -5 * wave(t)],
    LeftUpLeg: [left.thigh, 0, 0], LeftLeg: [left.knee, 0, 0], LeftFoot: [-0.35 * left.knee - 0.25 * left.thigh, 0, 0],
    RightUpLeg: [right.thigh, 0, 0], RightLeg: [right.knee, 0, 0], RightFoot: [-0.35 * right.knee - 0.25 * right.thigh, 0, 0],
    LeftArm: [24 * wave(t), -68, 0], LeftForeArm: [0, 0, -18 + 10 * wave(t)],
    RightArm: [-24 * wave(t), 68, 0], RightForeArm: [0, 0, 18 + 10 * wave(t)],
  };
}
/** @param {number} t */
function squat(t) {
  const down = thereAndBack(t);
  const thigh = -95 * down, knee = 120 * down;
  const radians = Math.PI / 180;
  const height = 0.43 * Math.cos(thigh * radians) + 0.43 * Math.cos((thigh + knee) * radians);
  const back = 0.43 * Math.sin(-thigh * radians) + 0.43 * Math.sin(-(thigh + knee) * radians);
  const leg = (/** @type {string} */ side) => ({ [`${side}UpLeg`]: [thigh, 0, 0], [`${side}Leg`]: [knee, 0, 0], [`${side}Foot`]: [-(knee + thigh), 0, 0] });
  return {
    hips: [0, height - 0.86, -back],
    Spine: [30 * down, 0, 0], Neck: [-15 * down, 0, 0],
    ...leg("Left"), ...leg("Right"),
    LeftArm: [-70 * down, -68 + 10 * down, 0], RightArm: [-70 * down, 68 - 10 * down, 0],
  };
}
/** @param {number} t */
function armsUp(t) {
  const up = thereAndBack(t);
  return {
    hips: [0, 0, 0],
    LeftShoulder: [0, 14 * up, 0], LeftArm: [0, -68 + 138 * up, 0], LeftForeArm: [0, 0, -12 * (1 - up)],
    RightShoulder: [0, -14 * up, 0], RightArm: [0, 68 - 138 * up, 0], RightForeArm: [0, 0, 12 * (1 - up)],
    Spine1: [-6 * up, 0, 0], Head: [-10 * up, 0, 0],
  };
}
/** @type {Record<string, { seconds: number, pose: (t: number) => Record<string, number[]> }>} */
const clips = {
  walk: { seconds: 1.1, pose: walk },
  squat: { seconds: 3, pose: squat },
  "arms up": { seconds: 3, pose: armsUp },
};

export const testClips = Object.keys(clips);

// The text of a BVH.
/** @param {string} name */
export function testClip(name) {
  const { seconds, pose } = clips[name];
  const lines = ["HIERARCHY"];
  const add = (/** @type {number} */ joint) => {
    const [joinedName, parent, offset] = body[joint];
    lines.push(`${parent < 0 ? "ROOT" : "JOINT"} ${joinedName}`, "{", `OFFSET ${offset.join(" ")}`);
    lines.push(parent < 0 ? "CHANNELS 6 Xposition Yposition Zposition Xrotation Zrotation Yrotation" : "CHANNELS 3 Xrotation Zrotation Yrotation");
    body.forEach((child, j) => child[1] === joint && add(j));
    if (ends[joinedName]) lines.push("End Site", "{", `OFFSET ${ends[joinedName].join(" ")}`, "}");
    lines.push("}");
  };
  add(0);
  const frames = Math.round(seconds * framesPerSecond) + 1;
  lines.push("MOTION", `Frames: ${frames}`, `Frame Time: ${1 / framesPerSecond}`);
  for (let f = 0; f < frames; ++f) {
    const at = pose(f / (frames - 1));
    const place = body[0][2].map((x, i) => x + at.hips[i]);
    lines.push([...place, ...body.flatMap(([joint]) => at[joint] ?? [0, 0, 0])].map((x) => x.toFixed(5)).join(" "));
  }
  return lines.join("\n");
}
