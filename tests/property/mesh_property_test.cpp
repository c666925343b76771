// SPDX-License-Identifier: MIT
// Nothing after the mesh stage knows how the caller numbered vertices and faces.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>

#include "mesh_scene.hpp"

namespace {

using sinew_test::MeshRun;
using sinew_test::MeshScene;

struct Renumbered {
  MeshScene first, second;
  std::vector<uint32_t> new_index;  // of first's vertices in second
};

// A soup of polygons on few distinct points, so that welds, duplicates, degenerate faces and non-manifold edges are
// common.
Renumbered random_pair(uint32_t seed, uint32_t vertices, uint32_t faces, uint32_t coarseness) {
  std::mt19937 random(seed);
  Renumbered pair;
  const auto value = [&] { return static_cast<float>(random() % coarseness) * 0.37f; };
  for (uint32_t v = 0; v < vertices; ++v) {
    const float x = value(), y = value(), z = value();
    pair.first.add_vertex(x, y, z);
  }
  std::vector<std::vector<uint32_t>> polygons(faces);
  for (auto& face : polygons) {
    face.resize(2 + random() % 4);
    for (uint32_t& corner : face) corner = static_cast<uint32_t>(random() % vertices);
    pair.first.add_face(face);
  }
  for (int32_t j = 0; j < 12; ++j) {
    const float x = value(), y = value(), z = value();
    pair.first.add_joint(x, y, z, j == 0 ? -1 : static_cast<int32_t>(random() % static_cast<uint32_t>(j)));
  }
  pair.second.joints = pair.first.joints;
  pair.second.parents = pair.first.parents;
  pair.new_index.resize(vertices);
  std::iota(pair.new_index.begin(), pair.new_index.end(), 0u);
  std::shuffle(pair.new_index.begin(), pair.new_index.end(), random);
  pair.second.positions.resize(pair.first.positions.size());
  for (uint32_t v = 0; v < vertices; ++v) {
    std::copy_n(&pair.first.positions[3 * v], 3, &pair.second.positions[3 * pair.new_index[v]]);
  }
  std::shuffle(polygons.begin(), polygons.end(), random);
  for (auto& face : polygons) {
    for (uint32_t& corner : face) corner = pair.new_index[corner];
    if (face.size() == 3) std::rotate(face.begin(), face.begin() + random() % 3, face.end());
    pair.second.add_face(face);
  }
  return pair;
}

template <class T>
bool same(const T* a, const T* b, size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(T)) == 0;
}

TEST(MeshProperty, RenumberingChangesNothing) {
  const bool held = rc::check("renumbered vertices and faces give the same mesh and candidates", [] {
    const auto seed = *rc::gen::arbitrary<uint32_t>();
    const auto vertices = *rc::gen::inRange<uint32_t>(1, 60);
    const auto faces = *rc::gen::inRange<uint32_t>(0, 90);
    const auto coarseness = *rc::gen::inRange<uint32_t>(1, 12);
    const Renumbered pair = random_pair(seed, vertices, faces, coarseness);
    const MeshRun a(pair.first, 0, 8, 16, true), b(pair.second, 0, 8, 16, true);
    RC_ASSERT(a.status == SINEW_OK);
    RC_ASSERT(b.status == SINEW_OK);
    const sinew::Mesh &m = a.mesh, &n = b.mesh;
    const size_t u = m.welded_count, t = m.triangle_count;
    RC_ASSERT(u == n.welded_count);
    RC_ASSERT(t == n.triangle_count);
    RC_ASSERT(same(m.positions, n.positions, u));
    RC_ASSERT(same(m.triangles, n.triangles, 3 * t));
    RC_ASSERT(same(m.row_offsets, n.row_offsets, u + 1));
    RC_ASSERT(same(m.col_indices, n.col_indices, m.row_offsets[u]));
    RC_ASSERT(same(m.normals, n.normals, u));
    RC_ASSERT(same(m.areas, n.areas, u));
    RC_ASSERT(same(m.mean_curvature, n.mean_curvature, u));
    RC_ASSERT(same(m.gauss_curvature, n.gauss_curvature, u));
    RC_ASSERT(same(m.edge_length, n.edge_length, u));
    RC_ASSERT(m.part_count == n.part_count);
    RC_ASSERT(same(m.part, n.part, u));
    RC_ASSERT(same(m.part_sizes, n.part_sizes, m.part_count));
    RC_ASSERT(same(m.part_vertices, n.part_vertices, u));
    RC_ASSERT(same(a.candidates.joints, b.candidates.joints, u * 8));
    RC_ASSERT(same(a.candidates.distances, b.candidates.distances, u * 8));
    RC_ASSERT(same(a.candidates.tips, b.candidates.tips, 12));
    for (uint32_t v = 0; v < pair.new_index.size(); ++v) {
      RC_ASSERT(m.vertex_to_welded[v] == n.vertex_to_welded[pair.new_index[v]]);
    }
  });
  EXPECT_TRUE(held);
}

}  // namespace
