// SPDX-License-Identifier: MIT
// The panel of bends: how the mesh follows its joints, and how much of its volume every bend keeps by it.
import { $, all } from "./elements.js";

const mostRows = 6;
const fullBar = 150; // percent of the volume that fill a bar
const playedMilliseconds = 250; // figures that change faster cannot be read

// How good it is to keep that many percent, as a class of style.css.
/** @typedef {{ joint: number, degrees: number, kept: number }} Bend */
/** @type {(percent: number) => string} */
export const bendGrade = (percent) => (Math.abs(percent - 100) <= 7 ? "good" : Math.abs(percent - 100) <= 15 ? "fair" : "poor");

// Those farthest from keeping all first. bends: [{joint, kept}].
/** @type {(bends: Bend[]) => Bend[]} */
export const worstFirst = (bends) => [...bends].sort((a, b) => Math.abs(b.kept - 1) - Math.abs(a.kept - 1) || a.joint - b.joint).slice(0, mostRows);

export class BendPanel {
  /** @type {(...of: any[]) => any} */
  onChange = () => {}; // another way of skinning
  /** @type {(...of: any[]) => any} */
  onPick = () => {}; // joint
  #shown = -Infinity; // when the list was written

  constructor() {
    $("skinning").onchange = () => this.onChange();
    $("bends").onclick = (/** @type {any} */ { target }) => {
      const button = target.closest("button");
      if (button) this.onPick(Number(button.dataset.joint));
    };
  }

  // SkinMethod of skinning.hpp.
  get skinning() {
    return Number(all("#skinning input:checked")[0].value);
  }

  next() {
    const inputs = all("#skinning input");
    inputs[(this.skinning + 1) % inputs.length].checked = true;
    this.onChange();
  }

  // bends: of the module's last pose; playing: a motion runs, so that the list is written now and then.
  /** @param {Bend[]} bends @param {{ name: string }[]} joints @param {boolean} playing */
  show(bends, joints, playing) {
    const now = performance.now();
    if (playing && now - this.#shown < playedMilliseconds) return;
    this.#shown = now;
    const rows = worstFirst(bends).map((bend) => row(bend, joints[bend.joint].name));
    const more = bends.length - rows.length;
    $("bends-said").textContent = more > 0 ? `the worst ${rows.length} of ${bends.length}` : "";
    if (rows.length === 0) {
      const none = document.createElement("li");
      none.className = "none";
      none.textContent = "Rotate a bone to see how much volume its bend keeps.";
      rows.push(none);
    }
    // A row under the pointer or the keyboard is the same element as before.
    const list = $("bends");
    if (list.children.length === rows.length) rows.forEach((li, i) => update(list.children[i], li));
    else list.replaceChildren(...rows);
  }
}

/** @param {Bend} bend @param {string} name */
function row({ joint, degrees, kept }, name) {
  const percent = Math.round(100 * kept);
  const li = document.createElement("li");
  li.className = bendGrade(percent);
  const button = Object.assign(document.createElement("button"), { type: "button", title: `${name}, rotated by ${Math.round(degrees)}°: its bend keeps ${percent} % of its volume` });
  button.dataset.joint = String(joint);
  const bar = document.createElement("i");
  bar.style.setProperty("--share", `${Math.min(100, Math.max(0, (100 * percent) / fullBar))}%`);
  button.append(Object.assign(document.createElement("span"), { className: "name", textContent: name }), bar, Object.assign(document.createElement("b"), { textContent: `${percent} %` }));
  li.append(button);
  return li;
}

/** @param {any} old @param {any} wanted */
function update(old, wanted) {
  if (old.className === "none" || wanted.className === "none") return old.replaceWith(wanted);
  old.className = wanted.className;
  const [a, b] = [old.firstElementChild, wanted.firstElementChild];
  a.title = b.title;
  a.dataset.joint = b.dataset.joint;
  [...b.children].forEach((child, i) => {
    if (child.tagName === "I") a.children[i].style.cssText = child.style.cssText;
    else a.children[i].textContent = child.textContent;
  });
}
