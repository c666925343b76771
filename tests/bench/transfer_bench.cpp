// SPDX-License-Identifier: MIT
// sinew_transfer() between two limbs of a size, by every method, beside the bind by heat of the same target, in turn: CSV on
// standard output. The ratio is to that bind.
//   sinew_bench_transfer [--repeats N] [VERTICES...]      default: 1000 10000
#include <cmath>
#include <cstdio>

#include "bench_report.hpp"
#include "sinew/published.h"
#include "transfer_scene.hpp"

namespace {

using sinew_test::BoundRows;
using sinew_test::MeshScene;

struct Contestant {
  const char* name;
  uint32_t method;
  bool garment;
};
constexpr Contestant kContestants[] = {
    {"bind by heat", 0, false},
    {"nearest", SINEW_TRANSFER_NEAREST, false},
    {"auto", SINEW_TRANSFER_AUTO, false},
    {"rebind", SINEW_TRANSFER_REBIND, false},
    {"garment", SINEW_TRANSFER_AUTO, true},
    {"biharmonic", SINEW_TRANSFER_BIHARMONIC, false},
};
constexpr size_t kCount = sizeof kContestants / sizeof *kContestants;

void check(const char* what, sinew_status status) { sinew_bench::check("sinew_bench_transfer", what, status); }

void measure(double vertices, int repeats) {
  const int rings = static_cast<int>(std::lround(std::sqrt(2 * vertices)));
  const int sides = static_cast<int>(std::lround(vertices / rings));
  const MeshScene source = sinew_test::limb(rings, sides, 3, 0.3), target = sinew_test::limb(rings, sides, 3.3, 0.33);
  const BoundRows rows = sinew_test::painted(source, 3);
  const sinew_mesh from = source.mesh_view(), to = target.mesh_view();
  const sinew_skeleton skeleton = source.skeleton_view(), target_skeleton = target.skeleton_view();
  const int32_t map[] = {0, 1, 2};
  const sinew_bound_character bound = {
      &from, &skeleton, {rows.joints.data(), rows.weights.data(), 2, SINEW_WEIGHT_UNORM16}, map};
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skins[kCount];
  size_t used[kCount] = {};
  const auto seconds = sinew_bench::medians_in_turn(kCount, repeats, [&](size_t i) {
    const Contestant& one = kContestants[i];
    if (i == 0) {
      sinew::Options options;
      options.method = SINEW_METHOD_HEAT;
      check(one.name, sinew::bind(nullptr, to, target_skeleton, options, &workspace, &skins[i]));
      check(one.name,
            sinew_bind_workspace_size(nullptr, to.vertex_count, to.face_count, to.corner_count, 3, &options, &used[i]));
      return;
    }
    sinew::TransferSettings settings;
    settings.method = one.method;
    settings.garment = one.garment ? 1 : 0;
    sinew::TransferReport report;
    check(one.name, sinew::transfer(nullptr, bound, to, target_skeleton, settings, &workspace, &skins[i], &report));
    used[i] = report.used_bytes;
  });
  for (size_t i = 0; i < kCount; ++i) {
    uint64_t hash =
        sinew_bench::fnv1a(sinew_bench::kHashStart, skins[i].joint_indices.data(), 2 * skins[i].joint_indices.size());
    hash = sinew_bench::fnv1a(hash, skins[i].weights.data(), 2 * skins[i].weights.size());
    std::printf("%s,%u,%s,%.3f,%.2f,%zu,%016llx\n", sinew_bench::row_start().c_str(), to.vertex_count,
                kContestants[i].name, seconds[i] * 1e3, seconds[i] / seconds[0], used[i],
                static_cast<unsigned long long>(hash));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 5;
  std::vector<double> sizes = {1000, 10000};
  sinew_bench::read_arguments(argc, argv, &repeats, &sizes);
  std::printf("machine,compiler,commit,vertices,method,median_ms,times_bind,bytes,hash\n");
  for (const double vertices : sizes) measure(vertices, repeats);
  return 0;
}
