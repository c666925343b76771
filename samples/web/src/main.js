// SPDX-License-Identifier: MIT
// The page: what is open, what is chosen, and what follows when that changes.
import { BendPanel } from "./bends.js";
import { Engine } from "./engine.js";
import { factsOf, number } from "./facts.js";
import { pairFiles } from "./files.js";
import { JointList } from "./joint_list.js";
import { listenForKeys } from "./keys.js";
import { Latest } from "./latest.js";
import { Motions } from "./motions.js";
import { BindOptions, switched } from "./options.js";
import { Pose } from "./pose.js";
import { PosePanel } from "./pose_panel.js";
import { kinds, partName, Questions } from "./questions.js";
import { sampleFiles, samples } from "./samples.js";
import { answersFor, editKinds, movedJoints, SkeletonEditor, sureColour } from "./skeleton.js";
import { testClip, testClips } from "./test_clips.js";
import { View } from "./view.js";

const $ = (id) => document.getElementById(id);
const modes = { joints: 0, field: 1, doubt: 2, artist: 3, artistField: 4, difference: 5, material: -1 }; // ColourMode of web.cpp, and the file's own look
const views = { "view-front": [0, 0, 1], "view-side": [1, 0, 0], "view-top": [0, 1, 0.001] };
const asked = [240, 120, 20]; // sRGB of the part that a question is about, as in the command's pictures
const dimmed = [52, 58, 67]; // and what the rest fades to
const pending = "·".repeat(16); // a hash that is not known yet
const lookMilliseconds = 90; // the pointer stays that long on what is shown

const engine = new Engine();
let view;
let engineFacts = {}; // {kernel, version, moduleBytes}
const models = {}; // by their task: {name, bytes, parameters, layers}
let open = []; // characters that were dropped together: {name, mesh, skeleton, number, answers, style}
let waiting = {}; // a mesh or a rig that its other half may still follow
let character = null; // what the module has loaded, with its bind result
let lastNumber = 0; // of the characters that were opened
let pose = null;
let posePanel;
let mode = modes.joints;
let questions;
let editor;
let player;
let motions; // the player among them
let bends;
let jointList;
let options;
let shownMean = 0; // of what the colours show, see web.cpp
let style = null; // {name}: answers for the characters from now on

// ---- one thing after another

let queue = Promise.resolve();
// Runs a job after those before it. What it throws is shown, and the page goes on.
function run(job) {
  const done = queue.then(job);
  queue = done.catch((error) => showError(error.message));
  return queue;
}

function showError(line) {
  $("error").firstElementChild.textContent = line;
  $("error").hidden = false;
}

function clearError() {
  $("error").hidden = true;
}

engine.onProgress = (share) => {
  $("progress").firstElementChild.style.width = `${share * 100}%`;
  $("progress").setAttribute("aria-valuenow", String(Math.round(share * 100)));
};

async function whileBinding(job) {
  engine.onProgress(0);
  $("progress").hidden = false;
  try {
    return await job();
  } finally {
    $("progress").hidden = true;
  }
}

// ---- files in

async function openFiles(list) {
  clearError();
  if (list.length === 0) return;
  const files = await Promise.all(list.map(withBytes));
  const names = files.map((file) => file.name);
  await engine.call("write", { files }, files.map((file) => file.bytes));
  const found = pairFiles(names, waiting);
  waiting = found.waiting;
  if (found.model !== "") await useModel(found.model);
  if (found.style !== "") await useStyle(found.style);
  if (found.characters.length > 0) {
    const before = open;
    open = found.characters;
    try {
      await load(open[0]);
    } catch (error) {
      open = before;
      showCharacters();
      throw error;
    }
    $("sample").value = "";
    const kept = new Set([...names, ...open.flatMap((c) => [c.mesh, c.skeleton])]);
    const isOld = (n) => n && !kept.has(n);
    await engine.call("remove", { names: before.flatMap((c) => [c.mesh, c.skeleton]).filter(isOld), numbers: before.map((c) => c.number ?? 0) });
  } else if ((found.model !== "" || found.style !== "") && character) {
    await useStyleAnswers();
    await bind();
  }
  if (found.motion !== "") await playMotion(found.motion);
  if (found.problems.length > 0) throw new Error(found.problems.join("; "));
}

const withBytes = async (file) => ({ name: file.name, bytes: await file.arrayBuffer() });

