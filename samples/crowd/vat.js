// SPDX-License-Identifier: MIT
// Vertex animation textures of `sinew animate --vat` in three.js: one InstancedMesh for each mesh of the character, each instance with a clip and a
// time of its own. Copy this file into your project.
import { Group, InstancedBufferAttribute, InstancedMesh, NearestFilter, NoColorSpace, TextureLoader, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// GLSL of vertex shaders. vatPlay, of each instance: first frame; intervals between frames, negative: the clip holds its last frame; frames a second;
// seconds ahead.
export const vatShader = /* glsl */ `
uniform highp sampler2D vatHigh, vatLow, vatNormal;
uniform vec3 vatMin, vatMax;
uniform int vatRows;
uniform float vatTime;
in vec2 vatTexel;
in vec4 vatPlay;
vec3 vatPosition, vatDirection;

vec3 vatPositionAt(ivec2 at) {
  vec3 value = 65280.0 * texelFetch(vatHigh, at, 0).rgb + 255.0 * texelFetch(vatLow, at, 0).rgb;
  return mix(vatMin, vatMax, value / 65535.0);
}
vec3 vatNormalAt(ivec2 at) {
  return (255.0 * texelFetch(vatNormal, at, 0).rgb - 128.0) / 127.0;
}
void vatSample() {
  float count = abs(vatPlay.y), time = (vatTime + vatPlay.w) * vatPlay.z;
  time = vatPlay.y > 0.0 ? mod(time, count) : clamp(time, 0.0, count);
  float frame = min(floor(time), max(count - 1.0, 0.0));
  ivec2 at = ivec2(vatTexel * vec2(textureSize(vatHigh, 0))) + ivec2(0, int(vatPlay.x + frame) * vatRows);
  ivec2 next = at + ivec2(0, count > 0.0 ? vatRows : 0);
  vatPosition = mix(vatPositionAt(at), vatPositionAt(next), time - frame);
  vatDirection = normalize(mix(vatNormalAt(at), vatNormalAt(next), time - frame));
}
`;

// Reads NAME.vat.json and the files beside it.
export async function loadVat(url) {
  const address = new URL(url, document.baseURI);
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${url}: the server answers ${answer.status}`);
  const layout = await answer.json();
  if (layout.sinew_vat !== 1) throw new Error(`${url}: expected a file of sinew animate --vat, version 1`);
  const file = (name) => new URL(encodeURIComponent(name), address).href;
  const texture = async (name) => {
    const made = await new TextureLoader().loadAsync(file(name));
    // The bytes as they are in the file.
    Object.assign(made, { flipY: false, colorSpace: NoColorSpace, generateMipmaps: false, minFilter: NearestFilter, magFilter: NearestFilter });
    return made;
  };
  const [high, low, normal, gltf] = await Promise.all([
    ...["position_high", "position_low", "normal"].map((name) => texture(layout.textures[name])),
    new GLTFLoader().loadAsync(file(layout.mesh)),
  ]);
  const meshes = [];
  gltf.scene.traverse((node) => node.isMesh && meshes.push(node));
  const uniforms = {
    vatHigh: { value: high },
    vatLow: { value: low },
    vatNormal: { value: normal },
    vatMin: { value: new Vector3(...layout.bounds.min) },
    vatMax: { value: new Vector3(...layout.bounds.max) },
    vatRows: { value: layout.rows_per_frame },
    vatTime: { value: 0 },
  };
  return { layout, meshes, uniforms };
}

// A copy of any mesh material of three.js that takes positions and normals from the textures; also for customDepthMaterial, which shadows need.
export function vatMaterial(vat, material) {
  const made = material.clone();
  made.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, vat.uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", `${vatShader}\nvoid main() {\nvatSample();`)
      .replace("#include <beginnormal_vertex>", "vec3 objectNormal = vatDirection;")
      .replace("#include <begin_vertex>", "vec3 transformed = vatPosition;");
  };
  made.customProgramCacheKey = () => "sinew vat";
  return made;
}

// `count` characters in a group. Set each with setMatrixAt() and play(), then call update(seconds) for every picture.
export class VatCrowd extends Group {
  constructor(vat, count) {
    super();
    this.vat = vat;
    this.clips = new Map(vat.layout.clips.map((clip) => [clip.name, clip]));
    this.plays = new InstancedBufferAttribute(new Float32Array(4 * count), 4);
    for (const { geometry, material, name } of vat.meshes) {
      const own = geometry.clone();
      own.setAttribute("vatTexel", geometry.attributes.uv1);
      own.setAttribute("vatPlay", this.plays);
      const mesh = new InstancedMesh(own, vatMaterial(vat, material), count);
      if (this.children.length > 0) mesh.instanceMatrix = this.children[0].instanceMatrix;
      mesh.name = name;
      mesh.frustumCulled = false; // its bounds are those of the rest pose
      this.add(mesh);
    }
  }

  setMatrixAt(index, matrix) {
    this.children[0].setMatrixAt(index, matrix);
    this.children[0].instanceMatrix.needsUpdate = true;
  }

  // Plays a clip by name; a clip that is no loop holds its last frame.
  play(index, name, secondsAhead = 0, speed = 1) {
    const clip = this.clips.get(name);
    if (!clip) throw new Error(`no clip ${name}, only ${[...this.clips.keys()].join(", ")}`);
    this.plays.setXYZW(index, clip.first_frame, (clip.frames - 1) * (clip.loop ? 1 : -1), clip.rate * speed, secondsAhead);
    this.plays.needsUpdate = true;
  }

  update(seconds) {
    this.vat.uniforms.vatTime.value = seconds;
  }
}
