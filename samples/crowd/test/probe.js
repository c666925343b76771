// SPDX-License-Identifier: MIT
// In the page of crowd_test.mjs: positions as the shader computes them, by transform feedback, and as three.js skins them.
import { AnimationMixer, LoopOnce, Vector3, WebGLRenderer } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { loadVat, vatShader } from "../vat.js";

function compile(gl) {
  const program = gl.createProgram();
  const sources = {
    [gl.VERTEX_SHADER]: `#version 300 es\n${vatShader}\nout vec3 position;\nvoid main() {\nvatSample();\nposition = vatPosition;\ngl_Position = vec4(0.0);\n}`,
    [gl.FRAGMENT_SHADER]: "#version 300 es\nvoid main() {}",
  };
  for (const [type, source] of Object.entries(sources)) {
    const shader = gl.createShader(Number(type));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.transformFeedbackVaryings(program, ["position"], gl.SEPARATE_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

class Shader {
  constructor(vat) {
    const renderer = new WebGLRenderer(), gl = renderer.getContext();
    this.gl = gl;
    this.program = compile(gl);
    gl.bindVertexArray(gl.createVertexArray());
    gl.useProgram(this.program);
    const { vatHigh, vatLow, vatMin, vatMax, vatRows } = vat.uniforms;
    const textures = { vatHigh, vatLow };
    for (const texture of Object.values(textures)) renderer.initTexture(texture.value); // as three.js puts it on the GPU
    for (const [unit, [name, texture]] of Object.entries(textures).entries()) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, renderer.properties.get(texture.value).__webglTexture);
      gl.uniform1i(this.at(name), unit);
    }
    gl.uniform3f(this.at("vatMin"), ...vatMin.value.toArray());
    gl.uniform3f(this.at("vatMax"), ...vatMax.value.toArray());
    gl.uniform1i(this.at("vatRows"), vatRows.value);
  }

  at(name) {
    return this.gl.getUniformLocation(this.program, name);
  }

  // [3 a vertex]
  positions(geometry, play, time) {
    const { gl, program } = this, texels = geometry.attributes.uv1, count = texels.count;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, texels.array, gl.STATIC_DRAW);
    const texel = gl.getAttribLocation(program, "vatTexel");
    gl.enableVertexAttribArray(texel);
    gl.vertexAttribPointer(texel, 2, gl.FLOAT, false, 0, 0);
    gl.vertexAttrib4f(gl.getAttribLocation(program, "vatPlay"), ...play);
    gl.uniform1f(this.at("vatTime"), time);
    const out = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, out);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 12 * count, gl.STREAM_READ);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, count);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    const positions = new Float32Array(3 * count);
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, positions);
    return positions;
  }
}

// The largest distance between both of any vertex, at a time of a clip in frames.
//   skinned  a GLB of the same character and clips
window.probe = async (vatUrl, skinned, moments) => {
  const vat = await loadVat(vatUrl), shader = new Shader(vat);
  const gltf = await new GLTFLoader().loadAsync(skinned), mixer = new AnimationMixer(gltf.scene);
  const skins = new Map();
  gltf.scene.traverse((node) => node.isMesh && skins.set(node.name, node));
  const results = [];
  for (const { clip: name, frame } of moments) {
    const clip = vat.layout.clips.find((one) => one.name === name);
    mixer.stopAllAction();
    const action = mixer.clipAction(gltf.animations.find((one) => one.name === name)).reset().setLoop(LoopOnce);
    action.clampWhenFinished = true; // its last frame is not its first one
    action.play();
    mixer.setTime(frame / clip.rate);
    gltf.scene.updateMatrixWorld(true);
    let largest = 0, vertices = 0;
    for (const { name: mesh, geometry } of vat.meshes) {
      const skin = skins.get(mesh), expected = new Vector3();
      const positions = shader.positions(geometry, [clip.first_frame, 1 - clip.frames, clip.rate, 0], frame / clip.rate);
      if (skin.geometry.attributes.position.count * 3 !== positions.length) throw new Error(`${mesh}: other vertices`);
      skin.skeleton?.update();
      for (let v = 0; v < positions.length / 3; ++v, ++vertices) {
        skin.getVertexPosition(v, expected).applyMatrix4(skin.matrixWorld);
        largest = Math.max(largest, expected.distanceTo(new Vector3().fromArray(positions, 3 * v)));
      }
    }
    results.push({ largest, vertices });
  }
  return results;
};
