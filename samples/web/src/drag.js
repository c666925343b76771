// SPDX-License-Identifier: MIT
// The whole character on the pointer, in the step Motion, so that one sees what swings on it: it goes along, turns with Shift, and comes back when it is let
// go. Beside it a drag orbits.
import { showError } from "./jobs.js";
import { sendPose } from "./showing.js";
import { $, at } from "./state.js";

const homeSeconds = 0.12; // in which a character that was let go is a third as far from its place
const swingSeconds = 3; // that chains still swing then
const longest = 0.25; // seconds of one frame; after a longer one chains would begin anew
const shakes = { seconds: 1.2, times: 2.5, far: 0.12 }; // of the character's size

export class Drag {
  /** @type {{ move: number[], degrees: number, last: number, letGo: number, shaken: number, begins: boolean } | null} */
  #now = null;

  constructor() {
    $("spring-grab").onchange = () => this.show();
    $("shake").onclick = () => this.shake();
  }

  // Whether the pointer takes the character.
  show() {
    const takes = at.step === "motion" && at.springs.on && $("spring-grab").checked;
    at.view.onGrab = takes ? (/** @type {number[]} */ move, /** @type {number} */ degrees, /** @type {boolean} */ ended) => this.#to(move, degrees, ended) : null;
    if (!at.springs.on) this.#now = null;
  }

  get runs() {
    return this.#now !== null;
  }

  // From side to side by itself.
  shake() {
    if (!at.springs.on) return;
    this.#to([0, 0, 0], 0, false);
    if (this.#now) this.#now.shaken = performance.now();
  }

  // What the next frame is to show; null where nobody drags.
  next() {
    if (!this.#now) return null;
    const time = performance.now();
    const passed = Math.min(longest, (time - this.#now.last) / 1e3);
    this.#now.last = time;
    const { move, degrees, begins } = this.#now;
    this.#now.begins = false;
    return { move: [...move], degrees, passed, begins };
  }

  /** @param {number[]} move @param {number} degrees @param {boolean} ended */
  #to(move, degrees, ended) {
    const isNew = !this.#now;
    const time = performance.now();
    this.#now ??= { move, degrees, last: time, letGo: 0, shaken: 0, begins: true };
    Object.assign(this.#now, ended ? { letGo: time } : { move, degrees, letGo: 0, shaken: 0 });
    if (isNew) this.#run(time);
  }

  /** @param {number} last */
  #run(last) {
    const drag = this.#now;
    if (!drag) return;
    const time = performance.now();
    if (drag.shaken) this.#shakeOn(drag, time);
    else if (drag.letGo) {
      const left = Math.exp(-(time - last) / 1e3 / homeSeconds);
      drag.move = drag.move.map((x) => x * left);
      drag.degrees *= left;
      if (time - drag.letGo > swingSeconds * 1e3) {
        this.#now = null;
        return;
      }
    }
    sendPose().catch((/** @type {Error} */ error) => showError(error.message));
    requestAnimationFrame(() => this.#run(time));
  }

  /** @param {{ move: number[], letGo: number, shaken: number }} drag @param {number} time */
  #shakeOn(drag, time) {
    const share = (time - drag.shaken) / 1e3 / shakes.seconds;
    drag.move = [at.character.size * shakes.far * Math.sin(2 * Math.PI * shakes.times * Math.min(1, share)), 0, 0];
    if (share >= 1) Object.assign(drag, { shaken: 0, letGo: time });
  }
}
