// SPDX-License-Identifier: MIT
// The picture: mesh with vertex colours, skeleton on top, orbit camera, the rings that turn a joint, and joints that are
// dragged where the skeleton is edited. Draws only when something changed.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  GridHelper,
  Group,
  HemisphereLight,
  InstancedMesh,
  MathUtils,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Object3D,
  OctahedronGeometry,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Scene,
  SphereGeometry,
  SRGBColorSpace,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import { draggedTo } from "./limbs.js";
import { ContactSpots } from "./spots.js";

const colourOf = ([r, g, b]) => new Color().setRGB(r / 255, g / 255, b / 255, SRGBColorSpace);
const toLinear = Float32Array.from({ length: 256 }, (_, i) => {
  const x = i / 255;
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
});
const bonesColour = new Color(0xdfe5ec);
const chosenColour = new Color(0xffb02e);
const pickPixels = 11;
const dragPixels = 3; // less is a click

export class View {
  onPickJoint = () => {};
  onPickSurface = () => {}; // shown vertex
  onTurnStart = () => {};
  onTurn = () => {}; // joint, degrees x, y, z
  onDrag = () => {}; // joint, [x, y, z] where it is wanted now
  onDragEnd = () => {};
  onStrokeEnd = () => {};
  selected = -1;
  #also = new Set(); // joints that turn with the chosen one
  #boneSize = 1;
  #look = null; // shown instead of the coloured mesh, see look.js
  #palette = null; // of the last pose
  #stroking = false;
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
  #bones = new Group();
  #spots = new ContactSpots(this.#model);
  #light = new DirectionalLight(0xffffff, 1.7);
  #mesh;
  #grid;
  #joints = []; // [{parent, position}]
  #jointColours = null; // while a predicted skeleton is edited
  #editing = false;
  #drag = null; // {joint, offset, from, moved}
  #handles = []; // Object3D per joint, a skeleton of their own that the rings turn
  #jointPositions = new Float32Array();
  #radius = 1;
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
    this.#scene.add(new HemisphereLight(0xffffff, 0x8b93a3, 1.9), this.#camera, this.#model);
    this.#camera.add(this.#light);
    this.#light.position.set(0.6, 0.9, 0.7);
    this.#model.add(this.#bones);
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
      if (value) this.onTurnStart();
    });
    this.#gizmo.addEventListener("objectChange", () => {
      const { x, y, z } = this.#handles[this.selected].rotation;
      this.onTurn(this.selected, x * MathUtils.RAD2DEG, y * MathUtils.RAD2DEG, z * MathUtils.RAD2DEG);
    });
    this.#scene.add(this.#gizmo.getHelper());
    this.#listenForDrags();
    this.#listenForClicks();
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
    this.#mesh.frustumCulled = false; // poses leave the rest pose's bounds
    this.#model.add(this.#mesh);
    this.#model.rotation.x = upAxis === 1 ? -Math.PI / 2 : 0;
    this.#model.updateMatrixWorld(true);
    this.frame();
    this.setSkeleton(joints);
    this.#makeGrid(geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld));
  }

  setSkeleton(joints) {
    this.select(-1);
    this.#jointColours = null;
    this.#joints = joints;
    this.#jointPositions = Float32Array.from(joints.flatMap((j) => j.position));
    this.#makeHandles();
    this.#makeBones();
    this.redraw();
  }

  // The same joints elsewhere.
  moveSkeleton(joints) {
    this.#joints = joints;
    this.#jointPositions = Float32Array.from(joints.flatMap((j) => j.position));
    this.#placeHandles();
    this.#placeBones();
    this.redraw();
  }

  // colours: [[r, g, b]], 0 to 255, or null.
  setJointColours(colours) {
    this.#jointColours = colours?.map(colourOf) ?? null;
    this.#paintBones();
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
    return this.#drag?.moved ?? false;
  }

  setColours(srgb) {
    const colours = this.#mesh.geometry.getAttribute("color");
    for (let i = 0; i < srgb.length; ++i) colours.array[i] = toLinear[srgb[i]];
    colours.needsUpdate = true;
    this.redraw();
  }

  // turns: degrees of all joints, which the rings follow. moves: a motion plays, and the camera goes along with it over the floor.
  setPose(positions, normals, jointPositions, turns, palette, moves = false) {
    this.#palette = palette;
    this.#look?.pose(palette);
    const { geometry } = this.#mesh;
    geometry.getAttribute("position").copyArray(positions).needsUpdate = true;
    geometry.getAttribute("normal").copyArray(normals).needsUpdate = true;
    geometry.boundingSphere = null;
    this.#jointPositions = jointPositions;
    this.#handles.forEach((handle, j) => {
      if (this.#gizmo.dragging && j === this.selected) return;
      handle.rotation.set(...[0, 1, 2].map((axis) => turns[j * 3 + axis] * MathUtils.DEG2RAD));
    });
    this.#placeBones();
    this.#goAlong(moves);
    this.redraw();
  }

  // Contacts of a motion's frame, see spots.js.
  setSpots(spots) {
    this.#spots.show(spots, this.#radius);
    this.redraw();
  }

  // The character as its file shows it, a Look; null: with the colours of weights again.
  setLook(look) {
    this.#look?.dispose();
    this.#look = look;
    this.#scene.environment = look?.room(this.#renderer) ?? null;
    this.#scene.environmentIntensity = 0.5;
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
    return this.#boneSize;
  }
  set boneSize(size) {
    this.#boneSize = size;
    if (this.#bones.children.length > 0) this.#placeBones();
    this.redraw();
  }

  // Joints that are chosen beside `selected`.
  get also() {
    return this.#also;
  }
  set also(joints) {
    this.#also = new Set(joints);
    this.#paintBones();
    this.redraw();
  }

  select(joint) {
    if (joint !== this.selected) this.#also = new Set();
    this.selected = joint;
    if (joint < 0 || this.#editing || !this.#turnable || this.#onStroke) this.#gizmo.detach();
    else this.#gizmo.attach(this.#handles[joint]);
    this.#paintBones();
    this.redraw();
  }

  get skeletonShown() {
    return this.#bones.visible;
  }
  set skeletonShown(shown) {
    this.#bones.visible = shown;
    this.redraw();
  }

  // Brings the character, as it is posed now, into view.
  // from: the direction that the camera is in, in the picture's axes.
  frame(from = [0.42, 0.22, 1]) {
    this.#mesh.geometry.computeBoundingBox();
    const box = this.#mesh.geometry.boundingBox.clone().applyMatrix4(this.#model.matrixWorld);
    box.getCenter(this.#centre);
    this.#radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-6);
    const direction = new Vector3(...from).normalize();
    const fit = this.#radius / Math.sin((this.#camera.fov * MathUtils.DEG2RAD) / 2) / Math.min(1, this.#camera.aspect);
    this.#camera.near = this.#radius / 200;
    this.#camera.far = this.#radius * 200;
    this.#camera.updateProjectionMatrix();
    this.#camera.position.copy(this.#centre).addScaledVector(direction, fit * 0.85);
    this.#orbit.target.copy(this.#centre);
    this.#orbit.minDistance = this.#radius / 20;
    this.#orbit.maxDistance = this.#radius * 30;
    this.#orbit.update();
    this.#untouched = true;
    this.redraw();
  }

  redraw() {
    if (this.#stale) return;
    this.#stale = true;
    requestAnimationFrame(() => {
      this.#stale = false;
      this.#renderer.render(this.#scene, this.#camera);
    });
  }

  // Where a joint is on the page.
  jointOnScreen(joint) {
    this.#camera.updateMatrixWorld(); // the picture may be a frame behind
    const at = new Vector3().fromArray(this.#jointPositions, joint * 3).applyMatrix4(this.#model.matrixWorld).project(this.#camera);
    const box = this.#renderer.domElement.getBoundingClientRect();
    return { x: box.left + ((at.x + 1) / 2) * box.width, y: box.top + ((1 - at.y) / 2) * box.height, behind: at.z > 1 };
  }

  // Where a joint would be in the middle of what is behind it, as the picture stands; where it is if nothing is there.
  middleOf(joint) {
    const { x, y } = this.jointOnScreen(joint);
    const from = [...this.#jointPositions.subarray(joint * 3, joint * 3 + 3)];
    return this.#place(joint, from, x, y, true);
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
    return this.#gizmo.axis !== null;
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
    this.#renderer.render(this.#scene, this.#camera); // at once: a canvas that was sized anew is empty
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

  #makeBones() {
    for (const child of [...this.#bones.children]) {
      child.removeFromParent();
      child.dispose();
    }
    const material = () => new MeshBasicMaterial({ transparent: true, opacity: 0.9, depthTest: false, depthWrite: false });
    const bone = new OctahedronGeometry(1, 0);
    const corners = bone.getAttribute("position");
    for (let i = 0; i < corners.count; ++i) {
      // From 0 to 1 along Y, widest near the start.
      const y = corners.getY(i);
      corners.setY(i, y > 0.5 ? 1 : y < -0.5 ? 0 : 0.18);
    }
    const bones = new InstancedMesh(bone, material(), Math.max(1, this.#joints.length));
    bones.material.opacity = 0.5;
    const joints = new InstancedMesh(new SphereGeometry(1, 12, 8), material(), Math.max(1, this.#joints.length));
    bones.renderOrder = 1;
    joints.renderOrder = 2;
    for (const mesh of [bones, joints]) {
      mesh.count = this.#joints.length;
      mesh.frustumCulled = false;
      this.#bones.add(mesh);
    }
    this.#placeBones();
    this.#paintBones();
  }

  #placeBones() {
    const [bones, joints] = this.#bones.children;
    const at = new Vector3();
    const from = new Vector3();
    const along = new Vector3();
    const turn = new Quaternion();
    const up = new Vector3(0, 1, 0);
    const matrix = new Matrix4();
    const size = new Vector3();
    this.#joints.forEach(({ parent }, j) => {
      at.fromArray(this.#jointPositions, j * 3);
      let length = this.#radius * 0.1;
      if (parent >= 0) {
        from.fromArray(this.#jointPositions, parent * 3);
        along.subVectors(at, from);
        length = along.length();
        turn.setFromUnitVectors(up, along.normalize());
        const width = Math.min(length * 0.09, this.#radius * 0.014) * this.#boneSize;
        bones.setMatrixAt(j, matrix.compose(from, turn, size.set(width, length, width)));
      } else {
        bones.setMatrixAt(j, matrix.makeScale(0, 0, 0));
      }
      const ball = Math.min(Math.max(length * 0.1, this.#radius * 0.004), this.#radius * 0.011) * this.#boneSize * (j === this.selected ? 1.5 : 1);
      joints.setMatrixAt(j, matrix.compose(at, turn.identity(), size.setScalar(ball)));
    });
    bones.instanceMatrix.needsUpdate = true;
    joints.instanceMatrix.needsUpdate = true;
  }

  #paintBones() {
    if (this.#bones.children.length === 0) return;
    const [bones, joints] = this.#bones.children;
    this.#joints.forEach(({ parent }, j) => {
      joints.setColorAt(j, j === this.selected || this.#also.has(j) ? chosenColour : (this.#jointColours?.[j] ?? bonesColour));
      bones.setColorAt(j, parent === this.selected && parent >= 0 ? chosenColour : bonesColour);
    });
    for (const mesh of [bones, joints]) if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    this.#placeBones();
  }

  #makeGrid(box) {
    this.#grid?.dispose();
    this.#grid?.removeFromParent();
    this.#grid = new GridHelper(this.#radius * 4, 20, 0x4a515d, 0x2c3139);
    this.#grid.position.set(this.#centre.x, box.min.y, this.#centre.z);
    this.#scene.add(this.#grid);
  }

  // The joint that is nearest to a place of the page, -1 where none is near.
  #jointAt(x, y) {
    let best = -1;
    let nearest = pickPixels;
    for (let j = 0; this.skeletonShown && j < this.#joints.length; ++j) {
      const at = this.jointOnScreen(j);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (!at.behind && distance < nearest) [best, nearest] = [j, distance];
    }
    return best;
  }

  // The shown vertex under the pointer, -1 beside the mesh.
  #surfaceAt({ clientX, clientY }) {
    if (!this.#mesh) return -1;
    const [hit] = this.#rayThrough(clientX, clientY).intersectObject(this.#mesh);
    if (!hit) return -1;
    const positions = this.#mesh.geometry.getAttribute("position");
    const at = this.#mesh.worldToLocal(hit.point.clone()), corner = new Vector3();
    const [near] = ["a", "b", "c"].map((name) => hit.face[name]).sort((a, b) => corner.fromBufferAttribute(positions, a).distanceToSquared(at) - corner.fromBufferAttribute(positions, b).distanceToSquared(at));
    return near;
  }

  #rayThrough(x, y) {
    const box = this.#renderer.domElement.getBoundingClientRect();
    const point = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    this.#camera.updateMatrixWorld();
    const ray = new Raycaster();
    ray.setFromCamera(point, this.#camera);
    return ray;
  }

  // Where a joint that is at `from` goes when it is dragged to a place of the page.
  #place(joint, from, x, y, toMiddle) {
    const { origin, direction } = this.#rayThrough(x, y).ray;
    const toModel = new Matrix4().copy(this.#model.matrixWorld).invert(); // turned at most, so lengths stay
    const { geometry } = this.#mesh;
    return draggedTo({
      origin: origin.applyMatrix4(toModel).toArray(),
      direction: direction.transformDirection(toModel).toArray(),
      forward: this.#camera.getWorldDirection(new Vector3()).transformDirection(toModel).toArray(),
      from,
      plane: this.planeOf(joint),
      surface: toMiddle ? { positions: geometry.getAttribute("position").array, triangles: geometry.index.array } : null,
    });
  }

  // Before the canvas hears of it: a drag that begins on a joint is no orbit.
  #listenForDrags() {
    this.#host.addEventListener(
      "pointerdown",
      (event) => {
        if (this.onStroke && event.button === 0 && event.target === this.#renderer.domElement && this.#surfaceAt(event) >= 0) {
          this.#stroking = true;
          this.#orbit.enabled = false;
          event.target.setPointerCapture(event.pointerId);
          this.onStroke(this.#surfaceAt(event));
          return;
        }
        if (!this.#editing || !this.draggable || event.button !== 0 || event.target !== this.#renderer.domElement || this.#drag) return;
        const joint = this.#jointAt(event.clientX, event.clientY);
        if (joint < 0) return;
        this.#orbit.enabled = false;
        this.#untouched = false; // the picture stays as it is, whatever the window does
        const at = this.jointOnScreen(joint);
        this.#drag = {
          joint,
          offset: [at.x - event.clientX, at.y - event.clientY],
          start: [event.clientX, event.clientY],
          from: [...this.#jointPositions.subarray(joint * 3, joint * 3 + 3)],
          moved: false,
        };
        event.target.setPointerCapture(event.pointerId);
      },
      true,
    );
    const canvas = this.#renderer.domElement;
    canvas.addEventListener("pointermove", (event) => {
      const drag = this.#drag;
      if (this.#stroking) {
        const at = this.#surfaceAt(event);
        if (at >= 0) this.onStroke?.(at);
        return;
      }
      if (!drag) {
        canvas.style.cursor = this.#editing && this.draggable && this.#jointAt(event.clientX, event.clientY) >= 0 ? "move" : "";
        return;
      }
      const { clientX: x, clientY: y } = event;
      if (!drag.moved && Math.hypot(x - drag.start[0], y - drag.start[1]) < dragPixels) return;
      drag.moved = true;
      drag.from = this.#place(drag.joint, drag.from, x + drag.offset[0], y + drag.offset[1], this.toMiddle !== event.altKey);
      this.onDrag(drag.joint, drag.from);
    });
    const end = () => {
      if (this.#stroking) {
        this.#stroking = false;
        this.#orbit.enabled = true;
        return this.onStrokeEnd();
      }
      if (!this.#drag) return;
      const { moved } = this.#drag;
      this.#drag = null;
      this.#orbit.enabled = true;
      if (moved) this.onDragEnd();
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  }

  // A click, not the end of a drag, chooses the joint under the pointer, else the strongest joint of the surface there.
  #listenForClicks() {
    const canvas = this.#renderer.domElement;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => {
      down = event.button === 0 && this.#gizmo.axis === null && !this.#stroking ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener("pointerup", (event) => {
      if (!down || !this.#mesh || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const joint = this.#jointAt(event.clientX, event.clientY);
      const more = event.ctrlKey || event.metaKey || event.shiftKey; // beside the chosen one
      if (joint >= 0) return this.onPickJoint(joint, more);
      const at = this.#surfaceAt(event);
      if (at >= 0) this.onPickSurface(at, more);
    });
  }
}
