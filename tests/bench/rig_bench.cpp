// SPDX-License-Identifier: MIT
// A whole sinew_rig() with the bundled model on synthetic bodies, with every kernel that runs here, in turn: CSV on
// standard output.
//   sinew_bench_rig [--kernel NAME] [--repeats N] [VERTICES...]      default: 10000
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "bundled_model.hpp"
#include "heat_scene.hpp"
#include "sinew/sinew.hpp"

namespace {

using namespace sinew;

// What has been done when the call reports so much: mesh and mirror plane; voxels and where it faces; points, network.
struct Mark {
  const char* stage;
  uint32_t permille;
};
constexpr Mark kMarks[] = {{"mesh", 150}, {"frame", 400}, {"votes", 800}};
constexpr size_t kMarkCount = 3, kStages = kMarkCount + 2;
constexpr const char* kStageNames[kStages] = {kMarks[0].stage, kMarks[1].stage, kMarks[2].stage, "skeleton", "whole"};

void check(sinew_status status, const char* what) { sinew_bench::check("sinew_bench_rig", what, status); }

struct Clock {
  double at[kMarkCount] = {};
  static int report(void* user, uint32_t permille) {
    Clock& clock = *static_cast<Clock*>(user);
    for (size_t i = 0; i < kMarkCount; ++i)
      if (permille == kMarks[i].permille && clock.at[i] == 0) clock.at[i] = sinew_bench::thread_seconds();
    return 0;
  }
};

struct Run {
  uint32_t kernel = 0;
  std::vector<double> seconds[kStages];
  sinew_rig_outputs outputs = {};
  uint64_t hash = 0;
};

void rig_once(const sinew_model& model, const sinew_mesh& mesh, const Workspace& block, Run* run) {
  Clock clock;
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.kernel = run->kernel;
  options.progress = Clock::report;
  options.progress_user = &clock;
  std::vector<float> positions(size_t{3} * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents(SINEW_MAX_RIG_JOINTS);
  run->outputs = SINEW_INIT(sinew_rig_outputs);
  run->outputs.positions = positions.data();
  run->outputs.parents = parents.data();
  double start = sinew_bench::thread_seconds();
  const double first = start;
  check(sinew_rig(&model, &mesh, &options, block.data(), block.size(), &run->outputs), "rig");
  const double end = sinew_bench::thread_seconds();
  for (size_t stage = 0; stage < kMarkCount; ++stage) {
    run->seconds[stage].push_back(clock.at[stage] - start);
    start = clock.at[stage];
  }
  run->seconds[kMarkCount].push_back(end - start);
  run->seconds[kStages - 1].push_back(end - first);
  const size_t joints = run->outputs.joint_count;
  run->hash = sinew_bench::fnv1a(sinew_bench::kHashStart, positions.data(), joints * 3 * sizeof(float));
  run->hash = sinew_bench::fnv1a(run->hash, parents.data(), joints * sizeof(int32_t));
}

void measure(double vertices, const sinew_model& model, uint32_t only, int repeats) {
  const uint32_t rings = static_cast<uint32_t>(std::lround(std::sqrt(vertices * 0.78)));
  const sinew_test::HeatScene scene = sinew_test::star(rings, static_cast<uint32_t>(std::lround(vertices / rings)), 10);
  const sinew_mesh mesh = scene.mesh_view();
  size_t bytes = 0;
  check(sinew_rig_workspace_size(&model, mesh.vertex_count, mesh.face_count, mesh.corner_count, nullptr, &bytes),
        "workspace");
  Workspace block(bytes);
  if (block.size() != bytes) check(SINEW_ERROR_WORKSPACE, "memory");
  std::memset(block.data(), 0, bytes);  // the first call does not pay for its pages
  std::vector<Run> runs;
  for (uint32_t kernel = SINEW_KERNEL_AUTO + 1; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    if (sinew_kernel_select(kernel) == 0 || (only != SINEW_KERNEL_AUTO && kernel != only)) continue;
    runs.emplace_back();
    runs.back().kernel = kernel;
  }
  for (int i = 0; i < repeats; ++i)
    for (Run& run : runs) rig_once(model, mesh, block, &run);
  for (const Run& run : runs) {
    if (run.hash != runs[0].hash) check(SINEW_ERROR_RANGE, "another result with another kernel");
    const double whole = sinew_bench::median(run.seconds[kStages - 1]);
    for (size_t stage = 0; stage < kStages; ++stage) {
      const double median = sinew_bench::median(run.seconds[stage]);
      const double least = *std::min_element(run.seconds[stage].begin(), run.seconds[stage].end());
      std::printf("%s,%s,%u,%u,%s,%.3f,%.3f,%.3f,%zu,%zu,%016llx\n", sinew_bench::row_start().c_str(),
                  sinew_kernel_name(run.kernel), mesh.vertex_count, run.outputs.joint_count, kStageNames[stage],
                  median * 1e3, least * 1e3, median / whole, bytes, run.outputs.used_bytes,
                  static_cast<unsigned long long>(run.hash));
    }
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  uint32_t kernel = SINEW_KERNEL_AUTO;
  int repeats = 9;
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i) {
    if (i + 1 < argc && std::strcmp(argv[i], "--repeats") == 0) {
      repeats = std::max(1, std::atoi(argv[++i]));
    } else if (i + 1 < argc && std::strcmp(argv[i], "--kernel") == 0) {
      const char* name = argv[++i];
      while (sinew_kernel_name(kernel) != nullptr && std::strcmp(sinew_kernel_name(kernel), name) != 0) ++kernel;
      if (sinew_kernel_select(kernel) == 0) {
        std::fprintf(stderr, "sinew_bench_rig: no kernels called %s run here\n", name);
        return 2;
      }
    } else {
      sizes.push_back(std::atof(argv[i]));
    }
  }
  if (sizes.empty()) sizes = {10000};
  const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_rig.sinew", sinew_rig_model_open);
  if (!opened.ok) {
    std::fprintf(stderr, "sinew_bench_rig: samples/data/sinew_rig.sinew is missing or refused\n");
    return 1;
  }
  std::printf(
      "machine,compiler,commit,kernel,vertices,joints,stage,median_ms,least_ms,share,workspace_bytes,used_bytes,"
      "hash\n");
  for (const double vertices : sizes) measure(vertices, opened.model, kernel, repeats);
  return 0;
}
