// SPDX-License-Identifier: MIT
// Files in: characters, models, motions, projects.
import { useStyle, useStyleAnswers } from "./asking.js";
import { saveWork } from "./autosave.js";
import { bind } from "./binding.js";
import { act } from "./acting.js";
import { colour } from "./colours.js";
import { restore } from "./commands.js";
import { forgetDocuments, giveFiles, newDocument } from "./documents.js";
import { showSkeleton, upOf } from "./editing.js";
import { isBeside, isPicture, isWhole, mayMove, pairFiles } from "./files.js";
import { clearError, run, whileBusy } from "./jobs.js";
import { useModel } from "./models.js";
import { asLoaded, remark, showOpened, unplaced } from "./opened.js";
import { longestSide } from "./sides.js";
import { closeOffer, offer } from "./offer.js";
import { filesOf, readProject } from "./project.js";
import { record, showHistory } from "./recording.js";
import { leftOut, reportClips } from "./report.js";
import { beginBound, reveal, showFound } from "./reveal.js";
import { showSteps } from "./rail.js";
import { sampleFiles } from "./samples.js";
import { frameClip, sendPose } from "./showing.js";
import { $, at, engine } from "./state.js";
import { firstStep, goTo, setStep } from "./steps.js";
import { unzip } from "./zip.js";

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
async function motionsAmong(names, { folder }) {
  const motions = [], unsure = [];
  for (const name of names.filter(mayMove)) {
    if (!at.character?.result && names.length === 1) break; // nothing that it could move
    const { mesh, clips } = await whileBusy(`Reading ${name}`, () => engine.call("contents", { name, folder })).catch(() => ({ mesh: true, clips: 0 })); // its error is said where it is opened
    if (clips > 0 && mesh && at.step === "motion" && at.character) unsure.push(name);
    else if (clips > 0 && !mesh) motions.push(name);
  }
  return { motions, unsure };
}

// Characters with animations, while another one's motions are worked on: the user says which is meant.
function askWhether(names, list) {
  const [words, open] = names.length === 1 ? [`${names[0]} is a character with animations.`, "Open it"] : [`${names.join(", ")} are characters with animations.`, "Open them"];
  offer(words, { [open]: () => run(() => openFiles(list, { meant: "characters" })), [`Play on ${at.character.name}`]: () => run(() => openFiles(list, { meant: "motions" })) });
}

// meant: what files are for that could be both, "characters" or "motions".
/** @param {File[]} dropped @param {{ meant?: string }} how */
export async function openFiles(dropped, { meant = "" } = {}) {
  clearError();
  closeOffer();
  if (dropped.length === 0) return;
  const list = await unpacked(dropped);
  const names = list.map(({ name }) => name);
  const isProject = names.includes("project.json");
  if (isProject) return openProject(dropped[0].name, (await list.find(({ name }) => name === "project.json")?.text()) ?? "", list);
  if (names.every(isPicture) && names.some(isMissing)) return addPictures(list);
  const document = newDocument();
  await giveFiles(list, document);
  try {
    const among = meant === "motions" ? { motions: names.filter(mayMove), unsure: [] } : await motionsAmong(names, document);
    if (among.unsure.length > 0 && meant === "") return askWhether(among.unsure, list);
    const moving = among.motions;
    const { waiting, waitingIn } = at;
    const found = pairFiles(names, waiting, moving);
    Object.assign(at, { waiting: found.waiting, waitingIn: document });
    if (found.model !== "") await useModel(found.model, document.folder);
    if (found.style !== "") await useStyle(found.style, document.folder);
    if (found.characters.length > 0) {
      const before = found.characters.flatMap(({ mesh, skeleton }) => [mesh, skeleton]).filter((name) => name && !names.includes(name));
      await giveFiles(before.flatMap((name) => waitingIn?.files.get(name) ?? []), document);
      document.beside = names.filter(isBeside);
      await openCharacters(found.characters, document);
    } else if ((found.model !== "" || found.style !== "") && at.character) {
      await useStyleAnswers();
      await bind();
      record(found.style || found.model);
    }
    if (found.motions.length > 0) {
      const of = at.character?.source.document;
      if (of && of !== document) await giveFiles(list, of);
      await playMotions(found.motions);
    }
    if (found.problems.length > 0) throw new Error(found.problems.join("; "));
  } finally {
    if (!at.open.some((source) => source.document === document)) await forgetDocuments([document]);
  }
}

// Pictures that the file which is open lacked.
async function addPictures(list) {
  const { source } = at.character;
  await giveFiles(list, source.document);
  source.document.beside = [...new Set([...source.document.beside, ...list.map(({ name }) => name)])];
  await load(source);
}

// They take the place of those that are open; what was done to one and is in no file stays open beside them.
async function openCharacters(characters, document, state = null) {
  const before = at.open;
  for (const source of characters) source.document = document;
  const stay = before.filter(({ changed, resumed }) => changed || resumed);
  at.open = [...stay, ...characters];
  try {
    await load(characters[0], state);
  } catch (error) {
    at.open = before;
    showCharacters();
    throw error;
  }
  $("sample").value = "";
  await forgetSources(before.filter((source) => !stay.includes(source)));
  await at.onOpened();
}

