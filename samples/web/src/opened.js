// SPDX-License-Identifier: MIT
// What the module has just opened, as the page shows it.
import { listQuestions, lookNowhere } from "./asked.js";
import { facingOf } from "./dial.js";
import { showSkeleton, upOf } from "./editing.js";
import { whileBusy } from "./jobs.js";
import { closeOffer } from "./offer.js";
import { Pose } from "./pose.js";
import { beginReport, report } from "./report.js";
import { sentenceOf } from "./sentences.js";
import { showFacts } from "./showing.js";
import { longestSide } from "./sides.js";
import { $, at, engine, modes } from "./state.js";
import { firstStep, setStep } from "./steps.js";

export const unplaced = { turns: [], height: 0, floor: false };
/** @type {(source: import("./types.js").Source, anew?: boolean) => object} */
export const asLoaded = ({ document: { folder }, mesh, skeleton, number, placement }, anew = false) => ({ folder, mesh, skeleton, number, place: { ...placement, anew, up: Number($("up").value) === 1 ? 1 : 0 } });

// The open character turned or scaled as a whole: with the joints of its file, without weights.
// anew: with the joints of its file also where others stood in the same placement.
/** @param {import("./types.js").Placement} placement */
export async function loadPlaced(placement, anew = false) {
  const { source, name, up } = at.character;
  const loaded = await whileBusy(`Moving ${name}`, () => engine.call("load", asLoaded({ ...source, placement }, anew)));
  source.placement = placement;
  at.character = { ...loaded, name, up, upAxis: upOf(loaded, up), source, result: null, size: longestSide(loaded.buffers.positions), placeable: true };
  source.locked = new Set(); // with the rows that were locked
  source.kept = 0;
  showOpened(loaded);
}

// The open drawing by other wishes: without joints and weights.
/** @param {import("./types.js").PictureWishes | undefined} wishes */
export async function loadDrawn(wishes) {
  const { source, name, up } = at.character;
  const { mesh, number, document: { folder } } = source;
  const loaded = await whileBusy(`Opening ${name}`, () => engine.call("picture", { folder, mesh, wishes: wishes ?? { class: "" }, number })); // without any it would be the one that is open
  source.pictureWishes = wishes;
  at.character = { ...loaded, name, up, upAxis: upOf(loaded, up), source, result: null, size: longestSide(loaded.buffers.positions), placeable: false };
  source.locked = new Set(); // with the rows that were locked
  source.kept = 0;
  showOpened(loaded);
}

/** @param {string} line */
export function remark(line) {
  $("remarks").textContent += `${$("remarks").textContent && "\n"}${sentenceOf(line)}`;
  $("remarks").hidden = false;
  report(line);
}

/** @param {any} loaded as the module tells it */
export function showOpened(loaded) {
  document.body.classList.remove("start");
  $("artist").hidden = !loaded.hasReference;
  closeOffer();
  $("remarks").textContent = "";
  $("remarks").hidden = true;
  beginReport(loaded);
  showOrigin(loaded);
  for (const note of loaded.notes) remark(note);
  at.pose = new Pose(loaded.joints.length);
  at.dragged = null;
  lookNowhere();
  at.view.setCharacter({ ...loaded.buffers, joints: loaded.joints, upAxis: at.character.upAxis });
  at.view.face(facingOf(at.character));
  at.mode = modes.material;
  at.modeChosen = false;
  $("search").value = "";
  setStep(at.character.source.step ?? firstStep(at.character, false), { view: false });
  showSkeleton();
  listQuestions();
  showFacts();
}

// What its file says of itself, in the step Export: who made it and what is not allowed, and parts that are not where its own skin puts them.
/** @param {{ misplaced?: string[], license?: { authors: string[], forbidsChanges: boolean } | null }} loaded */
function showOrigin({ misplaced = [], license = null }) {
  $("misplaced").hidden = misplaced.length === 0;
  const names = misplaced.slice(0, 4).join(", ") + (misplaced.length > 4 ? ` and ${misplaced.length - 4} more` : "");
  $("misplaced").textContent = `Look at it before you export it: ${names} ${misplaced.length === 1 ? "lies" : "lie"} far from the joints that this file's own skin gives ${misplaced.length === 1 ? "it" : "them"} to.`;
  if (misplaced.length > 0) remark($("misplaced").textContent);
  const authors = license?.authors.join(", ") ?? "";
  $("license-said").hidden = !license;
  $("license-said").textContent = `${authors ? `By ${authors}; that stays in the file.` : "Its file names no author."}${license?.forbidsChanges ? " Its license forbids changing it." : " Its license stays as it is."}`;
  $("author").placeholder = authors;
  $("license-mine-field").hidden = !license?.forbidsChanges;
  $("license-mine").checked = false;
}
