// SPDX-License-Identifier: MIT
import type { AnimationClip, Bone, BufferGeometry, Matrix4, Mesh as ThreeMesh, Skeleton as ThreeSkeleton, SkinnedMesh } from "three";
import type { Binder as SmallBinder } from "./bind.js";
import type { BindOptions, Bound, ClipOptions, Mesh, MotionRig, RetargetOptions, Rig, Skeleton, Skin, Transferred } from "./index.js";
import type { RemoteModel, RemoteSkin } from "./worker.js";

/** What load() gave, here or of ./bind, or connect() of ./worker. */
export type Binder = Skin | SmallBinder | RemoteSkin;
type Options = Omit<BindOptions<any>, "format">;

/** A geometry in the engine's arrays, in the world where matrixWorld puts it. */
export function meshOfGeometry(geometry: BufferGeometry, matrixWorld?: Matrix4): { positions: Float32Array; indices: Uint32Array };
/** Bones where they stand; those of a Skeleton where its inverses say that they are at rest. */
export function skeletonOfBones(bones: readonly Bone[] | ThreeSkeleton): MotionRig & { names: string[]; positions: Float32Array; parents: Int32Array; rotations: Float32Array };
/** Gives the geometry skinIndex and skinWeight. Bones stand as at rest; matrixWorld is the mesh's, the identity where it is missing. */
export function bindGeometry(binder: Binder, geometry: BufferGeometry, bones: readonly Bone[] | ThreeSkeleton, options?: Options & { matrixWorld?: Matrix4 }): Promise<Bound>;
export function setSkin(geometry: BufferGeometry, bound: Bound | Transferred): void;
/** A SkinnedMesh in the place of mesh, bound to bones as they stand; a Skeleton that is posed is refused. */
export function bindMesh(binder: Binder, mesh: ThreeMesh, bones: Bone[] | ThreeSkeleton, options?: Options): Promise<{ mesh: SkinnedMesh; bound: Bound }>;
/** Bones of what rig() gave, in its order. */
export function makeBones(rig: Rig): Bone[];
/** [J x 12] for Deformer.pose(), of the skeleton as it stands. */
export function paletteOf(skeleton: ThreeSkeleton): Float32Array;
/** A clip of the source's bones for the target's. Both stand at rest; a Skeleton that is posed is refused. */
export function retargetClip(
  skin: Skin, clip: AnimationClip, source: Bone[] | ThreeSkeleton, target: Bone[] | ThreeSkeleton, options?: RetargetOptions & ClipOptions,
): AnimationClip;
