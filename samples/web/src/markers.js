// SPDX-License-Identifier: MIT
// Markers: the user says where a part of the body is, and the skeleton is made anew from it, as by `sinew rig --at JOINT=X,Y,Z`. They are the
// character's source.markers: [{joint, place}], with the history and in its project.
import { $, at } from "./state.js";

const sides = ["Left", "Right"];
// Joints as sinew calls them. Of both sides first those of arms and legs.
const pairs = [["wrist", "Hand"], ["elbow", "ForeArm"], ["shoulder", "Arm"], ["ankle", "Foot"], ["knee", "Leg"], ["hip", "UpLeg"]];
const more = [["toes", "ToeBase"], ["ear", "Ear"], ["wing", "Wing"]];
const middle = [["Head", "Head"], ["Chin, neck", "Neck"], ["Middle of the hips", "Hips"]];
const ofSide = (list, side) => list.map(([part, joint]) => ({ joint: side + joint, words: `${side} ${part}` }));
const groups = {
  "Left": ofSide(pairs, "Left"),
  Middle: middle.map(([words, joint]) => ({ joint, words })),
  "Right": ofSide(pairs, "Right"),
  Others: [...sides.flatMap((side) => ofSide(more, side)), { joint: "Tail", words: "Tail" }],
};
const parts = Object.values(groups).flat();
export const partOf = (joint) => parts.find((part) => part.joint === joint)?.words ?? joint;

// With the marker of that joint there, in its old place in the list where it has one.
export function withMarker(markers, joint, place) {
  const known = markers.some((one) => one.joint === joint);
  return known ? markers.map((one) => (one.joint === joint ? { joint, place } : one)) : [...markers, { joint, place }];
}

// The part to mark next: the first after this one that has no marker. alike: those of the other side follow by themselves.
export function nextPart(markers, joint, alike) {
  const index = parts.findIndex((part) => part.joint === joint);
  const other = alike && /^(Left|Right)/.test(joint) ? (joint.startsWith("Left") ? "Right" : "Left") : null;
  const free = parts.slice(index + 1).find((part) => !markers.some((one) => one.joint === part.joint) && !(other && part.joint.startsWith(other)));
  return free?.joint ?? joint;
}

// What is shown of them: markers and, where both sides are alike, their images. mirror: {axis, plane} or null.
export function shownMarkers(markers, chosen, mirror) {
  const shown = markers.map(({ joint, place }) => ({ place, chosen: joint === chosen }));
  if (!mirror) return shown;
  const marked = new Set(markers.map(({ joint }) => joint));
  const otherSide = (joint) => joint.replace(/^(Left|Right)/, (side) => sides[1 - sides.indexOf(side)]);
  const images = markers.filter(({ joint }) => otherSide(joint) !== joint && !marked.has(otherSide(joint)));
  return [...shown, ...images.map(({ place }) => ({ place: place.map((x, i) => (i === mirror.axis ? 2 * mirror.plane - x : x)), image: true }))];
}

export class MarkerPanel {
  /** @type {(...of: any[]) => any} */
  onMark = () => {}; // joint, place
  /** @type {(...of: any[]) => any} */
  onRemove = () => {}; // joint
  /** @type {(...of: any[]) => any} */
  onClick = () => {}; // place
  /** @type {(...of: any[]) => any} */
  onRig = () => {};
  /** @type {(...of: any[]) => any} */
  onPlacing = () => {}; // whether a click on the mesh is a marker now; another part was chosen
  /** @type {any} */
  #markers = [];
  /** @type {any} */
  #character = null;

  constructor() {
    for (const [label, list] of Object.entries(groups)) {
      const group = Object.assign(document.createElement("optgroup"), { label });
      group.append(...list.map(({ joint, words }) => new Option(words, joint)));
      $("marker-part").append(group);
    }
    $("marker-part").onchange = () => this.#changed();
    $("marker-place").onclick = () => this.setPlacing(!this.placing);
    $("marker-here").onclick = () => this.onMark(this.part, this.#start());
    $("marker-rig").onclick = () => this.onRig();
    $("marking").ontoggle = () => $("marking").open || this.setPlacing(false);
    $("markers").onclick = ({ target }) => {
      const row = target.closest("li");
      if (!row) return;
      if (target.closest(".remove")) return this.onRemove(row.dataset.joint);
      this.choose(row.dataset.joint);
      $("marker-x").focus();
    };
    for (const axis of ["x", "y", "z"]) $(`marker-${axis}`).onchange = () => this.#typed();
  }

  get part() {
    return $("marker-part").value;
  }
  get placing() {
    return $("marker-place").ariaPressed === "true";
  }
  setPlacing(placing) {
    $("marker-place").ariaPressed = String(placing);
    this.onPlacing();
  }
  choose(joint) {
    $("marker-part").value = joint;
    this.#changed();
  }

  // character: that is open, with its source; or null.
  show(character) {
    this.#character = character;
    this.#markers = character?.source.markers ?? [];
    $("markers-count").textContent = this.#markers.length > 0 ? String(this.#markers.length) : "";
    $("markers").replaceChildren(...this.#markers.map(({ joint }) => this.#row(joint)));
    $("marker-rig").disabled = !character;
    this.#showPlace();
  }

  #row(joint) {
    const row = Object.assign(document.createElement("li"), {});
    row.dataset.joint = joint;
    const name = Object.assign(document.createElement("button"), { type: "button", className: "name", textContent: partOf(joint), ariaPressed: String(joint === this.part) });
    const remove = Object.assign(document.createElement("button"), { type: "button", className: "remove", textContent: "×", ariaLabel: `Remove the marker of ${partOf(joint)}` });
    row.append(name, remove);
    return row;
  }

  #changed() {
    this.show(this.#character);
    this.onPlacing();
  }

  // Where a marker begins without a pointer: at its joint, else in the middle of those that there are.
  #start() {
    const { joints } = this.#character;
    const found = joints.find(({ name }) => name === this.part);
    if (found) return [...found.position];
    return [0, 1, 2].map((i) => joints.reduce((sum, { position }) => sum + position[i], 0) / Math.max(1, joints.length));
  }

  #showPlace() {
    const marker = this.#markers.find(({ joint }) => joint === this.part);
    $("marker-where").hidden = !marker;
    ["x", "y", "z"].forEach((axis, i) => {
      $(`marker-${axis}`).value = marker ? Number(marker.place[i].toPrecision(4)) : "";
      $(`marker-${axis}`).step = this.#character ? String(Number((0.01 * this.#character.size).toPrecision(1))) : "any";
    });
    $("marker-here").disabled = !this.#character;
    $("marker-place").disabled = !this.#character;
  }

  #typed() {
    const marker = this.#markers.find(({ joint }) => joint === this.part);
    const place = ["x", "y", "z"].map((axis, i) => ($(`marker-${axis}`).value === String(Number(marker.place[i].toPrecision(4))) ? marker.place[i] : $(`marker-${axis}`).valueAsNumber));
    if (place.every(Number.isFinite)) this.onMark(this.part, place);
    else this.#showPlace();
  }
}

// Panel and picture, after any change.
export function showMarkers() {
  const { character, markers, view } = at;
  markers.show(character);
  const isEditing = view.editing && Boolean(character);
  const mirror = character?.mirrored && at.editor.alike ? character : null;
  view.setMarkers(isEditing ? shownMarkers(character.source.markers, markers.part, mirror) : []);
  view.onMark = isEditing && markers.placing && $("marking").open ? markers.onClick : null;
}
