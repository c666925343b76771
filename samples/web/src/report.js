// SPDX-License-Identifier: MIT
// What a file held when it was opened: what was found, what was mended or guessed, and what was left out. It stays in the step Mesh.
import { counted, sentenceOf } from "./sentences.js";
import { $, at } from "./state.js";

/** @typedef {"found" | "mended" | "left"} Kind */
const heads = { found: "Found", mended: "Mended or guessed", left: "Left out" };
/** @type {[Kind, RegExp][]} */
const words = [["left", /left out|not found|not read|is gone|are gone|stay still|no joint above|skipped|ignored/], ["mended", /mended|guess|taken for|read as|so one was|standing|turned|was made|were made|bound like a skin|stood/]];

// Which of the three a line of the reader belongs to.
/** @type {(line: string) => Kind} */
export const kindOf = (line) => words.find(([, expression]) => expression.test(line))?.[0] ?? "found";

/** @type {{ kind: Kind, line: string }[]} */
let lines = [];
// What the module tells of a file that it has just read.
/** @param {any} loaded */
export function beginReport({ vertices, faces, joints, hasReference, license, picture }) {
  lines = [{ kind: "found", line: `${counted(vertices, "vertex", "vertices")} and ${counted(faces, "face")}` }];
  if (picture) lines.push({ kind: "found", line: `a drawing with ${counted(picture.figures, "figure")}` });
  else lines.push(joints.length > 0 ? { kind: "found", line: `a skeleton of ${counted(joints.length, "bone")}${hasReference ? " with skin weights, to compare with in Weights, Options" : " without skin weights"}` } : { kind: "mended", line: "no skeleton in the file, so one was made" });
  if (license?.authors.length > 0) lines.push({ kind: "found", line: `an author: ${license.authors.join(", ")}` });
  showReport();
}

/** @param {string} line */
export function report(line) {
  lines.push({ kind: kindOf(line), line });
  showReport();
}

// How many things of the file are not here.
export const leftOut = () => lines.filter(({ kind }) => kind === "left").length;

/** @param {number} clips */
export const reportClips = (clips) => clips > 0 && report(counted(clips, "clip"));

function showReport() {
  const kinds = /** @type {Kind[]} */ (["found", "mended", "left"]);
  const shown = kinds.filter((kind) => lines.some((one) => one.kind === kind));
  $("report-said").textContent = shown.slice(1).map((kind) => `${lines.filter((one) => one.kind === kind).length} ${kind === "left" ? "left out" : "mended"}`).join(", ");
  $("report-lines").replaceChildren(
    ...shown.flatMap((kind) => {
      const head = Object.assign(document.createElement("dt"), { textContent: heads[kind] });
      return [head, ...lines.filter((one) => one.kind === kind).map(({ line }) => Object.assign(document.createElement("dd"), { textContent: sentenceOf(line) }))];
    }),
  );
  $("report").hidden = !at.character;
}
