// SPDX-License-Identifier: MIT
// The picture: mesh with vertex colours, skeleton on top (bones.js), canvas and orbit camera (stage.js, framing.js), the rings that turn a joint (rings.js), a
// drawing with its outline (outline_view.js), and what the pointer does there (pointer.js).
import { Box3, Color, Group, SRGBColorSpace, Vector3 } from "three";
import { Bones } from "./bones.js";
import { colouredMesh, moveMesh, paintMesh, sweepMesh } from "./coloured_mesh.js";
import { boxOfClip, Framing, middleOfJoints, slanted } from "./framing.js";
import { Floor, Lighting } from "./lighting.js";
import { MarkerBalls } from "./marker_balls.js";
import { OutlineView } from "./outline_view.js";
import { pictureOfPart, pictureOfPoses } from "./small_pictures.js";
import { Pointer } from "./pointer.js";
import { Rings } from "./rings.js";
import { ContactSpots } from "./spots.js";
import { Stage } from "./stage.js";
import { ViewCube } from "./view_cube.js";
import { ViewEvents } from "./view_events.js";

const colourOf = ([r, g, b]) => new Color().setRGB(r / 255, g / 255, b / 255, SRGBColorSpace);
export class View extends ViewEvents {
  selected = -1;
  #also = new Set(); // joints that turn with the chosen one
  /** @type {any} */
  #look = null; // shown instead of the coloured mesh, see look.js
  /** @type {any} */
  #palette = null; // of the last pose
  /** @type {any} */
  #onStroke = null;
  toMiddle = true; // a dragged joint goes to the middle of the limb behind the pointer; with Alt the other way round
  #turnable = true; // whether the rings turn the chosen joint
  draggable = false; // whether joints can be dragged while the skeleton is edited
  /** @type {(...of: any[]) => any} */
  planeOf = () => null; // joint -> {axis, at} of the plane it stays on, or null

  #stage;
  #framing;
  #facing = 0; // see face()
  #rings;
  #model = new Group(); // turned when Z is up
  #pointer;
  #cube;
  #spots = new ContactSpots(this.#model);
  #markers = new MarkerBalls(this.#model);
  #bones = new Bones(this.#model, () => this.#framing.radius);
  #outline = new OutlineView(this.#model, () => this.redraw());
  #skeletonShown = true;
  #light;
  #floor;
  /** @type {any} */
  #mesh;
  #upAxis = 0;
  #joints = []; // [{parent, position}]
  #editing = false;
  #jointPositions = new Float32Array();
  #restBox = new Box3();

