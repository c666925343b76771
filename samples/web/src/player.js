// SPDX-License-Identifier: MIT
// The panel that plays motions: clips, time and speed. What a frame looks like is the page's business.

const $ = (id) => document.getElementById(id);

export class MotionPlayer {
  onOpen = () => {}; // a File
  onClose = () => {};
  onFrame = () => {}; // the clip or the time has changed
  onClip = () => {};

  #motion = null; // as the module describes it, with {name, own, method}
  #seconds = 0;
  #playing = false;
  #last = 0; // when the picture before this one was drawn, milliseconds

  constructor() {
    $("open-motion").onclick = () => $("motion-files").click();
    $("motion-files").onchange = () => {
      const [file] = $("motion-files").files;
      $("motion-files").value = ""; // the same file again is news too
      if (file) this.onOpen(file);
    };
    $("close-motion").onclick = () => this.onClose();
    $("clip").onchange = () => (this.#to(0), this.onClip());
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

  // What the line about the motion says while it is made, which takes seconds for large meshes.
  wait(name) {
    $("motion-about").textContent = `${name}: retargeting…`;
  }

  // motion: as the module describes it, with its file's name; null for none. Where it had one with that name before, it
  // stays at the same place of it.
  show(motion, enabled) {
    const isSame = motion && this.#motion?.name === motion.name && this.#motion.clips.length === motion.clips.length;
    if (!motion) this.pause();
    this.#motion = motion;
    $("open-motion").disabled = $("test-clip").disabled = !enabled;
    $("player").hidden = $("speed").hidden = $("close-motion").hidden = !motion;
    const about = $("motion-about");
    if (!motion) {
      about.innerHTML = "Drop a <b>BVH</b>, or open a file with animations.";
      about.title = "";
      return;
    }
    about.textContent = `${motion.name}: ${motion.mapped} of ${motion.joints} joints move by ${motion.how}${motion.notes.map((note) => `. ${note}`).join("")}`;
    about.title = about.textContent;
    if (isSame) return this.#to(Math.min(this.#seconds, this.#length));
    $("clip").replaceChildren(...motion.clips.map(({ name, seconds }) => new Option(`${name || "clip"}, ${seconds.toFixed(1)} s`)));
    $("clip").hidden = motion.clips.length < 2;
    this.#to(0);
  }

  toggle() {
    if (!this.#motion) return;
    if (this.#playing) this.pause();
    else this.#play();
  }

  pause() {
    this.#playing = false;
    this.#showPlaying();
  }

  // By so many frames; pauses.
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
    const next = (now) => {
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

  #to(seconds) {
    this.#seconds = seconds;
    $("time").max = String(this.#length);
    $("time").value = String(seconds);
    $("time-said").textContent = `${seconds.toFixed(2)} s`;
    this.onFrame();
  }
}
