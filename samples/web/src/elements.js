// SPDX-License-Identifier: MIT
// Elements of index.html. Of which kind each is that page says, and no type.

/** @type {(id: string) => any} */
export const $ = (id) => document.getElementById(id);
/** @type {(selector: string) => any[]} */
export const all = (selector) => [...document.querySelectorAll(selector)];

// The system asks for stillness.
export const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
