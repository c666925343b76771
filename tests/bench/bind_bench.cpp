// SPDX-License-Identifier: MIT
// A whole bind with the bundled model, stage by stage and with threads, on synthetic bodies of several sizes: CSV on
// standard output. "--grid rule": as if the model's cells followed the vertices. "--dragged": binds alone, each after one
// joint has moved, as when a user drags it.
//   sinew_bench_bind [--kernel NAME] [--grid CELLS|rule] [--repeats N] [--dragged] [VERTICES...]
//                                                                              default: 1000 10000 100000
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "bind/bind.hpp"
#include "heat/heat.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "network/network.hpp"
#include "sinew/sinew.hpp"
#if !defined(__EMSCRIPTEN__)
#include "sinew_formats/base/thread_pool.hpp"
#endif

namespace {

using namespace sinew;

constexpr const char* kStages[] = {"mesh", "reduction", "candidates", "heat", "features", "network", "whole"};
constexpr size_t kWhole = 6;

void check(sinew_status status, const char* what) {
  if (status == SINEW_OK) return;
  std::fprintf(stderr, "sinew_bench_bind: %s: %s\n", what, sinew_status_text(status));
  std::exit(1);
}

struct Input {
  sinew_test::HeatScene scene;
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);

  // 61 joints whatever the size; rings and segments as on the 10k body of the other benchmarks.
  explicit Input(double vertices) {
    const uint32_t rings = static_cast<uint32_t>(std::lround(std::sqrt(vertices * 0.78)));
    scene = sinew_test::star(rings, static_cast<uint32_t>(std::lround(vertices / rings)), 10);
    mesh = scene.mesh_view();
    skeleton = scene.skeleton_view();
  }
};

// Memory that was touched before, so that the first bind does not pay for it.
Workspace touched(size_t bytes) {
  Workspace block(bytes);
  if (block.size() != 0) std::memset(block.data(), 0, bytes);
  return block;
}

// What threads would make of a bind, from processor time alone, so that it can be told on a busy machine too: pieces
// run one after the other, and of every loop only the longest piece counts.
struct Lanes {
  double all = 0, longest = 0;
  static void run(void* user, uint32_t count, void (*body)(void*, uint32_t), void* data) {
    Lanes& lanes = *static_cast<Lanes*>(user);
    double longest = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const double start = sinew_bench::thread_seconds();
      body(data, i);
      const double seconds = sinew_bench::thread_seconds() - start;
      lanes.all += seconds;
      longest = std::max(longest, seconds);
    }
    lanes.longest += longest;
  }
  // Of work that took `seconds` one after the other.
  double way(double seconds) const { return seconds - all + longest; }
};

// The stages as run_bind() calls them, each with the time of its longest way, which is all of it with one thread.
void time_stages(const Input& in, const sinew_model& model, sinew_bind_options options, uint32_t threads,
                 std::vector<double>* seconds) {
  Lanes lanes;
  options.thread_count = threads;
  options.parallel_for = Lanes::run;
  options.parallel_user = &lanes;
  BindPlan plan;
  check(plan_bind(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count, in.skeleton.joint_count,
                  &options, &plan),
        "plan");
  const Counts &full = plan.counts, counts = full.surface();
  Kernels kernels;
  if (!select_kernels(options.kernel, &kernels)) check(SINEW_ERROR_KERNEL, "kernels");
  Arena measuring;  // more than a bind's: nothing is given back before the network here
  PreparedBind p;
  check(prepare(in.mesh, in.skeleton, 0, full, PreparePurpose::kNetwork, kernels, {}, measuring, &p), "size");
  check(run_network(model, largest_network_input(counts), kernels, {}, measuring, nullptr, plan.network), "size");
  const size_t bytes = measuring.high_water();
  const Workspace block = touched(bytes);
  Arena arena(block.data(), bytes);
  const auto timed = [&](size_t stage, auto run) {
    lanes = Lanes();
    const double start = sinew_bench::thread_seconds();
    check(run(), kStages[stage]);
    seconds[stage].push_back(lanes.way(sinew_bench::thread_seconds() - start));
  };
  p.mesh.allocate(arena, full);
  p.skeleton.allocate(arena, full);
  p.source_joints = arena.alloc<uint8_t>(full.joints);
  timed(0, [&] {
    const sinew_status status = build_mesh_and_skeleton(in.mesh, in.skeleton, 0, full, arena, &p.mesh, &p.skeleton);
    if (status == SINEW_OK) choose_source_joints(p.mesh, p.skeleton, p.source_joints);
    return status;
  });
  if (full.may_reduce()) p.reduction.allocate(arena, full);
  timed(1, [&] { return full.may_reduce() ? reduce_mesh(p.mesh, full, {}, arena, &p.reduction) : SINEW_OK; });
  const Mesh& mesh = p.surface();
  p.candidates.allocate(arena, counts);
  timed(2, [&] { return find_candidates(mesh, p.skeleton, counts, {}, arena, &p.candidates); });
  p.heat.allocate(arena, counts);
  timed(3, [&] { return solve_heat(mesh, p.skeleton, p.source_joints, counts, kernels, {}, arena, &p.heat); });
  p.features.allocate(arena, counts);
  timed(4, [&] { return build_features(mesh, p.skeleton, p.candidates, p.heat, counts, arena, &p.features); });
  const NetworkInput input = network_input(p, counts);
  std::vector<int16_t> logits(size_t{mesh.welded_count} * counts.candidates);
  timed(5, [&] { return run_network(model, input, kernels, {}, arena, logits.data(), plan.network); });
}

