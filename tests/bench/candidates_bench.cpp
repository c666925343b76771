// SPDX-License-Identifier: MIT
// Time of the mesh and the candidate stage on synthetic bodies. Counters: vertices, joints, workspace bytes and a hash
// of the result. Arguments: scene, candidates a vertex, cells along the longest side.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <new>

#include "heat_scene.hpp"
#include "mesh_scene.hpp"

namespace {

sinew_test::MeshScene from(const sinew_test::HeatScene& scene) {
  sinew_test::MeshScene out;
  out.positions = scene.positions;
  for (size_t c = 0; c < scene.triangles.size(); c += 3) {
    out.add_face({scene.triangles[c], scene.triangles[c + 1], scene.triangles[c + 2]});
  }
  out.joints = scene.joints;
  out.parents = scene.parents;
  return out;
}

uint32_t hash(const sinew::Candidates& candidates, uint32_t vertex_count) {
  uint32_t value = 2166136261u;
  const size_t count = static_cast<size_t>(vertex_count) * candidates.k;
  for (size_t i = 0; i < count; ++i) {
    value = (value ^ candidates.joints[i]) * 16777619u;
    value = (value ^ candidates.distances[i]) * 16777619u;
  }
  return value;
}

void report(benchmark::State& state, const sinew_test::MeshRun& run) {
  if (run.status != SINEW_OK) state.SkipWithError("a stage failed");
  state.counters["vertices"] = run.mesh.welded_count;
  state.counters["joints"] = run.counts.joints;
  state.counters["bytes"] = static_cast<double>(run.used);
  if (run.candidates.joints != nullptr) state.counters["hash"] = hash(run.candidates, run.mesh.welded_count);
}

// A body with six arms, 10,002 vertices and 97 joints; a fat capsule with 100 joints; a floating sleeve beside few
// joints, where the labels have to cross much of the empty box.
sinew_test::MeshScene scene_of(int64_t which) {
  if (which == 0) return from(sinew_test::star(100, 100, 16));
  if (which == 1) return from(sinew_test::capsule(100, 100, 100));
  sinew_test::HeatScene scene = sinew_test::capsule(50, 50, 8);
  sinew_test::add_sleeve(&scene, 1.8, 1.0, 3.0, 20, 40);
  return from(scene);
}

void mesh_only(benchmark::State& state) {
  const sinew_test::MeshScene scene = scene_of(state.range(0));
  for (auto _ : state) {
    const sinew_test::MeshRun run(scene);
    report(state, run);
  }
}

void mesh_and_candidates(benchmark::State& state) {
  const sinew_test::MeshScene scene = scene_of(state.range(0));
  for (auto _ : state) {
    const sinew_test::MeshRun run(scene, 0, static_cast<uint32_t>(state.range(1)),
                                  static_cast<uint32_t>(state.range(2)), true);
    report(state, run);
  }
}

// The stage alone; bytes are its result and scratch.
void candidates_only(benchmark::State& state) {
  sinew_test::MeshRun run(scene_of(state.range(0)), 0, static_cast<uint32_t>(state.range(1)),
                          static_cast<uint32_t>(state.range(2)));
  sinew::Candidates candidates;
  const auto find = [&](sinew::Arena& arena) {
    candidates.allocate(arena, run.counts);
    return sinew::find_candidates(run.mesh, run.skeleton, run.counts, {}, arena, &candidates);
  };
  sinew::Arena measure;
  (void)find(measure);
  const size_t bytes = measure.high_water();
  void* const block = ::operator new (bytes, std::align_val_t{64});
  for (auto _ : state) {
    sinew::Arena arena(block, bytes);
    run.status = find(arena);
  }
  report(state, run);
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["hash"] = hash(candidates, run.mesh.welded_count);
  ::operator delete (block, std::align_val_t{64});
}

BENCHMARK(mesh_only)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_and_candidates)
    ->Args({0, 8, 64})
    ->Args({1, 8, 64})
    ->Args({2, 8, 64})
    ->Args({0, 16, 128})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(candidates_only)
    ->Args({0, 8, 64})
    ->Args({1, 8, 64})
    ->Args({2, 8, 64})
    ->Args({0, 16, 128})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