async function openSample(sample) {
  const files = await sampleFiles(sample);
  waiting = {};
  await openFiles(files);
  $("sample").value = sample.name;
}

// A model of weights, of skeletons or of hands.
async function useModel(name) {
  const { task, ...model } = await engine.call("model", { name });
  models[task] = { name, ...model };
}

async function fetchModel(name) {
  const response = await fetch(name);
  if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}; build the page with samples/web/build.sh`);
  const model = await response.arrayBuffer();
  await engine.call("write", { files: [{ name, bytes: model }] }, [model]);
  await useModel(name);
}

// anew: a predicted skeleton is predicted again, as for another up axis.
async function load(source, anew = false) {
  const { name, mesh, skeleton } = source;
  const upAxis = Number($("up").value);
  source.number ??= ++lastNumber;
  const loaded = await engine.call("load", { mesh, skeleton, number: source.number });
  // From here on the module has the new character, whether it can be bound or not.
  character = { ...loaded, name, upAxis, source, result: null, size: longestSide(loaded.buffers.positions) };
  source.answers ??= [];
  source.locked = new Set(); // with the rows that were locked
  $("artist").hidden = !loaded.hasReference;
  $("remarks").textContent = loaded.notes.join("\n");
  $("remarks").hidden = loaded.notes.length === 0;
  pose = new Pose(loaded.joints.length);
  dragged = null;
  lookNowhere();
  view.setCharacter({ ...loaded.buffers, joints: loaded.joints, upAxis });
  mode = modes.joints;
  $("search").value = "";
  showCharacters();
  setEditing(loaded.predicted || loaded.joints.length === 0);
  showSkeleton();
  listQuestions();
  showFacts();
  if (loaded.joints.length === 0 || (anew && loaded.predicted)) await predict();
  await useStyleAnswers();
  await bind();
  const isScene = /\.(glb|gltf|vrm|fbx|dae)$/i.test(mesh);
  if (isScene && source.motion === undefined && !character.predicted) await motions.open(mesh).catch(() => {}); // most files have no animations
}

function longestSide(positions) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    least[i % 3] = Math.min(least[i % 3], x);
    most[i % 3] = Math.max(most[i % 3], x);
  });
  return Math.max(...most.map((x, axis) => x - least[axis]));
}

const how = () => ({ wish: options.wish(character) });
const asNumbers = (answers) => answers.map(({ question, kind, joint }) => [question.part, kind, joint]);

// answers: those of the character from now on, if they can be had. focus: see Questions.show().
async function bind(answers = character.source.answers, focus) {
  if (character.joints.length === 0) return;
  const before = answers === character.source.answers ? null : character.result;
  lookNowhere();
  character.result = null;
  showFacts(character.shown && { ...character.shown, hash: pending }); // a line of the same length: the picture keeps its size
  const started = performance.now();
  try {
    const result = await whileBinding(() => engine.call("bind", { ...how(), answers: asNumbers(answers) }));
    character.result = { ...result, wallSeconds: (performance.now() - started) / 1e3, strongest: result.buffers.strongest };
    character.shown = character.result;
    result.questions.forEach((question, number) => (question.members = { of: result.buffers.vertexQuestions, number }));
    character.source.answers = answers;
  } catch (error) {
    character.result = before;
    if (before) await engine.call("endPreview").then(colour);
    throw error;
  } finally {
    showFacts();
    listQuestions(focus);
  }
  listJoints();
  showBrush();
  await colour();
  await motions.again();
  await sendPose();
}

// ---- joints on and off, locked vertices, the brush

// Whether the last bind gave the joint no weight because names, places or the user say so.
const isOff = (joint) => Boolean(character?.result?.off.includes(joint));

async function switchJoint(joint) {
  const { source } = character;
  const { never, always } = source;
  Object.assign(source, switched(source, character.joints[joint].name, isOff(joint)));
  try {
    await bind();
  } catch (error) {
    Object.assign(source, { never, always });
    await bind().catch(() => {});
    throw error;
  }
}

async function lockJoint(joint) {
  const { source, joints } = character;
  const { name } = joints[joint];
  if (!source.locked.delete(name)) source.locked.add(name);
  await engine.call("lock", { joints: joints.flatMap((one, j) => (source.locked.has(one.name) ? [j] : [])) });
  await bind();
}

const brushKind = () => document.querySelector("#brush-kind input:checked").value;

function showBrush() {
  const kind = brushKind();
  const ready = Boolean(character?.result) && !view.editing;
  view.onStroke = ready && (kind === "smooth" || (kind === "add" && view.selected >= 0)) ? (vertex) => strokes.want(vertex).catch((error) => showError(error.message)) : null;
  $("brush").hidden = view.editing;
  if (kind !== "none") $("brush").open = true; // by its key
  $("brush-settings").hidden = kind === "none";
  for (const id of ["brush-size", "brush-strength"]) $(id).nextElementSibling.textContent = `${$(id).value} %`;
  const painted = character?.result?.paintedVertices ?? 0;
  $("painted").textContent = kind === "add" && view.selected < 0 ? "choose a joint" : painted ? `${number.format(painted)} vertices` : "";
  $("forget-paint").disabled = painted === 0;
}

// The newest place of the brush; the next bind has what it left as hints.
const strokes = new Latest(async (vertex) => {
  if (!character?.result) return;
  const stroke = {
    vertex,
    radius: (Number($("brush-size").value) / 100) * character.size,
    joint: brushKind() === "add" ? view.selected : -1,
    strength: Number($("brush-strength").value) / 100,
  };
  const shown = mode === modes.material ? modes.joints : mode;
  const { buffers } = await engine.call("paint", { stroke, mode: shown, joint: Math.max(0, view.selected) });
  view.setColours(buffers.colours);
});

function endStroke() {
  run(async () => {
    while (strokes.busy) await strokes.idle().catch(() => {}); // said already
    clearError();
    await bind();
  });
}

async function forgetPaint() {
  await engine.call("forgetPaint");
  await bind();
}

// ---- motion

function motionChanged(motion) {
  if (!motion) view.setSpots([]);
  $(motion ? "motion" : "pose").after($("bending")); // beside what moves the joints
  showSkeleton();
}

// A change of the motion, then its pose.
const changeMotion = (change) => run(async () => (clearError(), await change(), await sendPose()));

async function openMotionFile(file) {
  const one = await withBytes(file);
  await engine.call("write", { files: [one] });
  await playMotion(one.name);
}

async function playMotion(name) {
  await motions.open(name);
  if (view.editing) {
    setEditing(false);
    showSkeleton();
  }
  await sendPose();
}

// ---- what is shown

async function colour() {
  if ((mode === modes.field || mode === modes.artistField) && view.selected < 0) mode = modes.joints;
  const isArtists = mode === modes.artist || mode === modes.artistField;
  if ((isArtists || mode === modes.difference) && !character?.hasReference) mode = modes.joints;
  for (const input of document.querySelectorAll("#mode input, #artist input")) {
    input.checked = Number(input.value) === (isArtists ? modes.artist : mode);
    input.disabled = !character?.result || (Number(input.value) === modes.field && view.selected < 0);
  }
  showLegend();
  showSure();
  if (!character?.result) return;
  await showLookOfFile();
  const shown = mode === modes.material ? modes.joints : mode;
  const { mean, buffers } = await engine.call("colour", { mode: shown, joint: Math.max(0, view.selected) });
  shownMean = mean;
  showLegend();
  view.setColours(emphasised(buffers.colours));
}

// The GLB that would be saved now, with its materials, instead of the colours; read anew after each bind.
async function showLookOfFile() {
  if (mode !== modes.material) return view.setLook(null);
  const { result, joints } = character;
  if (view.look?.result === result) return;
  const { Look } = await import("./look.js");
  const { buffers } = await engine.call("glb", { name: character.name });
  const look = await Look.of(buffers.bytes, joints.map(({ name }) => name));
  look.result = result;
  view.setLook(look);
}

// The part that is looked at, orange where it is only asked about, and the rest dimmed.
function emphasised(colours) {
  if (!shownLook) return colours;
  const { of, number: wanted } = shownLook.question.members;
  const { vertexOf } = character.buffers;
  const isAsked = shownLook.answer === undefined;
  return colours.map((c, i) => {
    const axis = i % 3;
    if (of[vertexOf[(i - axis) / 3]] !== wanted) return 0.15 * c + 0.85 * dimmed[axis];
    return isAsked ? asked[axis] : c;
  });
}

function showLegend() {
  const name = character?.joints[view.selected]?.name ?? "";
  const [caption, low, high] = {
    [modes.joints]: ["Each joint has its colour; vertices that joints share blend them.", "", ""],
    [modes.field]: [`Weight of ${name}`, "0", "1"],
    [modes.doubt]: ["Doubt about the strongest joint", "sure", "look here"],
    [modes.artist]: ["The weights that the file had", "", ""],
    [modes.artistField]: [`The file's weight of ${name}`, "0", "1"],
    [modes.difference]: [`What moves otherwise than in the file: ${(100 * shownMean).toFixed(1)} % in the mean`, "alike", "otherwise"],
    [modes.material]: [`As other programs show the file${bends.skinning > 0 ? ": by linear skinning" : ""}`, "", ""],
  }[mode];
  $("legend").hidden = !character;
  $("legend").querySelector("figcaption").textContent = lookText() ?? caption;
  $("legend").querySelector(".scale").hidden = [modes.joints, modes.artist, modes.material].includes(mode) || Boolean(shownLook && shownLook.answer === undefined);
  $("legend").querySelector(".low").textContent = low;
  $("legend").querySelector(".high").textContent = high;
}

