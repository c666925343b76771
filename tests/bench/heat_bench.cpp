// SPDX-License-Identifier: MIT
// Time, memory and output hash of the heat stage on synthetic bodies, and its steps one by one: CSV on standard output.
//   sinew_bench_heat [repeats]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "heat/laplacian.hpp"
#include "heat/solver.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.hpp"

namespace {

uint64_t fnv1a(uint64_t hash, const void* data, size_t bytes) {
  const unsigned char* p = static_cast<const unsigned char*>(data);
  for (size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211ull;
  return hash;
}

uint64_t hash_fields(const sinew_test::HeatRun& run) {
  uint64_t hash = 14695981039346656037ull;
  for (const sinew::HeatField& f : run.fields.field) {
    hash = fnv1a(hash, f.joints, size_t{run.mesh.welded_count} * sinew::kHeatSlots * sizeof(uint16_t));
    hash = fnv1a(hash, f.weights, size_t{run.mesh.welded_count} * sinew::kHeatSlots * sizeof(uint16_t));
  }
  return hash;
}

// Processor seconds: the stage has one thread, and the machine may be busy.
template <class Work>
double time(Work work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

[[noreturn]] void fail(const char* name, const char* what) {
  std::fprintf(stderr, "%s: %s\n", name, what);
  std::exit(1);
}

// What solve_heat() does with a mesh of one component, a step at a time. The parts field is left out: there it is the
// rule's.
struct Steps {
  std::vector<double> sources, edges, ordering, rule, soft;

  void run(const char* name, sinew_test::HeatRun& run, const sinew::Kernels& kernels, sinew::Arena& arena) {
    const size_t mark = arena.mark();
    sinew::HeatSources found;
    sinew::EdgeWeights weights;
    sinew::HeatSolver solver;
    if (!found.allocate(arena, run.counts) || !weights.allocate(arena, run.counts))
      fail(name, "the block is too small");
    sources.push_back(time([&] {
      (void)sinew::find_sources(run.mesh, run.skeleton, run.counts, {}, 1000, arena, &found, kernels.boxes_met);
    }));
    edges.push_back(time([&] { (void)sinew::weigh_edges(run.mesh, run.counts, arena, &weights); }));
    if (!solver.allocate(arena, run.counts)) fail(name, "the block is too small");
    solver.use(kernels.front);
    ordering.push_back(time([&] { solver.begin_component(run.mesh, weights, 0); }));
    for (const uint32_t field : {sinew::kFieldRule, sinew::kFieldSoft}) {
      std::vector<double>& seconds = field == sinew::kFieldRule ? rule : soft;
      seconds.push_back(time([&] { solver.solve_field(found, field, &run.fields.field[field]); }));
    }
    arena.release(mark);
  }
};

void measure(const char* name, const sinew_test::HeatScene& scene, int repeats) {
  sinew_test::HeatRun run(scene, false);
  if (run.status != SINEW_OK) fail(name, "the mesh stage failed");
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    sinew_status status = SINEW_OK;
    seconds.push_back(
        time([&] { status = sinew::solve_heat(run.mesh, run.skeleton, run.counts, {}, run.arena, &run.fields); }));
    if (status != SINEW_OK) fail(name, "the heat stage failed");
  }
  const uint64_t hash = hash_fields(run);
  Steps steps;
  if (run.mesh.component_count == 1) {
    sinew::Kernels kernels;
    (void)sinew::select_kernels(SINEW_KERNEL_AUTO, &kernels);
    sinew::Arena need;
    (void)sinew::HeatSources().allocate(need, run.counts);
    sinew::measure_solve_heat(need, run.counts);  // and some more than the steps take
    sinew::Workspace block(need.high_water());
    sinew::Arena arena(block.data(), block.size());
    for (int i = 0; i < repeats; ++i) steps.run(name, run, kernels, arena);
    if (hash_fields(run) != hash) fail(name, "the steps give other fields than the stage");
  }
  std::printf("%s,%u,%u,%u,%.4f", name, run.mesh.welded_count, run.mesh.component_count, run.skeleton.joint_count,
              median(seconds));
  for (const std::vector<double>* step : {&steps.sources, &steps.edges, &steps.ordering, &steps.rule, &steps.soft}) {
    if (step->empty())
      std::printf(",");
    else
      std::printf(",%.4f", median(*step));
  }
  std::printf(",%zu,%016llx,%s\n", run.heat_scratch_bytes, static_cast<unsigned long long>(hash), __VERSION__);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf(
      "scene,vertices,components,joints,stage_s,sources_s,edges_s,ordering_s,rule_s,soft_s,scratch_bytes,hash,"
      "compiler\n");
  measure("star_5k_61", sinew_test::star(62, 80, 10), repeats);
  measure("star_10k_61", sinew_test::star(88, 113, 10), repeats);
  measure("star_10k_97", sinew_test::star(88, 113, 16), repeats);
  measure("capsule_10k_100", sinew_test::capsule(100, 100, 100), repeats);
  sinew_test::HeatScene dressed = sinew_test::star(70, 90, 16);
  sinew_test::add_sleeve(&dressed, 0.62, -0.4, 0.4, 30, 60);
  sinew_test::add_sleeve(&dressed, 0.3, 0.2, 1.0, 30, 60);
  measure("dressed_10k_97", dressed, repeats);
  return 0;
}
