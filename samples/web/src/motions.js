// SPDX-License-Identifier: MIT
// The motion that a character plays: opened by the module, by the method and the map that the user has chosen, and retargeted again when the
// character has changed. What was chosen stays with the character (its source.motion) while its tab is open.
import { MapPanel } from "./map_panel.js";
import { MethodPanel, motionMethods } from "./methods.js";
import { MotionPlayer } from "./player.js";

export class Motions {
  player = new MotionPlayer();
  methods = new MethodPanel();
  map = new MapPanel();
  #engine;
  #current;
  #changed;

  // current: () => the character that is open, or null; changed: called when a motion is there or gone.
  constructor(engine, current, changed) {
    this.#engine = engine;
    this.#current = current;
    this.#changed = changed;
    this.player.onClip = () => this.#showMethod();
  }

  // A file that the module has: its clips play on the character from now on. method: MotionMethod; pins: of the map, {joint's name:
  // joint of the motion or -1}
  async open(name, { method = motionMethods.contacts, pins = {} } = {}) {
    const character = this.#current();
    if (!character?.result) throw new Error(`${name}: is a motion; open a character first`);
    const { source, joints, up } = character;
    const own = name === source.mesh;
    const known = new Map(joints.flatMap((joint, j) => (joint.name in pins ? [[j, pins[joint.name]]] : [])));
    this.player.wait(name);
    try {
      const motion = await this.#engine.call("motion", { name, wish: { up, own, method, pins: [...known] } });
      source.motion = { name, method, pins };
      this.#show({ name, own, method, pins: known, ...motion });
    } catch (error) {
      this.#show(this.player.motion); // the one before
      throw error;
    }
  }

  async close() {
    this.#current().source.motion = null;
    await this.again();
  }

  // The motion again, for a character that was bound or whose skeleton was changed; none where it has none.
  async again() {
    const { source } = this.#current();
    if (!source.motion) return this.#none();
    try {
      await this.open(source.motion.name, source.motion);
    } catch (error) {
      source.motion = null;
      await this.#none();
      throw error;
    }
  }

  // The same motion by another method, at the same place of it.
  async useMethod(method) {
    const { motion } = this.player;
    if (!motion) return;
    this.player.wait(motion.name);
    try {
      Object.assign(motion, await this.#engine.call("motionMethod", { method }), { method });
      this.#current().source.motion.method = method;
    } finally {
      this.#show(motion);
    }
  }

  // pins: the user's word about the map, joint -> joint of the motion or -1.
  async usePins(pins) {
    const { source, joints } = this.#current();
    const named = Object.fromEntries([...pins].map(([joint, from]) => [joints[joint].name, from]));
    await this.open(source.motion.name, { ...source.motion, pins: named });
  }

  async #none() {
    await this.#engine.call("motion", { name: "" });
    this.#show(null);
  }

  #show(motion) {
    const character = this.#current();
    this.player.show(motion, Boolean(character?.result));
    this.#showMethod();
    this.map.show(motion, character?.joints ?? [], motion?.pins ?? new Map());
    this.#changed(motion);
  }

  #showMethod() {
    this.methods.show(this.player.motion, this.player.clip);
  }
}