// How sure a predicted skeleton is, as the colour of its joints, and what is to be said about the whole.
function showSure() {
  const shown = Boolean(character?.predicted) && view.editing;
  $("sure").hidden = !shown;
  view.setJointColours(shown ? character.joints.map(({ confidence }) => sureColour(confidence)) : null);
  $("notice").hidden = !character?.doubtful;
}

const poses = new Latest(async () => {
  if (!character?.result) return;
  const [posed, { motion }, { skinning }] = [pose, player, bends];
  const plays = Boolean(motion) && !view.editing;
  const turns = view.editing ? new Float32Array(pose.turns.length) : pose.turns; // a skeleton is edited at rest
  const reply = plays ? await engine.call("frame", { clip: player.clip, seconds: player.seconds, skinning }) : await engine.call("pose", { turns, skinning });
  if (posed !== pose) return; // another character by now
  const { positions, normals, jointPositions, palette } = reply.buffers;
  view.setPose(positions, normals, jointPositions, turns, palette, plays);
  view.setSpots(plays && motions.methods.spotsShown ? reply.spots : []);
  bends.show(reply.bends, character.joints, player.playing);
});
const sendPose = () => poses.want();

function poseChanged() {
  showPose();
  sendPose().catch((error) => showError(error.message));
}

// more: beside the chosen joint, to turn with it.
function choose(joint, more = false) {
  if (!character || joint >= character.joints.length) return;
  if (more && joint >= 0 && view.selected >= 0 && joint !== view.selected) {
    const also = new Set(view.also);
    if (!also.delete(joint)) also.add(joint);
    view.also = also;
    showPose();
    return markJoint();
  }
  view.select(joint);
  if (mode === modes.artist || mode === modes.artistField) mode = joint >= 0 ? modes.artistField : modes.artist;
  else if (mode !== modes.material && mode !== modes.difference) mode = joint >= 0 ? modes.field : modes.joints;
  showPose();
  editor.show(character, joint);
  markJoint(); // into view: the panels may have taken room from the list
  run(colour);
}

