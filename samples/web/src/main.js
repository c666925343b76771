// SPDX-License-Identifier: MIT
// The page: what the user does, and how it begins.
import { act, posed } from "./acting.js";
import { forgetStyle, lookAt, saveStyle, take, takeBack } from "./asking.js";
import { autosaved, forgetWork, presentProject, warnBeforeLeaving } from "./autosave.js";
import { BendPanel } from "./bends.js";
import { bind, bindOtherwise, endStroke, forgetPaint, lockJoint, switchJoint } from "./binding.js";
import { nextBrush, showBrush, strokes } from "./brush.js";
import { cards } from "./cards.js";
import { listenForChecks } from "./checking.js";
import { setMode, showLegend } from "./colours.js";
import { undo } from "./commands.js";
import { changeKind, listenForDrawings } from "./drawing.js";
import { dragJoint, editName, editSkeleton, endDrag, moves, predict, toMiddle, upOf } from "./editing.js";
import { exportFor, listenForExport, showProgram } from "./export.js";
import { allFiles, motionFiles } from "./files.js";
import { showHelp } from "./help.js";
import { clearError, queue, recover, run, save, showError, stopJobs, whileBusy } from "./jobs.js";
import { JointList } from "./joint_list.js";
import { showKept } from "./kept.js";
import { listenForKeys } from "./keys.js";
import { changeMotion, motionChanged, openFiles, openSample, reopen, tryClip } from "./loading.js";
import { listenForMarkers } from "./marking.js";
import { Latest } from "./latest.js";
import { fetchModel } from "./models.js";
import { Motions } from "./motions.js";
import { listenForPlacement } from "./placing.js";
import { BindOptions } from "./options.js";
import { record } from "./recording.js";
import { Drag } from "./drag.js";
import { closeOffer } from "./offer.js";
import { PosePanel } from "./pose_panel.js";
import { chosenProgram } from "./programs.js";
import { Questions } from "./questions.js";
import { showSteps, steps } from "./rail.js";
import { walkOn } from "./reveal.js";
import { samples } from "./samples.js";
import { choose, frameClip, nextDoubt, poseChanged, poses, sendPose } from "./showing.js";
import { SkeletonEditor } from "./skeleton.js";
import { SpringPanel } from "./springs.js";
import { $, all, at, engine, modes, views } from "./state.js";
import { goTo, setStep } from "./steps.js";
import { View } from "./view.js";
import { zip } from "./zip.js";

engine.onCrash = recover;
engine.onProgress = (share) => {
  $("progress").classList.toggle("told", share > 0);
  $("progress").firstElementChild.style.width = share > 0 ? `${share * 100}%` : "100%";
  $("progress").setAttribute("aria-valuenow", String(Math.round(share * 100)));
};

function turnPicture(id) {
  if (!at.character) return;
  at.view.frame(views[id]);
}

function listenForFiles() {
  $("sample").append(new Option("choose…", ""), ...samples.map(({ name }) => new Option(name, name)));
  $("sample").onchange = () => {
    const sample = samples.find(({ name }) => name === $("sample").value);
    if (sample) run(() => openSample(sample));
  };
  for (const list of all("[data-samples]")) list.append(...cards((sample) => run(() => openSample(sample))));
  const choosing = (input, button, options) => {
    for (const id of button) $(id).onclick = () => $(input).click();
    $(input).onchange = () => {
      const list = [...$(input).files];
      $(input).value = ""; // the same file again is news too
      run(() => openFiles(list, options));
    };
  };
  $("files").accept = allFiles;
  $("motion-files").accept = motionFiles;
  choosing("files", ["open", "open-more"], {});
  choosing("motion-files", ["open-motion"], { meant: "motions" });
  choosing("camera", ["photograph", "photograph-more"], {});

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
    const list = [...(event.dataTransfer?.files ?? [])];
    run(() => (list.length > 0 ? openFiles(list) : Promise.reject(new Error("The drop contained no files."))));
  });
}

// The way on from the present step: the next one, and at the end the file.
function goOn() {
  const next = $("rail").children[steps.indexOf(at.step) + 1];
  if (next) goTo(next.dataset.step);
  else exportFor(chosenProgram());
}

async function saveProject() {
  clearError();
  const { project, files } = await presentProject();
  const list = await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
  save(zip([{ name: "project.json", bytes: new TextEncoder().encode(JSON.stringify(project)) }, ...list]), "application/zip", `${project.name}.sinewproject`);
  at.character.source.changed = at.character.source.resumed = false;
}