// Rows for 2, 4 and 8 threads: the longest way through a bind, and the time on the clock with real threads.
#if defined(__EMSCRIPTEN__)
void measure_threads(const Input&, const sinew_model&, sinew_bind_options, int, uint64_t) {}  // a module has none
#else
void measure_threads(const Input& in, const sinew_model& model, sinew_bind_options options, int repeats,
                     uint64_t hash) {
  for (const uint32_t threads : {2u, 4u, 8u}) {
    options.thread_count = threads;
    size_t bytes = 0;
    check(sinew_bind_workspace_size(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                    in.skeleton.joint_count, &options, &bytes),
          "workspace");
    const Workspace block = touched(bytes);
    std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = joints.data();
    outputs.weights = weights.data();
    const auto bind = [&] {
      check(sinew_bind(&model, &in.mesh, &in.skeleton, &options, block.data(), bytes, &outputs), "bind");
    };
    std::vector<double> way, clock, stages[kWhole];
    for (int i = 0; i < repeats; ++i) {
      Lanes lanes;
      options.parallel_for = Lanes::run;
      options.parallel_user = &lanes;
      const double start = sinew_bench::thread_seconds();
      bind();
      way.push_back(lanes.way(sinew_bench::thread_seconds() - start));
      time_stages(in, model, options, threads, stages);
      sinew::ThreadPool pool(threads);
      options.parallel_for = sinew::ThreadPool::parallel_for;
      options.parallel_user = &pool;
      const auto begin = std::chrono::steady_clock::now();
      bind();
      clock.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    uint64_t found = sinew_bench::fnv1a(sinew_bench::kHashStart, joints.data(), joints.size() * 2);
    found = sinew_bench::fnv1a(found, weights.data(), weights.size() * 2);
    if (found != hash) check(SINEW_ERROR_RANGE, "another result with threads");
    const auto print = [&](const char* stage, const char* what, const std::vector<double>& seconds) {
      const double median = sinew_bench::median(seconds);
      std::printf("%s,%s,%u,%u,%s with %u threads: %s,%.3f,,%.0f,%zu,%.0f,%016llx\n", sinew_bench::row_start().c_str(),
                  sinew_kernel_name(sinew_kernel_select(options.kernel)), in.mesh.vertex_count, in.skeleton.joint_count,
                  stage, threads, what, median * 1e3, median * 1e9 / in.mesh.vertex_count, outputs.used_bytes,
                  static_cast<double>(outputs.used_bytes) / in.mesh.vertex_count,
                  static_cast<unsigned long long>(found));
    };
    for (size_t stage = 0; stage < kWhole; ++stage) print(kStages[stage], "longest way", stages[stage]);
    print("whole", "longest way", way);
    print("whole", "clock", clock);
  }
}
#endif

void measure(double vertices, const sinew_model& model, const sinew_bind_options& options, int repeats) {
  const Input in(vertices);
  size_t bytes = 0;
  check(sinew_bind_workspace_size(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                  in.skeleton.joint_count, &options, &bytes),
        "workspace");
  const Workspace block = touched(bytes);
  std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  std::vector<double> seconds[kWhole + 1];
  for (int i = 0; i < repeats; ++i) {
    const double start = sinew_bench::thread_seconds();
    check(sinew_bind(&model, &in.mesh, &in.skeleton, &options, block.data(), bytes, &outputs), "bind");
    seconds[kWhole].push_back(sinew_bench::thread_seconds() - start);
    time_stages(in, model, options, 1, seconds);
  }
  const double whole = sinew_bench::median(seconds[kWhole]);
  uint64_t hash = sinew_bench::fnv1a(sinew_bench::kHashStart, joints.data(), joints.size() * 2);
  hash = sinew_bench::fnv1a(hash, weights.data(), weights.size() * 2);
  for (size_t stage = 0; stage <= kWhole; ++stage) {
    const double median = sinew_bench::median(seconds[stage]);
    std::printf("%s,%s,%u,%u,%s,%.3f,%.3f,%.0f,%zu,%.0f,%016llx\n", sinew_bench::row_start().c_str(),
                sinew_kernel_name(sinew_kernel_select(options.kernel)), in.mesh.vertex_count, in.skeleton.joint_count,
                kStages[stage], median * 1e3, median / whole, median * 1e9 / in.mesh.vertex_count, outputs.used_bytes,
                static_cast<double>(outputs.used_bytes) / in.mesh.vertex_count, static_cast<unsigned long long>(hash));
  }
  measure_threads(in, model, options, repeats, hash);
  std::fflush(stdout);
}

// A row for binds of the same mesh between which an end of a limb goes round a circle of 2 % of the body.
void measure_dragged(double vertices, const sinew_model& model, const sinew_bind_options& options, int repeats) {
  Input in(vertices);
  size_t bytes = 0;
  check(sinew_bind_workspace_size(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                  in.skeleton.joint_count, &options, &bytes),
        "workspace");
  const Workspace block = touched(bytes);
  std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  constexpr int kSteps = 12;
  const size_t dragged = size_t{3} * (in.skeleton.joint_count - 1);
  const float from[2] = {in.scene.joints[dragged], in.scene.joints[dragged + 1]};
  const auto sizes = std::minmax_element(in.scene.positions.begin(), in.scene.positions.end());
  const double radius = 0.02 * static_cast<double>(*sizes.second - *sizes.first);
  std::vector<double> seconds;
  uint64_t hash = sinew_bench::kHashStart;
  for (int i = 0; i < repeats * kSteps; ++i) {
    const double angle = 6.283185307179586 * (i % kSteps) / kSteps;
    in.scene.joints[dragged] = from[0] + static_cast<float>(radius * std::cos(angle));
    in.scene.joints[dragged + 1] = from[1] + static_cast<float>(radius * std::sin(angle));
    const double start = sinew_bench::thread_seconds();
    check(sinew_bind(&model, &in.mesh, &in.skeleton, &options, block.data(), bytes, &outputs), "bind");
    seconds.push_back(sinew_bench::thread_seconds() - start);
    if (i >= kSteps) continue;
    hash = sinew_bench::fnv1a(hash, joints.data(), joints.size() * 2);
    hash = sinew_bench::fnv1a(hash, weights.data(), weights.size() * 2);
  }
  const double median = sinew_bench::median(seconds);
  std::printf("%s,%s,%u,%u,a joint dragged: %.1f binds a second,%.3f,,%.0f,%zu,%.0f,%016llx\n",
              sinew_bench::row_start().c_str(), sinew_kernel_name(sinew_kernel_select(options.kernel)),
              in.mesh.vertex_count, in.skeleton.joint_count, 1 / median, median * 1e3,
              median * 1e9 / in.mesh.vertex_count, outputs.used_bytes,
              static_cast<double>(outputs.used_bytes) / in.mesh.vertex_count, static_cast<unsigned long long>(hash));
  std::fflush(stdout);
}

std::vector<uint64_t> read_model(size_t* size) {
  std::FILE* file = std::fopen(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew", "rb");
  if (file == nullptr) {
    std::fprintf(stderr, "sinew_bench_bind: samples/data/sinew_default.sinew is missing\n");
    std::exit(1);
  }
  std::vector<uint64_t> bytes(512 * 1024);
  *size = std::fread(bytes.data(), 1, bytes.size() * 8, file);
  std::fclose(file);
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  uint32_t& kernel = options.kernel;
  int repeats = 5;
  bool by_rule = false, dragged = false;
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i) {
    if (i + 1 < argc && std::strcmp(argv[i], "--repeats") == 0) {
      repeats = std::max(1, std::atoi(argv[++i]));
    } else if (std::strcmp(argv[i], "--dragged") == 0) {
      dragged = true;
    } else if (i + 1 < argc && std::strcmp(argv[i], "--grid") == 0) {
      options.grid_size = static_cast<uint32_t>(std::atoi(argv[++i]));
      by_rule = options.grid_size == 0;
    } else if (i + 1 < argc && std::strcmp(argv[i], "--kernel") == 0) {
      const char* name = argv[++i];
      while (sinew_kernel_name(kernel) != nullptr && std::strcmp(sinew_kernel_name(kernel), name) != 0) ++kernel;
      if (sinew_kernel_select(kernel) == 0) {
        std::fprintf(stderr, "sinew_bench_bind: no kernels called %s run here\n", name);
        return 2;
      }
    } else {
      sizes.push_back(std::atof(argv[i]));
    }
  }
  if (sizes.empty()) sizes = {1000, 10000, 100000};
  size_t size = 0;
  const std::vector<uint64_t> bytes = read_model(&size);
  sinew_model model = {};
  check(sinew_model_open(bytes.data(), size, &model), "model");
  if (by_rule) model.grid_size = 0;
  std::printf(
      "machine,compiler,commit,kernel,vertices,joints,stage,median_ms,share,ns_per_vertex,used_bytes,"
      "bytes_per_vertex,hash\n");
  for (const double vertices : sizes) {
    if (dragged)
      measure_dragged(vertices, model, options, repeats);
    else
      measure(vertices, model, options, repeats);
  }
  return 0;
}