function showPose() {
  const joint = view.selected;
  showBrush();
  $("switch").disabled = $("lock").disabled = joint < 0 || !character?.result;
  $("switch").textContent = isOff(joint) ? "Switch on" : "Switch off";
  $("lock").ariaPressed = String(joint >= 0 && Boolean(character?.source.locked?.has(character.joints[joint].name)));
  $("pose").hidden = view.editing || Boolean(player.motion);
  $("motion").hidden = $("bending").hidden = view.editing;
  view.turnable = !player.motion;
  posePanel.show(character, pose, joint, view.also);
}

function showCharacters() {
  const tabs = $("characters");
  tabs.hidden = open.length < 2;
  tabs.replaceChildren(
    ...open.map((one) => {
      const tab = document.createElement("button");
      tab.type = "button";
      tab.role = "tab";
      tab.textContent = one.name;
      tab.title = one.name;
      tab.ariaSelected = String(one.name === character?.name);
      tab.onclick = () => run(async () => (clearError(), load(one)));
      return tab;
    }),
  );
}

// result: what the line says of the bind, null while there is none.
function showFacts(result = character?.result) {
  $("facts").replaceChildren(...factsOf({ character, result, engine: engineFacts, models }));
  $("download").disabled = $("download-rig").disabled = $("download-fbx").disabled = !character?.result;
}

