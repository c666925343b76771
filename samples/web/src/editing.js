// SPDX-License-Identifier: MIT
// The skeleton: predicted, edited, dragged.
import { lookNowhere } from "./asked.js";
import { bind } from "./binding.js";
import { hasLegs } from "./builtin_clips.js";
import { facingOf } from "./dial.js";
import { showLegend, showSure } from "./colours.js";
import { run, showError, whileBusy } from "./jobs.js";
import { Latest } from "./latest.js";
import { showMarkers } from "./markers.js";
import { fetchModel } from "./models.js";
import { closeOffer, offer } from "./offer.js";
import { sidesOf } from "./sides.js";
import { jointsOutside, missingTail } from "./suspects.js";
import { Pose } from "./pose.js";
import { kinds } from "./questions.js";
import { record, rigChanged } from "./recording.js";
import { choose, listJoints, showFacts, showPose } from "./showing.js";
import { answersFor, editKinds, movedJoints } from "./skeleton.js";
import { $, at, engine, models } from "./state.js";
import { asNumbers, how, pending } from "./wishes.js";

// Joints, their list and the panels, after any change of them.
export function showSkeleton() {
  at.view.draggable = Boolean(at.character.editable) && !at.character.posed;
  listJoints();
  showPose();
  at.editor.show(at.character, at.view.selected);
  showMarkers();
  showLegend();
  showSure();
}

// Joints are edited where the step is the skeleton's; the pose is at rest then.
export function setEditing(editing) {
  at.view.editing = editing;
  if (editing) at.player.pause();
  else at.markers.setPlacing(false);
  showPose();
}

// What a bind takes for up, 0 = Y, 1 = Z. That of a predicted skeleton was found or told with it; others are told, and stand on Y unless they are,
// as the command has them. told: 0, 1, or 2 where nobody said.
/** @type {(rig: { upAxis?: number }, told: number) => number} */
export const upOf = ({ upAxis }, told) => upAxis ?? (told === 1 ? 1 : 0);

// rig: as the module describes it. chosen: the name of the joint that is chosen then.
function useRig({ joints, picture, ...rig }, chosen) {
  const { source } = at.character;
  if (picture) at.character.picture = { ...at.character.picture, ...picture }; // its class and clip are known now
  const isSame = joints.length === at.character.joints.length && joints.every(({ parent }, j) => parent === at.character.joints[j].parent);
  source.answers = answersFor(source.answers, at.character.joints, joints, kinds.rigid);
  Object.assign(at.character, { mirrored: false, doubtful: false, front: null, frontSure: 1, upSure: 1, upAxis: upOf(rig, at.character.up) }, rig, { joints });
  at.view.setUp(at.character.upAxis);
  at.view.face(facingOf(at.character));
  lookNowhere();
  at.character.suspects = at.character.predicted ? [...jointsOutside(joints, at.character.buffers, at.character.size), ...missingTail(joints, at.character.upAxis === 1 ? 2 : 1)] : [];
  if (isSame) {
    at.view.moveSkeleton(joints); // and renamed
  } else {
    at.pose = new Pose(joints.length);
    at.character.result = null;
    at.view.setSkeleton(joints);
    at.view.select(joints.findIndex(({ name }) => name === chosen));
  }
  showSkeleton();
}

const chosenName = () => at.character.joints[at.view.selected]?.name;

async function fetchModelsFor({ detail }) {
  await Promise.all([models.skeletons || fetchModel("sinew_rig.sinew"), models.fronts || fetchModel("sinew_front.sinew")]);
  if (detail > 0 && !models.hands) await fetchModel("sinew_hands.sinew");
}

// A mesh that may be a hand without a body is asked about once more, with the model that knows hands.
async function askForRig(wishes) {
  await fetchModelsFor(wishes);
  const rig = await engine.call("rig", { wishes });
  if (!rig.wantsHands || models.hands) return rig;
  await fetchModel("sinew_hands.sinew");
  return engine.call("rig", { wishes });
}

// What markers are for the module.
const marked = (markers) => ({ at: markers.map(({ joint, place }) => ({ kind: editKinds.at, joint, place })), alike: at.editor.alike });

const kindsAsked = { Person: "1", "Four legs": "2", Bird: "3", Fish: "4" }; // of #kind
const longAsSnakes = 4; // times as long as wide and high

// Whether the user is asked what the body is: no legs were found in it, or it is like nothing known.
function asksKind() {
  const { joints, doubtful, picture, buffers } = at.character;
  const [longest, next] = sidesOf(buffers.positions);
  return !picture && (doubtful || (!hasLegs(joints) && longest <= longAsSnakes * next));
}

