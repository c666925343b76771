// SPDX-License-Identifier: MIT
// The programs that files are made for: rows of character/src/profile/profiles.cpp as their users know them. To add one: a row here.
import { fileKind } from "../../npm/src/file_kinds.js";
import { all } from "./elements.js";

/** @typedef {{ id: string, name: string, profile: string, kind: string, bones: string, pose: string, influences: number }} Program */
/** @type {Program[]} */
export const programs = [
  { id: "any", name: "Any program", profile: "", kind: "glb", bones: "As they are here", pose: "As it stands", influences: 0 },
  { id: "blender", name: "Blender", profile: "blender", kind: "glb", bones: "Rigify: spine, upper_arm.L", pose: "As it stands", influences: 0 },
  { id: "unity", name: "Unity", profile: "unity", kind: "fbx", bones: "Humanoid: Hips, LeftUpperArm", pose: "T pose", influences: 4 },
  { id: "unreal", name: "Unreal", profile: "unreal", kind: "fbx", bones: "Mannequin: root, pelvis, upperarm_l", pose: "A pose", influences: 8 },
  { id: "godot", name: "Godot", profile: "godot", kind: "glb", bones: "Humanoid: Root, Hips, LeftUpperArm", pose: "T pose", influences: 8 },
  { id: "three", name: "three.js", profile: "three", kind: "glb", bones: "As they are here", pose: "As it stands", influences: 4 },
  { id: "vrchat", name: "VRChat", profile: "unity", kind: "fbx", bones: "Humanoid: Hips, LeftUpperArm", pose: "T pose", influences: 4 },
  { id: "vrm", name: "VRM avatar", profile: "vrm", kind: "vrm", bones: "VRM: hips, leftUpperArm", pose: "T pose, on the floor", influences: 4 },
];
export const chosenProgram = () => programs.find(({ id }) => id === all("#programs input:checked")[0]?.value) ?? programs[0];

/** @type {(kind: string) => string} */
export const unitOf = (kind) => (kind === "fbx" ? "Centimeters" : "Meters");

// What a file for it is like: [what, how].
// isPosed: the user has chosen a T pose; clips: names of those that go along.
/** @param {Program} program @param {boolean} isPosed @param {string[]} clips @returns {string[][]} */
export const factsOf = ({ kind, bones, pose, influences }, isPosed, clips) => [["File", fileKind(`.${kind}`)?.name ?? kind], ["Unit", unitOf(kind)], ["Bone names", bones], ["Rest pose", isPosed && !pose.startsWith("T") ? "T pose, as set in Skeleton" : pose], ["Bones per vertex", influences ? `At most ${influences}` : "As set in Weights"], ["Clips", clips.length > 3 ? `${clips.slice(0, 3).join(", ")} and ${clips.length - 3} more` : clips.join(", ") || "None"]];

// What a file cannot hold of the character, by what is known before it is written.
/** @param {Program} program @param {{ springs: boolean, baked: boolean, clips: number, withClips: boolean, skinning: number, turned: boolean }} character */
export function lossesOf({ kind, profile }, { springs, baked, clips, withClips, skinning, turned }) {
  const losses = [];
  if (springs && kind === "fbx") losses.push(baked && withClips && clips > 0 ? "FBX holds no springs: hair and skirts swing in the clips alone." : "FBX holds no springs: hair and skirts will not swing.");
  if (springs && kind === "glb") losses.push(`Only programs that read VRM springs play them${baked && withClips && clips > 0 ? "; the clips swing everywhere" : ""}.`);
  if (clips > 0 && !withClips) losses.push(`${clips} clip${clips === 1 ? "" : "s"} will be left out.`);
  if (skinning > 0) losses.push("Files have linear skinning: bends keep less volume there than in this picture.");
  if (turned) losses.push("The pose that you turned the joints to is not saved.");
  if (profile === "vrm" && clips > 0 && withClips) losses.push("Most VRM programs ignore clips.");
  return losses;
}
