// SPDX-License-Identifier: MIT
// What picture and panel show of the open character's drawing, in the step Mesh.
import { draggable } from "./outline.js";
import { $, at } from "./state.js";

const leastRoom = 450; // pixels, in which the usual points lie apart

/** @type {import("./outline.js").Draggable[]} */
let outline = [];
export const shownOutline = () => outline;

// After any change of the drawing or the step.
export function showDrawing() {
  const picture = at.character?.picture;
  document.body.classList.toggle("drawn", Boolean(picture));
  if (!picture || at.step !== "mesh") return at.view.setDrawing(null, picture ? [0, 0.05, 1] : undefined);
  const { mesh, pictureWishes: wishes } = at.character.source;
  at.player.pause();
  outline = draggable(picture.outline, Math.min($("stage").clientWidth, $("stage").clientHeight) < leastRoom ? 2 : 1);
  at.view.setDrawing({ outline, lies: picture.place, width: picture.width, height: picture.height, file: at.files.get(mesh) });
  $("flat").checked = picture.flat;
  $("outline-found").disabled = !wishes?.outline?.length && !wishes?.mask;
  $("figure-field").hidden = picture.figures < 2;
  $("figure").replaceChildren(...Array.from({ length: picture.figures }, (_, i) => new Option(String(i + 1), String(i + 1))));
  $("figure").value = String(picture.figure);
}
