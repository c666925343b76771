// SPDX-License-Identifier: MIT
// What the module has just opened, as the page shows it.
import { listQuestions, lookNowhere } from "./asked.js";
import { showSkeleton, upOf } from "./editing.js";
import { whileBusy } from "./jobs.js";
import { Pose } from "./pose.js";
import { showFacts } from "./showing.js";
import { $, at, engine, modes } from "./state.js";
import { firstStep, setStep } from "./steps.js";

export const unplaced = { turns: [], height: 0, floor: false };
/** @type {(source: import("./types.js").Source) => object} */
export const asLoaded = ({ mesh, skeleton, number, placement }) => ({ mesh, skeleton, number, place: { ...placement, up: Number($("up").value) === 1 ? 1 : 0 } });

// The open character turned or scaled as a whole: with the joints of its file, without weights.
/** @param {import("./types.js").Placement} placement */
export async function loadPlaced(placement) {
  const { source, name, up } = at.character;
  const loaded = await whileBusy(`Turning ${name}`, () => engine.call("load", asLoaded({ ...source, placement })));
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
  const { mesh, number } = source;
  const loaded = await whileBusy(`Opening ${name}`, () => engine.call("picture", { mesh, wishes: wishes ?? { class: "" }, number })); // without any it would be the one that is open
  source.pictureWishes = wishes;
  at.character = { ...loaded, name, up, upAxis: upOf(loaded, up), source, result: null, size: longestSide(loaded.buffers.positions), placeable: false };
  source.locked = new Set(); // with the rows that were locked
  source.kept = 0;
  showOpened(loaded);
}

/** @param {string} line */
export function remark(line) {
  $("remarks").textContent += `${$("remarks").textContent && "\n"}${line}`;
  $("remarks").hidden = false;
}

/** @param {any} loaded as the module tells it */
export function showOpened(loaded) {
  document.body.classList.remove("start");
  $("artist").hidden = !loaded.hasReference;
  $("remarks").textContent = "";
  $("remarks").hidden = true;
  for (const note of loaded.notes) remark(note);
  at.pose = new Pose(loaded.joints.length);
  at.dragged = null;
  lookNowhere();
  at.view.setCharacter({ ...loaded.buffers, joints: loaded.joints, upAxis: at.character.upAxis });
  at.mode = modes.material;
  at.modeChosen = false;
  $("search").value = "";
  setStep(at.character.source.step ?? firstStep(at.character, false), { view: false });
  showSkeleton();
  listQuestions();
  showFacts();
}

/** @param {Float32Array} positions [V x 3] */
export function longestSide(positions) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    least[i % 3] = Math.min(least[i % 3], x);
    most[i % 3] = Math.max(most[i % 3], x);
  });
  return Math.max(...most.map((x, axis) => x - least[axis]));
}
