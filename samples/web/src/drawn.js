// SPDX-License-Identifier: MIT
// What picture and panel show of the open character's drawing, in the step Mesh.
import { draggable } from "./outline.js";
import { $, at } from "./state.js";

const leastRoom = 450; // pixels, in which the usual points lie apart

/** @type {import("./outline.js").Draggable[]} */
let outline = [];
export const shownOutline = () => outline;

// The point that is worked on by numbers: its pixel, which stays when points are found anew; null for none.
/** @type {number[] | null} */
let chosen = null;
const points = () => outline.flatMap(({ line, points: all }, of) => all.map((place, point) => ({ of, point, pixel: line[place] })));
/** @param {number[] | null} pixel */
export function choosePoint(pixel) {
  chosen = pixel;
  showPoint();
}
// {of, point, pixel} of the number in the panel.
export const pointOfNumber = () => points()[Math.min(points().length, Math.max(1, $("point").valueAsNumber || 1)) - 1];

function showPoint() {
  const all = points();
  const off = (/** @type {number[]} */ pixel) => Math.hypot(pixel[0] - (chosen?.[0] ?? 0), pixel[1] - (chosen?.[1] ?? 0));
  const index = chosen ? all.reduce((best, { pixel }, i) => (off(pixel) < off(all[best].pixel) ? i : best), 0) : -1;
  at.view.choosePoint(index);
  $("point").max = String(all.length);
  $("point").value = index < 0 ? "" : String(index + 1);
  ["x", "y"].forEach((axis, i) => {
    $(`point-${axis}`).disabled = index < 0;
    $(`point-${axis}`).value = index < 0 ? "" : String(Math.round(all[index].pixel[i]));
  });
}

// After any change of the drawing or the step.
export function showDrawing() {
  const picture = at.character?.picture;
  document.body.classList.toggle("drawn", Boolean(picture));
  if (!picture) chosen = null;
  if (!picture || at.step !== "mesh") return at.view.setDrawing(null, picture ? [0, 0.05, 1] : undefined);
  const { mesh, pictureWishes: wishes, document: { files } } = at.character.source;
  at.player.pause();
  outline = draggable(picture.outline, Math.min($("stage").clientWidth, $("stage").clientHeight) < leastRoom ? 2 : 1, chosen);
  at.view.setDrawing({ outline, lies: picture.place, width: picture.width, height: picture.height, file: files.get(mesh) });
  showPoint();
  $("flat").checked = picture.flat;
  $("cut").checked = picture.cut;
  $("outline-found").disabled = !wishes?.outline?.length && !wishes?.mask;
  $("figure-field").hidden = picture.figures < 2;
  $("figure").replaceChildren(...Array.from({ length: picture.figures }, (_, i) => new Option(String(i + 1), String(i + 1))));
  $("figure").value = String(picture.figure);
}
