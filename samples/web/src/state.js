// SPDX-License-Identifier: MIT
// What the page's parts know in common: what is open, what is chosen, and the panels.
import { Engine } from "./engine.js";

export const $ = (id) => document.getElementById(id);
export const modes = { joints: 0, field: 1, doubt: 2, artist: 3, artistField: 4, difference: 5, material: -1 }; // ColourMode of web.cpp, and the file's own look
export const views = { "view-front": [0, 0, 1], "view-side": [1, 0, 0], "view-top": [0, 1, 0.001] };

export const engine = new Engine();
export const models = {}; // by their task: {name, bytes, parameters, layers}

export const at = {
  view: null,
  step: "mesh", // of steps.js
  engineFacts: {}, // {kernel, version, moduleBytes}
  // Characters that were dropped together: {name, mesh, skeleton, number}, and what their user did: {answers, style, never, always, locked, motion,
  // recipe, kept, history, step}. Sets and lists of these are never changed, others take their place.
  open: [],
  files: new Map(), // name -> File of all that the module has
  beside: [], // names of what was dropped with them: pictures, .bin, .mtl
  waiting: {}, // a mesh or a rig that its other half may still follow
  character: null, // what the module has loaded, with its bind result
  lastDone: null, // of `open`: that was opened as a whole
  lastNumber: 0, // of the characters that were opened
  pose: null,
  posePanel: null,
  mode: modes.material,
  questions: null,
  editor: null,
  markers: null, // their panel
  player: null,
  motions: null, // the player among them
  bends: null,
  jointList: null,
  options: null,
  shownMean: 0, // of what the colours show, see web.cpp
  style: null, // {name}: answers for the characters from now on
  dragged: null, // {joint, moved, done}: the name of the joint that is being dragged, whether the module knows, and the edits that it did last
  look: null, // what the pointer or the keyboard is on in the list of questions
  shownLook: null, // what of that is shown
  lookTimer: 0,
  previewing: false, // the module shows a preview
  modelFiles: [], // of the page's own, as Files
  modeChosen: false, // the user chose what the picture shows, in this step
  exported: false,
  firstAlone: null, // whether the first bind needed the first part of the module alone
  onFirstBound: () => {},
  forceScalar: false,
  changed: false, // something was done that no file has yet
  afterStop: () => {}, // brings the page back when a job was stopped
};
