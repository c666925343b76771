// SPDX-License-Identifier: MIT
// The dial in the step Mesh: the character from above with its front, which a drag of the arrow sets; beside it what the engine found for up and front, and how sure it is.
import { $, all } from "./elements.js";
import { extentsOf } from "./sides.js";

// The horizontal axes of the picture, seen from above: to its right, and toward who looks from the front.
/** @type {Record<number, { right: number, near: number, sign: number }>} */
const planes = { 0: { right: 0, near: 2, sign: 1 }, 1: { right: 0, near: 1, sign: -1 } }; // by upAxis; sign: of the axis toward the viewer
// sinew_front of each quarter, from the viewer to the picture's right, by upAxis.
/** @type {Record<number, number[]>} */
const fronts = { 0: [1, 3, 2, 4], 1: [6, 3, 5, 4] };
/** @type {Record<number, string[]>} */
const names = { 0: ["+Z", "+X", "−Z", "−X"], 1: ["−Y", "+X", "+Y", "−X"] };
const mostPoints = 3000; // of the picture
const flat = 0.05; // of the longest side: who is less wide from the front is seen on edge
const radius = 34; // of the picture in the dial, whose half side is 60

export const doubtful = 0.7; // below this probability the engine warns, see kCoinToss

/** @type {(quarter: number) => number} */
const within = (quarter) => ((Math.round(quarter) % 4) + 4) % 4;

// The front of joints that have sides: from the right ones to the left ones, turned to the front. Null: none has.
/** @param {import("./types.js").Joint[]} joints @param {number} upAxis @returns {number[] | null} */
export function frontOfJoints(joints, upAxis) {
  const [left, right] = [1, -1].map((wanted) => joints.filter(({ side }) => side === wanted));
  if (left.length === 0 || right.length === 0) return null;
  const mean = (/** @type {import("./types.js").Joint[]} */ list, /** @type {number} */ i) => list.reduce((sum, { position }) => sum + position[i], 0) / list.length;
  const [x, y, z] = [0, 1, 2].map((i) => mean(left, i) - mean(right, i));
  const front = upAxis === 1 ? [y, -x, 0] : [-z, 0, x]; // left x up
  const length = Math.hypot(...front);
  return length > 1e-6 ? front.map((one) => one / length) : null;
}

// Radians from the viewer to the picture's right.
/** @param {number[]} front @param {number} upAxis */
export function angleOf(front, upAxis) {
  const { right, near, sign } = planes[upAxis];
  return Math.atan2(front[right], sign * front[near]);
}
/** @type {(angle: number) => number} */
export const quarterOf = (angle) => within((2 * angle) / Math.PI);
/** @type {(quarter: number, upAxis: number) => number} */
export const frontAt = (quarter, upAxis) => fronts[upAxis][quarter];

// What was found or told of a character's front: {front: unit vector, sure: 0..1, told}; null where nothing is known. A sure of 0: nobody counted.
/** @param {any} character @param {number} told sinew_front, 0: none */
export function frontFound({ predicted, front, frontSure, joints, upAxis }, told) {
  if (predicted) return front ? { front, sure: frontSure, told: told !== 0 } : null;
  const ofJoints = frontOfJoints(joints, upAxis);
  return ofJoints && { front: ofJoints, sure: 1, told: false };
}

// The quarter that a character faces, and whether it is flat and seen on edge from there.
/** @param {any} character */
function facedQuarter(character) {
  const { picture, upAxis, buffers } = character, found = picture ? null : frontFound(character, 0);
  if (!found) return { quarter: 0, isEdge: false };
  const quarter = quarterOf(angleOf(found.front, upAxis)), { right, near } = planes[upAxis], sides = extentsOf(buffers.positions);
  return { quarter, isEdge: sides[quarter % 2 === 0 ? right : near] < flat * Math.max(...sides) };
}

/** @param {any} character */
export const isSeenOnEdge = (character) => facedQuarter(character).isEdge;

// From where a character is looked at, radians from the viewer to the picture's right: from its front, and one that is flat from beside its plane.
/** @param {any} character */
export function facingOf(character) {
  const { quarter, isEdge } = facedQuarter(character);
  return ((isEdge ? (quarter + 1) % 2 : quarter) * Math.PI) / 2;
}

// What is to be settled before the bones can be right: "up", "front".
/** @param {any} character */
export const placementDoubts = ({ predicted, frontSure, upSure }) => (predicted ? [...(upSure < doubtful ? ["up"] : []), ...(frontSure > 0 && frontSure < doubtful ? ["front"] : [])] : []);

/** @type {(sure: number, told: boolean) => string} */
const howSure = (sure, told) => (told ? "as you set it" : sure === 0 ? "a guess" : sure > 0.99 ? "sure" : `${Math.round(100 * sure)} % sure`);

