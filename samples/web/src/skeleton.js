// SPDX-License-Identifier: MIT
// The panel in which a skeleton is edited: what the chosen joint is, and the user's wishes as edits. Joints are the module's:
// {name, parent, position, side, end, partner, confidence}; edits are its SkeletonEdit.
import { $ } from "./elements.js";
import { sentenceOf } from "./sentences.js";

export const editKinds = { move: 0, add: 1, remove: 2, parent: 3, rename: 4, at: 5 };
const sureSpread = 0.03; // of the votes, share of the longest side: good, says sinew/rig.h
const unsureSpread = 0.1; // above it nobody knows, says the same header
const unsure = [
  [235, 240, 246],
  [255, 214, 102],
  [240, 130, 40],
  [225, 30, 45],
]; // from sure to unsure, as the legend has it

// How far off the votes for a joint think they are, share of the longest side: confidence is 1 / (1 + spread / 0.05)^2
// (engine/src/rig/clusters.hpp).
export const spreadOf = (confidence) => 0.05 * (1 / Math.sqrt(Math.max(confidence, 1e-4)) - 1);

// How far off a joint may be, as a person says it. size: the longest side, in meters; isDoubtful: its limb may be wrong as a whole.
/** @type {(confidence: number, size: number, isDoubtful?: boolean) => string} */
export function sureText(confidence, size, isDoubtful = false) {
  const spread = spreadOf(confidence), off = spread * size;
  const length = off >= 1 ? `${off.toFixed(1)} m` : off >= 0.01 ? `${Math.round(100 * off)} cm` : `${Math.max(1, Math.round(1000 * off))} mm`;
  if (spread <= sureSpread && !isDoubtful) return `Sure: within ${length}.`;
  return `${spread <= unsureSpread && !isDoubtful ? "Fairly sure" : "Unsure"}: may be off by ${length}.`;
}

// The colour of a joint's confidence, sRGB: that of the first row up to 3 % off, that of the last one from 10 %.
export function sureColour(confidence) {
  const share = (spreadOf(confidence) - sureSpread) / (unsureSpread - sureSpread);
  const at = Math.min(1, Math.max(0, share)) * (unsure.length - 1);
  const below = Math.min(unsure.length - 2, Math.floor(at));
  return unsure[below].map((c, i) => c + (unsure[below + 1][i] - c) * (at - below));
}

// Joints that may carry this one: neither bone ends nor what hangs on it.
export function possibleParents(joints, joint) {
  const hangs = (j) => {
    for (let above = j, steps = 0; above >= 0 && steps <= joints.length; above = joints[above].parent, ++steps) if (above === joint) return true;
    return false;
  };
  return joints.map((_, j) => j).filter((j) => !joints[j].end && !hangs(j));
}

// The joints as the module will have them when one is moved, to be shown until it has answered: bone ends go along, a
// joint on the mirror plane stays there, and where both sides are alike its partner goes to the mirror image.
/**
 * @param {import("./types.js").Joint[]} joints
 * @param {number} joint
 * @param {number[]} place
 * @param {{ mirrored?: boolean, axis: number, plane: number }} mirror
 * @param {boolean} alike
 */
export function movedJoints(joints, joint, place, { mirrored, axis, plane }, alike) {
  const isMirrored = Boolean(mirrored) && alike;
  const image = (p) => p.map((x, i) => (i === axis ? 2 * plane - x : x));
  const moved = joints.map((one) => ({ ...one }));
  const put = (j, to) => {
    const from = joints[j].position;
    for (const one of moved) {
      if (one.end && one.parent === j) one.position = one.position.map((x, i) => x + to[i] - from[i]);
    }
    moved[j].position = to;
  };
  const { partner } = joints[joint];
  const to = isMirrored && partner === joint ? place.map((x, i) => (i === axis ? plane : x)) : place;
  if (isMirrored && partner >= 0 && partner !== joint) put(partner, image(to));
  put(joint, to);
  return moved;
}

// A name for a new child that no joint has, on both sides where the child comes on both.
export function freeName(joints, { mirrored, axis, plane }, parent, alike) {
  const taken = new Set(joints.map(({ name }) => name));
  const { side, partner, position } = joints[parent];
  const isPair = mirrored && alike && partner >= 0 && partner !== parent;
  const isLeft = side !== 0 ? side > 0 : position[axis] > plane;
  for (let n = 1; ; ++n) {
    const base = `Joint${n === 1 ? "" : n}`;
    const names = isPair ? [`Left${base}`, `Right${base}`] : [base];
    if (names.every((name) => !taken.has(name))) return names[isPair && !isLeft ? 1 : 0];
  }
}

// Where a new child begins: onwards by half of the bone that leads to its parent; from a root, upwards.
export function childPlace(joints, parent, size, upAxis) {
  const { position, parent: above } = joints[parent];
  if (above < 0) return position.map((x, axis) => x + (axis === (upAxis === 1 ? 2 : 1) ? 0.1 * size : 0));
  return position.map((x, axis) => x + (x - joints[above].position[axis]) / 2);
}

// Answers that name a joint, for the joints that there are now; those whose joint is gone are left out.
export function answersFor(answers, before, after, rigid) {
  const alike = before.length === after.length && before.every(({ parent }, j) => parent === after[j].parent); // renamed at most
  return answers.flatMap((answer) => {
    if (answer.kind !== rigid) return [answer];
    const { name } = before[answer.joint];
    const named = after.findIndex((joint) => joint.name === name);
    const joint = named < 0 && alike ? answer.joint : named;
    return joint < 0 ? [] : [{ ...answer, joint, answer: `rigid:${after[joint].name}` }];
  });
}

const axes = ["x", "y", "z"];

