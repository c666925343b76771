// SPDX-License-Identifier: MIT
// The mesh with a colour per vertex, which shows weights and doubt.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshStandardMaterial, Vector4 } from "three";
import { moved } from "./rays.js";

const toLinear = Float32Array.from({ length: 256 }, (_, i) => {
  const x = i / 255;
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
});

/** @typedef {Mesh<BufferGeometry, MeshStandardMaterial>} ColouredMesh */

/**
 * Grey, with the bounds of its rest pose.
 * @param {{ triangles: Uint32Array, positions: Float32Array, normals: Float32Array, wireframe: boolean }} of
 * @returns {ColouredMesh}
 */
export function colouredMesh({ triangles, positions, normals, wireframe }) {
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(triangles, 1));
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(positions.length).fill(0.35), 3));
  geometry.computeBoundingBox();
  const material = new MeshStandardMaterial({ vertexColors: true, wireframe, roughness: 0.82, metalness: 0, side: DoubleSide });
  const mesh = new Mesh(geometry, material);
  mesh.userData.sweep = { value: new Vector4(0, 0, 0, 1) };
  material.onBeforeCompile = (shader) => {
    shader.uniforms.sweep = mesh.userData.sweep;
    shader.vertexShader = `uniform vec4 sweep;\n${shader.vertexShader}`.replace("#include <color_vertex>", "#include <color_vertex>\nvColor.rgb = mix(vec3(0.35), vColor.rgb, clamp(dot(sweep, vec4(position, 1.0)), 0.0, 1.0));");
  };
  mesh.frustumCulled = false; // poses leave the rest pose's bounds
  return mesh;
}

/** @param {ColouredMesh} mesh @param {Uint8Array} srgb three numbers a vertex */
export function paintMesh(mesh, srgb) {
  const colours = mesh.geometry.getAttribute("color");
  for (let i = 0; i < srgb.length; ++i) colours.array[i] = toLinear[srgb[i]];
  colours.needsUpdate = true;
}

const edge = 0.08; // of the height, in which gray becomes color

// From below the mesh shows its colors up to a share of its height; the rest is gray. up: an axis.
/** @param {ColouredMesh} mesh @param {number} share @param {number} up */
export function sweepMesh({ geometry, userData }, share, up) {
  const { min, max } = /** @type {import("three").Box3} */ (geometry.boundingBox);
  const steep = -1 / Math.max(1e-9, edge * (max.getComponent(up) - min.getComponent(up)));
  const end = min.getComponent(up) + share * (1 + edge) * (max.getComponent(up) - min.getComponent(up));
  if (share >= 1) userData.sweep.value.set(0, 0, 0, 1);
  else userData.sweep.value.set(0, 0, 0, -steep * end).setComponent(up, steep);
}

/** @param {ColouredMesh} mesh @param {Float32Array} positions @param {Float32Array} normals */
export function moveMesh({ geometry }, positions, normals) {
  for (const [name, values] of /** @type {const} */ ([["position", positions], ["normal", normals]])) {
    const attribute = geometry.getAttribute(name);
    attribute.array.set(values);
    attribute.needsUpdate = true;
  }
  geometry.boundingSphere = null;
  moved(geometry);
}
