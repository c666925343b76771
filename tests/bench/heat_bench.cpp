// SPDX-License-Identifier: MIT
// Time, memory and output hash of the heat stage on synthetic bodies: CSV on standard output.
//   sinew_bench_heat [repeats]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "heat_scene.hpp"

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

void measure(const char* name, const sinew_test::HeatScene& scene, int repeats) {
  sinew_test::HeatRun run(scene, false);
  if (run.status != SINEW_OK) {
    std::fprintf(stderr, "%s: %s\n", name, "the mesh stage failed");
    std::exit(1);
  }
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();  // processor time: the stage has one thread, the machine may be busy
    if (sinew::solve_heat(run.mesh, run.skeleton, run.counts, {}, run.arena, &run.fields) != SINEW_OK) {
      std::fprintf(stderr, "%s: the heat stage failed\n", name);
      std::exit(1);
    }
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf("%s,%u,%u,%u,%.4f,%.4f,%.4f,%zu,%016llx,%s\n", name, run.mesh.welded_count, run.mesh.component_count,
              run.skeleton.joint_count, seconds[seconds.size() / 2], seconds.front(), seconds.back(),
              run.heat_scratch_bytes, static_cast<unsigned long long>(hash_fields(run)), __VERSION__);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("scene,vertices,components,joints,median_s,min_s,max_s,scratch_bytes,hash,compiler\n");
  measure("star_5k_61", sinew_test::star(62, 80, 10), repeats);
  measure("star_10k_97", sinew_test::star(88, 113, 16), repeats);
  measure("capsule_10k_100", sinew_test::capsule(100, 100, 100), repeats);
  sinew_test::HeatScene dressed = sinew_test::star(70, 90, 16);
  sinew_test::add_sleeve(&dressed, 0.62, -0.4, 0.4, 30, 60);
  sinew_test::add_sleeve(&dressed, 0.3, 0.2, 1.0, 30, 60);
  measure("dressed_10k_97", dressed, repeats);
  return 0;
}