// ---- the skeleton

// Joints, their list and the panels, after any change of them.
function showSkeleton() {
  view.draggable = character.editable;
  listJoints();
  showPose();
  editor.show(character, view.selected);
  showLegend();
  showSure();
}

function setEditing(editing) {
  if (editing && !character) return;
  view.editing = editing;
  for (const input of document.querySelectorAll("#work input")) input.checked = (input.value === "skeleton") === editing;
  $("edit").hidden = !editing;
  $("ask").hidden = editing;
  if (editing) player.pause();
  showPose();
}

function edit(editing) {
  if (!character || view.editing === editing) return;
  setEditing(editing);
  showSkeleton();
  run(sendPose);
}

// rig: as the module describes it. chosen: the name of the joint that is chosen then.
function useRig({ joints, ...rig }, chosen) {
  const { source } = character;
  const isSame = joints.length === character.joints.length && joints.every(({ parent }, j) => parent === character.joints[j].parent);
  source.answers = answersFor(source.answers, character.joints, joints, kinds.rigid);
  Object.assign(character, { mirrored: false, doubtful: false }, rig, { joints });
  lookNowhere();
  if (isSame) {
    view.moveSkeleton(joints); // and renamed
  } else {
    pose = new Pose(joints.length);
    character.result = null;
    view.setSkeleton(joints);
    view.select(joints.findIndex(({ name }) => name === chosen));
  }
  showSkeleton();
}

const chosenName = () => character.joints[view.selected]?.name;

async function predict(wishes = editor.wishes) {
  const chosen = chosenName();
  if (!models.skeletons) await fetchModel("sinew_rig.sinew");
  if (wishes.detail > 0 && !models.hands) await fetchModel("sinew_hands.sinew");
  const rig = await engine.call("rig", { wishes: { ...wishes, upAxis: character.upAxis } });
  setEditing(true);
  useRig(rig, chosen);
}

async function editSkeleton(edits, chosen) {
  try {
    useRig(await engine.call("edit", { edits, mirror: editor.alike, continues: false }), chosen);
  } catch (error) {
    editor.show(character, view.selected); // what was typed is not so
    throw error;
  }
  await bind();
  if (edits[0].kind === editKinds.add) {
    $("rename").focus();
    $("rename").select();
  }
}

async function undoEdit(forward) {
  if (!(forward ? character?.canRedo : character?.canUndo)) return;
  useRig(await engine.call("undoEdit", { forward }), chosenName());
  await bind();
}

let dragged = null; // {joint, moved}: the name of the joint that is being dragged, and whether the module knows

// Weights follow a dragged joint as fast as the worker binds.
const moves = new Latest(async ({ of, place, step }) => {
  if (of !== character) return;
  const edits = [{ kind: editKinds.move, joint: step.joint, place }];
  const shown = { mode, joint: Math.max(0, view.selected) };
  const { rig, seconds, buffers } = await engine.call("move", {
    edits, mirror: editor.alike, continues: step.moved, ...how(), answers: asNumbers(character.source.answers), ...shown,
  });
  if (of !== character) return;
  step.moved = true;
  if (!moves.pending) {
    Object.assign(character, rig);
    view.moveSkeleton(rig.joints);
    editor.showPlace();
  }
  view.setColours(buffers.colours);
  if (character.result) {
    character.result = character.shown = { ...character.result, seconds, hash: pending };
    showFacts();
  }
});

function dragJoint(joint, place) {
  if (view.selected !== joint) choose(joint);
  dragged ??= { joint: character.joints[joint].name, moved: false };
  character.joints = movedJoints(character.joints, joint, place, character, editor.alike);
  view.moveSkeleton(character.joints);
  editor.showPlace();
  moves.want({ of: character, place, step: dragged }).catch((error) => showError(error.message));
}

function endDrag() {
  const ended = dragged;
  dragged = null;
  if (!ended) return;
  run(async () => {
    while (moves.busy) await moves.idle().catch(() => {}); // said already
    showSkeleton();
    if (ended.moved) await bind();
  });
}

function toMiddle() {
  if (!editor.canEdit || view.dragging) return;
  editor.move(view.middleOf(view.selected));
}

// ---- questions and answers

let look = null; // what the pointer or the keyboard is on in the list of questions
let shownLook = null; // what of that is shown
let lookTimer = 0;
let previewing = false; // the module shows a preview

