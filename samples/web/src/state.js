// SPDX-License-Identifier: MIT
// What the page's parts know in common: what is open, what is chosen, and the panels.
import { $, all } from "./elements.js";
import { Engine } from "./engine.js";

export { $, all };
export const modes = { joints: 0, field: 1, doubt: 2, artist: 3, artistField: 4, difference: 5, material: -1 }; // ColourMode of web.cpp, and the file's own look
export const views = { "view-front": [0, 0, 1], "view-side": [1, 0, 0], "view-top": [0, 1, 0.001] };

export const engine = new Engine();
/** @type {Record<string, { name: string, bytes: number, parameters: number, layers: number }>} */
export const models = {}; // by their task

/**
 * @typedef {import("./types.js").Source} Source
 * @typedef {import("./types.js").Character} Character
 */
/** @type {any} */
const later = null; // panels and what they show, there before anything is done

export const at = {
  /** @type {import("./view.js").View} */
  view: later,
  step: "mesh", // of steps.js
  engineFacts: { kernel: "", version: "", moduleBytes: 0 },
  // Characters that were dropped together: {name, mesh, skeleton, number}, and what their user did: {answers, style, never, always, locked, motion,
  // recipe, kept, history, step}. Sets and lists of these are never changed, others take their place.
  /** @type {Source[]} */
  open: [],
  /** @type {{ mesh?: string, rig?: string }} */
  waiting: {}, // a mesh or a rig that its other half may still follow
  /** @type {import("./types.js").Document | null} */
  waitingIn: null,
  /** @type {Character} */
  character: later, // null: none is open; what the module has loaded, with its bind result
  /** @type {Source | null} */
  lastDone: null, // of `open`: that was opened as a whole
  lastNumber: 0, // of the characters that were opened
  /** @type {import("./pose.js").Pose} */
  pose: later,
  /** @type {import("./pose_panel.js").PosePanel} */
  posePanel: later,
  mode: modes.material,
  /** @type {import("./questions.js").Questions} */
  questions: later,
  /** @type {import("./skeleton.js").SkeletonEditor} */
  editor: later,
  /** @type {import("./markers.js").MarkerPanel} */
  markers: later, // their panel
  /** @type {import("./dial.js").PlacementDial} */
  dial: later,
  /** @type {import("./player.js").MotionPlayer} */
  player: later,
  /** @type {import("./motions.js").Motions} */
  motions: later, // the player among them
  /** @type {import("./springs.js").SpringPanel} */
  springs: later,
  /** @type {import("./drag.js").Drag} */
  drag: later, // of the whole character
  /** @type {import("./bends.js").BendPanel} */
  bends: later,
  /** @type {import("./joint_list.js").JointList} */
  jointList: later,
  /** @type {import("./options.js").BindOptions} */
  options: later,
  shownMean: 0, // of what the colours show, see web.cpp
  /** @type {{ name: string } | null} */
  style: null, // : answers for the characters from now on
  /** @type {{ joint: string, moved: boolean, done: import("./types.js").Edit[] | null } | null} */
  dragged: null, // : the name of the joint that is being dragged, whether the module knows, and the edits that it did last
  /** @type {any} */
  look: null, // what the pointer or the keyboard is on in the list of questions
  /** @type {any} */
  shownLook: null, // what of that is shown
  /** @type {any} */
  lookTimer: 0,
  previewing: false, // the module shows a preview
  /** @type {File[]} */
  modelFiles: [], // of the page's own, as Files
  modeChosen: false, // the user chose what the picture shows, in this step
  /** @type {boolean | null} */
  firstAlone: null, // whether the first bind needed the first part of the module alone
  onFirstBound: () => {},
  forceScalar: false,
  onExported: () => {},
  onStep: () => {}, // another step is worked on
  /** @type {() => any} */
  onOpened: () => {}, // other characters are open
  onKind: () => {}, // the user said what the body is
  onProgram: () => {}, // another one is chosen in the step Export
  /** @type {() => any} */
  afterStop: () => {}, // brings the page back when a job was stopped
};
