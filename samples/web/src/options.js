// SPDX-License-Identifier: MIT
// What the user wants of a bind, beside answers: the options of `sinew bind`, and which joints and vertices are switched off, locked or
// painted. Sets of names live with a character (its `source`) while its tab is open.
import { $ } from "./elements.js";

// What a change of each is called in the history.
/** @type {Record<string, string>} */
const words = { method: "weights from", symmetric: "symmetric weights", "rigid-parts": "rigid parts", influences: "influences", softness: "softness", "t-pose": "T pose" };

export class BindOptions {
  #pose = "";
  /** @type {(...of: any[]) => any} */
  onChange = () => {};
  #first; // values as the page begins

  constructor() {
    this.#first = this.values;
    for (const id of Object.keys(words)) $(id).onchange = () => this.onChange(words[id]);
    $("t-pose").onclick = () => {
      this.toPose = this.toPose ? "" : "t";
      this.onChange(words["t-pose"]);
    };
    $("softness").oninput = () => this.#say();
    $("softness").ondblclick = () => {
      $("softness").value = "0";
      this.#say();
      this.onChange(words.softness);
    };
    this.#say();
  }

  // 2 ^ the slider's place: 1/4 to 4, as --softness has it.
  get softness() {
    return Math.round(100 * 2 ** Number($("softness").value)) / 100;
  }

  // The rest pose that is shown and saved: "t", "a" while a file needs it, or "" as the mesh stands.
  get toPose() {
    return this.#pose;
  }
  set toPose(pose) {
    this.#pose = pose;
    $("t-pose").ariaPressed = String(pose === "t");
  }

  // What the user chose, to be kept and put back.
  get values() {
    return { toPose: this.toPose, method: $("method").value, symmetric: $("symmetric").checked, rigidParts: $("rigid-parts").value, softness: $("softness").value, influences: $("influences").value };
  }
  set values({ toPose = "", method, symmetric, rigidParts, softness, influences }) {
    this.toPose = toPose;
    $("method").value = method;
    $("symmetric").checked = symmetric;
    $("rigid-parts").value = rigidParts;
    $("softness").value = softness;
    $("influences").value = influences;
    this.#say();
  }

  // Another character has none of the one before.
  reset() {
    this.values = this.#first;
  }

  // As web.cpp reads it. joints: of the character; source: {never, always} sets of names.
  /** @param {any} character that is open */
  wish({ joints, upAxis, source }) {
    const numbers = (/** @type {Set<string>} */ names) => joints.flatMap((/** @type {{ name: string }} */ { name }, /** @type {number} */ j) => (names?.has(name) ? [j] : []));
    return {
      method: Number($("method").value),
      upAxis,
      symmetric: $("symmetric").checked,
      rigidParts: Number($("rigid-parts").value),
      softness: this.softness,
      influences: Number($("influences").value),
      toPose: this.toPose,
      never: numbers(source.never),
      always: numbers(source.always),
    };
  }

  #say() {
    $("softness").nextElementSibling.textContent = `${this.softness} ×`;
    $("softness").disabled = $("method").value === "1";
  }
}

// source with the joint switched the other way round: {never, always}. isOff: as the last bind had it.
/** @param {{ never?: Set<string>, always?: Set<string> }} source @param {string} name @param {boolean} isOff */
export function switched({ never = new Set(), always = new Set() }, name, isOff) {
  const [off, on] = [new Set(never), new Set(always)];
  if (isOff && !off.delete(name)) on.add(name);
  if (!isOff && !on.delete(name)) off.add(name);
  return { never: off, always: on };
}