function listenForSkeleton() {
  at.editor = new SkeletonEditor();
  at.editor.onEdit = (edits, chosen) => act(editName(edits), () => editSkeleton(edits, chosen));
  at.editor.onPredict = (wishes, id) => at.character && (id === "kind" && at.character.picture ? changeKind() : act("new skeleton", async () => (await predict(wishes), await bind())));
  at.editor.onMiddle = toMiddle;
  listenForMarkers();
  listenForPlacement();
  listenForDrawings();
  at.jointList = new JointList();
  at.jointList.onPick = choose;
  $("next-doubt").onclick = nextDoubt;
  $("middle").onchange = () => (at.view.toMiddle = $("middle").checked);
  at.view.onDrag = dragJoint;
  at.view.onDragEnd = endDrag;
  at.view.planeOf = (joint) => (at.character.mirrored && at.editor.alike && at.character.joints[joint].partner === joint ? { axis: at.character.axis, at: at.character.plane } : null);
  $("up").onchange = () => at.character && act("up axis", changeUp);
}

function changeUp() {
  const { character } = at;
  character.up = Number($("up").value);
  if (character.predicted) return predict().then(() => bind());
  character.upAxis = upOf({ upAxis: undefined }, character.up);
  at.view.setUp(character.upAxis);
  return bind();
}

function listenForWeights() {
  at.questions = new Questions($("questions"));
  at.questions.onLook = lookAt;
  at.questions.onTake = take;
  at.questions.onTakeBack = takeBack;
  at.questions.pictureOf = (question) => at.view.pictureOf(question.members, at.character.buffers.vertexOf);
  $("next-question").onclick = () => (($("ask").open = true), at.questions.openFirst());
  $("save-style").onclick = () => run(() => (clearError(), saveStyle()));
  $("style").lastElementChild.onclick = () => act("remove style", forgetStyle);
  $("mode").onchange = $("artist").onchange = (event) => setMode(Number(event.target.value));
  const ofChosen = (word, job) => () => {
    const joint = at.view.selected;
    if (at.character?.result && joint >= 0) act(`${word} ${at.character.joints[joint].name}`, () => job(joint));
  };
  $("switch").onclick = ofChosen("switch", switchJoint);
  $("lock").onclick = ofChosen("lock", lockJoint);
  $("brush-kind").onchange = showBrush;
  $("brush-size").oninput = $("brush-strength").oninput = showBrush;
  $("forget-paint").onclick = () => act("clear painting", forgetPaint);
  at.view.onStrokeEnd = endStroke;
  at.options = new BindOptions();
  at.options.onChange = (name) => at.character && act(name, bindOtherwise);
}

function listenForPoses() {
  at.posePanel = new PosePanel();
  at.posePanel.onChange = poseChanged;
  at.posePanel.onStep = posed;
  at.view.onTurn = (joint, ...turn) => at.posePanel.turn(joint, turn);
  at.view.onTurnEnd = (joint) => posed(`rotate ${at.character.joints[joint].name}`);
  at.motions = new Motions(engine, () => at.character, motionChanged);
  at.player = at.motions.player;
  at.player.onClose = () => changeMotion("remove motions", () => at.motions.close());
  at.player.onFrame = () => sendPose().catch((error) => showError(error.message));
  at.motions.clips.onTry = tryClip;
  at.motions.clips.onPlay = (clip) => {
    at.player.choose(clip);
    frameClip();
  };
  at.motions.clips.onRemove = (file) => changeMotion(`remove ${file}`, () => at.motions.remove(file));
  at.motions.methods.onInPlace = (inPlace) => changeMotion(inPlace ? "stay in place" : "travel", () => at.motions.retargetWith({ inPlace }));
  at.motions.methods.onArmSpread = (armSpread) => changeMotion("arm spread", () => at.motions.retargetWith({ armSpread }));
  at.motions.methods.onMethod = (method) => changeMotion("method of retargeting", () => at.motions.useMethod(method));
  at.motions.methods.onSpots = poseChanged;
  at.motions.map.onPins = (pins) => changeMotion("map", () => at.motions.usePins(pins));
  at.motions.map.onPick = (joint) => choose(joint);
  at.springs = new SpringPanel();
  at.springs.onChange = changeMotion;
  at.springs.onSlide = () => slides.want().catch((error) => showError(error.message));
  at.springs.onSlid = (name) => run(async () => (await slides.idle(), record(name, { goesOn: true })));
  at.drag = new Drag();
  at.bends = new BendPanel();
  at.bends.onChange = () => at.character && (showLegend(), skinningChanged());
  at.bends.onPick = (joint) => choose(joint);
}

// Springs while one of their sliders moves.
const slides = new Latest(async () => (await at.springs.again(), await sendPose()));

// The first pose by another way of skinning may take a while: a deformer is made.
function skinningChanged() {
  run(() => whileBusy("Skinning", sendPose));
}

function listenForViews() {
  at.view.onPickJoint = choose;
  at.view.onPickSurface = (shown, more) => at.character.result && choose(at.character.result.strongest[shown], more);
  for (const id of Object.keys(views)) $(id).onclick = () => turnPicture(id);
  $("wireframe").onclick = toggleWireframe;
  $("bone-size").oninput = () => (at.view.boneSize = Number($("bone-size").value));
  $("skeleton").onclick = toggleSkeleton;
  $("frame").onclick = () => at.character && at.view.frame();
}

