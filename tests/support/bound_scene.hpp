// SPDX-License-Identifier: MIT
// A scene bound with the bundled model through the C API, in exactly the workspace that it asks for.
#ifndef SINEW_TESTS_BOUND_SCENE_HPP
#define SINEW_TESTS_BOUND_SCENE_HPP

#include <cstdint>
#include <vector>

#include "heat_scene.hpp"
#include "open_bundled_model.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

struct BoundScene {
  sinew_status status = SINEW_OK;
  size_t bytes = 0, used = 0;             // of workspace
  std::vector<uint16_t> joints, weights;  // [V x 4]
  std::vector<uint8_t> confidence;        // [V]
  uint32_t symmetric_vertices = 0;
};

// The joint that a hinted vertex is given wholly.
inline uint16_t hinted_joint(const HeatScene& scene, uint32_t vertex) {
  return static_cast<uint16_t>(vertex % scene.joint_count());
}

// `options` as they are, with confidence.
inline BoundScene bind_scene(const HeatScene& scene, const sinew_bind_options& options) {
  BoundScene bound;
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  bound.joints.assign(size_t{mesh.vertex_count} * 4, 0);
  bound.weights.assign(size_t{mesh.vertex_count} * 4, 0);
  bound.confidence.assign(mesh.vertex_count, 0);
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    if (options.hints == nullptr || options.hints[v] == 0) continue;
    bound.joints[size_t{v} * 4] = hinted_joint(scene, v);
    bound.weights[size_t{v} * 4] = 65535;
  }
  bound.status = sinew_bind_workspace_size(bundled_model(), mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                           skeleton.joint_count, &options, &bound.bytes);
  if (bound.status != SINEW_OK) return bound;
  const sinew::Workspace block(bound.bytes);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = bound.joints.data();
  outputs.weights = bound.weights.data();
  outputs.confidence = bound.confidence.data();
  bound.status = sinew_bind(bundled_model(), &mesh, &skeleton, &options, block.data(), bound.bytes, &outputs);
  bound.used = outputs.used_bytes;
  bound.symmetric_vertices = outputs.symmetric_vertices;
  return bound;
}

}  // namespace sinew_test
#endif
