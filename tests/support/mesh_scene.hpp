// SPDX-License-Identifier: MIT
// A polygon mesh with a skeleton, and one call that takes it through the mesh and the candidate stage.
#ifndef SINEW_TESTS_SUPPORT_MESH_SCENE_HPP
#define SINEW_TESTS_SUPPORT_MESH_SCENE_HPP

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <vector>

#include "bind/pipeline.hpp"
#include "scene_parts.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

struct MeshScene : SceneParts {
  std::vector<uint32_t> offsets = {0}, corners;

  void add_face(std::initializer_list<uint32_t> face) { add_face(std::vector<uint32_t>(face)); }
  void add_face(const std::vector<uint32_t>& face) {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<uint32_t>(corners.size()));
  }
  sinew_mesh mesh_view() const {
    sinew_mesh view = {};
    view.positions = positions.data();
    view.vertex_count = vertex_count();
    view.face_offsets = offsets.data();
    view.face_vertices = corners.data();
    view.face_count = static_cast<uint32_t>(offsets.size() - 1);
    view.corner_count = static_cast<uint32_t>(corners.size());
    return view;
  }
};

// Unit cube of quads, y from 0 to 1, shifted.
inline void add_cube(MeshScene* scene, float x, float y, float z, float side = 1) {
  const uint32_t first = scene->vertex_count();
  for (int i = 0; i < 8; ++i) {
    scene->add_vertex(x + side * static_cast<float>(i & 1), y + side * static_cast<float>((i >> 1) & 1),
                      z + side * static_cast<float>(i >> 2));
  }
  const uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) scene->add_face({first + f[0], first + f[1], first + f[2], first + f[3]});
}

// Sphere of radius 1 from a cube grid of n x n quads a side, projected: no poles, every corner shared.
inline MeshScene cube_sphere(int n) {
  MeshScene scene;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const uint32_t first = scene.vertex_count();
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        double p[3];
        p[axis] = sign;
        p[(axis + 1) % 3] = std::tan(M_PI / 4 * (2.0 * i / n - 1));
        p[(axis + 2) % 3] = std::tan(M_PI / 4 * (2.0 * j / n - 1));
        const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        scene.add_vertex(static_cast<float>(p[0] / norm), static_cast<float>(p[1] / norm),
                         static_cast<float>(p[2] / norm));
      }
    }
    const auto at = [&](int i, int j) { return first + static_cast<uint32_t>(i * (n + 1) + j); };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (sign > 0) {
          scene.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        } else {
          scene.add_face({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
      }
    }
  }
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

// Runs the stages in a block of exactly the measured size, filled with rubbish beforehand.
class MeshRun {
 public:
  explicit MeshRun(const MeshScene& scene, uint32_t up_axis = 0, uint32_t k = 8, uint32_t grid = 64,
                   bool candidates_too = false, size_t missing_bytes = 0, sinew::Progress progress = {}) {
    const sinew_mesh mesh_input = scene.mesh_view();
    const sinew_skeleton skeleton_input = scene.skeleton_view();
    counts = sinew::Counts{
        mesh_input.vertex_count, mesh_input.face_count, mesh_input.corner_count, skeleton_input.joint_count, k, grid};
    const auto run = [&](sinew::Arena& arena) {
      mesh.allocate(arena, counts);
      skeleton.allocate(arena, counts);
      const sinew_status built =
          sinew::build_mesh_and_skeleton(mesh_input, skeleton_input, up_axis, counts, arena, &mesh, &skeleton);
      if (built != SINEW_OK || !candidates_too) return built;
      candidates.allocate(arena, counts);
      return sinew::find_candidates(mesh, skeleton, counts, progress, arena, &candidates);
    };
    sinew::Arena measure;
    (void)run(measure);
    measured = measure.high_water();
    block_ = sinew::Workspace(measured);
    std::memset(block_.data(), 0xA5, measured);
    sinew::Arena arena(block_.data(), measured - missing_bytes);
    status = run(arena);
    used = arena.high_water();
  }

  sinew::Counts counts;
  sinew::Mesh mesh;
  sinew::Skeleton skeleton;
  sinew::Candidates candidates;
  sinew_status status = SINEW_OK;
  size_t measured = 0, used = 0;

 private:
  sinew::Workspace block_;
};

}  // namespace sinew_test
#endif
