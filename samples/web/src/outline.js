// SPDX-License-Identifier: MIT
// Outlines of drawings as their user drags them: closed lines of pixels, x right, y down, with a few of their places as points to drag.

/** @typedef {number[]} Place [x, y] */
/** @typedef {{ line: Place[], points: number[] }} Draggable points: which places of the line can be dragged, in its order */

// Shares of the longest side.
const tolerance = 0.012; // that the line between points may be off
const farthest = 0.1; // between points, along the line
const step = 0.02; // between places of the line

const between = (/** @type {Place} */ a, /** @type {Place} */ b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** @param {Place[][]} outline */
export function longestSide(outline) {
  const side = (/** @type {number} */ axis) => {
    const all = outline.flatMap((line) => line.map((place) => place[axis]));
    return all.reduce((most, x) => Math.max(most, x), -Infinity) - all.reduce((least, x) => Math.min(least, x), Infinity);
  };
  return Math.max(side(0), side(1));
}

/**
 * With more places where they are farther apart than that.
 * @param {Place[]} line closed
 * @param {number} most
 */
function refined(line, most) {
  return line.flatMap((a, i) => {
    const b = line[(i + 1) % line.length];
    const parts = Math.max(1, Math.ceil(between(a, b) / most));
    return Array.from({ length: parts }, (_, p) => [a[0] + ((b[0] - a[0]) * p) / parts, a[1] + ((b[1] - a[1]) * p) / parts]);
  });
}

/**
 * @param {Place} p
 * @param {Place} a
 * @param {Place} b
 */
function offLine(p, a, b) {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const t = Math.min(1, Math.max(0, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y || 1)));
  return Math.hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}

/**
 * Corners of the line between two of its places, by Douglas and Peucker; of an arc that is too long its middle.
 * @param {Place[]} line
 * @param {number[]} lengths up to each place
 * @param {number} from
 * @param {number} to above line.length where the line has begun anew
 * @param {number} size longest side, the larger the fewer
 * @returns {number[]}
 */
function cornersBetween(line, lengths, from, to, size) {
  if (to - from < 2) return [];
  const at = (/** @type {number} */ i) => line[i % line.length];
  let worst = -1;
  let most = tolerance * size;
  for (let i = from + 1; i < to; ++i) {
    const off = offLine(at(i), at(from), at(to));
    if (off > most) [worst, most] = [i, off];
  }
  if (worst < 0) {
    if (lengths[to] - lengths[from] <= farthest * size) return [];
    const half = (lengths[from] + lengths[to]) / 2;
    worst = from + 1;
    while (worst + 1 < to && lengths[worst] < half) ++worst;
  }
  return [...cornersBetween(line, lengths, from, worst, size), worst, ...cornersBetween(line, lengths, worst, to, size)];
}

/**
 * An outline with points to drag: at its corners, and between them where those are far apart.
 * @param {Place[][]} outline
 * @param {number} spacing how much farther apart they are than usual, where there is little room
 * @param {Place | null} kept where there is one whatever the line is like: what was moved last
 * @returns {Draggable[]}
 */
export function draggable(outline, spacing = 1, kept = null) {
  const longest = longestSide(outline);
  const size = spacing * longest;
  const made = outline.map((given) => {
    const line = refined(given, step * longest);
    const lengths = [0];
    for (let i = 0; i < line.length; ++i) lengths.push(lengths[i] + between(line[i], line[(i + 1) % line.length]));
    const far = line.reduce((best, place, i) => (between(place, line[0]) > between(line[best], line[0]) ? i : best), 0);
    return { line, points: [0, ...cornersBetween(line, lengths, 0, far, size), far, ...cornersBetween(line, lengths, far, line.length, size)].filter((point, i, all) => all.indexOf(point) === i) };
  });
  return kept ? withPoint(made, kept, step * longest) : made;
}

/**
 * With a point at the place of a line that is nearest, where it is near.
 * @param {Draggable[]} outline
 * @param {Place} kept
 * @param {number} near
 */
function withPoint(outline, kept, near) {
  let best = { of: -1, at: -1, off: near };
  outline.forEach(({ line }, of) =>
    line.forEach((place, at) => {
      const off = between(place, kept);
      if (off < best.off) best = { of, at, off };
    }),
  );
  return outline.map((one, of) => (of !== best.of || one.points.includes(best.at) ? one : { ...one, points: [...one.points, best.at].sort((a, b) => a - b) }));
}

/**
 * The line with one of its points elsewhere. What lies between the points beside it goes along, the less the farther.
 * @param {Draggable} of
 * @param {number} point which of its points
 * @param {Place} to
 * @returns {Place[]}
 */
export function dragged({ line, points }, point, to) {
  const count = line.length;
  const at = points[point];
  const [x, y] = [to[0] - line[at][0], to[1] - line[at][1]];
  const out = [...line];
  out[at] = to;
  for (const [by, beside] of [[-1, points.at(point - 1)], [1, points[(point + 1) % points.length]]]) {
    const way = [at];
    for (let i = at; i !== beside && way.length <= count; ) way.push((i = (i + (by ?? 0) + count) % count));
    const lengths = way.map((_, k) => (k === 0 ? 0 : between(line[way[k - 1]], line[way[k]])));
    const whole = lengths.reduce((sum, length) => sum + length, 0) || 1;
    let gone = 0;
    for (let k = 1; k + 1 < way.length; ++k) {
      gone += lengths[k];
      const share = 1 - gone / whole;
      out[way[k]] = [line[way[k]][0] + share * x, line[way[k]][1] + share * y];
    }
  }
  return out;
}
