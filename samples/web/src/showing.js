// SPDX-License-Identifier: MIT
// The pose, the chosen joint and the line of facts.
import { showBrush } from "./brush.js";
import { colour } from "./colours.js";
import { factsOf } from "./facts.js";
import { run, showError } from "./jobs.js";
import { Latest } from "./latest.js";
import { doubtsOf, showSteps } from "./rail.js";
import { $, all, at, engine, models, modes } from "./state.js";
import { isOff } from "./wishes.js";

export const poses = new Latest(async () => {
  const of = at.character?.result;
  if (!of) return;
  const [posed, { motion }, { skinning }] = [at.pose, at.player, at.bends];
  const plays = Boolean(motion) && !at.view.editing;
  const drag = at.view.editing ? null : at.drag.next();
  const swings = at.springs.on;
  const turns = at.view.editing ? new Float32Array(at.pose.turns.length) : at.pose.turns; // a skeleton is edited at rest
  const isPast = () => of !== at.character?.result || posed !== at.pose || motion !== at.player.motion; // another character, bind or motion by now
  let reply;
  try {
    if (drag) reply = await engine.call("dragged", { ...(plays && { clip: at.player.clip }), seconds: plays ? at.player.seconds : 0, turns, skinning, drag });
    // While a motion plays, the graphics card skins what is linear; the mesh itself follows when it stops.
    else reply = plays && at.player.playing && at.view.look && skinning === 0 ? await engine.call("frameJoints", { clip: at.player.clip, seconds: at.player.seconds, swings }) : plays ? await engine.call("frame", { clip: at.player.clip, seconds: at.player.seconds, skinning, swings }) : await engine.call("pose", { turns, skinning });
  } catch (error) {
    if (isPast()) return;
    throw error;
  }
  if (isPast()) return;
  const { positions, normals, jointPositions, palette } = reply.buffers;
  at.view.setPose(positions, normals, jointPositions, turns, palette, plays, drag?.move);
  at.view.setSpots(plays && !drag && at.motions.methods.spotsShown ? reply.spots : []);
  if (reply.bends) at.bends.show(reply.bends, at.character.joints, at.player.playing);
});
export const sendPose = () => poses.want();

// All of the clip that plays comes into view.
export const frameClip = () => at.view.frameClip(at.player.motion.clips[at.player.clip].room, at.character.upAxis);

export function poseChanged() {
  showPose();
  sendPose().catch((/** @type {Error} */ error) => showError(error.message));
}

// more: beside the chosen joint, to turn with it.
/** @param {number} joint @param {boolean} more */
export function choose(joint, more = false) {
  if (!at.character || joint >= at.character.joints.length) return;
  if (more && joint >= 0 && at.view.selected >= 0 && joint !== at.view.selected) {
    const also = new Set(at.view.also);
    if (!also.delete(joint)) also.add(joint);
    at.view.also = also;
    showPose();
    return markJoint();
  }
  at.view.select(joint);
  if (at.mode === modes.artist || at.mode === modes.artistField) at.mode = joint >= 0 ? modes.artistField : modes.artist;
  else if (at.mode === modes.material) at.mode = joint >= 0 && !at.modeChosen && at.step !== "motion" ? modes.field : at.mode;
  else if (at.mode !== modes.difference) at.mode = joint >= 0 ? modes.field : modes.joints;
  showPose();
  at.editor.show(at.character, joint);
  markJoint(); // into view: the panels may have taken room from the list
  run(colour);
}

// The next limb that may be wrong, in the middle of the picture.
export function nextDoubt() {
  const doubts = doubtsOf();
  if (doubts.length === 0) return;
  const next = (doubts.findIndex(({ joints }) => joints.includes(at.view.selected)) + 1) % doubts.length;
  choose(doubts[next].joint);
  at.view.lookAtJoints(doubts[next].joints);
}

export function showPose() {
  const joint = at.view.selected;
  showBrush();
  $("switch").disabled = $("lock").disabled = joint < 0 || !at.character?.result;
  $("switch").textContent = isOff(joint) ? "Switch on" : "Switch off";
  $("lock").ariaPressed = String(joint >= 0 && Boolean(at.character?.source.locked?.has(at.character.joints[joint].name)));
  $("pose-none").hidden = !at.player.motion;
  $("pose-turns").hidden = Boolean(at.player.motion);
  at.view.turnable = !at.player.motion;
  at.posePanel.show(at.character, at.pose, joint, at.view.also);
}

// result: what the line says of the bind, null while there is none.
export function showFacts(result = at.character?.result) {
  $("facts").replaceChildren(...factsOf({ character: at.character, result, engine: at.engineFacts, models }));
  for (const button of all("[data-needs=bound]")) button.disabled = !at.character?.result;
  showStatus();
  showPlacement();
}

// The line below the picture; the rest is behind its i.
function showStatus() {
  const { character } = at;
  const count = (/** @type {number} */ n) => n.toLocaleString("en");
  const parts = character ? [`${count(character.vertices)} vertices`, `${character.joints.length} bones`, character.result ? "weights ready" : "computing weights…"] : [];
  $("status-said").textContent = parts.join(" · ");
  showSteps();
}

export const showPlacement = () => at.dial.show(at.character);

export const listJoints = () => at.jointList.show(at.character, at.view.selected, at.view.also);
const markJoint = () => at.jointList.mark(at.view.selected, at.view.also);
