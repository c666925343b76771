// SPDX-License-Identifier: MIT
// What the user wants of a bind, beside answers: the options of `sinew bind`, and which joints and vertices are switched off, locked or
// painted. Sets of names live with a character (its `source`) while its tab is open.

const $ = (id) => document.getElementById(id);

// What a change of each is called in the history.
const words = { method: "weights from", symmetric: "symmetric weights", "rigid-parts": "rigid parts", influences: "influences", softness: "softness" };

export class BindOptions {
  onChange = () => {};

  constructor() {
    for (const id of Object.keys(words)) $(id).onchange = () => this.onChange(words[id]);
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

  // What the user chose, to be kept and put back.
  get values() {
    return { method: $("method").value, symmetric: $("symmetric").checked, rigidParts: $("rigid-parts").value, softness: $("softness").value, influences: $("influences").value };
  }
  set values({ method, symmetric, rigidParts, softness, influences }) {
    $("method").value = method;
    $("symmetric").checked = symmetric;
    $("rigid-parts").value = rigidParts;
    $("softness").value = softness;
    $("influences").value = influences;
    this.#say();
  }

  // As web.cpp reads it. joints: of the character; source: {never, always} sets of names.
  wish({ joints, upAxis, source }) {
    const numbers = (names) => joints.flatMap(({ name }, j) => (names?.has(name) ? [j] : []));
    return {
      method: Number($("method").value),
      upAxis,
      symmetric: $("symmetric").checked,
      rigidParts: Number($("rigid-parts").value),
      softness: this.softness,
      influences: Number($("influences").value),
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
export function switched({ never = new Set(), always = new Set() }, name, isOff) {
  const [off, on] = [new Set(never), new Set(always)];
  if (isOff && !off.delete(name)) on.add(name);
  if (!isOff && !on.delete(name)) off.add(name);
  return { never: off, always: on };
}
