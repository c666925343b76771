// SPDX-License-Identifier: MIT
// Files in and out: characters, models, motions.
import { listQuestions, lookNowhere } from "./asked.js";
import { useStyle, useStyleAnswers } from "./asking.js";
import { bind } from "./binding.js";
import { predict, setEditing, showSkeleton, upOf } from "./editing.js";
import { isBeside, isWhole, pairFiles } from "./files.js";
import { clearError, run, save } from "./jobs.js";
import { useModel } from "./models.js";
import { Pose } from "./pose.js";
import { sampleFiles } from "./samples.js";
import { sendPose, showFacts } from "./showing.js";
import { $, at, engine, modes } from "./state.js";
import { testClip } from "./test_clips.js";

export async function openFiles(list) {
  clearError();
  if (list.length === 0) return;
  const files = await Promise.all(list.map(withBytes));
  const names = files.map((file) => file.name);
  await engine.call("write", { files }, files.map((file) => file.bytes));
  const found = pairFiles(names, at.waiting);
  at.waiting = found.waiting;
  if (found.model !== "") await useModel(found.model);
  if (found.style !== "") await useStyle(found.style);
  if (found.characters.length > 0) {
    const before = at.open;
    at.open = found.characters;
    // What lay beside other characters is not theirs.
    const anew = at.open.every(({ mesh }) => names.includes(mesh));
    const old = anew ? at.beside.filter((name) => !names.includes(name)) : [];
    await engine.call("setAside", { names: old, where: "aside" });
    try {
      await load(at.open[0]);
    } catch (error) {
      at.open = before;
      await engine.call("setAside", { names: old, where: "back" });
      showCharacters();
      throw error;
    }
    await engine.call("setAside", { names: old, where: "gone" });
    at.beside = [...(anew ? [] : at.beside), ...names.filter(isBeside)];
    $("sample").value = "";
    const kept = new Set([...names, ...at.open.flatMap((c) => [c.mesh, c.skeleton])]);
    const isOld = (n) => n && !kept.has(n);
    await engine.call("remove", { names: before.flatMap((c) => [c.mesh, c.skeleton]).filter(isOld), numbers: before.map((c) => c.number ?? 0) });
  } else if ((found.model !== "" || found.style !== "") && at.character) {
    await useStyleAnswers();
    await bind();
  }
  if (found.motion !== "") await playMotion(found.motion);
  if (found.problems.length > 0) throw new Error(found.problems.join("; "));
}

const withBytes = async (file) => ({ name: file.name, bytes: await file.arrayBuffer() });

export async function openSample(sample) {
  const files = await sampleFiles(sample);
  at.waiting = {};
  await openFiles(files);
  $("sample").value = sample.name;
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
      tab.onclick = () => run(async () => (clearError(), load(one)));
      return tab;
    }),
  );
}

// anew: a predicted skeleton is predicted again, as for another up axis.
export async function load(source, anew = false) {
  const { name, mesh, skeleton } = source;
  source.number ??= ++at.lastNumber;
  const loaded = await engine.call("load", { mesh, skeleton, number: source.number });
  // From here on the module has the new character, whether it can be bound or not.
  const up = Number($("up").value);
  const upAxis = upOf(loaded, up);
  at.character = { ...loaded, name, up, upAxis, source, result: null, size: longestSide(loaded.buffers.positions) };
  source.answers ??= [];
  source.locked = new Set(); // with the rows that were locked
  $("artist").hidden = !loaded.hasReference;
  $("remarks").textContent = loaded.notes.join("\n");
  $("remarks").hidden = loaded.notes.length === 0;
  at.pose = new Pose(loaded.joints.length);
  at.dragged = null;
  lookNowhere();
  at.view.setCharacter({ ...loaded.buffers, joints: loaded.joints, upAxis });
  at.mode = modes.joints;
  $("search").value = "";
  showCharacters();
  setEditing(loaded.predicted || loaded.joints.length === 0);
  showSkeleton();
  listQuestions();
  showFacts();
  if (loaded.joints.length === 0 || (anew && loaded.predicted)) await predict();
  await useStyleAnswers();
  await bind();
  if (isWhole(mesh) && source.motion === undefined && !at.character.predicted) await at.motions.open(mesh).catch(() => {}); // most files have no animations
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

export function motionChanged(motion) {
  if (!motion) at.view.setSpots([]);
  $(motion ? "motion" : "pose").after($("bending")); // beside what moves the joints
  showSkeleton();
}

// A change of the motion, then its pose.
export const changeMotion = (change) => run(async () => (clearError(), await change(), await sendPose()));

export async function openMotionFile(file) {
  const one = await withBytes(file);
  await engine.call("write", { files: [one] });
  await playMotion(one.name);
}

async function playMotion(name) {
  await at.motions.open(name);
  if (at.view.editing) {
    setEditing(false);
    showSkeleton();
  }
  await sendPose();
}

export async function download() {
  const { buffers } = await engine.call("glb", { name: at.character.name });
  save(buffers.bytes, "model/gltf-binary", `${at.character.name}.${at.character.predicted ? "rigged" : "bound"}.glb`);
}

export async function downloadFbx() {
  const { buffers } = await engine.call("glb", { name: at.character.name });
  const { glbToFbx } = await import("./fbx.js");
  save(await glbToFbx(buffers.bytes), "application/octet-stream", `${at.character.name}.${at.character.predicted ? "rigged" : "bound"}.fbx`);
}

export async function playTestClip(name) {
  const file = `${name}.bvh`;
  await engine.call("write", { files: [{ name: file, bytes: new TextEncoder().encode(testClip(name)).buffer }] });
  await playMotion(file);
  if (!at.player.playing) at.player.toggle();
}

export async function downloadRig() {
  const { buffers } = await engine.call("rigText", { name: at.character.name });
  save(buffers.bytes, "text/plain", `${at.character.name}.rig.txt`);
}
