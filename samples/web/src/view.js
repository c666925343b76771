// SPDX-License-Identifier: MIT
// The picture: mesh with vertex colours, skeleton on top (bones.js), orbit camera, the rings that turn a joint, and what the pointer does there
// (pointer.js). Draws only when something changed.
import {
  Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, GridHelper, Group, HemisphereLight, MathUtils, Mesh,
  MeshStandardMaterial, NeutralToneMapping, NoToneMapping, Object3D, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderTarget, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import { Bones } from "./bones.js";
import { MarkerBalls } from "./marker_balls.js";
import { Pointer } from "./pointer.js";
import { moved } from "./rays.js";
import { ContactSpots } from "./spots.js";
import { ViewCube } from "./view_cube.js";

const colourOf = ([r, g, b]) => new Color().setRGB(r / 255, g / 255, b / 255, SRGBColorSpace);
const toLinear = Float32Array.from({ length: 256 }, (_, i) => {
  const x = i / 255;
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
});

// The address of a picture whose rows go upwards, as WebGL reads them.
function addressOf(pixels, width, height) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const upright = new ImageData(width, height);
  for (let y = 0; y < height; ++y) upright.data.set(pixels.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
  canvas.getContext("2d").putImageData(upright, 0, 0);
  return canvas.toDataURL();
}

const isLight = matchMedia("(prefers-color-scheme: light)");

export class View {
  onPickJoint = () => {};
  onPickSurface = () => {}; // shown vertex
  onTurn = () => {}; // joint, degrees x, y, z
  onTurnEnd = () => {};
  onDrag = () => {}; // joint, [x, y, z] where it is wanted now
  onDragEnd = () => {};
  onStrokeEnd = () => {};
  onMark = null; // [x, y, z] of a click on the mesh, while clicks are markers
  onDragMarker = () => {}; // index, [x, y, z], whether it has ended
  selected = -1;
  #also = new Set(); // joints that turn with the chosen one
  #look = null; // shown instead of the coloured mesh, see look.js
  #palette = null; // of the last pose
  #onStroke = null;
  toMiddle = true; // a dragged joint goes to the middle of the limb behind the pointer; with Alt the other way round
  #turnable = true; // whether the rings turn the chosen joint
  draggable = false; // whether joints can be dragged while the skeleton is edited
  planeOf = () => null; // joint -> {axis, at} of the plane it stays on, or null

  #host;
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera(35, 1, 0.01, 100);
  #orbit;
  #gizmo;
  #model = new Group(); // turned when Z is up
  #pointer;
  #cube;
  #spots = new ContactSpots(this.#model);
  #markers = new MarkerBalls(this.#model);
  #bones = new Bones(this.#model, () => this.#radius);
  #light = new DirectionalLight(0xffffff, 1.7);
  #sky = new HemisphereLight(0xffffff, 0x8b93a3, 1.9);
  #mesh;
  #grid;
  #upAxis = 0;
  #joints = []; // [{parent, position}]
  #editing = false;
  #handles = []; // Object3D per joint, a skeleton of their own that the rings turn
  #jointPositions = new Float32Array();
  #radius = 1;
  #restBox = new Box3();
  #centre = new Vector3();
  #middle = null; // of the joints in a motion's last frame
  #stale = false;
  #untouched = true; // the camera stands where frame() put it

  constructor(host) {
    this.#host = host;
    this.#renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.domElement.setAttribute("aria-label", "The character. Drag to orbit, click to choose a joint.");
    host.prepend(this.#renderer.domElement);
    this.#scene.add(this.#sky, this.#camera, this.#model);
    this.#camera.add(this.#light);
    this.#light.position.set(0.6, 0.9, 0.7);
    this.#orbit = new OrbitControls(this.#camera, this.#renderer.domElement);
    this.#orbit.enableDamping = false;
    this.#orbit.addEventListener("change", () => this.redraw());
    this.#orbit.addEventListener("start", () => (this.#untouched = false));
    this.#gizmo = new TransformControls(this.#camera, this.#renderer.domElement);
    this.#gizmo.setMode("rotate");
    this.#gizmo.setSpace("local");
    this.#gizmo.setSize(0.75);
    this.#gizmo.showXYZE = false; // a ball that would take the clicks on other joints and the drags that orbit
    this.#gizmo.addEventListener("change", () => this.redraw());
    this.#gizmo.addEventListener("dragging-changed", ({ value }) => {
      this.#orbit.enabled = !value;
      if (!value) this.onTurnEnd(this.selected);
    });
    this.#gizmo.addEventListener("objectChange", () => {
      const { x, y, z } = this.#handles[this.selected].rotation;
      this.onTurn(this.selected, x * MathUtils.RAD2DEG, y * MathUtils.RAD2DEG, z * MathUtils.RAD2DEG);
    });
    this.#scene.add(this.#gizmo.getHelper());
    const canvas = this.#renderer.domElement;
    this.#cube = new ViewCube({ camera: this.#camera, canvas, orbit: this.#orbit, host, redraw: () => ((this.#untouched = false), this.redraw()) });
    this.#pointer = new Pointer(this, { host, canvas, camera: this.#camera, model: this.#model, mesh: () => this.#mesh });
    isLight.addEventListener("change", () => this.#mesh && (this.#stand(this.#upAxis), this.redraw()));
    new ResizeObserver(() => this.#resize()).observe(host);
    this.#resize();
  }

  setCharacter({ triangles, positions, normals, joints, upAxis }) {
    this.select(-1);
    this.setLook(null);
    this.setSpots([]);
    this.#middle = null;
    this.#palette = null;
    const wireframe = this.wireframe;
    this.#mesh?.geometry.dispose();
    this.#mesh?.removeFromParent();
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(triangles, 1));
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(positions.length).fill(0.35), 3));
    this.#mesh = new Mesh(geometry, new MeshStandardMaterial({ vertexColors: true, wireframe, roughness: 0.82, metalness: 0, side: DoubleSide }));
    geometry.computeBoundingBox();
    this.#restBox = geometry.boundingBox.clone();
    this.#mesh.frustumCulled = false; // poses leave the rest pose's bounds
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
    this.frame();
    this.#makeGrid(this.#mesh.geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld));
  }

  setSkeleton(joints) {
    this.select(-1);
    this.#joints = joints;
    this.#jointPositions = Float32Array.from(joints.flatMap((j) => j.position));
    this.#makeHandles();
    this.#bones.make(joints, this.#jointPositions);
    this.redraw();
  }

  // The same joints elsewhere.
  moveSkeleton(joints) {
    this.#joints = joints;
    this.#jointPositions = Float32Array.from(joints.flatMap((j) => j.position));
    this.#placeHandles();
    this.#bones.place(this.#jointPositions);
    this.redraw();
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
    const colours = this.#mesh.geometry.getAttribute("color");
    for (let i = 0; i < srgb.length; ++i) colours.array[i] = toLinear[srgb[i]];
    colours.needsUpdate = true;
    this.redraw();
  }

  // turns: degrees of all joints, which the rings follow. Without positions the mesh stays, and the look of the file alone moves. moves: a motion plays, and the camera goes along with it over the floor.
  setPose(positions, normals, jointPositions, turns, palette, moves = false) {
    this.#palette = palette;
    this.#look?.pose(palette);
    if (positions) this.#moveMesh(positions, normals);
    this.#jointPositions = jointPositions;
    this.#handles.forEach((handle, j) => {
      if (this.#gizmo.dragging && j === this.selected) return;
      handle.rotation.set(...[0, 1, 2].map((axis) => turns[j * 3 + axis] * MathUtils.DEG2RAD));
    });
    this.#bones.place(this.#jointPositions);
    this.#goAlong(moves);
    this.redraw();
  }

  #moveMesh(positions, normals) {
    const { geometry } = this.#mesh;
    geometry.getAttribute("position").copyArray(positions).needsUpdate = true;
    geometry.getAttribute("normal").copyArray(normals).needsUpdate = true;
    geometry.boundingSphere = null;
    moved(geometry);
  }

  // Contacts of a motion's frame, see spots.js.
  setSpots(spots) {
    this.#spots.show(spots, this.#radius);
    this.redraw();
  }

  // See marker_balls.js.
  setMarkers(markers) {
    this.#markers.show(markers, this.#radius);
    this.redraw();
  }
  get markers() {
    return this.#markers.handles;
  }

  // The character as its file shows it, a Look; null: with the colours of weights again.
  setLook(look) {
    this.#look?.dispose();
    this.#look = look;
    this.#scene.environment = look?.room(this.#renderer) ?? null;
    // Materials are lit by the room, and bright ones keep their colours; what shows weights is lit evenly.
    this.#renderer.toneMapping = look ? NeutralToneMapping : NoToneMapping;
    this.#sky.intensity = look ? 0 : 1.9;
    this.#light.intensity = look ? 0.7 : 1.7;
    this.#scene.environmentIntensity = 0.55;
    if (look) {
      this.#model.add(look.root);
      if (this.#palette) look.pose(this.#palette);
    }
    if (this.#mesh) this.#mesh.visible = !look;
    this.redraw();
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
    if (joint < 0 || this.#editing || !this.#turnable || this.#onStroke) this.#gizmo.detach();
    else this.#gizmo.attach(this.#handles[joint]);
    this.#bones.paint({ chosen: this.selected, also: this.#also });
    this.redraw();
  }

  get skeletonShown() {
    return this.#bones.shown;
  }
  set skeletonShown(shown) {
    this.#bones.shown = shown;
    this.redraw();
  }

  // Brings the character, as it is posed now, into view.
  // from: the direction that the camera is in, in the picture's axes.
  frame(from = [0.42, 0.22, 1]) {
    this.#mesh.geometry.computeBoundingBox();
    this.#frameBox(this.#mesh.geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld), from);
  }

  #frameBox(box, from) {
    box.getCenter(this.#centre);
    this.#radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-6);
    const direction = new Vector3(...from).normalize();
    const fit = this.#radius / Math.sin((this.#camera.fov * MathUtils.DEG2RAD) / 2) / Math.min(1, this.#camera.aspect);
    this.#camera.near = this.#radius / 200;
    this.#camera.far = this.#radius * 200;
    this.#camera.updateProjectionMatrix();
    this.#camera.position.copy(this.#centre).addScaledVector(direction, fit * 0.97);
    this.#orbit.target.copy(this.#centre);
    this.#orbit.minDistance = this.#radius / 20;
    this.#orbit.maxDistance = this.#radius * 30;
    this.#orbit.update();
    this.#untouched = true;
    this.redraw();
  }

  // Brings all of a clip into view. room: of the module, what the joints take up; the camera goes along with them over the floor.
  frameClip({ is, around }, upAxis) {
    const up = upAxis === 1 ? 2 : 1;
    const middle = new Vector3(), at = new Vector3();
    for (let j = 0; j < this.#joints.length; ++j) middle.addScaledVector(at.fromArray(this.#joints[j].position), 1 / Math.max(1, this.#joints.length));
    const rest = new Box3().setFromArray(this.#joints.flatMap(({ position }) => position));
    const mesh = this.#restBox;
    const box = new Box3();
    [0, 1, 2].forEach((i) => {
      const [least, most] = i === up ? is[i] : around[i].map((x) => x + middle.getComponent(i));
      // The mesh reaches beyond its joints, at rest and in motion.
      box.min.setComponent(i, least - Math.max(0, rest.min.getComponent(i) - mesh.min.getComponent(i)));
      box.max.setComponent(i, most + Math.max(0, mesh.max.getComponent(i) - rest.max.getComponent(i)));
    });
    this.#middle = middle.clone().applyMatrix4(this.#model.matrixWorld);
    this.#frameBox(box.applyMatrix4(this.#model.matrixWorld), [0.42, 0.22, 1]);
  }

  redraw() {
    if (this.#stale) return;
    this.#stale = true;
    requestAnimationFrame(() => {
      this.#stale = false;
      this.#draw();
    });
  }

  #draw() {
    this.#renderer.render(this.#scene, this.#camera);
    if (this.#mesh) this.#cube.render(this.#renderer);
  }

  // Where a joint is on the page.
  jointOnScreen(joint) {
    return this.onScreen(this.jointPosition(joint));
  }
  // Where a point of the model is on the page.
  onScreen(point) {
    this.#camera.updateMatrixWorld(); // the picture may be a frame behind
    const at = new Vector3(...point).applyMatrix4(this.#model.matrixWorld).project(this.#camera);
    const box = this.#renderer.domElement.getBoundingClientRect();
    return { x: box.left + ((at.x + 1) / 2) * box.width, y: box.top + ((1 - at.y) / 2) * box.height, behind: at.z > 1 };
  }

  // Brings a joint into the middle, nearer where the whole character was in view.
  lookAtJoints(joints) {
    const box = new Box3();
    for (const joint of joints) box.expandByPoint(new Vector3().fromArray(this.#jointPositions, joint * 3));
    box.expandByScalar(0.08 * this.#restBox.getSize(new Vector3()).length());
    this.#frameBox(box.applyMatrix4(this.#model.matrixWorld), [0.42, 0.22, 1]);
    this.#untouched = false;
  }

  jointPosition(joint) {
    return [...this.#jointPositions.subarray(joint * 3, joint * 3 + 3)];
  }
  get jointCount() {
    return this.#joints.length;
  }

  // While the pointer has something else to do no drag orbits.
  set orbiting(orbiting) {
    this.#orbit.enabled = orbiting;
  }
  // The picture stays as it is, whatever the window does.
  hold() {
    this.#untouched = false;
  }
  get onRing() {
    return this.#gizmo.axis !== null;
  }

  // Where a joint would be in the middle of what is behind it, as the picture stands; where it is if nothing is there.
  middleOf(joint) {
    const { x, y } = this.jointOnScreen(joint);
    const from = this.jointPosition(joint);
    return this.#pointer.place(joint, from, x, y, true);
  }

  // A picture of a part at rest, orange on the rest: the address of a PNG. members: see Questions; vertexOf: of shown vertices; null where there is none.
  pictureOf(members, vertexOf) {
    const size = [144, 108];
    const { geometry } = this.#mesh;
    const [rest, colours] = [geometry.getAttribute("position"), geometry.getAttribute("color")];
    const box = new Box3(), at = new Vector3();
    const before = colours.array.slice();
    for (let i = 0; i < vertexOf.length; ++i) {
      const isPart = members?.of[vertexOf[i]] === members?.number;
      if (isPart) box.expandByPoint(at.fromBufferAttribute(rest, i));
      colours.setXYZ(i, ...(isPart ? [0.87, 0.19, 0.007] : [0.3, 0.32, 0.36]));
    }
    const url = members && !box.isEmpty() ? this.#pictureOfBox(box.applyMatrix4(this.#model.matrixWorld), size) : null;
    colours.array.set(before);
    colours.needsUpdate = true;
    return url;
  }

  #pictureOfBox(box, [width, height]) {
    const camera = new PerspectiveCamera(35, width / height, this.#camera.near, this.#camera.far);
    const centre = box.getCenter(new Vector3());
    const radius = Math.max(box.getSize(new Vector3()).length() / 2, 0.18 * this.#radius);
    camera.position.copy(centre).addScaledVector(new Vector3(0.42, 0.22, 1).normalize(), (1.6 * radius) / Math.sin(camera.fov * MathUtils.DEG2RAD / 2));
    camera.lookAt(centre);
    camera.add(new DirectionalLight(0xffffff, 1.7));
    const others = [this.#gizmo.getHelper(), this.#grid, this.#look?.root].filter((one) => one?.visible);
    const bonesShown = this.#bones.shown;
    this.#bones.shown = false;
    for (const one of others) one.visible = false;
    const meshShown = this.#mesh.visible;
    this.#mesh.visible = true;
    const [mapping, environment] = [this.#renderer.toneMapping, this.#scene.environment];
    this.#renderer.toneMapping = NoToneMapping;
    this.#scene.environment = null;
    const target = new WebGLRenderTarget(width, height, { samples: 4, colorSpace: SRGBColorSpace });
    const pixels = new Uint8ClampedArray(4 * width * height);
    this.#mesh.geometry.getAttribute("color").needsUpdate = true;
    this.#renderer.setRenderTarget(target);
    this.#renderer.clear();
    this.#renderer.render(this.#scene, camera);
    this.#renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    this.#renderer.setRenderTarget(null);
    target.dispose();
    this.#bones.shown = bonesShown;
    for (const one of others) one.visible = true;
    this.#mesh.visible = meshShown;
    [this.#renderer.toneMapping, this.#scene.environment] = [mapping, environment];
    this.redraw();
    return addressOf(pixels, width, height);
  }

  // The rest is for tests.
  shownJoints() {
    return Array.from(this.#jointPositions);
  }
  shownPositions() {
    return Array.from(this.#mesh.geometry.getAttribute("position").array);
  }
  shownSpots() {
    return this.#spots.shown;
  }
  shownColours() {
    return Array.from(this.#mesh.geometry.getAttribute("color").array);
  }
  ringUnderPointer() {
    return this.onRing;
  }
  // How far the rings' own skeleton is from where the engine has the joints, in sizes of the character.
  largestHandleDistance() {
    this.#model.updateMatrixWorld(true);
    const distances = this.#handles.map((handle, j) => {
      const engine = new Vector3().fromArray(this.#jointPositions, j * 3);
      return this.#model.worldToLocal(handle.getWorldPosition(new Vector3())).distanceTo(engine);
    });
    return Math.max(...distances) / this.#radius;
  }

  // The camera by what the joints' middle has moved; once more when a motion has ended, back to the pose.
  #goAlong(moves) {
    const middle = new Vector3();
    const at = new Vector3();
    const count = Math.max(1, this.#joints.length);
    for (let j = 0; j < this.#joints.length; ++j) middle.addScaledVector(at.fromArray(this.#jointPositions, j * 3), 1 / count);
    middle.applyMatrix4(this.#model.matrixWorld);
    if (this.#middle) {
      const way = new Vector3().subVectors(middle, this.#middle).setY(0);
      this.#camera.position.add(way);
      this.#orbit.target.add(way);
      this.#orbit.update();
    }
    this.#middle = moves ? middle : null;
  }

  #resize() {
    const width = Math.max(1, this.#host.clientWidth);
    const height = Math.max(1, this.#host.clientHeight);
    this.#renderer.setSize(width, height);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    if (this.#mesh && this.#untouched) this.frame();
    this.#draw(); // at once: a canvas that was sized anew is empty
  }

  #makeHandles() {
    for (const handle of this.#handles) handle.removeFromParent();
    this.#handles = this.#joints.map(() => {
      const handle = new Object3D();
      handle.rotation.order = "ZYX"; // R = Rz Ry Rx, as the engine's poses
      return handle;
    });
    this.#joints.forEach(({ parent }, j) => (parent < 0 ? this.#model : this.#handles[parent]).add(this.#handles[j]));
    this.#placeHandles();
  }

  #placeHandles() {
    this.#joints.forEach(({ parent, position }, j) => {
      const from = parent < 0 ? [0, 0, 0] : this.#joints[parent].position;
      this.#handles[j].position.set(...position.map((p, axis) => p - from[axis]));
    });
  }

  #makeGrid(box) {
    this.#grid?.dispose();
    this.#grid?.removeFromParent();
    this.#grid = new GridHelper(this.#radius * 4, 20, ...(isLight.matches ? [0xaab2bd, 0xc9cfd8] : [0x4a515d, 0x2c3139]));
    this.#grid.position.set(this.#centre.x, box.min.y, this.#centre.z);
    this.#scene.add(this.#grid);
  }
}
