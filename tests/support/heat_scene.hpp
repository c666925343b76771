// SPDX-License-Identifier: MIT
// Meshes with skeletons made by formula, and one call that takes them through the mesh and the heat stage.
#ifndef SINEW_TESTS_SUPPORT_HEAT_SCENE_HPP
#define SINEW_TESTS_SUPPORT_HEAT_SCENE_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "bind/pipeline.hpp"
#include "heat/heat.hpp"
#include "kernels/select.hpp"
#include "scene_parts.hpp"

namespace sinew_test {

struct HeatScene : SceneParts {
  std::vector<uint32_t> triangles;

  // A view of the scene, which must outlive it.
  sinew_mesh mesh_view() const {
    sinew_mesh view = {};
    view.positions = positions.data();
    view.vertex_count = vertex_count();
    view.face_vertices = triangles.data();
    view.corner_count = static_cast<uint32_t>(triangles.size());
    view.face_count = view.corner_count / 3;
    return view;
  }
  void add_triangle(uint32_t a, uint32_t b, uint32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
  sinew::Counts counts() const {
    sinew::Counts c;
    c.vertices = vertex_count();
    c.faces = static_cast<uint32_t>(triangles.size() / 3);
    c.corners = static_cast<uint32_t>(triangles.size());
    c.joints = joint_count();
    return c;
  }
};

// Closed surface of revolution about the y axis: ring i of `rings` at height(i) with radius(i, angle), and two poles.
// Normals point outwards.
template <class Height, class Radius>
void add_revolved(HeatScene* scene, uint32_t rings, uint32_t segments, Height height, Radius radius, double bottom,
                  double top) {
  const uint32_t first = scene->vertex_count();
  for (uint32_t i = 0; i < rings; ++i) {
    for (uint32_t s = 0; s < segments; ++s) {
      const double angle = 2 * M_PI * s / segments;
      const double r = radius(i, angle);
      scene->add_vertex(r * std::cos(angle), height(i), r * std::sin(angle));
    }
  }
  const uint32_t south = scene->add_vertex(0, bottom, 0), north = scene->add_vertex(0, top, 0);
  const auto at = [&](uint32_t i, uint32_t s) { return first + i * segments + s % segments; };
  for (uint32_t s = 0; s < segments; ++s) {
    for (uint32_t i = 0; i + 1 < rings; ++i) {
      scene->add_triangle(at(i, s), at(i + 1, s), at(i + 1, s + 1));
      scene->add_triangle(at(i, s), at(i + 1, s + 1), at(i, s + 1));
    }
    scene->add_triangle(south, at(0, s), at(0, s + 1));
    scene->add_triangle(north, at(rings - 1, s + 1), at(rings - 1, s));
  }
}

// Capsule of length 4 and radius 0.4 along y, with a chain of `joint_count` joints on its axis.
inline HeatScene capsule(uint32_t rings, uint32_t segments, uint32_t joint_count) {
  HeatScene scene;
  const auto along = [rings](uint32_t i) { return (i + 1.0) / (rings + 1.0); };
  add_revolved(
      &scene, rings, segments, [&](uint32_t i) { return 2 - 2 * std::cos(M_PI * along(i)); },
      [&](uint32_t i, double) { return 0.4 * std::sqrt(std::sin(M_PI * along(i))); }, 0.0, 4.0);
  for (uint32_t j = 0; j < joint_count; ++j) {
    scene.add_joint(0, 0.3 + 3.4 * j / (joint_count > 1 ? joint_count - 1 : 1), 0, static_cast<int32_t>(j) - 1);
  }
  return scene;
}

// A body with six arms along the axes, vertices in a latitude/longitude grid, and a chain of joints in every arm.
inline HeatScene star(uint32_t rings, uint32_t segments, uint32_t joints_per_arm) {
  HeatScene scene;
  for (uint32_t i = 0; i < rings; ++i) {
    const double polar = M_PI * (i + 1) / (rings + 1);
    for (uint32_t s = 0; s < segments; ++s) {
      const double angle = 2 * M_PI * s / segments;
      const double d[3] = {std::sin(polar) * std::cos(angle), -std::cos(polar), std::sin(polar) * std::sin(angle)};
      const double arms = std::pow(std::fabs(d[0]), 14) + std::pow(std::fabs(d[1]), 14) + std::pow(std::fabs(d[2]), 14);
      const double r = 0.5 + 1.4 * arms + 0.02 * std::sin(7 * angle + 5 * polar);
      scene.add_vertex(r * d[0], r * d[1], r * d[2]);
    }
  }
  const uint32_t south = scene.add_vertex(0, -1.9, 0), north = scene.add_vertex(0, 1.9, 0);
  const auto at = [&](uint32_t i, uint32_t s) { return i * segments + s % segments; };
  for (uint32_t s = 0; s < segments; ++s) {
    for (uint32_t i = 0; i + 1 < rings; ++i) {
      scene.add_triangle(at(i, s), at(i + 1, s), at(i + 1, s + 1));
      scene.add_triangle(at(i, s), at(i + 1, s + 1), at(i, s + 1));
    }
    scene.add_triangle(south, at(0, s), at(0, s + 1));
    scene.add_triangle(north, at(rings - 1, s + 1), at(rings - 1, s));
  }
  const uint32_t root = scene.add_joint(0, 0.05, 0, -1);
  for (int axis = 0; axis < 3; ++axis) {
    for (int sign = -1; sign <= 1; sign += 2) {
      uint32_t parent = root;
      for (uint32_t k = 0; k < joints_per_arm; ++k) {
        double p[3] = {0.01 * k, 0.02, -0.01 * k};
        p[axis] = sign * 1.75 * (k + 1) / joints_per_arm;
        parent = scene.add_joint(p[0], p[1], p[2], static_cast<int32_t>(parent));
      }
    }
  }
  return scene;
}

// Open tube around the y axis, as clothing: its own part, boundary edges at both ends.
inline void add_sleeve(HeatScene* scene, double radius, double bottom, double top, uint32_t rings, uint32_t segments) {
  const uint32_t first = scene->vertex_count();
  for (uint32_t i = 0; i < rings; ++i) {
    for (uint32_t s = 0; s < segments; ++s) {
      const double angle = 2 * M_PI * (s + 0.3) / segments;
      scene->add_vertex(radius * std::cos(angle), bottom + (top - bottom) * i / (rings - 1), radius * std::sin(angle));
    }
  }
  const auto at = [&](uint32_t i, uint32_t s) { return first + i * segments + s % segments; };
  for (uint32_t i = 0; i + 1 < rings; ++i) {
    for (uint32_t s = 0; s < segments; ++s) {
      scene->add_triangle(at(i, s), at(i + 1, s), at(i + 1, s + 1));
      scene->add_triangle(at(i, s), at(i + 1, s + 1), at(i, s + 1));
    }
  }
}

// Triangles between random points: no surface at all, edges with many faces, separators as large as the whole.
inline HeatScene tangle(uint32_t vertices, uint32_t triangles, uint32_t joints, uint32_t seed) {
  HeatScene scene;
  std::mt19937 random(seed);  // its output is fixed by the standard, the distributions' is not
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (uint32_t v = 0; v < vertices; ++v) {
    const double x = unit(), y = unit(), z = unit();
    scene.add_vertex(x, y, z);
  }
  for (uint32_t t = 0; t < triangles; ++t) {
    uint32_t corner[3];
    for (uint32_t& c : corner) c = static_cast<uint32_t>(random() % vertices);
    scene.add_triangle(corner[0], corner[1], corner[2]);
  }
  for (uint32_t j = 0; j < joints; ++j) {
    const double x = unit(), y = 0.1 + 0.8 * unit(), z = unit();
    scene.add_joint(x, y, z, static_cast<int32_t>(j) - 1);
  }
  return scene;
}

// Owns the workspace of a scene whose mesh and heat stages ran.
class HeatRun {
 public:
  explicit HeatRun(const HeatScene& scene, bool solve = true) : counts(scene.counts()) {
    const sinew::Kernels kernels = sinew::fastest_kernels();
    const auto build = [&](sinew::Arena& memory) {
      allocate(memory);
      return sinew::build_mesh_and_skeleton(scene.mesh_view(), scene.skeleton_view(), 0, counts, memory, &mesh,
                                            &skeleton);
    };
    const auto solve_in = [&](sinew::Arena& memory) {
      return sinew::solve_heat(mesh, skeleton, source_joints.data(), counts, kernels, {}, memory, &fields);
    };
    sinew::Arena measure;
    (void)build(measure);
    held_bytes = measure.used();
    sinew::Arena heat_measure;
    (void)solve_in(heat_measure);
    heat_scratch_bytes = heat_measure.high_water();
    const size_t bytes = held_bytes + std::max(heat_scratch_bytes, measure.high_water());
    block_.reset(std::aligned_alloc(64, bytes));
    arena = sinew::Arena(block_.get(), bytes);
    status = build(arena);
    if (status != SINEW_OK) return;
    source_joints.resize(counts.joints);
    sinew::choose_source_joints(mesh, skeleton, source_joints.data());
    if (solve) status = solve_in(arena);
  }

  // Weight of a joint in a raw row, 0..1.
  double weight(uint32_t field, uint32_t welded, uint32_t joint) const {
    const sinew::HeatField& f = fields.field[field];
    for (uint32_t s = 0; s < sinew::kHeatSlots; ++s) {
      if (f.joints[welded * sinew::kHeatSlots + s] == joint) return f.weights[welded * sinew::kHeatSlots + s] / 32768.0;
    }
    return 0;
  }

  sinew::Counts counts;
  size_t held_bytes = 0, heat_scratch_bytes = 0;
  sinew::Arena arena;
  sinew::Mesh mesh;
  sinew::Skeleton skeleton;
  std::vector<uint8_t> source_joints;
  sinew::HeatFields fields;
  sinew_status status = SINEW_OK;

 private:
  void allocate(sinew::Arena& a) {
    mesh.allocate(a, counts);
    skeleton.allocate(a, counts);
    fields.allocate(a, counts);
  }
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  std::unique_ptr<void, Free> block_;
};

}  // namespace sinew_test
#endif
