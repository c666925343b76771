// SPDX-License-Identifier: MIT
// Balls for meshes of faces and of what hands hold, and sinew_rig_details() without a model.
#ifndef SINEW_TESTS_DETAILS_BALL_SCENE_HPP
#define SINEW_TESTS_DETAILS_BALL_SCENE_HPP

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "mesh_scene.hpp"
#include "rig_skeleton.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

// An ellipsoid; its vertices behind `cut` along z (of the unit ball) are left out with their faces.
inline void add_ball(MeshScene* scene, const std::array<float, 3>& at, const std::array<float, 3>& radius,
                     float cut = -2) {
  const MeshScene ball = cube_sphere(6);
  const uint32_t first = scene->vertex_count();
  for (uint32_t v = 0; v < ball.vertex_count(); ++v) {
    const float* const p = &ball.positions[size_t{3} * v];
    scene->add_vertex(at[0] + radius[0] * p[0], at[1] + radius[1] * p[1], at[2] + radius[2] * std::max(p[2], cut));
  }
  for (size_t f = 0; f + 1 < ball.offsets.size(); ++f) {
    std::vector<uint32_t> face;
    bool kept = true;
    for (uint32_t c = ball.offsets[f]; c < ball.offsets[f + 1]; ++c) {
      face.push_back(first + ball.corners[c]);
      kept = kept && ball.positions[size_t{3} * ball.corners[c] + 2] >= cut;
    }
    if (kept) scene->add_face(face);
  }
}

// One stage, in a block of the size that it asks for less `missing` bytes.
inline sinew_status add_details(const MeshScene& scene, uint32_t wanted, RigSkeleton* skeleton,
                                sinew_rig_options options = SINEW_INIT(sinew_rig_options), size_t missing = 0) {
  const sinew_mesh mesh = scene.mesh_view();
  size_t bytes = 0;
  const sinew_status status = sinew_rig_details_workspace_size(nullptr, mesh.vertex_count, mesh.face_count,
                                                               mesh.corner_count, wanted, &options, &bytes);
  if (status != SINEW_OK) return status;
  const sinew::Workspace block(bytes);
  std::memset(block.data(), 0x5A, bytes);
  return sinew_rig_details(nullptr, &mesh, wanted, &options, block.data(), missing > bytes ? 0 : bytes - missing,
                           &skeleton->outputs);
}

}  // namespace sinew_test
#endif
