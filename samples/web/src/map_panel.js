// SPDX-License-Identifier: MIT
// The table of which joint moves as which joint of a motion. What the user says stays, and the rest is mapped again around it.
import { $ } from "./elements.js";

const found = "found"; // the option that takes the user's word back

// pins: a Map, joint -> joint of the motion or -1; with this word, and without others that gave the same joint away.
export function pinned(pins, joint, source) {
  const others = [...pins].filter(([one, other]) => one !== joint && (source < 0 || other !== source));
  return new Map([...others, [joint, source]]);
}
export function unpinned(pins, joint) {
  return new Map([...pins].filter(([one]) => one !== joint));
}

export class MapPanel {
  /** @type {(...of: any[]) => any} */
  onPins = () => {}; // Map
  /** @type {(...of: any[]) => any} */
  onPick = () => {}; // joint
  /** @type {any} */
  #motion = null;
  #joints = [];
  #pins = new Map();

  constructor() {
    $("map").ontoggle = () => this.#fill();
    const rows = $("map-rows");
    rows.onclick = ({ target }) => {
      const button = target.closest("button");
      if (button) this.onPick(Number(button.parentElement.parentElement.dataset.joint));
    };
    // A select has its options when it is looked at: a table of long lists would be slow.
    for (const event of ["pointerdown", "focusin"]) rows.addEventListener(event, ({ target }) => target.tagName === "SELECT" && this.#fillOptions(target));
    rows.onchange = ({ target }) => {
      const joint = Number(target.closest("tr").dataset.joint);
      this.onPins(target.value === found ? unpinned(this.#pins, joint) : pinned(this.#pins, joint, Number(target.value)));
    };
    $("map-forget").onclick = () => this.onPins(new Map());
  }

  // motion: as MotionPlayer has it, or null; joints: the character's.
  show(motion, joints, pins) {
    this.#motion = motion;
    this.#joints = joints;
    this.#pins = pins;
    $("map").hidden = !motion || motion.own;
    if (!motion) return;
    $("map-count").textContent = `${motion.mapped} of ${joints.length} bones${pins.size ? `, ${pins.size} by you` : ""}`;
    $("map-forget").disabled = pins.size === 0;
    this.#fill();
  }

  #fill() {
    if (!$("map").open || !this.#motion) return;
    const focused = /** @type {any} */ (document.activeElement)?.closest("#map-rows tr")?.dataset.joint;
    const rows = this.#joints.map(({ name }, j) => this.#row(name, j));
    $("map-rows").replaceChildren(...rows);
    if (focused !== undefined) rows[Number(focused)]?.querySelector("select")?.focus();
  }

  #row(name, joint) {
    const { source, why } = this.#motion.map[joint];
    const tr = document.createElement("tr");
    tr.dataset.joint = joint;
    tr.classList.toggle("pinned", this.#pins.has(joint));
    tr.classList.toggle("none", source < 0);
    const head = document.createElement("th");
    head.scope = "row";
    head.append(Object.assign(document.createElement("button"), { type: "button", textContent: name, title: `Choose ${name}` }));
    const select = document.createElement("select");
    select.setAttribute("aria-label", `${name} follows`);
    select.title = this.#pins.has(joint) ? "You chose this" : why;
    select.append(new Option(source < 0 ? "none" : this.#motion.sourceJoints[source].name, String(source), true, true));
    const cell = document.createElement("td");
    cell.append(select);
    tr.append(head, cell);
    return tr;
  }

  #fillOptions(select) {
    if (select.options.length > 1) return;
    const joint = Number(select.closest("tr").dataset.joint);
    const { value } = select;
    const options = this.#motion.sourceJoints.map(({ name, end }, j) => Object.assign(new Option(name, String(j)), { hidden: end && String(j) !== value }));
    select.replaceChildren(...(this.#pins.has(joint) ? [new Option("Automatic", found)] : []), new Option("none", "-1"), ...options);
    select.value = value;
  }
}
