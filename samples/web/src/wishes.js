// SPDX-License-Identifier: MIT
// What a bind of the open character is asked for, and what the last one said of a joint.
import { at } from "./state.js";

export const pending = "·".repeat(16); // a hash that is not known yet

export const how = () => ({ wish: at.options.wish(at.character) });
/** @type {(answers: import("./types.js").Answer[]) => number[][]} */
export const asNumbers = (answers) => answers.map(({ question, kind, joint }) => [question.part, kind, joint]);

// Whether the last bind gave the joint no weight because names, places or the user say so.
/** @type {(joint: number) => boolean} */
export const isOff = (joint) => Boolean(at.character?.result?.off.includes(joint));
