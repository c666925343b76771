// SPDX-License-Identifier: MIT
// Two rigs' anatomies through the matcher.
#ifndef SINEW_TESTS_MAPPING_MATCHED_RIGS_HPP
#define SINEW_TESTS_MAPPING_MATCHED_RIGS_HPP

#include <algorithm>
#include <utility>
#include <vector>

#include "human_rig.hpp"
#include "mapping/matcher.hpp"

namespace sinew::mapping {

struct MatchedRigs {
  std::vector<int32_t> sources;
  std::vector<double> costs;

  //   pins  pairs of a target joint and its source, -1 = none
  MatchedRigs(SmallRig* target, SmallRig* source, const std::vector<std::pair<int32_t, int32_t>>& pins = {}) {
    const Read to(target), from(source);
    const size_t n = target->parents.size(), m = source->parents.size();
    std::vector<int32_t> source_of(n, Pins::kFree), target_of(m, Pins::kFree);
    for (const auto& [joint, other] : pins) {
      source_of[static_cast<size_t>(joint)] = other;
      if (other >= 0) target_of[static_cast<size_t>(other)] = joint;
    }
    const Pins wanted = {source_of.data(), target_of.data(), !pins.empty()};
    Matcher matcher;
    Arena measuring;
    EXPECT_TRUE(matcher.allocate(measuring, static_cast<uint32_t>(n), static_cast<uint32_t>(m)));
    Workspace memory(measuring.high_water());
    Arena arena(memory.data(), measuring.high_water());
    EXPECT_TRUE(matcher.allocate(arena, static_cast<uint32_t>(n), static_cast<uint32_t>(m)));
    sources.assign(n, -7);
    costs.assign(n, -7);
    matcher.run(to.anatomy, from.anatomy, false, wanted, sources.data(), costs.data());
    for (const int32_t j : sources) {
      EXPECT_GE(j, -1);
      EXPECT_LT(j, static_cast<int32_t>(m));
      EXPECT_LE(j < 0 ? 0 : std::count(sources.begin(), sources.end(), j), 1) << "a source is given once: " << j;
    }
  }
  int32_t of(int32_t joint) const { return sources[static_cast<size_t>(joint)]; }
};

}  // namespace sinew::mapping
#endif
