// SPDX-License-Identifier: MIT
// The heat sources of a scene, found without the rest of the stage.
#ifndef SINEW_TESTS_SUPPORT_HEAT_SOURCES_HPP
#define SINEW_TESTS_SUPPORT_HEAT_SOURCES_HPP

#include <gtest/gtest.h>

#include <set>

#include "arena_block.hpp"
#include "heat/sources.hpp"
#include "heat_scene.hpp"

namespace sinew_test {

// Of a scene whose mesh stage ran.
struct Sources {
  explicit Sources(const HeatRun& run) : block(size(run.counts)) {
    found.allocate(block.arena, run.counts);
    EXPECT_EQ(sinew::find_sources(run.mesh, run.skeleton, run.source_joints.data(), run.counts, sinew::boxes_met_ref,
                                  {}, 1000, block.arena, &found),
              SINEW_OK);
  }
  static size_t size(const sinew::Counts& counts) {
    sinew::Arena measure;
    sinew::HeatSources s;
    s.allocate(measure, counts);
    sinew::measure_find_sources(measure, counts);
    return measure.high_water();
  }
  std::set<uint32_t> of(uint32_t field, uint32_t vertex) const {
    std::set<uint32_t> out;
    for (uint32_t t = 0; t < sinew::kMaxTies; ++t) {
      if (found.mask[field][vertex] >> t & 1)
        out.insert(found.ties[sinew::HeatSources::metric_of(field)][vertex * sinew::kMaxTies + t]);
    }
    return out;
  }
  Block block;
  sinew::HeatSources found;
};

}  // namespace sinew_test
#endif
