// SPDX-License-Identifier: MIT
// Checked by tsc alone, strictly: what the types allow.
import * as THREE from "three";
import { load, SinewError, type BindOptions, type Bound, type Mesh, type Rig, type Skeleton, type Skin } from "@sinew/skin";
import { load as loadBind, type Binder } from "@sinew/skin/bind";
import { bindWasm, wasm } from "@sinew/skin/url";
import { loadModel, loadRigModel } from "@sinew/skin/model";
import { bindGeometry, bindMesh, makeBones, paletteOf, retargetClip } from "@sinew/skin/three";
import { connect, serve, type RemoteSkin } from "@sinew/skin/worker";

const mesh: Mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: new Uint16Array([0, 1, 2]) };
const skeleton: Skeleton = { positions: new Float32Array(3), parents: [-1], names: ["hips"] };
const options: BindOptions = { method: "heat", influences: 4, answers: [{ vertex: 0, kind: "rigid", joint: 0 }], onProgress: (share) => share > 1 };

export async function main(worker: Worker): Promise<number> {
  const skin: Skin = await load({ model: await loadModel() });
  const small: Binder = await loadBind({ wasm: bindWasm });
  await load({ wasm, scalar: true });
  const bound: Bound = skin.bind(mesh, skeleton, options);
  const rig: Rig = skin.rig(mesh, { model: skin.openModel(await loadRigModel()), mirror: "never" });
  const bones: THREE.Bone[] = makeBones(rig);
  const three = new THREE.Mesh(new THREE.BufferGeometry());
  const { mesh: skinned } = await bindMesh(skin, three, bones, { symmetric: true });
  await bindMesh(small, three, skinned.skeleton);
  const palette: Float32Array = paletteOf(skinned.skeleton);
  const deformer = skin.deformer(mesh, skeleton, bound, { method: "volume", bodyContact: true });
  const { positions } = deformer.pose(palette);
  deformer.free();
  const clip: THREE.AnimationClip = retargetClip(skin, new THREE.AnimationClip("walk"), bones, skinned.skeleton, { fps: 30, inPlace: true, armSpread: 15 });
  const remote: RemoteSkin = await connect(worker, { model: await loadModel() });
  await bindGeometry(remote, three.geometry, bones, { method: "heat" });
  // @ts-expect-error no such method
  skin.bind(mesh, skeleton, { method: "magic" });
  // @ts-expect-error a skeleton has parents
  skin.bind(mesh, { positions: [] });
  try {
    serve();
  } catch (error) {
    if (error instanceof SinewError) return error.status;
  }
  return positions.length + clip.tracks.length;
}