function lookAt(wanted) {
  if (wanted === look) return;
  look = wanted;
  clearTimeout(lookTimer);
  lookTimer = setTimeout(() => {
    lookTimer = 0;
    run(showLook);
  }, lookMilliseconds);
}

// What a bind brings ends what was looked at.
function lookNowhere() {
  look = shownLook = null;
  previewing = false;
}

async function showLook() {
  if (look === shownLook || !character?.result) return;
  const wanted = look;
  const isPreview = wanted?.answer !== undefined && !character.source.answers.includes(wanted);
  const wasPreview = previewing;
  if (isPreview) {
    await engine.call("preview", { ...how(), answers: asNumbers([...character.source.answers, wanted]) });
  } else if (wasPreview) {
    await engine.call("endPreview");
  }
  previewing = isPreview;
  shownLook = wanted;
  await colour();
  if (isPreview || wasPreview) await sendPose();
}

function lookText() {
  if (!shownLook) return null;
  const { question, answer } = shownLook;
  const alike = question.parts > 1 ? ` in ${question.parts} parts alike` : "";
  if (answer === undefined) return `Orange: ${partName(question)}, ${number.format(question.vertices)} vertices${alike}`;
  return `${previewing ? "Preview" : "Answered"}: ${partName(question)} ${answer}${alike}`;
}

function listQuestions(focus) {
  const { answers } = character.source;
  const list = character.result?.questions ?? [];
  questions.show({ questions: list, answers, joints: character.joints, focus });
  $("questions-count").textContent = character.result ? `${list.length} open${answers.length ? `, ${answers.length} answered` : ""}` : "";
  $("style").hidden = !style;
  const byStyle = answers.filter((answer) => answer.byStyle).length;
  $("save-style").disabled = !character.result || answers.length === byStyle;
  const label = $("style").firstElementChild;
  label.textContent = label.title = style ? `${style.name}: ${byStyle} answers` : "";
}

function take(answer) {
  run(() => (clearError(), bind([...character.source.answers, answer], answer.question.part)));
}

function takeBack(answer) {
  run(() => (clearError(), bind(character.source.answers.filter((other) => other !== answer), answer.question.part)));
}

async function useStyle(file) {
  await engine.call("style", { name: file });
  style = file === "" ? null : { name: file };
}

// The style's answers for the character, before its own.
async function useStyleAnswers() {
  const { source } = character;
  if ((source.style ?? null) === style) return;
  const own = source.answers.filter(({ byStyle }) => !byStyle);
  const { answers, buffers } = style ? await engine.call("styleAnswers", how()) : { answers: [] };
  for (const answer of answers) {
    answer.byStyle = true;
    answer.question.members = { of: buffers.vertexQuestions, number: answer.number };
  }
  source.answers = [...answers, ...own];
  source.style = style;
}

async function forgetStyle() {
  await useStyle("");
  await useStyleAnswers();
  await bind();
}

async function saveStyle() {
  const own = character.source.answers.filter(({ byStyle }) => !byStyle);
  const name = `${character.name}.style`;
  const { buffers } = await engine.call("saveStyle", { ...how(), answers: asNumbers(own), name });
  save(buffers.bytes, "application/json", name);
}

const listJoints = () => jointList.show(character, view.selected, view.also);
const markJoint = () => jointList.mark(view.selected, view.also);

// ---- the user

function setMode(wanted) {
  if (!character?.result || (wanted === modes.field && view.selected < 0)) return;
  if ((wanted === modes.artist || wanted === modes.difference) && !character.hasReference) return;
  mode = wanted === modes.artist && view.selected >= 0 ? modes.artistField : wanted;
  run(colour);
}

function undo(forward) {
  if (view.editing) return view.dragging || run(() => (clearError(), undoEdit(forward)));
  if (forward ? pose?.redo() : pose?.undo()) poseChanged();
}

async function download() {
  const { buffers } = await engine.call("glb", { name: character.name });
  save(buffers.bytes, "model/gltf-binary", `${character.name}.${character.predicted ? "rigged" : "bound"}.glb`);
}

async function downloadFbx() {
  const { buffers } = await engine.call("glb", { name: character.name });
  const { glbToFbx } = await import("./fbx.js");
  save(await glbToFbx(buffers.bytes), "application/octet-stream", `${character.name}.${character.predicted ? "rigged" : "bound"}.fbx`);
}

