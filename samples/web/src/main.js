// SPDX-License-Identifier: MIT
// The page: what the user does, and how it begins.
import { forgetStyle, lookAt, saveStyle, take, takeBack } from "./asking.js";
import { BendPanel } from "./bends.js";
import { bind, endStroke, forgetPaint, lockJoint, switchJoint } from "./binding.js";
import { nextBrush, showBrush, strokes } from "./brush.js";
import { setMode, showLegend } from "./colours.js";
import { dragJoint, edit, editSkeleton, endDrag, moves, predict, toMiddle, undoEdit } from "./editing.js";
import { allFiles, motionFiles } from "./files.js";
import { clearError, queue, run, showError } from "./jobs.js";
import { JointList } from "./joint_list.js";
import { listenForKeys } from "./keys.js";
import { changeMotion, download, downloadFbx, downloadRig, load, motionChanged, openFiles, openMotionFile, openSample, playTestClip } from "./loading.js";
import { fetchModel } from "./models.js";
import { Motions } from "./motions.js";
import { BindOptions } from "./options.js";
import { PosePanel } from "./pose_panel.js";
import { Questions } from "./questions.js";
import { samples } from "./samples.js";
import { choose, poseChanged, poses, sendPose } from "./showing.js";
import { SkeletonEditor } from "./skeleton.js";
import { $, at, engine, modes, views } from "./state.js";
import { testClips } from "./test_clips.js";
import { View } from "./view.js";

engine.onProgress = (share) => {
  $("progress").firstElementChild.style.width = `${share * 100}%`;
  $("progress").setAttribute("aria-valuenow", String(Math.round(share * 100)));
};

function undo(forward) {
  if (at.view.editing) return at.view.dragging || run(() => (clearError(), undoEdit(forward)));
  if (forward ? at.pose?.redo() : at.pose?.undo()) poseChanged();
}

function turnPicture(id) {
  if (!at.character) return;
  const [x, y, z] = views[id];
  const turns = at.character.axis === 2 ? [z, y, x] : [x, y, z]; // it faces along x
  at.view.frame(turns);
}

