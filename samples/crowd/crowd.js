// SPDX-License-Identifier: MIT
// The page: a thousand characters in one draw call a mesh.  ?count=5000 draws others, ?vat=NAME.vat.json another character.
import { AmbientLight, Color, DirectionalLight, Fog, Matrix4, Mesh, MeshLambertMaterial, PerspectiveCamera, PlaneGeometry, Quaternion, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { loadVat, VatCrowd } from "./vat.js";

const settings = new URLSearchParams(location.search);
const count = Number(settings.get("count") ?? 1000);
const text = document.querySelector("#text");

// The same numbers 0..1 on every visit.
let seed = 1;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;

function fill(crowd, side, spacing) {
  const names = [...crowd.clips.keys()], up = new Vector3(0, 1, 0), scale = new Vector3(1, 1, 1);
  for (let i = 0; i < count; ++i) {
    const at = new Vector3((i % side) - (side - 1) / 2 + 0.5 * random(), 0, Math.floor(i / side) - (side - 1) / 2 + 0.5 * random()).multiplyScalar(spacing);
    crowd.setMatrixAt(i, new Matrix4().compose(at, new Quaternion().setFromAxisAngle(up, 0.8 * (random() - 0.5)), scale));
    crowd.play(i, names[Math.floor(random() * names.length)], 10 * random(), 0.9 + 0.2 * random());
  }
}

async function main() {
  const renderer = new WebGLRenderer({ antialias: true });
  document.body.prepend(renderer.domElement);
  const vat = await loadVat(settings.get("vat") ?? "character.vat.json");
  const { min, max } = vat.layout.bounds, height = max[1] - min[1], side = Math.ceil(Math.sqrt(count)), spacing = 0.8 * height;
  const crowd = new VatCrowd(vat, count);
  fill(crowd, side, spacing);

  const scene = new Scene();
  scene.background = new Color(0xbfd0dc);
  scene.fog = new Fog(0xbfd0dc, 6 * height + side * spacing * 0.4, 30 * height + side * spacing * 1.4);
  const sun = new DirectionalLight(0xffffff, 2.5);
  sun.position.set(1, 2, 1.5);
  const floor = new Mesh(new PlaneGeometry(1000 * height, 1000 * height).rotateX(-Math.PI / 2), new MeshLambertMaterial({ color: 0x93a58b }));
  floor.position.y = -0.01 * height;
  scene.add(crowd, floor, new AmbientLight(0xffffff, 1.2), sun);

  const camera = new PerspectiveCamera(45, 1, 0.05 * height, 1000 * height);
  camera.position.set(0, 3.2 * height, side * spacing * 0.5 + 5 * height);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.target.set(0, 0.5 * height, side * spacing * 0.3);
  controls.maxPolarAngle = 0.49 * Math.PI;
  controls.update();
  const resize = () => {
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(innerWidth, innerHeight);
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
  };
  addEventListener("resize", resize);
  resize();

  let frames = 0, since = performance.now();
  renderer.setAnimationLoop((now) => {
    crowd.update(now / 1000);
    controls.update();
    renderer.render(scene, camera);
    ++frames;
    if (now - since < 500) return;
    const rate = (1000 * frames) / (now - since), megabytes = (vat.layout.width * vat.layout.height * 12) / 1e6;
    text.textContent =
      `${count.toLocaleString("en")} characters of ${vat.layout.vertices.toLocaleString("en")} vertices, ${vat.layout.clips.length} clips in ` +
      `${megabytes.toFixed(1)} MB, ${renderer.info.render.calls} draw calls, ${rate.toFixed(rate < 10 ? 1 : 0)} FPS`;
    frames = 0;
    since = now;
  });
}

main().catch((error) => {
  text.textContent = String(error.message ?? error);
});
