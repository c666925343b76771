// SPDX-License-Identifier: MIT
// A limb with a skeleton and painted weights, and a transfer through the C API in exactly the workspace that it asks for.
#ifndef SINEW_TESTS_SUPPORT_TRANSFER_SCENE_HPP
#define SINEW_TESTS_SUPPORT_TRANSFER_SCENE_HPP

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "mesh_scene.hpp"

namespace sinew_test {

// A closed tube along y with three joints, `rings` rings of `sides` vertices, of a given height, thickness and lean.
inline MeshScene limb(int rings, int sides, double height, double radius, double lean = 0) {
  MeshScene scene;
  for (int r = 0; r < rings; ++r) {
    const double y = height * r / (rings - 1);
    for (int s = 0; s < sides; ++s) {
      const double angle = 2 * M_PI * s / sides;
      scene.add_vertex(static_cast<float>(radius * std::cos(angle) + lean * y), static_cast<float>(y),
                       static_cast<float>(radius * std::sin(angle)));
    }
  }
  const auto at = [&](int r, int s) { return static_cast<uint32_t>(r * sides + s % sides); };
  for (int r = 0; r + 1 < rings; ++r)
    for (int s = 0; s < sides; ++s) scene.add_face({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
  std::vector<uint32_t> bottom, top;
  for (int s = 0; s < sides; ++s) {
    bottom.push_back(at(0, s));
    top.push_back(at(rings - 1, sides - 1 - s));
  }
  scene.add_face(bottom);
  scene.add_face(top);
  for (int j = 0; j < 3; ++j)
    scene.add_joint(static_cast<float>(lean * height * j / 3), static_cast<float>(height * j / 3), 0, j - 1);
  return scene;
}

struct BoundRows {
  std::vector<uint16_t> joints, weights;  // [V x 2]
};

// Painted by height: joint 0 below, joint 1, joint 2 above, with a border as sharp as an artist's.
inline BoundRows painted(const MeshScene& scene, double height) {
  BoundRows rows;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    const double at = scene.positions[3 * v + 1] / height;
    const double share = at < 0.5 ? (at - 0.3) / 0.1 : (at - 0.7) / 0.1;
    const uint16_t upper = static_cast<uint16_t>(std::lround(65535 * std::fmin(std::fmax(share, 0), 1)));
    const uint16_t first = at < 0.5 ? 0 : 1;
    rows.joints.insert(rows.joints.end(), {first, static_cast<uint16_t>(first + 1)});
    rows.weights.insert(rows.weights.end(), {static_cast<uint16_t>(65535 - upper), upper});
  }
  return rows;
}

struct TransferRun {
  sinew_status sized = SINEW_OK, status = SINEW_OK;
  size_t bytes = 0;
  std::vector<uint16_t> joints, weights;  // [V x N]
  std::vector<uint8_t> confidence;
  std::vector<sinew_transfer_part> parts;
  std::vector<uint32_t> vertex_parts;
  sinew_transfer_outputs outputs = {};
  uint32_t n = 4;

  double weight(uint32_t vertex, uint16_t joint) const {
    double sum = 0;
    for (uint32_t i = 0; i < n; ++i)
      if (joints[vertex * n + i] == joint) sum += weights[vertex * n + i] / 65535.0;
    return sum;
  }
};

// Sum over joints of the difference between a row and the source's, mean over the vertices of two meshes with equal ones.
inline double distance(const TransferRun& run, const BoundRows& rows, uint32_t joints) {
  double sum = 0;
  const size_t vertices = rows.joints.size() / 2;
  for (size_t v = 0; v < vertices; ++v) {
    for (uint16_t j = 0; j < joints; ++j) {
      double own = 0;
      for (size_t i = 2 * v; i < 2 * v + 2; ++i) own += rows.joints[i] == j ? rows.weights[i] / 65535.0 : 0;
      sum += std::fabs(own - run.weight(static_cast<uint32_t>(v), j));
    }
  }
  return sum / static_cast<double>(vertices);
}

// joint_map empty: joints of one number are one.
inline TransferRun run_transfer(const MeshScene& source, const BoundRows& rows, const MeshScene& target,
                                const sinew_transfer_options& options = SINEW_INIT(sinew_transfer_options),
                                std::vector<int32_t> joint_map = {}, const TransferRun& before = {},
                                size_t missing_bytes = 0) {
  TransferRun run = before;
  const sinew_mesh source_mesh = source.mesh_view(), target_mesh = target.mesh_view();
  const sinew_skeleton source_skeleton = source.skeleton_view(), target_skeleton = target.skeleton_view();
  for (uint32_t j = 0; joint_map.size() < source_skeleton.joint_count; ++j)
    joint_map.push_back(j < target_skeleton.joint_count ? static_cast<int32_t>(j) : -1);
  const sinew_bound_character bound = {&source_mesh,
                                       &source_skeleton,
                                       {rows.joints.data(), rows.weights.data(), 2, SINEW_WEIGHT_UNORM16},
                                       joint_map.data()};
  run.n = options.influence_count != 0 ? options.influence_count : 4;
  run.joints.resize(size_t{run.n} * target_mesh.vertex_count);
  run.weights.resize(run.joints.size());
  run.confidence.resize(target_mesh.vertex_count);
  run.parts.resize(target_mesh.vertex_count);
  run.vertex_parts.resize(target_mesh.vertex_count);
  run.outputs = SINEW_INIT(sinew_transfer_outputs);
  run.outputs.joint_indices = run.joints.data();
  run.outputs.weights = run.weights.data();
  run.outputs.confidence = run.confidence.data();
  run.outputs.parts = run.parts.data();
  run.outputs.part_capacity = target_mesh.vertex_count;
  run.outputs.vertex_parts = run.vertex_parts.data();
  run.sized = sinew_transfer_workspace_size(nullptr, &bound, &target_mesh, &target_skeleton, &options, &run.bytes);
  sinew::Workspace workspace(run.sized == SINEW_OK ? run.bytes : size_t{1} << 22);
  std::memset(workspace.data(), 0xA5, workspace.size());
  const size_t given = run.sized == SINEW_OK ? run.bytes - missing_bytes : workspace.size();
  run.status =
      sinew_transfer(nullptr, &bound, &target_mesh, &target_skeleton, &options, workspace.data(), given, &run.outputs);
  run.parts.resize(run.status == SINEW_OK ? run.outputs.part_count : 0);
  return run;
}

}  // namespace sinew_test
#endif
