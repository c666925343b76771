// SPDX-License-Identifier: MIT
// A drawing's figure in the step Mesh: its outline with points to drag, which figure, a mask, flat or round, cut along lines or not. What was asked for is the character's
// source.pictureWishes, as web_picture() has them; mesh, joints and weights are made anew from it.
import { act } from "./acting.js";
import { bind } from "./binding.js";
import { restore } from "./commands.js";
import { giveFiles } from "./documents.js";
import { choosePoint, pointOfNumber, shownOutline } from "./drawn.js";
import { predict } from "./editing.js";
import { isPicture, pictureFiles } from "./files.js";
import { clearError, run } from "./jobs.js";
import { loadDrawn } from "./opened.js";
import { dragged } from "./outline.js";
import { historyOf } from "./recording.js";
import { $, at } from "./state.js";

const bodyWords = ["", "biped", "quadruped", "bird", "fish", "snake", "many-legged"]; // by the number of a kind, see #kind

// The same drawing with other wishes; the motion of its class goes on as the one of the class that it has then.
/** @param {string} name @param {import("./types.js").PictureWishes} change */
function changeDrawing(name, change) {
  if (!at.character?.picture) return undefined;
  return act(name, async () => {
    const { source } = at.character;
    const clipOf = () => at.character.picture?.clip ?? "";
    const before = clipOf();
    const { now } = historyOf(source);
    try {
      await loadDrawn({ ...source.pictureWishes, ...change });
      Object.assign(source, { markers: [], answers: [], recipe: { wishes: null, edits: [] } });
      const isOfClass = source.motion?.files.length === 1 && source.motion.files[0] === before;
      if (isOfClass) source.motion = null;
      await predict();
      await bind();
      if (isOfClass && clipOf()) await at.motions.open([clipOf()]);
    } catch (error) {
      await restore(now, { ...now, pictureWishes: null }); // anew, whatever of it was done
      throw error;
    }
  });
}

export const changeKind = () => changeDrawing("kind", { class: bodyWords[Number($("kind").value)] ?? "other" });

/** @param {{ of: number, point: number }} handle @param {number[]} pixel @param {boolean} ended */
function dragOutline({ of, point }, pixel, ended) {
  const now = shownOutline().map((one, i) => (i === of ? { ...one, line: dragged(one, point, pixel) } : one));
  at.view.setOutline(now);
  if (ended) choosePoint(pixel);
  if (ended) changeDrawing("outline", { outline: now.map(({ line }) => line), figure: 0, mask: "" });
}

// A picture that is bright where the figure is.
/** @param {File} file */
async function useMask(file) {
  clearError();
  if (!isPicture(file.name)) throw new Error(`${file.name}: expected a PNG or JPEG that is bright where the figure is, found another kind of file`);
  const { mesh, document } = at.character.source;
  const mask = new File([file], `mask ${document.files.size} of ${mesh}.${file.name}`);
  await giveFiles([mask], document);
  changeDrawing("mask", { mask: mask.name, outline: [], figure: 0 });
}

function typePoint() {
  const pixel = ["x", "y"].map((axis) => $(`point-${axis}`).valueAsNumber);
  if (pixel.every(Number.isFinite)) dragOutline(pointOfNumber(), pixel, true);
}

export function listenForDrawings() {
  at.view.onDragOutline = dragOutline;
  $("point").oninput = () => Number.isFinite($("point").valueAsNumber) && choosePoint(pointOfNumber().pixel);
  $("point-x").onchange = $("point-y").onchange = typePoint;
  $("flat").onchange = () => changeDrawing($("flat").checked ? "flat" : "round", { flat: $("flat").checked });
  $("cut").onchange = () => changeDrawing($("cut").checked ? "cut along inner lines" : "no cut", { cut: $("cut").checked, outline: [] });
  $("figure").onchange = async () => {
    await changeDrawing(`figure ${$("figure").value}`, { figure: Number($("figure").value), outline: [], mask: "" });
    at.view.frame(); // it stands elsewhere
  };
  $("outline-found").onclick = () => changeDrawing("reset outline", { outline: [], mask: "", figure: 0 });
  $("mask-file").accept = pictureFiles;
  $("open-mask").onclick = () => $("mask-file").click();
  $("mask-file").onchange = () => {
    const [file] = $("mask-file").files;
    $("mask-file").value = "";
    if (file && at.character?.picture) run(() => useMask(file));
  };
}
