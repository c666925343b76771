// SPDX-License-Identifier: MIT
// Where a joint goes that is dragged: along the picture's plane, or to the middle of the limb behind the pointer. Plain
// numbers, no picture: points and directions are [x, y, z].

/** @type {(a: number[], b: number[]) => number} */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(from: number[], direction: number[], t: number) => number[]} */
const along = (from, direction, t) => from.map((x, axis) => x + direction[axis] * t);
/** @type {(a: number[], b: number[]) => number[]} */
const minus = (a, b) => a.map((x, axis) => x - b[axis]);

// Where a ray meets a surface, by distance: [{t, enters}]. positions: [V x 3]; triangles: [T x 3], corners counter-clockwise
// from outside. Distances are in lengths of the direction and may be negative. Moeller and Trumbore's test.
/** @param {{ positions: ArrayLike<number>, triangles: ArrayLike<number> }} surface @param {number[]} origin @param {number[]} direction */
export function crossings({ positions, triangles }, origin, direction) {
  const [ox, oy, oz] = origin;
  const [dx, dy, dz] = direction;
  const found = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const a = triangles[i] * 3;
    const b = triangles[i + 1] * 3;
    const c = triangles[i + 2] * 3;
    const ax = positions[a];
    const ay = positions[a + 1];
    const az = positions[a + 2];
    const ux = positions[b] - ax;
    const uy = positions[b + 1] - ay;
    const uz = positions[b + 2] - az;
    const vx = positions[c] - ax;
    const vy = positions[c + 1] - ay;
    const vz = positions[c + 2] - az;
    const px = dy * vz - dz * vy;
    const py = dz * vx - dx * vz;
    const pz = dx * vy - dy * vx;
    const facing = ux * px + uy * py + uz * pz; // above 0 where the ray meets the outside
    if (facing === 0) continue;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const first = (sx * px + sy * py + sz * pz) / facing;
    if (first < 0 || first > 1) continue;
    const qx = sy * uz - sz * uy;
    const qy = sz * ux - sx * uz;
    const qz = sx * uy - sy * ux;
    const second = (dx * qx + dy * qy + dz * qz) / facing;
    if (second < 0 || first + second > 1) continue;
    found.push({ t: (vx * qx + vy * qy + vz * qz) / facing, enters: facing > 0 });
  }
  return found.sort((a, b) => a.t - b.t);
}

// The stretches of a ray that lie within the surface: [[from, to]]. Parts that overlap are one stretch; a surface met
// twice at one place, on the edge of two triangles, counts once; sheets that are never left count for nothing. A mesh
// whose faces are all turned inwards is read backwards.
/** @param {{ t: number, enters: boolean }[]} met */
export function insides(met) {
  const last = met.at(-1);
  if (met.length < 2 || !last) return [];
  const near = 1e-6 * Math.max(last.t - met[0].t, Math.abs(last.t) * 1e-3);
  const once = met.filter(({ t, enters }, i) => !met.slice(Math.max(0, i - 8), i).some((other) => other.enters === enters && t - other.t <= near));
  const inverted = !once[0].enters && (once.at(-1) ?? last).enters;
  const stretches = [];
  let depth = 0;
  let from = 0;
  for (const { t, enters } of once) {
    if (enters !== inverted) {
      if (depth++ === 0) from = t;
    } else if (depth > 0 && --depth === 0 && t - from > near) {
      stretches.push([from, t]);
    }
  }
  return stretches;
}

// The middle of the stretch that holds `at`, else of the nearest one; null where the ray meets no inside.
/** @param {number[][]} stretches @param {number} at @returns {number | null} */
export function middleNear(stretches, at) {
  let best = null;
  let nearest = Infinity;
  for (const [from, to] of stretches) {
    const gap = Math.max(from - at, at - to, 0);
    if (gap < nearest) [best, nearest] = [(from + to) / 2, gap];
  }
  return best;
}

// Where a joint at `from` goes when it is dragged to a ray.
//   origin, direction  the ray from the eye through the pointer; its direction has length 1
//   forward            what the eye looks along: without more, the joint stays as far away as it was
//   plane              null, or {axis, at} for a joint that stands for both sides: it stays on that plane
//   surface            null, or {positions, triangles}: the joint goes to the middle of what the ray passes through there
/** @param {{ origin: number[], direction: number[], forward: number[], from: number[], plane?: { axis: number, at: number } | null, surface?: any }} ray */
export function draggedTo({ origin, direction, forward, from, plane = null, surface = null }) {
  const t = dot(minus(from, origin), forward) / dot(direction, forward);
  const free = along(origin, direction, t);
  if (plane === null) {
    const middle = surface ? middleNear(insides(crossings(surface, origin, direction)), t) : null;
    return middle === null ? free : along(origin, direction, middle);
  }
  const { axis, at } = plane;
  const across = Math.abs(direction[axis]);
  const onPlane = free.map((x, i) => (i === axis ? at : x));
  if (surface && across < 0.85) {
    // Seen from the front or nearly so: the height is the pointer's, the depth is the middle's.
    const flat = direction.map((x, i) => (i === axis ? 0 : x));
    const length = Math.hypot(...flat);
    const into = flat.map((x) => x / length);
    const middle = middleNear(insides(crossings(surface, onPlane, into)), 0);
    return middle === null ? onPlane : along(onPlane, into, middle);
  }
  if (across < 0.3) return onPlane;
  return along(origin, direction, (at - origin[axis]) / direction[axis]).map((x, i) => (i === axis ? at : x));
}
