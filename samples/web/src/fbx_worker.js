// SPDX-License-Identifier: MIT
// FBX out, by way of the module's GLB, beside the page so that it never stands still. Message in: the GLB's bytes; out: {bytes} or {error}.
import { FBXExporter } from "@comfyorg/fbx-exporter-three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// Bytes of a binary FBX of a GLB, for Blender, Maya, Unity and Unreal.
/** @param {Uint8Array<ArrayBuffer>} glb */
async function glbToFbx(glb) {
  const gltf = await new GLTFLoader().parseAsync(glb.buffer, "");
  return new FBXExporter().parseAsync(gltf.scene, { animations: gltf.animations, creator: "sinew" });
}

onmessage = async ({ data }) => {
  try {
    const bytes = await glbToFbx(data);
    postMessage({ bytes });
  } catch (error) {
    postMessage({ error: String(error?.message ?? error) });
  }
};