/** @param {any} character @param {number} told */
export function placementText(character, told) {
  const { upAxis, up, upSure, predicted, joints } = character;
  const found = frontFound(character, told);
  const upright = `Up is ${upAxis === 1 ? "Z" : "Y"}${predicted || up !== 2 ? ` (${howSure(upSure, up !== 2)})` : ""}.`;
  if (!found) return `${upright}${joints.length > 0 ? " Its bones do not say where the front is." : ""}`;
  const name = names[upAxis][quarterOf(angleOf(found.front, upAxis))];
  if (!predicted) return `${upright} The front is ${name}, by its bones.`;
  const doubts = placementDoubts(character);
  return `${upright} The front is ${name} (${howSure(found.sure, found.told)}).${doubts.includes("front") ? " Left and right may be exchanged: turn the arrow to the front." : ""}${doubts.includes("up") ? " If it does not stand, tip it over." : ""}`;
}

// Points of the mesh from above, as a path of dots.
/** @param {ArrayLike<number>} positions @param {number} upAxis */
function dotsOf(positions, upAxis) {
  const { right, near, sign } = planes[upAxis];
  const step = 3 * Math.max(1, Math.ceil(positions.length / 3 / mostPoints));
  /** @type {number[][]} */
  const points = [];
  for (let v = 0; v < positions.length; v += step) points.push([positions[v + right], sign * positions[v + near]]);
  const [low, high] = [Math.min, Math.max].map((most) => [0, 1].map((i) => points.reduce((sum, point) => most(sum, point[i]), points[0][i])));
  const middle = low.map((x, i) => (x + high[i]) / 2), scale = radius / (Math.hypot(high[0] - low[0], high[1] - low[1]) / 2 || 1);
  return points.map((point) => `M${point.map((x, i) => ((x - middle[i]) * scale).toFixed(1)).join(" ")}h.1`).join("");
}

export class PlacementDial {
  /** @type {(front: number) => void} */
  onFront = () => {}; // sinew_front
  /** @type {any} */
  #character = null;
  /** @type {any} */
  #drawn = null; // positions and up axis that the picture is of

  constructor() {
    const ring = $("dial-ring");
    const angleAt = (/** @type {PointerEvent} */ { clientX, clientY }) => {
      const { left, top, width, height } = ring.getBoundingClientRect();
      return Math.atan2(clientX - left - width / 2, clientY - top - height / 2);
    };
    const turnTo = (/** @type {PointerEvent} */ event) => ring.hasPointerCapture(event.pointerId) && this.#point(angleAt(event));
    ring.onpointerdown = (/** @type {PointerEvent} */ event) => {
      if (!this.canTurn) return;
      ring.setPointerCapture(event.pointerId);
      turnTo(event);
    };
    ring.onpointermove = turnTo;
    ring.onpointercancel = () => this.show(this.#character);
    ring.onpointerup = (/** @type {PointerEvent} */ event) => {
      if (ring.hasPointerCapture(event.pointerId)) this.onFront(frontAt(quarterOf(angleAt(event)), this.#character.upAxis));
    };
  }

  // A file's own skeleton says where its front is.
  get canTurn() {
    return Boolean(this.#character?.predicted);
  }

  /** @param {number} angle */
  #point(angle) {
    $("dial-arrow").setAttribute("transform", `rotate(${((-angle * 180) / Math.PI).toFixed(1)})`);
  }

  // character: the open one, or null.
  /** @param {any} character */
  show(character) {
    this.#character = character;
    const { placeable = false, upAxis = 0, source = null } = character ?? {};
    const told = Number($("front").value), found = character && frontFound(character, told);
    for (const button of all("#dial button")) button.disabled = !placeable;
    for (const id of ["floor", "height"]) $(id).disabled = !placeable;
    $("front").disabled = !this.canTurn;
    $("floor").checked = Boolean(source?.placement?.floor);
    $("height").value = character?.tall ? Number(character.tall[upAxis].toPrecision(4)) : "";
    all("#dial-ring text").forEach((text, quarter) => (text.textContent = names[upAxis][quarter]));
    $("dial-arrow").style.display = found ? "" : "none";
    if (found) this.#point(angleOf(found.front, upAxis));
    $("dial").classList.toggle("fixed", !this.canTurn);
    $("dial").classList.toggle("doubtful", Boolean(character && placementDoubts(character).length > 0));
    $("dial-said").textContent = character ? placementText(character, told) : "";
    $("face-viewer").disabled = !placeable || !found || quarterOf(angleOf(found.front, upAxis)) === 0;
    if (!character || (this.#drawn?.positions === character.buffers.positions && this.#drawn?.upAxis === upAxis)) return;
    this.#drawn = { positions: character.buffers.positions, upAxis };
    $("dial-mesh").setAttribute("d", dotsOf(character.buffers.positions, upAxis));
  }
}