function listen() {
  for (const button of $("rail").children) button.onclick = () => goTo(button.dataset.step);
  $("sheet").onclick = () => ($("sheet").ariaExpanded = String($("sheet").ariaExpanded !== "true"));
  $("undo").onclick = () => undo(false);
  $("redo").onclick = () => undo(true);
  $("help").onclick = showHelp;
  $("stop").onclick = stopJobs;
  $("error").lastElementChild.onclick = clearError;
  at.afterStop = reopen;
  listenForFiles();
  listenForExport();
  listenForChecks();
  $("save-project").onclick = () => run(saveProject);
  $("onward").onclick = goOn;
  at.onExported = at.onProgram = () => showSteps();
  at.onStep = showProgram;
  at.onKind = walkOn;
  at.onOpened = showKept;
  listenForSkeleton();
  listenForWeights();
  listenForPoses();
  listenForViews();
  warnBeforeLeaving();
  const editing = () => at.view.editing;
  listenForKeys({
    "?": showHelp,
    "/": () => (at.step === "skeleton" || goTo("weights"), $("search").focus()),
    f: () => at.character && at.view.frame(),
    s: toggleSkeleton,
    " ": () => at.player.toggle(),
    ",": () => at.player.step(-1),
    ".": () => at.player.step(1),
    r: () => !editing() && !at.player.motion && at.posePanel.reset(),
    e: () => goTo(editing() ? "weights" : "skeleton"),
    n: nextDoubt,
    a: () => editing() && at.editor.add(),
    m: () => editing() && toMiddle(),
    delete: () => editing() && at.editor.remove(),
    backspace: () => editing() && at.editor.remove(),
    1: () => setMode(modes.joints),
    2: () => setMode(modes.field),
    3: () => setMode(modes.doubt),
    4: () => setMode(modes.material),
    5: () => setMode(modes.artist),
    6: () => setMode(modes.difference),
    7: () => turnPicture("view-front"),
    8: () => turnPicture("view-side"),
    9: () => turnPicture("view-top"),
    c: () => at.player.motion && !editing() && at.motions.methods.next(),
    d: () => !editing() && at.bends.next(),
    g: () => at.step === "motion" && at.drag.shake(),
    w: toggleWireframe,
    x: () => $("switch").click(),
    l: () => $("lock").click(),
    b: () => at.step === "weights" && nextBrush(),
  }, { onUndo: (forward) => undo(forward), onEscape: escape, onStep: (step) => goTo($("rail").children[step].dataset.step) });
}

// The innermost thing that is open closes.
function escape() {
  if ($("help-page").open) return; // its own
  if (stopJobs() || closeOffer()) return;
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
  at.forceScalar = new URLSearchParams(location.search).has("scalar");
  at.engineFacts = await whileBusy("Starting the engine", () => engine.call("start", { forceScalar: at.forceScalar }));
  await fetchModel("sinew_default.sinew");
  await showKept();
  const wanted = new URLSearchParams(location.search).get("sample");
  const sample = samples.find(({ name }) => name === wanted);
  if (sample) await openSample(sample);
}

// After the first bind, so that it takes nothing from it, or where none comes. A page without a worker of this kind works as well.
const offlineTimer = setTimeout(() => keepForOffline(), 15000);
function keepForOffline() {
  at.onFirstBound = () => {};
  clearTimeout(offlineTimer);
  if ("serviceWorker" in navigator && isSecureContext) navigator.serviceWorker.register("sw.js").catch(() => {});
}

try {
  at.view = new View($("stage"));
  listen();
  setStep("mesh");
  at.onFirstBound = keepForOffline;
  run(start);
} catch (error) {
  showError(`This browser cannot show 3D (${error.message}): turn on WebGL or use another browser`);
}
// What the tests ask: everything that was started is done, and the state that no element shows.
Object.assign(window, { sinewPage: {
  async settled() {
    while (true) {
      const last = queue;
      await last;
      if (last === queue && !poses.busy && !moves.busy && !strokes.busy && !slides.busy && at.lookTimer === 0) return;
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
  },
  autosaved,
  forgetWork,
  // The step and the folded part that an element is in.
  reveal(id) {
    const wanted = $(id);
    const part = wanted?.closest("[data-steps]");
    const body = wanted?.closest("#panel-body, #brush");
    if (!body || !part) return;
    const of = part.dataset.steps.split(" ");
    if (at.character && !of.includes(at.step)) goTo(of.includes("weights") ? "weights" : of[0]);
    for (let fold = wanted.closest("details"); fold; fold = fold.parentElement.closest("details")) if (!wanted.matches("summary")) fold.open = true;
  },
  get view() {
    return at.view;
  },
  get character() {
    return at.character;
  },
  get drags() {
    return at.drag.runs;
  },
  get step() {
    return at.step;
  },
  get firstAlone() {
    return at.firstAlone;
  },
} });