function listen() {
  $("sample").append(new Option("Samples…", ""), ...samples.map(({ name }) => new Option(name, name)));
  $("sample").onchange = () => {
    const sample = samples.find(({ name }) => name === $("sample").value);
    if (sample) run(() => openSample(sample));
  };
  $("files").accept = allFiles;
  $("motion-files").accept = motionFiles;
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

  at.questions = new Questions($("questions"));
  at.questions.onLook = lookAt;
  at.questions.onTake = take;
  at.questions.onTakeBack = takeBack;
  $("save-style").onclick = () => run(() => (clearError(), saveStyle()));
  $("style").lastElementChild.onclick = () => run(() => (clearError(), forgetStyle()));

  at.editor = new SkeletonEditor();
  at.editor.onEdit = (edits, chosen) => run(() => (clearError(), editSkeleton(edits, chosen)));
  at.editor.onPredict = (wishes) => at.character && run(async () => (clearError(), await predict(wishes), await bind()));
  at.editor.onMiddle = toMiddle;
  at.jointList = new JointList();
  at.jointList.onPick = choose;
  at.motions = new Motions(engine, () => at.character, motionChanged);
  at.player = at.motions.player;
  $("test-clip").append(...testClips.map((name) => new Option(name, name)));
  $("test-clip").onchange = () => {
    const { value } = $("test-clip");
    $("test-clip").value = "";
    if (value !== "") run(() => (clearError(), playTestClip(value)));
  };
  at.player.onOpen = (file) => run(() => (clearError(), openMotionFile(file)));
  at.player.onClose = () => changeMotion(() => at.motions.close());
  at.motions.methods.onMethod = (method) => changeMotion(() => at.motions.useMethod(method));
  at.motions.methods.onSpots = poseChanged;
  at.motions.map.onPins = (pins) => changeMotion(() => at.motions.usePins(pins));
  at.motions.map.onPick = (joint) => choose(joint);
  at.bends = new BendPanel();
  at.bends.onChange = () => at.character && (showLegend(), poseChanged());
  at.bends.onPick = (joint) => choose(joint);
  at.player.onFrame = () => sendPose().catch((error) => showError(error.message));
  $("work").onchange = ({ target }) => edit(target.value === "skeleton");
  $("undo-edit").onclick = () => undo(false);
  $("redo-edit").onclick = () => undo(true);
  $("middle").onchange = () => (at.view.toMiddle = $("middle").checked);

  $("mode").onchange = $("artist").onchange = (event) => setMode(Number(event.target.value));
  const ofChosen = (job) => () => at.character?.result && at.view.selected >= 0 && run(() => (clearError(), job(at.view.selected)));
  $("switch").onclick = ofChosen(switchJoint);
  $("lock").onclick = ofChosen(lockJoint);
  $("brush-kind").onchange = showBrush;
  $("brush-size").oninput = $("brush-strength").oninput = showBrush;
  $("forget-paint").onclick = () => run(() => (clearError(), forgetPaint()));
  for (const id of Object.keys(views)) $(id).onclick = () => turnPicture(id);
  $("wireframe").onclick = toggleWireframe;
  $("bone-size").oninput = () => (at.view.boneSize = Number($("bone-size").value));
  at.options = new BindOptions();
  at.options.onChange = () => at.character && run(async () => (clearError(), bind()));

  at.posePanel = new PosePanel();
  at.posePanel.onChange = poseChanged;
  $("undo").onclick = () => undo(false);
  $("skeleton").onclick = toggleSkeleton;
  $("frame").onclick = () => at.character && at.view.frame();
  $("up").onchange = () => {
    const current = at.open.find(({ name }) => name === at.character?.name);
    if (current) run(async () => (clearError(), load(current, true)));
  };

  at.view.onDrag = dragJoint;
  at.view.onDragEnd = endDrag;
  at.view.planeOf = (joint) => (at.character.mirrored && at.editor.alike && at.character.joints[joint].partner === joint ? { axis: at.character.axis, at: at.character.plane } : null);
  at.view.onPickJoint = choose;
  at.view.onPickSurface = (shown, more) => at.character.result && choose(at.character.result.strongest[shown], more);
  at.view.onStrokeEnd = endStroke;
  at.view.onTurnStart = () => at.pose.remember();
  at.view.onTurn = (joint, ...turn) => at.posePanel.turn(joint, turn);

  listenForKeys({
    "/": () => $("search").focus(),
    f: () => at.character && at.view.frame(),
    s: toggleSkeleton,
    " ": () => at.player.toggle(),
    ",": () => at.player.step(-1),
    ".": () => at.player.step(1),
    r: () => !at.view.editing && !at.player.motion && at.posePanel.reset(),
    e: () => edit(!at.view.editing),
    a: () => at.view.editing && at.editor.add(),
    m: () => at.view.editing && toMiddle(),
    delete: () => at.view.editing && at.editor.remove(),
    backspace: () => at.view.editing && at.editor.remove(),
    1: () => setMode(modes.joints),
    2: () => setMode(modes.field),
    3: () => setMode(modes.doubt),
    4: () => setMode(modes.material),
    5: () => setMode(modes.artist),
    6: () => setMode(modes.difference),
    7: () => turnPicture("view-front"),
    8: () => turnPicture("view-side"),
    9: () => turnPicture("view-top"),
    c: () => at.player.motion && !at.view.editing && at.motions.methods.next(),
    d: () => !at.view.editing && at.bends.next(),
    w: toggleWireframe,
    x: () => $("switch").click(),
    l: () => $("lock").click(),
    b: nextBrush,
  }, { onUndo: undo, onEscape: escape });
}

// The innermost thing that is open closes.
function escape() {
  if (document.activeElement === $("search")) $("search").blur();
  else if (document.activeElement === $("rename")) at.editor.show(at.character, at.view.selected), $("rename").blur();
  else if (!$("error").hidden) clearError();
  else if (!at.questions.close()) choose(-1);
}

function toggleWireframe() {
  at.view.wireframe = !at.view.wireframe;
  $("wireframe").ariaPressed = String(at.view.wireframe);
}

function toggleSkeleton() {
  at.view.skeletonShown = !at.view.skeletonShown;
  $("skeleton").ariaPressed = String(at.view.skeletonShown);
}

async function start() {
  const forceScalar = new URLSearchParams(location.search).has("scalar");
  at.engineFacts = await engine.call("start", { forceScalar });
  await fetchModel("sinew_default.sinew");
  const wanted = new URLSearchParams(location.search).get("sample");
  const sample = samples.find(({ name }) => name === wanted);
  if (sample) return openSample(sample);
  await openSample(samples.find(({ name }) => name === "biped__caped")); // a cape, a skirt and a hat: what is hard to bind
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) await playTestClip("walk");
}

try {
  at.view = new View($("stage"));
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
      if (last === queue && !poses.busy && !moves.busy && !strokes.busy && at.lookTimer === 0) return;
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
  },
  get view() {
    return at.view;
  },
  get character() {
    return at.character;
  },
};