// Characters that are open no more.
function forgetSources(sources) {
  const gone = sources.map((source) => source.document).filter((document) => !at.open.some((source) => source.document === document));
  return forgetDocuments(gone, sources.map(({ number }) => number ?? 0));
}

export async function openSample(sample) {
  const files = await whileBusy(`Fetching ${sample.name}`, () => sampleFiles(sample));
  at.waiting = {};
  setStep("mesh"); // a sample is a character whatever was worked on
  await openFiles(files);
  $("sample").value = sample.name;
}

// A project's file, or what the browser kept. list: its files; id: that it is kept by.
/** @param {string} name @param {string} text @param {File[]} list @param {string} [id] */
export async function openProject(name, text, list, id) {
  const { state, ...project } = readProject(name, text);
  const files = list.filter((file) => file.name !== "project.json");
  const missing = filesOf({ ...project, state }).filter((wanted) => !files.some((file) => file.name === wanted));
  if (missing.length > 0) throw new Error(`${name}: lacks ${missing.join(", ")}`);
  const document = { ...newDocument(), beside: project.beside ?? [] };
  await giveFiles(files, document);
  at.waiting = {};
  const source = { id, resumed: id !== undefined, name: project.name, mesh: project.mesh, skeleton: project.skeleton, step: project.step, pictureWishes: project.pictureWishes };
  await openCharacters([source], document, state);
}

// After a stopped job: another worker, with what the character last was.
export async function reopen() {
  at.engineFacts = await engine.call("start", { forceScalar: at.forceScalar });
  for (const document of new Set(at.open.map((source) => source.document))) await giveFiles(document.files.values(), document);
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
    ...at.open.flatMap((one) => {
      const tab = Object.assign(document.createElement("button"), { type: "button", role: "tab", textContent: one.name, title: one.name, ariaSelected: String(one === at.character?.source) });
      tab.onclick = () => run(() => (clearError(), load(one)));
      const close = Object.assign(document.createElement("button"), { type: "button", className: "close", textContent: "×", title: `Close ${one.name}; your work is kept`, ariaLabel: `Close ${one.name}` });
      close.onclick = () => run(() => closeCharacter(one));
      return [tab, close];
    }),
  );
}

async function closeCharacter(source) {
  clearError();
  await saveWork(); // while it is the one that the module has
  const next = at.open.find((one) => one !== source && one === at.character?.source) ?? at.open.find((one) => one !== source);
  if (next !== at.character?.source) await load(next);
  at.open = at.open.filter((one) => one !== source);
  showCharacters();
  await forgetSources([source]);
  await at.onOpened();
}

// state: what it is to be like, of a project; else as its history last had it, else as its file has it.
export async function load(source, state = null) {
  const { name, mesh, document: { folder } } = source;
  if (source !== at.character?.source) await saveWork();
  at.player.pause();
  const isKnown = source.history && source.history.now.epoch === engine.epoch;
  if (!isKnown) source.number = ++at.lastNumber;
  const wanted = state ?? source.history?.now ?? null;
  source.placement = wanted?.placement ?? source.placement ?? unplaced;
  if (wanted) source.pictureWishes = wanted.pictureWishes;
  const loaded = await whileBusy(`Opening ${name}`, () =>
    source.pictureWishes ? engine.call("picture", { folder, mesh, wishes: source.pictureWishes, number: source.number }) : engine.call("load", asLoaded(source)),
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
    await restore(wanted, null);
  } else {
    if (loaded.joints.length === 0 && !loaded.picture) await reveal();
    else await beginBound();
    if (loaded.picture) await moveDrawing();
    if (isWhole(mesh) && source.motion === undefined && !at.character.predicted) await at.motions.open([mesh]).catch(() => {}); // most files have no animations
    if (at.player.motion?.own) reportClips(at.player.motion.clips.length);
    if (at.player.motion?.clips.every(({ seconds }) => seconds === 0)) await at.motions.close(); // a pose is none
  }
  const { rigidParts } = at.character.result ?? { rigidParts: 0 };
  if (rigidParts) remark(`Its ${rigidParts} rigid parts are attached to bones; here they get skin weights.`);
  record("");
  setStep(source.step ?? firstStep(at.character, Boolean(at.player.motion)), { view: false });
  showHistory();
  at.lastDone = source;
  if (at.player.motion?.own) frameClip();
  await sendPose();
  if (wanted || loaded.picture) return;
  if (at.character.predicted) await showFound();
  else if (leftOut() > 0) offer(`${name} is open. ${leftOut()} part${leftOut() === 1 ? "" : "s"} of the file ${leftOut() === 1 ? "was" : "were"} left out.`, { "See what": () => goTo("mesh"), "Go on": () => {} });
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
  at.player.start();
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
  await colour();
  frameClip();
  await sendPose();
  record(names.length === 1 ? `motion ${names[0]}` : `${names.length} motions`);
}

// A clip to try, on or off.
export function tryClip(name, file, wanted) {
  if (!wanted) return changeMotion(`remove ${name}`, () => at.motions.remove(file));
  return run(async () => {
    clearError();
    await playMotions([file]);
    at.player.start();
  });
}
