// SPDX-License-Identifier: MIT
// Computes a glTF's vertices in its rest pose from nodes, inverse bind matrices and weights, like any viewer.
#ifndef SINEW_TESTS_REST_POSE_HPP
#define SINEW_TESTS_REST_POSE_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/io.hpp"

// [node with a mesh, primitive] -> positions
using RestPose = std::map<std::pair<size_t, size_t>, std::vector<std::array<double, 3>>>;

inline RestPose rest_pose(const sinew::GltfSource& source) {
  using namespace sinew;
  const auto& model = source.model;
  const GltfNodes nodes = gltf_nodes("rest", model);
  RestPose rest;
  size_t shown = 0;  // which mesh node it is: other nodes may go
  for (size_t n = 0; n < model.nodes.size(); ++n) {
    const auto& node = model.nodes[n];
    if (nodes.in_scene[n] == 0 || node.mesh < 0) continue;
    ++shown;
    const auto& primitives = model.meshes[static_cast<size_t>(node.mesh)].primitives;
    for (size_t p = 0; p < primitives.size(); ++p) {
      const auto& attributes = primitives[p].attributes;
      if (attributes.count("POSITION") == 0) continue;
      const std::vector<float> positions = accessor_floats("rest", model, attributes.at("POSITION"), 3);
      std::vector<Affine> matrices(positions.size() / 3, nodes.worlds[n]);
      if (node.skin >= 0 && attributes.count("WEIGHTS_0") != 0) {
        const std::vector<Affine> palette = skin_palette("rest", model, nodes, node.skin);
        std::fill(matrices.begin(), matrices.end(), Affine{});
        std::vector<double> sums(matrices.size(), 0);
        for (int set = 0; attributes.count("WEIGHTS_" + std::to_string(set)) != 0; ++set) {
          const auto weights = accessor_floats("rest", model, attributes.at("WEIGHTS_" + std::to_string(set)), 4);
          const auto joints = accessor_integers("rest", model, attributes.at("JOINTS_" + std::to_string(set)), 4);
          for (size_t i = 0; i < weights.size(); ++i) {
            for (size_t k = 0; k < 12; ++k)
              matrices[i / 4][k] += static_cast<double>(weights[i]) * palette.at(joints[i])[k];
            sums[i / 4] += static_cast<double>(weights[i]);
          }
        }
        for (size_t v = 0; v < matrices.size(); ++v)
          for (double& value : matrices[v]) value = sums[v] > 0 ? value / sums[v] : 0;
      }
      for (size_t v = 0; v < matrices.size(); ++v)
        rest[{shown, p}].push_back(transform_point(matrices[v], static_cast<double>(positions[v * 3]),
                                                   static_cast<double>(positions[v * 3 + 1]),
                                                   static_cast<double>(positions[v * 3 + 2])));
    }
  }
  return rest;
}

// The file written from a character stands where the character's own document stood; a file saved in a pose of its own
// is another matter, since new weights hold it differently there.
inline void expect_same_rest(const sinew::Character& character, const std::string& path) {
  if (!character.gltf || character.gltf->bind_pose.moved) return;
  const RestPose before = rest_pose(*character.gltf), after = rest_pose(sinew::load_gltf(path, sinew::read_file(path)));
  for (const auto& [part, positions] : before) {
    ASSERT_TRUE(after.count(part)) << path << ": mesh node " << part.first;
    ASSERT_EQ(after.at(part).size(), positions.size());
    double size = 1e-9, moved = 0;
    for (size_t v = 0; v < positions.size(); ++v)
      for (size_t c = 0; c < 3; ++c) {
        size = std::max(size, std::fabs(positions[v][c]));
        moved = std::max(moved, std::fabs(positions[v][c] - after.at(part)[v][c]));
      }
    EXPECT_LT(moved, 1e-4 * size) << path << ": mesh node " << part.first << ", primitive " << part.second;
  }
}

#endif
