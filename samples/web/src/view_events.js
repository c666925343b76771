// SPDX-License-Identifier: MIT
// What the picture tells the page of: each is a function of the page's.

export class ViewEvents {
  /** @type {(...of: any[]) => any} */
  onPickJoint = () => {};
  /** @type {(...of: any[]) => any} */
  onPickSurface = () => {}; // shown vertex
  /** @type {(...of: any[]) => any} */
  onTurn = () => {}; // joint, degrees x, y, z
  /** @type {(...of: any[]) => any} */
  onTurnEnd = () => {};
  /** @type {(...of: any[]) => any} */
  onDrag = () => {}; // joint, [x, y, z] where it is wanted now
  /** @type {(...of: any[]) => any} */
  onDragEnd = () => {};
  /** @type {(...of: any[]) => any} */
  onStrokeEnd = () => {};
  /** @type {any} */
  onGrab = null; // [x, y, z] and degrees about what is up by which the character is dragged, whether it has ended; null while it stays
  /** @type {any} */
  onMark = null; // [x, y, z] of a click on the mesh, while clicks are markers
  /** @type {(...of: any[]) => any} */
  onDragMarker = () => {}; // index, [x, y, z], whether it has ended
  /** @type {(...of: any[]) => any} */
  onDragOutline = () => {}; // {of, point} of outline_view.js, pixel, whether it has ended
}
