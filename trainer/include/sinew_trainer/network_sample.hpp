// SPDX-License-Identifier: MIT
// What a network sees of one mesh or one skeleton: the rows of its inputs, and who is whose neighbour. Every task's samples
// begin with it and add what they are trained towards.
#ifndef SINEW_TRAINER_NETWORK_SAMPLE_HPP
#define SINEW_TRAINER_NETWORK_SAMPLE_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// Copies, all sizes known. For a task over joints, "vertex" stands for a joint everywhere here. A task whose network has no
// domain with slots has one slot per vertex, always absent.
struct NetworkSample {
  NetworkSample() = default;
  NetworkSample(const NetworkSample&) = default;
  NetworkSample(NetworkSample&&) = default;
  NetworkSample& operator=(const NetworkSample&) = default;
  NetworkSample& operator=(NetworkSample&&) = default;
  virtual ~NetworkSample() = default;

  struct Input {
    uint32_t channels = 0;      // C
    std::vector<int16_t> rows;  // [U x C] or, in a domain with slots, [U x K x C]; Q13
  };

  std::string name, family;
  uint32_t vertices = 0;                           // U, welded
  uint32_t candidates = 0;                         // K
  uint32_t part_count = 0, joints = 0;             // parts; J, more than any candidate
  std::vector<Input> inputs;                       // in the task's order
  std::vector<uint16_t> candidate;                 // [U x K], 0xFFFF absent
  std::vector<uint32_t> row_offsets, col_indices;  // one-ring CSR
  std::vector<uint32_t> far_offsets, far_indices;  // CSR of far neighbours; empty where the task has none
  std::vector<uint32_t> part, part_offsets, part_vertices;
};

}  // namespace sinew
#endif
