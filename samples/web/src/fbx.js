// SPDX-License-Identifier: MIT
// FBX out, by way of the module's GLB. Loaded only when it is asked for.
import { FBXExporter } from "@comfyorg/fbx-exporter-three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// Bytes of a binary FBX of a GLB, for Blender, Maya, Unity and Unreal.
export async function glbToFbx(glb) {
  const gltf = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength), "");
  return new FBXExporter().parseAsync(gltf.scene, { animations: gltf.animations, creator: "sinew" });
}
