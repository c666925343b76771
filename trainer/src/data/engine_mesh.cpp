// SPDX-License-Identifier: MIT
// Vertices and triangles through the engine's first stages.
#include "data/engine_mesh.hpp"

#include "sinew_formats/error.hpp"

namespace sinew {

using namespace rigging;

EngineMesh::EngineMesh(const std::string& name, const std::vector<std::array<double, 3>>& vertices,
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

MirrorFrame EngineMesh::mirror_frame() const {
  MirrorFrame frame;
  const float zero[3] = {0, 0, 0};
  const Vec3i middle = quantize_point(quantizer, zero);
  const int32_t middles[2] = {middle.x, middle.z};
  Arena measuring;
  (void)find_mirror_frame(mesh, Mirroring::kAuto, middles, false, measuring, &frame);
  Workspace scratch(measuring.high_water());
  Arena arena(scratch.data(), scratch.size());
  (void)find_mirror_frame(mesh, Mirroring::kAuto, middles, false, arena, &frame);
  return frame;
}

void surface_of(const Character& character, std::vector<std::array<double, 3>>* vertices,
                std::vector<std::array<uint32_t, 3>>* triangles, std::vector<uint32_t>* source) {
  std::vector<uint32_t> number(character.vertices.size(), UINT32_MAX);
  const auto vertex_of = [&](uint32_t v) {
    if (number[v] == UINT32_MAX) {
      number[v] = static_cast<uint32_t>(vertices->size());
      const Vec3 p = character.vertices[v];
      vertices->push_back({p.x, p.y, p.z});
      source->push_back(v);
    }
    return number[v];
  };
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t begin = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t i = begin + 2; i < end; ++i) {
      triangles->push_back({vertex_of(character.face_vertices[begin]), vertex_of(character.face_vertices[i - 1]),
                            vertex_of(character.face_vertices[i])});
    }
  }
  if (triangles->empty()) throw Error(character.name + ": no faces; expected a surface");
}

}  // namespace sinew
