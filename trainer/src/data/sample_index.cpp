// SPDX-License-Identifier: MIT
// Builds the row numbers and neighbor lists that the float layers run on.
#include "data/sample_index.hpp"

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

void check_sizes(const NetworkSample& s) {
  const size_t rows = size_t{s.vertices} * s.candidates;
  const bool fits = s.candidates >= 1 && s.candidates <= kMaxCandidates && s.candidate.size() == rows &&
                    s.row_offsets.size() == size_t{s.vertices} + 1 && s.part.size() == s.vertices &&
                    s.part_offsets.size() == size_t{s.part_count} + 1 && s.part_vertices.size() == s.vertices;
  if (!fits) throw Error(s.name + ": the sample's arrays do not fit its counts; its cache is damaged, delete it");
}

}  // namespace

void SampleIndex::build(const NetworkSample& sample) {
  check_sizes(sample);
  vertices = sample.vertices;
  slots = sample.candidates;
  pair_begin.resize(size_t{vertices} + 1);
  pair_slot.clear();
  for (uint32_t v = 0; v < vertices; ++v) {
    pair_begin[v] = static_cast<uint32_t>(pair_slot.size());
    for (uint32_t slot = v * slots; slot < (v + 1) * slots; ++slot) {
      if (sample.candidate[slot] != kAbsent) pair_slot.push_back(slot);
    }
  }
  pairs = static_cast<uint32_t>(pair_slot.size());
  pair_begin[vertices] = pairs;

  ring_begin.resize(size_t{pairs} + 1);
  ring_pairs.clear();
  for (uint32_t v = 0; v < vertices; ++v) {
    for (uint32_t p = pair_begin[v]; p < pair_begin[v + 1]; ++p) {
      ring_begin[p] = static_cast<uint32_t>(ring_pairs.size());
      const uint16_t joint = sample.candidate[pair_slot[p]];
      for (uint32_t e = sample.row_offsets[v]; e < sample.row_offsets[v + 1]; ++e) {
        const uint32_t u = sample.col_indices[e];
        for (uint32_t q = pair_begin[u]; q < pair_begin[u + 1]; ++q) {
          if (sample.candidate[pair_slot[q]] == joint) {
            ring_pairs.push_back(q);
            break;
          }
        }
      }
    }
  }
  ring_begin[pairs] = static_cast<uint32_t>(ring_pairs.size());

  group.resize(pairs);
  group_scale.clear();
  joint_mark_.assign(sample.joints, UINT32_MAX);
  joint_group_.resize(sample.joints);
  for (uint32_t part = 0; part < sample.part_count; ++part) {
    const uint32_t begin = sample.part_offsets[part], end = sample.part_offsets[part + 1];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t v = sample.part_vertices[i];
      for (uint32_t p = pair_begin[v]; p < pair_begin[v + 1]; ++p) {
        const uint16_t joint = sample.candidate[pair_slot[p]];
        if (joint_mark_[joint] != part) {
          joint_mark_[joint] = part;
          joint_group_[joint] = static_cast<uint32_t>(group_scale.size());
          group_scale.push_back(1.0f / static_cast<float>(end - begin));
        }
        group[p] = joint_group_[joint];
      }
    }
  }
}

}  // namespace sinew
