// SPDX-License-Identifier: MIT
// A character with all that was done to it, as text and files: what autosave keeps in the browser and a project file outside.

const format = 1;

// character: as the page has it; state: of its history; rows: of the module, or null. Answers keep their questions, pictures of them do not.
/** @param {import("./types.js").Character} character @param {import("./types.js").State} state @param {object | null} rows @param {string[]} beside @returns {any} */
export function projectOf({ name, source }, state, rows, beside) {
  const { recipe, up, options, pose, never, always, locked, answers, motion, springs, markers, placement } = state;
  return {
    sinewProject: format, name, mesh: source.mesh, skeleton: source.skeleton, beside, step: source.step, pictureWishes: source.pictureWishes,
    state: {
      recipe, up, options, motion, springs, markers, placement, pose: [...pose], never: [...never], always: [...always], locked: [...locked],
      answers: answers.map(({ question: { members, ...question }, answer, kind, joint, byStyle }) => ({ question, answer, kind, joint, byStyle })),
    },
    rows,
  };
}

// Names of the files that it needs.
/** @type {(project: { mesh: string, skeleton: string, beside: string[], pictureWishes?: import("./types.js").PictureWishes, state: { motion: import("./types.js").Motion | null } }) => string[]} */
export const filesOf = ({ mesh, skeleton, beside, pictureWishes, state }) =>
  [...new Set([mesh, skeleton, ...beside, pictureWishes?.mask ?? "", ...(state.motion?.files ?? [])])].filter((file) => file !== "" && !file.startsWith("builtin:"));

// {name, mesh, skeleton, step, state} of a project's text. Throws Error for anything else.
/** @param {string} name @param {string} text */
export function readProject(name, text) {
  let project;
  try {
    project = JSON.parse(text);
  } catch {
    throw new Error(`${name}: its project.json is damaged`);
  }
  if (project?.sinewProject !== format) throw new Error(`${name}: expected a project of version ${format}, found ${project?.sinewProject ? `version ${project.sinewProject}` : "something else"}`);
  const { state, rows } = project;
  return {
    ...project,
    state: { ...state, rows, pictureWishes: project.pictureWishes, kept: 0, markers: state.markers ?? [], springs: state.springs ?? null, epoch: 0, style: null, pose: Float32Array.from(state.pose), never: new Set(state.never), always: new Set(state.always), locked: new Set(state.locked) },
  };
}