  constructor(host) {
    super();
    this.#stage = new Stage(host, () => this.#mesh && this.#cube.render(this.#stage.renderer));
    const { scene, camera, canvas, orbit, renderer } = this.#stage;
    scene.add(this.#model);
    this.#light = new Lighting({ scene, camera, renderer });
    this.#floor = new Floor(scene, () => this.#mesh && (this.#stand(this.#upAxis), this.redraw()));
    this.#framing = new Framing({ camera, orbit, room: () => this.#stage.covered });
    orbit.addEventListener("start", () => this.hold());
    const redraw = () => this.redraw();
    this.#rings = new Rings({ camera, canvas, scene, model: this.#model, orbit, redraw });
    this.#rings.onTurn = (...turn) => this.onTurn(...turn);
    this.#rings.onTurnEnd = (joint) => this.onTurnEnd(joint);
    this.#cube = new ViewCube({ camera, canvas, orbit, host, redraw: () => (this.hold(), this.redraw()) });
    this.#pointer = new Pointer(this, { host, canvas, camera, model: this.#model, mesh: () => this.#mesh });
    // As large as its room again, the picture shows what it did, where nobody has moved it.
    this.#stage.onResize = () => this.#mesh && this.#framing.untouched && (this.#outline.shown ? this.frame() : this.#framing.again());
    this.#stage.resize();
  }

  setCharacter({ triangles, positions, normals, joints, upAxis }) {
    this.select(-1);
    this.setLook(null);
    this.setSpots([]);
    this.#framing.startAt(null);
    this.#palette = null;
    const wireframe = this.wireframe;
    this.#mesh?.geometry.dispose();
    this.#mesh?.removeFromParent();
    this.#mesh = colouredMesh({ triangles, positions, normals, wireframe });
    this.#restBox = new Box3().copy(this.#mesh.geometry.boundingBox ?? new Box3());
    this.#model.add(this.#mesh);
    this.#stand(upAxis);
    this.setSkeleton(joints);
  }

  setUp(upAxis) {
    if (upAxis !== this.#upAxis) this.#stand(upAxis);
  }

  // upAxis 1: z, which the picture turns up; else y.
  #stand(upAxis) {
    this.#upAxis = upAxis;
    this.#cube.up = upAxis;
    this.#model.rotation.x = upAxis === 1 ? -Math.PI / 2 : 0;
    this.#model.updateMatrixWorld(true);
    if (!this.#outline.shown) this.frame();
    this.#floor.show(this.#framing, this.#mesh.geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld).min.y);
  }

  // areNew: else the same joints elsewhere.
  setSkeleton(joints, areNew = true) {
    if (areNew) this.select(-1);
    this.#joints = joints;
    this.#jointPositions = Float32Array.from(joints.flatMap((j) => j.position));
    if (areNew) this.#rings.make(joints);
    else this.#rings.place(joints);
    if (areNew) this.#bones.make(joints, this.#jointPositions);
    else this.#bones.place(this.#jointPositions);
    this.redraw();
  }
  moveSkeleton(joints) {
    this.setSkeleton(joints, false);
  }

  // colours: [[r, g, b]], 0 to 255, or null.
  setJointColours(colours) {
    this.#bones.paint({ colours: colours?.map(colourOf) ?? null });
    this.redraw();
  }

  // Joints of limbs that may be wrong are red, whatever else colours them.
  setDoubts(joints) {
    this.#bones.paint({ doubts: new Set(joints) });
    this.redraw();
  }

  // How much of the skeleton has grown, and how much of the mesh has its colors: shares of 1.
  setRevealed(grown, swept) {
    this.#bones.grown = grown;
    sweepMesh(this.#mesh, swept, this.#upAxis === 1 ? 2 : 1);
    this.redraw();
  }

  // While a skeleton is edited joints are dragged and nothing is turned.
  get editing() {
    return this.#editing;
  }
  set editing(editing) {
    this.#editing = editing;
    this.select(this.selected);
  }
  set turnable(turnable) {
    if (turnable === this.#turnable) return;
    this.#turnable = turnable;
    this.select(this.selected);
  }
  get dragging() {
    return this.#pointer.dragging;
  }

  setColours(srgb) {
    paintMesh(this.#mesh, srgb);
    this.redraw();
  }

  // turns: degrees of all joints, which the rings follow. Without positions the mesh stays, and the look of the file alone moves. moves: a motion plays, and the camera goes along with it over the floor, but not by what it is dragged.
  setPose(positions, normals, jointPositions, turns, palette, moves = false, dragged = [0, 0, 0]) {
    this.#palette = palette;
    this.#look?.pose(palette);
    if (positions) moveMesh(this.#mesh, positions, normals);
    this.#jointPositions = jointPositions;
    this.#rings.turn(turns);
    this.#bones.place(this.#jointPositions);
    this.#framing.goAlong(middleOfJoints(jointPositions).sub(new Vector3(...dragged)).applyMatrix4(this.#model.matrixWorld), moves);
    this.redraw();
  }

  // Contacts of a motion's frame, see spots.js.
  setSpots(spots) {
    this.#spots.show(spots, this.#framing.radius);
    this.redraw();
  }

  // See marker_balls.js.
  setMarkers(markers) {
    this.#markers.show(markers, this.#framing.radius);
    this.redraw();
  }
  get markers() {
    return this.#markers.handles;
  }

  // A drawing with its outline in place of the character, see outline_view.js; null: none.
  // from: where it is looked at from without one. The same drawing stays where it is in the picture, whatever was made of it.
  setDrawing(drawing, from = slanted) {
    if (!drawing && !this.#outline.shown) return;
    const isSame = drawing && drawing.file === this.#outline.file;
    if (isSame) this.#framing.move(this.#outline.movesTo(drawing.lies));
    this.#outline.show(drawing);
    this.#stage.flat = Boolean(drawing); // a drag beside the points moves the paper
    if (!isSame) this.frame(from);
    this.#showParts();
  }
  // The outline of that drawing while it is dragged.
  setOutline(outline) {
    this.#outline.setOutline(outline);
    this.redraw();
  }
  get drawingShown() {
    return this.#outline.shown;
  }
  get outlineHandles() {
    return this.#outline.shown ? this.#outline.handles : [];
  }
  choosePoint(index) {
    this.#outline.choose(index);
    this.redraw();
  }
  pixelAt = (place) => this.#outline.toPixel(place);

  // What of the character is shown: its file's look or the coloured mesh, with bones, or its drawing alone.
  #showParts() {
    const drawn = this.#outline.shown;
    if (this.#mesh) this.#mesh.visible = !this.#look && !drawn;
    if (this.#look) this.#look.root.visible = !drawn;
    this.#spots.visible = !drawn;
    this.#bones.shown = this.#skeletonShown && !drawn;
    this.select(this.selected);
  }

  // The character as its file shows it, a Look; null: with the colours of weights again.
  setLook(look) {
    this.#look?.dispose();
    this.#look = look;
    this.#light.show(look);
    if (look) {
      this.#model.add(look.root);
      if (this.#palette) look.pose(this.#palette);
    }
    this.#showParts();
  }
  get look() {
    return this.#look;
  }

  get wireframe() {
    return this.#mesh?.material.wireframe ?? false;
  }
  set wireframe(shown) {
    if (this.#mesh) this.#mesh.material.wireframe = shown;
    this.redraw();
  }

  // Called with the shown vertex that the brush is on; null while there is no brush. Rings would take its strokes.
  get onStroke() {
    return this.#onStroke;
  }
  set onStroke(stroke) {
    const isNew = Boolean(stroke) !== Boolean(this.#onStroke);
    this.#onStroke = stroke;
    if (isNew) this.select(this.selected);
  }

  get boneSize() {
    return this.#bones.thickness;
  }
  set boneSize(size) {
    this.#bones.thickness = size;
    this.redraw();
  }

  // Joints that are chosen beside `selected`.
  get also() {
    return this.#also;
  }
  set also(joints) {
    this.#also = new Set(joints);
    this.#bones.paint({ chosen: this.selected, also: this.#also });
    this.redraw();
  }

  select(joint) {
    if (joint !== this.selected) this.#also = new Set();
    this.selected = joint;
    this.#rings.show(this.#editing || !this.#turnable || this.#onStroke || this.#outline.shown ? -1 : joint);
    this.#bones.paint({ chosen: this.selected, also: this.#also });
    this.redraw();
  }

  get skeletonShown() {
    return this.#skeletonShown;
  }
  set skeletonShown(shown) {
    this.#skeletonShown = shown;
    this.#showParts();
  }

  // Which way the character faces, radians from the picture's +z to its +x: it is looked at from there.
  face(angle) {
    if (angle === this.#facing) return;
    this.#facing = angle;
    if (this.#mesh && this.#framing.untouched && !this.#outline.shown) this.frame();
  }

  // A direction before the character's front as one in the picture's axes.
  /** @param {number[]} direction @returns {number[]} */
  #before([right, up, ahead]) {
    const [sin, cos] = [Math.sin(this.#facing), Math.cos(this.#facing)];
    return [right * cos + ahead * sin, up, ahead * cos - right * sin];
  }

  // Brings the character, as it is posed now, into view.
  // from: the direction that the camera is in: to the right of who looks at its front, up, ahead of it.
  frame(from = slanted) {
    if (this.#outline.shown) {
      this.#framing.startAt(null);
      return this.#frameBox(new Box3().setFromArray(this.#outline.handles.flatMap(({ place }) => place)), [0, 0, 1]);
    }
    this.#mesh.geometry.computeBoundingBox();
    this.#frameBox(this.#mesh.geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld), this.#before(from));
  }

  // Where nobody moved the camera, with the room that the present step's buttons leave.
  frameAgain() {
    if (this.#mesh && this.#framing.untouched && !this.#outline.shown) this.#framing.again();
    this.redraw();
  }

  #frameBox(box, from) {
    this.#framing.frame(box, from);
    this.redraw();
  }

  // Brings all of a clip into view, see boxOfClip().
  frameClip(room, upAxis) {
    const { box, middle } = boxOfClip(room, upAxis === 1 ? 2 : 1, Float32Array.from(this.#joints.flatMap(({ position }) => position)), this.#restBox);
    this.#framing.startAt(middle.applyMatrix4(this.#model.matrixWorld));
    this.#frameBox(box.applyMatrix4(this.#model.matrixWorld), this.#before(slanted));
  }

  redraw() {
    this.#stage.redraw();
  }

  // Where a joint, and any point of the model, is on the page.
  jointOnScreen = (joint) => this.onScreen(this.jointPosition(joint));
  onScreen = (point) => this.#stage.onScreen(new Vector3(...point).applyMatrix4(this.#model.matrixWorld));

  // Brings a joint into the middle, nearer where the whole character was in view.
  lookAtJoints(joints) {
    const box = new Box3();
    for (const joint of joints) box.expandByPoint(new Vector3().fromArray(this.#jointPositions, joint * 3));
    box.expandByScalar(0.08 * this.#restBox.getSize(new Vector3()).length());
    this.#frameBox(box.applyMatrix4(this.#model.matrixWorld), this.#before(slanted));
    this.hold();
  }

  jointPosition = (joint) => [...this.#jointPositions.subarray(joint * 3, joint * 3 + 3)];
  // The ends of a bone on the page, of a root its own place twice.
  boneOnScreen(joint) {
    const { parent } = this.#joints[joint];
    return [this.jointOnScreen(joint), this.jointOnScreen(parent < 0 ? joint : parent)];
  }
  get jointCount() {
    return this.#joints.length;
  }

  // While the pointer has something else to do no drag orbits.
  set orbiting(orbiting) {
    this.#stage.orbit.enabled = orbiting;
  }
  // The picture stays as it is, whatever the window does.
  hold() {
    this.#framing.untouched = false;
  }
  get onRing() {
    return this.#rings.underPointer;
  }

  // Where a joint would be in the middle of what is behind it, as the picture stands; where it is if nothing is there.
  middleOf(joint) {
    const { x, y } = this.jointOnScreen(joint);
    const from = this.jointPosition(joint);
    return this.#pointer.place(from, x, y, { plane: this.planeOf(joint), toMiddle: true });
  }

  // A picture of a part at rest, orange on the rest: the address of a PNG. members: see Questions; vertexOf: of shown vertices; null where there is none.
  pictureOf(members, vertexOf) {
    const { renderer, scene } = this.#stage;
    const url = pictureOfPart({ renderer, scene, model: this.#model, from: this.#before(slanted), mesh: this.#mesh, radius: this.#framing.radius }, members, vertexOf);
    this.redraw();
    return url;
  }

  // A strip of small pictures of the file's look in poses. poses: [{palette, jointPositions}].
  pictureOfPoses(poses) {
    const { renderer, scene } = this.#stage, look = this.#look;
    const url = pictureOfPoses({ renderer, scene, model: this.#model, from: this.#before(slanted), shown: look.root, box: this.#restBox }, poses.map(({ palette, jointPositions }) => ({ pose: () => look.pose(palette), middle: middleOfJoints(jointPositions) })));
    if (this.#palette) look.pose(this.#palette);
    this.redraw();
    return url;
  }

  // The address of a small picture of what is shown.
  thumbnail = () => this.#stage.thumbnail();

  // For tests: joints, positions, colours or spots as they are shown.
  shown(what) {
    if (what === "joints") return Array.from(this.#jointPositions);
    if (what === "spots") return this.#spots.shown;
    return Array.from(this.#mesh.geometry.getAttribute(what === "colours" ? "color" : "position").array);
  }
  // And how far the rings' own skeleton is from where the engine has the joints, in sizes of the character.
  largestHandleDistance() {
    return this.#rings.largestDistance(this.#jointPositions) / this.#framing.radius;
  }
}
