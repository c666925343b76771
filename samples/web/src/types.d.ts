// SPDX-License-Identifier: MIT
// What the page's parts hand to each other, for the checker of types alone (tsconfig.json).
import type { History } from "./history.js";

export interface Joint {
  name: string;
  parent: number;
  position: number[];
  partner: number; // -1: none
  side?: number;
  end?: boolean;
  confidence?: number;
  named?: number;
}

/** As edit() of web.cpp reads them; kinds are editKinds of skeleton.js. */
export interface Edit {
  kind: number;
  joint: string;
  other?: string;
  place?: number[];
}

export interface Placement {
  turns: string[];
  height: number;
  floor: boolean;
}

export interface Marker {
  joint: string;
  place: number[];
}

export interface Recipe {
  wishes: Record<string, unknown> | null; // null: the file's own skeleton
  edits: { edits: Edit[]; mirror: boolean }[];
}

export interface Question {
  part: number;
  mesh: string;
  joint: string;
  vertices: number;
  parts: number;
  share: number;
  alternatives: { answer: string; kind: number; joint: number; change: number }[];
  members?: { of: ArrayLike<number>; number: number };
}

export interface Answer {
  question: Question;
  answer: string;
  kind: number;
  joint: number;
  byStyle?: boolean;
  number?: number;
}

export interface Motion {
  files: string[];
  method: number;
  pins: Record<string, Record<string, number>>; // of each file, joint's name -> joint of the file, or -1
  inPlace?: boolean;
  armSpread?: number; // degrees
}

/** Of what swings: which chains, by name, and how much of what was found for them. */
export interface Springs {
  on: boolean;
  switched: Record<string, boolean>;
  stiffness: number;
  drag: number;
  gravity: number;
}

/** As sinew springs has them. */
export interface SpringWish {
  take: string[];
  drop: string[];
  values: string[];
}

/** As web_picture() of web.cpp reads them. */
export interface PictureWishes {
  class?: string;
  figure?: number;
  mask?: string;
  flat?: boolean;
  cut?: boolean;
  outline?: number[][][];
}

/** As web_picture() of web.cpp tells it. */
export interface Picture {
  width: number;
  height: number;
  figures: number;
  figure: number;
  clip: string;
  flat: boolean;
  cut: boolean;
  outline: number[][][];
  place: { scale: number; left: number; bottom: number };
}

export interface BindValues {
  toPose: string;
  method: string;
  symmetric: boolean;
  rigidParts: string;
  softness: string;
  influences: string;
}

/** A character as undo brings it back. Sets and lists in it are never changed, others take their place. */
export interface State {
  kept: number; // in the module, 0: not there
  epoch: number; // of the worker that kept it
  recipe: Recipe;
  up: number;
  pose: Float32Array;
  options: BindValues;
  never: Set<string>;
  always: Set<string>;
  locked: Set<string>;
  answers: Answer[];
  style: { name: string } | null;
  motion: Motion | null;
  springs: Springs | null;
  markers: Marker[];
  placement: Placement;
  rows?: any; // weights that no bind makes again, painted and locked ones, as web_rows() has them, or a promise of them; null: none
  pictureWishes?: PictureWishes;
}

/** Files that were dropped together, see documents.js. */
export interface Document {
  folder: number;
  files: Map<string, File>;
  beside: string[]; // names of what was dropped with characters: pictures, .bin, .mtl
}

/** A character that was dropped, and what its user did. */
export interface Source {
  document: Document;
  id?: string; // that its work is kept by
  keptWith?: string; // the files that are kept with it
  changed?: boolean; // something was done that no file has
  looked?: Set<string>; // steps that the user was in
  exported?: boolean;
  resumed?: boolean; // it is of the work that was kept
  name: string;
  mesh: string;
  skeleton: string;
  number: number;
  step?: string;
  kept: number;
  recipe: Recipe;
  never: Set<string>;
  always: Set<string>;
  locked: Set<string>;
  answers: Answer[];
  style?: { name: string } | null;
  motion?: Motion | null;
  springs?: Springs | null;
  markers: Marker[];
  placement: Placement;
  rows?: any; // of the state, see there
  pictureWishes?: PictureWishes;
  history?: History;
}

export interface BindResult {
  hash: string;
  seconds: number;
  wallSeconds: number;
  usedBytes: number;
  strongest: ArrayLike<number>;
  questions: Question[];
  places: number[][];
  off: number[];
  lookFirst: number;
  lookFirstSure: number;
  leftOut: string[];
  lockedVertices: number;
  paintedVertices: number;
  rigidParts: number;
  grownTogether: string;
  keptMeshes: number;
  alone: boolean;
  buffers: Record<string, any>;
}

/** What the module has loaded, with its bind result. */
export interface Character {
  name: string;
  source: Source;
  joints: Joint[];
  vertices: number;
  faces: number;
  size: number;
  up: number;
  upAxis: number;
  tall: number[];
  notes: string[];
  buffers: Record<string, any>;
  result: BindResult | null;
  shown?: BindResult;
  placeable: boolean;
  posed?: boolean;
  predicted?: boolean;
  editable?: boolean;
  mirrored?: boolean;
  axis: number;
  plane: number;
  doubtful?: boolean;
  front?: any; // unit vector that was found or told, of a predicted skeleton; null without
  frontSure?: any; // probability of that, 0: it was not counted
  upSure?: any; // probability of upAxis
  doubts?: { name: string; joint: number; joints: number[] }[];
  suspects?: { name: string; joint: number; joints: number[] }[]; // see suspects.js
  ears?: { name: string; joint: number; joints: number[] }[]; // that move the head
  spread: number;
  seconds: number;
  hasReference: boolean;
  picture?: Picture;
}

/** Work that the browser keeps. */
export interface Kept {
  id: string;
  name: string;
  time: number;
  text: string;
  picture: string;
}

/** What is written to a project file. */
export interface Project {
  sinewProject: number;
  name: string;
  mesh: string;
  skeleton: string;
  beside: string[];
  step?: string;
  pictureWishes?: PictureWishes;
  state: Record<string, any>;
  rows: object | null;
}