async function playTestClip(name) {
  const file = `${name}.bvh`;
  await engine.call("write", { files: [{ name: file, bytes: new TextEncoder().encode(testClip(name)).buffer }] });
  await playMotion(file);
  if (!player.playing) player.toggle();
}

function turnPicture(id) {
  if (!character) return;
  const [x, y, z] = views[id];
  const turns = character.axis === 2 ? [z, y, x] : [x, y, z]; // it faces along x
  view.frame(turns);
}

async function downloadRig() {
  const { buffers } = await engine.call("rigText", { name: character.name });
  save(buffers.bytes, "text/plain", `${character.name}.rig.txt`);
}

function save(content, type, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function listen() {
  $("sample").append(new Option("Samples…", ""), ...samples.map(({ name }) => new Option(name, name)));
  $("sample").onchange = () => {
    const sample = samples.find(({ name }) => name === $("sample").value);
    if (sample) run(() => openSample(sample));
  };
  $("open").onclick = () => $("files").click();
  $("files").onchange = () => {
    const list = [...$("files").files];
    $("files").value = ""; // the same file again is news too
    run(() => openFiles(list));
  };
  $("download").onclick = () => run(download);
  $("download-rig").onclick = () => run(downloadRig);
  $("download-fbx").onclick = () => run(() => (clearError(), downloadFbx()));
  $("error").lastElementChild.onclick = clearError;

  // A drag passes over many elements; the count says when it has left the page.
  let over = 0;
  const drag = (step) => {
    over = Math.max(0, over + step);
    document.body.classList.toggle("dragging", over > 0);
  };
  addEventListener("dragenter", (event) => (event.preventDefault(), drag(1)));
  addEventListener("dragleave", () => drag(-1));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    drag(-over);
    const list = [...event.dataTransfer.files];
    run(() => (list.length > 0 ? openFiles(list) : Promise.reject(new Error("the drop held no files"))));
  });

  questions = new Questions($("questions"));
  questions.onLook = lookAt;
  questions.onTake = take;
  questions.onTakeBack = takeBack;
  $("save-style").onclick = () => run(() => (clearError(), saveStyle()));
  $("style").lastElementChild.onclick = () => run(() => (clearError(), forgetStyle()));

  editor = new SkeletonEditor();
  editor.onEdit = (edits, chosen) => run(() => (clearError(), editSkeleton(edits, chosen)));
  editor.onPredict = (wishes) => character && run(async () => (clearError(), await predict(wishes), await bind()));
  editor.onMiddle = toMiddle;
  jointList = new JointList();
  jointList.onPick = choose;
  motions = new Motions(engine, () => character, motionChanged);
  player = motions.player;
  $("test-clip").append(...testClips.map((name) => new Option(name, name)));
  $("test-clip").onchange = () => {
    const { value } = $("test-clip");
    $("test-clip").value = "";
    if (value !== "") run(() => (clearError(), playTestClip(value)));
  };
  player.onOpen = (file) => run(() => (clearError(), openMotionFile(file)));
  player.onClose = () => changeMotion(() => motions.close());
  motions.methods.onMethod = (method) => changeMotion(() => motions.useMethod(method));
  motions.methods.onSpots = poseChanged;
  motions.map.onPins = (pins) => changeMotion(() => motions.usePins(pins));
  motions.map.onPick = (joint) => choose(joint);
  bends = new BendPanel();
  bends.onChange = () => character && (showLegend(), poseChanged());
  bends.onPick = (joint) => choose(joint);
  player.onFrame = () => sendPose().catch((error) => showError(error.message));
  $("work").onchange = ({ target }) => edit(target.value === "skeleton");
  $("undo-edit").onclick = () => undo(false);
  $("redo-edit").onclick = () => undo(true);
  $("middle").onchange = () => (view.toMiddle = $("middle").checked);

  $("mode").onchange = $("artist").onchange = (event) => setMode(Number(event.target.value));
  const ofChosen = (job) => () => character?.result && view.selected >= 0 && run(() => (clearError(), job(view.selected)));
  $("switch").onclick = ofChosen(switchJoint);
  $("lock").onclick = ofChosen(lockJoint);
  $("brush-kind").onchange = showBrush;
  $("brush-size").oninput = $("brush-strength").oninput = showBrush;
  $("forget-paint").onclick = () => run(() => (clearError(), forgetPaint()));
  for (const id of Object.keys(views)) $(id).onclick = () => turnPicture(id);
  $("wireframe").onclick = toggleWireframe;
  $("bone-size").oninput = () => (view.boneSize = Number($("bone-size").value));
  options = new BindOptions();
  options.onChange = () => character && run(async () => (clearError(), bind()));

  posePanel = new PosePanel();
  posePanel.onChange = poseChanged;
  $("undo").onclick = () => undo(false);
  $("skeleton").onclick = toggleSkeleton;
  $("frame").onclick = () => character && view.frame();
  $("up").onchange = () => {
    const current = open.find(({ name }) => name === character?.name);
    if (current) run(async () => (clearError(), load(current, true)));
  };

  view.onDrag = dragJoint;
  view.onDragEnd = endDrag;
  view.planeOf = (joint) => (character.mirrored && editor.alike && character.joints[joint].partner === joint ? { axis: character.axis, at: character.plane } : null);
  view.onPickJoint = choose;
  view.onPickSurface = (shown, more) => character.result && choose(character.result.strongest[shown], more);
  view.onStrokeEnd = endStroke;
  view.onTurnStart = () => pose.remember();
  view.onTurn = (joint, ...turn) => posePanel.turn(joint, turn);

  listenForKeys({
    "/": () => $("search").focus(),
    f: () => character && view.frame(),
    s: toggleSkeleton,
    " ": () => player.toggle(),
    ",": () => player.step(-1),
    ".": () => player.step(1),
    r: () => !view.editing && !player.motion && posePanel.reset(),
    e: () => edit(!view.editing),
    a: () => view.editing && editor.add(),
    m: () => view.editing && toMiddle(),
    delete: () => view.editing && editor.remove(),
    backspace: () => view.editing && editor.remove(),
    1: () => setMode(modes.joints),
    2: () => setMode(modes.field),
    3: () => setMode(modes.doubt),
    4: () => setMode(modes.material),
    5: () => setMode(modes.artist),
    6: () => setMode(modes.difference),
    7: () => turnPicture("view-front"),
    8: () => turnPicture("view-side"),
    9: () => turnPicture("view-top"),
    c: () => player.motion && !view.editing && motions.methods.next(),
    d: () => !view.editing && bends.next(),
    w: toggleWireframe,
    x: () => $("switch").click(),
    l: () => $("lock").click(),
    b: nextBrush,
  }, { onUndo: undo, onEscape: escape });
}

