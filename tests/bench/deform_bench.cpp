// SPDX-License-Identifier: MIT
// sinew_deform_create() and sinew_deform_pose() on a synthetic body with every joint turned, beside dual quaternion skinning of the
// same pose: CSV on standard output. Ratios are poses over skinning; those of threads are of wall time, against one thread.
//   sinew_bench_deform [--repeats N] [VERTICES...]      default: 5000
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bench_report.hpp"
#include "heat_scene.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/base/thread_pool.hpp"

namespace {

using namespace sinew;

constexpr uint32_t kInfluences = 4;

void check(sinew_status status, const char* what) {
  if (status == SINEW_OK) return;
  std::fprintf(stderr, "sinew_bench_deform: %s: %s\n", what, sinew_status_text(status));
  std::exit(1);
}

// Every joint turned by 0.5 about z on top of its parent; parents come first.
std::vector<float> turned_palette(const sinew_test::HeatScene& scene) {
  const size_t count = scene.joint_count();
  std::vector<double> m(12 * count, 0);
  for (size_t j = 0; j < count; ++j) {
    const double c = std::cos(0.5), s = scene.parents[j] < 0 ? 0 : std::sin(0.5) * (j % 2 == 0 ? 1 : -1);
    const double own[9] = {scene.parents[j] < 0 ? 1 : c, -s, 0, s, scene.parents[j] < 0 ? 1 : c, 0, 0, 0, 1};
    for (size_t r = 0; r < 3; ++r) {
      double translation = double{scene.joints[3 * j + r]};
      for (size_t k = 0; k < 3; ++k) translation -= own[3 * r + k] * double{scene.joints[3 * j + k]};
      for (size_t k = 0; k < 4; ++k) m[12 * j + 4 * r + k] = k < 3 ? own[3 * r + k] : translation;
    }
    if (scene.parents[j] < 0) continue;
    const double* const above = &m[12 * static_cast<size_t>(scene.parents[j])];
    double whole[12];
    for (size_t r = 0; r < 3; ++r)
      for (size_t k = 0; k < 4; ++k) {
        whole[4 * r + k] = k == 3 ? above[4 * r + 3] : 0;
        for (size_t i = 0; i < 3; ++i) whole[4 * r + k] += above[4 * r + i] * m[12 * j + 4 * i + k];
      }
    std::memcpy(&m[12 * j], whole, sizeof whole);
  }
  return std::vector<float>(m.begin(), m.end());
}

struct Bound {
  sinew_test::HeatScene scene;
  std::vector<uint16_t> joints, weights;
  std::vector<float> palette;
};

Bound bind_star(double vertices) {
  const uint32_t rings = static_cast<uint32_t>(std::lround(std::sqrt(vertices * 0.78)));
  Bound out = {sinew_test::star(rings, static_cast<uint32_t>(std::lround(vertices / rings)), 10), {}, {}, {}};
  const sinew_mesh mesh = out.scene.mesh_view();
  const sinew_skeleton skeleton = out.scene.skeleton_view();
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  size_t bytes = 0;
  check(sinew_bind_workspace_size(nullptr, mesh.vertex_count, mesh.face_count, mesh.corner_count, skeleton.joint_count,
                                  &options, &bytes),
        "bind");
  Workspace block(bytes);
  out.joints.resize(size_t{mesh.vertex_count} * kInfluences);
  out.weights.resize(out.joints.size());
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = out.joints.data();
  outputs.weights = out.weights.data();
  check(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), block.size(), &outputs), "bind");
  out.palette = turned_palette(out.scene);
  return out;
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Medians of so many calls: this thread's processor time, and the clock on the wall.
template <class Call>
void measure(int repeats, const Call& call, double* own, double* wall) {
  std::vector<double> owns, walls;
  for (int i = 0; i < repeats; ++i) {
    const double start = sinew_bench::thread_seconds(), begin = wall_seconds();
    call();
    walls.push_back(wall_seconds() - begin);
    owns.push_back(sinew_bench::thread_seconds() - start);
  }
  *own = sinew_bench::median(owns);
  *wall = sinew_bench::median(walls);
}

void run(double vertices, int repeats) {
  const Bound bound = bind_star(vertices);
  const sinew_mesh mesh = bound.scene.mesh_view();
  const uint32_t joint_count = bound.scene.joint_count();
  std::vector<float> out(size_t{3} * mesh.vertex_count);
  double skinned = 0, ignored = 0;
  measure(
      repeats,
      [&] {
        const sinew_skin skin = {bound.joints.data(), bound.weights.data(), kInfluences, SINEW_WEIGHT_UNORM16};
        check(sinew_skin_dual_quaternion(mesh.positions, mesh.vertex_count, &skin, bound.palette.data(), joint_count,
                                         out.data()),
              "skin");
      },
      &skinned, &ignored);
  for (const uint32_t cells : {24u, 32u, 48u, 64u}) {
    for (const uint32_t rounds : {10u, 20u, 40u}) {
      double single = 0;
      uint64_t expected = 0;
      for (const uint32_t threads : {1u, 2u, 4u}) {
        ThreadPool pool(threads);
        sinew_deform_options options = SINEW_INIT(sinew_deform_options);
        options.cell_count = cells;
        options.round_count = rounds;
        options.thread_count = threads;
        options.parallel_for = ThreadPool::parallel_for;
        options.parallel_user = &pool;
        Deformer deformer;
        const double start = sinew_bench::thread_seconds();
        check(deformer.create(mesh, bound.scene.skeleton_view(),
                              {bound.joints.data(), bound.weights.data(), kInfluences}, options),
              "create");
        const double created = sinew_bench::thread_seconds() - start;
        sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
        outputs.positions = out.data();
        double own = 0, wall = 0;
        measure(
            repeats, [&] { check(deformer.pose(bound.palette.data(), &outputs), "pose"); }, &own, &wall);
        const uint64_t hash = sinew_bench::fnv1a(sinew_bench::kHashStart, out.data(), out.size() * sizeof(float));
        if (threads == 1) {
          single = wall;
          expected = hash;
        }
        if (hash != expected) check(SINEW_ERROR_RANGE, "another result with more threads");
        std::printf("%s,%u,%u,%u,%u,%u,%u,%.3f,%.3f,%.3f,%.1f,%.2f,%zu,%016llx\n", sinew_bench::row_start().c_str(),
                    mesh.vertex_count, joint_count, cells, rounds, threads, outputs.active_tetrahedra, created * 1e3,
                    own * 1e3, wall * 1e3, own / skinned, single / wall, deformer.memory_bytes(),
                    static_cast<unsigned long long>(hash));
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 15;
  std::vector<double> sizes = {5000};
  sinew_bench::read_arguments(argc, argv, &repeats, &sizes);
  std::printf(
      "machine,compiler,commit,vertices,joints,cells,rounds,threads,active_tetrahedra,create_ms,own_ms,wall_ms,"
      "times_skinning,times_faster_than_one_thread,memory_bytes,hash\n");
  for (const double vertices : sizes) run(vertices, repeats);
  return 0;
}
