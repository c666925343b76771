// SPDX-License-Identifier: MIT
// Row numbers of a sample's present pairs and who their neighbors are: what the layers gather and scatter with.
#ifndef SINEW_TRAINER_DATA_SAMPLE_INDEX_HPP
#define SINEW_TRAINER_DATA_SAMPLE_INDEX_HPP

#include <cstdint>
#include <vector>

#include "sinew_trainer/sample.hpp"

namespace sinew {

constexpr uint16_t kAbsent = 0xFFFF;     // NetworkSample::candidate of an unused slot
constexpr uint32_t kMaxCandidates = 16;  // largest K of the engine

// P present pairs in vertex order: only they have rows, absent slots cost nothing.
struct SampleIndex {
  uint32_t vertices = 0, slots = 0, pairs = 0;
  std::vector<uint32_t> pair_begin;  // [U + 1] first pair row of a vertex
  std::vector<uint32_t> pair_slot;   // [P] index into the dense [U x K] arrays
  std::vector<uint32_t> ring_begin;  // [P + 1] CSR: pairs of the one-ring with the same joint
  std::vector<uint32_t> ring_pairs;
  std::vector<uint32_t> group;     // [P] (part, joint) the pair belongs to
  std::vector<float> group_scale;  // [G] 1 / vertices of the part

  // Reuses the vectors' memory. Throws Error when the sample's arrays do not fit together.
  void build(const NetworkSample& sample);

 private:
  std::vector<uint32_t> joint_mark_, joint_group_;
};

}  // namespace sinew
#endif
