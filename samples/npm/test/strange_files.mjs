// SPDX-License-Identifier: MIT
// Files as strangers make them, small: meshes that hang on joints, props, bone ends with and without weight, controls, FBX and COLLADA.
import { strangeDae, strangeFbx } from "../../web/test/scene_files.mjs";

// A tube of rings of four along the joints of a body, a box on its last joint, a control beside it.
// names: of hip, spine, head, tip, control; hanging: the box is a node below the head, else part of nothing; weighted: the tube has weights.
function glb({ names, hanging = false, weighted = false }) {
  const heights = [0, 0.5, 1, 1.3], chunks = [], views = [], accessors = [];
  const put = (array, type, count, extra = {}) => {
    const bytes = Buffer.from(array.buffer), at = chunks.reduce((sum, one) => sum + one.length, 0);
    chunks.push(bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4));
    views.push({ buffer: 0, byteOffset: at, byteLength: bytes.length });
    const componentType = array instanceof Float32Array ? 5126 : array instanceof Uint32Array ? 5125 : 5123;
    accessors.push({ bufferView: views.length - 1, componentType, count, type, ...extra });
    return accessors.length - 1;
  };
  const rings = 14, points = [], indices = [];
  for (let r = 0; r < rings; ++r) for (const [x, z] of [[1, 0], [0, 1], [-1, 0], [0, -1]]) points.push(0.12 * x, (1.3 * r) / (rings - 1), 0.12 * z);
  for (let r = 0; r + 1 < rings; ++r)
    for (let i = 0; i < 4; ++i) {
      const [a, b] = [4 * r + i, 4 * r + ((i + 1) % 4)];
      indices.push(a, b, a + 4, b, b + 4, a + 4);
    }
  const bounds = (list) => ({ min: [0, 1, 2].map((k) => Math.min(...list.filter((_, i) => i % 3 === k))), max: [0, 1, 2].map((k) => Math.max(...list.filter((_, i) => i % 3 === k))) });
  const shape = (list, faces) => ({ POSITION: put(Float32Array.from(list), "VEC3", list.length / 3, bounds(Array.from(Float32Array.from(list)))), indices: put(Uint32Array.from(faces), "SCALAR", faces.length) });
  const tube = shape(points, indices);
  const box = shape([0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1], [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  const joints = new Uint16Array((4 * points.length) / 3), weights = new Float32Array(joints.length);
  for (let v = 0; v < points.length / 3; ++v) {
    const y = points[3 * v + 1], j = y < 0.5 ? 0 : y < 1 ? 1 : 2;
    joints.set([j, weighted ? 3 : 0, 0, 0], 4 * v);
    weights.set(weighted && y > 1.2 ? [0.5, 0.5, 0, 0] : [1, 0, 0, 0], 4 * v);
  }
  const binds = new Float32Array(names.length * 16);
  names.forEach((_, j) => binds.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, j === 4 ? -0.5 : 0, j === 4 ? 0 : -heights[j], 0, 1], 16 * j));
  const skinned = { POSITION: tube.POSITION, JOINTS_0: put(joints, "VEC4", joints.length / 4), WEIGHTS_0: put(weights, "VEC4", weights.length / 4) };
  const nodes = names.map((name, j) => ({ name, translation: j === 4 ? [0.5, 0, 0] : [0, j === 0 ? 0 : heights[j] - heights[j - 1], 0] }));
  for (let j = 0; j < 3; ++j) nodes[j].children = [j + 1];
  nodes[0].children.push(4);
  nodes.push({ name: "body", mesh: 0, skin: 0 }, { name: "hat", mesh: 1, translation: [0, 0.2, 0] });
  if (hanging) nodes[2].children.push(6);
  const document = {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: hanging ? [0, 5] : [0, 5, 6] }], nodes, accessors, bufferViews: views,
    meshes: [{ name: "body", primitives: [{ attributes: skinned, indices: tube.indices }] }, { name: "hat", primitives: [{ attributes: { POSITION: box.POSITION }, indices: box.indices }] }],
    skins: [{ joints: [0, 1, 2, 3, 4], inverseBindMatrices: put(binds, "MAT4", names.length) }],
  };
  const bin = Buffer.concat(chunks);
  document.buffers = [{ byteLength: bin.length }];
  const text = Buffer.from(JSON.stringify(document)), json = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
  const head = Buffer.alloc(20), second = Buffer.alloc(8);
  head.write("glTF");
  [2, 28 + json.length + bin.length, json.length, 0x4e4f534a].forEach((word, i) => head.writeUInt32LE(word, 4 + 4 * i));
  second.writeUInt32LE(bin.length, 0);
  second.writeUInt32LE(0x004e4942, 4);
  return Buffer.concat([head, json, second, bin]);
}

// {name: bytes}
export const strangeFiles = () => ({
  "hanging.glb": glb({ names: ["Hips", "Spine", "Head", "Head_tip", "IK_pole"], hanging: true }),
  "named.glb": glb({ names: ["pelvis", "spine_01", "head", "head_end", "ctrl_root"] }),
  "weighted.glb": glb({ names: ["Hips", "Spine", "Head", "Head_tip", "Pole"], hanging: true, weighted: true }),
  "strange.fbx": strangeFbx(),
  "meters.fbx": strangeFbx({ unit: 100, up: "y", size: 1.83 }),
  "strange.dae": strangeDae(),
  "skin.png": Buffer.from("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/PchI7wAAAABJRU5ErkJggg==", "base64"),
  "broken.fbx": Buffer.from("no fbx"),
  "bare.obj": Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
});
