// SPDX-License-Identifier: MIT
// Files in: characters, models, motions, projects.
import { useStyle, useStyleAnswers } from "./asking.js";
import { bind } from "./binding.js";
import { act } from "./acting.js";
import { restore } from "./commands.js";
import { predict, showSkeleton, upOf } from "./editing.js";
import { isBeside, isPicture, isWhole, mayMove, pairFiles } from "./files.js";
import { clearError, run, whileBusy } from "./jobs.js";
import { useModel } from "./models.js";
import { asLoaded, longestSide, remark, showOpened, unplaced } from "./opened.js";
import { filesOf, readProject } from "./project.js";
import { record, showHistory } from "./recording.js";
import { showSteps } from "./rail.js";
import { sampleFiles } from "./samples.js";
import { sendPose } from "./showing.js";
import { $, at, engine } from "./state.js";
import { firstStep, setStep } from "./steps.js";
import { unzip } from "./zip.js";

// Files for the module. Dropped ones stay with the page, which writes them again for a project or another worker.
export async function giveFiles(list) {
  const files = await Promise.all(list.map(async (file) => ({ name: file.name, bytes: await file.arrayBuffer() })));
  for (const file of list) at.files.set(file.name, file);
  await engine.call("write", { files }, files.map(({ bytes }) => bytes));
}

async function unpacked(list) {
  const files = await Promise.all(
    list.map(async (file) => {
      if (!/\.(zip|sinewproject)$/i.test(file.name)) return [file];
      return (await unzip(file.name, new Uint8Array(await file.arrayBuffer()))).map(({ name, bytes }) => new File([bytes], name));
    }),
  );
  return files.flat();
}

const isMissing = (name) => at.character?.notes?.some((note) => note.includes(`'${name}' was not found`)) ?? false;

// What files that hold a mesh or a motion are for here: a motion where there is no mesh, and where motions are what is worked on.
async function motionsAmong(names) {
  const motions = [];
  for (const name of names.filter(mayMove)) {
    if (!at.character?.result && names.length === 1) break; // nothing that it could move
    const { mesh, clips } = await whileBusy(`Reading ${name}`, () => engine.call("contents", { name })).catch(() => ({ mesh: true, clips: 0 })); // its error is said where it is opened
    if (clips > 0 && mesh && at.step === "motion" && at.character) remark(`${name} moves ${at.character.name}. To open it as a character, drop it in the step Mesh.`);
    if (clips > 0 && (!mesh || (at.step === "motion" && at.character))) motions.push(name);
  }
  return motions;
}

// asMotions: whatever they are, their motions are meant.
export async function openFiles(dropped, { asMotions = false } = {}) {
  clearError();
  if (dropped.length === 0) return;
  const list = await unpacked(dropped);
  const names = list.map(({ name }) => name);
  const isProject = names.includes("project.json");
  if (isProject) return openProject(dropped[0].name, (await list.find(({ name }) => name === "project.json")?.text()) ?? "", list);
  await giveFiles(list);
  if (names.every(isPicture) && names.some(isMissing)) return run(() => load(at.character.source)); // of the file that is open
  const moving = asMotions ? names.filter(mayMove) : await motionsAmong(names);
  const found = pairFiles(names, at.waiting, moving);
  at.waiting = found.waiting;
  if (found.model !== "") await useModel(found.model);
  if (found.style !== "") await useStyle(found.style);
  if (found.characters.length > 0) {
    await openCharacters(found.characters, names);
  } else if ((found.model !== "" || found.style !== "") && at.character) {
    await useStyleAnswers();
    await bind();
    record(found.style || found.model);
  }
  if (found.motions.length > 0) await playMotions(found.motions);
  if (found.problems.length > 0) throw new Error(found.problems.join("; "));
}

async function openCharacters(characters, names, state = null, rows = null) {
  const before = at.open;
  at.open = characters;
  // What lay beside other characters is not theirs.
  const anew = at.open.every(({ mesh }) => names.includes(mesh));
  const old = anew ? at.beside.filter((name) => !names.includes(name)) : [];
  await engine.call("setAside", { names: old, where: "aside" });
  try {
    await load(at.open[0], state, rows);
  } catch (error) {
    at.open = before;
    showCharacters();
    await engine.call("setAside", { names: old, where: "back" });
    throw error;
  }
  await engine.call("setAside", { names: old, where: "gone" });
  at.beside = [...(anew ? [] : at.beside), ...names.filter(isBeside)];
  $("sample").value = "";
  at.changed = at.exported = false;
  const kept = new Set([...names, ...at.open.flatMap((c) => [c.mesh, c.skeleton])]);
  const gone = before.flatMap((c) => [c.mesh, c.skeleton]).filter((n) => n && !kept.has(n));
  for (const name of gone) at.files.delete(name);
  await engine.call("remove", { names: gone, numbers: before.map((c) => c.number ?? 0) });
}

export async function openSample(sample) {
  const files = await whileBusy(`Fetching ${sample.name}`, () => sampleFiles(sample));
  at.waiting = {};
  setStep("mesh"); // a sample is a character whatever was worked on
  await openFiles(files);
  $("sample").value = sample.name;
}

