// SPDX-License-Identifier: MIT
// sinew_map() between two people with fingers and between two rigs at the limits, by both methods, in turn: CSV on standard
// output. The ratio is to our method.
//   sinew_bench_map [repeats]
#include <cstdio>
#include <cstdlib>

#include "bench_report.hpp"
#include "draw.hpp"
#include "map_rig.hpp"
#include "sinew/published.h"
#include "sinew/sinew.hpp"

namespace {

using sinew_test::TestRig;

// 20 joints a hand's worth more on both sides: about 60 in all.
TestRig with_fingers(TestRig rig) {
  for (const float s : {1.0f, -1.0f}) {
    const int32_t hand = rig.find(s > 0 ? "LeftHand" : "RightHand");
    const float* const at = &rig.positions[3 * static_cast<size_t>(hand)];
    const float x = at[0], y = at[1], z = at[2];
    for (int finger = 0; finger < 5; ++finger) {
      int32_t last = hand;
      for (int k = 1; k <= 4; ++k)
        last = rig.add("f", last, x + s * 0.03f * static_cast<float>(k), y,
                       z + 0.02f * static_cast<float>(2 - finger) + (finger == 0 ? 0.01f * static_cast<float>(k) : 0),
                       k == 4);
    }
  }
  return rig;
}

// Any tree of so many joints.
TestRig bush(uint32_t joints, uint32_t seed) {
  sinew_test::Draw draw(seed);
  TestRig rig;
  for (uint32_t i = 0; i < joints; ++i)
    rig.add("j", i == 0 ? -1 : static_cast<int32_t>(draw.below(i)), draw.range(-1, 1), draw.range(-1, 1),
            draw.range(-1, 1));
  return rig;
}

void measure(const char* name, const TestRig& target, const TestRig& source, int repeats) {
  constexpr uint32_t kMethods[] = {SINEW_MAP_SINEW, SINEW_MAP_BRANCHES};
  constexpr const char* kNames[] = {"sinew", "branches"};
  sinew_test::MapCall call;
  std::vector<const char*> texts[2];
  const sinew_skeleton to = call.view(target, &texts[0]), from = call.view(source, &texts[1]);
  sinew::Workspace workspace;
  sinew::JointMap maps[2];
  sinew_status status[2] = {};
  const auto seconds = sinew_bench::medians_in_turn(2, repeats, [&](size_t i) {
    sinew::MapSettings settings;
    settings.method = kMethods[i];
    status[i] = sinew::map_joints(to, from, settings, &workspace, &maps[i]);
  });
  for (size_t i = 0; i < 2; ++i) {
    if (status[i] == SINEW_ERROR_COUNT && i == 1) continue;  // more branches than are compared
    sinew_bench::check("sinew_bench_map", name, status[i]);
    const uint64_t hash =
        sinew_bench::fnv1a(sinew_bench::kHashStart, maps[i].sources.data(), maps[i].sources.size() * sizeof(int32_t));
    std::printf("%s,%s,%u,%u,%s,%.3f,%.2f,%u,%zu,%016llx\n", sinew_bench::row_start().c_str(), name, target.count(),
                source.count(), kNames[i], seconds[i] * 1e3, seconds[i] / seconds[0], maps[i].mapped, workspace.size(),
                static_cast<unsigned long long>(hash));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 21;
  std::printf(
      "machine,compiler,commit,scene,target_joints,source_joints,method,median_ms,times_sinew,mapped,"
      "workspace_bytes,hash\n");
  measure("people", sinew_test::humanoid(3, true), sinew_test::humanoid(2, false), repeats);
  measure("people_with_fingers", with_fingers(sinew_test::humanoid(4, true)),
          with_fingers(sinew_test::humanoid(3, false)), repeats);
  measure("bushes", bush(SINEW_MAX_JOINTS, 1), bush(1000, 2), std::min(repeats, 3));
  return 0;
}
