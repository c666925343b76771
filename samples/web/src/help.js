// SPDX-License-Identifier: MIT
// Help inside the page: what the steps are for, and the keys.
import { $ } from "./elements.js";

const does = [
  ["Drop a mesh", "It gets joints and weights at once. Red limbs may be wrong: Skeleton, Next; drag a joint, its mirror partner follows. Or mark parts of the body (Markers) and rig again."],
  ["It lies or is too large", "Mesh: turn by 90°, height in metres, on the floor. Skeleton: T pose."],
  ["Drop a rigged file", "Its own joints are bound anew; Material, Weights and Doubt show the result."],
  ["Drop a motion", "A file with animations and no mesh moves the character that is open; in the Motion step any animated file does. Several are several clips."],
  ["Export", "A file for other programs, with all clips, or the project with everything that was done."],
  ["Nothing is lost", "Every step is undone by name. The last eight characters that you worked on are kept in this browser, each with all that was done: they are in the list of the first page and in Mesh. A file that is dropped on unsaved work opens beside it."],
];
const keys = [
  ["?", "this help"], ["Esc", "stop, close, choose nothing"], ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["Ctrl+1 … 5", "the steps, with Alt on some browsers"], ["E", "skeleton, and back to weights"],
  ["4, 1, 3", "Material, Weights, Doubt"], ["5, 6", "artist's weights, difference"], ["7, 8, 9, F", "front, side, top, frame"],
  ["W, S", "wire, bones"], ["/", "search joints, arrow keys step"], ["N", "next limb to check"], ["A, M, Delete", "add a joint, to the middle, remove"],
  ["X, L", "switch off, lock the joint"], ["B", "brush: add, smooth, off"], ["R", "reset the pose"], ["D", "way of skinning"],
  ["Space, comma, dot", "play, a frame back and on"], ["C", "method of retargeting"], ["G", "shake the character: see what swings"],
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
    const close = Object.assign(cell("button", "Close"), { type: "button", className: "primary", onclick: () => page.close() });
    page.append(cell("h2", "What to do here"), table(does, false), cell("h2", "Keys"), columns, close);
  }
  page.showModal();
}
