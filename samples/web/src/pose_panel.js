// SPDX-License-Identifier: MIT
// The panel that turns the chosen joint by sliders, with those that turn along: others that were chosen, and mirror images.
import { $ } from "./elements.js";

const axes = ["x", "y", "z"];

// The joint on the other side, by the skeleton's mirror or by its name; -1 for none.
const otherSide = ({ partner, named }) => (partner >= 0 ? partner : named);

// [[joint, [x, y, z]]]: those of `joints` at the same turn, and where both sides are mirrored their partners at the other way round.
export function turnsOf(skeleton, joints, turn, mirrored, axis = 0) {
  const turns = joints.map((joint) => [joint, turn]);
  if (!mirrored) return turns;
  const image = turn.map((degrees, i) => (i === axis ? degrees : -degrees)); // turns about the other axes change their sign
  const others = joints.map((joint) => otherSide(skeleton[joint])).filter((other) => other >= 0 && !joints.includes(other));
  return [...turns, ...others.map((other) => [other, image])];
}

export class PosePanel {
  /** @type {(...of: any[]) => any} */
  onChange = () => {};
  /** @type {(...of: any[]) => any} */
  onStep = () => {}; // the name of what was done, and whether it goes on
  /** @type {any} */
  #character = null;
  /** @type {any} */
  #pose = null;
  #joint = -1;
  #also = new Set();

  constructor() {
    axes.forEach((name, axis) => {
      const slider = $(`turn-${name}`);
      slider.oninput = () => this.#turnAbout(axis, Number(slider.value));
      slider.onchange = () => this.onStep(`rotate ${this.#name}`, true); // all of one drag is one step
      slider.ondblclick = () => {
        this.#turnAbout(axis, 0);
        this.onStep(`rotate ${this.#name}`);
      };
    });
    $("reset").onclick = () => this.reset();
    $("reset-joint").onclick = () => {
      this.turn(this.#joint, [0, 0, 0]);
      this.onStep(`reset ${this.#name}`);
    };
  }

  // joint: the chosen one or -1, also: a Set of those beside it.
  show(character, pose, joint, also) {
    this.#character = character;
    this.#pose = pose;
    this.#joint = joint;
    this.#also = joint < 0 ? new Set() : also;
    const turn = joint < 0 ? null : pose.of(joint);
    $("joint-name").textContent = turn ? `${character.joints[joint].name}${this.#also.size ? ` and ${this.#also.size} more` : ""}` : "No bone selected";
    axes.forEach((name, axis) => {
      const slider = $(`turn-${name}`);
      slider.disabled = !turn;
      slider.value = turn?.[axis] ?? 0;
      slider.nextElementSibling.textContent = turn ? `${Math.round(turn[axis])}°` : "";
    });
    $("reset").disabled = !pose || pose.isRest;
    $("reset-joint").disabled = !turn || turn.every((degrees) => degrees === 0);
  }

  // Turns the joint and what turns along.
  turn(joint, turn) {
    const { joints, axis } = this.#character;
    for (const [j, degrees] of turnsOf(joints, [joint, ...this.#also], turn, $("mirror-pose").checked, axis)) this.#pose.set(j, ...degrees);
    this.onChange();
  }

  reset() {
    if (!this.#pose || this.#pose.isRest) return;
    this.#pose.reset();
    this.onChange();
    this.onStep("reset pose");
  }

  get #name() {
    return this.#character.joints[this.#joint].name;
  }

  #turnAbout(axis, degrees) {
    const turn = [...this.#pose.of(this.#joint)];
    turn[axis] = degrees;
    this.turn(this.#joint, turn);
  }
}