/** @param {string} why */
export function askKind(why) {
  const rigAs = (/** @type {string} */ kind) => () => {
    $("kind").value = kind;
    $("kind").dispatchEvent(new Event("change"));
    at.onKind();
  };
  offer(`${why}What is it?`, {
    ...Object.fromEntries(Object.entries(kindsAsked).map(([word, kind]) => [word, rigAs(kind)])), Other: () => {},
  });
}

export async function predict(wishes = at.editor.wishes) {
  const chosen = chosenName();
  const told = { ...wishes, up: at.character.up, ...marked(at.character.source.markers) };
  const rig = await whileBusy("Finding the bones", () => askForRig(told));
  at.character.source.recipe = { wishes: told, edits: [] };
  rigChanged();
  useRig(rig, chosen);
  closeOffer();
  if (!told.category && asksKind()) askKind(hasLegs(at.character.joints) ? "This mesh is hard to recognize. " : "No legs were found. ");
}

const withEdits = ({ wishes, edits }, more, mirror) => ({ wishes, edits: [...edits, { edits: more, mirror }] });

export async function editSkeleton(edits, chosen) {
  const { source } = at.character;
  const mirror = at.editor.alike;
  try {
    useRig(await engine.call("edit", { edits, mirror, continues: false }), chosen);
  } catch (error) {
    at.editor.show(at.character, at.view.selected); // what was typed is not so
    throw error;
  }
  source.recipe = withEdits(source.recipe, edits, mirror);
  rigChanged();
  await bind();
  if (edits[0].kind === editKinds.add) {
    $("rename").closest("details").open = true;
    $("rename").focus();
    $("rename").select();
  }
}

// What edits are called in the history.
/** @type {(edits: import("./types.js").Edit[]) => string} */
export const editName = ([{ kind, joint, other }]) => [`move ${joint}`, `add ${joint}`, `remove ${joint}`, `change parent of ${joint}`, `rename ${joint} to ${other}`][kind];

// The skeleton of a state of the history: the module kept it, or its recipe makes it anew from the file.
export async function restoreRig({ kept, epoch, recipe, up }) {
  const { source } = at.character;
  at.character.up = up;
  at.editor.showWishes(recipe.wishes);
  let rig = null;
  if (epoch === engine.epoch) {
    rig = await engine.call("restore", { number: kept });
  } else {
    if (recipe.wishes) rig = await whileBusy("Finding the bones", () => askForRig(recipe.wishes));
    for (const { edits, mirror } of recipe.edits) rig = await engine.call("edit", { edits, mirror, continues: false });
  }
  source.recipe = recipe;
  rigChanged();
  if (rig) useRig(rig, chosenName());
}

// Weights follow a dragged joint as fast as the worker binds.
export const moves = new Latest(async ({ of, place, step }) => {
  if (of !== at.character) return;
  const edits = [{ kind: editKinds.move, joint: step.joint, place }];
  const shown = { mode: at.mode, joint: Math.max(0, at.view.selected) };
  const { rig, seconds, buffers } = await engine.call("move", {
    edits, mirror: at.editor.alike, continues: step.moved, ...how(), answers: asNumbers(at.character.source.answers), ...shown,
  });
  if (of !== at.character) return;
  step.moved = true;
  step.done = edits;
  if (!moves.pending) {
    Object.assign(at.character, rig);
    at.view.moveSkeleton(rig.joints);
    at.editor.showPlace();
  }
  at.view.setColours(buffers.colours);
  if (at.character.result) {
    at.character.result = at.character.shown = { ...at.character.result, seconds, hash: pending };
    showFacts();
  }
});

export function dragJoint(joint, place) {
  if (at.view.selected !== joint) choose(joint);
  at.dragged ??= { joint: at.character.joints[joint].name, moved: false, done: null };
  at.character.joints = movedJoints(at.character.joints, joint, place, at.character, at.editor.alike);
  at.view.moveSkeleton(at.character.joints);
  at.editor.showPlace();
  moves.want({ of: at.character, place, step: at.dragged }).catch((error) => showError(error.message));
}

export function endDrag() {
  const ended = at.dragged;
  at.dragged = null;
  if (!ended) return;
  run(async () => {
    while (moves.busy) await moves.idle().catch(() => {}); // said already
    showSkeleton();
    if (!ended.moved) return;
    const { source } = at.character;
    if (!ended.done) return;
    source.recipe = withEdits(source.recipe, ended.done, at.editor.alike);
    rigChanged();
    await bind();
    record(editName(ended.done));
  });
}

export function toMiddle() {
  if (!at.editor.canEdit || at.view.dragging) return;
  at.editor.move(at.view.middleOf(at.view.selected));
}
