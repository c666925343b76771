// SPDX-License-Identifier: MIT
// What the mesh's colours show, and the legend.
import { lookText } from "./asked.js";
import { glbOf } from "./look_file.js";
import { fillClipPictures } from "./clip_pictures.js";
import { run } from "./jobs.js";
import { doubtsOf } from "./rail.js";
import { sureColour } from "./skeleton.js";
import { $, all, at, engine, modes } from "./state.js";

const asked = [240, 120, 20]; // sRGB of the part that a question is about, as in the command's pictures
const dimmed = [52, 58, 67]; // and what the rest fades to

export async function colour() {
  if ((at.mode === modes.field || at.mode === modes.artistField) && at.view.selected < 0) at.mode = modes.joints;
  const isArtists = at.mode === modes.artist || at.mode === modes.artistField;
  if ((isArtists || at.mode === modes.difference) && !at.character?.hasReference) at.mode = modes.joints;
  const shows = isArtists ? modes.artist : at.mode === modes.field ? modes.joints : at.mode;
  for (const input of all("#mode input, #artist input")) {
    input.checked = Number(input.value) === shows;
    input.disabled = !at.character?.result;
  }
  showLegend();
  showSure();
  if (!at.character?.result) return;
  await showLookOfFile();
  fillClipPictures();
  const shown = at.mode === modes.material ? modes.joints : at.mode;
  const { mean, buffers } = await engine.call("colour", { mode: shown, joint: Math.max(0, at.view.selected) });
  at.shownMean = mean;
  showLegend();
  at.view.setColours(emphasised(buffers.colours));
}

// The mesh in its stead is where it was last posed.
function hideLook() {
  if (!at.view.look) return;
  at.view.setLook(null);
  at.player.onFrame();
}

// The GLB that would be saved now, with its materials, instead of the colours; read anew after each bind.
async function showLookOfFile() {
  if (at.mode !== modes.material || at.shownLook) return hideLook(); // a part that is asked about is shown by colours
  const { result, joints } = at.character;
  if (at.view.look?.result === result) return;
  const { Look } = await import("./look.js");
  const look = await Look.of(await glbOf(at.character.name), joints);
  look.result = result;
  at.view.setLook(look);
}

// The part that is looked at, orange where it is only asked about, and the rest dimmed.
/** @param {Uint8Array} colours */
function emphasised(colours) {
  const members = at.shownLook?.question.members; // answers of a project have none
  if (!members) return colours;
  const { of, number: wanted } = members;
  const { vertexOf } = at.character.buffers;
  const isAsked = at.shownLook.answer === undefined;
  return colours.map((c, i) => {
    const axis = i % 3;
    if (of[vertexOf[(i - axis) / 3]] !== wanted) return 0.15 * c + 0.85 * dimmed[axis];
    return isAsked ? asked[axis] : c;
  });
}

export function showLegend() {
  const name = at.character?.joints[at.view.selected]?.name ?? "";
  const [caption, low, high] = {
    [modes.joints]: ["Each bone has a color; shared vertices blend them.", "", ""],
    [modes.field]: [`Weight of ${name}`, "0", "1"],
    [modes.doubt]: ["Where weights are uncertain", "sure", "check"],
    [modes.artist]: ["The weights in the file", "", ""],
    [modes.artistField]: [`Weight of ${name} in the file`, "0", "1"],
    [modes.difference]: [`Difference from the weights in the file: ${(100 * at.shownMean).toFixed(1)} % on average`, "same", "different"],
    [modes.material]: [`As other programs show it${at.bends.skinning > 0 ? ", with linear skinning" : ""}`, "", ""],
  }[at.mode];
  $("legend").classList.toggle("plain", [modes.joints, modes.artist].includes(at.mode) && !lookText());
  $("legend").classList.toggle("of-joint", at.mode === modes.field || at.mode === modes.artistField);
  $("legend").hidden = !at.character || (at.mode === modes.material && !lookText() && !showsSureness());
  $("legend").querySelector("figcaption").textContent = lookText() ?? caption;
  $("legend").querySelector(".scale").hidden = [modes.joints, modes.artist, modes.material].includes(at.mode) || Boolean(at.shownLook && at.shownLook.answer === undefined);
  $("legend").querySelector(".low").textContent = low;
  $("legend").querySelector(".high").textContent = high;
}

const showsSureness = () => Boolean(at.character?.predicted) && at.view.editing;

// How sure a predicted skeleton is, as the colour of its joints, and what is to be said about the whole.
export function showSure() {
  const shown = showsSureness();
  $("sure").hidden = !shown;
  at.view.setJointColours(shown ? at.character.joints.map(({ confidence }) => sureColour(confidence)) : null);
  at.view.setDoubts(doubtsOf().flatMap(({ joints }) => joints));
  $("notice").hidden = !at.character?.doubtful;
}

// As the user chooses it; it stays for the step.
/** @param {number} wanted */
export function setMode(wanted) {
  if (!at.character?.result || (wanted === modes.field && at.view.selected < 0)) return;
  if ((wanted === modes.artist || wanted === modes.difference) && !at.character.hasReference) return;
  const chosen = at.view.selected >= 0;
  at.modeChosen = true;
  at.mode = wanted === modes.artist && chosen ? modes.artistField : wanted === modes.joints && chosen ? modes.field : wanted;
  run(colour);
}
