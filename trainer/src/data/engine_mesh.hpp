// SPDX-License-Identifier: MIT
// A mesh of doubles as the engine reads it.
#ifndef SINEW_TRAINER_DATA_ENGINE_MESH_HPP
#define SINEW_TRAINER_DATA_ENGINE_MESH_HPP

#include <array>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

// A mesh that the engine has read, in its workspace.
struct EngineMesh {
  std::vector<float> positions;
  std::vector<uint32_t> corners;
  Workspace block{0};
  Mesh mesh;
  GridQuantizer quantizer;
  Counts counts;

  EngineMesh(const std::string& name, const std::vector<std::array<double, 3>>& vertices,
             const std::vector<std::array<uint32_t, 3>>& triangles) {
    for (const auto& v : vertices)
      for (const double x : v) positions.push_back(static_cast<float>(x));
    for (const auto& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
    sinew_mesh input = {};
    input.positions = positions.data();
    input.vertex_count = static_cast<uint32_t>(vertices.size());
    input.face_vertices = corners.data();
    input.face_count = static_cast<uint32_t>(triangles.size());
    input.corner_count = static_cast<uint32_t>(corners.size());
    counts.vertices = input.vertex_count;
    counts.faces = input.face_count;
    counts.corners = input.corner_count;
    const auto run = [&](Arena& arena) {
      (void)mesh.allocate(arena, counts);
      if (arena.measuring()) return build_mesh(input, quantizer, counts, arena, &mesh);
      const sinew_status status = make_grid_quantizer(input.positions, input.vertex_count, 0, &quantizer);
      return status == SINEW_OK ? build_mesh(input, quantizer, counts, arena, &mesh) : status;
    };
    Arena measuring;
    (void)run(measuring);
    block = Workspace(measuring.high_water());
    Arena arena(block.data(), block.size());
    const sinew_status status = run(arena);
    if (status != SINEW_OK) throw Error(name + ": " + sinew_status_text(status));
  }
};

}  // namespace sinew
#endif