export class SkeletonEditor {
  /** @type {(...of: any[]) => any} */
  onEdit = () => {}; // [edits], the name of the joint that is chosen then
  /** @type {(...of: any[]) => any} */
  onPredict = () => {}; // wishes
  /** @type {(...of: any[]) => any} */
  onMiddle = () => {}; // the chosen joint to the middle of its limb
  /** @type {any} */
  #character = null;
  #joint = -1;
  #first; // wishes as the page begins

  constructor() {
    $("rename").onchange = () => {
      const other = $("rename").value.trim();
      const { name } = this.#character.joints[this.#joint];
      if (other === "" || other === name) return this.show(this.#character, this.#joint);
      this.onEdit([{ kind: editKinds.rename, joint: name, other }], other);
    };
    $("rename").onkeydown = ({ key }) => {
      if (key === "Enter") $("rename").blur(); // the page's keys are back
    };
    $("parent").onchange = () => {
      const { joints } = this.#character;
      const { name } = joints[this.#joint];
      this.onEdit([{ kind: editKinds.parent, joint: name, other: joints[Number($("parent").value)].name }], name);
    };
    axes.forEach((axis, i) => {
      $(`place-${axis}`).onchange = ({ target }) => {
        if (!Number.isFinite(target.valueAsNumber)) return this.showPlace();
        this.move(this.#character.joints[this.#joint].position.map((x, other) => (other === i ? target.valueAsNumber : x)));
      };
    });
    for (let count = 1; count <= 16; ++count) $("spine").append(new Option(String(count), String(count)));
    $("add-joint").onclick = () => this.add();
    $("remove-joint").onclick = () => this.remove();
    $("to-middle").onclick = () => this.onMiddle();
    $("predict").onclick = () => this.onPredict(this.wishes);
    this.#first = this.wishes;
    for (const id of ["detail", "spine", "toes", "ends", "mirror", "kind", "front"]) $(id).onchange = () => this.#character?.predicted && this.onPredict(this.wishes, id);
  }

  get alike() {
    return $("alike").checked;
  }
  // As SkeletonOptions has them, and the number of a SkeletonDetail.
  get wishes() {
    return { category: Number($("kind").value), front: Number($("front").value), detail: Number($("detail").value), spine: Number($("spine").value), toes: $("toes").checked, ends: $("ends").checked, mirror: Number($("mirror").value) };
  }

  set wishes({ category, front, detail, spine, toes, ends, mirror }) {
    for (const [id, value] of Object.entries({ kind: category, front, detail, spine, mirror })) $(id).value = String(value);
    $("toes").checked = toes;
    $("ends").checked = ends;
  }
  // wishes: of the skeleton that is there, or null: as the page begins.
  showWishes(wishes) {
    this.wishes = wishes ?? this.#first;
  }

  get canEdit() {
    return Boolean(this.#character?.editable) && !this.#character.posed && this.#joint >= 0;
  }

  move(place) {
    const { name } = this.#character.joints[this.#joint];
    this.onEdit([{ kind: editKinds.move, joint: name, place }], name);
  }

  add() {
    if (!this.canEdit || this.#character.joints[this.#joint].end) return;
    const { joints, size, upAxis } = this.#character;
    const name = freeName(joints, this.#character, this.#joint, this.alike);
    const place = childPlace(joints, this.#joint, size, upAxis);
    this.onEdit([{ kind: editKinds.add, joint: name, other: joints[this.#joint].name, place }], name);
  }

  remove() {
    if (!this.canEdit) return;
    const { name, parent } = this.#character.joints[this.#joint];
    this.onEdit([{ kind: editKinds.remove, joint: name }], this.#character.joints[parent]?.name);
  }

  // character: what is open, or null; joint: what is chosen, or -1.
  show(character, joint) {
    this.#character = character;
    this.#joint = joint;
    const chosen = character?.joints[joint];
    const canEdit = this.canEdit;
    $("edit-name").textContent = chosen?.name ?? "No bone selected";
    $("edit-sure").textContent = chosen && character.predicted ? this.#sureText(chosen) : "";
    $("edit-notes").textContent = character?.predicted ? (character.notes ?? []).filter((note) => !/^warning: (doubtful|this mesh resembles)/.test(note)).map(sentenceOf).join(" ") : "";
    $("edit-none").hidden = !character || (character.editable && !character.posed) || character.joints.length === 0;
    $("edit-none").textContent = character?.posed ? "Bones cannot be edited in T pose. Turn T pose off first." : "This skeleton came with the file and cannot be edited. Make a new one to edit it.";
    for (const id of ["rename", "parent", "remove-joint", "to-middle", ...axes.map((axis) => `place-${axis}`)]) $(id).disabled = !canEdit;
    $("add-joint").disabled = !canEdit || chosen.end;
    $("rename").value = chosen?.name ?? "";
    this.showPlace();
    const parents = canEdit ? possibleParents(character.joints, joint) : [];
    const none = chosen?.parent < 0 ? [new Option("none: the root", "-1", true, true)] : [];
    $("parent").replaceChildren(...none, ...parents.map((j) => new Option(character.joints[j].name, j)));
    if (none.length > 0) none[0].disabled = true;
    if (chosen) $("parent").value = String(chosen.parent);
    $("alike").disabled = !character?.mirrored;
    $("predict").disabled = !character;
  }

  showPlace() {
    const chosen = this.#character?.joints[this.#joint];
    axes.forEach((axis, i) => ($(`place-${axis}`).value = chosen ? Number(chosen.position[i].toPrecision(4)) : ""));
  }

  #sureText({ confidence }) {
    return confidence === 1 ? "You placed this bone." : sureText(confidence, this.#character.size, (this.#character.doubts ?? []).some(({ joints }) => joints.includes(this.#joint)));
  }
}
