// SPDX-License-Identifier: MIT
// Time, memory and output hash of the heat stage on synthetic bodies, as a whole and (bodies of one part) step by
// step: CSV on standard output.
//   sinew_bench_heat [repeats]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench_report.hpp"
#include "heat/solver.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.hpp"
#include "solve/laplacian.hpp"

namespace {

// The parts field has no step of its own: on one part it is a copy of the rule's.
constexpr const char* kSteps[] = {"whole", "sources and visibility", "edges", "ordering", "rule field", "soft field"};
enum Step : size_t { kWhole, kSources, kEdges, kOrdering, kRule, kSoft, kStepCount };

struct Measured {
  const char* name;
  std::vector<double> seconds[kStepCount];

  template <class Work>
  void time(Step step, Work work) {
    const double start = sinew_bench::thread_seconds();
    const sinew_status status = work();
    seconds[step].push_back(sinew_bench::thread_seconds() - start);
    if (status != SINEW_OK) fail(sinew_status_text(status));
  }
  [[noreturn]] void fail(const char* what) const {
    std::fprintf(stderr, "sinew_bench_heat: %s: %s\n", name, what);
    std::exit(1);
  }
};

uint64_t hash_fields(const sinew_test::HeatRun& run) {
  uint64_t hash = sinew_bench::kHashStart;
  for (const sinew::HeatField& f : run.fields.field) {
    const size_t bytes = size_t{run.mesh.welded_count} * sinew::kHeatSlots * sizeof(uint16_t);
    hash = sinew_bench::fnv1a(sinew_bench::fnv1a(hash, f.joints, bytes), f.weights, bytes);
  }
  return hash;
}

// What solve_heat() does with a mesh of one part, a step at a time.
void run_steps(const sinew::Kernels& kernels, sinew::Arena& arena, sinew_test::HeatRun* run, Measured* out) {
  const size_t mark = arena.mark();
  sinew::HeatSources sources;
  sinew::EdgeWeights weights;
  sinew::HeatSolver solver;
  (void)sources.allocate(arena, run->counts);
  (void)weights.allocate(arena, run->counts);
  out->time(kSources, [&] {
    return sinew::find_sources(run->mesh, run->skeleton, run->source_joints.data(), run->counts, kernels.boxes_met, {},
                               1000, arena, &sources);
  });
  out->time(kEdges, [&] { return sinew::weigh_edges(run->mesh, run->counts, arena, &weights); });
  if (!solver.allocate(arena, run->counts)) out->fail("the block is too small");
  solver.use(kernels.front);
  out->time(kOrdering, [&] {
    solver.begin_part(run->mesh, weights, 0);
    return SINEW_OK;
  });
  for (const uint32_t field : {sinew::kFieldRule, sinew::kFieldSoft}) {
    out->time(field == sinew::kFieldRule ? kRule : kSoft, [&] {
      solver.solve_field(sources, field, &run->fields.field[field]);
      return SINEW_OK;
    });
  }
  arena.release(mark);
}

void measure(const char* name, const sinew_test::HeatScene& scene, int repeats) {
  Measured out{name, {}};
  sinew_test::HeatRun run(scene, false);
  if (run.status != SINEW_OK) out.fail("the mesh stage failed");
  const sinew::Kernels kernels = sinew::fastest_kernels();
  for (int i = 0; i < repeats; ++i) {
    out.time(kWhole, [&] {
      return sinew::solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, kernels, {}, run.arena,
                               &run.fields);
    });
  }
  const uint64_t hash = hash_fields(run);
  if (run.mesh.part_count == 1) {
    sinew::Arena need;  // some more than the steps take
    (void)sinew::HeatSources().allocate(need, run.counts);
    (void)sinew::solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, kernels, {}, need,
                            &run.fields);
    sinew::Workspace block(need.high_water());
    sinew::Arena arena(block.data(), block.size());
    for (int i = 0; i < repeats; ++i) run_steps(kernels, arena, &run, &out);
    if (hash_fields(run) != hash) out.fail("the steps give other fields than the stage");
  }
  for (size_t step = 0; step < kStepCount; ++step) {
    if (out.seconds[step].empty()) continue;
    std::printf("%s,%s,%u,%u,%u,%s,%.3f,%zu,%016llx\n", sinew_bench::row_start().c_str(), name, run.mesh.welded_count,
                run.mesh.part_count, run.skeleton.joint_count, kSteps[step],
                sinew_bench::median(out.seconds[step]) * 1e3, run.heat_scratch_bytes,
                static_cast<unsigned long long>(hash));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("machine,compiler,commit,scene,vertices,parts,joints,step,median_ms,scratch_bytes,hash\n");
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
