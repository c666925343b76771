// SPDX-License-Identifier: MIT
// Lines of the readers and jobs, which speak to users of the command, as sentences of the page: without the command's options.
/** @type {(n: number, word: string, words?: string) => string} */
export const counted = (n, word, words = `${word}s`) => `${n.toLocaleString("en")} ${n === 1 ? word : words}`;

const isOption = /(^|[ (])--[a-z]/;

/** @param {string} line @returns {string} */
export function sentenceOf(line) {
  const parts = line.replace(/^warning: /, "").replace(/,? (or|and) (try|say it with) --[^;,.]*/g, "").replace(/ \([^()]*--[^()]*\)/g, "").split("; ");
  const kept = parts.filter((part) => !isOption.test(part)).join("; ").trim();
  const first = /^\S+\.\w+:/.test(kept) ? kept.slice(0, 1) : kept.slice(0, 1).toUpperCase(); // a file keeps its name
  return kept && `${first}${kept.slice(1)}${/[.!?]$/.test(kept) ? "" : "."}`;
}
