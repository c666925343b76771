// SPDX-License-Identifier: MIT
// A scene taken through the mesh stage and the reduction, in a block of exactly the measured size.
#ifndef SINEW_TESTS_SUPPORT_REDUCED_SCENE_HPP
#define SINEW_TESTS_SUPPORT_REDUCED_SCENE_HPP

#include <cstring>

#include "heat_scene.hpp"
#include "reduce/reduction.hpp"
#include "sinew/sinew.hpp"

namespace sinew_test {

class ReducedRun {
 public:
  explicit ReducedRun(const HeatScene& scene, uint32_t surface_vertices, sinew::Threads threads = {}) {
    counts = scene.counts();
    counts.surface_vertices = surface_vertices;
    counts.threads = threads;
    sinew::Arena measure;
    (void)run(scene, measure);
    const size_t bytes = measure.high_water();
    block_ = sinew::Workspace(bytes);
    std::memset(block_.data(), 0xA5, bytes);
    sinew::Arena arena(block_.data(), bytes);
    status = run(scene, arena);
  }

  sinew::Counts counts;
  sinew::Mesh mesh;
  sinew::Skeleton skeleton;
  sinew::Reduction reduction;
  sinew_status status = SINEW_OK;

 private:
  sinew_status run(const HeatScene& scene, sinew::Arena& arena) {
    (void)mesh.allocate(arena, counts);
    (void)skeleton.allocate(arena, counts);
    if (counts.may_reduce()) (void)reduction.allocate(arena, counts);
    const sinew_status built =
        sinew::build_mesh_and_skeleton(scene.mesh_view(), scene.skeleton_view(), 0, counts, arena, &mesh, &skeleton);
    return built == SINEW_OK && counts.may_reduce() ? sinew::reduce_mesh(mesh, counts, {}, arena, &reduction) : built;
  }
  sinew::Workspace block_;
};

}  // namespace sinew_test
#endif
