// SPDX-License-Identifier: MIT
// Markers are placed, dragged, taken away, and followed.
import { bind } from "./binding.js";
import { act } from "./acting.js";
import { predict } from "./editing.js";
import { MarkerPanel, nextPart, partOf, showMarkers, shownMarkers, withMarker } from "./markers.js";
import { $, at } from "./state.js";

/** @param {string} name @param {import("./types.js").Marker[]} markers */
function setMarkers(name, markers) {
  return act(name, () => {
    at.character.source.markers = markers;
    showMarkers();
  });
}

/** @param {string} joint @param {number[]} place */
function mark(joint, place) {
  return setMarkers(`mark ${partOf(joint)}`, withMarker(at.character.source.markers, joint, place));
}

// A click on the mesh: the chosen part is in the middle of what is there, and the next one is chosen.
/** @param {number[]} place */
function markAt(place) {
  const { part } = at.markers;
  mark(part, place);
  at.markers.choose(nextPart(withMarker(at.character.source.markers, part, place), part, at.editor.alike && at.character.mirrored));
}

/** @param {number} index @param {number[]} place @param {boolean} ended */
function dragMarker(index, place, ended) {
  const { markers } = at.character.source;
  const { joint } = markers[index];
  if (at.markers.part !== joint) at.markers.choose(joint);
  if (ended) return mark(joint, place);
  const mirror = at.character.mirrored && at.editor.alike ? at.character : null;
  at.view.setMarkers(shownMarkers(withMarker(markers, joint, place), joint, mirror));
}

export function listenForMarkers() {
  at.markers = new MarkerPanel();
  at.markers.onMark = mark;
  at.markers.onRemove = (joint) => setMarkers(`unmark ${partOf(joint)}`, at.character.source.markers.filter((one) => one.joint !== joint));
  at.markers.onClick = markAt;
  at.markers.onPlacing = showMarkers;
  at.markers.onRig = () => act("rig again", async () => (await predict(), await bind()));
  at.view.onDragMarker = dragMarker;
  $("alike").addEventListener("change", () => at.character && showMarkers());
}