// A project's file, or what the browser kept. list: its files.
export async function openProject(name, text, list) {
  const { state, rows, ...project } = readProject(name, text);
  const files = list.filter((file) => file.name !== "project.json");
  const missing = filesOf({ ...project, state }).filter((wanted) => !files.some((file) => file.name === wanted));
  if (missing.length > 0) throw new Error(`${name}: lacks ${missing.join(", ")}`);
  await giveFiles(files);
  at.waiting = {};
  const source = { name: project.name, mesh: project.mesh, skeleton: project.skeleton, step: project.step, pictureWishes: project.pictureWishes };
  await openCharacters([source], files.map((file) => file.name), state, rows);
}

// After a stopped job: another worker, with what the character last was.
export async function reopen() {
  at.engineFacts = await engine.call("start", { forceScalar: at.forceScalar });
  await giveFiles([...at.files.values()]);
  for (const file of at.modelFiles) {
    const bytes = await file.arrayBuffer();
    await engine.call("write", { files: [{ name: file.name, bytes }] }, [bytes]);
    await useModel(file.name);
  }
  if (at.lastDone) return load(at.lastDone);
  Object.assign(at, { character: null });
  document.body.classList.add("start");
}

function showCharacters() {
  const tabs = $("characters");
  tabs.hidden = at.open.length < 2;
  tabs.replaceChildren(
    ...at.open.map((one) => {
      const tab = document.createElement("button");
      tab.type = "button";
      tab.role = "tab";
      tab.textContent = one.name;
      tab.title = one.name;
      tab.ariaSelected = String(one.name === at.character?.name);
      tab.onclick = () => run(() => (clearError(), load(one)));
      return tab;
    }),
  );
}

// state: what it is to be like, of a project, with its rows; else as its history last had it, else as its file has it.
export async function load(source, state = null, rows = null) {
  const { name, mesh } = source;
  at.player.pause();
  const isKnown = source.history && source.history.now.epoch === engine.epoch;
  if (!isKnown) source.number = ++at.lastNumber;
  const wanted = state ?? source.history?.now ?? null;
  source.placement = wanted?.placement ?? source.placement ?? unplaced;
  if (wanted) source.pictureWishes = wanted.pictureWishes;
  const loaded = await whileBusy(`Opening ${name}`, () =>
    source.pictureWishes ? engine.call("picture", { mesh, wishes: source.pictureWishes, number: source.number }) : engine.call("load", asLoaded(source)),
  );
  // From here on the module has the new character, whether it can be bound or not.
  if (!wanted) forgetOptions();
  const up = Number($("up").value);
  const upAxis = upOf(loaded, up);
  at.character = { ...loaded, name, up, upAxis, source, result: null, size: longestSide(loaded.buffers.positions), placeable: !loaded.picture };
  Object.assign(source, { answers: source.answers ?? [], never: source.never ?? new Set(), always: source.always ?? new Set(), markers: source.markers ?? [], recipe: source.recipe ?? { wishes: null, edits: [] }, kept: 0 });
  source.locked = new Set(); // with the rows that were locked
  showOpened(loaded);
  showCharacters();
  if (wanted) {
    await bring(wanted, rows);
  } else {
    if (loaded.joints.length === 0) await predict();
    await useStyleAnswers();
    await bind();
    if (loaded.picture) await moveDrawing();
    if (isWhole(mesh) && source.motion === undefined && !at.character.predicted) await at.motions.open([mesh]).catch(() => {}); // most files have no animations
  }
  const { rigidParts } = at.character.result ?? { rigidParts: 0 };
  if (rigidParts) remark(`Its ${rigidParts} parts hang on joints as they are; here they are bound like a skin.`);
  record("");
  setStep(source.step ?? firstStep(at.character, Boolean(at.player.motion)), { view: false });
  showHistory();
  at.lastDone = source;
  await sendPose();
}

// What was asked for the character before says nothing of this one.
function forgetOptions() {
  at.options.reset();
  at.editor.showWishes(null);
  $("up").value = "2";
}

// A drawing moves at once, as its class does.
async function moveDrawing() {
  const { picture } = at.character;
  if (!picture?.clip) return;
  at.view.frame([0, 0.05, 1]); // it is flat
  await at.motions.open([picture.clip]);
  if (!at.player.playing && !matchMedia("(prefers-reduced-motion: reduce)").matches) at.player.toggle();
}

// The character that was just loaded, as it was in that state.
async function bring(state, rows) {
  const { source } = at.character;
  if (state.epoch !== engine.epoch && state.locked.size > 0 && !rows) state = { ...state, locked: new Set() }; // those rows went with the worker
  await restore(state, null);
  if (!rows) return;
  await engine.call("putRows", { rows });
  source.locked = state.locked;
  await bind();
}

export function motionChanged(motion) {
  if (!motion) at.view.setSpots([]);
  document.body.classList.toggle("moving", Boolean(motion));
  showSkeleton();
  showSteps();
}

// A change of the motion, then its pose; a step of the history.
export const changeMotion = (name, change) => act(name, async () => (await change(), await sendPose()));

async function playMotions(names) {
  await at.motions.add(names);
  setStep("motion");
  at.view.frameClip(at.player.motion.clips[at.player.clip].room, at.character.upAxis);
  await sendPose();
  record(names.length === 1 ? `motion ${names[0]}` : `${names.length} motions`);
}

// A clip to try, on or off.
export function tryClip(name, file, wanted) {
  if (!wanted) return changeMotion(`remove ${name}`, () => at.motions.remove(file));
  return run(async () => {
    clearError();
    await playMotions([file]);
    if (!at.player.playing && !matchMedia("(prefers-reduced-motion: reduce)").matches) at.player.toggle();
  });
}
