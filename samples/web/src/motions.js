// SPDX-License-Identifier: MIT
// The motions that a character plays: opened by the module, by the method and the maps that the user has chosen, and retargeted again when the
// character has changed. What was chosen is the character's source.motion, see Motion in types.d.ts.
import { ClipList } from "./clip_list.js";
import { whileBusy } from "./jobs.js";
import { MapPanel } from "./map_panel.js";
import { MethodPanel, motionMethods } from "./methods.js";
import { MotionPlayer } from "./player.js";
import { at } from "./state.js";

export class Motions {
  player = new MotionPlayer();
  methods = new MethodPanel();
  map = new MapPanel();
  clips = new ClipList();
  #engine;
  #current;
  #changed;

  // current: () => the character that is open, or null; changed: called when a motion is there or gone.
  constructor(engine, current, changed) {
    this.#engine = engine;
    this.#current = current;
    this.#changed = changed;
    this.player.onClip = () => this.#showClip();
  }

  // Files that the module has, or builtin:NAME: their clips are the character's from now on.
  async open(files, { method = motionMethods.contacts, pins = {}, inPlace = false, armSpread = 0 } = {}) {
    const character = this.#current();
    if (!character?.result) throw new Error(`${files[0]} is a motion: open a character first`);
    const { source, joints, up, picture } = character;
    const own = files.length === 1 && files[0] === source.mesh;
    const known = files.map((file) => new Map(joints.flatMap((joint, j) => (joint.name in (pins[file] ?? {}) ? [[j, pins[file][joint.name]]] : []))));
    const wish = { up, own, picture: Boolean(picture), method, inPlace, armSpread, pins: known.map((one) => [...one]) };
    const motion = await whileBusy("Retargeting the motion", () => this.#engine.call("motion", { names: files, wish }));
    source.motion = { files, method, pins, inPlace, armSpread };
    this.#show({ own, method, inPlace, armSpread, pins: known, ...motion });
    await at.springs.again();
  }

  // More of them; the first new clip plays.
  async add(files) {
    const { source } = this.#current() ?? {};
    const before = this.player.motion?.own ? null : source?.motion;
    const more = files.filter((file) => !before?.files.includes(file));
    const again = files.filter((file) => !more.includes(file)); // dropped once more: read anew
    await this.open([...(before?.files ?? []), ...more], before ?? {});
    const first = this.player.motion.files.findIndex(({ file }) => file === (more[0] ?? again[0]));
    this.player.choose(this.player.motion.clips.findIndex(({ file }) => file === first));
  }

  async remove(file) {
    const { source } = this.#current();
    const files = source.motion.files.filter((one) => one !== file);
    if (files.length === 0) return this.close();
    await this.open(files, source.motion);
  }

  async close() {
    this.#current().source.motion = null;
    await this.again();
  }

  // The same motions for a character that was bound or whose skeleton was changed; none where it has none.
  async again() {
    const { source } = this.#current();
    if (!source.motion) return this.#none();
    try {
      await this.open(source.motion.files, source.motion);
    } catch (error) {
      source.motion = null;
      await this.#none();
      throw error;
    }
  }

  // The same motions by another method, at the same place.
  async useMethod(method) {
    const { motion } = this.player;
    if (!motion) return;
    const { source } = this.#current();
    try {
      Object.assign(motion, await whileBusy("Retargeting the motion", () => this.#engine.call("motionMethod", { method })), { method });
      source.motion = { ...source.motion, method };
    } finally {
      this.#show(motion);
    }
  }

  // The same motions with another option of their retargeting: {inPlace} or {armSpread}.
  async retargetWith(option) {
    const { source } = this.#current();
    try {
      await this.open(source.motion.files, { ...source.motion, ...option });
    } finally {
      this.#show(this.player.motion);
    }
  }

  // pins: the user's word about the map of the file that plays, joint -> joint of the motion or -1.
  async usePins(pins) {
    const { source, joints } = this.#current();
    const named = Object.fromEntries([...pins].map(([joint, from]) => [joints[joint].name, from]));
    const { file } = this.player.fileOfClip;
    await this.open(source.motion.files, { ...source.motion, pins: { ...source.motion.pins, [file]: named } });
  }

  async #none() {
    await this.#engine.call("motion", { names: [] });
    this.#show(null);
    await at.springs.again();
  }

  #show(motion) {
    this.player.show(motion);
    this.#showClip();
    this.#changed(motion);
  }

  #showClip() {
    const character = this.#current();
    const { motion, clip, fileOfClip } = this.player;
    this.methods.show(motion, clip);
    this.clips.show(motion, clip, Boolean(character?.result));
    this.map.show(motion && { own: motion.own, ...fileOfClip }, character?.joints ?? [], motion?.pins[motion.clips[clip].file] ?? new Map());
  }
}
