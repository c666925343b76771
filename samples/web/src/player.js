// SPDX-License-Identifier: MIT
// The panel that plays motions: clips, time and speed. What a frame looks like is the page's business.
import { $, isStill } from "./elements.js";
import { sentenceOf } from "./sentences.js";

export class MotionPlayer {
  /** @type {(...of: any[]) => any} */
  onClose = () => {};
  /** @type {(...of: any[]) => any} */
  onFrame = () => {}; // the clip or the time has changed
  /** @type {(...of: any[]) => any} */
  onClip = () => {};

  /** @type {any} */
  #motion = null; // as the module describes it, with {own, method, pins}
  #seconds = 0;
  #playing = false;
  #last = 0; // when the picture before this one was drawn, milliseconds

  constructor() {
    $("close-motion").onclick = () => this.onClose();
    $("clip").onchange = () => this.choose($("clip").selectedIndex);
    $("time").oninput = () => {
      this.pause();
      this.#to(Number($("time").value));
    };
    $("play").onclick = () => this.toggle();
  }

  get motion() {
    return this.#motion;
  }
  get playing() {
    return this.#playing;
  }
  get clip() {
    return Math.max(0, $("clip").selectedIndex);
  }
  get seconds() {
    return this.#seconds;
  }
  // {file, mapped, how, sourceJoints, map, notes} of the clip that plays.
  get fileOfClip() {
    return this.#motion?.files[this.#motion.clips[this.clip].file];
  }

  // motion: as the module describes it; null for none. With clips of the same names as before it stays at the same place.
  /** @param {any} motion */
  show(motion) {
    const names = (/** @type {any} */ of) => of?.clips.map((/** @type {{ name: string }} */ { name }) => name).join("\n");
    const isSame = motion && names(motion) === names(this.#motion);
    if (!motion) this.pause();
    this.#motion = motion;
    $("timeline").hidden = !motion;
    if (!motion) return this.#sayAbout();
    if (isSame) {
      this.#sayAbout();
      return this.#to(Math.min(this.#seconds, this.#length));
    }
    $("clip").replaceChildren(...motion.clips.map((/** @type {{ name: string, seconds: number }} */ { name, seconds }) => new Option(`${name || "clip"}, ${seconds.toFixed(1)} s`)));
    $("clip").hidden = motion.clips.length < 2;
    this.choose(0);
  }

  // Another clip, from its beginning.
  /** @param {number} clip */
  choose(clip) {
    $("clip").selectedIndex = clip;
    this.#sayAbout();
    this.#to(0);
    this.onClip();
  }

  #sayAbout() {
    const about = $("motion-about");
    if (!this.#motion) {
      about.textContent = "Choose a clip, or drop a motion file.";
      about.title = "";
      about.classList.remove("warns");
      return;
    }
    const { file, mapped, how, notes } = this.fileOfClip;
    about.textContent = `${file.replace(/^builtin:/, "")}: moves ${mapped} of ${this.#motion.joints} bones, matched by ${how}.`;
    about.title = [about.textContent, ...notes].join("\n");
    const warnings = /** @type {string[]} */ (notes).filter((note) => note.startsWith("warning: "));
    about.classList.toggle("warns", warnings.length > 0);
    about.append(...warnings.map((note) => ` ${sentenceOf(note.replace(`${file}: `, ""))}`));
  }

  // At once, where the system has not asked for stillness.
  start() {
    if (!this.#playing && !isStill()) this.toggle();
  }

  toggle() {
    if (!this.#motion) return;
    if (this.#playing) this.pause();
    else this.#play();
  }

  pause() {
    const played = this.#playing;
    this.#playing = false;
    this.#showPlaying();
    if (played && this.#motion) this.onFrame(); // all of it
  }

  // By so many frames; pauses.
  /** @param {number} frames */
  step(frames) {
    if (!this.#motion) return;
    this.pause();
    const clip = this.#motion.clips[this.clip];
    const frame = clip.seconds / Math.max(1, clip.frames - 1);
    this.#to(Math.min(clip.seconds, Math.max(0, this.#seconds + frames * frame)));
  }

  #play() {
    this.#playing = true;
    this.#showPlaying();
    if (this.#seconds >= this.#length) this.#to(0);
    this.#last = performance.now();
    const next = (/** @type {number} */ now) => {
      if (!this.#playing) return;
      const passed = Math.max(0, (now - this.#last) / 1e3) * Number($("speed").value);
      this.#last = now;
      const length = this.#length;
      this.#to(length > 0 ? (this.#seconds + passed) % length : 0);
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  }

  get #length() {
    return this.#motion.clips[this.clip].seconds;
  }

  #showPlaying() {
    $("play").textContent = this.#playing ? "Pause" : "Play";
    $("play").ariaPressed = String(this.#playing);
  }

  /** @param {number} seconds */
  #to(seconds) {
    this.#seconds = seconds;
    $("time").max = String(this.#length);
    $("time").value = String(seconds);
    $("time-said").textContent = `${seconds.toFixed(2)} s`;
    this.onFrame();
  }
}