// The innermost thing that is open closes.
function escape() {
  if (document.activeElement === $("search")) $("search").blur();
  else if (document.activeElement === $("rename")) editor.show(character, view.selected), $("rename").blur();
  else if (!$("error").hidden) clearError();
  else if (!questions.close()) choose(-1);
}

function toggleWireframe() {
  view.wireframe = !view.wireframe;
  $("wireframe").ariaPressed = String(view.wireframe);
}

function nextBrush() {
  const kinds = [...document.querySelectorAll("#brush-kind input")];
  kinds[(kinds.findIndex(({ checked }) => checked) + 1) % kinds.length].checked = true;
  showBrush();
}

function toggleSkeleton() {
  view.skeletonShown = !view.skeletonShown;
  $("skeleton").ariaPressed = String(view.skeletonShown);
}

async function start() {
  const forceScalar = new URLSearchParams(location.search).has("scalar");
  engineFacts = await engine.call("start", { forceScalar });
  await fetchModel("sinew_default.sinew");
  const wanted = new URLSearchParams(location.search).get("sample");
  const sample = samples.find(({ name }) => name === wanted);
  if (sample) return openSample(sample);
  await openSample(samples.find(({ name }) => name === "biped__caped")); // a cape, a skirt and a hat: what is hard to bind
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) await playTestClip("walk");
}

try {
  view = new View($("stage"));
  listen();
  run(start);
} catch (error) {
  showError(`this browser shows no 3D picture (${error.message}); turn on WebGL or try another browser`);
}

// What the tests ask: everything that was started is done, and the state that no element shows.
window.sinewPage = {
  async settled() {
    while (true) {
      const last = queue;
      await last;
      if (last === queue && !poses.busy && !moves.busy && !strokes.busy && lookTimer === 0) return;
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
  },
  get view() {
    return view;
  },
  get character() {
    return character;
  },
};
