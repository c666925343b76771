// SPDX-License-Identifier: MIT
// Help inside the page: what the steps are for, and the keys.
import { $ } from "./elements.js";

const does = [
  ["Drop a mesh", "It gets bones and weights and walks. Red limbs may be wrong: in Skeleton, drag a bone, and its mirror image follows. Or mark parts of the body (Markers) and rig again."],
  ["It lies down or has the wrong size", "In Mesh, tip it over until it stands, turn the arrow to its front, set its height in meters and put it on the floor. In Skeleton, turn on T pose."],
  ["Drop a rigged file", "Its bones get new weights; Material, Weights and Confidence show the result."],
  ["Drop a motion", "A motion file moves the open character. In Motion, so does any animated file. Each file adds its clips."],
  ["Export", "Choose your program: the page says what the file will leave out. A project keeps everything you did."],
  ["Nothing is lost", "You can undo every step. This browser keeps the last eight characters that you worked on, with everything you did: resume them on the first page or in Mesh. A file that you drop on unsaved work opens beside it."],
];
const keys = [
  ["?", "this help"], ["Esc", "stop, close, select nothing"], ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["Ctrl+1 … 5", "the steps, with Alt on some browsers"], ["E", "skeleton, and back to weights"],
  ["4, 1, 3", "Material, Weights, Confidence"], ["5, 6", "artist's weights, difference"], ["7, 8, 9, F", "front, side, top, frame"],
  ["W, S", "wire, bones"], ["/", "search bones, arrow keys move"], ["N", "next limb to check"], ["A, M, Delete", "add a bone, center it, remove it"],
  ["X, L", "switch off or lock the bone"], ["B", "brush: add, smooth, off"], ["R", "reset the pose"], ["D", "skinning method"],
  ["Space, comma, dot", "play, previous and next frame"], ["C", "retargeting method"], ["G", "shake the character"],
];

/** @type {(tag: string, text: string) => HTMLElement} */
const cell = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });

export function showHelp() {
  const page = $("help-page");
  if (page.open) return page.close();
  if (page.childElementCount === 0) {
    const table = (/** @type {string[][]} */ rows, /** @type {boolean} */ head) => {
      const made = document.createElement("table");
      made.append(...rows.map(([a, b]) => {
        const tr = document.createElement("tr");
        const th = document.createElement("th");
        th.append(head ? cell("kbd", a) : cell("b", a));
        tr.append(th, cell("td", b));
        return tr;
      }));
      return made;
    };
    const columns = Object.assign(document.createElement("div"), { className: "columns" });
    columns.append(table(keys, true));
    const close = Object.assign(cell("button", "Close"), { type: "button", onclick: () => page.close() });
    page.append(cell("h2", "What you can do here"), table(does, false), cell("h2", "Keys"), columns, close);
  }
  page.showModal();
}
