// SPDX-License-Identifier: MIT
// FBX in and out, by way of GLB: three.js reads it, the page's module has the GLB. Loaded only when such a file is asked for.
import { FBXExporter } from "@comfyorg/fbx-exporter-three";
import { LoadingManager, MeshStandardMaterial } from "three";
import { GLTFExporter } from "three/addons/exporters/GLTFExporter.js";
import { FBXLoader } from "three/addons/loaders/FBXLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const nothing = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/PchI7wAAAABJRU5ErkJggg==";

// What glTF has of a material of FBX.
function standard({ name, color, map, normalMap, emissive, emissiveMap, opacity, transparent, alphaMap, side, vertexColors }) {
  const made = new MeshStandardMaterial({ name, map, normalMap, emissiveMap, opacity, side, vertexColors, roughness: 0.8, metalness: 0 });
  made.transparent = transparent && (opacity < 1 || Boolean(alphaMap));
  if (color) made.color.copy(color);
  if (emissive) made.emissive.copy(emissive);
  return made;
}

// Bytes of a GLB with the meshes, skeleton, weights, materials and animations of an FBX.
// buffer: ArrayBuffer of the file; name: for messages. Throws Error in one line.
export async function fbxToGlb(buffer, name) {
  const manager = new LoadingManager();
  manager.setURLModifier((url) => (/^(blob|data):/.test(url) ? url : nothing)); // textures beside the file are not here
  let began = false;
  const loaded = new Promise((resolve) => {
    manager.onStart = () => (began = true);
    manager.onLoad = resolve;
  });
  let scene;
  const said = console.warn; // of materials and weights that FBX has and glTF has not
  console.warn = () => {};
  try {
    try {
      scene = new FBXLoader(manager).parse(buffer, "");
    } catch (error) {
      throw new Error(`${name}: is no FBX that can be read (${String(error.message ?? error).split("\n")[0]}); save it as FBX 7.4 binary, or as GLB`);
    }
    if (began) await Promise.race([loaded, new Promise((resolve) => setTimeout(resolve, 5000))]);
    let meshes = 0;
    const lights = [];
    scene.traverse((object) => {
      if (object.isLight || object.isCamera) lights.push(object);
      if (!object.isMesh) return;
      ++meshes;
      object.material = Array.isArray(object.material) ? object.material.map(standard) : standard(object.material);
    });
    for (const light of lights) light.removeFromParent();
    if (meshes === 0 && scene.animations.length === 0) throw new Error(`${name}: holds neither a mesh nor a motion`);
    const glb = await new GLTFExporter().parseAsync(scene, { binary: true, onlyVisible: false, animations: scene.animations });
    return new Uint8Array(glb);
  } finally {
    console.warn = said;
  }
}

// Bytes of a binary FBX of a GLB, for Blender, Maya, Unity and Unreal.
export async function glbToFbx(glb) {
  const gltf = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength), "");
  return new FBXExporter().parseAsync(gltf.scene, { animations: gltf.animations, creator: "sinew" });
}
